// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ImageOutline.h"

namespace limn {

/// Rounded to nearest even, as std::nearbyint, which is a call on older processors.
inline std::uint8_t toByte(float x)
{
  constexpr float kUnit = 12582912.0f;  // 1.5 * 2^23: floats from there on are whole
  const float bounded = x > 0.0f ? (x < 255.0f ? x : 255.0f) : 0.0f;
  return static_cast<std::uint8_t>((bounded + kUnit) - kUnit);
}

inline float boundedRadiance(float x)
{
  return x > 0.0f ? (x < kMaxRadiance ? x : kMaxRadiance) : 0.0f;
}

/// One channel of a pixel, and of those of its samples that change.
struct ChannelChange {
  std::uint8_t pixel, from, to;
};

/// The channel of the pixel, a mean of `shared` samples, after `samples` of them have changed.
std::uint8_t changed(ChannelChange c, double samples, int shared, Resolve resolve);

/// What of a pixel are samples that its layer has not.
struct RestOfPixel {
  int count, shared;  ///< SurfaceLayer's; count < shared
  Resolve resolve;

  /// Their mean, of a channel of the pixel and of the layer.
  std::uint8_t of(std::uint8_t pixel, std::uint8_t own) const;
  /// Likewise, of radiance; >= 0.
  float ofRadiance(float pixel, float own) const;
};

/// Gives a share of a pixel, which is its layer's, the colour of the layer's line: as if that share
/// of the pixel's samples had it. Requires: 0 < share <= count of the layer / samples.
void paintLine(const OutlinePass& pass, int x, int y, float share);

/// The same of the surfaces that share the layer's pixel, with the line of the first of them.
/// Requires: 0 < share <= (covered - count) / samples. Before paintLine() of that pixel.
void paintLineBehind(const OutlinePass& pass, int x, int y, float share);

}  // namespace limn
