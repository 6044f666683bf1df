// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedTextures.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Scene.h"
#include "Rendering/Texture/Procedural.h"
#include "Rendering/Texture/SampleTexture.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

using procedural_detail::gradientNoise;
using procedural_detail::sineOfTurns;

struct Rgb {
  std::uint8_t r, g, b;
};

/// color(x, y) of each texel.
template <class Color>
GeneratedTexture rgbTexture(int width, int height, Color color)
{
  GeneratedTexture texture = {width, height, 3, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Rgb c = color(x, y);
      texture.texels.insert(texture.texels.end(), {c.r, c.g, c.b});
    }
  return texture;
}

std::uint8_t byteOf(float unit)
{
  return static_cast<std::uint8_t>(std::nearbyint(std::clamp(unit, 0.0f, 1.0f) * 255.0f));
}

constexpr int kGlyphColumns = 5, kGlyphRows = 7;
using Glyph = const char*;  ///< rows from the top, one after the other
constexpr Glyph kLetters[8] = {
    " ### #   ##   #######   ##   ##   #", "#### #   ##   ##### #   ##   ##### ",
    " #####    #    #    #    #     ####", "#### #   ##   ##   ##   ##   ##### ",
    "######    #    #### #    #    #####", "######    #    #### #    #    #    ",
    " #####    #    #  ###   ##   # ####", "#   ##   ##   #######   ##   ##   #"};
constexpr Glyph kDigits[8] = {
    "  #   ##    #    #    #    #   ### ", " ### #   #    #  ##  #   #    #####",
    "####     #    # ###     #    ##### ", "   #   ##  # # #  # #####   #    # ",
    "######    ####     #    ##   # ### ", " ### #    #    #### #   ##   # ### ",
    "#####    #   #   #   #    #    #   ", " ### #   ##   # ### #   ##   # ### "};

/// Whether a glyph drawn with its lower left corner at the origin covers a point.
bool covers(Glyph glyph, int x, int y, int size)
{
  if (x < 0 || y < 0 || x >= kGlyphColumns * size || y >= kGlyphRows * size) return false;
  return glyph[(kGlyphRows - 1 - y / size) * kGlyphColumns + x / size] == '#';
}

struct Brick {
  int column, row;
  int x, y;  ///< within it
};
constexpr int kWallSide = 128, kBrickWidth = 32, kBrickHeight = 16;

Brick brickAt(int x, int y)
{
  const int row = y / kBrickHeight;
  const int shifted = (x + (row % 2) * kBrickWidth / 2) % kWallSide;
  return {shifted / kBrickWidth, row, shifted % kBrickWidth, y % kBrickHeight};
}

float brickHeight(int x, int y)
{
  const Brick brick = brickAt(x, y);
  const int edge = std::min(std::min(brick.x, kBrickWidth - 1 - brick.x),
                            std::min(brick.y, kBrickHeight - 1 - brick.y));
  const float t = std::clamp((static_cast<float>(edge) - 0.5f) / 3.0f, 0.0f, 1.0f);
  const float rise = t * t * (3.0f - 2.0f * t);
  const float of = static_cast<float>(7 * brick.column + 3 * brick.row) + 0.37f;
  const Vec3f at = {static_cast<float>(brick.x) / 5, static_cast<float>(brick.y) / 5, of};
  const float own = gradientNoise({of * 1.7f, 0.5f, 0.5f});
  return 0.15f + rise * (0.65f + 0.12f * own + 0.08f * gradientNoise(at));
}

}  // namespace

GeneratedTexture uvGrid()
{
  constexpr int kCells = 8, kCell = 32, kSize = 2;
  return rgbTexture(kCells * kCell, kCells * kCell, [](int x, int y) -> Rgb {
    const int column = x / kCell, row = y / kCell, inX = x % kCell, inY = y % kCell;
    const bool isLine = inX == 0 || inY == 0;
    if (isLine) return {16, 16, 16};
    if (covers(kLetters[column], inX - 5, inY - 9, kSize) ||
        covers(kDigits[row], inX - 5 - (kGlyphColumns + 1) * kSize, inY - 9, kSize))
      return {255, 255, 255};
    return {static_cast<std::uint8_t>(24 + 24 * column), static_cast<std::uint8_t>(24 + 24 * row),
            static_cast<std::uint8_t>((column + row) % 2 == 0 ? 128 : 72)};
  });
}

GeneratedTexture brickHeights()
{
  GeneratedTexture texture = {kWallSide, kWallSide, 1, {}};
  for (int y = 0; y < kWallSide; ++y)
    for (int x = 0; x < kWallSide; ++x)
      texture.texels.push_back(byteOf(brickHeight(x, y)));
  return texture;
}

