// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages between a picture's radiance and its last bytes, against their formulas.
#include "Rendering/Post/EffectPlanes.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

class PostEffectsTest : public BothBackends {
 protected:
  void apply(const PostEffects& effects, const Camera& camera, Picture& picture) const
  {
    EffectPlanes planes;
    const Status status =
        applyEffects(effects, camera, picture.frame(Background::kBlend), planes, {GetParam(), 2});
    EXPECT_TRUE(status.ok()) << status.message;
  }
  void apply(const PostEffects& effects, Picture& picture) const
  {
    apply(effects, Stage{}.camera(), picture);
  }
};
LIMN_ON_BOTH_BACKENDS(PostEffectsTest);

/// Grey or coloured radiance, pixel by pixel, with old bytes that have to go.
Picture radiant(int width, int height, const std::function<Vec3f(int, int)>& radiance)
{
  Picture picture(width, height);
  picture.color.assign(picture.color.size(), {9, 99, 199, 77});
  picture.addRadiance();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(y * width + x);
      const Vec3f value = radiance(x, y);
      picture.radiance[0][i] = value.x;
      picture.radiance[1][i] = value.y;
      picture.radiance[2][i] = value.z;
    }
  return picture;
}
Vec3f grey(double value)
{
  const auto v = static_cast<float>(value);
  return {v, v, v};
}
double byteOf(double value)
{
  return 255 * std::min(std::max(value, 0.0), 1.0);
}

/// Bytes as they are: black, white and alpha 200.
Picture blackAndWhite(int width, int height, const std::function<bool(int, int)>& isWhite)
{
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto v = static_cast<std::uint8_t>(isWhite(x, y) ? 255 : 0);
      picture.color[static_cast<std::size_t>(y * width + x)] = {v, v, v, 200};
    }
  return picture;
}

// ---- radiance ----

class Radiance : public BothBackends {
 protected:
  Picture drawn(const Stage& stage, Background background, Rgba8 old = {0, 0, 0, 0}) const
  {
    Picture picture(stage.width, stage.height);
    picture.color.assign(picture.color.size(), old);
    picture.addRadiance();
    const Status status = render(stage.scene(), picture.frame(background), {GetParam(), 1});
    EXPECT_TRUE(status.ok()) << status.message;
    return picture;
  }
};
LIMN_ON_BOTH_BACKENDS(Radiance);

TEST_P(Radiance, KnowsColoursAboveOne)
{
  Stage stage = pixelStage(32, 1);
  const OwnedMesh square = sheet({4, 4, 0}, {24, 0, 0}, {0, 24, 0});
  for (const ShadingFrequency frequency :
       {ShadingFrequency::kFlat, ShadingFrequency::kGouraud, ShadingFrequency::kPhong}) {
    stage.instances = {painted(square, {2.5f, 0.25f, 7})};
    stage.instances[0].style.frequency = frequency;
    const Picture picture = drawn(stage, Background::kBlend, {0, 51, 0, 0});
    const std::size_t outside = 1 * 32 + 1;
    // Amid a triangle, and on the line between the two.
    for (const std::size_t inside : {10u * 32 + 20, 16u * 32 + 16}) {
      EXPECT_EQ(picture.radiance[0][inside], 2.5f);
      EXPECT_EQ(picture.radiance[1][inside], 0.25f);
      EXPECT_EQ(picture.radiance[2][inside], 7.0f);
      EXPECT_EQ(picture.color[inside].r, 255);
    }
    EXPECT_EQ(picture.radiance[1][outside], 51 / 255.0f);
  }
}

TEST_P(Radiance, IsBoundedByTheLargestHalfFloat)
{
  Stage stage = pixelStage(32, 4);
  const OwnedMesh square = sheet({4, 4, 0}, {24, 0, 0}, {0, 24, 0});
  for (const ShadingFrequency frequency : {ShadingFrequency::kFlat, ShadingFrequency::kPhong}) {
    stage.instances = {painted(square, {1e38f, 1, 1})};
    stage.instances[0].style.frequency = frequency;
    const Picture picture = drawn(stage, Background::kBlend);
    for (std::size_t y = 5; y < 27; ++y)
      for (std::size_t x = 5; x < 27; ++x)
        ASSERT_EQ(picture.radiance[0][y * 32 + x], 65504.0f) << x << ", " << y;
  }
}

