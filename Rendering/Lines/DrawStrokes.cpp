// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/DrawStrokes.h"

#include "Rendering/Lines/HaloCut.h"
#include "Rendering/Lines/LinePlace.h"
#include "Rendering/Lines/StrokeBlend.h"
#include "Rendering/Lines/StrokePieces.h"
#include "Rendering/Lines/TileStroke.h"
#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <optional>

namespace limn {
namespace {

constexpr std::size_t kPiecesPerTask = 1024;
constexpr std::size_t kPointsPerTask = 4096;

/// For each tile the pieces that may cover some of it.
class StrokeBins {
 public:
  StrokeBins(const StrokePlan& plan, const TileGrid& grid, int threads)
      : grid_(grid), first_(grid.count() + 1, 0)
  {
    std::vector<std::atomic<std::uint32_t>> next(grid.count());
    Array<TileRange> ranges(plan.pieces.size());
    parallelForEach(threads, plan.pieces.size(), kPiecesPerTask,
                    [&](std::size_t i) { ranges[i] = rangeOf(plan.pieces[i]); });
    forEachPiece(plan, ranges, threads, [&](std::size_t tile, std::uint32_t) {
      next[tile].fetch_add(1, std::memory_order_relaxed);
    });
    for (std::size_t tile = 0; tile < grid.count(); ++tile) {
      first_[tile + 1] = first_[tile] + next[tile].load();
      next[tile].store(first_[tile]);
    }
    piece_.resize(first_.back());
    forEachPiece(plan, ranges, threads, [&](std::size_t tile, std::uint32_t piece) {
      piece_[next[tile].fetch_add(1, std::memory_order_relaxed)] = piece;
    });
  }

  /// Ascending, whatever thread came first.
  Span<const std::uint32_t> sorted(std::size_t tile)
  {
    std::uint32_t* const begin = piece_.data() + first_[tile];
    std::uint32_t* const end = piece_.data() + first_[tile + 1];
    std::sort(begin, end);
    return {begin, static_cast<std::size_t>(end - begin)};
  }

 private:
  /// Tiles [x0, x1] x [y0, y1] around a piece.
  struct TileRange {
    int x0, y0, x1, y1;
  };
  static double reachOf(const StrokePiece& piece)
  {
    return static_cast<double>(std::max(piece.half0, piece.half1)) + 1.0;
  }
  TileRange rangeOf(const StrokePiece& piece) const
  {
    const double reach = reachOf(piece);
    return {column(std::min(piece.x0, piece.x1) - reach, grid_.columns()),
            column(std::min(piece.y0, piece.y1) - reach, grid_.rows()),
            column(std::max(piece.x0, piece.x1) + reach, grid_.columns()),
            column(std::max(piece.y0, piece.y1) + reach, grid_.rows())};
  }
  template <class Visit>
  void forEachPiece(const StrokePlan& plan, const Array<TileRange>& ranges, int threads,
                    const Visit& visit) const
  {
    parallelForEach(threads, plan.pieces.size(), kPiecesPerTask, [&](std::size_t i) {
      const auto [x0, y0, x1, y1] = ranges[i];
      const bool isLong = x1 > x0 && y1 > y0;
      for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
          if (!isLong || meets(plan.pieces[i], x, y, reachOf(plan.pieces[i])))
            visit(grid_.index(x, y), static_cast<std::uint32_t>(i));
    });
  }
  static int column(double pixel, int count)
  {
    const double tile = std::floor(pixel / kTileSide);
    return static_cast<int>(std::min(std::max(tile, 0.0), count - 1.0));
  }
  /// Whether the line comes near the circle around a tile.
  static bool meets(const StrokePiece& piece, int x, int y, double reach)
  {
    constexpr double kSide = kTileSide, kRadius = 0.75 * kSide;
    const double dx = piece.x1 - piece.x0, dy = piece.y1 - piece.y0;
    const double length = std::sqrt(dx * dx + dy * dy);
    const double distance =
        ((x + 0.5) * kSide - piece.x0) * dy - ((y + 0.5) * kSide - piece.y0) * dx;
    return std::fabs(distance) <= (kRadius + reach) * length;
  }

