// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eye-dome lighting, depth unsharp masks, halos: their values, in both projections, and what they
// leave alone.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Rgba8 kBackground = {12, 34, 56, 78};

class DepthCuesOn : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(DepthCuesOn);

bool areEqual(Rgba8 a, Rgba8 b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

/// One unit a pixel, seen from z = `eye`, over a background.
Stage flatStage(int side, int samples, double eye = 200)
{
  Stage stage = pixelStage(side, samples);
  stage.resolve = Resolve::kLinear;
  stage.view.eye.z = eye;
  stage.view.near = 1;
  stage.view.far = 2 * eye;
  return stage;
}

Picture drawOver(const Stage& stage, Backend backend, Background background = Background::kBlend)
{
  Picture picture(stage.width, stage.height);
  std::fill(picture.color.begin(), picture.color.end(), kBackground);
  stage.drawOver(picture, backend, background);
  return picture;
}

double diagonal(const Stage& stage)
{
  return std::hypot(stage.width, stage.height);
}

/// The parts of the response to a function of the place beside a point, which gives how much nearer
/// the surface is there, in pixels.
double eyeDomeResponse(double radius, const std::function<double(double, double)>& nearer)
{
  const auto ring = [&](double r, double turn) {
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
      const double angle = (i + turn) * kPi / 4;
      const double x = std::nearbyint(r * std::cos(angle)), y = std::nearbyint(r * std::sin(angle));
      sum += std::clamp(nearer(x, y) / std::hypot(x, y), 0.0, 4.0);
    }
    return sum / 8;
  };
  const double coarse = (ring(2 * radius, 0.5) + ring(3 * radius, 0) + ring(4 * radius, 0.5)) / 3;
  return (ring(radius, 0) + coarse) / 2;
}

/// A sheet in the plane z = 0 of a flat stage, and one to the left of the middle, `step` before it.
struct Steps {
  OwnedMesh back, front;
  Steps(int side, double step)
      : back(sheet({-20.0, -20.0, 0}, {side + 40.0, 0, 0}, {0, side + 40.0, 0})),
        front(sheet({-20.0, -20.0, step}, {side / 2 + 20.0, 0, 0}, {0, side + 40.0, 0}))
  {
  }
};

TEST_P(DepthCuesOn, EyeDomeLightingDarkensTiltedPlanesByTheirSlope)
{
  constexpr int kSide = 64;
  const double middle = kSide / 2.0;
  for (const double slope : {0.0, 0.25, 1.0, 3.0})
    for (const double radius : {1.0, 1.8}) {
      const OwnedMesh plane =
          sheet({-9, -9, slope * (-9 - middle)}, {82, 0, slope * 82}, {0, 82, 0});
      Stage stage = flatStage(kSide, 1);
      stage.instances = {painted(plane, {1, 1, 1})};
      EyeDomeLighting& cue = stage.instances[0].style.cues.eyeDome;
      cue.strength = 0.7f;
      cue.radius = static_cast<float>(radius / diagonal(stage));
      const double response =
          eyeDomeResponse(radius, [&](double dx, double) { return slope * dx; });
      EXPECT_NEAR(at(draw(stage), 32, 32).g, 255 * std::exp(-0.7 * response), 0.6)
          << "slope " << slope << ", radius " << radius;
    }
}

TEST_P(DepthCuesOn, EyeDomeLightingOfAStepFallsOffWithTheDistance)
{
  constexpr int kSide = 128;
  for (const double step : {1.5, 40.0}) {
    const Steps steps(kSide, step);
    Stage stage = flatStage(kSide, 1);
    stage.instances = {painted(steps.back, {1, 1, 1}), painted(steps.front, {1, 1, 1})};
    for (Instance& instance : stage.instances)
      instance.style.cues.eyeDome = {1, static_cast<float>(2 / diagonal(stage))};
    const Picture picture = draw(stage);
    for (int x = 64; x < 78; ++x) {
      const double response =
          eyeDomeResponse(2, [&](double dx, double) { return x + dx < 64 ? step : 0.0; });
      EXPECT_NEAR(at(picture, x, 64).g, 255 * std::exp(-response), 0.6) << x << ", step " << step;
    }
    EXPECT_LT(at(picture, 64, 64).g, 210);
    EXPECT_EQ(at(picture, 63, 64).g, 255) << "what is before is not darkened";
    EXPECT_EQ(at(picture, 76, 64).g, 255);
  }
}

/// What vtkEDLShading makes of a window depth: a distance by the formula for perspective, as a
/// share of the distances that the clipping range has.
double distanceAsVtkHasIt(double depth, const Viewpoint& view)
{
  const double n = view.near, f = view.far;
  const double z = 2 * depth - 1;
  return (2 * n * f / (f + n - z * (f - n)) - n) / (f - n);
}