TEST_P(Radiance, IsTheLinearMeanOfThePixelsSamples)
{
  for (const int samples : {2, 4, 8}) {
    Stage stage = pixelStage(32, samples);
    const OwnedMesh low = sheet({4, 4, 0}, {24.5, 0, 0}, {0, 12.5, 0});
    const OwnedMesh high = sheet({4, 16.5, 0}, {24.5, 0, 0}, {0, 8, 0});
    stage.instances = {painted(low, {3, 0, 0}), painted(high, {0, 1, 0})};
    // Half of a pixel's samples lie in each half, at any number of them.
    const Picture blended = drawn(stage, Background::kBlend, {0, 0, 255, 0});
    const std::size_t border = 16 * 32 + 10, rim = 8 * 32 + 28, corner = 16 * 32 + 28;
    EXPECT_EQ(blended.radiance[0][border], 1.5f);
    EXPECT_EQ(blended.radiance[1][border], 0.5f);
    EXPECT_EQ(blended.radiance[0][rim], 1.5f);
    EXPECT_EQ(blended.radiance[2][rim], 0.5f);
    EXPECT_EQ(blended.radiance[2][corner], 0.5f);
    const Picture apart = drawn(stage, Background::kKeepApart, {0, 0, 255, 0});
    EXPECT_EQ(apart.radiance[0][rim], 3.0f);
    EXPECT_EQ(apart.radiance[2][rim], 0.0f);
  }
}

TEST_P(Radiance, IsClearedWithTheColour)
{
  Stage stage = pixelStage(32, 1);
  const OwnedMesh square = sheet({4, 4, 0}, {4, 0, 0}, {0, 4, 0});
  stage.instances = {painted(square, {1, 1, 1})};
  Picture picture(32, 32);
  picture.addRadiance();
  FrameView frame = picture.frame(Background::kBlend);
  frame.clear = {FrameClear::Extent::kAll, {51, 102, 255, 0}, 1.0f};
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
  EXPECT_EQ(picture.radiance[0][31 * 32 + 31], 51 / 255.0f);
  EXPECT_EQ(picture.radiance[1][31 * 32 + 31], 102 / 255.0f);
  EXPECT_EQ(picture.radiance[2][31 * 32 + 31], 1.0f);
}

TEST_P(Radiance, LeavesTheBytesAsTheyAreWithoutIt)
{
  Stage stage = pixelStage(64, 4);
  const OwnedMesh square = sheet({4.3, 4.7, 0}, {40, 3, 0}, {5, 24, 0});
  stage.instances = {painted(square, {0.7f, 0.2f, 1.5f})};
  const Picture plain = stage.draw(GetParam());
  const Picture radiant = drawn(stage, Background::kBlend);
  EXPECT_EQ(std::memcmp(plain.color.data(), radiant.color.data(), plain.color.size() * 4), 0);
}

// ---- exposure and tone mapping ----

/// Compares tone mapping of coloured radiance from 0 to 20 with `curve`, which gets the channel and
/// the luminance.
void expectCurve(const std::function<void(Picture&)>& map,
                 const std::function<double(double, double)>& curve)
{
  const auto color = [](int x, int y) {
    return Vec3f{static_cast<float>(x * x) / 200, static_cast<float>(y) / 8,
                 static_cast<float>(x + y) / 100};
  };
  Picture picture = radiant(63, 37, color);
  map(picture);
  for (int y = 0; y < 37; ++y)
    for (int x = 0; x < 63; ++x) {
      const Vec3d c = vec3Cast<double>(color(x, y));
      const double luminance = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
      ASSERT_NEAR(at(picture, x, y).r, byteOf(curve(c.x, luminance)), 0.501);
      ASSERT_NEAR(at(picture, x, y).g, byteOf(curve(c.y, luminance)), 0.501);
      ASSERT_NEAR(at(picture, x, y).b, byteOf(curve(c.z, luminance)), 0.501);
      ASSERT_EQ(at(picture, x, y).a, 77) << "alpha stays";
    }
}

TEST_P(PostEffectsTest, WithoutToneMappingColoursAreClamped)
{
  PostEffects effects;
  effects.exposure = 0.5f;
  expectCurve([&](Picture& picture) { apply(effects, picture); },
              [](double c, double) { return c / 2; });
}

TEST_P(PostEffectsTest, ReinhardDividesByOnePlusLuminance)
{
  PostEffects effects;
  effects.toneMapping = ToneMapping::kReinhard;
  expectCurve([&](Picture& picture) { apply(effects, picture); },
              [](double c, double luminance) { return c / (1 + luminance); });
}

