// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Binning/BinClusters.h"

#include "Rendering/Base/Executor.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>

namespace limn {
namespace {

constexpr std::size_t kChunk = 2048;  // clusters per task
// Rounding moves a vertex by less than this (ViewSpace.h: 1/32 pixel, and half a subpixel).
constexpr double kMarginPixels = 0.125;

struct Interval {
  double low, high;
};

/// Range of one row of the matrix over a cluster's box, widened by the rounding of its terms.
Interval rowOverBox(const Mat4d& m, int row, const Cluster& cluster)
{
  const double low[3] = {cluster.low.x, cluster.low.y, cluster.low.z};
  const double high[3] = {cluster.high.x, cluster.high.y, cluster.high.z};
  double centre = m.m[row][3], radius = 0, terms = std::fabs(m.m[row][3]);
  for (int axis = 0; axis < 3; ++axis) {
    const double a = m.m[row][axis];
    const double middle = a * (0.5 * (low[axis] + high[axis]));
    const double half = std::fabs(a * (0.5 * (high[axis] - low[axis])));
    centre += middle;
    radius += half;
    terms += std::fabs(middle) + half;
  }
  radius += 1e-6 * terms;
  return {centre - radius, centre + radius};
}

/// First and one past the last pixel of a range of ndc coordinates, cut to [0, size).
struct PixelRange {
  int first, end;
};
PixelRange pixelRange(Interval c, Interval w, int size)
{
  if (!(w.low > 0)) return {0, size};
  const double low = std::min(c.low / w.low, c.low / w.high);
  const double high = std::max(c.high / w.low, c.high / w.high);
  const double half = 0.5 * size;
  const double first = std::floor(low * half + half - kMarginPixels);
  const double last = std::floor(high * half + half + kMarginPixels);
  const double limit = size;
  return {static_cast<int>(std::clamp(first, 0.0, limit)),
          static_cast<int>(std::clamp(last + 1.0, 0.0, limit))};
}

constexpr TileRectangle kNothing = {std::numeric_limits<int>::max(),
                                    std::numeric_limits<int>::max(), 0, 0};

TileRectangle pixelsOf(const PlacedInstance& placed, const Cluster& cluster, int width, int height)
{
  const Mat4d& m = placed.transform.toClip;
  const Interval z = rowOverBox(m, 2, cluster), w = rowOverBox(m, 3, cluster);
  if (z.high + w.high < 0 || z.low - w.high > 0) return kNothing;
  const PixelRange x = pixelRange(rowOverBox(m, 0, cluster), w, width);
  const PixelRange y = pixelRange(rowOverBox(m, 1, cluster), w, height);
  if (x.first >= x.end || y.first >= y.end) return kNothing;
  return {x.first, y.first, x.end, y.end};
}

TileRectangle united(TileRectangle a, TileRectangle b)
{
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

template <class Visit>
void forEachTile(const TileGrid& grid, const TileRectangle& pixels, Visit visit)
{
  if (pixels.x0 >= pixels.x1) return;
  for (int row = pixels.y0 / kTileSide; row <= (pixels.y1 - 1) / kTileSide; ++row)
    for (int column = pixels.x0 / kTileSide; column <= (pixels.x1 - 1) / kTileSide; ++column)
      visit(grid.index(column, row));
}

}  // namespace

Status binClusters(const PlacedScene& scene, int threads, TileBins& bins)
{
  bins.grid = {scene.width, scene.height};
  const std::size_t tiles = bins.grid.count();
  const std::size_t clusters = scene.clusterCount;
  const std::size_t chunks = (clusters + kChunk - 1) / kChunk;
  const auto forEachCluster = [&](std::size_t chunk, auto visit) {
    const std::size_t end = std::min(clusters, (chunk + 1) * kChunk);
    for (std::size_t c = chunk * kChunk; c < end; ++c)
      visit(static_cast<std::uint32_t>(c));
  };

  std::vector<TileRectangle> pixels(clusters);
  std::vector<TileRectangle> touched(chunks, kNothing);
  const auto counts = std::make_unique<std::atomic<std::uint64_t>[]>(tiles);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    forEachCluster(chunk, [&](std::uint32_t c) {
      const PlacedInstance& placed = scene.instances[scene.instanceOf(c)];
      const Cluster& cluster = placed.mesh().clusters[c - placed.firstCluster];
      pixels[c] = pixelsOf(placed, cluster, scene.width, scene.height);
      touched[chunk] = united(touched[chunk], pixels[c]);
      forEachTile(bins.grid, pixels[c],
                  [&](std::size_t tile) { counts[tile].fetch_add(1, std::memory_order_relaxed); });
    });
  });

  bins.firstEntry.resize(tiles + 1);
  std::uint64_t entries = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    bins.firstEntry[tile] = static_cast<std::uint32_t>(entries);
    entries += counts[tile].exchange(entries, std::memory_order_relaxed);
  }
  if (entries > std::numeric_limits<std::uint32_t>::max())
    return {Error::kTooManyPrimitives,
            "The frame has more than 4294967295 cluster-tile pairs; "
            "draw fewer meshes at once or a smaller image."};
  bins.firstEntry[tiles] = static_cast<std::uint32_t>(entries);

  bins.cluster.resize(entries);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    forEachCluster(chunk, [&](std::uint32_t c) {
      forEachTile(bins.grid, pixels[c], [&](std::size_t tile) {
        bins.cluster[counts[tile].fetch_add(1, std::memory_order_relaxed)] = c;
      });
    });
  });

  bins.touched = kNothing;
  for (const TileRectangle& chunk : touched)
    bins.touched = united(bins.touched, chunk);
  return {};
}

}  // namespace limn
