// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"

#include <cstdint>

namespace limn {

inline constexpr int kMaxSamples = 16;
inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;  ///< per pixel, in x and in y

/// Offset from the pixel's lower left corner, in subpixels.
struct SampleOffset {
  std::int32_t x, y;
};

inline constexpr SampleOffset kPixelCentre = {kSubpixels / 2, kSubpixels / 2};

/// Direct3D's standard patterns, with their offsets read upwards as OpenGL's rasterizers (llvmpipe
/// among them) do in a window whose y points up. The mean of the samples is the centre, but with 16
/// of them, where it is 1/32 of a pixel to the left and below; some of those lie on these two
/// borders. Requires: samples is 1, 2, 4, 8 or 16.
inline Span<const SampleOffset> samplePositions(int samples)
{
  static constexpr SampleOffset k1[] = {kPixelCentre};
  static constexpr SampleOffset k2[] = {{192, 192}, {64, 64}};
  static constexpr SampleOffset k4[] = {{96, 32}, {224, 96}, {32, 160}, {160, 224}};
  static constexpr SampleOffset k8[] = {{144, 80}, {112, 176}, {208, 144}, {80, 48},
                                        {48, 208}, {16, 112},  {176, 240}, {240, 16}};
  static constexpr SampleOffset k16[] = {
      {144, 144}, {112, 80}, {80, 160}, {192, 112}, {48, 96}, {160, 208}, {208, 176}, {176, 48},
      {96, 224},  {128, 16}, {64, 32},  {32, 192},  {0, 128}, {240, 64},  {224, 240}, {16, 0}};
  switch (samples) {
    case 16:
      return {k16, 16};
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