TEST_P(PostEffectsTest, ExtendedReinhardMapsItsWhitePointToWhite)
{
  PostEffects effects;
  effects.toneMapping = ToneMapping::kReinhardExtended;
  effects.whitePoint = 3;
  expectCurve([&](Picture& picture) { apply(effects, picture); },
              [](double c, double l) { return c * (1 + l / 9) / (1 + l); });
  Picture picture = radiant(8, 1, [](int x, int) { return grey(x < 4 ? 3 : 2.9); });
  apply(effects, picture);
  EXPECT_EQ(at(picture, 1, 0).r, 255);
  EXPECT_LT(at(picture, 5, 0).r, 255);
}

TEST_P(PostEffectsTest, AcesIsNarkowiczsFit)
{
  PostEffects effects;
  effects.toneMapping = ToneMapping::kAces;
  expectCurve(
      [&](Picture& picture) { apply(effects, picture); },
      [](double c, double) { return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14); });
}

TEST_P(PostEffectsTest, ExposureMultipliesRadiance)
{
  for (const ToneMapping curve : {ToneMapping::kReinhard, ToneMapping::kAces}) {
    PostEffects effects;
    effects.toneMapping = curve;
    const auto ramp = [](double scale) {
      return radiant(50, 3, [scale](int x, int y) { return grey(scale * (x + y) / 20.0); });
    };
    Picture twice = ramp(2), exposed = ramp(1);
    apply(effects, twice);
    effects.exposure = 2;
    apply(effects, exposed);
    EXPECT_EQ(std::memcmp(twice.color.data(), exposed.color.data(), 50 * 3 * 4), 0);
  }
}

// ---- bloom ----

/// What one unit of light at `from` becomes in a row of `size` pixels on its way through `levels`
/// levels of a pyramid, from the definition of its weights.
std::vector<double> spreadRow(int size, int from, int levels)
{
  std::vector<std::vector<double>> row = {std::vector<double>(static_cast<std::size_t>(size), 0.0)};
  row[0][static_cast<std::size_t>(from)] = 1;
  const auto valueAt = [](const std::vector<double>& values, int i) {
    return i < 0 || i >= static_cast<int>(values.size()) ? 0.0
                                                         : values[static_cast<std::size_t>(i)];
  };
  constexpr double kWeights[5] = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
  std::vector<double> values = row[0];
  std::vector<int> sizes;
  for (int level = 0; level < levels; ++level) {
    sizes.push_back(static_cast<int>(values.size()));
    std::vector<double> coarse((values.size() + 1) / 2, 0.0);
    for (std::size_t i = 0; i < coarse.size(); ++i)
      for (int k = -2; k <= 2; ++k)
        coarse[i] += kWeights[k + 2] * valueAt(values, 2 * static_cast<int>(i) + k);
    values = coarse;
  }
  for (int level = levels - 1; level >= 0; --level) {
    std::vector<double> fine(static_cast<std::size_t>(sizes[static_cast<std::size_t>(level)]), 0.0);
    // Each coarse value lands with twice the weights about twice its place.
    for (int i = 0; i < static_cast<int>(values.size()); ++i)
      for (int k = -2; k <= 2; ++k) {
        const int x = 2 * i + k;
        if (x >= 0 && x < static_cast<int>(fine.size()))
          fine[static_cast<std::size_t>(x)] +=
              2 * kWeights[k + 2] * values[static_cast<std::size_t>(i)];
      }
    values = fine;
  }
  return values;
}

struct Spot {
  int x, y;
  double radiance;
};
constexpr int kBloomWidth = 131, kBloomHeight = 97;
Picture spotPicture(const Spot& spot)
{
  return radiant(kBloomWidth, kBloomHeight, [&](int x, int y) {
    return x == spot.x && y == spot.y ? grey(spot.radiance) : grey(0);
  });
}

TEST_P(PostEffectsTest, BloomOfOneBrightPixelIsThePyramidsKernel)
{
  for (const int levels : {1, 2, 5})
    for (const Spot& spot : {Spot{64, 48, 301}, Spot{65, 48, 301}, Spot{61, 51, 61}}) {
      PostEffects effects;
      effects.bloom.strength = 0.5f;
      effects.bloom.threshold = 1;
      effects.bloom.levels = levels;
      Picture picture = spotPicture(spot);
      apply(effects, picture);
      double sum = 0, lit = 0;
      std::vector<std::vector<double>> columns, rows;
      for (int level = 1; level <= levels; ++level) {
        columns.push_back(spreadRow(kBloomWidth, spot.x, level));
        rows.push_back(spreadRow(kBloomHeight, spot.y, level));
      }
      for (int y = 0; y < kBloomHeight; ++y)
        for (int x = 0; x < kBloomWidth; ++x) {
          double kernel = 0;
          for (std::size_t level = 0; level < columns.size(); ++level)
            kernel += columns[level][static_cast<std::size_t>(x)] *
                      rows[level][static_cast<std::size_t>(y)] / levels;
          sum += kernel;
          if (x == spot.x && y == spot.y) continue;
          const double added = 0.5 * (spot.radiance - 1) * kernel;
          lit += added > 0.01;
          ASSERT_NEAR(at(picture, x, y).g, byteOf(added), 0.51)
              << levels << " levels at " << x << ", " << y;
        }
      EXPECT_GT(lit, 20);
      if (levels < 5) {
        EXPECT_NEAR(sum, 1, 1e-12) << "no light is lost";
      }
    }
}

