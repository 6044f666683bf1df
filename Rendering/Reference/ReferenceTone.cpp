// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceTone.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Texture/SampleTexture.h"
#include "Rendering/Vertex/ClippingRange.h"

#include <cmath>

namespace limn::reference {
namespace {

/// Keeps what does not change exact.
constexpr float kLeastSlope = 1e-6f;

float bounded(float x, float low, float high)
{
  return x > low ? (x < high ? x : high) : low;
}

/// To 7e-5 (Abramowitz and Stegun 1964, 4.4.45).
float arcCosine(float x)
{
  const float a = bounded(std::fabs(x), 0.0f, 1.0f);
  const float series = 1.5707288f + a * (-0.2121144f + a * (0.0742610f + a * -0.0187293f));
  const float angle = std::sqrt(1.0f - a) * series;
  return x < 0.0f ? 3.14159265f - angle : angle;
}

/// In stripes, 0 to kMetalStripes.
float acrossStripes(float cosine)
{
  return arcCosine(cosine) * (static_cast<float>(kMetalStripes) / 3.14159265f);
}

float greyOf(int stripe)
{
  std::uint32_t bits = static_cast<std::uint32_t>(stripe + 1) * 2654435761u;
  bits = bits ^ (bits >> 16);
  bits = bits * 2246822519u;
  bits = bits ^ (bits >> 13);
  return static_cast<float>(bits >> 8) * (0.5f / 16777216.0f);
}

}  // namespace

float slopeOf(ScreenValues values)
{
  const float x = values.right - values.here, y = values.above - values.here;
  return std::sqrt(x * x + y * y);
}

float smoothStep(float x)
{
  const float t = bounded(x, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float stepped(float t, float slope, int bands)
{
  const auto n = static_cast<float>(bands);
  const float edge = std::nearbyint(bounded(t * n, 1.0f, n - 1.0f));
  // Not wider than a band: steps that are less than a pixel wide meet halfway.
  const float pixel = bounded(slope < 1.0f / n ? slope : 1.0f / n, kLeastSlope, 1.0f);
  return ((edge - 1.0f) + smoothStep((t - edge / n) / pixel + 0.5f)) / (n - 1.0f);
}

float onOff(float highlight, float slope)
{
  return smoothStep((highlight - 0.5f) / bounded(slope, kLeastSlope, 1.0f) + 0.5f);
}

float evenLine(ScreenValues g, float f, float width)
{
  const float curvature = f * slopeOf(g);
  const float distance =
      (g.here * g.here) / (2.0f * (curvature > kLeastSlope ? curvature : kLeastSlope));
  return bounded((width + 0.5f) - distance, 0.0f, 1.0f);
}

float metalGrey(Vec3f n, Vec3f l)
{
  constexpr float kLast = static_cast<float>(kMetalStripes - 1);
  const float light = std::floor(bounded(acrossStripes(l.x), 0.0f, kLast));
  const float place = bounded(acrossStripes(n.x) - 0.5f, 0.0f, kLast);
  const float left = std::floor(place), fraction = place - left;
  const float right = bounded(left + 1.0f, 0.0f, kLast);
  const auto grey = [&](float stripe) {
    return stripe == light ? 1.0f : greyOf(static_cast<int>(stripe));
  };
  return grey(left) + (grey(right) - grey(left)) * fraction;
}

float exaggerated(const Exaggeration& exaggeration, const ExaggeratedPoint& point)
{
  const float p = exaggeration.exponent;
  const float step = p < 0.0f ? 1.0f / power(point.ratio, -p) : power(point.ratio, p);
  float k[kMaxSmoothLevels] = {}, sum = 0.0f, next = 1.0f;
  for (std::size_t i = 0; i < point.smooth.size(); ++i) {
    k[i] = next;
    sum = sum + next;
    next = next * step;
  }
  float c = 0.0f;
  Vec3f n = point.n;
  for (std::size_t i = 0; i < point.smooth.size(); ++i) {
    const Vec3f coarser = point.smooth[i];
    const Vec3f across = point.l - coarser * dot(coarser, point.l);
    const float length = std::sqrt(dot(across, across));
    const Vec3f grazing = across * (1.0f / (length > kLeastGrazing ? length : kLeastGrazing));
    const float a = exaggeration.contrast * dot(n, grazing);
    const float bounded = a > -1.0f ? (a < 1.0f ? a : 1.0f) : -1.0f;
    c = c + (k[i] / sum * (1.0f - exaggeration.base)) * (0.5f + 0.5f * bounded);
    n = coarser;
  }
  return c + exaggeration.base * (0.5f + 0.5f * dot(n, point.l));
}

float rampDetail(const ToneRamp& ramp, const Camera& camera, const DetailOf& point)
{
  switch (ramp.detail) {
    case RampDetail::kSilhouette:
      return power(std::fabs(point.nv), ramp.exponent);
    case RampDetail::kHighlight:
      return power(point.rv > 0.0f ? point.rv : 0.0f, ramp.exponent);
    default: {
      const DepthRange range = depthRangeOf(ramp, camera);
      const float octaves = 1.0f / power_detail::log2Normal(range.farthest / range.nearest);
      const float z = bounded(point.depth, range.nearest, range.farthest);
      return 1.0f - power_detail::log2Normal(z / range.nearest) * octaves;
    }
  }
}

Vec3f rampColor(const ToneRamp& ramp, float u, float v)
{
  TextureSampler sampler;
  sampler.wrapU = sampler.wrapV = TextureWrap::kClamp;
  const Vec4f color = sampleTexture(*ramp.image, sampler, {u, v}, {0, 0}, {0, 0});
  return {color.x, color.y, color.z};
}

Vec3f matCapColor(const ToneRamp& ramp, Vec3f n, Vec3f v)
{
  const Vec3f right = normalized(Vec3f{v.z, 0.0f, -v.x});
  const Vec3f up = cross(v, right);
  return rampColor(ramp, 0.5f + 0.5f * dot(n, right), 0.5f + 0.5f * dot(n, up));
}

}  // namespace limn::reference
