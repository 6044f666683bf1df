// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceLines_h
#define SurfaceLines_h

#include "Rendering/Base/Status.h"
#include "Rendering/Lines/HatchLines.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/LightRays.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataArray;
class vtkLimnProperty;
class vtkPolyData;
class vtkProperty;

namespace limn::bridge
{

/// Whether a property asks for lines of the mesh.
bool wantsLines(vtkProperty* property);

/// How a property's lines look.
LineStyle strokeStyleOf(vtkLimnProperty* property, double pixelsPerInch);
/// Whether they are of a width that can be drawn; an error names it as the property does.
Status checkStroke(const LineStyle& style, const char* name = "StrokeWidth");

/// What all lines of one frame depend on.
struct LineView
{
  Camera camera;
  Vec3f ambientLight = { 0, 0, 0 };
  Span<const Light> lights;
  int width = 1, height = 1; ///< of the picture, in pixels
  double pixelsPerInch = 72;
  std::vector<LightRays> rays; ///< of the lights those that are on; headlights last
  int threads = 0;
};

/// Number by number, so that what is kept for one is right for the other.
bool isSamePlace(const Mat4d& a, const Mat4d& b);

/// Owns the lines of a frame's instances.
struct FrameLines
{
  std::vector<std::unique_ptr<std::vector<LineSet>>> sets; ///< of one instance each
  std::vector<std::shared_ptr<const EdgeChains>> edges;
  std::vector<std::shared_ptr<const ContourLines>> contours;
  std::vector<std::unique_ptr<const ContourLines>> hatches;
};

/// What one mapper keeps of its lines between frames: what does not depend on the camera is made
/// anew only when the mesh or what is asked for has changed.
class SurfaceLines
{
public:
  /// Gives `instance`, described already, the lines of which `property` tells. `geometry` counts
  /// the mesh's changes. Errors: those of buildEdgeTable().
  Status add(vtkLimnProperty* property, vtkPolyData* data, vtkIdType geometry, const LineView& view,
    Instance& instance, FrameLines& frame);

  /// Frees what is kept for the mesh as it was before.
  void releaseAllBut(vtkIdType geometry);

  vtkIdType edgeBuilds() const { return edgeBuilds_; }

private:
  /// Vertex normals, as the data has them or as they are computed.
  struct NormalsVersion
  {
    const void* values = nullptr; ///< nullptr: none
    vtkMTimeType time = 0;        ///< of the data's
    int source = 0;               ///< vtkLimnProperty::VertexNormalSources
    double featureDegrees = 0;

    bool operator==(const NormalsVersion& other) const;
  };
  static NormalsVersion normalsVersion(
    vtkLimnProperty* property, vtkPolyData* data, const Instance& instance);
  struct Choice
  {
    unsigned kinds = 0;
    double creaseDegrees = -1;
    std::uint32_t shortestCrease = 1;
    const void* ids = nullptr;
    vtkMTimeType idsTime = 0;
    NormalsVersion normals; ///< those of the instance

    bool operator==(const Choice& other) const;
  };

  Status update(vtkIdType geometry, const Instance& instance, int threads);
  void updateFeatures(
    const Choice& choice, vtkDataArray* idArray, const Instance& instance, int threads);
  Status updateNormals(double creaseDegrees, const Instance& instance, int threads);
  MeshView weldedMesh(const MeshView& mesh) const;
  void weld(const MeshView& mesh, int threads);
  void updateCurvature(const NormalsVersion& normals, const Instance& instance, int threads);
  CurvedSurface curved(const MeshView& mesh) const;
  FeatureArrays contourArrays() const;
  void addFeatures(vtkLimnProperty* property, vtkPolyData* data, const LineView& view,
    const Instance& instance, FrameLines& frame);
  class Finders;
  Status addContours(vtkLimnProperty* property, const LineStyle& style, const LineView& view,
    const Instance& instance, Finders& finders, FrameLines& frame);
  Status addTerminators(
    vtkLimnProperty* property, const LineView& view, const Instance& instance, FrameLines& frame);
  void addCurves(vtkLimnProperty* property, vtkPolyData* data, const LineView& view,
    const Instance& instance, Finders& finders, FrameLines& frame);

  /// The angle of edges at which strokes end.
  double hatchCreaseDegrees(
    vtkLimnProperty* property, vtkPolyData* data, const Instance& instance) const;
  Status updateStrokes(
    vtkLimnProperty* property, vtkPolyData* data, const Instance& instance, int threads);
  LineSet hatchLinesOf(
    vtkLimnProperty* property, const LineView& view, const Instance& instance, FrameLines& frame);

  vtkIdType geometry_ = -1;
  vtkIdType edgeBuilds_ = 0;
  EdgeTable table_;
  FacingBounds faceBounds_; ///< empty until silhouettes are asked for
  Choice choice_;
  std::shared_ptr<const EdgeChains> features_;
  Array<Triangle> weldedTriangles_;
  double normalsDegrees_ = -1;
  SplitNormals normals_;             ///< of the welded mesh, split where lines are creases
  Array<std::uint32_t> onlyNormals_; ///< of these, by place: FeatureArrays::normalOfVertex
  FacingBounds normalBounds_;
  std::vector<Vec3f> smoothNormals_;
  NormalsVersion curvedNormals_;
  Array<VertexCurvature> curvature_;
  double featureSize_ = 0;  ///< of the surface that bends so
  CurveBounds curveBounds_; ///< of it; empty until suggestive contours are asked for
  std::shared_ptr<const ContourLines> ridges_, valleys_;
  double ridgeThreshold_ = -1; ///< of these
  /// Of one light, as the mesh is placed.
  struct Terminator
  {
    LightRays light;
    Mat4d place;
    double creaseDegrees;
    std::shared_ptr<const ContourLines> lines;
  };
  std::vector<Terminator> terminators_;
  std::unique_ptr<const HatchStrokes> strokes_;
  double strokesCreaseAngle_ = -1, strokesDegrees_ = -1; ///< of these: as asked, and as they end
};

} // namespace limn::bridge

#endif
