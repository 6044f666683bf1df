// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/CompositeTile.h"

#include "Rendering/Base/FullIntensity.h"
#include "Rendering/Post/ColorSum.h"
#include "Rendering/Post/TilePlace.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace limn {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu, kRun = 0xFFFFFFFEu;

const std::array<float, 256>& shares()
{
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(i) / 255.0f;
    return values;
  }();
  return table;
}

/// Rounded to nearest, halves to even.
std::uint8_t toByte(float share)
{
  // Above 2^23 a float has no fraction: adding rounds, and leaves the number in its lowest bits.
  constexpr float kRounder = 0x1.8p23f;
  const float rounded = (share < 1.0f ? share : 1.0f) * 255.0f + kRounder;
  std::uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof bits);
  return static_cast<std::uint8_t>(bits & 0xFFu);
}

}  // namespace

void TileCompositor::begin(const TileClusters& clusters, const TileRectangle& pixels,
                           const FragmentList& fragments, const TileColors& colors,
                           const FrameView& frame, bool isVeiled)
{
  clusters_ = &clusters;
  tile_ = pixels;
  fragments_ = &fragments;
  colors_ = &colors;
  frame_ = &frame;
  samples_ = static_cast<std::uint32_t>(clusters.scene->scene->samples);
  hasRadiance_ = colors.hasRadiance;
  isVeiled_ = isVeiled;
  pixels_.clear();
  std::fill(std::begin(firstFragment_), std::end(firstFragment_), kNone);
  for (std::size_t r = 0; r < fragments.runCount; ++r)
    std::fill_n(firstFragment_ + fragments.run[r].pixel, fragments.run[r].length, kRun);
  for (std::size_t f = fragments.count; f-- > 0;)
    firstFragment_[fragments.pixel[f]] = static_cast<std::uint32_t>(f);
}

void TileCompositor::set(std::uint32_t sample, Rgba8 color, Vec3f radiance)
{
  const std::array<float, 256>& share = shares();
  sample_[sample] = {
      {share[color.r], share[color.g], share[color.b], share[color.a]}, radiance, true};
}

Vec3f TileCompositor::radianceOf(const RadianceArrays& from, std::size_t i) const
{
  return hasRadiance_ ? Vec3f{from.r[i], from.g[i], from.b[i]} : Vec3f{0, 0, 0};
}

/// What the pixel's samples have without translucent surfaces.
bool TileCompositor::findOpaque(std::uint32_t pixel, std::ptrdiff_t index)
{
  const std::uint32_t first = firstFragment_[pixel];
  const std::uint32_t all = (1u << samples_) - 1u;
  coverage_ = 0;
  if (first == kRun) {
    for (std::uint32_t s = 0; s < samples_; ++s)
      set(s, colors_->pixel[pixel], radianceOf(colors_->pixelRadiance, pixel));
    coverage_ = all;
    return true;
  }
  const RadianceView& old = frame_->radiance;
  const Vec3f radiance =
      hasRadiance_ ? Vec3f{old.r[index], old.g[index], old.b[index]} : Vec3f{0, 0, 0};
  for (std::uint32_t s = 0; s < samples_; ++s)
    if (frame_->background == Background::kBlend)
      set(s, frame_->color[index], radiance);
    else
      sample_[s] = {{0, 0, 0, 0}, {0, 0, 0}, false};
  if (first == kNone) return true;
  for (std::size_t f = first; f < fragments_->count && fragments_->pixel[f] == pixel; ++f) {
    const std::uint32_t coverage = samples_ == 1 ? 1u : fragments_->coverage[f];
    for (std::uint32_t s = 0; s < samples_; ++s)
      if ((coverage >> s & 1u) != 0)
        set(s, colors_->fragment[f], radianceOf(colors_->fragmentRadiance, f));
    coverage_ |= coverage;
  }
  return samples_ == 1 || fragments_->coverage[first] == all;
}

void TileCompositor::cover(const TranslucentFragments& fragments, const std::uint32_t* layers,
                           std::uint32_t count, Sample& sample) const
{
  Vec4f below = sample.color;
  Vec3f radiance = sample.radiance;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec4f c = fragments.colors()[layers[i]];
    const float a = c.w, rest = 1.0f - a;
    below = Vec4f{full(c.x), full(c.y), full(c.z), 1.0f} * a + below * rest;
    if (hasRadiance_) radiance = Vec3f{c.x, c.y, c.z} * a + radiance * rest;
  }
  sample = {below, radiance, true};
}

/// `layers` are those of all samples.
float TileCompositor::restOf(const TranslucentFragments& fragments,
                             const std::uint32_t* layers) const
{
  float sum = 0;
  for (std::uint32_t s = 0; s < samples_; ++s) {
    float rest = 1;
    for (std::uint32_t count = *layers++; count > 0; --count)
      rest = rest * (1.0f - fragments.colors()[*layers++].w);
    sum += rest;
  }
  return sum / static_cast<float>(samples_);
}

/// What the pixel's only sample has without translucent surfaces.
Rgba8 TileCompositor::opaqueColor(std::uint32_t pixel, std::ptrdiff_t index) const
{
  const std::uint32_t first = firstFragment_[pixel];
  if (first == kRun) return colors_->pixel[pixel];
  if (first != kNone) return colors_->fragment[first];
  return frame_->background == Background::kBlend ? frame_->color[index] : Rgba8{0, 0, 0, 0};
}

