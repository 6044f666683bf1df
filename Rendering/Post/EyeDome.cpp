// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EyeDome.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/EyeDome.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/EyeDome-inl.h"

#if HWY_ONCE
namespace limn {
namespace {

EyeDomeTaps::Tap tapAt(float x, float y)
{
  const float dx = std::nearbyint(x), dy = std::nearbyint(y);
  return {static_cast<int>(dx), static_cast<int>(dy), 1.0f / std::sqrt(dx * dx + dy * dy)};
}

/// Eight directions, turned by 22.5 degrees or not.
EyeDomeTaps::Ring ringOf(float radius, bool isTurned)
{
  constexpr float kHalf = 0.707106781f;
  const float c = isTurned ? 0.923879533f : 1.0f, s = isTurned ? 0.382683432f : 0.0f;
  const float x = c * radius, y = s * radius;
  const float x2 = (kHalf * (c - s)) * radius, y2 = (kHalf * (c + s)) * radius;
  return {tapAt(x, y),   tapAt(x2, y2),   tapAt(-y, x), tapAt(-y2, x2),
          tapAt(-x, -y), tapAt(-x2, -y2), tapAt(y, -x), tapAt(y2, -x2)};
}

}  // namespace

HWY_EXPORT(eyeDomeKernel);

EyeDomeTaps::EyeDomeTaps(float radius)
    : rings_{ringOf(radius, false), ringOf(2.0f * radius, true), ringOf(3.0f * radius, false),
             ringOf(4.0f * radius, true)}
{
}

int eyeDomeReach(float radius)
{
  return static_cast<int>(std::ceil(4.0f * radius)) + 1;
}

void shadeEyeDome(const EyeDomeTaps& taps, const EyeDomeRow& row)
{
  HWY_DYNAMIC_DISPATCH(eyeDomeKernel)(taps, row);
}

}  // namespace limn
#endif  // HWY_ONCE
