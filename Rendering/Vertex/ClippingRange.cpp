// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ClippingRange.h"

namespace limn {

DepthRange depthRangeOf(const ToneRamp& ramp, const Camera& camera)
{
  if (ramp.nearest > 0) return {ramp.nearest, ramp.farthest};
  // Where z = -1 and 1 after the divide by w, which is 1, or in perspective the distance.
  const double a = camera.viewToClip.m[2][2], b = camera.viewToClip.m[2][3];
  const double nearest = camera.parallel ? (b + 1) / a : b / (a - 1);
  const double farthest = camera.parallel ? (b - 1) / a : b / (a + 1);
  constexpr DepthRange kAny = {1, 2};
  if (!(farthest > 1e-30 && farthest < 1e30)) return kAny;
  const double least = farthest / 1000;
  const double bounded = nearest > least ? nearest : least;
  if (!(bounded < farthest)) return kAny;
  return {static_cast<float>(bounded), static_cast<float>(farthest)};
}

}  // namespace limn
