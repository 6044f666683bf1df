// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/WorldMesh.h"

/// The border of what light casts in shadow.
///
/// An edge from A to B casts it where it is a border, or both of its faces lie on one side of the
/// half plane that it makes with the light. In that half plane a point is told by u, from 0 at A to
/// 1 at B, and by w, which is 0 at the edge, less behind it and more before it: of parallel rays in
/// the direction d it is A + u (B - A) - w d, and of rays from L it is L + (A + u (B - A) - L) /
/// (1 + w). There each triangle that the half plane cuts is a straight line, w linear in u. For
/// each u the ray ends at the triangle of the largest w (of equal ones the first), all but those at
/// the edge itself: a w above 0 keeps the light from the edge, and where it is below 0 the triangle
/// has the border of a shadow. Nearer to the edge than kShadowContact times the scene's size it has
/// none.
namespace limn {

/// As a share of WorldMesh::size.
inline constexpr double kShadowContact = 1e-6;
/// Rays are followed from this share of their way to the edge on.
inline constexpr double kShadowNear = 1e-6;
/// A smooth surface has no border of its own nearer to the edge than so many times as its faces are
/// wide across it.
inline constexpr double kShadowFacets = 3;
/// Shorter pieces, in u, are left out.
inline constexpr double kShadowSliver = 1e-9;

struct ShadowPiece {
  std::uint32_t edge;      ///< of the WorldMesh
  std::uint32_t receiver;  ///< the triangle that it lies on
  double u0, u1;           ///< along the edge
  Vec3d from, to;          ///< world
};

}  // namespace limn
