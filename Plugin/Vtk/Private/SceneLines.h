// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLines_h
#define SceneLines_h

#include "Surface.h"

#include "Rendering/Lines/CastShadows.h"
#include "Rendering/Lines/Intersections.h"

#include "vtkLimnPolyDataMapper.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace limn::bridge
{

/// Lines that depend on all surfaces of a renderer: borders of cast shadows and intersections. They
/// are made anew only when a surface, its place or a light has changed, not for the camera.
class SceneLines
{
public:
  /// Adds to the lines of `instances`, described already, those of which the surfaces' properties
  /// tell. Errors: those of buildWorldMesh().
  Status add(const std::vector<const Surface*>& surfaces, std::vector<Instance>& instances,
    const LineView& view, FrameLines& frame);

private:
  struct Body
  {
    vtkWeakPointer<vtkLimnPolyDataMapper> mapper;
    vtkIdType geometry;
    Mat4d place;
    bool castsShadow, isCut, hasAllLights;
    double creaseDegrees;

    bool operator==(const Body& other) const;
  };
  using Lines = std::shared_ptr<const ContourLines>;

  static Body bodyOf(const Surface& surface);
  Status build(const std::vector<Instance>& instances, int threads);
  void castShadows(const WorldMesh& world, const TriangleTree& tree, int threads);
  void cut(const WorldMesh& world, const TriangleTree& tree, int threads);
  void keep(std::size_t body, ContourLines lines);

  std::vector<Body> bodies_;
  std::vector<LightRays> lights_;
  std::vector<std::vector<Lines>> lines_; ///< by body
};

/// Whether a property asks for lines of this kind.
bool wantsSceneLines(vtkProperty* property);

} // namespace limn::bridge

#endif
