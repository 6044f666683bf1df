// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Panes.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Lines/LinePlace.h"
#include "Rendering/Lines/StrokePieces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace limn {
namespace {

/// Marks the blocks of a frame that strokes and halos may reach.
class ReachMarker {
 public:
  explicit ReachMarker(const TileGrid& grid)
      : grid_(grid),
        columns_(grid.columns() * kPerTile),
        rows_(grid.rows() * kPerTile),
        reached_(grid.count())
  {
  }

  /// A straight stroke, pixels from its middle to where it has none; on any thread.
  void mark(const LinePoint& a, const LinePoint& b, double reach)
  {
    constexpr double kFar = 1e7;  // from here on rounding moves a place by more than it should
    if (std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)}) > kFar) {
      markBox(0, 0, columns_ * kPaneBlockSide, rows_ * kPaneBlockSide);
      return;
    }
    double from = 0, to = 1;
    if (!keepInside(a.x, b.x, columns_ * kPaneBlockSide, reach, from, to) ||
        !keepInside(a.y, b.y, rows_ * kPaneBlockSide, reach, from, to))
      return;
    const auto x = [&](double t) { return a.x + t * (b.x - a.x); };
    const auto y = [&](double t) { return a.y + t * (b.y - a.y); };
    const double length = std::max(std::fabs(x(to) - x(from)), std::fabs(y(to) - y(from)));
    const int pieces = std::max(static_cast<int>(std::ceil(length / kPaneBlockSide)), 1);
    for (int i = 0; i < pieces; ++i) {
      const double s = from + (to - from) * i / pieces, t = from + (to - from) * (i + 1) / pieces;
      markBox(std::min(x(s), x(t)) - reach, std::min(y(s), y(t)) - reach,
              std::max(x(s), x(t)) + reach, std::max(y(s), y(t)) + reach);
    }
  }
  /// Pixels [x0, x1] x [y0, y1] and what lies in between; on any thread.
  void markBox(double x0, double y0, double x1, double y1)
  {
    const int lastColumn = blockOf(x1, columns_), lastRow = blockOf(y1, rows_);
    for (int row = blockOf(y0, rows_); row <= lastRow; ++row)
      for (int column = blockOf(x0, columns_); column <= lastColumn; ++column) {
        const int bit = row % kPerTile * kPerTile + column % kPerTile;
        std::atomic<TileBlocks>& tile = reached_[grid_.index(column / kPerTile, row / kPerTile)];
        const auto mask = static_cast<TileBlocks>(1u << bit);
        if ((tile.load(std::memory_order_relaxed) & mask) == 0)
          tile.fetch_or(mask, std::memory_order_relaxed);
      }
  }
  TileBlocks of(std::size_t tile) const { return reached_[tile].load(std::memory_order_relaxed); }

 private:
  static constexpr int kPerTile = kTileSide / kPaneBlockSide;

  /// Shortens a line to what is less than `reach` outside of [0, size]. False if nothing is.
  static bool keepInside(double a, double b, double size, double reach, double& from, double& to)
  {
    const double change = b - a;
    if (change == 0) return a >= -reach && a <= size + reach;
    const double low = (-reach - a) / change, high = (size + reach - a) / change;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
    return from <= to;
  }
  static int blockOf(double pixel, int count)
  {
    const double block = std::floor(pixel / kPaneBlockSide);
    return static_cast<int>(std::min(std::max(block, 0.0), count - 1.0));
  }

  TileGrid grid_;
  int columns_, rows_;  ///< of blocks
  std::vector<std::atomic<TileBlocks>> reached_;
};

void markStrokes(const Scene& scene, const TileGrid& grid, int threads, ReachMarker& marker)
{
  constexpr std::size_t kChainsPerTask = 64;
  for (const Instance& instance : scene.instances) {
    const LinePlace place(scene.camera, instance.modelToWorld, grid.width, grid.height);
    for (const LineSet& set : instance.lines)
      parallelForEach(threads, set.chainCount(), kChainsPerTask, [&](std::size_t chain) {
        for (std::uint32_t i = set.first[chain]; i + 1 < set.first[chain + 1]; ++i) {
          LinePoint a, b;
          bool clipsStart, clipsEnd;
          if (place.place(set, set.vertex[i], set.vertex[i + 1], a, b, clipsStart, clipsEnd))
            marker.mark(a, b, strokeReach(set.style));
        }
      });
  }
}

/// A depth that nothing with a halo is before.
float nearestHalo(const PlacedScene& scene, const TileBins& bins)
{
  float nearest = std::numeric_limits<float>::infinity();
  for (const PlacedInstance& placed : scene.instances) {
    if (!(haloWidth(*placed.instance) > 0.0f)) continue;
    const std::size_t clusters = placed.mesh().clusters.size();
    for (std::size_t c = placed.firstCluster; c < placed.firstCluster + clusters; ++c)
      if (!bins.bounds[c].empty()) nearest = std::min(nearest, bins.bounds[c].nearest);
  }
  return nearest;
}

