// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/TonalArtMap.h"

#include <cstddef>

namespace limn {
namespace {

constexpr int kSide = TonalArtMap::kSide;

enum class Way { kAlongRows, kAlongColumns };

/// Strokes of two texels: the texel of a number and the one before it.
class Draughtsman {
 public:
  explicit Draughtsman(float* first) : first_(first) {}

  void drawAll(Way way, int start, int step, int tone)
  {
    for (int line = start; line < kSide; line += step)
      draw(way, line, {0, kSide}, tone);
  }
  /// On each line one stroke of about half its length, at a random place.
  void drawHalf(Way way, int start, int step, int tone)
  {
    for (int line = start; line < kSide; line += step) {
      const int begin = static_cast<int>(random() % kSide);
      const int length = kSide * 3 / 8 + static_cast<int>(random() % (kSide / 4));
      draw(way, line, {begin, length}, tone);
    }
  }

 private:
  struct Stretch {
    int begin, length;
  };
  void draw(Way way, int line, Stretch stretch, int tone)
  {
    for (int i = stretch.begin; i < stretch.begin + stretch.length; ++i)
      for (const int across : {line + kSide - 1, line}) {
        const int a = across % kSide, along = i % kSide;
        const int texel = way == Way::kAlongRows ? a * kSide + along : along * kSide + a;
        float& first = first_[texel];
        if (static_cast<float>(tone) < first) first = static_cast<float>(tone);
      }
  }
  /// Numerical Recipes' series modulo 2^32, of which the upper bits are good.
  std::uint32_t random()
  {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> 16;
  }

  float* first_;
  std::uint32_t state_ = 12061u;
};

}  // namespace

TonalArtMap::TonalArtMap()
{
  first_.fill(static_cast<float>(kTones));
  Draughtsman draughtsman(first_.data());
  draughtsman.drawAll(Way::kAlongRows, 0, 16, 1);
  draughtsman.drawHalf(Way::kAlongRows, 8, 16, 1);
  draughtsman.drawAll(Way::kAlongRows, 0, 8, 2);
  draughtsman.drawAll(Way::kAlongColumns, 0, 16, 3);
  draughtsman.drawHalf(Way::kAlongColumns, 8, 16, 3);
  draughtsman.drawAll(Way::kAlongColumns, 0, 8, 4);
  draughtsman.drawHalf(Way::kAlongRows, 4, 8, 4);
  draughtsman.drawAll(Way::kAlongRows, 0, 4, 5);
  draughtsman.drawAll(Way::kAlongColumns, 0, 4, 5);
  for (int tone = 0; tone <= kTones; ++tone) {
    int count = 0;
    for (const float first : first_)
      if (first <= static_cast<float>(tone)) ++count;
    coverage_[static_cast<std::size_t>(tone)] =
        static_cast<float>(count) / static_cast<float>(kSide * kSide);
  }
  for (std::size_t tone = 0; tone < kTones; ++tone)
    perCoverage_[tone] = 1.0f / (coverage_[tone + 1] - coverage_[tone]);
}

const TonalArtMap& tonalArtMap()
{
  static const TonalArtMap map;
  return map;
}

}  // namespace limn
