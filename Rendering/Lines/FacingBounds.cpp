// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FacingBounds.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kBoxesPerTask = 512;

/// Lower triangles than this share of the mesh's reach may turn over by rounding.
constexpr double kLeastHeight = 1e-7;
/// By how much rounding may turn a plane of a triangle of that height, with room to spare.
constexpr double kTurn = 1e-5;
/// What a box' float may lack of a double, with room to spare.
constexpr double kFloatSlack = 1e-6;

class BoxBuilder {
 public:
  void add(Vec3d n, double distance)
  {
    const double values[4] = {n.x, n.y, n.z, distance};
    for (int i = 0; i < 4; ++i) {
      low_[i] = std::min(low_[i], values[i]);
      high_[i] = std::max(high_[i], values[i]);
      isKnown_ = isKnown_ && std::fabs(values[i]) < std::numeric_limits<float>::max();
    }
  }
  void addUnknown() { isKnown_ = false; }

  PlaneBox box() const
  {
    PlaneBox result = {};
    for (int i = 0; i < 4; ++i) {
      if (!isKnown_ || !(low_[i] <= high_[i])) {
        result.half[i] = std::numeric_limits<float>::infinity();
        continue;
      }
      const double size = std::max(std::fabs(low_[i]), std::fabs(high_[i]));
      result.middle[i] = static_cast<float>(0.5 * (low_[i] + high_[i]));
      result.half[i] = static_cast<float>(0.5 * (high_[i] - low_[i]) + kFloatSlack * size);
    }
    return result;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  double low_[4] = {kFar, kFar, kFar, kFar}, high_[4] = {-kFar, -kFar, -kFar, -kFar};
  bool isKnown_ = true;
};

double lengthOf(Vec3d v)
{
  return std::sqrt(dot(v, v));
}

FacingBounds boundsOf(const MeshView& mesh, int threads)
{
  FacingBounds bounds;
  const Box box = finiteBox(mesh, threads);
  if (box.empty()) return bounds;
  bounds.center = (box.low + box.high) * 0.5;
  bounds.radius = lengthOf(box.high - bounds.center);
  bounds.reach = lengthOf(bounds.center) + bounds.radius;
  return bounds;
}

/// Calls addPlanes(edge's number, box) for all edges.
template <class AddPlanes>
void fillBoxes(const EdgeTable& table, int threads, FacingBounds& bounds,
               const AddPlanes& addPlanes)
{
  bounds.boxes.resize(stretchCount(table.edges.size(), kEdgesPerBound));
  parallelForEach(threads, bounds.boxes.size(), kBoxesPerTask, [&](std::size_t b) {
    BoxBuilder box;
    const std::size_t end = std::min(table.edges.size(), (b + 1) * kEdgesPerBound);
    for (std::size_t e = b * kEdgesPerBound; e < end; ++e)
      addPlanes(e, box);
    bounds.boxes[b] = box.box();
  });
}

/// Frobenius norm.
double sizeOf(const Mat4d& a)
{
  double sum = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      sum += a.m[row][column] * a.m[row][column];
  return std::sqrt(sum);
}

}  // namespace

FacingBounds boundFaces(const MeshView& mesh, const EdgeTable& table, int threads)
{
  FacingBounds bounds = boundsOf(mesh, threads);
  const double leastHeight = kLeastHeight * bounds.reach;
  fillBoxes(table, threads, bounds, [&](std::size_t e, BoxBuilder& box) {
    const MeshEdge& edge = table.edges[e];
    if (!edge.isShared()) return;
    for (int f = 0; f < 2; ++f) {
      const auto [a, b, c] = mesh.triangles[edge.corner[f] / 3].vertex;
      const Vec3d p = mesh.position(a), ab = mesh.position(b) - p, ac = mesh.position(c) - p;
      const Vec3d bc = ac - ab, n = cross(ab, ac);
      const double length = lengthOf(n);
      const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
      if (!(length > leastHeight * longest)) {
        box.addUnknown();
        continue;
      }
      const bool isTurned = f == 1 && table.woundAlike[e] == 0;
      const Vec3d unit = n * ((isTurned ? -1 : 1) / length);
      box.add(unit, dot(unit, p - bounds.center));
    }
  });
  return bounds;
}

FacingBounds boundNormals(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                          int threads)
{
  FacingBounds bounds = boundsOf(mesh, threads);
  const auto addCorner = [&](std::uint32_t corner, BoxBuilder& box) {
    const std::uint32_t vertex = mesh.triangles[corner / 3].vertex[corner % 3];
    const std::uint32_t number =
        arrays.normalOfCorner.empty() ? vertex : arrays.normalOfCorner[corner];
    const Vec3d n = vec3Cast<double>(arrays.vertexNormals[number]);
    const double length = lengthOf(n);
    if (!(length > 0)) {
      box.addUnknown();
      return;
    }
    const Vec3d unit = n * (1 / length);
    box.add(unit, dot(unit, mesh.position(vertex) - bounds.center));
  };
  fillBoxes(table, threads, bounds, [&](std::size_t e, BoxBuilder& box) {
    const MeshEdge& edge = table.edges[e];
    for (int f = 0; f < (edge.isShared() ? 2 : 1); ++f) {
      const std::uint32_t corner = edge.corner[f];
      addCorner(corner, box);
      addCorner(corner % 3 == 2 ? corner - 2 : corner + 1, box);
    }
  });
  return bounds;
}

ModelEye::ModelEye(const Camera& camera, const Mat4d& modelToWorld) : isParallel(camera.parallel)
{
  const Mat4d toView = camera.worldToView * modelToWorld;
  place = ModelDirections(toView)(
      isParallel ? Vec3d{0, 0, 1} : Vec3d{-toView.m[0][3], -toView.m[1][3], -toView.m[2][3]});
}

BoundedFacing::BoundedFacing(const FacingBounds& bounds, const Camera& camera,
                             const Mat4d& modelToWorld)
    : boxes_(bounds.boxes)
{
  const Mat4d toView = camera.worldToView * modelToWorld;
  const ModelEye eye(camera, modelToWorld);
  // Of a parallel camera, too: coordinates are rounded by where its view begins.
  const ModelEye origin({camera.worldToView, camera.viewToClip, false}, modelToWorld);
  const double condition =
      sizeOf(toView) * sizeOf(cofactor3(toView)) / std::fabs(determinant3(toView));
  const Vec3d direction = eye.isParallel ? eye.place : eye.place - bounds.center;
  const double values[4] = {direction.x, direction.y, direction.z, eye.isParallel ? 0.0 : -1.0};
  for (int i = 0; i < 4; ++i) {
    eye_[i] = values[i];
    size_[i] = std::fabs(values[i]);
  }
  const double length = lengthOf(direction) + (eye.isParallel ? 0 : bounds.radius);
  margin_ = kTurn * condition * (1 + lengthOf(origin.place) / bounds.reach) * length;
}

}  // namespace limn
