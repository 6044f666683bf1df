// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cstdint>

namespace limn {

/// Where an edge of one triangle goes through another.
struct CutPoint {
  std::uint32_t point[2];  ///< of the WorldMesh, the ends of the edge, the lower first
  std::uint32_t triangle;  ///< the other
  Vec3d place;
};

/// Where two triangles cut each other whose boxes meet. What only touches, within rounding, counts
/// as moved apart by as good as nothing: the later triangle, or that of the later body, along
/// kCutMove. Triangles of one body that have a point in common do not cut.
struct CutPiece {
  std::uint32_t triangle[2];  ///< the lower first
  CutPoint end[2];
};

/// Askew to what things are mostly built along.
inline constexpr Vec3d kCutMove = {0.5773, 0.3217, 0.7505};
/// Distances below this share of WorldMesh::size are rounding.
inline constexpr double kCutRounding = 1e-12;
/// Boxes of triangles that are apart by no more roundings meet: what lies off a plane by less may
/// count as beyond it, and slivers' planes round more.
inline constexpr double kCutBoxRoundings = 64;

}  // namespace limn
