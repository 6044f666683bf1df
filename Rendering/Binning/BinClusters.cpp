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
// Of a sample's depth, by the divide, the viewport, the depth plane and the sum over it: some units
// of 2^-24 each.
constexpr double kDepthRounding = 4e-6;

struct Interval {
  double low, high;
  double rounding;  ///< of a sum of its terms in float, by far; included in low and high
};

/// Range of one row of the matrix over a cluster's box.
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
  return {centre - radius, centre + radius, 1e-6 * terms};
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

/// What bounds need of an instance. Depth is z/w = slope + rest/w, where the slope takes out of z
/// all that is proportional to w: in a perspective nearly all, so that the bound is tight.
struct BoundsTransform {
  Mat4d toClip;  ///< row 2 is the rest
  double slope;

  explicit BoundsTransform(const Mat4d& m) : toClip(m), slope(0)
  {
    const double* z = m.m[2];
    const double* w = m.m[3];
    const double square = (w[0] * w[0] + w[1] * w[1]) + w[2] * w[2];
    if (!(square > 0)) return;
    slope = ((z[0] * w[0] + z[1] * w[1]) + z[2] * w[2]) / square;
    for (int column = 0; column < 4; ++column)
      toClip.m[2][column] = z[column] - slope * w[column];
  }
};

constexpr TileRectangle kNothing = {std::numeric_limits<int>::max(),
                                    std::numeric_limits<int>::max(), 0, 0};
constexpr ClusterBounds kNowhere = {0, 0, 0, 0, 0};

ClusterBounds boundsOf(const BoundsTransform& transform, const Cluster& cluster, int width,
                       int height)
{
  const Interval rest = rowOverBox(transform.toClip, 2, cluster);
  const Interval w = rowOverBox(transform.toClip, 3, cluster);
  float nearest = 0;
  if (w.low > 0) {
    const double low = transform.slope + std::min(rest.low / w.low, rest.low / w.high);
    const double high = transform.slope + std::max(rest.high / w.low, rest.high / w.high);
    if (high < -1 || low > 1) return kNowhere;
    // z is summed up in float from all its terms, not only from the rest.
    const double rounding =
        ((1 + std::fabs(transform.slope)) * w.rounding + rest.rounding) / w.low +
        kDepthRounding * (1 + std::max(std::fabs(low), std::fabs(high)));
    nearest = static_cast<float>(low * 0.5 + 0.5 - rounding);
  } else if (w.high < 0) {
    return kNowhere;
  }
  const PixelRange x = pixelRange(rowOverBox(transform.toClip, 0, cluster), w, width);
  const PixelRange y = pixelRange(rowOverBox(transform.toClip, 1, cluster), w, height);
  if (x.first >= x.end || y.first >= y.end) return kNowhere;
  return {static_cast<std::int16_t>(x.first), static_cast<std::int16_t>(y.first),
          static_cast<std::int16_t>(x.end), static_cast<std::int16_t>(y.end), nearest};
}

TileRectangle united(TileRectangle a, const ClusterBounds& b)
{
  if (b.empty()) return a;
  return {std::min<int>(a.x0, b.x0), std::min<int>(a.y0, b.y0), std::max<int>(a.x1, b.x1),
          std::max<int>(a.y1, b.y1)};
}
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

  bins.bounds.resize(clusters);
  std::vector<BoundsTransform> transforms;
  for (const PlacedInstance& placed : scene.instances)
    transforms.emplace_back(placed.transform.toClip);
  std::vector<TileRectangle> touched(chunks, kNothing);
  const auto counts = std::make_unique<std::atomic<std::uint64_t>[]>(tiles);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    forEachCluster(chunk, [&](std::uint32_t c) {
      const std::uint32_t instance = scene.instanceOf(c);
      const PlacedInstance& placed = scene.instances[instance];
      const Cluster& cluster = placed.mesh().clusters[c - placed.firstCluster];
      bins.bounds[c] = boundsOf(transforms[instance], cluster, scene.width, scene.height);
      touched[chunk] = united(touched[chunk], bins.bounds[c]);
      forEachTile(bins.grid, bins.bounds[c],
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
      forEachTile(bins.grid, bins.bounds[c], [&](std::size_t tile) {
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
