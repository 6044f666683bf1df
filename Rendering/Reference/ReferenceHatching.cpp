// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceHatching.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Reference/ReferenceTone.h"
#include "Rendering/Texture/TonalArtMap.h"

#include <cmath>

namespace limn::reference {
namespace {

constexpr int kSide = TonalArtMap::kSide;

float bounded(float x, float low, float high)
{
  return x > low ? (x < high ? x : high) : low;
}

/// One coordinate's part in four texels: two of the finer level, then two of the coarser.
struct Taps {
  int texel[4];
  float weight[4];
};

/// The two texels about a coordinate at a level of texels of the size 2^octave.
void tap(float coordinate, float octave, float share, int* texel, float* weight)
{
  const float pictures = coordinate * std::ldexp(1.0f, -static_cast<int>(octave) - 7);
  const float place = bounded(pictures - std::floor(pictures), 0.0f, 1.0f) * 128.0f - 0.5f;
  const float left = std::floor(place), fraction = place - left;
  const int first = static_cast<int>(left);
  texel[0] = (first + kSide) % kSide;
  texel[1] = (first + 1) % kSide;
  weight[0] = share * (1.0f - fraction);
  weight[1] = share * fraction;
}

/// The coarser level's share grows with the logarithm of a texel's size.
Taps tapsOf(ScreenValues coordinate, float spacing)
{
  static_assert(kSide == 128, "2^7");
  const float texelsPerPixel =
      slopeOf(coordinate) * (spacing * (1.0f / static_cast<float>(TonalArtMap::kQuarterSpacing)));
  const float octave = power_detail::log2Normal(bounded(texelsPerPixel, 1e-30f, 1e30f));
  const float finer = std::floor(octave), coarser = octave - finer;
  Taps taps;
  tap(coordinate.here, finer, 1.0f - coarser, taps.texel, taps.weight);
  tap(coordinate.here, finer + 1.0f, coarser, taps.texel + 2, taps.weight + 2);
  return taps;
}

/// The tone, 0 to kTones, that has so much ink, between those of the map.
float toneOf(float darkness)
{
  const TonalArtMap& map = tonalArtMap();
  float tone = 0.0f;
  for (int k = 0; k < TonalArtMap::kTones; ++k)
    tone = tone + bounded((darkness - map.coverage(k)) * map.perCoverage(k), 0.0f, 1.0f);
  return tone;
}

float inkOf(const Taps& u, const Taps& v, float tone)
{
  float ink = 0.0f;
  for (int y = 0; y < 4; ++y) {
    float row = 0.0f;
    for (int x = 0; x < 4; ++x) {
      const auto first = static_cast<float>(tonalArtMap().firstTone(u.texel[x], v.texel[y]));
      row = row + u.weight[x] * bounded((tone + 1.0f) - first, 0.0f, 1.0f);
    }
    ink = ink + v.weight[y] * row;
  }
  return ink;
}

/// How near the surface is to a plane of two axes, by the third component of its normal.
float nearness(float component)
{
  const float excess = bounded(component * component - 0.2f, 0.0f, 1.0f);
  return excess * excess;
}

}  // namespace

float hatchInModel(const HatchPositions& position, Vec3f normal, HatchTone how)
{
  const float tone = toneOf(how.darkness);
  const auto taps = [&](auto coordinate) {
    return tapsOf(
        {coordinate(position.here), coordinate(position.right), coordinate(position.above)},
        how.spacing);
  };
  const Taps rows = taps([](Vec3f p) { return (p.x + p.y) + p.z; });
  const float x = nearness(normal.x), y = nearness(normal.y), z = nearness(normal.z);
  const float sum = (x + y) + z, share = sum > 0.0f ? 1.0f / sum : 0.0f;
  float ink = 0.0f;
  if (x > 0.0f)
    ink = ink + (x * share) * inkOf(taps([](Vec3f p) { return p.y - p.z; }), rows, tone);
  if (y > 0.0f)
    ink = ink + (y * share) * inkOf(taps([](Vec3f p) { return p.z - p.x; }), rows, tone);
  if (z > 0.0f)
    ink = ink + (z * share) * inkOf(taps([](Vec3f p) { return p.x - p.y; }), rows, tone);
  return ink;
}

float hatchByTexture(const HatchCoordinates& uv, HatchTone how)
{
  const Taps u = tapsOf({uv.here.x, uv.right.x, uv.above.x}, how.spacing);
  const Taps v = tapsOf({uv.here.y, uv.right.y, uv.above.y}, how.spacing);
  return inkOf(u, v, toneOf(how.darkness));
}

}  // namespace limn::reference
