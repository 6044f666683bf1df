// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Veil.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Lines/PaintLayer.h"
#include "Rendering/Lines/SurfaceLayers.h"

#include <algorithm>

namespace limn {
namespace {

void addHalosOfTile(const HaloCut& cut, const TileRectangle& tile, TilePanes& panes,
                    VeiledTile& veiled)
{
  std::size_t next = 0;
  for (const TilePanes::Pixel& pixel : panes.pixels()) {
    const int x = tile.x0 + static_cast<int>(pixel.pixel % kTileSide);
    const int y = tile.y0 + static_cast<int>(pixel.pixel / kTileSide);
    if (!cut.isAny(x, y)) continue;
    while (veiled.pixels[next].x != x || veiled.pixels[next].y != y)
      ++next;
    const LineColor change = panes.colorByHalos(pixel, [&](float depth, std::uint32_t instance) {
      return cut.overPane(x, y, depth, instance);
    });
    veiled.changes.push_back({next, change});
  }
}

}  // namespace

bool Veil::isNeeded(const Scene& scene, const FrameView& frame)
{
  if (frame.background == Background::kKeepApart) return false;
  const auto isAny = [&](auto&& holds) {
    return std::any_of(scene.instances.begin(), scene.instances.end(), holds);
  };
  return isAny([](const Instance& one) { return one.isTranslucent(); }) &&
         isAny([](const Instance& one) {
           return !one.isTranslucent() && (hasImageOutline(one) || hasCues(one));
         });
}

void Veil::addHalos(const Scene& scene, const SurfaceLayers& layers, const TileGrid& grid,
                    Panes& panes, int threads)
{
  const HaloCut cut(scene, layers);
  parallelFor(threads, tiles_.size(), [&](std::size_t tile) {
    addHalosOfTile(cut, grid.rectangle(tile), panes.tile(tile), tiles_[tile]);
  });
}

void Veil::lay(const FrameView& frame, int threads) const
{
  parallelFor(threads, tiles_.size(), [&](std::size_t tile) { lay(tiles_[tile], frame); });
}

void Veil::lay(const VeiledTile& all, const FrameView& frame)
{
  const RadianceView& radiance = frame.radiance;
  auto halo = all.changes.begin();
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    const VeiledPixel& veiled = all.pixels[i];
    const std::ptrdiff_t index = veiled.y * frame.rowStride + veiled.x;
    LineColor change = {{0, 0, 0}, {0, 0, 0}};
    if (halo != all.changes.end() && halo->pixel == i) change = (halo++)->change;
    const auto mixed = [&](std::uint8_t seen, float more, std::uint8_t below, std::uint8_t now) {
      return toByte(static_cast<float>(seen) + more * 255.0f +
                    veiled.rest * (static_cast<float>(now) - static_cast<float>(below)));
    };
    const Rgba8 now = frame.color[index];
    frame.color[index] = {mixed(veiled.seen.r, change.color.x, veiled.below.r, now.r),
                          mixed(veiled.seen.g, change.color.y, veiled.below.g, now.g),
                          mixed(veiled.seen.b, change.color.z, veiled.below.b, now.b),
                          mixed(veiled.seen.a, 0, veiled.below.a, now.a)};
    if (radiance.empty()) continue;
    const VeiledRadiance& bright = all.radiance[i];
    const auto lay = [&](float& value, float seen, float more, float below) {
      value = boundedRadiance(seen + more + veiled.rest * (value - below));
    };
    lay(radiance.r[index], bright.seen.x, change.radiance.x, bright.below.x);
    lay(radiance.g[index], bright.seen.y, change.radiance.y, bright.below.y);
    lay(radiance.b[index], bright.seen.z, change.radiance.z, bright.below.z);
  }
}

}  // namespace limn
