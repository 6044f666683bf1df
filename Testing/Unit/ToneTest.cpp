// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gooch's cool and warm shading: equation (12.6) as printed, and with warm towards the light, with
// the constants of other books, with stripes of metal, and with a light of the camera's.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class Tones : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Tones);

constexpr Vec3d kSurface = {0.5, 0.2, 0.3};
// k_cool = (0, 0, 0.4) + 0.2 k_d and k_warm = (0.4, 0.4, 0) + 0.6 k_d, Gooch 1998's figures.
constexpr Vec3d kCool = {0.1, 0.04, 0.46}, kWarm = {0.7, 0.52, 0.18};

/// The unit sphere under parallel projection, 40 pixels in radius, lit from +x.
Stage toneSphere(Tone tone)
{
  Stage stage;
  stage.view.parallel = true;
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.tone = tone;
  stage.instances[0].material.diffuseColor = vec3Cast<float>(kSurface);
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-1, 0, 0};
  stage.lights = {light};
  return stage;
}
Vec3d between(Vec3d cool, Vec3d warm, double lightCosine)
{
  return warm * ((1 + lightCosine) / 2) + cool * ((1 - lightCosine) / 2);
}

TEST_P(Tones, GoochIsAffineAcrossASphereAndWarmFacesTheLight)
{
  const Stage stage = toneSphere(Tone::kGooch);
  const auto tone = [](const Hit& hit) { return between(kCool, kWarm, hit.position.x); };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + kFacets);
}

TEST_P(Tones, GoochChapterIsEquation12_6AndCoolFacesTheLight)
{
  const Stage stage = toneSphere(Tone::kGoochChapter);
  const auto tone = [](const Hit& hit) { return between(kWarm, kCool, hit.position.x); };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + kFacets);
}

TEST_P(Tones, TheTwoGoochModelsSwapCoolAndWarmExactly)
{
  Stage stage = toneSphere(Tone::kGooch);
  const Picture gooch = draw(stage);
  Style& style = stage.instances[0].style;
  style.tone = Tone::kGoochChapter;
  std::swap(style.toneCool, style.toneWarm);
  std::swap(style.coolSurface, style.warmSurface);
  EXPECT_EQ(draw(stage).differingPixels(gooch), 0u);
}

TEST_P(Tones, TheDisksMeanIsHalfwayBetweenCoolAndWarm)
{
  const Stage stage = toneSphere(Tone::kGooch);
  const Picture picture = draw(stage);
  Vec3d sum = {0, 0, 0};
  int count = 0;
  for (std::size_t i = 0; i < picture.color.size(); ++i)
    if (picture.coverage[i] != 0) {
      sum =
          sum + Vec3d{1.0 * picture.color[i].r, 1.0 * picture.color[i].g, 1.0 * picture.color[i].b};
      ++count;
    }
  ASSERT_GT(count, 4000);
  const Vec3d mean = sum * (1.0 / count), expected = (kCool + kWarm) * (255.0 / 2);
  // Rounding of 5000 pixels averages out; the silhouette's pixels are symmetric.
  EXPECT_NEAR(mean.x, expected.x, 0.1);
  EXPECT_NEAR(mean.y, expected.y, 0.1);
  EXPECT_NEAR(mean.z, expected.z, 0.1);
}

TEST_P(Tones, TheHighlightIsAddedWithoutTheLightsColor)
{
  Stage stage = toneSphere(Tone::kGooch);
  const Vec3d l = normalized(Vec3d{1, 1, 2});
  stage.lights[0].direction = -l;
  stage.lights[0].color = {0, 5, 0};
  Material& material = stage.instances[0].material;
  material.specular = 0.8f;
  material.specularPower = 25;
  const auto tone = [&](const Hit& hit) -> std::optional<Vec3d> {
    const double nl = dot(hit.normal, l);
    if (std::fabs(nl) < 0.02) return std::nullopt;
    const double nh = std::max(0.0, dot(hit.normal, normalized(l + hit.towardEye)));
    const double highlight = nl > 0 ? 0.8 * std::pow(nh, 25) : 0;
    return between(kCool, kWarm, nl) + Vec3d{highlight, highlight, highlight};
  };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + steepness(25) * kFacets);
}

