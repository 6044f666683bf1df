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

/// How a viewport is cut into tiles, row by row from the lower left.
struct TileGrid {
  int width, height;  ///< of the viewport, in pixels

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
    const int x0 = static_cast<int>(tile % static_cast<std::size_t>(columns())) * kTileSide;
    const int y0 = static_cast<int>(tile / static_cast<std::size_t>(columns())) * kTileSide;
    return {x0, y0, std::min(x0 + kTileSide, width), std::min(y0 + kTileSide, height)};
  }
};

}  // namespace limn
