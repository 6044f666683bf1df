// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Scene.h"

namespace limn {

/// Which side of a mesh's faces a camera sees.
class Facing {
 public:
  Facing(const MeshView& mesh, const Camera& camera, const Mat4d& modelToWorld)
      : mesh_(mesh),
        toView_(camera.worldToView * modelToWorld),
        isParallel_(camera.parallel),
        isMirrored_(determinant3(toView_) < 0)
  {
  }

  Vec3d inView(std::uint32_t vertex) const
  {
    return transformPoint(toView_, mesh_.position(vertex));
  }
  /// From a point in view space, of any length.
  Vec3d towardEye(Vec3d p) const { return isParallel_ ? Vec3d{0, 0, 1} : -p; }

  /// The outer side, by the winding; faces seen edge-on count as front.
  bool isFront(std::uint32_t triangle) const
  {
    const auto [a, b, c] = mesh_.triangles[triangle].vertex;
    return isFront(inView(a), inView(b), inView(c));
  }
  /// Of corners in view space.
  bool isFront(Vec3d a, Vec3d b, Vec3d c) const
  {
    const double side = dot(cross(b - a, c - a), towardEye(a));
    return isMirrored_ ? side <= 0 : side >= 0;
  }
  bool isOuter(const EdgeTable& table, const MeshEdge& edge) const
  {
    if (!edge.isShared()) return true;
    const bool isTurned = isFront(edge.corner[0] / 3) != isFront(edge.corner[1] / 3);
    return isTurned == table.isWoundAlike(mesh_, edge);
  }

 private:
  const MeshView& mesh_;
  Mat4d toView_;
  bool isParallel_, isMirrored_;
};

}  // namespace limn
