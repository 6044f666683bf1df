// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace limn {

/// A pixel near another, and how far away.
struct LensTap {
  int dx, dy;
  float distance;
};

/// The planes that discs are gathered from, of one row stride; the padding has no share.
struct LensPlanes {
  std::ptrdiff_t stride;
  int height;
  const float* depth;
  const float* radius;      ///< of a pixel's disc
  const float* share;       ///< of a pixel's light that each pixel of its disc gets
  const float* channel[4];  ///< red, green, blue, alpha
};

/// Pixels [x0, x1) of row y; their channels go to rows of `out`.
struct LensSegment {
  int y, x0, x1;
  float* out[4];
};

}  // namespace limn
