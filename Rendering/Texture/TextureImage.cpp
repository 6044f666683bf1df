// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/TextureImage.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <string>

namespace limn {
namespace {

/// Work for one thread at a time.
constexpr int kTexelsOfBlock = 1 << 14;

/// Calls body(first row, end) for all rows.
template <class Body>
void forEachBlockOfRows(int threads, int width, int height, Body body)
{
  const int rows = std::max(1, kTexelsOfBlock / width);
  const int blocks = (height + rows - 1) / rows;
  const auto block = [&](std::size_t i) {
    const int first = static_cast<int>(i) * rows;
    body(first, std::min(height, first + rows));
  };
  if (blocks == 1)
    block(0);
  else
    parallelFor(threads, static_cast<std::size_t>(blocks), block);
}

template <class Number>
using Channels = std::array<Number, 4>;

/// How texels lie in words. `Sum` holds weighted sums of numbers without rounding (integers) or in
/// more digits (floats).
template <TexelFormat>
struct Layout;

template <>
struct Layout<TexelFormat::kUnorm8> {
  using Number = std::uint8_t;
  using Sum = std::uint64_t;
  static constexpr std::size_t kWords = 1;
  static constexpr Number kOne = 255;

  static Channels<Number> load(const std::uint32_t* word)
  {
    return {static_cast<Number>(*word), static_cast<Number>(*word >> 8),
            static_cast<Number>(*word >> 16), static_cast<Number>(*word >> 24)};
  }
  static void store(Channels<Number> c, std::uint32_t* word)
  {
    *word = c[0] | static_cast<std::uint32_t>(c[1]) << 8 | static_cast<std::uint32_t>(c[2]) << 16 |
            static_cast<std::uint32_t>(c[3]) << 24;
  }
};

template <>
struct Layout<TexelFormat::kUnorm16> {
  using Number = std::uint16_t;
  using Sum = std::uint64_t;
  static constexpr std::size_t kWords = 2;
  static constexpr Number kOne = 65535;

  static Channels<Number> load(const std::uint32_t* word)
  {
    return {static_cast<Number>(word[0]), static_cast<Number>(word[0] >> 16),
            static_cast<Number>(word[1]), static_cast<Number>(word[1] >> 16)};
  }
  static void store(Channels<Number> c, std::uint32_t* word)
  {
    word[0] = c[0] | static_cast<std::uint32_t>(c[1]) << 16;
    word[1] = c[2] | static_cast<std::uint32_t>(c[3]) << 16;
  }
};

template <>
struct Layout<TexelFormat::kFloat32> {
  using Number = float;
  using Sum = double;
  static constexpr std::size_t kWords = 4;
  static constexpr Number kOne = 1;

