// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Post/CuePass.h"

#include <array>

namespace limn {

/// The neighbours that eye-dome lighting of one radius looks at.
class EyeDomeTaps {
 public:
  struct Tap {
    int dx, dy;
    float perLength;  ///< 1 / distance, in pixels
  };
  using Ring = std::array<Tap, 8>;

  /// Of a radius in pixels, at least 1.
  explicit EyeDomeTaps(float radius);

  const Ring& fine() const { return rings_[0]; }
  const Ring& coarse(std::size_t i) const { return rings_[1 + i]; }
  static constexpr std::size_t kCoarseRings = 3;

 private:
  std::array<Ring, 1 + kCoarseRings> rings_;
};
/// Farthest neighbour of a radius, in pixels.
int eyeDomeReach(float radius);

/// One row of pixels. The arrays have paddedWidth() values.
struct EyeDomeRow {
  const DistancePlane& distances;
  int y;
  const float* pixel;     ///< ViewPoint::pixel
  const float* strength;  ///< 0: the factor stays
  float* factor;          ///< of the colours
};
void shadeEyeDome(const EyeDomeTaps& taps, const EyeDomeRow& row);

}  // namespace limn
