// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/Lines/StrokePieces.h"

#include <algorithm>

namespace limn {

/// A piece of a stroke as the pixels of one tile see it. A pixel centre (x, y), from the tile's
/// corner, is at d = distance + x normalX + y normalY from the line, and at
/// s = along + x alongX + y alongY from its start.
struct TileStroke {
  float distance, normalX, normalY;
  float along, alongX, alongY;
  float length, inverseLength;  ///< 0 of a point
  float half, halfGrowth;       ///< half the width at the start, and how much it grows to the end
  float startLimit, endLimit;   ///< the coverage ends there: at 0 and length, or far away
  float round0, round1;         ///< 1 where it ends in half a disc, else 0
  float nearest, depthGrowth;   ///< depth as the width
  /// The share of a pixel on one side of a straight line: linear in the distance up to `inner`,
  /// quadratic to `outer`, where the line has left the pixel.
  float inner, outer, linear, quadratic;
  float reach;         ///< pixels farther from the line are not covered
  int x0, y0, x1, y1;  ///< its pixels, from the tile's corner; empty if x0 >= x1 or y0 >= y1
};

/// Coverage and depth of a group in a tile, pixel by pixel.
struct StrokeTile {
  alignas(64) float coverage[kTilePixels];
  alignas(64) float depth[kTilePixels];  ///< the nearest of the pieces that cover something

  /// For the next group: only rows that were used need it.
  void clear()
  {
    const int first = usedY0 * kTileSide, end = std::max(usedY1, usedY0) * kTileSide;
    std::fill(coverage + first, coverage + end, 0.0f);
    std::fill(depth + first, depth + end, kNoDepth);
    usedY0 = kTileSide;
    usedY1 = 0;
  }
  /// Before rows [y0, y1) are written to.
  void use(int y0, int y1)
  {
    usedY0 = std::min(usedY0, y0);
    usedY1 = std::max(usedY1, y1);
  }

 private:
  int usedY0 = 0, usedY1 = kTileSide;  ///< at first everything
};

TileStroke strokeInTile(const StrokePiece& piece, const TileRectangle& tile);
void coverStroke(const TileStroke& stroke, StrokeTile& tile);

}  // namespace limn
