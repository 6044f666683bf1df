// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tones over the colours of data: CIELAB in double, by libm, against what is drawn.
#include "Rendering/Reference/ReferenceDataTone.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace limn::testing {
namespace {

// The primaries of sRGB to CIE XYZ, ITU-R BT.709 with D65.
constexpr double kToXyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                 {0.2126729, 0.7151522, 0.0721750},
                                 {0.0193339, 0.1191920, 0.9503041}};

double decoded(double c)
{
  return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}
double labRoot(double t)
{
  const double knee = std::pow(6.0 / 29, 3);
  return t > knee ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29;
}
Vec3d lab(Vec3d rgb)
{
  const double linear[3] = {decoded(rgb.x), decoded(rgb.y), decoded(rgb.z)};
  double root[3];
  for (int i = 0; i < 3; ++i) {
    double value = 0, white = 0;
    for (int k = 0; k < 3; ++k) {
      value += kToXyz[i][k] * linear[k];
      white += kToXyz[i][k];
    }
    root[i] = labRoot(value / white);
  }
  return {116 * root[1] - 16, 500 * (root[0] - root[1]), 200 * (root[1] - root[2])};
}
Vec3d lab(Rgba8 c)
{
  return lab(Vec3d{c.r / 255.0, c.g / 255.0, c.b / 255.0});
}
Vec3d lab(Vec3f c)
{
  return lab(vec3Cast<double>(c));
}

/// Called with a grid of colours of the whole of sRGB, its corners, edges and greys among them.
template <class Visit>
void forEachColor(Visit visit)
{
  constexpr int kSteps = 17;
  for (int r = 0; r <= kSteps; ++r)
    for (int g = 0; g <= kSteps; ++g)
      for (int b = 0; b <= kSteps; ++b)
        visit(Vec3f{static_cast<float>(r) / kSteps, static_cast<float>(g) / kSteps,
                    static_cast<float>(b) / kSteps});
}

Style legendSafe(float range)
{
  Style style;
  style.toneOverData = ToneOverData::kLegendSafe;
  style.legendSafeRange = range;
  return style;
}

TEST(DataTones, OurLabIsThatOfDoublePrecisionToAThousandth)
{
  double most = 0;
  forEachColor([&](Vec3f c) {
    const Vec3d ours = vec3Cast<double>(reference::labOf(c)), exact = lab(c);
    most = std::max({most, std::fabs(ours.x - exact.x), std::fabs(ours.y - exact.y),
                     std::fabs(ours.z - exact.z)});
  });
  std::cout << "largest error of L*, a* or b*: " << most << '\n';
  // a* is 500 times a difference of roots, which are right to 2e-7.
  EXPECT_LT(most, 5e-4);
}

TEST(DataTones, LegendSafeMovesLightnessAloneAndByTheRoomThereIs)
{
  double mostChroma = 0, mostLightness = 0;
  forEachColor([&](Vec3f c) {
    for (const float cosine : {-1.0f, -0.6f, 0.0f, 0.3f, 1.0f}) {
      const Vec3f drawn = reference::dataTone(legendSafe(12), c, cosine);
      ASSERT_TRUE(drawn.x >= 0 && drawn.y >= 0 && drawn.z >= 0);
      ASSERT_TRUE(drawn.x <= 1.00001f && drawn.y <= 1.00001f && drawn.z <= 1.00001f);
      const float room = reference::roomInGamut(c, cosine < 0 ? -12.0f : 12.0f);
      const Vec3d before = lab(c), after = lab(drawn);
      mostChroma =
          std::max({mostChroma, std::fabs(after.y - before.y), std::fabs(after.z - before.z)});
      mostLightness = std::max(mostLightness, std::fabs(after.x - before.x - 12.0 * room * cosine));
    }
  });
  std::cout << "a*, b* to " << mostChroma << ", L* to " << mostLightness << '\n';
  // The slack of a byte's share that colours on the edge of the gamut have.
  EXPECT_LT(mostChroma, 0.02);
  EXPECT_LT(mostLightness, 0.02);
}

