// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Raster/VisibilityTile.h"

#include "Rendering/Raster/EdgeFunction.h"
#include "Rendering/Raster/TranslucentTile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Raster/RasterizeTile.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "Rendering/Raster/RasterizeTile-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(rasterizeTileKernel);
HWY_EXPORT(rasterizeTranslucentKernel);

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
  clearTile({frame.depth + pixels.y0 * frame.rowStride + pixels.x0, frame.rowStride}, pixels,
            samples, tile);
}

void clearTile(const DepthRows& depths, const TileRectangle& pixels, int samples,
               VisibilityTile& tile)
{
  constexpr float kBeforeEverything = -1.0f;
  tile.stale = ~std::uint64_t{0};
  for (int s = 0; s < samples; ++s) {
    static_assert(kNobody == 0xFFFFFFFFu, "bytes of 0xFF");
    std::memset(tile.owner[s], 0xFF, sizeof tile.owner[s]);
    const int width = pixels.x1 - pixels.x0, height = pixels.y1 - pixels.y0;
    for (int y = 0; y < height; ++y) {
      float* const row = tile.depth[s] + y * kTileSide;
      // A fresh tile's depth may lie there already.
      const float* const old = depths.first + y * depths.stride;
      if (old != row) std::copy_n(old, width, row);
      std::fill(row + width, row + kTileSide, kBeforeEverything);
    }
    std::fill(tile.depth[s] + height * kTileSide, tile.depth[s] + kTilePixels, kBeforeEverything);
  }
}

namespace {

/// A counting sort; the order within a bucket is of no account.
template <int kBuckets, class Entry, class Bucket>
void sortByBucket(Span<const std::uint32_t> list, std::vector<TileCluster>& ordered, Entry entry,
                  Bucket bucket)
{
  std::uint32_t next[kBuckets + 1] = {};
  for (const std::uint32_t c : list)
    ++next[bucket(c) + 1];
  std::partial_sum(next, next + kBuckets, next);
  for (const std::uint32_t c : list)
    ordered[next[bucket(c)]++] = entry(c);
}

}  // namespace

std::size_t orderClusters(const PlacedScene& scene, const TileBins& bins, std::size_t tile,
                          std::vector<TileCluster>& ordered)
{
  const Span<const std::uint32_t> list = bins.clustersOf(tile);
  const auto entry = [&](std::uint32_t c) -> TileCluster {
    const PlacedInstance& placed = scene.instances[scene.instanceOf(c)];
    return {{&placed, &placed.mesh().clusters[c - placed.firstCluster]}, bins.bounds[c]};
  };
  ordered.resize(list.size());
  if (!scene.optimizations.occlusionCulling) {
    std::transform(list.begin(), list.end(), ordered.begin(), entry);
  } else {
    constexpr int kBuckets = 256;
    float low = std::numeric_limits<float>::max(), high = -low;
    for (const std::uint32_t c : list) {
      low = std::min(low, bins.bounds[c].nearest);
      high = std::max(high, bins.bounds[c].nearest);
    }
    const float scale = high > low ? (kBuckets - 1) / (high - low) : 0.0f;
    const auto bucket = [&](std::uint32_t c) {
      return static_cast<std::size_t>((bins.bounds[c].nearest - low) * scale);
    };
    if (scene.hasTranslucent) {
      // These behind the others, and the farthest first, as they are blended.
      sortByBucket<2 * kBuckets>(list, ordered, entry, [&](std::uint32_t c) {
        const PlacedInstance& placed = scene.instances[scene.instanceOf(c)];
        return placed.instance->isTranslucent() ? 2 * kBuckets - 1 - bucket(c) : bucket(c);
      });
    } else {
      sortByBucket<kBuckets>(list, ordered, entry, bucket);
    }
  }
  if (!scene.hasTranslucent) return ordered.size();
  const auto isOpaque = [](const TileCluster& cluster) {
    return !cluster.cluster.placed->instance->isTranslucent();
  };
  const auto firstTranslucent = scene.optimizations.occlusionCulling
                                    ? std::partition_point(ordered.begin(), ordered.end(), isOpaque)
                                    : std::partition(ordered.begin(), ordered.end(), isOpaque);
  return static_cast<std::size_t>(firstTranslucent - ordered.begin());
}

std::size_t rasterizeTile(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                          VisibilityTile& tile)
{
  return HWY_DYNAMIC_DISPATCH(rasterizeTileKernel)(clusters, pixels, samples, tile);
}

void rasterizeTranslucent(const TileClusters& clusters, std::size_t firstSlot,
                          const TileRectangle& pixels, TileRows rows, int samples,
                          VisibilityTile& tile, TranslucentTile& translucent)
{
  HWY_DYNAMIC_DISPATCH(rasterizeTranslucentKernel)
  (clusters, firstSlot, pixels, rows, samples, tile, translucent);
}

}  // namespace limn
#endif  // HWY_ONCE
