// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/SampleTexture.h"

#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace limn {
namespace {

float finiteOrZero(float x)
{
  return std::fabs(x) <= std::numeric_limits<float>::max() ? x : 0.0f;
}
Vec2f finiteOrZero(Vec2f v)
{
  return {finiteOrZero(v.x), finiteOrZero(v.y)};
}

template <class T>
T mix(T a, T b, float t)
{
  return a + (b - a) * t;
}

/// A coordinate after its wrap: within [0, 1] if it repeats, else near enough to find what is
/// outside.
struct Wrapped {
  float value;
  float direction;  ///< -1 in a copy that is turned round, else 1
};

Wrapped wrapped(TextureWrap wrap, float coordinate)
{
  const float u = finiteOrZero(coordinate);
  switch (wrap) {
    case TextureWrap::kRepeat:
      return {u - std::floor(u), 1.0f};
    case TextureWrap::kMirror: {
      const float t = u - 2.0f * std::floor(u * 0.5f);
      return t > 1.0f ? Wrapped{2.0f - t, -1.0f} : Wrapped{t, 1.0f};
    }
    default:
      return {u > -2.0f ? (u < 3.0f ? u : 3.0f) : -2.0f, 1.0f};
  }
}

struct WrappedUv {
  Wrapped u, v;
};

struct Level {
  float width, height;
  std::int32_t columns, rows, offset;
};

Level levelOf(const TextureImage& image, std::int32_t number)
{
  const TextureImage::Levels& levels = image.levels();
  const std::int32_t columns = levels.width[number], rows = levels.height[number];
  return {static_cast<float>(columns), static_cast<float>(rows), columns, rows,
          levels.offset[number]};
}

/// Index of a texel within a side of the image, or -1 on the border. Requires: at most two sides
/// from it.
std::int32_t texelIndex(TextureWrap wrap, std::int32_t index, std::int32_t side)
{
  const std::int32_t last = side - 1;
  std::int32_t i = index;
  switch (wrap) {
    case TextureWrap::kRepeat:
      i += i < 0 ? side : 0;
      i -= i > last ? side : 0;
      break;
    case TextureWrap::kMirror:
      i = i < 0 ? -1 - i : i;
      i = i > last ? last + side - i : i;
      break;
    case TextureWrap::kClamp:
      break;
    case TextureWrap::kBorder:
      return i > last ? -1 : std::max(i, -1);
  }
  // A side of one texel is shorter than the reach of a difference.
  return std::clamp(i, 0, last);
}

/// Where between two texels a coordinate is: the left or lower one, and how far from its centre.
struct Between {
  std::int32_t first;
  float weight;
};

Between between(TextureFilter filter, float u, float side)
{
  if (filter == TextureFilter::kNearest)
    return {static_cast<std::int32_t>(std::floor(u * side)), 0};
  const float x = u * side - 0.5f;
  const float first = std::floor(x);
  return {static_cast<std::int32_t>(first), x - first};
}

/// Texels of an image as numbers, not yet in units of sampleTexture().
class Texels {
 public:
  Texels(const TextureImage& image, const TextureSampler& sampler)
      : image_(image), border_(sampler.borderColor * image.one())
  {
  }

  Vec4f color(const Level& level, std::int32_t x, std::int32_t y) const
  {
    if (x < 0 || y < 0) return border_;
    const std::uint32_t* words = image_.words();
    const auto texel = static_cast<std::size_t>(level.offset + y * level.columns + x);
    const auto part = [](std::uint32_t word, int shift, std::uint32_t mask) {
      return static_cast<float>(word >> shift & mask);
    };
    switch (image_.format()) {
      case TexelFormat::kUnorm8: {
        const std::uint32_t word = words[texel];
        return {part(word, 0, 0xFF), part(word, 8, 0xFF), part(word, 16, 0xFF),
                part(word, 24, 0xFF)};
      }
      case TexelFormat::kUnorm16: {
        const std::uint32_t rg = words[2 * texel], ba = words[2 * texel + 1];
        return {part(rg, 0, 0xFFFF), part(rg, 16, 0xFFFF), part(ba, 0, 0xFFFF),
                part(ba, 16, 0xFFFF)};
      }
      default: {
        Vec4f color;
        std::memcpy(&color, words + 4 * texel, sizeof color);
        return color;
      }
    }
  }

 private:
  const TextureImage& image_;
  Vec4f border_;
};

/// The colour at a point of one level.
class ColorOfLevel {
 public:
  ColorOfLevel(const TextureImage& image, const TextureSampler& sampler)
      : sampler_(sampler), texels_(image, sampler)
  {
  }

  Vec4f operator()(WrappedUv at, const Level& level) const
  {
    const Between x = between(sampler_.filter, at.u.value, level.width);
    const Between y = between(sampler_.filter, at.v.value, level.height);
    const auto texel = [&](std::int32_t i, std::int32_t j) {
      return texels_.color(level, texelIndex(sampler_.wrapU, x.first + i, level.columns),
                           texelIndex(sampler_.wrapV, y.first + j, level.rows));
    };
    if (sampler_.filter == TextureFilter::kNearest) return texel(0, 0);
    return mix(mix(texel(0, 0), texel(1, 0), x.weight), mix(texel(0, 1), texel(1, 1), x.weight),
               y.weight);
  }