/// Around the clusters of what has a halo.
void markHalos(const PlacedScene& scene, const TileBins& bins, int threads, ReachMarker& marker)
{
  constexpr std::size_t kClustersPerTask = 4096;
  for (const PlacedInstance& placed : scene.instances) {
    const float width = haloWidth(*placed.instance);
    if (!(width > 0.0f)) continue;
    const double reach = haloReach(width);
    parallelForEach(threads, placed.mesh().clusters.size(), kClustersPerTask, [&](std::size_t c) {
      const ClusterBounds& box = bins.bounds[placed.firstCluster + c];
      if (!box.empty())
        marker.markBox(box.x0 - reach, box.y0 - reach, box.x1 + reach, box.y1 + reach);
    });
  }
}

}  // namespace

void TilePanes::add(const TileClusters& clusters, int samples,
                    const TranslucentFragments& fragments)
{
  for (const TranslucentFragments::Pixel& touched : fragments.touched()) {
    if (!isIn(reach_.ofLines, touched.pixel) && !isIn(reach_.ofHalos, touched.pixel)) continue;
    const auto lists = static_cast<std::uint32_t>(
        fragments.areSameInAll(touched, static_cast<std::uint32_t>(samples)) ? 1 : samples);
    pixels_.push_back({touched.pixel, static_cast<std::uint32_t>(listEnd_.size()), lists});
    std::size_t next = touched.first;
    for (std::uint32_t list = 0; list < lists; ++list) {
      for (std::uint32_t count = fragments.layers()[next++]; count > 0; --count, ++next) {
        const std::uint32_t fragment = fragments.layers()[next];
        const std::uint32_t slot = TileOwner::slot(fragments.owners()[fragment]);
        const std::ptrdiff_t instance = clusters.at(slot).placed - clusters.scene->instances.data();
        panes_.push_back({fragments.depths()[next], static_cast<std::uint32_t>(instance),
                          fragments.colors()[fragment]});
      }
      listEnd_.push_back(static_cast<std::uint32_t>(panes_.size()));
    }
    if (!isNeeded(pixels_.back())) dropLast();
  }
}

/// Whether a line may be there, or something lies behind what has a halo.
bool TilePanes::isNeeded(const Pixel& pixel) const
{
  if (isIn(reach_.ofLines, pixel.pixel)) return true;
  std::size_t farthest = firstPane(pixel);
  for (std::uint32_t list = 0; list < pixel.lists; ++list) {
    const std::size_t end = listEnd_[pixel.firstList + list];
    if (farthest < end && panes_[farthest].depth >= reach_.nearestHalo) return true;
    farthest = end;
  }
  return false;
}

void TilePanes::dropLast()
{
  const Pixel pixel = pixels_.back();
  panes_.resize(firstPane(pixel));
  listEnd_.resize(pixel.firstList);
  pixels_.pop_back();
}

LineColor TilePanes::before(const Pixel& pixel, Vec3f color, float depth,
                            std::uint32_t instance) const
{
  Vec3f colors = {0, 0, 0}, radiances = {0, 0, 0};
  std::size_t next = firstPane(pixel);
  for (std::uint32_t list = 0; list < pixel.lists; ++list) {
    LineColor seen = {full(color), color};
    for (; next < listEnd_[pixel.firstList + list]; ++next) {
      const Pane& pane = panes_[next];
      if (pane.depth > depth || pane.instance == instance) continue;
      const Vec3f own = {pane.color.x, pane.color.y, pane.color.z};
      const float a = pane.color.w, rest = 1.0f - a;
      seen = {full(own) * a + seen.color * rest, own * a + seen.radiance * rest};
    }
    colors = colors + seen.color;
    radiances = radiances + seen.radiance;
  }
  return meanOf(pixel, {colors, radiances});
}

Panes::Panes(const PlacedScene& scene, const TileBins& bins, int threads)
    : tiles_(bins.grid.count())
{
  ReachMarker ofLines(bins.grid), ofHalos(bins.grid);
  markStrokes(*scene.scene, bins.grid, threads, ofLines);
  markHalos(scene, bins, threads, ofHalos);
  const float nearest = nearestHalo(scene, bins);
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
    tiles_[tile].reach({ofLines.of(tile), ofHalos.of(tile), nearest});
}

bool Panes::areBeforeLines(const Scene& scene, const FrameView& frame)
{
  if (frame.background == Background::kKeepApart) return false;
  const Span<const Instance> all = scene.instances;
  const auto translucent = std::count_if(all.begin(), all.end(),
                                         [](const Instance& one) { return one.isTranslucent(); });
  return std::any_of(all.begin(), all.end(), [&](const Instance& one) {
    return !one.lines.empty() && translucent > (one.isTranslucent() ? 1 : 0);
  });
}

bool Panes::areBehindHalos(const Scene& scene, const FrameView& frame)
{
  if (frame.background == Background::kKeepApart) return false;
  const Span<const Instance> all = scene.instances;
  return std::any_of(all.begin(), all.end(),
                     [](const Instance& one) { return one.isTranslucent(); }) &&
         std::any_of(all.begin(), all.end(),
                     [](const Instance& one) { return haloWidth(one) > 0.0f; });
}

}  // namespace limn
