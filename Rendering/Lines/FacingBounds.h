// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Prefetch.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Scene.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace limn {

/// So many edges in a row of an EdgeTable are bounded together.
inline constexpr std::size_t kEdgesPerBound = 16;

/// Box about planes {n, n.(p - center)} with unit normals n through points p.
struct PlaneBox {
  float middle[4];
  float half[4];  ///< infinite: nothing is known
};

/// Of each kEdgesPerBound edges the planes about them. Whole stretches of a mesh that are seen from
/// one side, most of it, need no closer look: they have no contour. None, and nothing is left out,
/// while `boxes` is empty.
struct FacingBounds {
  Vec3d center = {0, 0, 0};  ///< of the mesh's box
  double radius = 0;         ///< about it
  double reach = 0;          ///< of the mesh from the origin
  std::vector<PlaneBox> boxes;
};

/// Planes of the faces at edges that are shared, the second turned over where it is not wound
/// alike. The same on any number of threads, as are those of the two below.
FacingBounds boundFaces(const MeshView& mesh, const EdgeTable& table, int threads);

/// Planes through the ends of edges, by the vertex normals that the faces there have.
FacingBounds boundNormals(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                          int threads);

/// Planes through the ends of edges, by the normals, one a vertex, that these ends have themselves.
/// `box` is finiteBox() of the mesh.
FacingBounds boundEnds(const MeshView& mesh, const Box& box, const EdgeTable& table,
                       Span<const Vec3f> normals, int threads);

/// Calls visit(vertex) for the ends of an edge, but for the lower one where the edge before, of the
/// same kEdgesPerBound, has it, too.
template <class Visit>
void forEachNewEnd(const EdgeTable& table, std::size_t e, const Visit& visit)
{
  const MeshEdge& edge = table.edges[e];
  if (e % kEdgesPerBound == 0 || table.edges[e - 1].vertex[0] != edge.vertex[0])
    visit(edge.vertex[0]);
  visit(edge.vertex[1]);
}

/// Calls visit(edge's number) for those of the edges [first, end) whose bounds are not left out:
/// isLeftOut(number of a box). `first` is a multiple of kEdgesPerBound. What is read of so few
/// edges lies far apart in memory: fetch(edge) is to begin with that, a while before the visit.
template <class LeaveOut, class Fetch, class Visit>
void forEachBoundedEdge(const EdgeTable& table, std::size_t first, std::size_t end,
                        const LeaveOut& isLeftOut, const Fetch& fetch, const Visit& visit)
{
  constexpr std::size_t kMost = 64, kAhead = 2;
  std::size_t kept[kMost];
  const auto forEachOf = [&](std::size_t box, const auto& body) {
    const std::size_t last = std::min(end, (box + 1) * kEdgesPerBound);
    for (std::size_t e = box * kEdgesPerBound; e < last; ++e)
      body(e);
  };
  const auto fetchBox = [&](std::size_t box) {
    forEachOf(box, [&](std::size_t e) { fetch(table.edges[e]); });
  };
  const std::size_t boxes = (end + kEdgesPerBound - 1) / kEdgesPerBound;
  for (std::size_t box = first / kEdgesPerBound; box < boxes;) {
    std::size_t count = 0;
    for (; box < boxes && count < kMost; ++box) {
      if (isLeftOut(box)) continue;
      forEachOf(box, [&](std::size_t e) { prefetch(&table.edges[e]); });
      kept[count++] = box;
    }
    for (std::size_t i = 0; i < count + kAhead; ++i) {
      if (i < count) fetchBox(kept[i]);
      if (i >= kAhead) forEachOf(kept[i - kAhead], visit);
    }
  }
}

/// Takes directions of any length from view space to a model's own, not only where it is rigid.
class ModelDirections {
 public:
  explicit ModelDirections(const Mat4d& toView)
      : cofactor_(cofactor3(toView)), perDeterminant_(1.0 / determinant3(toView))
  {
  }
  Vec3d operator()(Vec3d inView) const
  {
    const auto column = [&](int c) {
      return (cofactor_.m[0][c] * inView.x + cofactor_.m[1][c] * inView.y) +
             cofactor_.m[2][c] * inView.z;
    };
    return Vec3d{column(0), column(1), column(2)} * perDeterminant_;
  }

 private:
  Mat4d cofactor_;
  double perDeterminant_;
};

/// Where a camera looks from, in a model's own space.
struct ModelEye {
  Vec3d place;  ///< the eye; or the direction towards it, of any length
  bool isParallel;

  ModelEye(const Camera& camera, const Mat4d& modelToWorld);
  Vec3d toward(Vec3d position) const { return isParallel ? place : place - position; }
};

/// Which bounded planes a camera sees from one side, by more than rounding can be mistaken.
class BoundedFacing {
 public:
  enum class Side { kBoth, kFront, kBack };

  BoundedFacing(const FacingBounds& bounds, const Camera& camera, const Mat4d& modelToWorld);

  Side side(std::size_t box) const
  {
    if (boxes_.empty()) return Side::kBoth;
    double middle = 0, half = margin_;
    for (int i = 0; i < 4; ++i) {
      middle += eye_[i] * static_cast<double>(boxes_[box].middle[i]);
      half += size_[i] * static_cast<double>(boxes_[box].half[i]);
    }
    if (middle > half) return Side::kFront;
    return middle < -half ? Side::kBack : Side::kBoth;
  }

 private:
  Span<const PlaneBox> boxes_;
  double eye_[4], size_[4];  ///< n.(eye - p) is their product with a plane; sizes of the same
  double margin_;
};

}  // namespace limn