TEST_P(Tones, TheFirstLightGivesTheTone)
{
  Stage stage = toneSphere(Tone::kGooch);
  const Picture one = draw(stage);
  Light second;
  second.kind = LightKind::kDirectional;
  second.direction = {1, 1, 0};
  stage.lights.push_back(second);
  EXPECT_EQ(draw(stage).differingPixels(one), 0u);
}

TEST_P(Tones, APointLightIsSeenFromEachPoint)
{
  Stage stage = toneSphere(Tone::kGooch);
  stage.lights[0].kind = LightKind::kPoint;
  stage.lights[0].position = {1.5, 0, 1};
  const auto tone = [](const Hit& hit) {
    const Vec3d l = normalized(Vec3d{1.5, 0, 1} - hit.position);
    return between(kCool, kWarm, dot(hit.normal, l));
  };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + 2 * kFacets);
}

TEST_P(Tones, ToneTakesTheDatasColorAsTheSurface)
{
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  mesh.cellColors = {{255, 0, 51, 255}};
  Stage stage = toneSphere(Tone::kGooch);
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.tone = Tone::kGooch;
  // n.l = 0: halfway between (0.2, 0, 0.44) and (1, 0.4, 0.12).
  const Rgba8 color = at(draw(stage), 48, 48);
  EXPECT_EQ(color.r, 153);
  EXPECT_EQ(color.g, 51);
  EXPECT_NEAR(color.b, 0.28 * 255, kRounding + 0.01);
}

TEST_P(Tones, GoochIsTheSumOfTwoLightsAndAnAmbientOne)
{
  // Gooch's form for fixed pipelines: ambient (warm + cool) / 2, (warm - cool) / 2 by l and the
  // negative of that by -l.
  const Stage stage = toneSphere(Tone::kGooch);
  const Vec3d half = (kWarm - kCool) * 0.5;
  const auto tone = [&](const Hit& hit) {
    const double nl = hit.position.x;
    return (kWarm + kCool) * 0.5 + half * std::max(0.0, nl) - half * std::max(0.0, -nl);
  };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + kFacets);
}

/// r.v
double reflectedCosine(const Hit& hit, Vec3d l)
{
  return dot(hit.normal * (2 * dot(hit.normal, l)) - l, hit.towardEye);
}

TEST_P(Tones, TheHighlightOfRealTimeRenderingMixesWithWhite)
{
  Stage stage = toneSphere(Tone::kGooch);
  Style& style = stage.instances[0].style;
  style.toneCool = {0, 0, 0.55f};
  style.toneWarm = {0.3f, 0.3f, 0};
  style.coolSurface = style.warmSurface = 0.25f;
  style.toneHighlight = ToneHighlight::kWhite;
  const Vec3d l = normalized(Vec3d{1, 1, 3});
  stage.lights[0].direction = -l;
  const Vec3d cool = Vec3d{0, 0, 0.55} + kSurface * 0.25;
  const Vec3d warm = Vec3d{0.3, 0.3, 0} + kSurface * 0.25;
  int white = 0;
  const auto tone = [&](const Hit& hit) {
    const double s = std::clamp(100 * reflectedCosine(hit, l) - 97, 0.0, 1.0);
    white += s == 1;
    return between(cool, warm, dot(hit.normal, l)) * (1 - s) + Vec3d{s, s, s};
  };
  // 100 r.v changes 100 sin(acos 0.97) = 24 times as fast as a cosine, twice that for r.
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + 50 * kFacets);
  EXPECT_GT(white, 30);
}

TEST_P(Tones, TheHighlightOfTheOrangeBookIsThatOfTheReflectedRay)
{
  Stage stage = toneSphere(Tone::kGooch);
  Style& style = stage.instances[0].style;
  style.toneCool = {0, 0, 0.6f};
  style.toneWarm = {0.6f, 0.6f, 0};
  style.coolSurface = style.warmSurface = 0.45f;
  style.toneHighlight = ToneHighlight::kReflected;
  Material& material = stage.instances[0].material;
  material.diffuseColor = {0.75f, 0.75f, 0.75f};
  material.specular = 1;
  material.specularPower = 32;
  const Vec3d l = normalized(Vec3d{1, 1, 3});
  stage.lights[0].direction = -l;
  const Vec3d surface = Vec3d{0.75, 0.75, 0.75} * 0.45;
  const auto tone = [&](const Hit& hit) -> std::optional<Vec3d> {
    const double nl = dot(hit.normal, l);
    if (std::fabs(nl) < 0.02) return std::nullopt;
    const double rv = std::max(0.0, reflectedCosine(hit, l));
    const double highlight = nl > 0 ? std::pow(rv, 32) : 0;
    return between(Vec3d{0, 0, 0.6} + surface, Vec3d{0.6, 0.6, 0} + surface, nl) +
           Vec3d{highlight, highlight, highlight};
  };
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + 2 * steepness(32) * kFacets);
}

