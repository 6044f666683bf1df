// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/PaintLayer.h"

#include "Rendering/Base/ResolveTable.h"

#include <cmath>

namespace limn {
std::uint8_t changed(ChannelChange c, double samples, int shared, Resolve resolve)
{
  if (resolve == Resolve::kLinear)
    return toByte(static_cast<float>(c.pixel + samples * (c.to - c.from) / shared));
  const ResolveTable& table = ResolveTable::gamma22();
  const double difference =
      static_cast<double>(table.linear(c.to)) - static_cast<double>(table.linear(c.from));
  const double sum =
      static_cast<double>(table.linear(c.pixel)) * shared + std::nearbyint(samples * difference);
  const double most = static_cast<double>(table.linear(255)) * shared;
  const double bounded = sum > 0 ? (sum < most ? sum : most) : 0;
  return table.byteOfMean(static_cast<std::uint32_t>(bounded), static_cast<std::uint32_t>(shared));
}

void paintLine(const OutlinePass& pass, int x, int y, float share)
{
  const std::size_t index = pass.layers.indexOf(x, y);
  const Rgba8 color = pass.layers.color[index];
  const int shared = pass.layers.shared[index];
  const Style& style = pass.scene.instances[pass.layers.instance[index]].style;
  const float opacity = style.outlineOpacity;
  const auto over = [&](std::uint8_t own, float line) {
    const float from = static_cast<float>(own);
    return toByte(from + (line * 255.0f - from) * opacity);
  };
  const std::ptrdiff_t place = y * pass.frame.rowStride + x;
  const Resolve resolve = pass.scene.resolve;
  const double samples = static_cast<double>(share) * pass.scene.samples;
  const auto paint = [&](std::uint8_t& pixel, std::uint8_t own, float line) {
    pixel = changed({pixel, own, over(own, line)}, samples, shared, resolve);
  };
  Rgba8& pixel = pass.frame.color[place];
  paint(pixel.r, color.r, style.outlineColor.x);
  paint(pixel.g, color.g, style.outlineColor.y);
  paint(pixel.b, color.b, style.outlineColor.z);
  const RadianceView& radiance = pass.frame.radiance;
  if (radiance.empty()) return;
  const Vec3f own = pass.layers.radiance[index];
  const float part =
      share * static_cast<float>(pass.scene.samples) * opacity / static_cast<float>(shared);
  radiance.r[place] = boundedRadiance(radiance.r[place] + (style.outlineColor.x - own.x) * part);
  radiance.g[place] = boundedRadiance(radiance.g[place] + (style.outlineColor.y - own.y) * part);
  radiance.b[place] = boundedRadiance(radiance.b[place] + (style.outlineColor.z - own.z) * part);
}

}  // namespace limn
