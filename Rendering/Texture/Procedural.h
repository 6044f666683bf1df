// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Base/Vec.h"

#include <cstdint>
#include <string>

/// Textures that are computed instead of read ("procedural", seed 003), unfiltered.
/// Procedural-inl.h has the vector form with the same operations in the same order.
namespace limn {

enum class ProceduralKind : std::uint8_t {
  /// Cells of side 1; colorA where the sum of the cell's numbers floor(q + 2^-12) is even. The
  /// shift
  /// keeps faces that lie at whole numbers in one cell.
  kChecker,
  /// Rings about the z axis: r = |(q.x, q.y)| + turbulence noise(q), a ring each unit, colorA at
  /// its
  /// borders and colorB in its middle, by 3w^2 - 2w^3 of the triangle wave w (Peachey 1985, Perlin
  /// 1985).
  kWood,
  /// Veins: sin(2 pi (q.x + turbulence sum |noise(2^k q)| / 2^k)), k = 0 ... 4, from colorA at -1
  /// to
  /// colorB at 1 (Perlin 1985, An Image Synthesizer).
  kMarble,
};

/// What a procedural texture reads at a fragment.
enum class ProceduralSpace : std::uint8_t {
  kUv,      ///< (u, v, 0)
  kObject,  ///< the position in the model's own coordinates
};

/// A function of q = scale times a point.
struct ProceduralTexture {
  ProceduralKind kind = ProceduralKind::kChecker;
  ProceduralSpace space = ProceduralSpace::kObject;
  Vec4f colorA = {1, 1, 1, 1}, colorB = {0, 0, 0, 1};
  float scale = 1;       ///< periods per unit of the space
  float turbulence = 0;  ///< how far noise moves rings and veins, in periods; not for kChecker
};

/// The largest scale and turbulence.
inline constexpr float kMostProcedural = 1e6f;

/// Errors: kNotFinite for a colour that is not a number up to kLargestTexel, a scale that is not
/// above 0 or above kMostProcedural, a turbulence that is not between 0 and that; the message
/// begins with `name`.
Status checkProcedural(const ProceduralTexture& texture, const std::string& name);

/// RGBA at a point of the texture's space. All points are allowed: a coordinate of q that is not
/// finite, or 2^30 or more, counts as 0. Requires: the texture is checked.
Vec4f proceduralColor(const ProceduralTexture& texture, Vec3f point);

namespace procedural_detail {

inline constexpr float kFarthest = 1 << 30;
inline constexpr float kShift = 1.0f / 4096;
inline constexpr int kOctaves = 5;
/// Of a lattice point, the primes of Teschner et al. 2003, Optimized Spatial Hashing, and a product
/// that carries them into the upper bits.
inline constexpr std::uint32_t kPrime[3] = {73856093u, 19349663u, 83492791u};
inline constexpr std::uint32_t kMultiplier = 0x2C1B3C6Du;
/// Of sin x / x in x^2.
inline constexpr float kSineSeries[6] = {
    1.0f, -0.166666672f, 8.33333377e-3f, -1.98412701e-4f, 2.75573188e-6f, -2.50521079e-8f};
inline constexpr float kTwoPi = 6.28318548f;

/// Gradient noise (Perlin 2002, Improving Noise) on an integer hash instead of a table: 0 on whole
/// numbers, within -1.05 and 1.05 elsewhere. Far points as in proceduralColor().
float gradientNoise(Vec3f q);

/// sin(2 pi turns), to 3e-7, for finite numbers.
float sineOfTurns(float turns);

}  // namespace procedural_detail
}  // namespace limn
