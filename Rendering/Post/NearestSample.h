// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Raster/VisibilityTile.h"

#include <cstddef>
#include <cstdint>

namespace limn {

struct NearestSample {
  float depth;
  std::uint32_t owner;  ///< kNobody if no sample shows an instance
  int sample;
};

/// The sample of a pixel that is nearest; of equal ones that which is later in draw order, then the
/// first.
inline NearestSample nearestSample(const TileClusters& clusters, const VisibilityTile& tile,
                                   int samples, std::size_t pixel)
{
  NearestSample nearest = {0, kNobody, 0};
  for (int s = 0; s < samples; ++s) {
    const std::uint32_t owner = tile.owner[s][pixel];
    if (owner == kNobody) continue;
    const float depth = tile.depth[s][pixel];
    if (nearest.owner == kNobody || depth < nearest.depth ||
        (depth == nearest.depth && owner != nearest.owner &&
         clusters.drawnLater(owner, nearest.owner)))
      nearest = {depth, owner, s};
  }
  return nearest;
}

}  // namespace limn
