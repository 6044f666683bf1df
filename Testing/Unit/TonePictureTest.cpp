// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tones that are pictures: X-Toon's ramps and lit spheres. The picture shows where it is read: red
// grows to the right, green upwards.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class TonePictures : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(TonePictures);

constexpr int kSide = 256;
/// Of a picture of so many texels: their own rounding, and half a texel at the edges.
constexpr double kTexels = 0.6;

const TextureImage& coordinates()
{
  static const TextureImage* const kImage = [] {
    static TextureImage image;
    std::vector<float> texels;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (const float value :
             {(static_cast<float>(x) + 0.5f) / kSide, (static_cast<float>(y) + 0.5f) / kSide, 0.0f})
          texels.push_back(value);
    const TextureView view = {
        kSide, kSide, 3, TexelFormat::kFloat32, texels.data(), texels.size() * sizeof(float)};
    EXPECT_TRUE(image.build(view, MipChain::kNone).ok());
    return &image;
  }();
  return *kImage;
}

Stage pictured(Tone tone, RampDetail detail, float exponent)
{
  Stage stage;
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.tone = tone;
  stage.instances[0].style.ramp = {&coordinates(), detail, exponent, 0, 0};
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-1, -1, -2};
  stage.lights = {light};
  return stage;
}

/// n.l, within the texels.
double tone(const Hit& hit)
{
  return std::clamp(dot(hit.normal, normalized(Vec3d{1, 1, 2})), 0.5 / kSide, 1 - 0.5 / kSide);
}
double within(double detail)
{
  return std::clamp(detail, 0.5 / kSide, 1 - 0.5 / kSide);
}

TEST_P(TonePictures, RampsReadTheToneAndTheSilhouette)
{
  for (const float exponent : {1.0f, 0.5f, 3.0f}) {
    const Stage stage = pictured(Tone::kRamp, RampDetail::kSilhouette, exponent);
    const auto color = [&](const Hit& hit) {
      const double nv = std::fabs(dot(hit.normal, hit.towardEye));
      return Vec3d{tone(hit), within(std::pow(nv, exponent)), 0};
    };
    expectPicture(stage, draw(stage), hitSphere, color, kTexels + 3 * kFacets);
  }
}

TEST_P(TonePictures, RampsReadTheHighlight)
{
  const Stage stage = pictured(Tone::kRamp, RampDetail::kHighlight, 5);
  const Vec3d l = normalized(Vec3d{1, 1, 2});
  const auto color = [&](const Hit& hit) {
    const double rv = dot(hit.normal * (2 * dot(hit.normal, l)) - l, hit.towardEye);
    return Vec3d{tone(hit), within(std::pow(std::max(0.0, rv), 5)), 0};
  };
  expectPicture(stage, draw(stage), hitSphere, color, kTexels + 2 * steepness(5) * kFacets);
}

TEST_P(TonePictures, RampsReadTheLogarithmOfTheDepth)
{
  Stage stage = pictured(Tone::kRamp, RampDetail::kDepth, 1);
  const auto expectRange = [&](double nearest, double farthest) {
    const auto color = [&](const Hit& hit) {
      const double z = dot(stage.view.eye - hit.position, axesOf(stage.view).back);
      const double depth = 1 - std::log(z / nearest) / std::log(farthest / nearest);
      return Vec3d{tone(hit), within(depth), 0};
    };
    expectPicture(stage, draw(stage), hitSphere, color, kTexels + 2 * kFacets);
  };
  // The stage's clipping planes.
  for (const bool isParallel : {false, true}) {
    stage.view.parallel = isParallel;
    expectRange(0.5, 10);
  }
  stage.instances[0].style.ramp.nearest = 1.9f;
  stage.instances[0].style.ramp.farthest = 2.7f;
  expectRange(1.9, 2.7);
}

TEST_P(TonePictures, RampsMultiplyTheSurfacesColor)
{
  Stage stage = pictured(Tone::kRamp, RampDetail::kSilhouette, 1);
  const Picture white = draw(stage);
  stage.instances[0].material.diffuseColor = {0.5f, 0, 1};
  const Picture half = draw(stage);
  const Rgba8 full = at(white, 48, 48), color = at(half, 48, 48);
  EXPECT_NEAR(color.r, full.r / 2.0, 1);
  EXPECT_EQ(color.g, 0);
}

TEST_P(TonePictures, ALitSphereIsReadByTheNormal)
{
  Stage stage = pictured(Tone::kMatCap, RampDetail::kDepth, 1);
  stage.view.parallel = true;
  const auto color = [](const Hit& hit) {
    return Vec3d{0.5 + 0.5 * hit.normal.x, 0.5 + 0.5 * hit.normal.y, 0};
  };
  expectPicture(stage, draw(stage), hitSphere, color, kTexels + kFacets);
}

TEST_P(TonePictures, ALitSphereIsReadAboutTheRayOfThePixelInPerspective)
{
  // A sphere at the edge of a wide view: its middle, as the eye sees it, shows the picture's.
  Stage stage = pictured(Tone::kMatCap, RampDetail::kDepth, 1);
  stage.view = perspectiveView({0.9, -0.7, 2}, {0.9, -0.7, 0}, 100);
  const auto color = [](const Hit& hit) {
    const Vec3d v = hit.towardEye;
    const Vec3d right = normalized(Vec3d{v.z, 0, -v.x}), up = cross(v, right);
    return Vec3d{0.5 + 0.5 * dot(hit.normal, right), 0.5 + 0.5 * dot(hit.normal, up), 0};
  };
  const Picture picture = draw(stage);
  expectPicture(stage, picture, hitSphere, color, kTexels + 2 * kFacets);
  const Vec3d middle = stage.project(normalized(stage.view.eye));
  const Rgba8 seen = at(picture, static_cast<int>(middle.x), static_cast<int>(middle.y));
  EXPECT_NEAR(seen.r, 127.5, 4);
  EXPECT_NEAR(seen.g, 127.5, 4);
}

}  // namespace
}  // namespace limn::testing
