// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/EdgeTable.h"
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
/// alike. The same on any number of threads, as are those of boundNormals().
FacingBounds boundFaces(const MeshView& mesh, const EdgeTable& table, int threads);

/// Planes through the ends of edges, by the vertex normals that the faces there have.
FacingBounds boundNormals(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                          int threads);

/// Calls visit(edge's number) for those of the edges [first, end) whose bounds are not left out:
/// isLeftOut(number of a box). `first` is a multiple of kEdgesPerBound.
template <class LeaveOut, class Visit>
void forEachBoundedEdge(std::size_t first, std::size_t end, const LeaveOut& isLeftOut,
                        const Visit& visit)
{
  for (std::size_t e = first; e < end;) {
    const std::size_t next = std::min(end, e + kEdgesPerBound);
    if (!isLeftOut(e / kEdgesPerBound))
      for (; e < next; ++e)
        visit(e);
    e = next;
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