TEST_P(Tones, NoHighlightIsNone)
{
  Stage stage = toneSphere(Tone::kGooch);
  const Picture matt = draw(stage);
  stage.instances[0].material.specular = 1;
  stage.instances[0].style.toneHighlight = ToneHighlight::kNone;
  EXPECT_EQ(draw(stage).differingPixels(matt), 0u);
}

TEST_P(Tones, TheUpperRightLightIsTheCamerasWhateverTheScenes)
{
  Stage stage = toneSphere(Tone::kGooch);
  stage.instances[0].style.toneLight = ToneLight::kUpperRight;
  stage.view.eye = {3, 1, -2};
  const Axes axes = axesOf(stage.view);
  const auto tone = [&](const Hit& hit) {
    return between(kCool, kWarm, dot(hit.normal, axes.right + axes.up) * std::sqrt(0.5));
  };
  const Picture picture = draw(stage);
  expectPicture(stage, picture, hitSphere, tone, kRounding + kFacets);
  stage.lights.clear();
  EXPECT_EQ(draw(stage).differingPixels(picture), 0u);
}

/// Grey of stripe i, by 64-bit arithmetic.
double stripe(int i)
{
  constexpr std::uint64_t kWord = std::uint64_t{1} << 32;
  std::uint64_t bits = static_cast<std::uint64_t>(i + 1) * 2654435761u % kWord;
  bits = bits ^ (bits / 65536);
  bits = bits * 2246822519u % kWord;
  bits = bits ^ (bits / 8192);
  return static_cast<double>(bits / 256) / 16777216.0 / 2;
}

TEST_P(Tones, MetalIsTwentyStripesOfWhichTheLightsIsWhite)
{
  Stage stage = toneSphere(Tone::kMetal);
  stage.width = stage.height = 192;
  Style& style = stage.instances[0].style;
  style.toneCool = style.toneWarm = {1, 1, 1};
  style.coolSurface = style.warmSurface = 0;
  const double angle = 1.0;
  stage.lights[0].direction = {-std::cos(angle), 0, -std::sin(angle)};
  const int light = static_cast<int>(angle / 3.14159265358979 * kMetalStripes);
  const auto tone = [&](const Hit& hit) {
    const double place = std::acos(hit.normal.x) / 3.14159265358979 * kMetalStripes - 0.5;
    const auto grey = [&](int i) {
      const int at = std::clamp(i, 0, kMetalStripes - 1);
      return at == light ? 1.0 : stripe(at);
    };
    const int left = static_cast<int>(std::floor(place));
    const double value = grey(left) + (grey(left + 1) - grey(left)) * (place - left);
    return Vec3d{value, value, value};
  };
  // A stripe is a twentieth of half a turn, over which a grey goes from 0 to 1 at most; the arc
  // cosine is good to 7e-5 of a radian.
  expectPicture(stage, draw(stage), hitSphere, tone, kRounding + 10 * kFacets + 0.2);
}

TEST_P(Tones, MetalIsTimesCoolAndWarm)
{
  Stage stage = toneSphere(Tone::kMetal);
  const Picture metal = draw(stage);
  Style& style = stage.instances[0].style;
  style.toneCool = style.toneWarm = {1, 1, 1};
  style.coolSurface = style.warmSurface = 0;
  const Picture grey = draw(stage);
  const auto tone = [&](const Hit& hit) {
    const Vec3d pixel = stage.project(hit.position);
    const double stripes = at(grey, static_cast<int>(pixel.x), static_cast<int>(pixel.y)).r / 255.0;
    return between(kCool, kWarm, hit.position.x) * stripes;
  };
  expectPicture(stage, metal, hitSphere, tone, 2 * kRounding + kFacets);
}

}  // namespace
}  // namespace limn::testing
