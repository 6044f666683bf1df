// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceWalk.h"

namespace limn {

/// Where strokes begin that are evenly apart on a surface of circles, as HatchField has them: along
/// one of its profiles for circles, along a circle half way for the profiles.
class SeedLine {
 public:
  /// Of the connected surface that a triangle belongs to, for the family across circles or for
  /// them. Empty where that meets a border on its way round.
  SeedLine(const SurfaceWalk& walk, std::uint32_t triangle, bool isCross, double step);

  /// The points that halve the distances of all before, in the first call those whose distance
  /// is nearest to `distance`, if one fits in.
  std::vector<WalkPoint> next(double distance);
  /// How many times as dense as asked that last time all are.
  double density() const { return density_; }

 private:
  void findProfile(WalkPoint start);
  void findCircle();
  void go(WalkPoint from, double way);
  WalkPoint at(double share) const;

  const SurfaceWalk* walk_;
  Vec3d axis_;
  double step_;
  std::vector<WalkPoint> points_;  ///< a step apart
  bool isCircle_ = false;
  double length_ = 0;
  double count_ = 0;  ///< distances that it is divided in; 0: not yet
  int halvings_ = 0;
  double density_ = 1;
};

}  // namespace limn
