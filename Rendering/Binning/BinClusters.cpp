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
void forEachTile(const TileGrid& grid, const ClusterBounds& pixels, Visit visit)
{
  if (pixels.empty()) return;
  for (int row = pixels.y0 / kTileSide; row <= (pixels.y1 - 1) / kTileSide; ++row)
    for (int column = pixels.x0 / kTileSide; column <= (pixels.x1 - 1) / kTileSide; ++column)
      visit(grid.index(column, row));
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
    boundClusters(transforms[instance], {placed.mesh().clusters.data() + local, count}, scene.width,
                  scene.height, bounds.data() + first);
    first += count;
    ++instance;
  }
}

}  // namespace

Status binClusters(const PlacedScene& scene, int threads, TileBins& bins)
{
  bins.grid = {scene.width, scene.height};
  const std::size_t tiles = bins.grid.count();
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
      forEachTile(bins.grid, b, [&](std::size_t tile) { ++next[chunk][tile]; });
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
      forEachTile(bins.grid, bins.bounds[c], [&](std::size_t tile) {
        bins.cluster[next[chunk][tile]++] = static_cast<std::uint32_t>(c);
      });
  });

  bins.touched = kNothing;
  for (const TileRectangle& chunk : touched)
    bins.touched = united(bins.touched, chunk);
  return {};
}

}  // namespace limn
