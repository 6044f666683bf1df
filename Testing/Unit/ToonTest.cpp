// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Light in even steps, Style::toonBands: where its edges lie, how soft they are, and of what light.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class Toons : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Toons);

constexpr double kPi = 3.14159265358979323846;
constexpr int kSide = 240;
constexpr double kRadius = 100;  ///< of the sphere in pixels

/// The white unit sphere under parallel projection, lit along the gaze.
Stage toonSphere(int bands)
{
  Stage stage;
  stage.width = stage.height = kSide;
  stage.view.parallel = true;
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.toonBands = bands;
  stage.lights = {Light{}};
  return stage;
}

Light directional(Vec3d toward, Vec3f color = {1, 1, 1})
{
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = -toward;
  light.color = color;
  return light;
}

/// Red of a pixel, 0 to 1.
double value(const Picture& picture, int x, int y)
{
  return at(picture, x, y).r / 255.0;
}

/// The step that a pixel shows, 0 to bands - 1; between two where an edge goes through it.
double step(const Picture& picture, int x, int y, int bands)
{
  const double level = value(picture, x, y) * (bands - 1), whole = std::round(level);
  return std::fabs(level - whole) * 255 < 0.6 * (bands - 1) ? whole : level;
}

/// Pixels that are on the upper side of edge k of `bands`, by their shares.
double areaAbove(const Picture& picture, int bands, int k)
{
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      sum += std::clamp(step(picture, x, y, bands) - (k - 1), 0.0, 1.0);
  return sum;
}

/// Pixels that show no pure step.
int mixedPixels(const Picture& picture, int bands)
{
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double level = step(picture, x, y, bands);
      count += level != std::round(level);
    }
  return count;
}

TEST_P(Toons, AHeadlightsBandsAreCirclesOfTheArea1MinusTSquaredPiRSquared)
{
  for (const int bands : {2, 3, 4, 7}) {
    const Picture picture = draw(toonSphere(bands));
    for (int k = 1; k < bands; ++k) {
      const double t = static_cast<double>(k) / bands;
      const double area = kPi * (1 - t * t) * kRadius * kRadius;
      EXPECT_NEAR(areaAbove(picture, bands, k), area, 0.0015 * area) << k << " of " << bands;
    }
  }
}

TEST_P(Toons, AHeadlightsBandsHaveTheRadiusRootOf1MinusTSquared)
{
  const Picture picture = draw(toonSphere(4));
  for (int k = 1; k < 4; ++k) {
    const double t = k / 4.0;
    double chord = 0;
    for (int x = 0; x < kSide; ++x)
      chord += std::clamp(step(picture, x, kSide / 2, 4) - (k - 1), 0.0, 1.0);
    // The row of pixel centres half a pixel above the middle.
    const double radius = std::sqrt(chord * chord / 4 + 0.25);
    EXPECT_NEAR(radius, std::sqrt(1 - t * t) * kRadius, 0.15) << k;
  }
}

TEST_P(Toons, EdgesAreOnePixelWide)
{
  const Picture picture = draw(toonSphere(2));
  const double length = 2 * kPi * std::sqrt(0.75) * kRadius;
  // The ends of the smooth step round to the bytes of pure steps.
  EXPECT_NEAR(mixedPixels(picture, 2) / length, 0.95, 0.1);
}

TEST_P(Toons, EdgesOfManyBandsAreAsNarrow)
{
  const Picture picture = draw(toonSphere(5));
  double length = 0;
  for (int k = 1; k < 5; ++k)
    length += 2 * kPi * std::sqrt(1 - k * k / 25.0) * kRadius;
  EXPECT_NEAR(mixedPixels(picture, 5) / length, 0.9, 0.15);
}

TEST_P(Toons, LightsAreSummedBeforeTheyAreStepped)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage = toonSphere(2);
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.toonBands = 2;
  stage.lights = {directional({0, 0, 1}, {0.3f, 0.3f, 0.3f})};
  EXPECT_EQ(at(draw(stage), kSide / 2, kSide / 2).r, 0);
  stage.lights.push_back(stage.lights[0]);
  EXPECT_EQ(at(draw(stage), kSide / 2, kSide / 2).r, 255);
}