TEST_P(DepthCuesOn, EyeDomeLightingIsTheSameWhereverTheClippingRangeLiesAndVtksIsNot)
{
  // One step in parallel projection, near to the eye and far from it.
  constexpr int kSide = 64;
  const Steps steps(kSide, 2);
  std::vector<double> colors, vtks;
  for (const double eye : {12.0, 60.0, 390.0}) {
    Stage stage = flatStage(kSide, 1, eye);
    stage.view.near = 5;
    stage.view.far = 400;
    stage.instances = {painted(steps.back, {1, 1, 1}), painted(steps.front, {1, 1, 1})};
    stage.instances[0].style.cues.eyeDome = {1, static_cast<float>(1 / diagonal(stage))};
    colors.push_back(at(draw(stage), 32, 32).g);
    vtks.push_back(distanceAsVtkHasIt(stage.project({32, 32, 0}).z, stage.view) -
                   distanceAsVtkHasIt(stage.project({32, 32, 2}).z, stage.view));
  }
  EXPECT_EQ(colors[1], colors[0]);
  EXPECT_EQ(colors[2], colors[0]);
  EXPECT_LT(colors[0], 240);
  EXPECT_GT(std::max(vtks[0], vtks[2]) / std::min(vtks[0], vtks[2]), 100)
      << "the fault that must not be repeated";
}

TEST_P(DepthCuesOn, EyeDomeLightingIsTheSameInPerspectiveAndInParallelProjection)
{
  // The sphere over a wall, as large in the picture by both projections.
  const OwnedMesh wall = sheet({-40, -40, -1.5}, {80, 0, 0}, {0, 80, 0});
  const OwnedMesh step = sheet({-40, -40, -1.42}, {40, 0, 0}, {0, 80, 0});
  for (const double distance : {5.0, 400.0}) {
    Stage perspective, parallel;
    for (Stage* stage : {&perspective, &parallel}) {
      stage->width = stage->height = 128;
      stage->instances = {painted(wall, {1, 1, 1}), painted(step, {1, 1, 1})};
      for (Instance& instance : stage->instances)
        instance.style.cues.eyeDome = {1, static_cast<float>(2 / diagonal(*stage))};
    }
    const double half = 1.2, toWall = distance + 1.5;
    perspective.view =
        perspectiveView({0, 0, distance}, {0, 0, 0}, 2 * std::atan(half / toWall) * 180 / kPi,
                        {distance / 10, distance * 10});
    parallel.view = parallelView({0, 0, distance}, {0, 0, 0}, half, {distance / 10, distance * 10});
    const Picture first = draw(perspective), second = draw(parallel);
    EXPECT_LT(at(second, 65, 64).g, 200);
    for (int y = 0; y < 128; ++y)
      for (int x = 64; x < 80; ++x)
        ASSERT_NEAR(at(first, x, y).g, at(second, x, y).g, distance < 10 ? 5 : 1)
            << x << ", " << y << " at " << distance;
  }
}

TEST_P(DepthCuesOn, SpheresLookTheSameInPerspectiveFromFarAndInParallelProjection)
{
  DepthCues cues;
  cues.eyeDome = {1, 0.01f};
  cues.unsharp.strength = 0.7f;
  const OwnedMesh wall = sheet({-400, -400, -2}, {800, 0, 0}, {0, 800, 0});
  Stage perspective, parallel;
  for (Stage* stage : {&perspective, &parallel}) {
    stage->width = stage->height = 128;
    stage->instances = {painted(fineSphere(), {1, 1, 1}), painted(wall, {1, 1, 1})};
    for (Instance& instance : stage->instances)
      instance.style.cues = cues;
  }
  constexpr double kDistance = 1000;
  perspective.view =
      perspectiveView({0, 0, kDistance}, {0, 0, 0}, 2 * std::atan(1.8 / kDistance) * 180 / kPi,
                      {kDistance - 10, kDistance + 10});
  parallel.view = parallelView({0, 0, 10}, {0, 0, 0}, 1.8, {1, 30});
  const Picture first = draw(perspective), second = draw(parallel);
  double sum = 0;
  for (std::size_t i = 0; i < first.color.size(); ++i)
    sum += std::abs(first.color[i].g - second.color[i].g);
  EXPECT_LT(sum / static_cast<double>(first.color.size()), 0.3);
}

