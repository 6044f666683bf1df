// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hatching by a tonal art map: nested strokes, ink in the mean as the tone asks, one density at any
// distance.
#include "Rendering/Texture/TonalArtMap.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn::testing {
namespace {

constexpr int kSide = TonalArtMap::kSide;

TEST(TonalArtMaps, DarkerTonesHaveTheStrokesOfLighterOnesAndTheLastIsAllInk)
{
  const TonalArtMap& map = tonalArtMap();
  int count[TonalArtMap::kTones + 1] = {};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      // One number says which tones have the texel: all from that on.
      ASSERT_GE(map.firstTone(x, y), 1);
      ASSERT_LE(map.firstTone(x, y), TonalArtMap::kTones);
      for (int tone = map.firstTone(x, y); tone <= TonalArtMap::kTones; ++tone)
        ++count[tone];
    }
  EXPECT_EQ(map.coverage(0), 0.0f);
  EXPECT_EQ(map.coverage(2), 0.25f) << "strokes of 2 texels, 8 apart";
  EXPECT_EQ(map.coverage(TonalArtMap::kTones), 1.0f);
  for (int tone = 1; tone <= TonalArtMap::kTones; ++tone) {
    EXPECT_EQ(map.coverage(tone), static_cast<float>(count[tone]) / (kSide * kSide));
    EXPECT_GT(map.coverage(tone), map.coverage(tone - 1));
  }
}

TEST(TonalArtMaps, CoarserLevelsHaveOnlyStrokesThatFinerOnesHave)
{
  const TonalArtMap& map = tonalArtMap();
  // A texel of the coarser level covers four of the finer one.
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      int first = TonalArtMap::kTones;
      for (int i = 0; i < 4; ++i)
        first = std::min(first, map.firstTone((2 * x + i % 2) % kSide, (2 * y + i / 2) % kSide));
      ASSERT_LE(first, map.firstTone(x, y)) << x << ' ' << y;
    }
}

TEST(TonalArtMaps, StrokesOfTheFirstToneEnd)
{
  int ink = 0;
  for (int x = 0; x < kSide; ++x)
    ink += tonalArtMap().firstTone(x, 8) == 1;
  EXPECT_GT(ink, kSide / 4);
  EXPECT_LT(ink, kSide * 3 / 4);
}

class HatchedSurfaces : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(HatchedSurfaces);

/// A square across the picture, one unit a pixel times `scale`, lit so that 1 - darkness arrives.
struct Sheet {
  OwnedMesh mesh;
  Stage stage;

  Sheet(double darkness, double scale, Vec3d tilt = {0, 0, 0})
  {
    const double half = 160 * scale;
    mesh = sheet({-half, -half, -(tilt.x + tilt.y) * half}, {2 * half, 0, 2 * half * tilt.x},
                 {0, 2 * half, 2 * half * tilt.y});
    stage.width = stage.height = 256;
    stage.view =
        parallelView({0, 0, 4000 * scale}, {0, 0, 0}, 128 * scale, {100 * scale, 8000 * scale});
    stage.instances = {instanceOf(mesh)};
    Instance& instance = stage.instances[0];
    instance.style.tone = Tone::kHatching;
    instance.style.hatching.darkest = 1;
    instance.material.ambient = 1;
    const auto light = static_cast<float>(1 - darkness);
    stage.ambientLight = {light, light, light};
  }
};

double meanOf(const Picture& picture)
{
  double sum = 0;
  for (const Rgba8 color : picture.color)
    sum += color.g;
  return sum / (255.0 * static_cast<double>(picture.color.size()));
}

// Of 256 x 256 pixels, in which the map repeats about three times, ends of strokes are cut off at
// any place: 1.5 % of the scale from white to black.
constexpr double kMeanTolerance = 0.015;

TEST_P(HatchedSurfaces, MeanReflectanceOfAFlatPatchIsTheTone)
{
  for (const double scale : {1.0, 1.3, 1.7, 40.0})
    for (const double darkness : {0.0, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 0.95, 1.0}) {
      const Sheet sheet(darkness, scale);
      EXPECT_NEAR(meanOf(draw(sheet.stage)), 1 - darkness, kMeanTolerance)
          << "scale " << scale << ", darkness " << darkness;
    }
}

TEST_P(HatchedSurfaces, MeanReflectanceOfATiltedPatchIsTheTone)
{
  // Up to 72 degrees; (1, 0.5) is where three planes share the strokes.
  for (const Vec3d tilt : {Vec3d{0.6, 0, 0}, {0, -1.2, 0}, {1, 0.5, 0}, {-3, 0.2, 0}})
    for (const double darkness : {0.2, 0.5, 0.8}) {
      const Sheet sheet(darkness, 1, tilt);
      EXPECT_NEAR(meanOf(draw(sheet.stage)), 1 - darkness, 2 * kMeanTolerance)
          << tilt.x << ' ' << tilt.y << ", darkness " << darkness;
    }
}

TEST_P(HatchedSurfaces, EveryPixelDarkensWithTheTone)
{
  Picture before = draw(Sheet(0, 1.2).stage);
  for (int step = 1; step <= 20; ++step) {
    const double darkness = step / 20.0;
    const Picture picture = draw(Sheet(darkness, 1.2).stage);
    for (std::size_t i = 0; i < picture.color.size(); ++i)
      ASSERT_LE(picture.color[i].g, before.color[i].g) << darkness;
    before = picture;
  }
  EXPECT_EQ(at(before, 128, 128).g, 0);
}

