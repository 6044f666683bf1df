// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ApronDepths.h"

#include <algorithm>

namespace limn {

void ApronDepths::begin(const FrameView& frame, int apron)
{
  width_ = frame.width;
  height_ = frame.height;
  apron_ = apron;
  if (apron == 0) return;
  depth_.resize(static_cast<std::size_t>(indexOf(-apron, height_ + apron)));
  if (frame.clear.extent != FrameClear::Extent::kNothing) {
    std::fill(depth_.begin(), depth_.end(), frame.clear.depth);
    return;
  }
  for (int y = -apron; y < height_ + apron; ++y) {
    const float* const row = frame.depth + std::min(std::max(y, 0), height_ - 1) * frame.rowStride;
    std::fill_n(at(-apron, y), apron, row[0]);
    if (!isBeside(y)) std::copy_n(row, width_, at(0, y));
    std::fill_n(at(width_, y), apron, row[width_ - 1]);
  }
}

}  // namespace limn