TEST(DataTones, LightnessAtTheEndOfTheRoomLeavesTheGamutAStepFurther)
{
  int limited = 0;
  forEachColor([&](Vec3f c) {
    for (const float step : {-12.0f, 12.0f}) {
      const float room = reference::roomInGamut(c, step);
      ASSERT_EQ(room * 1024, std::floor(room * 1024));
      if (room == 1.0f) continue;
      ++limited;
      // All of the room less a hair, asked for as a range of its own, fits.
      EXPECT_EQ(reference::roomInGamut(c, step * room * 0.999f), 1.0f);
      EXPECT_LT(reference::roomInGamut(c, step * (room + 2.0f / 1024)), 1.0f);
    }
  });
  EXPECT_GT(limited, 1000);
}

/// What the bisection rests on: with a* and b* kept, more L* is more red, green and blue.
TEST(DataTones, EachLinearChannelGrowsWithLightness)
{
  const double toRgb[3][3] = {{3.2404542, -1.5371385, -0.4985314},
                              {-0.9692660, 1.8760108, 0.0415560},
                              {0.0556434, -0.2040259, 1.0572252}};
  forEachColor([&](Vec3f c) {
    const Vec3d color = lab(c);
    const double y = (color.x + 16) / 116;
    const double root[3] = {y + color.y / 500, y, y - color.z / 200};
    for (const auto& channel : toRgb) {
      double slope = 0;
      for (int i = 0; i < 3; ++i) {
        const double white = kToXyz[i][0] + kToXyz[i][1] + kToXyz[i][2];
        slope += channel[i] * white * 3 * std::pow(std::max(root[i], 6.0 / 29), 2);
      }
      ASSERT_GT(slope, 0.005);
    }
  });
}

TEST(DataTones, GreysHaveAllTheRoomAndPureColorsNone)
{
  EXPECT_EQ(reference::roomInGamut({0.5f, 0.5f, 0.5f}, 12), 1.0f);
  EXPECT_EQ(reference::roomInGamut({0.5f, 0.5f, 0.5f}, -12), 1.0f);
  EXPECT_EQ(reference::roomInGamut({1, 1, 1}, 12), 0.0f);
  EXPECT_EQ(reference::roomInGamut({1, 1, 1}, -12), 1.0f);
  for (const Vec3f pure : {Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}})
    for (const float step : {-12.0f, 12.0f})
      EXPECT_EQ(reference::roomInGamut(pure, step), 0.0f);
}

class TonesOverData : public BothBackends {
 protected:
  /// The unit sphere under parallel projection, 40 pixels in radius, lit from +x, in one colour of
  /// data.
  Stage sphereOf(Rgba8 color, Tone tone, ToneOverData over)
  {
    mesh_ = fineSphere();
    mesh_.vertexColors.assign(mesh_.positions.size(), color);
    Stage stage;
    stage.view.parallel = true;
    stage.instances = {instanceOf(mesh_)};
    Style& style = stage.instances[0].style;
    style.tone = tone;
    style.toneOverData = over;
    stage.instances[0].material.specular = 1;
    Light light;
    light.kind = LightKind::kDirectional;
    light.direction = {-1, 0, 0};
    stage.lights = {light};
    return stage;
  }

 private:
  OwnedMesh mesh_;
};
LIMN_ON_BOTH_BACKENDS(TonesOverData);

TEST_P(TonesOverData, LegendSafeLightnessIsAffineAcrossASphere)
{
  for (const Tone tone : {Tone::kGooch, Tone::kGoochChapter}) {
    const Rgba8 color = {120, 140, 90, 255};
    const Picture picture = draw(sphereOf(color, tone, ToneOverData::kLegendSafe));
    const Vec3d data = lab(color);
    int compared = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const double px = (x + 0.5 - 48) / 40, py = (y + 0.5 - 48) / 40;
        if (px * px + py * py > 0.9) continue;
        const Vec3d seen = lab(at(picture, x, y));
        const double towards = tone == Tone::kGooch ? px : -px;
        // Bytes are a quarter of a unit of L* here, and less of a* and b* than 0.6.
        ASSERT_NEAR(seen.x, data.x + 12 * towards, 0.4);
        ASSERT_NEAR(seen.y, data.y, 0.7);
        ASSERT_NEAR(seen.z, data.z, 0.7);
        ++compared;
      }
    EXPECT_GT(compared, 4000);
  }
}

