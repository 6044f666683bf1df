// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace limn {

inline constexpr int kTileSide = 64;
inline constexpr int kTilePixels = kTileSide * kTileSide;

/// A tile's pixels [x0, x1) x [y0, y1); smaller than kTileSide at the right and upper border.
struct TileRectangle {
  int x0, y0, x1, y1;
};

/// How a viewport, or a part of its apron, is cut into tiles, row by row from the lower left.
struct TileGrid {
  int width, height;   ///< in pixels
  int x0 = 0, y0 = 0;  ///< its lower left pixel

  int columns() const { return (width + kTileSide - 1) / kTileSide; }
  int rows() const { return (height + kTileSide - 1) / kTileSide; }
  std::size_t count() const
  {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }
  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(column);
  }
  TileRectangle rectangle(std::size_t tile) const
  {
    const int x = static_cast<int>(tile % static_cast<std::size_t>(columns())) * kTileSide;
    const int y = static_cast<int>(tile / static_cast<std::size_t>(columns())) * kTileSide;
    return {x0 + x, y0 + y, x0 + std::min(x + kTileSide, width),
            y0 + std::min(y + kTileSide, height)};
  }
};

}  // namespace limn