TEST_P(DepthCuesOn, CuesLookTheSameInALargerPicture)
{
  DepthCues cues;
  cues.eyeDome = {1, 0.02f};
  cues.unsharp.strength = 1;
  const OwnedMesh wall = sheet({-4, -4, -1.3}, {8, 0, 0}, {0, 8, 0});
  const auto drawn = [&](int size) {
    Stage stage;
    stage.width = stage.height = size;
    stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1.5);
    stage.instances = {painted(fineSphere(), {1, 1, 1}), painted(wall, {1, 1, 1})};
    for (Instance& instance : stage.instances)
      instance.style.cues = cues;
    return draw(stage);
  };
  const Picture small = drawn(80), large = drawn(320);
  double sum = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      double mean = 0;
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
          mean += at(large, 4 * x + i, 4 * y + j).g / 16.0;
      sum += std::fabs(mean - at(small, x, y).g);
    }
  EXPECT_LT(sum / 6400, 3);
}

/// Whether an instance is at a pixel or up to `reach` beside it.
bool isBeside(const Picture& picture, std::size_t index, int instance, int reach)
{
  const int x = static_cast<int>(index) % picture.width,
            y = static_cast<int>(index) / picture.width;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const int qx = x + dx, qy = y + dy;
      if (qx < 0 || qy < 0 || qx >= picture.width || qy >= picture.height) continue;
      if (picture.instance[static_cast<std::size_t>(qy * picture.width + qx)] ==
          static_cast<std::uint32_t>(instance))
        return true;
    }
  return false;
}

TEST_P(DepthCuesOn, NoPaleSeamRunsAlongTheNearersBorder)
{
  // Half of the pixel between both shows the wall, which is dark there.
  for (const Resolve resolve : {Resolve::kLinear, Resolve::kGamma22}) {
    const Steps steps(128, 100);
    Stage stage = flatStage(128, 4);
    stage.resolve = resolve;
    stage.instances = {painted(steps.back, {1, 1, 1}), painted(steps.front, {0, 0, 0})};
    stage.instances[1].modelToWorld.m[0][3] = 0.5;
    stage.instances[0].style.cues.eyeDome = {3, 0.01f};
    const Picture picture = draw(stage);
    const int dark = at(picture, 65, 64).g;
    EXPECT_LT(dark, 30);
    EXPECT_LE(at(picture, 64, 64).g, dark);
    EXPECT_EQ(at(picture, 63, 64).g, 0);
  }
}

TEST_P(DepthCuesOn, CuesKeepTheBackgroundAndActorsWithoutThem)
{
  // A tilted sheet that a smaller one passes through, both before nothing.
  const OwnedMesh tilted = sheet({8, 8, -30}, {48, 0, 60}, {0, 48, 0});
  const OwnedMesh small = sheet({20, 20, 4}, {24, 0, 0}, {0, 24, -3});
  for (const int samples : {1, 4})
    for (const int cued : {0, 1}) {
      Stage stage = flatStage(64, samples);
      stage.instances = {painted(tilted, {0.9f, 0.7f, 0.5f}, 1),
                         painted(small, {0.2f, 0.9f, 0.4f}, 2)};
      const Picture plain = drawOver(stage, GetParam());
      DepthCues& cues = stage.instances[static_cast<std::size_t>(cued)].style.cues;
      cues.eyeDome.strength = 3;
      cues.unsharp.strength = 1;
      cues.unsharp.lightens = true;
      const Picture picture = drawOver(stage, GetParam());
      int changed = 0;
      for (std::size_t i = 0; i < plain.color.size(); ++i) {
        // With several samples pixels at its border may be in part its own.
        const bool isOwn = isBeside(plain, i, cued + 1, samples == 1 ? 0 : 1);
        if (isOwn)
          changed += areEqual(picture.color[i], plain.color[i]) ? 0 : 1;
        else
          ASSERT_TRUE(areEqual(picture.color[i], plain.color[i])) << i << " of " << samples;
      }
      EXPECT_GT(changed, cued == 0 ? 300 : 20);
      EXPECT_EQ(picture.depth, plain.depth);
      EXPECT_EQ(picture.coverage, plain.coverage);
    }
}

TEST_P(DepthCuesOn, CuesAreTheSameInLayersAndInRadiance)
{
  const Steps steps(48, 10);
  for (const int samples : {1, 8}) {
    Stage stage = flatStage(48, samples);
    stage.instances = {painted(steps.back, {0.8f, 0.7f, 0.6f}),
                       painted(steps.front, {0.8f, 0.7f, 0.6f})};
    stage.instances[1].modelToWorld.m[0][3] = 0.4;
    for (Instance& instance : stage.instances) {
      instance.style.cues.eyeDome.strength = 1;
      instance.style.cues.unsharp.strength = 0.5f;
      instance.style.cues.unsharp.lightens = true;
      instance.style.cues.halo.width = 1.4f;
    }
    const Picture blended = draw(stage);
    Picture apart(48, 48), radiant(48, 48);
    stage.drawOver(apart, GetParam(), Background::kKeepApart);
    radiant.addRadiance();
    stage.drawOver(radiant, GetParam());
    for (std::size_t i = 0; i < blended.color.size(); ++i) {
      ASSERT_EQ(apart.color[i].g, blended.color[i].g) << i;
      ASSERT_NEAR(radiant.radiance[1][i] * 255, blended.color[i].g, 1.51) << i;
    }
  }
}

