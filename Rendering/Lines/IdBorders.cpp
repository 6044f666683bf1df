// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/IdBorders.h"

#include <cmath>
#include <cstddef>

namespace limn {
namespace {

constexpr int kBefore = 1;           ///< columns of the window before the pair's first
constexpr int kLong = 4, kWide = 3;  ///< its size along the way from one to the other, and across

float bounded(float x, float low, float high)
{
  return x < low ? low : (x > high ? high : x);
}

/// What is seen of the first pixel's id about a pair.
class Window {
 public:
  Window(const SurfaceLayers& layers, const IdPair& pair)
      : layers_(layers), pair_(pair), first_(layers.indexOf(pair.x, pair.y))
  {
    second_ = first_ + (pair.isToRight ? 1 : layers.stride());
    for (int i = 0; i < kLong; ++i)
      for (int j = 0; j < kWide; ++j)
        share_[i][j] = shareAt(i - kBefore, j - 1);
  }

  Vec2f place()
  {
    float along = 0.0f, across = 0.0f;
    for (int j = 0; j < kWide; ++j)
      along = along + ((share_[2][j] + share_[3][j]) - (share_[0][j] + share_[1][j]));
    for (int i = 0; i < kLong; ++i)
      across = across + (share_[i][2] - share_[i][0]);
    // Both are as long at some 45 degrees, where either way of counting is exact.
    const bool isAlong = std::fabs(along) >= std::fabs(across);
    if ((isAlong ? along : across) > 0.0f) swapIds();
    return isAlong ? placeAlong() : placeAcross();
  }

 private:
  float shareAt(int i, int j) const
  {
    const int x = pair_.x + (pair_.isToRight ? i : j), y = pair_.y + (pair_.isToRight ? j : i);
    const bool isInside = layers_.isInside(x, y);
    const std::size_t index = isInside ? layers_.indexOf(x, y) : first_;
    // Where the surface ends the border is taken to go on straight across.
    if (!isInside || layers_.instance[index] != layers_.instance[first_])
      return i > 0 ? 0.0f : 1.0f;
    const float share =
        static_cast<float>(layers_.idSamples[index]) / static_cast<float>(layers_.count[index]);
    if (layers_.id[index] == layers_.id[first_]) return share;
    return layers_.id[index] == layers_.id[second_] ? 1.0f - share : 0.0f;
  }
  void swapIds()
  {
    for (auto& row : share_)
      for (float& share : row)
        share = 1.0f - share;
  }
  /// A pixel at the window's end that another border has taken.
  static float before(float share) { return share < 0.5f ? 1.0f : share; }
  static float behind(float share) { return share > 0.5f ? 0.0f : share; }

  /// The first id has most of the first pixel and the second of the other, so that a border at 45
  /// degrees or more does not leave the two.
  Vec2f placeAlong() const { return at((share_[1][1] + share_[2][1]) - 0.5f, 0.0f); }
  Vec2f placeAcross() const
  {
    const auto height = [&](int i) {
      return (before(share_[i][0]) + share_[i][1]) + behind(share_[i][2]);
    };
    return at(0.5f, bounded((height(1) + height(2)) * 0.5f - 1.5f, -1.0f, 1.0f));
  }
  Vec2f at(float along, float across) const
  {
    return {static_cast<float>(pair_.x) + 0.5f + (pair_.isToRight ? along : across),
            static_cast<float>(pair_.y) + 0.5f + (pair_.isToRight ? across : along)};
  }

  const SurfaceLayers& layers_;
  const IdPair& pair_;
  std::size_t first_, second_;
  float share_[kLong][kWide];
};

}  // namespace

Vec2f placeOfIdBorder(const SurfaceLayers& layers, const IdPair& pair)
{
  return Window(layers, pair).place();
}

}  // namespace limn