TEST(Bloom, AddsItsStrengthTimesTheBrightLight)
{
  Picture picture = radiant(200, 180, [](int x, int y) {
    const bool isBright = (x - 100) * (x - 100) + (y - 90) * (y - 90) < 100;
    return isBright ? Vec3f{5, 2, 0.5f} : grey(0.3);
  });
  PostEffects effects;
  effects.bloom = {0.8f, 1, 3};
  EffectPlanes planes;
  const auto sums = [](const auto& valueAt) {
    std::array<double, 3> sum = {};
    for (std::size_t c = 0; c < 3; ++c)
      for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 200; ++x)
          sum[c] += valueAt(c, x, y);
    return sum;
  };
  const auto before = sums([&](std::size_t c, int x, int y) {
    return picture.radiance[c][static_cast<std::size_t>(y * 200 + x)];
  });
  ASSERT_TRUE(applyEffects(effects, Stage{}.camera(), picture.frame(Background::kBlend), planes,
                           {Backend::kPipeline, 2})
                  .ok());
  const auto after = sums([&](std::size_t c, int x, int y) { return planes.image[c].row(y)[x]; });
  int bright = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 200; ++x)
      bright += (x - 100) * (x - 100) + (y - 90) * (y - 90) < 100;
  // Of (5, 2, 0.5) the part (5 - 1) / 5 is above the threshold.
  const double part = 0.8 * bright * 0.8;
  EXPECT_NEAR(after[0] - before[0], 5 * part, 5 * part * 1e-5);
  EXPECT_NEAR(after[1] - before[1], 2 * part, 2 * part * 1e-5);
  EXPECT_NEAR(after[2] - before[2], 0.5 * part, 0.5 * part * 1e-4);
}

TEST_P(PostEffectsTest, BloomLeavesWhatIsNotBrightAsItIs)
{
  const auto dim = [](int x, int y) { return grey((x * 7 + y * 13) % 100 / 100.0); };
  Picture plain = radiant(90, 70, dim), bloomed = plain;
  PostEffects effects;
  effects.toneMapping = ToneMapping::kReinhard;
  apply(effects, plain);
  effects.bloom.strength = 3;
  apply(effects, bloomed);
  EXPECT_EQ(std::memcmp(plain.color.data(), bloomed.color.data(), plain.color.size() * 4), 0);
}

// ---- depth of field ----

constexpr double kFocus = 3;

PostEffects lensOf(double aperture, int maxRadius = 30)
{
  PostEffects effects;
  effects.depthOfField = {static_cast<float>(aperture), static_cast<float>(kFocus), maxRadius};
  return effects;
}

/// A camera at (0, 0, 3) that looks along -z at the points of its axis.
Stage lensStage()
{
  Stage stage;
  stage.view = perspectiveView({0, 0, kFocus}, {0, 0, 0}, 40, {0.5, 30});
  stage.width = stage.height = 141;
  return stage;
}
float depthAtDistance(const Stage& stage, double distance)
{
  return static_cast<float>(stage.project({0, 0, kFocus - distance}).z);
}
/// Radius in pixels of the disc of a point, from the thin lens itself: rays from the rim of the
/// lens to a point at distance d meet the plane of focus in a circle.
double discRadius(const Stage& stage, double aperture, double distance)
{
  const double onFocus = aperture / 2 * std::fabs(distance - kFocus) / distance;
  const double pixelsPerUnit =
      stage.height / (2 * kFocus * std::tan(stage.view.fovyDegrees * kPi / 360));
  return onFocus * pixelsPerUnit;
}

