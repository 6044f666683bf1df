// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Veil.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Lines/PaintLayer.h"
#include "Rendering/Lines/SurfaceLayers.h"

#include <algorithm>

namespace limn {

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

void Veil::lay(const FrameView& frame, int threads) const
{
  parallelFor(threads, tiles_.size(), [&](std::size_t tile) { lay(tiles_[tile], frame); });
}

void Veil::lay(const VeiledTile& all, const FrameView& frame)
{
  const RadianceView& radiance = frame.radiance;
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    const VeiledPixel& veiled = all.pixels[i];
    const std::ptrdiff_t index = veiled.y * frame.rowStride + veiled.x;
    const auto mixed = [&](std::uint8_t seen, std::uint8_t below, std::uint8_t now) {
      return toByte(static_cast<float>(seen) +
                    veiled.rest * (static_cast<float>(now) - static_cast<float>(below)));
    };
    const Rgba8 now = frame.color[index];
    frame.color[index] = {
        mixed(veiled.seen.r, veiled.below.r, now.r), mixed(veiled.seen.g, veiled.below.g, now.g),
        mixed(veiled.seen.b, veiled.below.b, now.b), mixed(veiled.seen.a, veiled.below.a, now.a)};
    if (radiance.empty()) continue;
    const VeiledRadiance& bright = all.radiance[i];
    const auto lay = [&](float& value, float seen, float below) {
      value = boundedRadiance(seen + veiled.rest * (value - below));
    };
    lay(radiance.r[index], bright.seen.x, bright.below.x);
    lay(radiance.g[index], bright.seen.y, bright.below.y);
    lay(radiance.b[index], bright.seen.z, bright.below.z);
  }
}

}  // namespace limn
