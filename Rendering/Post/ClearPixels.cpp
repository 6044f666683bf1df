// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/ClearPixels.h"

#include <algorithm>

namespace limn {

void clearPixels(const FrameView& frame, const TileRectangle& pixels)
{
  const std::ptrdiff_t width = pixels.x1 - pixels.x0;
  if (width <= 0) return;
  const auto fill = [&](auto* plane, auto value) {
    if (plane == nullptr) return;
    const auto row = [&](int y) { return plane + y * frame.rowStride + pixels.x0; };
    // Rows are copies of the first: the compiler's own loops do not go by vectors here.
    for (int y = pixels.y0; y < pixels.y1; ++y)
      if (y == pixels.y0)
        std::fill_n(row(y), width, value);
      else
        std::copy_n(row(pixels.y0), width, row(y));
  };
  forEachClearedPlane(frame, fill);
}

}  // namespace limn