TEST_P(TonesOverData, BandsStepTheLightness)
{
  const Rgba8 color = {120, 140, 90, 255};
  Stage stage = sphereOf(color, Tone::kGooch, ToneOverData::kLegendSafe);
  stage.instances[0].style.toonBands = 4;
  const Picture picture = draw(stage);
  const double data = lab(color).x;
  int compared = 0;
  for (int y = 20; y < 76; ++y)
    for (int x = 20; x < 76; ++x) {
      const double t = ((x + 0.5 - 48) / 40 + 1) / 2;
      // Edges are a pixel wide.
      if (std::fabs(4 * t - std::round(4 * t)) < 0.1) continue;
      ASSERT_NEAR(lab(at(picture, x, y)).x, data + 12 * (2 * std::floor(4 * t) / 3 - 1), 0.4);
      ++compared;
    }
  EXPECT_GT(compared, 2000);
}

TEST_P(TonesOverData, UndertoneMixesTheToneOfGreyIntoTheData)
{
  for (const Tone tone : {Tone::kGooch, Tone::kGoochChapter}) {
    Stage stage = sphereOf({51, 102, 204, 255}, tone, ToneOverData::kUndertone);
    stage.instances[0].style.undertone = 0.25f;
    // (0, 0, 0.4) + 0.2 / 2 and (0.4, 0.4, 0) + 0.6 / 2.
    const Vec3d cool = {0.1, 0.1, 0.5}, warm = {0.7, 0.7, 0.3}, data = {0.2, 0.4, 0.8};
    const auto equation = [&](const Hit& hit) {
      const double nl = tone == Tone::kGooch ? hit.position.x : -hit.position.x;
      return data * 0.75 + (warm * ((1 + nl) / 2) + cool * ((1 - nl) / 2)) * 0.25;
    };
    expectPicture(stage, draw(stage), hitSphere, equation, kRounding + kFacets);
  }
}

TEST_P(TonesOverData, SharesOfNothingAndAllAndARangeOfNothing)
{
  const Rgba8 color = {200, 30, 77, 255};
  Stage stage = sphereOf(color, Tone::kGooch, ToneOverData::kUndertone);
  stage.instances[0].style.undertone = 0;
  const Picture bare = draw(stage);
  stage.instances[0].style.toneOverData = ToneOverData::kLegendSafe;
  stage.instances[0].style.legendSafeRange = 0;
  EXPECT_EQ(draw(stage).differingPixels(bare), 0u);
  const Rgba8 middle = at(bare, 48, 48);
  EXPECT_EQ(middle.r, color.r);
  EXPECT_EQ(middle.g, color.g);
  EXPECT_EQ(middle.b, color.b);
}

TEST_P(TonesOverData, WithoutColorsOfDataTheToneStaysClassic)
{
  Stage stage = sphereOf({1, 2, 3, 255}, Tone::kGooch, ToneOverData::kClassic);
  stage.instances[0].attributes.vertexColors = {};
  const Picture classic = draw(stage);
  for (const ToneOverData over : {ToneOverData::kUndertone, ToneOverData::kLegendSafe}) {
    stage.instances[0].style.toneOverData = over;
    EXPECT_EQ(draw(stage).differingPixels(classic), 0u);
  }
}

TEST_P(TonesOverData, WithoutAToneColorsOfDataAreLitAsEver)
{
  Stage stage = sphereOf({100, 200, 30, 255}, Tone::kNone, ToneOverData::kClassic);
  const Picture lit = draw(stage);
  stage.instances[0].style.toneOverData = ToneOverData::kLegendSafe;
  EXPECT_EQ(draw(stage).differingPixels(lit), 0u);
}

TEST_P(TonesOverData, ColorsOfCellsCount)
{
  OwnedMesh mesh = sphere(8, 8);
  mesh.cellColors.assign(mesh.cellCount, {128, 128, 128, 255});
  Stage stage;
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.tone = Tone::kGooch;
  stage.instances[0].style.toneOverData = ToneOverData::kLegendSafe;
  stage.instances[0].style.legendSafeRange = 30;
  stage.lights = {Light{}};
  const Rgba8 facing = at(draw(stage), 48, 48);
  EXPECT_EQ(facing.r, facing.b);
  EXPECT_NEAR(lab(facing).x, lab(Rgba8{128, 128, 128, 255}).x + 30, 1.5);
}

}  // namespace
}  // namespace limn::testing
