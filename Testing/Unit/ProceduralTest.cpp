// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/Procedural.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace limn {
namespace {

using procedural_detail::gradientNoise;
using procedural_detail::sineOfTurns;

constexpr Vec4f kA = {0.25f, 0.5f, 1, 1}, kB = {0.75f, 0, 0, 0.5f};

ProceduralTexture textureOf(ProceduralKind kind, float scale = 1, float turbulence = 0)
{
  return {kind, ProceduralSpace::kObject, kA, kB, scale, turbulence};
}

float within(std::mt19937& random, float low, float high)
{
  return low + (high - low) * (static_cast<float>(random() >> 8) / (1 << 24));
}

TEST(Checker, AlternatesFromCellToCell)
{
  const ProceduralTexture texture = textureOf(ProceduralKind::kChecker, 4);
  for (int z = -3; z < 3; ++z)
    for (int y = -3; y < 3; ++y)
      for (int x = -3; x < 3; ++x)
        for (const float within : {0.0f, 0.5f, 0.99f}) {
          const Vec3f p = {(float(x) + within) / 4, (float(y) + within) / 4,
                           (float(z) + within) / 4};
          EXPECT_EQ(proceduralColor(texture, p), ((x + y + z) & 1) == 0 ? kA : kB)
              << x << ' ' << y << ' ' << z;
        }
}

TEST(Checker, IsWholeOnFacesAtWholeNumbers)
{
  const ProceduralTexture texture = textureOf(ProceduralKind::kChecker);
  for (const float face : {0.0f, 1.0f, -1.0f, 7.0f})
    for (const float noise : {-1e-5f, 0.0f, 1e-5f})
      EXPECT_EQ(proceduralColor(texture, {0.5f, 0.5f, face + noise}),
                proceduralColor(texture, {0.5f, 0.5f, face}));
}

TEST(Sine, IsWithin3e7OfTheSine)
{
  double worst = 0;
  for (int i = -40000; i <= 40000; ++i) {
    const float turns = static_cast<float>(i) / 8192;
    const double exact = std::sin(2 * 3.14159265358979323846 * double{turns});
    worst = std::max(worst, std::fabs(double{sineOfTurns(turns)} - exact));
  }
  EXPECT_LT(worst, 3e-7);
  EXPECT_GT(worst, 3e-8) << "a bound ten times too wide says little";
  EXPECT_EQ(sineOfTurns(0), 0.0f);
  EXPECT_EQ(sineOfTurns(1e9f), 0.0f);
}

TEST(GradientNoise, IsZeroOnWholeNumbersAndFarAway)
{
  for (int i = -20; i < 20; ++i)
    EXPECT_EQ(gradientNoise({float(i), float(3 * i), float(7 - i)}), 0.0f);
  const float far = 2e9f, nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(gradientNoise({far, 0.5f, 0.25f}), gradientNoise({0, 0.5f, 0.25f}));
  EXPECT_EQ(gradientNoise({0.5f, nan, 0.25f}), gradientNoise({0.5f, 0, 0.25f}));
}

TEST(GradientNoise, StaysWithinItsBoundsWithoutABias)
{
  std::mt19937 random(1);
  float most = 0;
  double sum = 0, squares = 0;
  constexpr int kPoints = 2000000;
  for (int i = 0; i < kPoints; ++i) {
    const float n =
        gradientNoise({within(random, -500, 500), within(random, -500, 500), within(random, 0, 9)});
    most = std::max(most, std::fabs(n));
    sum += double{n};
    squares += double{n} * double{n};
  }
  EXPECT_LE(most, 1.05f);
  EXPECT_GT(most, 0.8f);
  EXPECT_NEAR(sum / kPoints, 0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / kPoints), 0.26, 0.03);
}

TEST(GradientNoise, IsContinuousAcrossCells)
{
  std::mt19937 random(2);
  for (int i = 0; i < 10000; ++i) {
    const float y = within(random, -9, 9), z = within(random, -9, 9);
    const float x = static_cast<float>(static_cast<int>(random() % 19) - 9);
    // The noise of a cell's face is that of its neighbour's.
    EXPECT_NEAR(gradientNoise({x - 1e-4f, y, z}), gradientNoise({x + 1e-4f, y, z}), 5e-4f);
    EXPECT_NEAR(gradientNoise({y, x - 1e-4f, z}), gradientNoise({y, x + 1e-4f, z}), 5e-4f);
    EXPECT_NEAR(gradientNoise({y, z, x - 1e-4f}), gradientNoise({y, z, x + 1e-4f}), 5e-4f);
  }
}

TEST(Wood, HasRingsAboutTheZAxis)
{
  const ProceduralTexture texture = textureOf(ProceduralKind::kWood, 2);
  for (int ring = 0; ring < 5; ++ring) {
    const float border = static_cast<float>(ring) / 2, middle = border + 0.25f;
    EXPECT_EQ(proceduralColor(texture, {border, 0, 3.3f}), kA);
    EXPECT_EQ(proceduralColor(texture, {0, -middle, -8}), kB);
    const Vec4f turned = proceduralColor(texture, {0.6f * middle, 0.8f * middle, 1});
    EXPECT_NEAR(turned.x, kB.x, 1e-5f);
  }
  EXPECT_NE(proceduralColor(textureOf(ProceduralKind::kWood, 2, 0.3f), {0.4f, 0.3f, 0.2f}).x,
            proceduralColor(texture, {0.4f, 0.3f, 0.2f}).x);
}

TEST(Marble, IsASineAlongXThatTurbulenceBends)
{
  const ProceduralTexture texture = textureOf(ProceduralKind::kMarble, 2);
  EXPECT_NEAR(proceduralColor(texture, {0.125f, 5, 6}).x, kB.x, 1e-7f);
  EXPECT_NEAR(proceduralColor(texture, {0.375f, 5, 6}).x, kA.x, 1e-7f);
  EXPECT_EQ(proceduralColor(texture, {0.5f, 1, 2}).x, 0.5f);
  std::mt19937 random(3);
  const ProceduralTexture bent = textureOf(ProceduralKind::kMarble, 2, 0.7f);
  int moved = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3f p = {within(random, -5, 5), within(random, -5, 5), within(random, -5, 5)};
    const Vec4f color = proceduralColor(bent, p);
    EXPECT_GE(color.x, kA.x - 1e-6f);
    EXPECT_LE(color.x, kB.x + 1e-6f);
    moved += std::fabs(color.x - proceduralColor(texture, p).x) > 0.01f ? 1 : 0;
  }
  EXPECT_GT(moved, 700);
}

TEST(CheckProcedural, NamesWhatIsWrong)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto expectError = [](const ProceduralTexture& texture, const char* word) {
    const Status status = checkProcedural(texture, "Instance 5");
    EXPECT_EQ(status.error, Error::kNotFinite);
    EXPECT_NE(status.message.find("Instance 5"), std::string::npos);
    EXPECT_NE(status.message.find(word), std::string::npos) << status.message;
  };
  EXPECT_TRUE(checkProcedural(ProceduralTexture(), "").ok());
  for (const float wrong : {0.0f, -1.0f, 2e6f, nan}) {
    ProceduralTexture texture;
    texture.scale = wrong;
    expectError(texture, "scale");
  }
  for (const float wrong : {-0.1f, 2e6f, nan}) {
    ProceduralTexture texture;
    texture.turbulence = wrong;
    expectError(texture, "turbulence");
  }
  ProceduralTexture texture;
  texture.colorB.y = nan;
  expectError(texture, "colour");
}

}  // namespace
}  // namespace limn
