// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cmath>

namespace limn {

/// Lines that cut a pixel, given by their unit normal and their distance from the pixel's centre
/// along it: how much of the pixel lies on the side that the normal does not point to, and back.
/// By components of the normal; the sides do not matter for their signs.
struct CutPixel {
  float longer, shorter;

  explicit CutPixel(Vec2f normal)
  {
    const float x = normal.x < 0.0f ? -normal.x : normal.x;
    const float y = normal.y < 0.0f ? -normal.y : normal.y;
    longer = x < y ? y : x;
    shorter = x < y ? x : y;
  }

  float areaBelow(float distance) const
  {
    const float flat = (longer - shorter) * 0.5f, end = (longer + shorter) * 0.5f;
    if (!(distance > -end)) return 0.0f;
    if (!(distance < end)) return 1.0f;
    if (distance >= -flat && distance <= flat) return 0.5f + distance / longer;
    const float rest = distance < 0.0f ? end + distance : end - distance;
    const float corner = rest * rest / (2.0f * longer * shorter);
    return distance < 0.0f ? corner : 1.0f - corner;
  }
  /// Requires: 0 < area < 1.
  float distanceOf(float area) const
  {
    const float flat = (longer - shorter) * 0.5f, end = (longer + shorter) * 0.5f;
    const float fromMiddle = area - 0.5f;
    const float linear = fromMiddle * longer;
    if (linear >= -flat && linear <= flat) return linear;
    const float twice = 2.0f * longer * shorter;
    return area < 0.5f ? std::sqrt(twice * area) - end : end - std::sqrt(twice * (1.0f - area));
  }
};

}  // namespace limn