TEST_P(DepthCuesOn, LinesAreNotDarkened)
{
  const Steps steps(64, 10);
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(steps.back, {0, 0, 0}), painted(steps.front, {0, 0, 0})};
  const OwnedMesh square = sheet({40, 10, -20}, {20, 0, 0}, {0, 40, 0});
  const OwnedMesh deep = sheet({-9, -9, -40}, {90, 0, 0}, {0, 90, 0});
  stage.instances = {painted(deep, {1, 1, 1}), painted(square, {0, 0, 0}),
                     painted(steps.front, {0, 0, 0})};
  Style& style = stage.instances[1].style;
  style.imageOutline.detector = OutlineDetector::kPlane;
  style.outlineColor = {1, 1, 1};
  style.outlineWidth = 2;
  style.cues.eyeDome = {5, 0.02f};
  style.cues.unsharp.strength = 1;
  const Picture picture = draw(stage);
  for (const int x : {40, 41, 58, 59})
    EXPECT_EQ(at(picture, x, 30).g, 255) << x;
}

TEST_P(DepthCuesOn, UnsharpMasksFollowTheErrorFunctionBesideAStep)
{
  constexpr int kSide = 160;
  for (const double sigma : {4.0, 16.0})
    for (const double step : {0.5, 1.0}) {
      const Steps steps(kSide, step * sigma);
      Stage stage = flatStage(kSide, 1);
      stage.instances = {painted(steps.back, {1, 1, 1}), painted(steps.front, {0.5f, 0.5f, 0.5f})};
      for (Instance& instance : stage.instances) {
        instance.style.cues.unsharp = {0.8f, static_cast<float>(sigma / diagonal(stage)), true};
      }
      const Picture picture = draw(stage);
      for (int x = 40; x < 120; ++x) {
        const double t = (x + 0.5 - 80) / sigma;
        const double g = step * 0.5 * std::erfc(std::fabs(t) / std::sqrt(2.0));
        const double share = g / (1 + g);
        const double expected = t > 0 ? 255 * (1 - 0.8 * share) : 127.5 + 127.5 * 0.8 * share;
        // Blocks of two pixels, interpolated.
        EXPECT_NEAR(at(picture, x, 80).g, expected, 2.5) << x << ", sigma " << sigma;
      }
      EXPECT_LT(at(picture, 80, 80).g, 255 - 40 * step);
      for (Instance& instance : stage.instances)
        instance.style.cues.unsharp.lightens = false;
      EXPECT_EQ(at(draw(stage), 78, 80).g, 128) << "what is before stays";
    }
}

TEST_P(DepthCuesOn, UnsharpMasksDoNotSeeTheBackground)
{
  const OwnedMesh square = sheet({20, 12, 0}, {25, 0, 0}, {0, 33, 0});
  Stage stage = flatStage(64, 4);
  stage.instances = {painted(square, {0.7f, 0.7f, 0.7f})};
  const Picture plain = drawOver(stage, GetParam());
  stage.instances[0].style.cues.unsharp = {1, 0.05f, true};
  EXPECT_EQ(drawOver(stage, GetParam()).differingPixels(plain), 0u);
}

/// A white square about the middle, turned, before a black wall.
struct Haloed {
  OwnedMesh wall, square;
  Haloed(int side, double half, double degrees, double step)
      : wall(sheet({-9.0, -9.0, 0}, {side + 18.0, 0, 0}, {0, side + 18.0, 0})),
        square(turned(side, half, degrees, step))
  {
  }
  static OwnedMesh turned(int side, double half, double degrees, double step)
  {
    const double c = std::cos(degrees * kPi / 180) * half, s = std::sin(degrees * kPi / 180) * half;
    const Vec3d middle = {side / 2 + 0.3, side / 2 + 0.1, step}, u = {c, s, 0}, v = {-s, c, 0};
    return sheet(middle - u - v, u * 2.0, v * 2.0);
  }
  Stage stage(int side, int samples, float width) const
  {
    Stage stage = flatStage(side, samples);
    stage.instances = {painted(wall, {0, 0, 0}, 1), painted(square, {0, 0, 1}, 2)};
    stage.instances[1].style.cues.halo = {width, 4, {1, 0, 0}};
    return stage;
  }
};