TEST_P(Toons, WhatDoesNotChangeIsExact)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage = toonSphere(0);
  stage.instances = {instanceOf(mesh)};
  Style& style = stage.instances[0].style;
  const struct {
    double light;
    int bands, level;
  } cases[] = {{0.499, 2, 0},   {0.501, 2, 255}, {0.332, 3, 0}, {0.334, 3, 128},
               {0.667, 3, 255}, {0.799, 5, 191}, {5, 3, 255}};
  for (const auto& one : cases) {
    style.toonBands = one.bands;
    const auto color = static_cast<float>(one.light);
    stage.lights = {directional({0, 0, 1}, {color, color, color})};
    EXPECT_EQ(at(draw(stage), kSide / 2, kSide / 2).r, one.level) << one.light;
  }
}

TEST_P(Toons, ColoredLightsKeepTheirHue)
{
  Stage stage = toonSphere(3);
  stage.lights = {directional({1, 0, 1}, {1, 0.5f, 0}), directional({-1, 0, 1}, {0, 0, 0.8f})};
  const Picture picture = draw(stage);
  const auto hue = [](Vec3d color) { return color * (1 / std::max({color.x, color.y, color.z})); };
  int compared = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto hit = hitSphere(stage.ray(x + 0.5, y + 0.5));
      const Rgba8 actual = at(picture, x, y);
      if (!hit || hit->normal.z < 0.3 || std::max({actual.r, actual.g, actual.b}) != 255) continue;
      const double first = std::max(0.0, (hit->normal.x + hit->normal.z) * std::sqrt(0.5));
      const double second = std::max(0.0, (hit->normal.z - hit->normal.x) * std::sqrt(0.5));
      const Vec3d expected =
          hue(Vec3d{1, 0.5, 0} * first + Vec3d{0, 0, 0.800000011920929} * second);
      ASSERT_NEAR(actual.r, expected.x * 255, 2) << x << ", " << y;
      ASSERT_NEAR(actual.g, expected.y * 255, 2) << x << ", " << y;
      ASSERT_NEAR(actual.b, expected.z * 255, 2) << x << ", " << y;
      ++compared;
    }
  EXPECT_GT(compared, 3000);
}

TEST_P(Toons, ADimLightOfOneColorIsNotDarkForThat)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage = toonSphere(2);
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.toonBands = 2;
  const Vec3f colors[] = {{0.6f, 0, 0}, {0, 0.6f, 0}, {0, 0, 0.6f}};
  for (const Vec3f light : colors) {
    stage.lights = {directional({0, 0, 1}, light)};
    const Rgba8 color = at(draw(stage), kSide / 2, kSide / 2);
    EXPECT_EQ(color.r, light.x > 0 ? 255 : 0);
    EXPECT_EQ(color.g, light.y > 0 ? 255 : 0);
    EXPECT_EQ(color.b, light.z > 0 ? 255 : 0);
  }
}

TEST_P(Toons, TheHighlightIsAllOrNothing)
{
  Stage stage = toonSphere(2);
  Material& material = stage.instances[0].material;
  stage.instances[0].style.reflection = Reflection::kBlinnPhong;
  material.diffuse = 0;
  material.specular = 1;
  material.specularPower = 9;
  // n.h = cos of half the angle to l = v: cos^9 = 1/2.
  const Picture picture = draw(stage);
  const double cosine = std::pow(0.5, 1.0 / 9);
  const double area = kPi * (1 - cosine * cosine) * kRadius * kRadius;
  EXPECT_NEAR(areaAbove(picture, 2, 1), area, 0.004 * area);
  EXPECT_NEAR(mixedPixels(picture, 2) / std::sqrt(4 * kPi * area), 0.95, 0.15);
}

