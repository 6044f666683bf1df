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

  static Body bodyOf(const Surface& surface);
  Status place(const std::vector<Instance>& instances, bool hasLights, int threads);
  void castShadows(int threads);
  void cut(const WorldMesh& world, int threads);

  std::vector<Body> bodies_;
  std::vector<LightRays> lights_;
  RefinedWorld refined_; ///< of the bodies, if any casts a shadow
  std::unique_ptr<const TriangleTree> refinedTree_;
  std::vector<std::vector<std::shared_ptr<const ShadowLines>>> shadows_; ///< by body
  std::vector<std::shared_ptr<const ContourLines>> cuts_; ///< by body; may be nullptr
};

/// Whether a property asks for lines of this kind.
bool wantsSceneLines(vtkProperty* property);

} // namespace limn::bridge

#endif