TEST_P(PostEffectsTest, APointBecomesTheDiscOfAThinLens)
{
  const Stage stage = lensStage();
  constexpr int kMiddle = 70;
  int cases = 0;
  for (const double distance : {1.2, 2.0, 6.0, 20.0})
    for (const double aperture : {0.1, 0.2}) {
      const double radius = discRadius(stage, aperture, distance);
      if (radius < 2 || radius > 25) continue;
      ++cases;
      const double area = kPi * radius * radius;
      Picture picture = radiant(stage.width, stage.height, [&](int x, int y) {
        return grey(x == kMiddle && y == kMiddle ? 0.8 * area : 0);
      });
      picture.depth.assign(picture.depth.size(), depthAtDistance(stage, distance));
      apply(lensOf(aperture), stage.camera(), picture);
      double sum = 0;
      for (int y = 0; y < stage.height; ++y)
        for (int x = 0; x < stage.width; ++x) {
          const double away = std::hypot(x - kMiddle, y - kMiddle);
          const int value = at(picture, x, y).r;
          sum += value;
          if (away > radius + 0.51) {
            ASSERT_EQ(value, 0) << distance << ": " << away;
          } else if (away < radius - 0.51) {
            ASSERT_NEAR(value, 0.8 * 255, 0.8 * 255 * 0.03) << away;
          }
        }
      // All of the light, spread evenly over the disc: its area says its radius.
      EXPECT_NEAR(std::sqrt(sum / (0.8 * 255) / kPi), radius, 0.015 * radius) << distance;
    }
  EXPECT_EQ(cases, 6);
}

TEST_P(PostEffectsTest, ThePlaneOfFocusStaysSharpToTheBit)
{
  Stage stage = lensStage();
  const OwnedMesh board = sheet({-2, -2, 0}, {4, 0, 0}, {0, 4, 0});
  stage.instances = {painted(board, {1, 1, 1})};
  Picture sharp = radiant(stage.width, stage.height,
                          [](int x, int y) { return grey((x * 31 + y * 17) % 11 / 7.0); });
  ASSERT_TRUE(render(stage.scene(), sharp.frame(Background::kBlend), {GetParam(), 1}).ok());
  for (int i = 0; i < stage.width * stage.height; ++i)
    for (auto& plane : sharp.radiance)
      plane[static_cast<std::size_t>(i)] = static_cast<float>(i * 31 % 97) / 77;
  Picture blurred = sharp;
  apply(lensOf(1), stage.camera(), blurred);
  PostEffects idle;
  idle.bloom = {1, kMaxRadiance, 1};
  apply(idle, stage.camera(), sharp);
  EXPECT_EQ(std::memcmp(sharp.color.data(), blurred.color.data(), sharp.color.size() * 4), 0);
}

TEST_P(PostEffectsTest, ASharpThingBeforeABlurredOneKeepsItsColour)
{
  const Stage stage = lensStage();
  const auto isThing = [](int x, int y) { return x > 60 && x < 80 && y > 50 && y < 90; };
  Picture picture = radiant(stage.width, stage.height, [&](int x, int y) {
    return isThing(x, y) ? Vec3f{0.5f, 0, 0} : Vec3f{0, 40, 0};
  });
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x)
      picture.depth[static_cast<std::size_t>(y * stage.width + x)] =
          depthAtDistance(stage, isThing(x, y) ? kFocus : 20);
  apply(lensOf(0.3), stage.camera(), picture);
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x)
      if (isThing(x, y)) {
        ASSERT_EQ(at(picture, x, y).r, 128);
        ASSERT_EQ(at(picture, x, y).g, 0);
      }
}

TEST_P(PostEffectsTest, ABlurredThingBeforeASharpOneSpreadsOverIt)
{
  const Stage stage = lensStage();
  const auto isThing = [](int x, int) { return x < 70; };
  Picture picture =
      radiant(stage.width, stage.height, [&](int x, int y) { return grey(isThing(x, y) ? 1 : 0); });
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x) {
      const auto i = static_cast<std::size_t>(y * stage.width + x);
      picture.depth[i] = depthAtDistance(stage, isThing(x, y) ? 1.5 : kFocus);
      picture.color[i].a = isThing(x, y) ? 255 : 0;
    }
  const double radius = discRadius(stage, 0.15, 1.5);
  ASSERT_GT(radius, 4);
  apply(lensOf(0.15), stage.camera(), picture);
  const int reach = static_cast<int>(radius);
  EXPECT_GT(at(picture, 70, 70).r, 40);
  EXPECT_GT(at(picture, 70, 70).a, 40) << "coverage is blurred with the colour";
  EXPECT_GT(at(picture, 70 + reach - 2, 70).r, 0);
  EXPECT_EQ(at(picture, 70 + reach + 2, 70).r, 0);
  EXPECT_EQ(at(picture, 70 - reach - 2, 70).r, 255);
}