TEST_P(Toons, EveryReflectionModelHasNoOtherShades)
{
  for (int model = 0; model <= static_cast<int>(Reflection::kMetallicRoughnessAsVtk); ++model) {
    const auto reflection = static_cast<Reflection>(model);
    if (reflection == Reflection::kNone) continue;
    for (const bool isLone : {true, false}) {
      Stage stage = toonSphere(3);
      // Of those whose white needs I = pi.
      const float full = reflection == Reflection::kIrradiance || model >= 7 ? 3.0f : 1.0f;
      stage.lights[0].color = {full, full, full};
      if (!isLone) stage.lights = {directional(normalized(Vec3d{1, 1, 3}), {full, full, full})};
      stage.instances[0].style.reflection = reflection;
      stage.instances[0].material.specular = 0.2f;
      stage.instances[0].material.specularPower = 20;
      const Picture picture = draw(stage);
      int shades[256] = {};
      int seen = 0;
      for (std::size_t i = 0; i < picture.color.size(); ++i)
        if (picture.coverage[i] != 0) {
          ++shades[picture.color[i].r];
          ++seen;
        }
      std::sort(shades, shades + 256);
      // Three steps, and one or two of them with the highlight.
      const int pure = shades[255] + shades[254] + shades[253] + shades[252] + shades[251];
      EXPECT_GT(pure, 0.95 * seen) << model << (isLone ? " lone" : "");
      EXPECT_GT(shades[254], 100) << model << ": two steps at least";
    }
  }
}

TEST_P(Toons, TheUnlitHaveNoSteps)
{
  Stage stage = toonSphere(4);
  stage.instances[0].style.reflection = Reflection::kNone;
  const Picture picture = draw(stage);
  stage.instances[0].style.toonBands = 0;
  EXPECT_EQ(draw(stage).differingPixels(picture), 0u);
}

TEST_P(Toons, OneBandIsNone)
{
  Stage stage = toonSphere(1);
  const Picture picture = draw(stage);
  stage.instances[0].style.toonBands = 0;
  EXPECT_EQ(draw(stage).differingPixels(picture), 0u);
}

TEST_P(Toons, GoochIsSteppedFromCoolToWarm)
{
  Stage stage = toonSphere(3);
  Style& style = stage.instances[0].style;
  style.tone = Tone::kGooch;
  style.toneCool = {0, 0, 1};
  style.toneWarm = {1, 1, 0};
  style.coolSurface = style.warmSurface = 0;
  stage.lights = {directional({1, 0, 0})};
  const Picture picture = draw(stage);
  // (1 + x) / 2 = 1/3 and 2/3 are straight lines.
  double low = 0, high = 0;
  for (int x = 0; x < kSide; ++x) {
    low += std::clamp(value(picture, x, kSide / 2) * 2, 0.0, 1.0);
    high += std::clamp(value(picture, x, kSide / 2) * 2 - 1, 0.0, 1.0);
  }
  EXPECT_NEAR(low, kRadius * (1 + 1.0 / 3), 0.6);
  EXPECT_NEAR(high, kRadius * (1 - 1.0 / 3), 0.6);
  const Rgba8 middle = at(picture, kSide / 2, kSide / 2);
  EXPECT_EQ(middle.r, 128);
  EXPECT_EQ(middle.b, 128);
  EXPECT_EQ(at(picture, kSide / 2 - 60, kSide / 2).b, 255);
  EXPECT_EQ(at(picture, kSide / 2 + 60, kSide / 2).b, 0);
}

TEST_P(Toons, FlatFacesHaveOneStepEach)
{
  const OwnedMesh mesh = sphere(12, 24);
  Stage stage = toonSphere(3);
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.toonBands = 3;
  stage.instances[0].style.frequency = ShadingFrequency::kFlat;
  EXPECT_EQ(mixedPixels(draw(stage), 3), 0);
}

TEST_P(Toons, TheSumOfLightsBeyondOneIsTheLastStep)
{
  Stage stage = toonSphere(2);
  stage.lights = {Light{}, Light{}};
  // 2 n.z = 1/2.
  const double area = kPi * (1 - 1.0 / 16) * kRadius * kRadius;
  EXPECT_NEAR(areaAbove(draw(stage), 2, 1), area, 0.0015 * area);
}

}  // namespace
}  // namespace limn::testing