/// addPixel() of one sample without radiance.
void TileCompositor::addSinglePixel(const TranslucentFragments& fragments,
                                    TranslucentFragments::Pixel touched)
{
  const TilePlace place(tile_, *frame_);
  const std::array<float, 256>& share = shares();
  const Rgba8 old = opaqueColor(touched.pixel, place.indexOf(touched.pixel));
  Vec4f color = {share[old.r], share[old.g], share[old.b], share[old.a]};
  const std::uint32_t* const layers = fragments.layers() + touched.first;
  for (std::uint32_t i = 1; i <= layers[0]; ++i) {
    const Vec4f c = fragments.colors()[layers[i]];
    color = Vec4f{full(c.x), full(c.y), full(c.z), 1.0f} * c.w + color * (1.0f - c.w);
  }
  pixels_.push_back({touched.pixel,
                     {toByte(color.x), toByte(color.y), toByte(color.z), toByte(color.w)},
                     {0, 0, 0},
                     1});
}

void TileCompositor::addPixel(const TranslucentFragments& fragments,
                              TranslucentFragments::Pixel touched)
{
  const TilePlace place(tile_, *frame_);
  const bool isUniform = findOpaque(touched.pixel, place.indexOf(touched.pixel));
  const std::uint32_t* layers = fragments.layers() + touched.first;
  if (isUniform && fragments.areSameInAll(touched, samples_)) {
    cover(fragments, layers + 1, layers[0], sample_[0]);
    pixels_.push_back(meanOfEqual(touched.pixel));
    return;
  }
  for (std::uint32_t s = 0; s < samples_; ++s) {
    const std::uint32_t count = *layers++;
    if (count == 0) continue;
    cover(fragments, layers, count, sample_[s]);
    coverage_ |= 1u << s;
    layers += count;
  }
  pixels_.push_back(meanOf(touched.pixel));
}

TileCompositor::Pixel TileCompositor::meanOf(std::uint32_t pixel) const
{
  ColorSum sum(clusters_->scene->scene->resolve);
  Vec3f radiance = {0, 0, 0};
  float count = 0;
  for (std::uint32_t s = 0; s < samples_; ++s) {
    const Sample& sample = sample_[s];
    if (!sample.isShown) continue;
    const Vec4f c = sample.color;
    sum.add({toByte(c.x), toByte(c.y), toByte(c.z), toByte(c.w)}, 1);
    radiance = radiance + sample.radiance;
    count += 1.0f;
  }
  return {pixel,
          sum.mean(),
          {radiance.x / count, radiance.y / count, radiance.z / count},
          static_cast<std::uint16_t>(coverage_)};
}

/// meanOf() where all samples are as the first.
TileCompositor::Pixel TileCompositor::meanOfEqual(std::uint32_t pixel) const
{
  const Sample& sample = sample_[0];
  const Vec4f c = sample.color;
  Vec3f radiance = {0, 0, 0};
  for (std::uint32_t s = 0; hasRadiance_ && s < samples_; ++s)
    radiance = radiance + sample.radiance;
  const auto count = static_cast<float>(samples_);
  return {pixel,
          {toByte(c.x), toByte(c.y), toByte(c.z), toByte(c.w)},
          {radiance.x / count, radiance.y / count, radiance.z / count},
          static_cast<std::uint16_t>((1u << samples_) - 1u)};
}

void TileCompositor::add(const TranslucentFragments& fragments)
{
  const bool isSingle = samples_ == 1 && !hasRadiance_;
  for (const TranslucentFragments::Pixel& touched : fragments.touched()) {
    if (isSingle)
      addSinglePixel(fragments, touched);
    else
      addPixel(fragments, touched);
    if (isVeiled_) pixels_.back().rest = restOf(fragments, fragments.layers() + touched.first);
  }
}

void TileCompositor::write() const
{
  const TilePlace place(tile_, *frame_);
  for (const Pixel& pixel : pixels_) {
    const std::ptrdiff_t index = place.indexOf(pixel.pixel);
    frame_->color[index] = pixel.color;
    if (frame_->coverage != nullptr)
      frame_->coverage[index] = static_cast<std::uint8_t>(pixel.coverage);
    if (!hasRadiance_) continue;
    frame_->radiance.r[index] = pixel.radiance.x;
    frame_->radiance.g[index] = pixel.radiance.y;
    frame_->radiance.b[index] = pixel.radiance.z;
  }
}

void TileCompositor::veil(const TileRectangle& pixels, VeiledTile& veiled) const
{
  const TilePlace place(tile_, *frame_);
  veiled.pixels.reserve(pixels_.size());
  for (const Pixel& pixel : pixels_) {
    const std::ptrdiff_t index = place.indexOf(pixel.pixel);
    const int column = static_cast<int>(pixel.pixel % kTileSide),
              row = static_cast<int>(pixel.pixel / kTileSide);
    veiled.pixels.push_back({static_cast<std::uint16_t>(pixels.x0 + column),
                             static_cast<std::uint16_t>(pixels.y0 + row), frame_->color[index],
                             pixel.color, pixel.rest});
    if (frame_->coverage != nullptr)
      frame_->coverage[index] = static_cast<std::uint8_t>(pixel.coverage);
    if (!hasRadiance_) continue;
    const RadianceView& below = frame_->radiance;
    veiled.radiance.push_back({{below.r[index], below.g[index], below.b[index]}, pixel.radiance});
  }
}

}  // namespace limn
