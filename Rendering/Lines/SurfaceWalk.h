// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceCurves.h"

namespace limn {

/// A place on a mesh and a way to go on.
struct WalkPoint {
  std::uint32_t triangle;
  Vec3d position;   ///< in the triangle
  Vec3d direction;  ///< unit, in the triangle's plane
};

/// Walks over the triangles of a mesh along a field of directions without a sign, by vertex, and
/// across it.
class SurfaceWalk {
 public:
  /// All outlive it. `field` is one per vertex, perpendicular to its normal, unit or 0.
  SurfaceWalk(const CurvedSurface& surface, const EdgeTable& table, Span<const Vec3f> field);

  /// The middle of the triangle `number`; false if it has no area.
  bool seed(std::size_t number, WalkPoint& point) const;
  std::size_t seedCount() const { return surface_.mesh.triangles.size(); }

  /// A step of the field, or of the directions across it, in the sense that is nearest to the
  /// point's direction, by the midpoint rule. False, with the point moved as far as it goes, at a
  /// border, an edge of three faces and more, or one of more than 60 degrees.
  bool stepAlong(WalkPoint& point, bool across, double length) const;

  /// The field in the triangle's plane, near to the point's direction; unit.
  Vec3d fieldAt(const WalkPoint& point, bool across) const;
  /// Of the smooth surface; unit.
  Vec3d normalAt(const WalkPoint& point) const;

 private:
  struct Corners {
    Vec3d p[3], normal;  ///< unit
  };
  Corners cornersOf(std::uint32_t triangle) const;
  void weigh(const WalkPoint& point, const Corners& corners, double (&weight)[3]) const;
  bool goStraight(WalkPoint& point, double length) const;
  bool cross(WalkPoint& point, int edge, const Corners& from) const;

  const CurvedSurface& surface_;
  Span<const Vec3f> field_;
  std::vector<std::uint32_t> neighbour_;  ///< three a triangle: across the edge from each corner
};

}  // namespace limn