TEST_P(DepthCuesOn, HalosCoverWidthTimesLength)
{
  constexpr int kSide = 96;
  for (const double degrees : {0.0, 11.0, 31.0})
    for (const float width : {1.0f, 2.5f, 5.0f}) {
      const Haloed scene(kSide, 20, degrees, 60);
      const Picture picture = draw(scene.stage(kSide, 8, width));
      double red = 0, blue = 0;
      for (const Rgba8 c : picture.color) {
        red += c.r / 255.0;
        blue += c.b / 255.0;
      }
      const double w = width;
      // By the shares of the pixels at the border, which do not say where in them it runs.
      EXPECT_NEAR(red / (4 * 40 * w + kPi * w * w), 1, w < 2 ? 0.07 : 0.02)
          << degrees << " degrees, width " << width;
      EXPECT_NEAR(blue, 1600, 5) << "the nearer keeps its own";
    }
}

TEST_P(DepthCuesOn, HalosGetNarrowWhereThereIsLittleDepth)
{
  constexpr int kSide = 96;
  for (const double share : {0.0, 0.25, 0.5, 1.0, 3.0}) {
    const float width = 6;
    const Haloed scene(kSide, 20, 0, share * 4 * width + (share == 0 ? -0.01 : 0));
    Stage stage = scene.stage(kSide, 1, width);
    stage.instances[1].modelToWorld.m[0][3] = -0.3;
    const Picture picture = draw(stage);
    double gap = 0;
    for (int x = 60; x < kSide; ++x)
      gap += at(picture, x, 48).r / 255.0;
    const double t = std::min(share, 1.0);
    EXPECT_NEAR(gap, t * t * (3 - 2 * t) * 6, 0.55) << share;
  }
}

TEST_P(DepthCuesOn, HalosLeaveBackgroundAndOneSurfaceAlone)
{
  // A sphere, a plane tilted by 85 degrees: steep, but nothing lies behind anything.
  const OwnedMesh steep = sheet({10, 30, 0}, {44, 0, 0}, {0, 4, -46});
  for (const int samples : {1, 4}) {
    Stage stage = flatStage(64, samples);
    stage.instances = {painted(steep, {0, 0, 1})};
    Stage round;
    round.width = round.height = 96;
    round.samples = samples;
    round.instances = {painted(fineSphere(), {0, 0, 1})};
    for (Stage* one : {&stage, &round}) {
      const Picture plain = drawOver(*one, GetParam());
      one->instances[0].style.cues.halo = {4, 4, {1, 0, 0}};
      EXPECT_EQ(drawOver(*one, GetParam()).differingPixels(plain), 0u) << samples;
    }
  }
}

TEST_P(DepthCuesOn, HalosCutPartsOfOneMeshAndLinesBehind)
{
  // One mesh of two squares, one before the other.
  const std::vector<Vec3d> points = {{4, 4, 0},    {60, 4, 0},   {60, 60, 0},  {4, 4, 0},
                                     {60, 60, 0},  {4, 60, 0},   {20, 20, 60}, {44, 20, 60},
                                     {44, 44, 60}, {20, 20, 60}, {44, 44, 60}, {20, 44, 60}};
  const OwnedMesh mesh = soup(points);
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(mesh, {0, 0, 1})};
  stage.instances[0].style.cues.halo = {3, 4, {1, 0, 0}};
  const Picture picture = draw(stage);
  for (const int x : {17, 18, 19, 44, 45, 46})
    EXPECT_EQ(at(picture, x, 32).r, 255) << x;
  for (const int x : {5, 16, 20, 32, 43, 47})
    EXPECT_EQ(at(picture, x, 32).r, 0) << x;

  const OwnedMesh beam = sheet({-9, 28, 20}, {90, 0, 0}, {0, 8, 0});
  const OwnedMesh post = sheet({28, -9, 60}, {8, 0, 0}, {0, 90, 0});
  stage.instances = {painted(beam, {0, 0, 1}), painted(post, {0, 0, 1})};
  stage.instances[0].style.imageOutline.detector = OutlineDetector::kPlane;
  stage.instances[0].style.outlineColor = {0, 1, 0};
  stage.instances[1].style.cues.halo = {3, 4, {1, 0, 0}};
  const Picture crossing = draw(stage);
  EXPECT_EQ(at(crossing, 23, 28).g, 255) << "the beam's line";
  for (const int x : {25, 26, 27, 36, 37, 38}) {
    EXPECT_EQ(at(crossing, x, 28).g, 0) << x;
    EXPECT_EQ(at(crossing, x, 28).r, 255) << x;
  }
}

/// One straight stroke, as an instance borrows it.
struct Stroke {
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> vertex = {0, 1}, first = {0, 2};
  std::vector<LineSet> sets;

  Stroke(Vec3d from, Vec3d to, float width) : points{vec3Cast<float>(from), vec3Cast<float>(to)}
  {
    LineStyle style;
    style.color = {1, 0, 0};
    style.width = width;
    sets.push_back({{points, {}, {}}, vertex, first, {}, {}, style});
  }
  Stroke(const Stroke&) = delete;
  Stroke& operator=(const Stroke&) = delete;
};

