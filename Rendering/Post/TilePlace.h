// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"

#include <cstddef>

namespace limn {

/// Where a tile's pixels lie in the frame.
class TilePlace {
 public:
  TilePlace(const TileRectangle& pixels, const FrameView& frame)
      : first_(pixels.y0 * frame.rowStride + pixels.x0), rowStride_(frame.rowStride)
  {
  }
  /// Whether indexOf() is the pixel's own number, as of a TileFrame.
  bool isWholeTile() const { return first_ == 0 && rowStride_ == kTileSide; }
  std::ptrdiff_t indexOf(std::size_t pixel) const
  {
    return first_ + static_cast<std::ptrdiff_t>(pixel / kTileSide) * rowStride_ +
           static_cast<std::ptrdiff_t>(pixel % kTileSide);
  }

 private:
  std::ptrdiff_t first_, rowStride_;
};

}  // namespace limn
