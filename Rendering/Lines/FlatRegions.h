// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchSurface.h"

namespace limn {

/// Connected triangles in one plane.
struct FlatRegion {
  Vec3d normal;  ///< unit
  /// Unit, in the plane: along the most of its straight border, counted by length together with
  /// what is at right angles to it. Where no direction has a fifth of the border, as of disks, and
  /// of directions that have as much, the one that is level, by z; x where the plane is.
  Vec3d along;
  Vec3d origin;   ///< on a border that is along it or at right angles, if there is one
  bool isFramed;  ///< all of its border is creases, borders of the mesh or edges of several faces
};

struct FlatRegions {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::vector<std::uint32_t> ofTriangle;  ///< or kNone; empty where there are no regions
  std::vector<FlatRegion> regions;

  std::uint32_t of(std::size_t triangle) const
  {
    return ofTriangle.empty() ? kNone : ofTriangle[triangle];
  }
  bool isFramed(std::size_t triangle) const
  {
    return of(triangle) != kNone && regions[of(triangle)].isFramed;
  }
};

/// The distance of strokes, as a share of the diagonal of the mesh's box.
inline constexpr double kHatchDensity = 1.0 / 200;

/// Triangles whose normals are within 0.1 degrees of the first one's, and of slivers, of which they
/// say little, those in its plane. Regions smaller than two by two distances of strokes do not
/// count; nor do those that go over into others without a crease, unless they have four times the
/// area of each of these: others are facets of something round.
FlatRegions flatRegions(const HatchSurface& surface, int threads);

}  // namespace limn
