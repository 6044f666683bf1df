// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"
#include "Rendering/Binning/TileGrid.h"

#include <cstdint>
#include <vector>

namespace limn {

/// For each tile the clusters that may touch it, as numbers of a PlacedScene, in any order: the
/// picture does not depend on it.
struct TileBins {
  TileGrid grid;
  std::vector<std::uint32_t> firstEntry;  ///< per tile, and one more: the end
  std::vector<std::uint32_t> cluster;
  TileRectangle touched;  ///< pixels outside show nothing; empty if x0 >= x1

  Span<const std::uint32_t> clustersOf(std::size_t tile) const
  {
    return {cluster.data() + firstEntry[tile], firstEntry[tile + 1] - firstEntry[tile]};
  }
};

}  // namespace limn
