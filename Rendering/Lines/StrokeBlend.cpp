// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/StrokeBlend.h"

#include "Rendering/Base/BitCount.h"
#include "Rendering/Base/FullIntensity.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

float mixed(float old, float line, float a)
{
  return old + (line - old) * a;
}

std::uint8_t roundedByte(float value)
{
  return static_cast<std::uint8_t>(std::floor(value + 0.5f));
}

std::uint8_t mixedByte(std::uint8_t old, float line, float a)
{
  return roundedByte(mixed(old, line, a));
}

}  // namespace

void OpenSamples::begin(const TileRectangle& tile)
{
  constexpr Pixel kClear = {{0, 0, 0, 0}, 1};
  pixels_.resize(kTilePixels, kClear);
  for (int y = used_.y0; y < used_.y1; ++y)
    std::fill_n(pixels_.begin() + static_cast<std::ptrdiff_t>(indexOf(used_.x0, y)),
                used_.x1 - used_.x0, kClear);
  tile_ = tile;
  used_ = {tile.x1, tile.y1, tile.x0, tile.y0};
}

void OpenSamples::add(int x, int y, Vec4f line, float share, float depth)
{
  used_ = {std::min(used_.x0, x), std::min(used_.y0, y), std::max(used_.x1, x + 1),
           std::max(used_.y1, y + 1)};
  Pixel& pixel = pixels_[indexOf(x, y)];
  Vec4f& color = pixel.color;
  color = {mixed(color.x, line.x, share), mixed(color.y, line.y, share),
           mixed(color.z, line.z, share), mixed(color.w, line.w, share)};
  pixel.depth = std::min(pixel.depth, depth);
}

void OpenSamples::collect(const FrameView& frame, int samples, std::vector<LinePixel>& pixels) const
{
  const auto all = static_cast<std::uint8_t>((1u << samples) - 1u);
  for (int y = used_.y0; y < used_.y1; ++y)
    for (int x = used_.x0; x < used_.x1; ++x) {
      const Pixel& pixel = pixels_[indexOf(x, y)];
      if (!(pixel.color.w > 0.0f)) continue;
      const Rgba8 color = {roundedByte(pixel.color.x), roundedByte(pixel.color.y),
                           roundedByte(pixel.color.z), roundedByte(pixel.color.w)};
      const std::uint8_t covered = frame.coverage[y * frame.rowStride + x];
      if (color.a == 0 || covered == all) continue;
      pixels.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), color,
                        pixel.depth, static_cast<std::uint8_t>(all & ~covered)});
    }
}

StrokeBlend::StrokeBlend(const StrokeGroup& group, const FrameView& frame, const HaloCut* cut,
                         OpenSamples* open, int samples)
    : frame_(frame),
      cut_(cut),
      open_(open),
      instance_(group.instance),
      opacity_(group.opacity),
      own_(inkOf({full(group.color), group.color})),
      samples_(static_cast<std::uint32_t>(samples)),
      keepsApart_(frame.background == Background::kKeepApart && frame.coverage != nullptr)
{
}

StrokeBlend::Ink StrokeBlend::inkOf(const LineColor& line)
{
  const Vec3f c = line.color;
  return {{c.x * 255.0f, c.y * 255.0f, c.z * 255.0f, 255.0f}, line.radiance};
}

void StrokeBlend::blend(int x, int y, float coverage, float depth, const Ink& ink) const
{
  if (cut_ != nullptr) {
    coverage *= 1.0f - cut_->shareAt(x, y, depth, instance_);
    if (!(coverage > 0.0f)) return;
  }
  const std::ptrdiff_t index = y * frame_.rowStride + x;
  const float a = coverage * opacity_;
  Shown shown = Shown::kMore;
  if (!keepsApart_)
    mix(index, a, ink);
  else if (open_ == nullptr)
    shown = blendSamples(index, a);
  else {
    const std::uint32_t open = samples_ - bitCount(frame_.coverage[index]);
    shown = coverSamples(index, a, a < 1.0f ? 0 : open);
    if (a < 1.0f && open > 0) open_->add(x, y, ink.bytes, a, depth);
  }
  const bool isItsDepth = shown == Shown::kFirst || (shown == Shown::kMore && a >= 0.5f);
  if (isItsDepth && depth < frame_.depth[index]) frame_.depth[index] = depth;
}

void StrokeBlend::mix(std::ptrdiff_t index, float a, const Ink& ink) const
{
  Rgba8& color = frame_.color[index];
  color = {mixedByte(color.r, ink.bytes.x, a), mixedByte(color.g, ink.bytes.y, a),
           mixedByte(color.b, ink.bytes.z, a), mixedByte(color.a, ink.bytes.w, a)};
  if (frame_.radiance.empty()) return;
  const RadianceView& planes = frame_.radiance;
  planes.r[index] = mixed(planes.r[index], ink.radiance.x, a);
  planes.g[index] = mixed(planes.g[index], ink.radiance.y, a);
  planes.b[index] = mixed(planes.b[index], ink.radiance.z, a);
}

StrokeBlend::Shown StrokeBlend::blendSamples(std::ptrdiff_t index, float a) const
{
  const std::uint32_t open = samples_ - bitCount(frame_.coverage[index]);
  const float share = std::floor(a * static_cast<float>(open) + 0.5f);
  return coverSamples(index, a, static_cast<std::uint32_t>(share));
}

StrokeBlend::Shown StrokeBlend::coverSamples(std::ptrdiff_t index, float a,
                                             std::uint32_t more) const
{
  std::uint32_t bits = frame_.coverage[index];
  const std::uint32_t old = bitCount(bits);
  if (old + more == 0) return Shown::kNothing;
  // Of all samples that are covered now, the line's share.
  const float share =
      (static_cast<float>(more) + a * static_cast<float>(old)) / static_cast<float>(old + more);
  mix(index, share, own_);
  for (std::uint32_t s = 0, left = more; left > 0; ++s) {
    if ((bits >> s & 1u) != 0) continue;
    bits |= 1u << s;
    --left;
  }
  frame_.coverage[index] = static_cast<std::uint8_t>(bits);
  return old == 0 ? Shown::kFirst : Shown::kMore;
}

}  // namespace limn