TEST_P(DepthCuesOn, HalosCutStrokesOfOtherInstancesBehind)
{
  const OwnedMesh beam = sheet({-9, 28, 20}, {90, 0, 0}, {0, 8, 0});
  const OwnedMesh post = sheet({28, -9, 60}, {8, 0, 0}, {0, 90, 0});
  // Along the lower side of the beam: half of it lies over the background.
  const Stroke far({-9, 28, 20}, {81, 28, 20}, 4), own({28, -9, 60}, {28, 81, 60}, 2);
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(beam, {0, 0, 1}), painted(post, {0, 0, 1})};
  stage.instances[0].lines = far.sets;
  stage.instances[1].lines = own.sets;
  stage.instances[1].style.cues.halo = {3, 4, {0, 1, 0}};
  const Picture picture = drawOver(stage, GetParam());
  for (const int y : {26, 27, 28, 29}) {
    for (const int x : {23, 24, 39, 40})
      EXPECT_EQ(at(picture, x, y).r, 255) << x << ", " << y;
    for (const int x : {25, 26, 36, 37, 38})
      EXPECT_LE(at(picture, x, y).r, kBackground.r) << x << ", " << y;
  }
  EXPECT_TRUE(areEqual(at(picture, 26, 27), kBackground)) << "halos colour no background";
  for (const int y : {10, 27, 31, 50})
    for (const int x : {27, 28})
      EXPECT_EQ(at(picture, x, y).r, 255) << "the post's own at " << x << ", " << y;
}

TEST_P(DepthCuesOn, HalosCutHiddenStrokesBehind)
{
  const OwnedMesh wall = sheet({-9, -9, 10}, {90, 0, 0}, {0, 90, 0});
  const OwnedMesh post = sheet({28, -9, 60}, {8, 0, 0}, {0, 90, 0});
  Stroke far({-9, 30, 5}, {81, 30, 5}, 4);
  far.sets[0].style.hidden = HiddenLines::kThin;
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(wall, {0, 0, 1}), painted(post, {0, 0, 1})};
  stage.instances[0].lines = far.sets;
  stage.instances[1].style.cues.halo = {3, 4, {0, 1, 0}};
  const Picture picture = drawOver(stage, GetParam());
  for (const int x : {23, 24, 30, 39})
    EXPECT_EQ(at(picture, x, 30).r, 255) << x;
  for (const int x : {25, 26, 27, 36, 37, 38})
    EXPECT_EQ(at(picture, x, 30).r, 0) << x;
}

TEST_P(DepthCuesOn, HalosCutStrokesOfTheirOwnInstanceFarBehind)
{
  const std::vector<Vec3d> points = {{4, 4, 0},    {60, 4, 0},   {60, 60, 0},  {4, 4, 0},
                                     {60, 60, 0},  {4, 60, 0},   {20, 20, 60}, {44, 20, 60},
                                     {44, 44, 60}, {20, 20, 60}, {44, 44, 60}, {20, 44, 60}};
  const OwnedMesh mesh = soup(points);
  const Stroke behind({4, 32, 0}, {60, 32, 0}, 2), border({20, 20, 60}, {20, 44, 60}, 2);
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(mesh, {0, 0, 1})};
  stage.instances[0].style.cues.halo = {3, 4, {0, 1, 0}};
  const std::vector<LineSet> sets = {behind.sets[0], border.sets[0]};
  stage.instances[0].lines = sets;
  const Picture picture = drawOver(stage, GetParam());
  for (const int x : {10, 16, 19, 20, 47, 50})
    EXPECT_EQ(at(picture, x, 31).r, 255) << x;
  for (const int x : {17, 44, 45, 46})
    EXPECT_EQ(at(picture, x, 31).r, 0) << x;

  const OwnedMesh square = sheet({20, 20, 60}, {24, 0, 0}, {0, 24, 0});
  stage.instances[0] = painted(square, {0, 0, 1});
  stage.instances[0].style.cues.halo = {3, 4, {0, 1, 0}};
  stage.instances[0].lines = behind.sets;
  EXPECT_TRUE(areEqual(at(drawOver(stage, GetParam()), 18, 31), kBackground)) << "on no surface";
}

/// What halos of a color make of a pane's half opacity over something.
int half(float own, int below)
{
  return static_cast<int>(std::nearbyint(127.5f * own + 0.5f * static_cast<float>(below)));
}

