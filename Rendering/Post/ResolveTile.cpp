// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/ResolveTile.h"

#include "Rendering/Base/BitCount.h"
#include "Rendering/Post/ColorSum.h"
#include "Rendering/Post/NearestSample.h"
#include "Rendering/Post/TilePlace.h"

#include <algorithm>

namespace limn {
namespace {

void writeNames(const TileClusters& clusters, std::uint32_t owner, const FrameView& frame,
                std::ptrdiff_t index, std::size_t count)
{
  if (frame.instance == nullptr && frame.cell == nullptr) return;
  const PlacedCluster cluster = clusters.at(TileOwner::slot(owner));
  const Instance& instance = *cluster.placed->instance;
  if (frame.instance != nullptr) std::fill_n(frame.instance + index, count, instance.id);
  if (frame.cell != nullptr) {
    const std::uint32_t triangle = cluster.meshTriangle(TileOwner::triangle(owner));
    std::fill_n(frame.cell + index, count,
                instance.attributes.cells.empty() ? triangle : instance.attributes.cells[triangle]);
  }
}

/// Of one sample a pixel. Where nobody is seen the tile holds the frame's own depth.
void copyDepth(const VisibilityTile& tile, const TileRectangle& pixels, const FrameView& frame)
{
  if (frame.depth == tile.depth[0]) return;
  for (int y = pixels.y0; y < pixels.y1; ++y)
    std::copy_n(tile.depth[0] + (y - pixels.y0) * kTileSide, pixels.x1 - pixels.x0,
                frame.depth + y * frame.rowStride + pixels.x0);
}

/// All of a run's samples show one triangle, so nothing is mixed.
void copyRuns(const TileClusters& clusters, const VisibilityTile& tile, const TilePlace& place,
              const FragmentList& fragments, const TileColors& colors, const FrameView& frame)
{
  const int samples = clusters.scene->scene->samples;
  const auto allSamples = static_cast<std::uint8_t>((1u << samples) - 1u);
  for (std::size_t r = 0; r < fragments.runCount; ++r) {
    const FragmentRun& run = fragments.run[r];
    if (run.length == 0) continue;
    const std::ptrdiff_t index = place.indexOf(run.pixel);
    if (colors.pixel != frame.color)
      std::copy_n(colors.pixel + run.pixel, run.length, frame.color + index);
    for (int i = 0; samples > 1 && i < run.length; ++i) {
      float nearest = tile.depth[0][run.pixel + i];
      for (int s = 1; s < samples; ++s)
        nearest = std::min(nearest, tile.depth[s][run.pixel + i]);
      frame.depth[index + i] = nearest;
    }
    if (frame.coverage != nullptr) std::fill_n(frame.coverage + index, run.length, allSamples);
    writeNames(clusters, tile.owner[0][run.pixel], frame, index, run.length);
  }
}

/// Fragments of pixels with one sample.
void copyFragments(const TileClusters& clusters, const TilePlace& place,
                   const FragmentList& fragments, const TileColors& colors, const FrameView& frame)
{
  if (place.isWholeTile())
    for (std::size_t f = 0; f < fragments.count; ++f)
      frame.color[fragments.pixel[f]] = colors.fragment[f];
  else
    for (std::size_t f = 0; f < fragments.count; ++f)
      frame.color[place.indexOf(fragments.pixel[f])] = colors.fragment[f];
  for (std::size_t f = 0; frame.coverage != nullptr && f < fragments.count; ++f)
    frame.coverage[place.indexOf(fragments.pixel[f])] = 1;
  if (frame.instance == nullptr && frame.cell == nullptr) return;
  for (std::size_t f = 0; f < fragments.count; ++f)
    writeNames(clusters, fragments.owner[f], frame, place.indexOf(fragments.pixel[f]), 1);
}

/// Fragments of pixels with several samples.
void mixFragments(const TileClusters& clusters, const VisibilityTile& tile, const TilePlace& place,
                  const FragmentList& fragments, const TileColors& colors, const FrameView& frame)
{
  const Scene& scene = *clusters.scene->scene;
  const auto samples = static_cast<std::uint32_t>(scene.samples);
  std::size_t next = 0;
  while (next < fragments.count) {
    const std::size_t pixel = fragments.pixel[next];
    const std::ptrdiff_t index = place.indexOf(pixel);
    const Rgba8 firstColor = colors.fragment[next];
    ColorSum sum(scene.resolve);
    std::uint32_t covered = 0;
    std::uint32_t coverage = 0;
    const std::size_t first = next;
    for (; next < fragments.count && fragments.pixel[next] == pixel; ++next) {
      const std::uint32_t count = bitCount(fragments.coverage[next]);
      sum.add(colors.fragment[next], count);
      covered += count;
      coverage |= fragments.coverage[next];
    }
    if (covered < samples && frame.background == Background::kBlend)
      sum.add(frame.color[index], samples - covered);

    const bool uniform =
        next == first + 1 && (covered == samples || frame.background == Background::kKeepApart);
    frame.color[index] = uniform ? firstColor : sum.mean();
    const NearestSample nearest = nearestSample(clusters, tile, scene.samples, pixel);
    frame.depth[index] = nearest.depth;
    if (frame.coverage != nullptr) frame.coverage[index] = static_cast<std::uint8_t>(coverage);
    writeNames(clusters, nearest.owner, frame, index, 1);
  }
}

}  // namespace

void resolveTile(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const TileColors& colors, const FrameView& frame)
{
  const TilePlace place(pixels, frame);
  copyRuns(clusters, tile, place, fragments, colors, frame);
  if (clusters.scene->scene->samples == 1) {
    copyDepth(tile, pixels, frame);
    copyFragments(clusters, place, fragments, colors, frame);
  } else {
    mixFragments(clusters, tile, place, fragments, colors, frame);
  }
}

}  // namespace limn
