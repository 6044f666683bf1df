// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

/// Snapped coordinates of anything drawn without clipping stay within +-kGuardSubpixels (32768
/// pixels), so that edge functions fit 2^50 and are exact in double and in 64-bit integers.
inline constexpr std::int32_t kGuardSubpixels = 1 << 23;

/// Smallest w that is divided by; what lies nearer to the eye's plane cannot be drawn.
inline constexpr double kSmallestW = 1e-30;

/// A vertex on the screen. Requires of the user: if needsClip, the other members mean nothing.
struct ScreenVertex {
  std::int32_t x, y;  ///< 1/256 pixel from the viewport's lower left corner, rounded to even
  float depth;        ///< window depth, 0 near; beyond 1 behind the far plane
  float inverseW;
  bool needsClip;  ///< before the near plane or outside the guard band
};

}  // namespace limn
