// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CompareNeighbours.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Lines/CompareNeighbours.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Lines/CompareNeighbours-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(comparePairsKernel);
HWY_EXPORT(compareIdsKernel);

PairTest::PairTest(const SurfaceLayers& layers, const NeighbourBounds& bounds, int samples)
    : sharpest(*std::min_element(bounds.crease.begin(), bounds.crease.end())),
      asksAlike(std::adjacent_find(bounds.asks.begin(), bounds.asks.end(), std::not_equal_to<>()) ==
                bounds.asks.end())
{
  for (std::size_t s = 0; s < layers.offsets.size(); ++s) {
    offsetX[s] = layers.offsets[s].x;
    offsetY[s] = layers.offsets[s].y;
  }
  findGentle(layers, *std::min_element(bounds.tolerance.begin(), bounds.tolerance.end()), samples);
}

/// A unit vector's product with the way from one pixel to the other is at most that way's length.
void PairTest::findGentle(const SurfaceLayers& layers, float tolerance, int samples)
{
  // Of a place P = N / w, both of them linear in the pixel and its depth d, the way to the next
  // pixel is (c + (e - P m) (d' - d)) / w', with c, e the columns of N for the pixel and the depth
  // and m what w grows by with depth: its length is at most (|c| + |e w - N m| |d' - d| / w) / w'.
  const Mat4f& m = layers.toView->matrix();
  if (m.m[3][0] != 0.0f || m.m[3][1] != 0.0f) return;
  const auto lengthOf = [](Vec3f v) {
    const auto wide = vec3Cast<double>(v);
    return static_cast<float>(std::sqrt(dot(wide, wide)));
  };
  const auto columnOf = [&](int c) { return Vec3f{m.m[0][c], m.m[1][c], m.m[2][c]}; };
  const auto apron = static_cast<float>(layers.apron);
  float skew = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const float x = (corner & 1) != 0 ? static_cast<float>(layers.endX()) : -apron;
    const float y = (corner & 2) != 0 ? static_cast<float>(layers.endY()) : -apron;
    const float depth = (corner & 4) != 0 ? 1.0f : 0.0f;
    const Vec3f n = columnOf(0) * x + columnOf(1) * y + columnOf(2) * depth + columnOf(3);
    const Vec3f grows = columnOf(2) * (m.m[3][2] * depth + m.m[3][3]) - n * m.m[3][2];
    perDepth = std::max(perDepth, lengthOf(grows));
    skew = std::max(skew, lengthOf(grows) / std::fabs(grows.z));
  }
  // Nearest samples of two pixels may lie at their far sides.
  const float width = lengthOf(columnOf(0)), height = lengthOf(columnOf(1));
  const float aside = samples == 1 ? std::max(width, height)
                                   : std::max(2.0f * width + height, width + 2.0f * height);
  // Of the tolerance in pixels' heights; a twentieth of it is for rounding and for w that is not
  // the same at both pixels. What float leaves of w's last bits is in ViewPoint::rounding, unless
  // pixels lie far aside.
  const float rest = 0.95f * tolerance * std::fabs(m.m[1][1]) - aside;
  constexpr float kMostSkew = 2, kMostGrowth = 0.02f;
  const bool isKnown = perDepth > 0.0f && aside > 0.0f && skew <= kMostSkew;
  if (isKnown && std::fabs(m.m[3][2]) * rest <= kMostGrowth * perDepth) gentle = rest;
}

NeighbourRows::NeighbourRows(const SurfaceLayers& layers, const NeighbourBounds& bounds,
                             int samples, const PixelRectangle& touched)
    : layers_(layers),
      bounds_(bounds),
      samples_(samples),
      touched_(touched),
      count_(static_cast<std::size_t>(touched.x1 - touched.x0)),
      test_(layers, bounds, samples),
      compared_(touched.y0 - 2)
{
  // One before the first pixel, and a vector behind the last.
  const std::size_t room = count_ + 1 + SurfaceLayers::kSpare;
  for (std::vector<std::uint8_t>* bytes : {&pairs_, &below_, &asks_, &marks_})
    bytes->assign(room, 0);
}

namespace {

/// PixelMark bits of as many pixels as Word has bytes: an edge where a step lies at any side, and
/// creases, as far as instances ask for them.
template <class Word>
void markPixels(const std::uint8_t* pairs, const std::uint8_t* left, const std::uint8_t* below,
                const std::uint8_t* asks, std::uint8_t* marks)
{
  static_assert(kMayHaveEdge == kStepRight && kStepAbove == kStepRight << 3, "bits are moved");
  constexpr auto kOnes = static_cast<Word>(static_cast<Word>(~Word{0}) / 0xFF);  // 1 in each byte
  constexpr auto kCreases = static_cast<Word>(kOnes * (kMayCreaseRight | kMayCreaseAbove));
  const auto load = [](const std::uint8_t* bytes) {
    Word word;
    std::memcpy(&word, bytes, sizeof word);
    return word;
  };
  const Word own = load(pairs), under = load(below);
  const auto steps = static_cast<Word>((own | load(left) | (own | under) >> 3) & kOnes);
  const auto marked = static_cast<Word>((steps | (own & kCreases)) & load(asks));
  std::memcpy(marks, &marked, sizeof marked);
}

}  // namespace

/// Between a row's pixels, and from it to the row above.
void NeighbourRows::comparePairs(int y)
{
  const RowJob job = {
      layers_, bounds_, test_, samples_, touched_.x0, y, layers_.indexOf(touched_.x0, y), count_};
  HWY_DYNAMIC_DISPATCH(comparePairsKernel)(job, pairs_.data() + 1, asks_.data());
  if (layers_.hasIds) HWY_DYNAMIC_DISPATCH(compareIdsKernel)(job, pairs_.data() + 1);
  // Next to the frame's border, and to what was not touched.
  pairs_[0] = kStepRight;
  pairs_[count_] |= kStepRight;
  compared_ = y;
}

const std::uint8_t* NeighbourRows::marksOf(int y)
{
  if (compared_ != y - 1 && y > touched_.y0) comparePairs(y - 1);
  if (y == touched_.y0)
    std::fill(below_.begin(), below_.end(), std::uint8_t{kStepAbove});
  else
    std::swap(pairs_, below_);
  comparePairs(y);
  const std::uint8_t *const left = pairs_.data(), *const pairs = left + 1,
                            *const below = below_.data() + 1, *const asks = asks_.data();
  // Eight pixels at once, then those that are left.
  std::size_t i = 0;
  for (; i + sizeof(std::uint64_t) <= count_; i += sizeof(std::uint64_t))
    markPixels<std::uint64_t>(pairs + i, left + i, below + i, asks + i, marks_.data() + i);
  for (; i < count_; ++i)
    markPixels<std::uint8_t>(pairs + i, left + i, below + i, asks + i, marks_.data() + i);
  return marks_.data();
}

}  // namespace limn
#endif  // HWY_ONCE
