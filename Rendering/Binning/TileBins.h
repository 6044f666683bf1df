// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"
#include "Rendering/Binning/TileGrid.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Where on the screen a cluster may be: pixels [x0, x1) x [y0, y1) of the viewport and its apron,
/// empty if x0 >= x1, and a depth that none of its samples is before.
struct ClusterBounds {
  std::int16_t x0, y0, x1, y1;
  float nearest;
  /// The box was not cut, and no vertex lies before the near plane.
  bool isWhole;
  // The cluster's own, beside what is read of every cluster of a tile.
  std::uint8_t vertexCount, triangleCount;
  std::uint32_t firstVertex, firstTriangle;

  bool empty() const { return x0 >= x1; }
};

/// For each tile the clusters that may touch it, as numbers of a PlacedScene, ascending.
struct TileBins {
  TileGrid grid;
  /// Below, above, to the left and to the right of the viewport. Their tiles are numbered on from
  /// the viewport's.
  TileGrid apron[4] = {};
  std::vector<std::uint32_t> firstEntry;  ///< per tile, and one more: the end
  std::vector<std::uint32_t> cluster;
  std::vector<ClusterBounds> bounds;  ///< per cluster of the PlacedScene
  TileRectangle touched;              ///< pixels outside show nothing; empty if x0 >= x1
  TileRectangle touchedWithApron;     ///< likewise

  std::size_t count() const { return firstEntry.size() - 1; }
  TileRectangle rectangle(std::size_t tile) const
  {
    if (tile < grid.count()) return grid.rectangle(tile);
    tile -= grid.count();
    const TileGrid* side = apron;
    for (; tile >= side->count(); ++side)
      tile -= side->count();
    return side->rectangle(tile);
  }
  Span<const std::uint32_t> clustersOf(std::size_t tile) const
  {
    return {cluster.data() + firstEntry[tile], firstEntry[tile + 1] - firstEntry[tile]};
  }
};

}  // namespace limn
