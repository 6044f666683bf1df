// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/ResolveTile.h"

#include "Rendering/Base/ResolveTable.h"

#include <algorithm>

namespace limn {
namespace {

/// A sum of colours, weighted by counts of samples, and its mean.
class ColorSum {
 public:
  explicit ColorSum(Resolve resolve) : resolve_(resolve) {}

  void add(Rgba8 color, std::uint32_t samples)
  {
    r_ += value(color.r) * samples;
    g_ += value(color.g) * samples;
    b_ += value(color.b) * samples;
    a_ += color.a * samples;
    count_ += samples;
  }
  Rgba8 mean() const { return {byte(r_), byte(g_), byte(b_), linearByte(a_)}; }

 private:
  std::uint32_t value(std::uint8_t byte) const
  {
    return resolve_ == Resolve::kGamma22 ? ResolveTable::gamma22().linear(byte) : byte;
  }
  std::uint8_t byte(std::uint32_t sum) const
  {
    return resolve_ == Resolve::kGamma22 ? ResolveTable::gamma22().byteOfMean(sum, count_)
                                         : linearByte(sum);
  }
  std::uint8_t linearByte(std::uint32_t sum) const
  {
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): every fragment covers a sample
    return static_cast<std::uint8_t>((sum + count_ / 2) / count_);
  }

  Resolve resolve_;
  std::uint32_t r_ = 0, g_ = 0, b_ = 0, a_ = 0, count_ = 0;
};

std::uint32_t bitCount(std::uint8_t bits)
{
  std::uint32_t count = 0;
  for (; bits != 0; bits = static_cast<std::uint8_t>(bits & (bits - 1)))
    ++count;
  return count;
}

struct Nearest {
  float depth;
  std::uint32_t owner;
};

Nearest nearestSample(const TileClusters& clusters, const VisibilityTile& tile, int samples,
                      std::size_t pixel)
{
  Nearest nearest = {0, kNobody};
  for (int s = 0; s < samples; ++s) {
    const std::uint32_t owner = tile.owner[s][pixel];
    if (owner == kNobody) continue;
    const float depth = tile.depth[s][pixel];
    if (nearest.owner == kNobody || depth < nearest.depth ||
        (depth == nearest.depth && clusters.drawnLater(owner, nearest.owner)))
      nearest = {depth, owner};
  }
  return nearest;
}

void writeNames(const TileClusters& clusters, std::uint32_t owner, const FrameView& frame,
                std::ptrdiff_t index)
{
  if (frame.instance == nullptr && frame.cell == nullptr) return;
  const PlacedCluster cluster = clusters.at(TileOwner::slot(owner));
  const Instance& instance = *cluster.placed->instance;
  if (frame.instance != nullptr) frame.instance[index] = instance.id;
  if (frame.cell != nullptr) {
    const std::uint32_t triangle = cluster.meshTriangle(TileOwner::triangle(owner));
    frame.cell[index] =
        instance.attributes.cells.empty() ? triangle : instance.attributes.cells[triangle];
  }
}

/// One sample a pixel: nothing to mix.
void copyTile(const TileClusters& clusters, const VisibilityTile& tile, const TileRectangle& pixels,
              const FragmentList& fragments, const Array<Rgba8>& colors, const FrameView& frame)
{
  const auto indexOf = [&](std::uint32_t pixel) {
    return (pixels.y0 + static_cast<std::ptrdiff_t>(pixel / kTileSide)) * frame.rowStride +
           pixels.x0 + static_cast<std::ptrdiff_t>(pixel % kTileSide);
  };
  for (std::size_t f = 0; f < fragments.count; ++f)
    frame.color[indexOf(fragments.pixel[f])] = colors[f];
  // Where nobody is seen the tile holds the frame's own depth.
  for (int y = pixels.y0; y < pixels.y1; ++y)
    std::copy_n(tile.depth[0] + (y - pixels.y0) * kTileSide, pixels.x1 - pixels.x0,
                frame.depth + y * frame.rowStride + pixels.x0);
  if (frame.coverage != nullptr)
    for (std::size_t f = 0; f < fragments.count; ++f)
      frame.coverage[indexOf(fragments.pixel[f])] = 1;
  if (frame.instance != nullptr || frame.cell != nullptr)
    for (std::size_t f = 0; f < fragments.count; ++f)
      writeNames(clusters, fragments.owner[f], frame, indexOf(fragments.pixel[f]));
}

}  // namespace

void resolveTile(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const Array<Rgba8>& colors, const FrameView& frame)
{
  const Scene& scene = *clusters.scene->scene;
  if (scene.samples == 1) {
    copyTile(clusters, tile, pixels, fragments, colors, frame);
    return;
  }
  const auto samples = static_cast<std::uint32_t>(scene.samples);
  std::size_t next = 0;
  while (next < fragments.count) {
    const std::size_t pixel = fragments.pixel[next];
    const std::ptrdiff_t index =
        (pixels.y0 + static_cast<std::ptrdiff_t>(pixel) / kTileSide) * frame.rowStride + pixels.x0 +
        static_cast<std::ptrdiff_t>(pixel) % kTileSide;
    const Rgba8 firstColor = colors[next];
    ColorSum sum(scene.resolve);
    std::uint32_t covered = 0;
    std::uint8_t coverage = 0;
    const std::size_t first = next;
    for (; next < fragments.count && fragments.pixel[next] == pixel; ++next) {
      const std::uint32_t count = bitCount(fragments.coverage[next]);
      sum.add(colors[next], count);
      covered += count;
      coverage = static_cast<std::uint8_t>(coverage | fragments.coverage[next]);
    }
    if (covered < samples && frame.background == Background::kBlend)
      sum.add(frame.color[index], samples - covered);

    const bool uniform =
        next == first + 1 && (covered == samples || frame.background == Background::kKeepApart);
    frame.color[index] = uniform ? firstColor : sum.mean();
    const Nearest nearest = nearestSample(clusters, tile, scene.samples, pixel);
    frame.depth[index] = nearest.depth;
    if (frame.coverage != nullptr) frame.coverage[index] = coverage;
    writeNames(clusters, nearest.owner, frame, index);
  }
}

}  // namespace limn
