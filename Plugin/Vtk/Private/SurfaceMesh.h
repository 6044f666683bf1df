// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceMesh_h
#define SurfaceMesh_h

#include "MovedPoints.h"
#include "TrianglesFromPolyData.h"
#include "UsableNormals.h"
#include "VectorArray.h"

#include "Rendering/Base/Status.h"
#include "Rendering/Mesh/FaceGeometry.h"
#include "Rendering/Mesh/HullEdges.h"
#include "Rendering/Mesh/SmoothNormals.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Rendering/Scene.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace limn::bridge
{

/// Where vertex normals come from.
struct NormalChoice
{
  bool fromData = true; ///< if there are any
  NormalWeight weight = NormalWeight::kArea;
  double featureDegrees = 180; ///< from here on edges are smooth

  bool operator==(const NormalChoice& other) const;
};

/// Which arrays a style reads besides the geometry.
struct SurfaceNeeds
{
  bool vertexNormals = false;
  NormalChoice normals;
  bool faceGeometry = false;
  bool firstCorners = false; ///< to light faces at, in place of their centroids
  bool triangles = false;    ///< for the reference renderer, and lines
  bool hull = false;         ///< implies `triangles`
  bool smoothNormals = false;
  SmoothScales smoothScales;
};

/// What one mapper keeps of its input between frames. Geometry is prepared anew only when cells are
/// other ones or were modified, and moved when points are; arrays that a style needs are made when
/// first needed.
class SurfaceMesh
{
public:
  /// Brings all up to date with `data`, its points where they are `moved` to, which is borrowed
  /// until the next update(). Errors: those of buildClusters().
  Status update(
    vtkPolyData* data, const MovedPoints& moved, const SurfaceNeeds& needs, int threads);

  /// Colours of the points (`cellFlag` 0) or cells (1), kept by reference; nullptr for none.
  void setColors(vtkUnsignedCharArray* colors, int cellFlag);

  /// Normals that update() computed last; keep them while an instance has them.
  std::shared_ptr<const SplitNormals> computedNormals() const { return normals_; }

  /// Likewise of normals at several scales; null if update() was asked for none.
  std::shared_ptr<const SmoothNormals> smoothNormals() const { return smooth_; }

  /// Sets the instance's geometry and attributes as the last update() asked for them; they are
  /// valid until the data changes, but for computedNormals() and smoothNormals().
  void describe(Instance& instance) const;
  /// Likewise of the instance that draws the hull. Requires: the last update() asked for it.
  void describeHull(Instance& instance) const;

  bool isEmpty() const { return this->clusters_.triangleCount == 0; }
  bool hasPointNormals() const
  {
    // Those that moved triangles have outgrown count as well.
    return !(this->isMoved() ? this->pointNormals_.span() : this->givenNormals()).empty();
  }
  bool hasCellNormals() const { return !this->cellNormals().empty(); }
  vtkIdType geometryBuilds() const { return this->geometryBuilds_; }
  /// Changes of points without a build.
  vtkIdType geometryMoves() const { return this->geometryMoves_; }
  /// Grows with every change of triangles or points.
  vtkIdType geometryChanges() const { return this->geometryChanges_; }

  /// What had to be left out of the last geometry built, in words; empty if nothing.
  std::string complaint() const;
  /// How many normals of the data are not drawn, as they are not finite, and when these were
  /// modified.
  struct UnusableCount
  {
    vtkIdType count = 0;
    vtkMTimeType time = 0;
  };
  UnusableCount unusablePointNormals() const;
  UnusableCount unusableCellNormals() const;
  /// Whether nothing had to be left out, and yet no face of the last geometry built has an area.
  bool isFlattened() const { return this->isFlattened_ && this->complaint().empty(); }

private:
  /// What the triangles are made of, points apart.
  struct CellsVersion
  {
    const void* polys = nullptr;
    const void* strips = nullptr;
    vtkMTimeType time = 0;
    vtkIdType pointCount = 0;
    vtkIdType cellCount = 0;

    bool operator==(const CellsVersion& other) const;
  };
  struct PointsVersion
  {
    const void* points = nullptr;
    vtkMTimeType time = 0;
    vtkMTimeType dataTime = 0; ///< of the data set alone, which is modified for other reasons, too
    vtkMTimeType moved = 0;    ///< MovedPoints::version()

    bool isOfSameArray(const PointsVersion& other) const;
    bool operator==(const PointsVersion& other) const;
  };
  static CellsVersion cellsVersionOf(vtkPolyData* data);
  PointsVersion pointsVersionOf(vtkPolyData* data) const;
  Status updateGeometry(vtkPolyData* data, int threads);
  /// Whether the points are moved for the first, second, fourth, eighth ... time since clusters
  /// were built of points in disorder.
  bool isRebuildDue();
  Status rebuild(vtkPolyData* data, int threads);
  Status supply(vtkPolyData* data, const SurfaceNeeds& needs, int threads);
  Status supplySmoothNormals(vtkPolyData* data, const SurfaceNeeds& needs, int threads);
  Status supplyNormals(vtkPolyData* data, const SurfaceNeeds& needs, int threads);
  void keepTriangles(vtkPolyData* data, int threads);
  bool isKept(const NormalChoice& choice) const;
  Status computeNormals(const NormalChoice& choice, int threads);
  void updateNormals(vtkPolyData* data, int threads);
  /// What normals at several scales are made from, the geometry apart.
  struct SmoothVersion
  {
    SmoothScales scales;
    const void* normals = nullptr; ///< of the data; null: their own
    vtkMTimeType time = 0;

    bool operator==(const SmoothVersion& other) const;
  };
  SmoothVersion smoothVersionOf(vtkPolyData* data, const SurfaceNeeds& needs) const;
  bool isKept(const SmoothVersion& version) const;
  Status computeSmoothNormals(const SmoothVersion& version, int threads);
  MeshView view() const;
  bool isMoved() const { return moved_ && moved_->areMoved(); }
  /// Without those that were made for want of others; what moved triangles have outgrown is none.
  Span<const Vec3f> givenNormals() const;
  Span<const Vec3f> cellNormals() const;

  CellsVersion cellsVersion_;
  PointsVersion pointsVersion_;
  PointArray points_;
  const MovedPoints* moved_ = nullptr;
  SurfaceTriangles surface_;
  ClusteredMesh clusters_;
  Status buildStatus_;
  std::size_t cellCount_ = 0;
  bool isFlattened_ = false; ///< has faces, but none with an area
  vtkIdType geometryBuilds_ = 0;
  vtkIdType geometryMoves_ = 0;
  vtkIdType geometryChanges_ = 0;
  vtkIdType movesToWait_ = 1; ///< from one build in disorder to the next
  vtkIdType movesLeft_ = 1;

  VectorArray pointNormals_;
  VectorArray cellNormals_;
  UsableNormals usablePointNormals_; ///< moved ones, where points are moved
  UsableNormals usableCellNormals_;
  struct Computed
  {
    NormalChoice choice;
    std::shared_ptr<const SplitNormals> normals;
  };
  std::vector<Computed> computed_; ///< the last used last
  std::shared_ptr<const SplitNormals> normals_;
  struct Smoothed
  {
    SmoothVersion version;
    std::shared_ptr<const SmoothNormals> normals;
  };
  std::vector<Smoothed> smoothed_; ///< the last used last
  std::shared_ptr<const SmoothNormals> smooth_;
  FaceGeometry faces_;
  HullEdges hull_;
  bool hasHull_ = false; ///< the above is of the geometry
  std::vector<Vec3d> firstCorners_;
  bool isLitAtFirstCorners_ = false;

  vtkSmartPointer<vtkUnsignedCharArray> colors_;
  int colorCellFlag_ = 0;
};

} // namespace limn::bridge

#endif
