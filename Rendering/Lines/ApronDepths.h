// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/FrameView.h"

#include <cstddef>

namespace limn {

/// Depths of the pixels around a frame, as FrameView::depth has them of those in it: of its opaque
/// surfaces, or of what was there before. Kept from frame to frame for their memory.
class ApronDepths {
 public:
  /// Sets `apron` pixels on all sides to what the frame holds at its border, or will be cleared to.
  void begin(const FrameView& frame, int apron);

  int apron() const { return apron_; }
  /// Of a pixel outside of the frame. Those to the right of it in the apron, below, above or on
  /// one side of the frame, follow; those above them come after strideAt().
  float* at(int x, int y) { return depth_.data() + indexOf(x, y); }
  const float* at(int x, int y) const { return depth_.data() + indexOf(x, y); }
  std::ptrdiff_t strideAt(int y) const { return isBeside(y) ? 2 * apron_ : width_ + 2 * apron_; }

 private:
  /// Whether the frame has this row of pixels.
  bool isBeside(int y) const { return y >= 0 && y < height_; }
  /// Rows from below, without what the frame has of them.
  std::ptrdiff_t indexOf(int x, int y) const
  {
    const std::ptrdiff_t whole = width_ + 2 * apron_, beside = 2 * apron_;
    if (y < 0) return (y + apron_) * whole + (x + apron_);
    if (y < height_) return apron_ * whole + y * beside + (x < 0 ? x : x - width_) + apron_;
    return apron_ * whole + height_ * beside + (y - height_) * whole + (x + apron_);
  }

  int width_ = 0, height_ = 0;  ///< of the frame
  int apron_ = 0;
  Array<float> depth_;
};

}  // namespace limn
