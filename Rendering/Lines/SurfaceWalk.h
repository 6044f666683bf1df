// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchField.h"

namespace limn {

/// A place on a mesh and a way to go on.
struct WalkPoint {
  std::uint32_t triangle;
  Vec3d position;   ///< in the triangle
  Vec3d direction;  ///< unit, in the triangle's plane
};

/// Walks over the triangles of a mesh along the crosses of a field.
class SurfaceWalk {
 public:
  /// Both outlive it.
  SurfaceWalk(const HatchSurface& surface, const HatchField& field);

  /// The middle of the triangle `number`; false if it has no area.
  bool seed(std::size_t number, WalkPoint& point) const;
  std::size_t seedCount() const { return surface_.mesh.triangles.size(); }
  /// HatchField::circles of a triangle, and their axis.
  std::uint8_t circlesAt(std::size_t triangle) const;
  /// A triangle of each connected surface of circles.
  std::vector<std::uint32_t> circledTriangles() const;
  static Vec3d axisOf(std::uint8_t about);

  /// A step along the arm of the cross that is nearest to the point's direction, by the midpoint
  /// rule. False, with the point moved as far as it goes, at a border, an edge of three faces and
  /// more, or a crease; and where that arm is of the other family, which `across` names.
  /// `drift` is the tangent of an angle by which it keeps to the left of the arm.
  bool stepAlong(WalkPoint& point, bool across, double length, double drift = 0) const;

  /// The first axis, or what is across it, in the triangle's plane, in the sense that is nearest to
  /// the point's direction; unit.
  Vec3d fieldAt(const WalkPoint& point, bool across) const;
  /// Of the smooth surface; unit.
  Vec3d normalAt(const WalkPoint& point) const;

 private:
  struct Corners {
    Vec3d p[3], normal;  ///< unit
  };
  Corners cornersOf(std::uint32_t triangle) const;
  void weigh(const WalkPoint& point, const Corners& corners, double (&weight)[3]) const;
  Vec3d axisAt(const WalkPoint& point, const Corners& corners) const;
  bool goStraight(WalkPoint& point, double length) const;
  bool cross(WalkPoint& point, int edge, const Corners& from) const;

  const CurvedSurface& surface_;
  const HatchField& field_;
  std::vector<std::uint32_t> neighbour_;  ///< three a triangle: across the edge from each corner
};

}  // namespace limn
