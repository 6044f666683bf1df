// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

/// Powers and a cosine made of + - * / only, so that they give the same bits everywhere; libm's do
/// not (facts: it picks other code on CPUs with FMA). Power-inl.h has the vector form of
/// power() with the same operations in the same order.
namespace limn {

namespace power_detail {

/// log2(m) = s (c0 + s^2 (c1 + ...)), s = (m-1)/(m+1): the series of 2/ln2 atanh(s). Left-out terms
/// are below 4e-10 for m in [sqrt(1/2), sqrt(2)].
inline constexpr float kLog2Series[5] = {2.885390082f, 0.961796694f, 0.577078016f, 0.412198583f,
                                         0.320598898f};
/// 2^f = 1 + f (e1 + f (e2 + ...)), e_k = ln2^k / k!; left-out terms below 6e-9 for |f| <= 1/2.
inline constexpr float kExp2Series[7] = {0.693147181f,    0.240226507f,   0.0555041087f,
                                         0.00961812911f,  0.00133335581f, 0.000154035304f,
                                         0.0000152527338f};
inline constexpr float kSmallestNormal = 1.17549435e-38f;
inline constexpr std::int32_t kSqrtHalfBits = 0x3F3504F3;

inline std::int32_t bitsOf(float value)
{
  std::int32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}
inline float floatOf(std::int32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Requires: x a positive normal number. Error below 2e-7 relative to the result.
inline float log2Normal(float x)
{
  const std::int32_t bits = bitsOf(x);
  const std::int32_t exponent = (bits - kSqrtHalfBits) >> 23;
  const float mantissa = floatOf(bits - exponent * (1 << 23));
  const float f = mantissa - 1.0f;
  const float s = f / (f + 2.0f);
  const float s2 = s * s;
  const float series =
      kLog2Series[0] +
      s2 * (kLog2Series[1] + s2 * (kLog2Series[2] + s2 * (kLog2Series[3] + s2 * kLog2Series[4])));
  return static_cast<float>(exponent) + s * series;
}

/// 0 below 2^-126 and 2^127 above that. Relative error below 2e-7.
inline float exp2Clamped(float y)
{
  if (!(y >= -126.0f)) return 0.0f;
  const float bounded = y < 127.0f ? y : 127.0f;
  const float whole = std::nearbyint(bounded);
  const float f = bounded - whole;
  const float series =
      kExp2Series[0] +
      f * (kExp2Series[1] +
           f * (kExp2Series[2] +
                f * (kExp2Series[3] +
                     f * (kExp2Series[4] + f * (kExp2Series[5] + f * kExp2Series[6])))));
  const float scale = floatOf((static_cast<std::int32_t>(whole) + 127) * (1 << 23));
  return (1.0f + f * series) * scale;
}

}  // namespace power_detail

/// How often x has to be squared for x^p; -1 if p is not one of 1, 2, 4 ... 1024.
inline int squaringsFor(float p)
{
  const std::int32_t bits = power_detail::bitsOf(p);
  if ((bits & 0x7FFFFF) != 0) return -1;
  const std::int32_t exponent = (bits >> 23) - 127;
  return exponent >= 0 && exponent <= 10 ? exponent : -1;
}

/// x^p for p >= 0; 0 for x <= 0 and for denormal x, but x^0 = 1 always. Relative error below
/// 2e-7 (1 + p |log2 x|), or p 6e-8 for powers of two up to 1024, which are made by squaring.
inline float power(float x, float p)
{
  if (p == 0.0f) return 1.0f;
  if (!(x >= power_detail::kSmallestNormal)) return 0.0f;
  const int squarings = squaringsFor(p);
  if (squarings < 0) return power_detail::exp2Clamped(p * power_detail::log2Normal(x));
  for (int i = 0; i < squarings; ++i)
    x = x * x;
  return x;
}

/// Cosine of an angle of 0 to 180 degrees, to 1e-15: the Taylor series about 0, folded at 90.
inline double cosineOfDegrees(double degrees)
{
  if (degrees > 90.0) return -cosineOfDegrees(180.0 - degrees);
  const double radians = degrees * (3.14159265358979323846 / 180.0);
  const double x2 = radians * radians;
  double sum = 1.0;
  for (int k = 11; k >= 1; --k)
    sum = 1.0 - sum * x2 / (2.0 * k * (2.0 * k - 1.0));
  return sum;
}

/// Angle in radians, 0 to pi, of a vector along (cosine, sine) of any length, sine >= 0, to 1e-12:
/// three times halved, then the arc tangent's Taylor series. 0 for the zero vector.
inline double angleOf(double cosine, double sine)
{
  // Without branches, as angles above a right one come as they will.
  const double size = std::fabs(cosine);
  double tangent = sine / (size + std::sqrt(size * size + sine * sine));
  for (int i = 0; i < 2; ++i)
    tangent = tangent / (1.0 + std::sqrt(1.0 + tangent * tangent));
  const double t2 = tangent * tangent;
  double sum = 0.0;
  for (int k = 15; k >= 1; k -= 2)
    sum = 1.0 / k - t2 * sum;
  const double acute = sine == 0.0 ? 0.0 : 8.0 * tangent * sum;
  return cosine < 0.0 ? 3.14159265358979323846 - acute : acute;
}

}  // namespace limn
