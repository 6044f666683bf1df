// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Binning/BinClusters.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Binning/BoundClusters.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kSmallestChunk = 512, kMostChunks = 256;

constexpr TileRectangle kNothing = {std::numeric_limits<int>::max(),
                                    std::numeric_limits<int>::max(), 0, 0};

TileRectangle united(TileRectangle a, TileRectangle b)
{
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

template <class Visit>
void forEachTileOf(const TileGrid& grid, const ClusterBounds& pixels, Visit visit)
{
  const int x0 = std::max(pixels.x0 - grid.x0, 0), x1 = std::min(pixels.x1 - grid.x0, grid.width);
  const int y0 = std::max(pixels.y0 - grid.y0, 0), y1 = std::min(pixels.y1 - grid.y0, grid.height);
  if (x0 >= x1 || y0 >= y1) return;
  for (int row = y0 / kTileSide; row <= (y1 - 1) / kTileSide; ++row)
    for (int column = x0 / kTileSide; column <= (x1 - 1) / kTileSide; ++column)
      visit(grid.index(column, row));
}

template <class Visit>
void forEachTile(const TileBins& bins, const ClusterBounds& pixels, Visit visit)
{
  if (pixels.empty()) return;
  forEachTileOf(bins.grid, pixels, visit);
  const TileGrid& grid = bins.grid;
  if (pixels.x0 >= 0 && pixels.y0 >= 0 && pixels.x1 <= grid.width && pixels.y1 <= grid.height)
    return;
  std::size_t first = grid.count();
  for (const TileGrid& side : bins.apron) {
    forEachTileOf(side, pixels, [&](std::size_t tile) { visit(first + tile); });
    first += side.count();
  }
}

/// Cuts the viewport into tiles, and its apron. Returns how many there are.
std::size_t cutIntoTiles(const Viewport& viewport, TileBins& bins)
{
  const auto [width, height, apron] = viewport;
  bins.grid = {width, height};
  std::size_t count = bins.grid.count();
  if (apron == 0) return count;
  bins.apron[0] = {width + 2 * apron, apron, -apron, -apron};
  bins.apron[1] = {width + 2 * apron, apron, -apron, height};
  bins.apron[2] = {apron, height, -apron, 0};
  bins.apron[3] = {apron, height, width, 0};
  for (const TileGrid& side : bins.apron)
    count += side.count();
  return count;
}

TileRectangle cut(TileRectangle pixels, const TileGrid& grid)
{
  const TileRectangle inside = {std::max(pixels.x0, 0), std::max(pixels.y0, 0),
                                std::min(pixels.x1, grid.width), std::min(pixels.y1, grid.height)};
  return inside.x0 < inside.x1 && inside.y0 < inside.y1 ? inside : kNothing;
}

/// boundClusters() of the clusters [first, end) of a frame, instance by instance.
void boundRange(const PlacedScene& scene, const std::vector<BoundsTransform>& transforms,
                std::size_t first, std::size_t end, std::vector<ClusterBounds>& bounds)
{
  std::size_t instance = scene.instanceOf(static_cast<std::uint32_t>(first));
  while (first < end) {
    const PlacedInstance& placed = scene.instances[instance];
    const std::size_t local = first - placed.firstCluster;
    const std::size_t count = std::min(end - first, placed.mesh().clusters.size() - local);
    boundClusters(transforms[instance], {placed.mesh().clusters.data() + local, count},
                  scene.viewport, bounds.data() + first);
    first += count;
    ++instance;
  }
}

}  // namespace

Status binClusters(const PlacedScene& scene, int threads, TileBins& bins)
{
  const std::size_t tiles = cutIntoTiles(scene.viewport, bins);
  const std::size_t clusters = scene.clusterCount;
  const std::size_t chunkSize = std::max(kSmallestChunk, clusters / kMostChunks + 1);
  const std::size_t chunks = (clusters + chunkSize - 1) / chunkSize;
  bins.bounds.resize(clusters);
  std::vector<BoundsTransform> transforms;
  for (const PlacedInstance& placed : scene.instances)
    transforms.emplace_back(placed.transform.toClip);

  // First how many clusters of each chunk meet each tile, then the place of the first of them.
  std::vector<std::vector<std::uint32_t>> next(chunks);
  std::vector<TileRectangle> touched(chunks, kNothing);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    const std::size_t first = chunk * chunkSize, end = std::min(clusters, first + chunkSize);
    boundRange(scene, transforms, first, end, bins.bounds);
    next[chunk].assign(tiles, 0);
    for (std::size_t c = first; c < end; ++c) {
      const ClusterBounds& b = bins.bounds[c];
      if (b.empty()) continue;
      touched[chunk] = united(touched[chunk], {b.x0, b.y0, b.x1, b.y1});
      forEachTile(bins, b, [&](std::size_t tile) { ++next[chunk][tile]; });
    }
  });

  bins.firstEntry.resize(tiles + 1);
  std::uint64_t entries = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    bins.firstEntry[tile] = static_cast<std::uint32_t>(entries);
    for (std::vector<std::uint32_t>& chunk : next)
      entries += std::exchange(chunk[tile], static_cast<std::uint32_t>(entries));
  }
  if (entries > std::numeric_limits<std::uint32_t>::max())
    return {Error::kTooManyPrimitives,
            "The frame has more than 4294967295 cluster-tile pairs; "
            "draw fewer meshes at once or a smaller image."};
  bins.firstEntry[tiles] = static_cast<std::uint32_t>(entries);

  bins.cluster.resize(entries);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    const std::size_t first = chunk * chunkSize, end = std::min(clusters, first + chunkSize);
    for (std::size_t c = first; c < end; ++c)
      forEachTile(bins, bins.bounds[c], [&](std::size_t tile) {
        bins.cluster[next[chunk][tile]++] = static_cast<std::uint32_t>(c);
      });
  });

  bins.touchedWithApron = kNothing;
  for (const TileRectangle& chunk : touched)
    bins.touchedWithApron = united(bins.touchedWithApron, chunk);
  bins.touched = cut(bins.touchedWithApron, bins.grid);
  return {};
}

}  // namespace limn
