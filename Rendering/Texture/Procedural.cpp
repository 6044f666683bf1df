// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/Procedural.h"

#include "Rendering/Texture/TextureImage.h"

#include <cmath>

namespace limn {

Status checkProcedural(const ProceduralTexture& texture, const std::string& name)
{
  for (const Vec4f color : {texture.colorA, texture.colorB})
    for (const float channel : {color.x, color.y, color.z, color.w})
      if (!(std::fabs(channel) <= kLargestTexel))
        return {Error::kNotFinite, name + ": a colour is not a number up to 1e27."};
  if (!(texture.scale > 0 && texture.scale <= kMostProcedural))
    return {Error::kNotFinite, name + ": its scale is not above 0 and up to 1e6."};
  if (!(texture.turbulence >= 0 && texture.turbulence <= kMostProcedural))
    return {Error::kNotFinite, name + ": its turbulence is not between 0 and 1e6."};
  return {};
}

namespace procedural_detail {
namespace {

float nearby(float q)
{
  return std::fabs(q) < kFarthest ? q : 0.0f;
}

/// Rises from 0 to 1 without a jump of its first two derivatives.
float faded(float t)
{
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// Of one of the directions to the 12 edges of a cube.
float alongGradient(std::uint32_t hash, Vec3f d)
{
  const std::uint32_t mixed = (hash ^ hash >> 15) * kMultiplier;
  const std::uint32_t edge = mixed >> 28;
  const float u = edge < 8 ? d.x : d.y;
  const float v = edge < 4 ? d.y : edge == 12 || edge == 14 ? d.x : d.z;
  return ((edge & 1) != 0 ? -u : u) + ((edge & 2) != 0 ? -v : v);
}

float mix(float a, float b, float t)
{
  return a + (b - a) * t;
}

}  // namespace

float gradientNoise(Vec3f q)
{
  struct Axis {
    std::uint32_t hash[2];
    float distance[2];
    float weight;
  };
  const auto axis = [](float coordinate, std::uint32_t prime) -> Axis {
    const float at = nearby(coordinate);
    const float cell = std::floor(at);
    const float d = at - cell;
    const std::uint32_t hash = static_cast<std::uint32_t>(static_cast<std::int32_t>(cell)) * prime;
    return {{hash, hash + prime}, {d, d - 1.0f}, faded(d)};
  };
  const Axis x = axis(q.x, kPrime[0]), y = axis(q.y, kPrime[1]), z = axis(q.z, kPrime[2]);
  const auto corner = [&](int i, int j, int k) {
    return alongGradient(x.hash[i] ^ y.hash[j] ^ z.hash[k],
                         {x.distance[i], y.distance[j], z.distance[k]});
  };
  const auto edge = [&](int j, int k) { return mix(corner(0, j, k), corner(1, j, k), x.weight); };
  const auto face = [&](int k) { return mix(edge(0, k), edge(1, k), y.weight); };
  return mix(face(0), face(1), z.weight);
}

float sineOfTurns(float turns)
{
  const float half = turns - std::floor(turns) - 0.5f;
  const float size = std::fabs(half);
  const float x = (size > 0.25f ? 0.5f - size : size) * kTwoPi;
  const float x2 = x * x;
  float series = kSineSeries[5];
  for (int k = 4; k >= 0; --k)
    series = kSineSeries[k] + x2 * series;
  const float sine = x * series;
  return half > 0.0f ? -sine : sine;
}

namespace {

float checker(Vec3f q)
{
  const float cells =
      std::floor(q.x + kShift) + std::floor(q.y + kShift) + std::floor(q.z + kShift);
  return cells - 2.0f * std::floor(cells * 0.5f);
}

float wood(Vec3f q, float turbulence)
{
  float r = std::sqrt(q.x * q.x + q.y * q.y);
  if (turbulence > 0.0f) r = r + turbulence * gradientNoise(q);
  const float w = 1.0f - std::fabs(2.0f * (r - std::floor(r)) - 1.0f);
  return w * w * (3.0f - 2.0f * w);
}

float marble(Vec3f q, float turbulence)
{
  float turns = q.x;
  if (turbulence > 0.0f) {
    float sum = 0.0f, frequency = 1.0f, share = 1.0f;
    for (int k = 0; k < kOctaves; ++k) {
      sum = sum + share * std::fabs(gradientNoise(q * frequency));
      frequency *= 2.0f;
      share *= 0.5f;
    }
    turns = turns + turbulence * sum;
  }
  return 0.5f + 0.5f * sineOfTurns(turns);
}

}  // namespace
}  // namespace procedural_detail

Vec4f proceduralColor(const ProceduralTexture& texture, Vec3f point)
{
  using namespace procedural_detail;
  const Vec3f scaled = point * texture.scale;
  const Vec3f q = {nearby(scaled.x), nearby(scaled.y), nearby(scaled.z)};
  if (texture.kind == ProceduralKind::kChecker)
    return checker(q) > 0.0f ? texture.colorB : texture.colorA;
  const float t = texture.kind == ProceduralKind::kWood ? wood(q, texture.turbulence)
                                                        : marble(q, texture.turbulence);
  return texture.colorA + (texture.colorB - texture.colorA) * t;
}

}  // namespace limn
