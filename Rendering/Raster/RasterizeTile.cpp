// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Raster/VisibilityTile.h"

#include "Rendering/Raster/EdgeFunction.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Raster/RasterizeTile.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Raster/RasterizeTile-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(rasterizeTileKernel);

bool TileClusters::drawnLater(std::uint32_t fresh, std::uint32_t old) const
{
  if (old == kNobody) return true;
  const PlacedCluster a = at(TileOwner::slot(fresh)), b = at(TileOwner::slot(old));
  if (a.placed != b.placed) return a.placed > b.placed;
  return a.meshTriangle(TileOwner::triangle(fresh)) >= b.meshTriangle(TileOwner::triangle(old));
}

void clearTile(const FrameView& frame, const TileRectangle& pixels, int samples,
               VisibilityTile& tile)
{
  constexpr float kBeforeEverything = -1.0f;
  for (int s = 0; s < samples; ++s) {
    std::fill_n(tile.owner[s], kTilePixels, kNobody);
    if (pixels.x1 - pixels.x0 < kTileSide || pixels.y1 - pixels.y0 < kTileSide)
      std::fill_n(tile.depth[s], kTilePixels, kBeforeEverything);
    for (int y = pixels.y0; y < pixels.y1; ++y)
      std::copy_n(frame.depth + y * frame.rowStride + pixels.x0, pixels.x1 - pixels.x0,
                  tile.depth[s] + (y - pixels.y0) * kTileSide);
  }
}

void rasterizeTile(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                   VisibilityTile& tile)
{
  HWY_DYNAMIC_DISPATCH(rasterizeTileKernel)(clusters, pixels, samples, tile);
}

}  // namespace limn
#endif  // HWY_ONCE