  static Channels<Number> load(const std::uint32_t* word)
  {
    Channels<Number> c;
    std::memcpy(c.data(), word, sizeof c);
    return c;
  }
  static void store(Channels<Number> c, std::uint32_t* word)
  {
    std::memcpy(word, c.data(), sizeof c);
  }
};

template <class Result, class Function>
Result withLayout(TexelFormat format, Function function)
{
  switch (format) {
    case TexelFormat::kUnorm8:
      return function(Layout<TexelFormat::kUnorm8>());
    case TexelFormat::kUnorm16:
      return function(Layout<TexelFormat::kUnorm16>());
    default:
      return function(Layout<TexelFormat::kFloat32>());
  }
}

constexpr std::size_t kNoTexel = std::numeric_limits<std::size_t>::max();

/// Which texel is `number`'s: of two threads that found one each the first is named.
void keepLowest(std::atomic<std::size_t>& lowest, std::size_t number)
{
  std::size_t known = lowest.load();
  while (number < known && !lowest.compare_exchange_weak(known, number)) {
  }
}

bool isAllowed(float number)
{
  return std::fabs(number) <= kLargestTexel;
}
template <class Integer>
bool isAllowed(Integer)
{
  return true;
}

/// Copies level 0; returns the first texel that is not allowed, or kNoTexel.
template <class Layout>
std::size_t copyTexels(const TextureView& view, int threads, std::uint32_t* words)
{
  using Number = typename Layout::Number;
  const auto width = static_cast<std::size_t>(view.width);
  const auto components = static_cast<std::size_t>(view.components);
  std::atomic<std::size_t> wrong = kNoTexel;
  forEachBlockOfRows(threads, view.width, view.height, [&](int first, int end) {
    const std::size_t stop = static_cast<std::size_t>(end) * width;
    for (std::size_t i = static_cast<std::size_t>(first) * width; i < stop; ++i) {
      Channels<Number> given = {};
      std::memcpy(given.data(),
                  static_cast<const char*>(view.texels) + i * components * sizeof(Number),
                  components * sizeof(Number));
      if (!std::all_of(given.begin(), given.end(), [](Number n) { return isAllowed(n); }))
        keepLowest(wrong, i);
      if (components < 3) given = {given[0], given[0], given[0], given[1]};
      if (components % 2 == 1) given[3] = Layout::kOne;
      Layout::store(given, words + i * Layout::kWords);
    }
  });
  return wrong;
}

/// The texels along an axis that one texel of the next level is the weighted mean of.
struct AxisMean {
  int first, count;
  std::uint64_t weight[3];
};

std::uint64_t weightOfAxis(int side)
{
  return side == 1 ? 1 : side % 2 == 0 ? 2 : static_cast<std::uint64_t>(side);
}

AxisMean axisMean(int side, int i)
{
  if (side == 1) return {0, 1, {1}};
  if (side % 2 == 0) return {2 * i, 2, {1, 1}};
  const int half = side / 2;
  return {2 * i,
          3,
          {static_cast<std::uint64_t>(half - i), static_cast<std::uint64_t>(half),
           static_cast<std::uint64_t>(i + 1)}};
}

double mean(double sum, std::uint64_t weight)
{
  return sum / static_cast<double>(weight);
}
/// To nearest, half to even: always up would brighten each level by an eighth.
std::uint64_t mean(std::uint64_t sum, std::uint64_t weight)
{
  // Of 2 x 2 texels, by far the most, without a division.
  const std::uint64_t whole = weight == 4 ? sum >> 2 : sum / weight;
  const std::uint64_t rest = sum - whole * weight;
  const bool up = 2 * rest > weight || (2 * rest == weight && whole % 2 == 1);
  return up ? whole + 1 : whole;
}

template <class Layout>
Channels<typename Layout::Number> meanTexel(const std::uint32_t* words, int width, AxisMean x,
                                            AxisMean y, std::uint64_t weight)
{
  using Sum = typename Layout::Sum;
  Sum sums[4] = {};
  for (int j = 0; j < y.count; ++j) {
    const auto row = static_cast<std::size_t>(y.first + j) * static_cast<std::size_t>(width);
    for (int i = 0; i < x.count; ++i) {
      const auto texel =
          Layout::load(words + (row + static_cast<std::size_t>(x.first + i)) * Layout::kWords);
      const auto share = static_cast<Sum>(x.weight[i] * y.weight[j]);
      for (std::size_t c = 0; c < 4; ++c)
        sums[c] += share * static_cast<Sum>(texel[c]);
    }
  }
  Channels<typename Layout::Number> result;
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = static_cast<typename Layout::Number>(mean(sums[c], weight));
  return result;
}

template <class Layout>
void computeLevel(const TextureImage::Levels& levels, int level, int threads, std::uint32_t* words)
{
  const int fromWidth = levels.width[level - 1], fromHeight = levels.height[level - 1];
  const int width = levels.width[level];
  const std::uint32_t* from =
      words + static_cast<std::size_t>(levels.offset[level - 1]) * Layout::kWords;
  std::uint32_t* to = words + static_cast<std::size_t>(levels.offset[level]) * Layout::kWords;
  const std::uint64_t weight = weightOfAxis(fromWidth) * weightOfAxis(fromHeight);
  forEachBlockOfRows(threads, width, levels.height[level], [&](int first, int end) {
    for (int j = first; j < end; ++j) {
      const AxisMean y = axisMean(fromHeight, j);
      const std::size_t row = static_cast<std::size_t>(j) * static_cast<std::size_t>(width);
      for (int i = 0; i < width; ++i)
        Layout::store(meanTexel<Layout>(from, fromWidth, axisMean(fromWidth, i), y, weight),
                      to + (row + static_cast<std::size_t>(i)) * Layout::kWords);
    }
  });
}

Status checkView(const TextureView& view)
{
  if (view.width < 1 || view.height < 1 || view.width > TextureImage::kMaxSide ||
      view.height > TextureImage::kMaxSide)
    return {Error::kInvalidImageSize, "Texture size " + std::to_string(view.width) + " x " +
                                          std::to_string(view.height) + " is not between 1 and " +
                                          std::to_string(TextureImage::kMaxSide) +
                                          " texels a side; scale the image."};
  if (view.components < 1 || view.components > 4)
    return {Error::kSizeMismatch, "Texture with " + std::to_string(view.components) +
                                      " components a texel; there may be 1 to 4."};
  const std::size_t size = view.format == TexelFormat::kUnorm8    ? 1
                           : view.format == TexelFormat::kUnorm16 ? 2
                                                                  : 4;
  const std::size_t needed = static_cast<std::size_t>(view.width) *
                             static_cast<std::size_t>(view.height) *
                             static_cast<std::size_t>(view.components) * size;
  if (view.texels == nullptr || view.byteCount < needed)
    return {Error::kSizeMismatch, "Texture of " + std::to_string(view.width) + " x " +
                                      std::to_string(view.height) + " texels is truncated: " +
                                      std::to_string(view.texels == nullptr ? 0 : view.byteCount) +
                                      " bytes of " + std::to_string(needed) +
                                      "; read the image again or name its true size."};
  return {};
}

TextureImage::Levels levelsOf(const TextureView& view, MipChain chain)
{
  TextureImage::Levels levels;
  int width = view.width, height = view.height, offset = 0;
  for (;;) {
    levels.width[levels.count] = width;
    levels.height[levels.count] = height;
    levels.offset[levels.count++] = offset;
    if (chain == MipChain::kNone || (width == 1 && height == 1)) return levels;
    offset += width * height;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
}

}  // namespace

Status TextureImage::build(const TextureView& view, MipChain chain, int threads)
{
  *this = TextureImage();
  if (Status status = checkView(view); !status.ok()) return status;
  const Levels levels = levelsOf(view, chain);
  const auto size = [&](int level) {
    return static_cast<std::size_t>(levels.width[level]) *
           static_cast<std::size_t>(levels.height[level]);
  };
  const std::size_t texels =
      static_cast<std::size_t>(levels.offset[levels.count - 1]) + size(levels.count - 1);
  const auto fill = [&](auto layout) -> std::size_t {
    using L = decltype(layout);
    words_.resize(texels * L::kWords);
    const std::size_t wrong = copyTexels<L>(view, threads, words_.data());
    for (int level = 1; wrong == kNoTexel && level < levels.count; ++level)
      computeLevel<L>(levels, level, threads, words_.data());
    one_ = static_cast<float>(L::kOne);
    return wrong;
  };
  try {
    const std::size_t wrong = withLayout<std::size_t>(view.format, fill);
    if (wrong != kNoTexel) {
      *this = TextureImage();
      const auto width = static_cast<std::size_t>(view.width);
      return {Error::kNotFinite, "Texture texel (" + std::to_string(wrong % width) + ", " +
                                     std::to_string(wrong / width) +
                                     ") has a value that is not a number up to 1e27; replace it."};
    }
  } catch (const std::bad_alloc&) {
    *this = TextureImage();
    return {Error::kInvalidImageSize, "Texture of " + std::to_string(view.width) + " x " +
                                          std::to_string(view.height) +
                                          " texels does not fit into the memory; scale the image."};
  }
  format_ = view.format;
  unit_ = 1.0f / one_;
  levels_ = levels;
  return {};
}

Vec4f TextureImage::texel(int level, int x, int y) const
{
  const auto at = static_cast<std::size_t>(levels_.offset[level] + y * levels_.width[level] + x);
  return withLayout<Vec4f>(format_, [&](auto layout) -> Vec4f {
    using L = decltype(layout);
    const auto c = L::load(words_.data() + at * L::kWords);
    return Vec4f{static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                 static_cast<float>(c[3])} *
           unit_;
  });
}

}  // namespace limn