TEST_P(DepthCuesOn, HalosCutTranslucentSurfacesBehind)
{
  const OwnedMesh wall = sheet({-9, -9, 0}, {90, 0, 0}, {0, 90, 0});
  const OwnedMesh post = sheet({28, -9, 60}, {8, 0, 0}, {0, 90, 0});
  for (const int samples : {1, 4})
    for (const bool hasWall : {false, true})
      for (const double depth : {20.0, 90.0}) {
        const OwnedMesh pane = sheet({-9, 10, depth}, {90, 0, 0}, {0, 40, 0});
        Stage stage = flatStage(64, samples);
        stage.instances = {painted(pane, {0, 0, 1}), painted(post, {1, 0, 0})};
        stage.instances[0].material.opacity = 0.5f;
        if (hasWall) stage.instances.push_back(painted(wall, {0, 0, 0}));
        const Picture plain = drawOver(stage, GetParam());
        stage.instances[1].style.cues.halo = {3, 4, {0, 1, 0}};
        const Picture picture = drawOver(stage, GetParam());
        const int below = hasWall ? 255 : kBackground.g;
        const double width = depth < 60 ? 3 : 0;
        for (const int x : {23, 24, 25, 26, 27, 36, 37, 38, 39, 40}) {
          const double distance = x < 28 ? 28 - (x + 0.5) : x + 0.5 - 36;
          const auto share = static_cast<float>(std::clamp(width + 0.5 - distance, 0.0, 1.0));
          const bool isBelowCut = hasWall && distance < 3;
          EXPECT_NEAR(at(picture, x, 30).g,
                      half(share, isBelowCut ? below
                                  : hasWall  ? 0
                                             : below),
                      1)
              << x << ", depth " << depth << ", " << samples << " samples";
          EXPECT_NEAR(at(picture, x, 30).b, half(1 - share, hasWall ? 0 : kBackground.b), 1)
              << x << ", depth " << depth << ", " << samples << " samples";
        }
        EXPECT_TRUE(areEqual(at(picture, 32, 30), at(plain, 32, 30))) << "the post";
        EXPECT_TRUE(hasWall || areEqual(at(picture, 26, 5), kBackground)) << "no background";
      }
}

// As far as the nearest border has it, not that part of the surface which is nearest to the eye.
TEST_P(DepthCuesOn, HalosAreNarrowerOverTranslucentSurfacesLittleBehind)
{
  const OwnedMesh pane = sheet({-9, -9, 44}, {90, 0, 0}, {0, 90, 10});
  const OwnedMesh post = sheet({28, -9, 50}, {8, 0, 0}, {0, 90, 10});
  for (const int samples : {1, 4}) {
    Stage stage = flatStage(64, samples);
    stage.instances = {painted(pane, {0, 0, 1}), painted(post, {1, 0, 0})};
    stage.instances[0].material.opacity = 0.5f;
    stage.instances[1].style.cues.halo = {3, 4, {0, 1, 0}};
    const Picture picture = drawOver(stage, GetParam());
    // Half of four widths behind.
    for (const int x : {23, 24, 25, 26, 27, 36, 37, 38, 39, 40}) {
      const double distance = x < 28 ? 28 - (x + 0.5) : x + 0.5 - 36;
      const auto share = static_cast<float>(std::clamp(1.5 + 0.5 - distance, 0.0, 1.0));
      for (const int y : {20, 30, 40})
        EXPECT_NEAR(at(picture, x, y).b, half(1 - share, kBackground.b), 6)
            << x << ", " << y << ", " << samples << " samples";
    }
  }
}

// At the border of what has the halo, too, of which the pixels have parts.
TEST_P(DepthCuesOn, HalosOverTranslucentSurfacesCoverWidthTimesLength)
{
  constexpr int kSide = 96;
  for (const double degrees : {0.0, 11.0, 31.0})
    for (const float width : {1.0f, 2.5f, 5.0f}) {
      const Haloed scene(kSide, 20, degrees, 60);
      Stage stage = scene.stage(kSide, 8, width);
      stage.instances[0] = painted(scene.wall, {0, 1, 0}, 1);
      stage.instances[0].material.opacity = 0.5f;
      const Picture picture = draw(stage);
      double red = 0, green = 0;
      for (const Rgba8 c : picture.color) {
        red += c.r / 127.5;
        green += c.g / 127.5;
      }
      const double w = width, gap = 4 * 40 * w + kPi * w * w;
      EXPECT_NEAR(red / gap, 1, w < 2 ? 0.07 : 0.02) << degrees << " degrees, width " << width;
      EXPECT_NEAR(green, kSide * kSide - 1600 - red, 40) << degrees << " degrees, width " << width;
    }
}

