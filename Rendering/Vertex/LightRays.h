// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

namespace limn {

/// How the rays of a light run, for lines that tell where it shines. Rectangles and spheres count
/// as points in their middle.
struct LightRays {
  bool isParallel;
  Vec3d source;  ///< world: its position, or if parallel the unit vector towards it
  bool isCone;   ///< only rays no farther than `cosine` from `axis`, a unit vector
  Vec3d axis;
  double cosine;

  /// From a point towards the light, of any length.
  Vec3d towardLight(Vec3d p) const { return isParallel ? source : source - p; }
  /// Whether the cone holds a point.
  bool holds(Vec3d p) const
  {
    if (!isCone) return true;
    const Vec3d way = p - source;
    return dot(way, axis) >= cosine * std::sqrt(dot(way, way));
  }
};

/// The camera places headlights.
LightRays lightRays(const Light& light, const Camera& camera);

bool operator==(const LightRays& a, const LightRays& b);

}  // namespace limn
