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

std::uint8_t RestOfPixel::of(std::uint8_t pixel, std::uint8_t own) const
{
  const int rest = shared - count;
  if (resolve == Resolve::kLinear)
    return toByte(static_cast<float>(pixel * shared - own * count) / static_cast<float>(rest));
  const ResolveTable& table = ResolveTable::gamma22();
  const double sum = static_cast<double>(table.linear(pixel)) * shared -
                     static_cast<double>(table.linear(own)) * count;
  const double most = static_cast<double>(table.linear(255)) * rest;
  return table.byteOfMean(static_cast<std::uint32_t>(sum > 0 ? (sum < most ? sum : most) : 0),
                          static_cast<std::uint32_t>(rest));
}

float RestOfPixel::ofRadiance(float pixel, float own) const
{
  const float sum = pixel * static_cast<float>(shared) - own * static_cast<float>(count);
  return (sum > 0.0f ? sum : 0.0f) / static_cast<float>(shared - count);
}

namespace {

/// Samples of a pixel to be painted with a style's line, and what they have now.
struct Strip {
  std::ptrdiff_t place;  ///< in the frame
  const Style& style;
  Rgba8 color;
  Vec3f radiance;
  float share;
  int shared;
};

void paintStrip(const OutlinePass& pass, const Strip& strip)
{
  const float opacity = strip.style.outlineOpacity;
  const Vec3f line = strip.style.outlineColor;
  const Resolve resolve = pass.scene.resolve;
  const double samples = static_cast<double>(strip.share) * pass.scene.samples;
  const auto paint = [&](std::uint8_t& pixel, std::uint8_t own, float to) {
    const float from = static_cast<float>(own);
    pixel = changed({pixel, own, toByte(from + (to * 255.0f - from) * opacity)}, samples,
                    strip.shared, resolve);
  };
  Rgba8& pixel = pass.frame.color[strip.place];
  paint(pixel.r, strip.color.r, line.x);
  paint(pixel.g, strip.color.g, line.y);
  paint(pixel.b, strip.color.b, line.z);
  const RadianceView& radiance = pass.frame.radiance;
  if (radiance.empty()) return;
  const float part = strip.share * static_cast<float>(pass.scene.samples) * opacity /
                     static_cast<float>(strip.shared);
  const auto add = [&](float& value, float to, float from) {
    value = boundedRadiance(value + (to - from) * part);
  };
  add(radiance.r[strip.place], line.x, strip.radiance.x);
  add(radiance.g[strip.place], line.y, strip.radiance.y);
  add(radiance.b[strip.place], line.z, strip.radiance.z);
}

}  // namespace

void paintLine(const OutlinePass& pass, int x, int y, float share)
{
  const SurfaceLayers& layers = pass.layers;
  const std::size_t index = layers.indexOf(x, y);
  paintStrip(
      pass, {y * pass.frame.rowStride + x, pass.scene.instances[layers.instance[index]].style,
             layers.color[index], layers.radiance.empty() ? Vec3f{0, 0, 0} : layers.radiance[index],
             share, layers.shared[index]});
}

void paintLineBehind(const OutlinePass& pass, int x, int y, float share)
{
  const SurfaceLayers& layers = pass.layers;
  const std::size_t index = layers.indexOf(x, y);
  const std::ptrdiff_t place = y * pass.frame.rowStride + x;
  const RestOfPixel rest = {layers.count[index], layers.shared[index], pass.scene.resolve};
  const Rgba8 pixel = pass.frame.color[place], own = layers.color[index];
  const Rgba8 color = {rest.of(pixel.r, own.r), rest.of(pixel.g, own.g), rest.of(pixel.b, own.b),
                       255};
  Vec3f radiance = {0, 0, 0};
  if (const RadianceView& all = pass.frame.radiance; !all.empty()) {
    const Vec3f of = layers.radiance[index];
    radiance = {rest.ofRadiance(all.r[place], of.x), rest.ofRadiance(all.g[place], of.y),
                rest.ofRadiance(all.b[place], of.z)};
  }
  paintStrip(pass, {place, pass.scene.instances[layers.other[index]].style, color, radiance, share,
                    rest.shared});
}

}  // namespace limn
