// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/FrameView.h"
#include "Rendering/PostEffects.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// A plane of floats whose rows have room at both ends, so that kernels read past them.
class PaddedPlane {
 public:
  /// Floats before a row's first and after its last: the largest blur, and a vector more.
  static constexpr int kPad = kMaxBlurRadius + 1 + 16;

  /// Leaves the values unset where the size changes.
  void resize(int width, int height)
  {
    width_ = width;
    height_ = height;
    constexpr int kVector = 16;
    stride_ = (width + kVector - 1) / kVector * kVector + 2 * kPad;
    values_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height));
  }
  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  float* row(int y) { return values_.data() + static_cast<std::ptrdiff_t>(y) * stride_ + kPad; }
  const float* row(int y) const { return const_cast<PaddedPlane*>(this)->row(y); }
  /// Sets what lies beyond the ends of a row.
  void padRow(int y, float left, float right)
  {
    std::fill_n(this->row(y) - kPad, kPad, left);
    std::fill_n(this->row(y) + width_, stride_ - kPad - width_, right);
  }
  std::size_t bytes() const { return values_.capacity() * sizeof(float); }

 private:
  Array<float> values_;
  int width_ = 0, height_ = 0;
  std::ptrdiff_t stride_ = 0;
};

/// One plane for each of red, green and blue.
using ColorPlanes = std::array<PaddedPlane, 3>;

/// The memory of a chain of post effects, and the radiance that the pictures are drawn to. To be
/// kept from frame to frame: then a frame of the same size and effects allocates nothing.
class EffectPlanes {
 public:
  /// Planes for FrameView::radiance with what `color` holds, of width x height pixels, row by row:
  /// to be asked for before a frame is drawn. Stays valid until the next call.
  RadianceView radianceOf(const FrameView& frame, int threads);

  std::size_t bytes() const;

  // For the stages.
  ColorPlanes image, blurred;  ///< before and after the lens
  PaddedPlane alpha, blurredAlpha;
  PaddedPlane depth, radius, share;  ///< of the lens: see LensPlanes
  std::vector<float> largestRadius;  ///< likewise, by tile
  std::vector<ColorPlanes> pyramid;  ///< of light that spills over: level 0 has the frame's size
  PaddedPlane blank;                 ///< a row of zeros
  Array<Rgba8> jagged;               ///< the picture before FXAA
  PaddedPlane luma;

 private:
  Array<float> radiance_;
};

}  // namespace limn