 private:
  const TextureSampler& sampler_;
  Texels texels_;
};

/// The gradient of the red channel at a point of one level.
class GradientOfLevel {
 public:
  GradientOfLevel(const TextureImage& image, const TextureSampler& sampler)
      : sampler_(sampler), texels_(image, sampler)
  {
  }

  Vec2f operator()(WrappedUv at, const Level& level) const
  {
    const Between x = between(sampler_.filter, at.u.value, level.width);
    const Between y = between(sampler_.filter, at.v.value, level.height);
    const auto height = [&](std::int32_t i, std::int32_t j) {
      return texels_
          .color(level, texelIndex(sampler_.wrapU, x.first + i, level.columns),
                 texelIndex(sampler_.wrapV, y.first + j, level.rows))
          .x;
    };
    const auto across = [&](std::int32_t i, std::int32_t j) {
      return height(i + 1, j) - height(i - 1, j);
    };
    const auto up = [&](std::int32_t i, std::int32_t j) {
      return height(i, j + 1) - height(i, j - 1);
    };
    Vec2f twice = {across(0, 0), up(0, 0)};
    if (sampler_.filter != TextureFilter::kNearest)
      twice = {mix(mix(twice.x, across(1, 0), x.weight), mix(across(0, 1), across(1, 1), x.weight),
                   y.weight),
               mix(mix(twice.y, up(1, 0), x.weight), mix(up(0, 1), up(1, 1), x.weight), y.weight)};
    return {twice.x * (0.5f * level.width * at.u.direction),
            twice.y * (0.5f * level.height * at.v.direction)};
  }

 private:
  const TextureSampler& sampler_;
  Texels texels_;
};

/// What of a texture one pixel sees.
struct Footprint {
  float level;  ///< within the chain
  float probes;
  Vec2f axis;  ///< that the probes lie along, in uv
};

Footprint footprint(const TextureImage& image, const TextureSampler& sampler, Vec2f ddx, Vec2f ddy)
{
  const float width = static_cast<float>(image.width());
  const float height = static_cast<float>(image.height());
  const auto squaredLength = [&](Vec2f d) {
    const Vec2f texels = {d.x * width, d.y * height};
    return texels.x * texels.x + texels.y * texels.y;
  };
  const float x2 = squaredLength(ddx), y2 = squaredLength(ddy);
  const bool isWide = x2 > y2;
  const float longer2 = isWide ? x2 : y2;
  Footprint result = {0.0f, 1.0f, isWide ? ddx : ddy};
  float squared = longer2;
  if (sampler.maxAnisotropy > 1) {
    const float most = static_cast<float>(sampler.maxAnisotropy);
    const float shorter = std::sqrt(isWide ? y2 : x2);
    const float ratio = std::sqrt(longer2) / (shorter > 1.0f ? shorter : 1.0f);
    // Of two infinite lengths the ratio is not a number, and the most probes are taken.
    const float wanted = ratio < most ? std::ceil(ratio) : most;
    result.probes = wanted > 1.0f ? wanted : 1.0f;
    squared = longer2 / (result.probes * result.probes);
  }
  if (!(squared > 1.0f)) return result;
  const float coarsest = static_cast<float>(1 << 2 * (image.levelCount() - 1));
  result.level = 0.5f * power_detail::log2Normal(squared < coarsest ? squared : coarsest);
  return result;
}

WrappedUv wrapped(const TextureSampler& sampler, Vec2f uv)
{
  return {wrapped(sampler.wrapU, uv.x), wrapped(sampler.wrapV, uv.y)};
}

template <class AtLevel>
auto trilinear(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, float level,
               const AtLevel& atLevel)
{
  const WrappedUv at = wrapped(sampler, uv);
  const auto finer = static_cast<std::int32_t>(level);
  const float weight = level - static_cast<float>(finer);
  const auto fine = atLevel(at, levelOf(image, finer));
  if (weight == 0.0f) return fine;
  return mix(fine, atLevel(at, levelOf(image, std::min(finer + 1, image.levelCount() - 1))),
             weight);
}

template <class AtLevel>
auto filtered(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx,
              Vec2f ddy)
{
  const AtLevel atLevel(image, sampler);
  if (sampler.filter != TextureFilter::kTrilinear)
    return atLevel(wrapped(sampler, uv), levelOf(image, 0)) * image.unit();
  const Footprint print = footprint(image, sampler, finiteOrZero(ddx), finiteOrZero(ddy));
  if (sampler.maxAnisotropy == 1)
    return trilinear(image, sampler, uv, print.level, atLevel) * image.unit();
  auto sum = decltype(atLevel({}, {})){};
  const float step = 1.0f / (print.probes + 1.0f);
  for (float i = 1.0f; i <= print.probes; i += 1.0f)
    sum =
        sum + trilinear(image, sampler, uv + print.axis * (i * step - 0.5f), print.level, atLevel);
  return sum * (1.0f / print.probes) * image.unit();
}

}  // namespace

Vec4f sampleTexture(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx,
                    Vec2f ddy)
{
  return filtered<ColorOfLevel>(image, sampler, uv, ddx, ddy);
}

Vec2f heightGradient(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx,
                     Vec2f ddy)
{
  return filtered<GradientOfLevel>(image, sampler, uv, ddx, ddy);
}

}  // namespace limn