  TileGrid grid_;
  std::vector<std::uint32_t> first_, piece_;
};

/// A thread's own: each starts out with what its last tile left.
StrokeTile& strokeTile()
{
  thread_local StrokeTile memory;
  return memory;
}

/// The strokes of one tile, group by group.
class TilePainter {
 public:
  TilePainter(const StrokePlan& plan, const FrameView& frame, const HaloCut* cut, int samples,
              TileRectangle tile)
      : plan_(plan), frame_(frame), cut_(cut), samples_(samples), tile_(tile)
  {
    if (!wantsLinePixels(frame)) return;
    thread_local OpenSamples open;
    open_ = &open;
    open_->begin(tile);
  }

  /// Paints the groups that `isWanted` names.
  template <class IsWanted>
  void paint(Span<const std::uint32_t> pieces, const IsWanted& isWanted)
  {
    std::size_t next = 0;
    for (const StrokeGroup& group : plan_.groups) {
      const std::size_t first = next;
      while (next < pieces.size() && pieces[next] < group.endPiece)
        ++next;
      if (next > first && isWanted(group)) paintGroup(group, {pieces.data() + first, next - first});
    }
  }
  /// Appends what goes to FrameView::linePixels.
  void collect(std::vector<LinePixel>& linePixels) const
  {
    if (open_ != nullptr) open_->collect(frame_, samples_, linePixels);
  }

  void setPanes(const TilePanes& panes)
  {
    thread_local std::vector<const TilePanes::Pixel*> ofPixel;
    ofPixel.assign(kTilePixels, nullptr);
    for (const TilePanes::Pixel& one : panes.pixels())
      ofPixel[one.pixel] = &one;
    panes_ = &panes;
    panesOf_ = ofPixel.data();
  }

 private:
  void paintGroup(const StrokeGroup& group, Span<const std::uint32_t> pieces)
  {
    memory_.clear();
    int x0 = kTileSide, y0 = kTileSide, x1 = 0, y1 = 0;
    for (const std::uint32_t piece : pieces) {
      const TileStroke stroke = strokeInTile(plan_.pieces[piece], tile_);
      if (stroke.x0 >= stroke.x1 || stroke.y0 >= stroke.y1) continue;
      memory_.use(stroke.y0, stroke.y1);
      coverStroke(stroke, memory_);
      x0 = std::min(x0, stroke.x0);
      y0 = std::min(y0, stroke.y0);
      x1 = std::max(x1, stroke.x1);
      y1 = std::max(y1, stroke.y1);
    }
    const StrokeBlend blend(group, frame_, cut_, open_, samples_);
    for (int y = y0; y < y1; ++y) {
      forEachCovered(memory_.coverage + y * kTileSide, x0, x1, [&](int x) {
        const float coverage = memory_.coverage[y * kTileSide + x];
        const float depth = memory_.depth[y * kTileSide + x];
        const TilePanes::Pixel* const over =
            panes_ == nullptr ? nullptr : panesOf_[y * kTileSide + x];
        if (over == nullptr)
          blend.blend(tile_.x0 + x, tile_.y0 + y, coverage, depth);
        else
          blend.blend(tile_.x0 + x, tile_.y0 + y, coverage, depth,
                      panes_->before(*over, group.color, depth, group.instance));
      });
    }
  }
  /// Calls visit(x) for the pixels of [x0, x1) of a row that are covered. Most are not.
  template <class Visit>
  static void forEachCovered(const float* row, int x0, int x1, const Visit& visit)
  {
    constexpr int kAtOnce = 4;
    for (int x = x0; x < x1;) {
      std::uint64_t bits[2];
      static_assert(sizeof bits == kAtOnce * sizeof *row);
      if (x + kAtOnce <= x1) {
        std::memcpy(bits, row + x, sizeof bits);
        if ((bits[0] | bits[1]) == 0) {
          x += kAtOnce;
          continue;
        }
      }
      for (const int end = std::min(x + kAtOnce, x1); x < end; ++x)
        if (row[x] > 0) visit(x);
    }
  }

