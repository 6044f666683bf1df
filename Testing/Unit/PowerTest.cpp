// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/Power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

/// Error of power(x, p) in units of its documented bound.
double errorInBounds(float x, float p)
{
  const double exact = std::pow(static_cast<double>(x), static_cast<double>(p));
  const double bound = squaringsFor(p) >= 0
                           ? p * 6e-8
                           : 2e-7 * (1 + p * std::fabs(std::log2(static_cast<double>(x))));
  return std::fabs(power(x, p) - exact) / exact / bound;
}

TEST(Power, StaysWithinItsDocumentedErrorOnTheWholeUnitInterval)
{
  double worst = 0;
  for (const float p : {0.01f, 0.5f, 1.0f, 2.0f, 2.2f, 10.0f, 33.3f, 128.0f, 1000.0f, 1024.0f})
    for (int i = 1; i <= 100000; ++i) {
      const float x = static_cast<float>(i) / 100000;
      if (p * std::log2(x) < -125.99f) continue;
      worst = std::max(worst, errorInBounds(x, p));
    }
  EXPECT_LT(worst, 1);
  EXPECT_GT(worst, 0.05) << "a bound 20 times too wide says nothing";
}

TEST(Power, StaysWithinItsDocumentedErrorOverAllMagnitudes)
{
  double worst = 0;
  for (double e = -37.5; e < 38; e += 0.0013)
    for (const float p : {0.25f, 1.0f, 1.5f, 3.0f}) {
      const float x = static_cast<float>(std::pow(10, e));
      if (std::fabs(p * std::log2(x)) > 125.9f) continue;
      worst = std::max(worst, errorInBounds(x, p));
    }
  EXPECT_LT(worst, 1);
}

TEST(Power, StaysWithinItsDocumentedErrorForLargeExponents)
{
  double worst = 0;
  for (const float p : {64.0f, 100.5f, 512.0f, 1023.0f, 2048.0f, 12345.6f, 1e5f, 1e6f})
    for (int i = 1; i <= 20000; ++i) {
      // Down to the smallest normal result.
      const auto x = static_cast<float>(std::exp2(-125.9 * i / 20000 / static_cast<double>(p)));
      worst = std::max(worst, errorInBounds(x, p));
    }
  EXPECT_LT(worst, 1.0);
}

TEST(Power, HasItsDocumentedCorners)
{
  for (const float x : {-1.0f, 0.0f, 1e-40f, 0.5f, 1.0f, 7.0f})
    EXPECT_EQ(power(x, 0), 1.0f) << x;
  for (const float x : {-1.0f, 0.0f, 1e-40f})
    EXPECT_EQ(power(x, 2), 0.0f) << x;
  for (const float p : {0.1f, 1.0f, 1e6f})
    EXPECT_EQ(power(1, p), 1.0f) << p;
  EXPECT_EQ(power(0.5f, 127), 0.0f) << "below 2^-126";
  EXPECT_EQ(power(0.5f, 126), 0x1p-126f);
  EXPECT_EQ(power(2, 500), 0x1p127f);
  EXPECT_EQ(power(std::numeric_limits<float>::quiet_NaN(), 2), 0.0f);
}

TEST(Power, SquaresForExponentsThatArePowersOfTwo)
{
  for (int k = 0; k <= 10; ++k)
    for (const float x : {0.3f, 0.77f, 0.999f, 1.0f}) {
      float product = x;
      for (int i = 0; i < k; ++i)
        product *= product;
      EXPECT_EQ(power(x, static_cast<float>(1 << k)), product) << x << ' ' << k;
    }
  EXPECT_EQ(squaringsFor(1), 0);
  EXPECT_EQ(squaringsFor(1024), 10);
  for (const float p : {0.0f, 0.5f, 3.0f, 2048.0f})
    EXPECT_EQ(squaringsFor(p), -1) << p;
}

TEST(Power, PowersOfTwoAreExact)
{
  for (int e = -60; e <= 60; ++e)
    EXPECT_EQ(power(std::ldexp(1.0f, e), 2), std::ldexp(1.0f, 2 * e));
}

TEST(CosineOfDegrees, IsWithin1e15OfTheCosine)
{
  constexpr long double kPi = 3.14159265358979323846264338327950288L;
  double worst = 0;
  for (int i = 0; i <= 180 * 64; ++i) {
    const double degrees = i / 64.0;
    const long double exact = std::cos(static_cast<long double>(degrees) * kPi / 180);
    worst = std::max(worst, static_cast<double>(std::fabs(cosineOfDegrees(degrees) - exact)));
  }
  EXPECT_LT(worst, 1e-15);
  EXPECT_EQ(cosineOfDegrees(0), 1);
  EXPECT_EQ(cosineOfDegrees(180), -1);
}

}  // namespace
}  // namespace limn
