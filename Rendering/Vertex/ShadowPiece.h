// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/WorldMesh.h"

/// The border of what light casts in shadow.
///
/// It is cast by borders of sheets, by edges of which the normals on one side are lit and those on
/// the other are not, and where the normals turn away from the light between: by the contour that
/// the light sees, one segment a triangle, if the surface bulges there, or if its body is a sheet.
/// In the half plane of the rays through such a caster from A to B a point is told by u, from 0 at
/// A to 1 at B, and by w, which is 0 at the caster, less behind it and more before it: of parallel
/// rays in the direction d it is A + u (B - A) - w d, and of rays from L it is
/// L + (A + u (B - A) - L) / (1 + w). There each triangle that the half plane cuts is a straight
/// line, w linear in u. For each u the ray ends at the triangle of the largest w (of equal ones the
/// first), all but those at the caster itself: a w above 0 keeps the light from the caster, and
/// where it is below 0 the triangle has the border of a shadow. Nearer to the caster than
/// kShadowContact times the scene's size it has none. The ray is looked at between all places where
/// a triangle begins, ends or cuts another, but for those that lie so much behind where it ends,
/// or kShadowRounding if that is more; and not at all in those of kShadowSteps even steps of the
/// caster that one triangle alone keeps dark: no border comes of either.
///
/// Facets stand a little beside the surface that they stand for. So of the caster's own body, where
/// that is curved, a ray goes on: within `reach` of the caster and within the crease angle of its
/// faces, through what is before it, unless light comes from the surface's other side, and through
/// what is behind it if it leaves again at once; and through all that it leaves from inside.
namespace limn {

/// As a share of WorldMesh::size.
inline constexpr double kShadowContact = 1e-6;
inline constexpr double kShadowRounding = 1e-12;  ///< of w
inline constexpr int kShadowSteps = 16;
/// Rays are followed from this share of their way to the edge on.
inline constexpr double kShadowNear = 1e-6;
/// A caster's reach, in sides of its facets: the longest at contours, the shortest at edges.
inline constexpr double kShadowFacets = 3;
/// A contour's gap is its reach, or this times the shortest side of its facet if that is less.
inline constexpr double kShadowGap = 6;
/// Faces are flat whose vertices' normals are no farther than this from theirs.
inline constexpr double kShadowFlat = 1e-3;
/// The light's contour crosses an edge at a place known to 2^-kShadowHalvings of it.
inline constexpr int kShadowHalvings = 40;
/// Shorter pieces, in u, are left out.
inline constexpr double kShadowSliver = 1e-9;

/// A straight part of what casts a border: of an edge, or of a contour seen from the light.
struct ShadowCaster {
  Vec3d end[2];               ///< world
  std::uint64_t place[2];     ///< equal where two casters of a body meet
  std::uint32_t triangle[2];  ///< of the edge, the second kNoCorner at a border; or that it crosses
  std::uint32_t point[2];     ///< of the edge; of a contour kNoCorner
  std::uint32_t body;
  bool bulgesOut;  ///< whether the light that grazes it is on the outer side, as at all edges
  double reach;    ///< how far facets next to it may stand in the way; 0 where faces are flat
  double gap;      ///< what may be missing of the border; as `reach`, but at sheets' borders, too

  bool isContour() const { return point[0] == kNoCorner; }
};

struct ShadowPiece {
  std::uint32_t caster;
  std::uint32_t receiver;  ///< the triangle that it lies on
  double u0, u1;           ///< along the caster
  Vec3d from, to;          ///< world
};

}  // namespace limn