GeneratedTexture brickNormals()
{
  const GeneratedTexture heights = brickHeights();
  TextureImage image;
  if (!image.build(heights.view(), MipChain::kNone).ok()) return {};
  TextureSampler sampler;
  sampler.filter = TextureFilter::kNearest;
  return rgbTexture(kWallSide, kWallSide, [&](int x, int y) -> Rgb {
    const Vec2f uv = {(static_cast<float>(x) + 0.5f) / kWallSide,
                      (static_cast<float>(y) + 0.5f) / kWallSide};
    const Vec2f slope = heightGradient(image, sampler, uv, {0, 0}, {0, 0}) * kBrickDepth;
    const Vec3f n = normalized(Vec3f{-slope.x, -slope.y, 1.0f});
    return {byteOf(0.5f + 0.5f * n.x), byteOf(0.5f + 0.5f * n.y), byteOf(0.5f + 0.5f * n.z)};
  });
}

GeneratedTexture planet()
{
  constexpr int kWidth = 256, kHeight = 128;
  return rgbTexture(kWidth, kHeight, [](int x, int y) -> Rgb {
    const float longitude = (static_cast<float>(x) + 0.5f) / kWidth;
    const float latitude = (static_cast<float>(y) + 0.5f) / (2 * kHeight) - 0.25f;
    const float radius = sineOfTurns(latitude + 0.25f);
    const Vec3f p = {radius * sineOfTurns(longitude + 0.25f), radius * sineOfTurns(longitude),
                     sineOfTurns(latitude)};
    float height = 0, share = 1, frequency = 1.6f;
    for (int octave = 0; octave < 5; ++octave) {
      height += share * gradientNoise(p * frequency + Vec3f{3.3f, 7.1f, 1.9f});
      share *= 0.5f;
      frequency *= 2;
    }
    if (std::fabs(p.z) + 0.15f * height > 0.93f) return {236, 242, 246};
    if (height < -0.1f) return {14, 48, 104};
    if (height < 0.04f) return {28, 88, 150};
    if (height < 0.07f) return {206, 190, 132};
    if (height < 0.3f) return {66, 122, 56};
    if (height < 0.5f) return {124, 100, 64};
    return {220, 220, 220};
  });
}

GeneratedTexture leadedWindow()
{
  constexpr int kSide = 128, kStep = 32, kBar = 4;
  constexpr Rgba8 kLead = {40, 40, 44, 255}, kBroken = {255, 255, 255, 0};
  constexpr Rgba8 kGlass[] = {
      {210, 40, 30, 150}, {40, 90, 200, 110}, {240, 190, 40, 130}, {50, 150, 70, 90}};
  GeneratedTexture texture = {kSide, kSide, 4, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      // Lozenges are the squares of these two.
      const int rising = (x + y) % kSide, falling = (x - y + kSide) % kSide;
      const bool isLead = rising % kStep < kBar || falling % kStep < kBar;
      const int column = rising / kStep, row = falling / kStep;
      const Rgba8 c = isLead                        ? kLead
                      : (4 * row + column) % 3 == 2 ? kBroken
                                                    : kGlass[(column + 2 * row) % 4];
      texture.texels.insert(texture.texels.end(), {c.r, c.g, c.b, c.a});
    }
  return texture;
}

GeneratedTexture toonRamp()
{
  constexpr int kWidth = 128, kHeight = 64, kInks = 4;
  constexpr Vec3f kInk[kInks] = {
      {0.16f, 0.13f, 0.3f}, {0.55f, 0.23f, 0.27f}, {0.93f, 0.55f, 0.32f}, {1.0f, 0.92f, 0.72f}};
  constexpr Vec3f kWash = {0.8f, 0.84f, 0.88f};
  return rgbTexture(kWidth, kHeight, [&](int x, int y) -> Rgb {
    const float detail = (static_cast<float>(y) + 0.5f) / kHeight;
    const float share = detail * detail * (3.0f - 2.0f * detail);
    const Vec3f color = kInk[x * kInks / kWidth] * share + kWash * (1.0f - share);
    return {byteOf(color.x), byteOf(color.y), byteOf(color.z)};
  });
}

GeneratedTexture litSphere()
{
  constexpr int kSide = 128;
  const Vec3f key = normalized(Vec3f{-0.5f, 0.7f, 0.6f}), fill = normalized(Vec3f{0.8f, -0.5f, 0});
  const Vec3f halfway = normalized(key + Vec3f{0, 0, 1});
  const auto positive = [](float value) { return value > 0 ? value : 0; };
  return rgbTexture(kSide, kSide, [&](int x, int y) -> Rgb {
    const auto across = [](int i) { return (static_cast<float>(i) + 0.5f) * (2.0f / kSide) - 1; };
    const float squared = across(x) * across(x) + across(y) * across(y);
    // The corners, which no normal reads, are the border's.
    const Vec3f n =
        normalized(Vec3f{across(x), across(y), squared < 1 ? std::sqrt(1 - squared) : 0.0f});
    const float rim = positive(1 - n.z);
    Vec3f color = Vec3f{0.2f, 0.11f, 0.1f} + Vec3f{0.62f, 0.36f, 0.24f} * positive(dot(n, key));
    color = color + Vec3f{0.1f, 0.2f, 0.35f} * (positive(dot(n, fill)) * rim * 1.6f);
    color = color + Vec3f{1.0f, 0.95f, 0.85f} * (0.6f * power(positive(dot(n, halfway)), 64));
    return {byteOf(color.x), byteOf(color.y), byteOf(color.z)};
  });
}

}  // namespace limn