TEST_P(PostEffectsTest, APointBeforeASharpGroundCoversItByTheShareOfItsDisc)
{
  const Stage stage = lensStage();
  constexpr int kMiddle = 70;
  const auto isPoint = [](int x, int y) { return x == kMiddle && y == kMiddle; };
  constexpr double kBright = 20;
  Picture picture = radiant(stage.width, stage.height,
                            [&](int x, int y) { return grey(isPoint(x, y) ? kBright : 0); });
  picture.depth.assign(picture.depth.size(), depthAtDistance(stage, kFocus));
  picture.depth[kMiddle * 141 + kMiddle] = depthAtDistance(stage, 1.5);
  const double aperture = 0.2, radius = discRadius(stage, aperture, 1.5);
  apply(lensOf(aperture), stage.camera(), picture);
  // The ground has its own pixel whole, the point one in so many: their weights are 1 : 1 / area.
  const double area = kPi * radius * radius;
  EXPECT_NEAR(at(picture, kMiddle + 3, kMiddle).r, byteOf(kBright / (1 + area)), 1);
  EXPECT_NEAR(at(picture, kMiddle, kMiddle - 4).r, byteOf(kBright / (1 + area)), 1);
}

TEST_P(PostEffectsTest, DiscsReachIntoTheNextTiles)
{
  const Stage stage = lensStage();
  // One near pixel on each side of the lines at 64 between the tiles, and in the corner.
  const struct {
    int x, y, dx, dy;
  } cases[] = {{32, 62, 0, 4}, {32, 66, 0, -4},  {62, 32, 4, 0},  {66, 32, -4, 0},
               {63, 63, 3, 3}, {64, 64, -3, -3}, {64, 63, -3, 3}, {63, 64, 3, -3}};
  for (const auto& one : cases) {
    Picture picture = radiant(stage.width, stage.height, [&](int x, int y) {
      return grey(x == one.x && y == one.y ? 60 : 0);
    });
    picture.depth.assign(picture.depth.size(), depthAtDistance(stage, kFocus));
    picture.depth[static_cast<std::size_t>(one.y * stage.width + one.x)] =
        depthAtDistance(stage, 1.5);
    apply(lensOf(0.2), stage.camera(), picture);
    EXPECT_GT(at(picture, one.x + one.dx, one.y + one.dy).r, 20) << one.x << ", " << one.y;
  }
}

TEST_P(PostEffectsTest, NoDiscIsLargerThanAsked)
{
  const Stage stage = lensStage();
  Picture picture = radiant(stage.width, stage.height,
                            [](int x, int y) { return grey(x == 70 && y == 70 ? 60 : 0); });
  picture.depth.assign(picture.depth.size(), depthAtDistance(stage, 1));
  apply(lensOf(5, 4), stage.camera(), picture);
  EXPECT_GT(at(picture, 74, 70).r, 0);
  EXPECT_EQ(at(picture, 75, 70).r, 0);
}

// ---- FXAA ----

PostEffects fxaa()
{
  PostEffects effects;
  effects.fxaa.enabled = true;
  return effects;
}

TEST_P(PostEffectsTest, FxaaLeavesPlainAreasAndStraightEdgesAlone)
{
  const std::function<bool(int, int)> pictures[] = {[](int, int) { return true; },
                                                    [](int x, int) { return x < 20; },
                                                    [](int, int y) { return y < 9; }};
  for (const auto& isWhite : pictures)
    for (const bool quality : {true, false}) {
      Picture picture = blackAndWhite(47, 33, isWhite);
      const Picture before = picture;
      PostEffects effects = fxaa();
      effects.fxaa.highQualityEndpoints = quality;
      apply(effects, picture);
      EXPECT_EQ(picture.differingPixels(before), 0u);
    }
}

TEST_P(PostEffectsTest, FxaaSmoothsADiagonal)
{
  Picture picture = blackAndWhite(40, 40, [](int x, int y) { return x + y >= 40; });
  apply(fxaa(), picture);
  for (int x = 4; x < 36; ++x) {
    // Half of the pixel's neighbours differ: (1/2 - 1/4) / (1 - 1/4) = 1/3 of the mean of the 3 x 3
    // pixels, of which 3 are of the other colour, is blended in.
    EXPECT_EQ(at(picture, x, 39 - x).r, 28) << "1/3 * 3/9 of 255";
    EXPECT_EQ(at(picture, x, 40 - x).r, 227);
    EXPECT_EQ(at(picture, x, 38 - x).r, 0);
    EXPECT_EQ(at(picture, x, 41 - x).r, 255);
    EXPECT_EQ(at(picture, x, 40 - x).a, 200);
  }
}