TEST_P(HatchedSurfaces, NothingIsDrawnInFullLightNorBeyondTheDarkestTone)
{
  const Picture light = draw(Sheet(0, 1).stage);
  for (const Rgba8 color : light.color)
    ASSERT_EQ(color.g, 255);
  Sheet sheet(1, 1);
  sheet.stage.instances[0].style.hatching.darkest = 0.25f;
  EXPECT_NEAR(meanOf(draw(sheet.stage)), 0.75, kMeanTolerance);
}

TEST_P(HatchedSurfaces, StrokesAreAsFarApartAsAskedAtAnyZoom)
{
  // Strokes of the second tone along x + y = const: without others between them where the size of
  // a texel is a power of two. Across the diagonal of 128 pixels, 181 of them.
  for (const double spacing : {6.0, 8.0, 12.0}) {
    const double pixel = 8 / (spacing * std::sqrt(2));
    Sheet sheet(0.25, pixel);
    sheet.stage.instances[0].style.hatching.spacing = static_cast<float>(spacing);
    const Picture picture = draw(sheet.stage);
    int strokes = 0;
    for (int i = 64; i < 192; ++i)
      strokes += at(picture, i, i).g < 128 && at(picture, i - 1, i - 1).g >= 128;
    EXPECT_NEAR(strokes, 128 * std::sqrt(2) / spacing, 1.01) << spacing;
  }
}

TEST_P(HatchedSurfaces, ZoomingByTwoGivesTheSamePicture)
{
  const Picture one = draw(Sheet(0.4, 1.1).stage);
  EXPECT_EQ(draw(Sheet(0.4, 2.2).stage).differingPixels(one), 0u);
  EXPECT_EQ(draw(Sheet(0.4, 1.1 / 8).stage).differingPixels(one), 0u);
  EXPECT_GT(draw(Sheet(0.4, 1.6).stage).differingPixels(one), 1000u);
}

TEST_P(HatchedSurfaces, StrokesStayOnTheSurfaceWhenTheCameraMoves)
{
  Sheet sheet(0.4, 1);
  const Picture before = draw(sheet.stage);
  sheet.stage.view.eye = {16, 8, 4000};
  sheet.stage.view.target = {16, 8, 0};
  const Picture after = draw(sheet.stage);
  int differing = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x)
      differing += std::abs(at(after, x, y).g - at(before, x + 16, y + 8).g) > 1;
  EXPECT_EQ(differing, 0);
}

TEST_P(HatchedSurfaces, LightIsSummedOverAllLights)
{
  Sheet sheet(1, 1);
  Light light;
  light.kind = LightKind::kDirectional;
  light.color = {0.3f, 0.3f, 0.3f};
  sheet.stage.lights = {light, light};
  EXPECT_NEAR(meanOf(draw(sheet.stage)), 0.6, kMeanTolerance);
}

TEST_P(HatchedSurfaces, TheCamerasLightGivesTheWholeScale)
{
  // Head-on n.l is 0.
  Sheet sheet(1, 1);
  Instance& instance = sheet.stage.instances[0];
  instance.style.toneLight = ToneLight::kUpperRight;
  instance.style.hatching.darkest = 0.8f;
  EXPECT_NEAR(meanOf(draw(sheet.stage)), 0.6, kMeanTolerance);
}

TEST_P(HatchedSurfaces, PaperTakesTheSurfacesColourAndInkDoesNot)
{
  Sheet sheet(0.5, 1);
  Instance& instance = sheet.stage.instances[0];
  instance.material.diffuseColor = {0.5f, 1, 1};
  instance.style.hatching.paper = {1, 0.8f, 1};
  instance.style.hatching.ink = {0, 0, 0.2f};
  instance.style.hatching.spacing = 16;
  const Picture picture = draw(sheet.stage);
  int paper = 0, ink = 0;
  for (const Rgba8 color : picture.color) {
    paper += color.r == 128 && color.g == 204 && color.b == 255;
    ink += color.r == 0 && color.g == 0 && color.b == 51;
  }
  EXPECT_GT(paper, 4000);
  EXPECT_GT(ink, 8000);
}

TEST_P(HatchedSurfaces, TextureCoordinatesCarryTheStrokesWhereAsked)
{
  Sheet sheet(0.25, 1);
  sheet.mesh.uv = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  ASSERT_EQ(sheet.mesh.uv.size(), sheet.mesh.view().vertexCount());
  Instance& instance = sheet.stage.instances[0];
  for (std::size_t v = 0; v < 4; ++v) {
    const Vec3d p = sheet.mesh.view().position(static_cast<std::uint32_t>(v));
    sheet.mesh.uv[v] = {static_cast<float>(p.x), static_cast<float>(p.y)};
  }
  instance.attributes.uv = sheet.mesh.uv;
  instance.style.hatching.place = HatchPlace::kTexture;
  instance.style.hatching.spacing = 8;
  const Picture picture = draw(sheet.stage);
  // A quarter's strokes are those along the first coordinate.
  for (int y = 0; y < 256; ++y)
    for (int x = 1; x < 256; ++x)
      ASSERT_EQ(at(picture, x, y).g, at(picture, 0, y).g);
  EXPECT_NEAR(meanOf(picture), 0.75, kMeanTolerance);
}

TEST_P(HatchedSurfaces, FrequenciesSayWhereLightIsTaken)
{
  Stage stage;
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.tone = Tone::kHatching;
  stage.lights = {Light{}};
  const Picture perPixel = draw(stage);
  stage.instances[0].style.frequency = ShadingFrequency::kGouraud;
  EXPECT_EQ(draw(stage).differingPixels(perPixel), 0u);
}

}  // namespace
}  // namespace limn::testing