  const StrokePlan& plan_;
  const FrameView& frame_;
  const HaloCut* cut_;
  int samples_;
  TileRectangle tile_;
  StrokeTile& memory_ = strokeTile();
  const TilePanes* panes_ = nullptr;
  const TilePanes::Pixel* const* panesOf_ = nullptr;  ///< by pixel; null of those without
  OpenSamples* open_ = nullptr;
};

/// A box on the screen that grows; everything where something has no place on it.
struct ScreenBox {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  void add(double x, double y, double reach)
  {
    x0 = std::min(x0, x - reach);
    y0 = std::min(y0, y - reach);
    x1 = std::max(x1, x + reach);
    y1 = std::max(y1, y + reach);
  }
  void add(const ScreenBox& other)
  {
    x0 = std::min(x0, other.x0);
    y0 = std::min(y0, other.y0);
    x1 = std::max(x1, other.x1);
    y1 = std::max(y1, other.y1);
  }
};

ScreenBox boxOf(const LineSet& set, const LinePlace& place, int threads)
{
  const std::size_t count = set.vertex.size();
  std::vector<ScreenBox> boxes(stretchCount(count, kPointsPerTask));
  const auto growBox = [&](std::size_t stretch, std::size_t first, std::size_t end) {
    ScreenBox& box = boxes[stretch];
    for (std::size_t i = first; i < end; ++i) {
      LinePoint point;
      if (place.place(set, set.vertex[i], point))
        box.add(point.x, point.y, strokeReach(set.style));
      else
        box.add({-1e300, -1e300, 1e300, 1e300});
    }
  };
  parallelForStretches(threads, count, kPointsPerTask, growBox);
  ScreenBox all;
  for (const ScreenBox& box : boxes)
    all.add(box);
  return all;
}

int pixelOf(double coordinate, int size)
{
  return static_cast<int>(std::min(std::max(coordinate, 0.0), static_cast<double>(size)));
}

}  // namespace

bool hasLines(const Scene& scene)
{
  return std::any_of(scene.instances.begin(), scene.instances.end(),
                     [](const Instance& instance) { return !instance.lines.empty(); });
}

TileRectangle boundStrokes(const Scene& scene, int width, int height, int threads)
{
  ScreenBox box;
  for (const Instance& instance : scene.instances)
    for (const LineSet& set : instance.lines)
      box.add(boxOf(set, LinePlace(scene.camera, instance.modelToWorld, width, height), threads));
  if (box.x0 > box.x1) return {0, 0, 0, 0};
  return {pixelOf(std::floor(box.x0), width), pixelOf(std::floor(box.y0), height),
          pixelOf(std::ceil(box.x1), width), pixelOf(std::ceil(box.y1), height)};
}

void drawStrokes(const StrokePass& pass)
{
  const Scene& scene = pass.scene;
  const FrameView& frame = pass.frame;
  const StrokePlan plan = findStrokePieces(scene, frame, pass.around, pass.threads);
  if (plan.pieces.empty()) return;
  const TileGrid grid = {frame.width, frame.height};
  StrokeBins bins(plan, grid, pass.threads);
  std::optional<HaloCut> cut;
  if (pass.layers != nullptr && !pass.layers->halo.empty()) cut.emplace(scene, *pass.layers);
  std::vector<std::vector<LinePixel>> linePixels(grid.count());
  parallelFor(pass.threads, grid.count(), [&](std::size_t tile) {
    const Span<const std::uint32_t> pieces = bins.sorted(tile);
    if (pieces.empty()) return;
    TilePainter painter(plan, frame, cut ? &*cut : nullptr, scene.samples, grid.rectangle(tile));
    if (pass.panes == nullptr) {
      painter.paint(pieces, [](const StrokeGroup&) { return true; });
    } else {
      painter.setPanes(pass.panes->tile(tile));
      for (const bool isTranslucent : {false, true})
        painter.paint(pieces, [&](const StrokeGroup& group) {
          return scene.instances[group.instance].isTranslucent() == isTranslucent;
        });
    }
    painter.collect(linePixels[tile]);
  });
  if (!wantsLinePixels(frame)) return;
  for (const std::vector<LinePixel>& ofTile : linePixels)
    frame.linePixels->insert(frame.linePixels->end(), ofTile.begin(), ofTile.end());
}

}  // namespace limn