TEST_P(PostEffectsTest, FxaaMovesPixelsAcrossAnEdgeByTheirDistanceFromItsEnd)
{
  // A stair that rises by a pixel every 8, once along x and once along y.
  for (const bool isTurned : {false, true})
    for (const bool quality : {true, false}) {
      Picture picture = blackAndWhite(64, 64, [&](int x, int y) {
        return isTurned ? 8 * x >= y - y % 8 + 128 : 8 * y >= x - x % 8 + 128;
      });
      PostEffects effects = fxaa();
      effects.fxaa.subpixelBlendLimit = 0;
      effects.fxaa.highQualityEndpoints = quality;
      apply(effects, picture);
      const auto value = [&](int along, int across) {
        return at(picture, isTurned ? across : along, isTurned ? along : across).r;
      };
      // Columns 24 to 31: white from row 19 on; the next step is at column 32.
      for (int i = 0; i < 8; ++i) {
        const int before = i + 1, after = 8 - i;
        const double white = before < after ? 0.5 - before / 9.0 : 0;
        const double black = after <= before ? 0.5 - after / 9.0 : 0;
        EXPECT_NEAR(value(24 + i, 19), 255 * (1 - black), 0.51) << "the white side, " << i;
        EXPECT_NEAR(value(24 + i, 18), 255 * white, 0.51) << "the black side, " << i;
      }
    }
}

TEST_P(PostEffectsTest, FxaaLooksAtContrastsAboveItsThresholdsOnly)
{
  PostEffects effects = fxaa();
  effects.fxaa.hardContrastThreshold = 0.1f;
  effects.fxaa.relativeContrastThreshold = 0.1f;
  for (const int contrast : {20, 32}) {
    Picture picture = blackAndWhite(40, 40, [](int x, int y) { return x + y >= 40; });
    for (Rgba8& c : picture.color)
      c.r = c.g = c.b = static_cast<std::uint8_t>(c.r == 0 ? 100 : 100 + contrast);
    const Picture before = picture;
    apply(effects, picture);
    EXPECT_EQ(picture.differingPixels(before) > 0, contrast > 25.5);
  }
}

TEST_P(PostEffectsTest, FxaaReadsThePicturesBorderBeyondIt)
{
  Picture picture = blackAndWhite(1, 1, [](int, int) { return true; });
  apply(fxaa(), picture);
  EXPECT_EQ(at(picture, 0, 0).r, 255);
  // An edge along the border has no end there.
  Picture edge = blackAndWhite(30, 2, [](int, int y) { return y == 0; });
  const Picture before = edge;
  apply(fxaa(), edge);
  EXPECT_EQ(edge.differingPixels(before), 0u);
}

// ---- the chain ----

TEST_P(PostEffectsTest, StagesFollowEachOther)
{
  // Light of 8 on a black ground: bloom sees what the exposure made of it, the curve sees the
  // bloom.
  Picture picture = spotPicture({64, 48, 8});
  PostEffects effects;
  effects.exposure = 4;
  effects.bloom = {1, 2, 1};
  effects.toneMapping = ToneMapping::kReinhard;
  apply(effects, picture);
  const double beside = spreadRow(kBloomWidth, 64, 1)[65] * spreadRow(kBloomHeight, 48, 1)[48];
  const double added = (4 * 8 - 2) * beside;
  EXPECT_NEAR(at(picture, 65, 48).r, byteOf(added / (1 + added)), 0.51);
}

TEST_P(PostEffectsTest, ThoseLeftOutChangeNothing)
{
  Picture picture = radiant(20, 20, [](int x, int y) { return grey(x * y / 100.0); });
  const Picture before = picture;
  apply(PostEffects{}, picture);
  EXPECT_EQ(picture.differingPixels(before), 0u);
}

TEST(EffectPlanes, KeepTheirMemory)
{
  Picture picture = radiant(300, 200, [](int x, int y) { return grey(x * y / 100.0); });
  PostEffects effects = lensOf(0.1);
  effects.bloom.strength = 1;
  effects.fxaa.enabled = true;
  EffectPlanes planes;
  const auto draw = [&] {
    FrameView frame = picture.frame(Background::kBlend);
    frame.radiance = planes.radianceOf(frame, 1);
    ASSERT_TRUE(applyEffects(effects, lensStage().camera(), frame, planes).ok());
  };
  draw();
  const std::size_t bytes = planes.bytes();
  const float* const first = planes.luma.row(0);
  EXPECT_GT(bytes, 300u * 200 * 40);
  for (int i = 0; i < 3; ++i)
    draw();
  EXPECT_EQ(planes.bytes(), bytes);
  EXPECT_EQ(planes.luma.row(0), first);
}

