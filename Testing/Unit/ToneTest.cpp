// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gooch's cool and warm shading: equation (12.6) as printed, and with warm towards the light.
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

}  // namespace
}  // namespace limn::testing
