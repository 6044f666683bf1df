// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

inline constexpr int kMaxImageSide = 16384;
inline constexpr std::uint32_t kNobody = 0xFFFFFFFFu;

enum class Background : std::uint8_t {
  /// Samples that show nothing keep the pixel's old colour, and the average of all is written.
  kBlend,
  /// The average of the covered samples is written, with alpha 255; `coverage` tells how many.
  kKeepApart,
};

/// What render() writes to a frame before it draws, for frames whose old content is of no account:
/// cheaper than clearing them first. Clears the planes that name things and the coverage too, to
/// kNobody and 0, and the normals to (0, 0, 0). An error clears nothing.
struct FrameClear {
  enum class Extent : std::uint8_t {
    kNothing,
    kTouched,  ///< at least the pixels of RenderStats::touched; the others are not touched
    kAll,
  };
  Extent extent = Extent::kNothing;
  Rgba8 color = {0, 0, 0, 0};
  float depth = 1;  ///< 0 to 1
};

/// Planes of colour before it is clamped and rounded to bytes, for post effects: full intensity is
/// 1, values are 0 to kMaxRadiance (larger ones become that, and what is not a number 0).
struct RadianceView {
  float* r = nullptr;
  float* g = nullptr;
  float* b = nullptr;

  bool empty() const { return r == nullptr; }
};
/// Planes of unit vectors in view space: right, up, towards the eye.
struct NormalView {
  float* x = nullptr;
  float* y = nullptr;
  float* z = nullptr;

  bool empty() const { return x == nullptr; }
};
/// The largest half float, which bounds the render targets of graphics cards too.
inline constexpr float kMaxRadiance = 65504;

/// Pixels [x0, x1) x [y0, y1); empty if x0 >= x1.
struct PixelRectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// What lines lay over those samples of a pixel that show no instance, for a host that knows what
/// lies behind these: it makes C into color + C (1 - alpha), where C is not nearer than `depth`.
struct LinePixel {
  std::uint16_t x, y;
  Rgba8 color;  ///< multiplied by its alpha, the share of the samples that is the lines'; not 0
  float depth;  ///< of the nearest of the lines
  std::uint8_t samples;  ///< bit s set: for sample s, which `coverage` has not
};

/// Where a picture goes: borrowed rows, row 0 at the bottom, as glReadPixels has it. The scene is
/// drawn over what the frame holds: `color` and `depth` are read and written.
struct FrameView {
  int width = 0, height = 0;
  std::ptrdiff_t rowStride = 0;  ///< elements from a row to the next, in every plane
  Rgba8* color = nullptr;
  /// Window depth in [0, 1], 0 near. A sample is drawn where it is not behind the old depth; the
  /// nearest sample's depth is written.
  float* depth = nullptr;
  /// Bit s set: sample s shows an instance. May be null, and has to be with 16 samples.
  std::uint8_t* coverage = nullptr;
  std::uint32_t* instance = nullptr;  ///< Instance::id of the nearest sample; may be null
  std::uint32_t* cell = nullptr;      ///< cell of the nearest sample; may be null
  Background background = Background::kBlend;
  /// May be null; read with Background::kKeepApart and `coverage` alone. Lines cover whole samples
  /// then where they cover all of a pixel, and what else they do to samples that show nothing is
  /// put in here, as bytes alone and in any order that is always the same: at most one a pixel.
  /// Null: they cover the number of samples that is nearest to their share.
  std::vector<LinePixel>* linePixels = nullptr;
  FrameClear clear;
  /// All three or none. Read and written as `color` is, but for the mean of a pixel's samples,
  /// which is linear here: the sum over the triangles seen, in the order of their first samples, of
  /// colour times number of samples, and the old value likewise where Background::kBlend asks for
  /// it.
  RadianceView radiance;
  /// All three or none. The normal of the triangle of the nearest sample, where that is shaded and
  /// as it is shaded, turned to the eye with its face, but without the bumps of textures.
  NormalView normal = {};
};
// Pixels that show no instance keep their old values, or those of `clear`, in every plane.

}  // namespace limn
