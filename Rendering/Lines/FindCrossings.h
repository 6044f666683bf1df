// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cstddef>

namespace limn {

/// An edge as the smooth surface has it: a cubic's control points, and a quadratic's for the
/// normal.
struct EdgeCurve {
  Vec3d point[4], normal[3];
};

/// A crossing is known to 2^-kCrossingHalvings of its edge.
inline constexpr int kCrossingHalvings = 40;

/// Edges at whose ends the surface faces other ways, and where in between it turns. One array a
/// component; vectors may read up to kCapacity.
struct alignas(64) CrossingBatch {
  static constexpr std::size_t kCapacity = 64;

  double point[4][3][kCapacity], normal[3][3][kCapacity];
  double startsFront[kCapacity];  ///< 1: the curve starts on the front, 0: it ends there
  double found[3][kCapacity];
  std::size_t count = 0;

  /// Requires: room.
  void add(const EdgeCurve& curve, bool startIsFront)
  {
    for (int k = 0; k < 4; ++k)
      set(point[k], curve.point[k]);
    for (int k = 0; k < 3; ++k)
      set(normal[k], curve.normal[k]);
    startsFront[count++] = startIsFront ? 1.0 : 0.0;
  }
  Vec3d place(std::size_t i) const { return {found[0][i], found[1][i], found[2][i]}; }

 private:
  void set(double (&to)[3][kCapacity], Vec3d v) const
  {
    to[0][count] = v.x;
    to[1][count] = v.y;
    to[2][count] = v.z;
  }
};

/// Finds the places by halving, seen from a point, or from the direction `eye`.
void findCrossings(Vec3d eye, bool isParallel, CrossingBatch& batch);

}  // namespace limn
