// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"

#include <cstdint>

namespace limn {

inline constexpr int kMaxSamples = 8;
inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;  ///< per pixel, in x and in y

/// Offset from the pixel's lower left corner, in subpixels.
struct SampleOffset {
  std::int32_t x, y;
};

inline constexpr SampleOffset kPixelCentre = {kSubpixels / 2, kSubpixels / 2};

/// Direct3D's standard patterns, with their offsets read upwards as OpenGL's rasterizers (llvmpipe
/// among them) do in a window whose y points up. In each the mean of the samples is the centre.
/// Requires: samples is 1, 2, 4 or 8.
inline Span<const SampleOffset> samplePositions(int samples)
{
  static constexpr SampleOffset k1[] = {kPixelCentre};
  static constexpr SampleOffset k2[] = {{192, 192}, {64, 64}};
  static constexpr SampleOffset k4[] = {{96, 32}, {224, 96}, {32, 160}, {160, 224}};
  static constexpr SampleOffset k8[] = {{144, 80}, {112, 176}, {208, 144}, {80, 48},
                                        {48, 208}, {16, 112},  {176, 240}, {240, 16}};
  switch (samples) {
    case 8:
      return {k8, 8};
    case 4:
      return {k4, 4};
    case 2:
      return {k2, 2};
    default:
      return {k1, 1};
  }
}

}  // namespace limn