TEST_P(DepthCuesOn, LinesBehindPanesBehindHalosAreSeenThroughTheirColours)
{
  const OwnedMesh pane = sheet({-9, -9, 40}, {90, 0, 0}, {0, 90, 0});
  const OwnedMesh bar = sheet({-9, 28, 20}, {90, 0, 0}, {0, 8, 0});
  const OwnedMesh post = sheet({28.0, -9, 60}, {8, 0, 0}, {0, 90, 0});
  const Stroke line({-9, 32, 20}, {81, 32, 20}, 6);
  Stage stage = flatStage(64, 1);
  stage.instances = {painted(bar, {0, 0, 0}), painted(pane, {0, 0, 1}), painted(post, {0, 0, 0})};
  stage.instances[0].lines = line.sets;
  stage.instances[1].material.opacity = 0.5f;
  stage.instances[2].style.cues.halo = {2.5f, 1, {0, 1, 0}};
  const Picture picture = drawOver(stage, GetParam());
  // Half of the pixel 25 has the gap; the pane is half blue, half green there, the line half gone.
  EXPECT_EQ(at(picture, 24, 31).r, 128);
  EXPECT_EQ(at(picture, 26, 31).r, 0);
  EXPECT_NEAR(at(picture, 25, 31).r, 64, 1);
  EXPECT_NEAR(at(picture, 25, 31).b, 64, 1);
  EXPECT_NEAR(at(picture, 25, 31).g, 64 + 32, 1);
}

// Its contour lies some ten pixels behind what the last pixels before it show, and, seen from near,
// some fifty.
TEST_P(DepthCuesOn, HalosLeaveTheContourOfASphere)
{
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> vertex, first = {0};
  for (std::uint32_t i = 0; i < 360; ++i) {
    const double angle = i * kPi / 180;
    points.push_back(vec3Cast<float>(Vec3d{std::cos(angle), std::sin(angle), 0}));
    vertex.push_back(i);
  }
  vertex.push_back(0);
  first.push_back(static_cast<std::uint32_t>(vertex.size()));
  LineStyle style;
  style.width = 3;
  const std::vector<LineSet> sets = {{{points, {}, {}}, vertex, first, {}, {}, style}};
  const OwnedMesh coarse = sphere(32, 64);
  for (const bool isNear : {false, true}) {
    Stage stage;
    stage.width = stage.height = 96;
    stage.view = isNear ? parallelView({1, 0, 8}, {1, 0, 0}, 0.1, {1, 20})
                        : parallelView({0, 0, 8}, {0, 0, 0}, 1.2, {1, 20});
    stage.instances = {painted(isNear ? coarse : fineSphere(), {0, 0, 1})};
    stage.instances[0].lines = sets;
    const Picture plain = drawOver(stage, GetParam());
    stage.instances[0].style.cues.halo = {4, 0.25f, {0, 1, 0}};
    EXPECT_EQ(drawOver(stage, GetParam()).differingPixels(plain), 0u) << isNear;
  }
}

TEST_P(DepthCuesOn, TranslucentInstancesHaveNone)
{
  const Steps steps(48, 10);
  Stage stage = flatStage(48, 4);
  stage.instances = {painted(steps.back, {1, 1, 1}), painted(steps.front, {1, 1, 1})};
  stage.instances[1].material.opacity = 0.5f;
  const Picture plain = draw(stage);
  stage.instances[1].style.cues.eyeDome.strength = 1;
  stage.instances[1].style.cues.unsharp.strength = 1;
  stage.instances[1].style.cues.halo.width = 3;
  EXPECT_EQ(draw(stage).differingPixels(plain), 0u);
}

TEST_P(DepthCuesOn, RefuseSenselessValues)
{
  const OwnedMesh square = sheet({4, 4, 0}, {20, 0, 0}, {0, 20, 0});
  Picture picture(48, 48);
  const auto errorOf = [&](const auto& change) {
    Stage stage = flatStage(48, 1);
    stage.instances = {painted(square, {1, 1, 1})};
    change(stage.instances[0].style.cues);
    return render(stage.scene(), picture.frame(Background::kBlend), {GetParam(), 1}).error;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(errorOf([](DepthCues&) {}), Error::kNone);
  for (const float bad : {-1.0f, kNan, kInfinite}) {
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.eyeDome.strength = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.eyeDome.radius = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.unsharp.strength = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.unsharp.radius = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.halo.width = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.halo.depth = bad; }), Error::kNotFinite);
    EXPECT_EQ(errorOf([&](DepthCues& c) { c.halo.color.y = bad; }), Error::kNotFinite);
  }
  EXPECT_EQ(errorOf([](DepthCues& c) { c.eyeDome.strength = 101; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.eyeDome.radius = 0.03f; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.eyeDome.radius = 0; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.unsharp.strength = 1.5f; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.unsharp.radius = 0.2f; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.halo.width = 65; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](DepthCues& c) { c.halo.depth = 0; }), Error::kNotFinite);
}

}  // namespace
}  // namespace limn::testing