// ---- errors ----

TEST_P(PostEffectsTest, ErrorsNameTheSettingAndChangeNothing)
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const struct {
    std::function<void(PostEffects&)> spoil;
    const char* word;
  } cases[] = {
      {[](PostEffects& e) { e.exposure = -1; }, "exposure"},
      {[](PostEffects& e) { e.exposure = kNan; }, "exposure"},
      {[](PostEffects& e) { e.exposure = kInfinity; }, "exposure"},
      {[](PostEffects& e) { e.whitePoint = 0; }, "white point"},
      {[](PostEffects& e) { e.whitePoint = kNan; }, "white point"},
      {[](PostEffects& e) { e.bloom.strength = -0.1f; }, "bloom"},
      {[](PostEffects& e) { e.bloom.strength = kNan; }, "bloom"},
      {[](PostEffects& e) { e.bloom.threshold = -1; }, "bloom"},
      {[](PostEffects& e) { e.bloom.levels = 0; }, "levels"},
      {[](PostEffects& e) { e.bloom.levels = 9; }, "levels"},
      {[](PostEffects& e) { e.depthOfField.aperture = -1; }, "aperture"},
      {[](PostEffects& e) { e.depthOfField.aperture = kNan; }, "aperture"},
      {[](PostEffects& e) { e.depthOfField.aperture = 3e38f; }, "aperture"},
      {[](PostEffects& e) {
         e.depthOfField = {1, 0, 16};
       },
       "focus"},
      {[](PostEffects& e) {
         e.depthOfField = {1, kNan, 16};
       },
       "focus"},
      {[](PostEffects& e) {
         e.depthOfField = {1, 1, 64};
       },
       "radius"},
      {[](PostEffects& e) {
         e.depthOfField = {1, 1, 0};
       },
       "radius"},
      {[](PostEffects& e) { e.fxaa.hardContrastThreshold = 2; }, "FXAA"},
      {[](PostEffects& e) { e.fxaa.subpixelBlendLimit = kNan; }, "FXAA"},
      {[](PostEffects& e) { e.fxaa.endpointSearchIterations = -1; }, "FXAA"},
  };
  for (const auto& one : cases) {
    PostEffects effects = fxaa();
    effects.toneMapping = ToneMapping::kAces;
    one.spoil(effects);
    Picture picture = radiant(16, 16, [](int x, int y) { return grey(x + y); });
    const Picture before = picture;
    EffectPlanes planes;
    const Status status = applyEffects(effects, lensStage().camera(),
                                       picture.frame(Background::kBlend), planes, {GetParam(), 1});
    EXPECT_EQ(status.error, Error::kNotFinite) << one.word;
    EXPECT_NE(status.message.find(one.word), std::string::npos) << status.message;
    EXPECT_EQ(picture.differingPixels(before), 0u);
  }
}

TEST_P(PostEffectsTest, ErrorsNameWhatIsMissing)
{
  Picture picture = blackAndWhite(16, 16, [](int x, int y) { return x > y; });
  EffectPlanes planes;
  const auto statusOf = [&](const PostEffects& effects, const Camera& camera) {
    return applyEffects(effects, camera, picture.frame(Background::kBlend), planes,
                        {GetParam(), 1});
  };
  PostEffects bright;
  bright.exposure = 2;
  EXPECT_EQ(statusOf(bright, lensStage().camera()).error, Error::kMissingData);
  EXPECT_TRUE(statusOf(fxaa(), lensStage().camera()).ok()) << "works on bytes alone";
  picture.addRadiance();
  Stage parallel = lensStage();
  parallel.view.parallel = true;
  const Status status = statusOf(lensOf(1), parallel.camera());
  EXPECT_EQ(status.error, Error::kMissingData);
  EXPECT_NE(status.message.find("perspective"), std::string::npos);
  FrameView frame = picture.frame(Background::kBlend);
  frame.radiance.g = nullptr;
  Stage stage;
  EXPECT_EQ(render(stage.scene(), frame, {GetParam(), 1}).error, Error::kMissingData);
}

}  // namespace
}  // namespace limn::testing
