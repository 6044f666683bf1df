// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines from the finished picture: their place, their width, what they leave alone.
#include "Testing/Unit/OutlinedScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class ImageOutlines : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(ImageOutlines);

/// In pixels that are wholly black.
double darkness(const Picture& picture)
{
  double sum = 0;
  for (const Rgba8 color : picture.color)
    sum += darknessOf(color);
  return sum;
}

/// A quadrangle about the middle of a picture, turned.
OwnedMesh turnedSquare(double side, double half, double degrees, double z = 0)
{
  const double c = std::cos(degrees * kPi / 180) * half, s = std::sin(degrees * kPi / 180) * half;
  const Vec3d middle = {side / 2 + 0.3, side / 2 + 0.1, z}, u = {c, s, 0}, v = {-s, c, 0};
  return sheet(middle - u - v, u * 2.0, v * 2.0);
}

TEST_P(ImageOutlines, CoverWidthTimesLengthOfStraightBorders)
{
  constexpr int kSide = 100, kFrom = 20, kTo = 80;
  // The border is known to some hundredths of a pixel by 8 samples, in the mean of its length.
  constexpr double kSampling = 0.011;
  const bool isFast = GetParam() == Backend::kPipeline;
  const std::vector<double> angles =
      isFast ? std::vector<double>{0, 3, 11, 18, 27, 31, 38, 44} : std::vector<double>{11, 31};
  for (const int samples : {8, 16})
    for (const double degrees : angles)
      for (const double shift : {0.0, 0.3, 0.7})
        for (const float width : {0.7f, 1.0f, 2.0f, 3.5f}) {
          if (!isFast && shift != 0.3) continue;
          const OwnedMesh half = halfPlane(kSide, degrees, shift);
          Stage stage = flatStage(kSide, samples);
          stage.instances = {outlined(half, width)};
          const Picture picture = drawOverWhite(stage, GetParam());
          double sum = 0;
          for (int y = 0; y < kSide; ++y)
            for (int x = kFrom; x < kTo; ++x)
              sum += darknessOf(at(picture, x, y));
          const double length = (kTo - kFrom) / std::cos(degrees * kPi / 180);
          EXPECT_NEAR(sum / length, width, std::max(0.005 * width, kSampling))
              << degrees << " degrees, " << samples << " samples, shift " << shift;
        }
}

TEST_P(ImageOutlines, CoverWidthTimesLengthOfDiscs)
{
  constexpr int kSide = 100;
  for (const int samples : {8, 16})
    for (const double radius : {20.3, 40.7})
      for (const float width : {1.0f, 2.0f, 3.5f}) {
        const OwnedMesh round = disc({50.2, 49.6, 0}, radius);
        Stage stage = flatStage(kSide, samples);
        stage.instances = {outlined(round, width)};
        const double w = width;
        const double area = kPi * (radius * radius - (radius - w) * (radius - w));
        EXPECT_NEAR(darkness(drawOverWhite(stage, GetParam())) / area, 1, 0.005)
            << "radius " << radius << ", width " << width << ", " << samples << " samples";
      }
}

TEST_P(ImageOutlines, RunAroundASphereAndNowhereElse)
{
  // Depth falls off steeply towards a sphere's border, which is no step.
  for (const int samples : {1, 4, 8}) {
    Stage stage;
    stage.width = stage.height = 120;
    stage.resolve = Resolve::kLinear;
    stage.samples = samples;
    stage.view = perspectiveView({0, 0, 3}, {0, 0, 0}, 50);
    stage.instances = {outlined(fineSphere(), 2)};
    stage.instances[0].style.normals = NormalSource::kVertex;
    const double f = stage.height / 2.0 / std::tan(25 * kPi / 180);
    const double radius = f / std::sqrt(3.0 * 3.0 - 1);
    const double area = kPi * (radius * radius - (radius - 2) * (radius - 2));
    const Picture picture = drawOverWhite(stage, GetParam());
    // One sample tells no more than between which pixels the border lies.
    EXPECT_NEAR(darkness(picture) / area, 1, samples == 1 ? 0.05 : 0.01) << samples;
    for (int y = 0; y < stage.height; ++y)
      for (int x = 0; x < stage.width; ++x)
        if (std::hypot(x + 0.5 - 60, y + 0.5 - 60) < radius - 2 - 1) {
          ASSERT_EQ(at(picture, x, y).g, 255) << x << ", " << y << " of " << samples;
        }
  }
}

TEST_P(ImageOutlines, LieInsideOfTheNearerSurfaceAlone)
{
  // Two squares of different actors, one before the other; only what is nearer has lines there.
  constexpr int kSide = 96;
  const OwnedMesh back = turnedSquare(kSide, 32, 20, 0), front = turnedSquare(kSide, 16, 50, 0.25);
  Stage stage = flatStage(kSide, 4);
  stage.instances = {outlined(back, 3, 1), outlined(front, 3, 2)};
  Stage bare = stage;
  for (Instance& instance : bare.instances)
    instance.style.imageOutline = {};
  bare.instances[0].material.diffuseColor = {1, 0, 0};
  Stage onlyFront = bare;
  onlyFront.instances[1].style = stage.instances[1].style;
  const Picture plain = drawOverWhite(bare, GetParam());
  const Picture lined = drawOverWhite(onlyFront, GetParam());
  int changed = 0;
  for (std::size_t i = 0; i < plain.color.size(); ++i) {
    if (plain.instance[i] == 2) {
      changed += lined.color[i].g != plain.color[i].g;
      continue;
    }
    ASSERT_EQ(lined.color[i].r, plain.color[i].r) << "others' pixels stay";
    ASSERT_EQ(lined.color[i].g, plain.color[i].g);
  }
  EXPECT_NEAR(changed, 128 * 3, 100);
  // Where the front square lies inside of the back one there is one line, not two.
  const Picture both = drawOverWhite(stage, GetParam());
  const double areas = 64 * 64 - 58 * 58 + 32 * 32 - 26 * 26;
  EXPECT_NEAR(darkness(both) / areas, 1, 0.02);
}

TEST_P(ImageOutlines, DrawNoEdgesOnTiltedPlanes)
{
  for (const bool parallel : {false, true})
    for (const double degrees : {0.0, 60.0, 80.0, 85.0, 88.0})
      for (const int samples : {1, 4}) {
        const double s = std::sin(degrees * kPi / 180), c = std::cos(degrees * kPi / 180);
        const OwnedMesh plane = sheet(Vec3d{-4, -4 * c, -4 * s}, {8, 0, 0}, {0, 8 * c, 8 * s}, 8);
        Stage stage;
        stage.view.eye = {0, 0, 8};
        stage.view.parallel = parallel;
        stage.view.fovyDegrees = 30;
        stage.view.near = 1;
        stage.view.far = 20;
        stage.samples = samples;
        stage.instances = {outlined(plane, 1)};
        Stage bare = stage;
        bare.instances[0].style.imageOutline = {};
        const Picture lined = stage.draw(GetParam()), plain = bare.draw(GetParam());
        for (int y = 4; y < stage.height - 4; ++y)
          for (int x = 4; x < stage.width - 4; ++x) {
            bool isInner = true;
            for (int dy = -4; dy <= 4; ++dy)
              for (int dx = -4; dx <= 4; ++dx)
                isInner = isInner && covered(plain, x + dx, y + dy);
            if (isInner) {
              ASSERT_EQ(at(lined, x, y).g, at(plain, x, y).g)
                  << x << ", " << y << " at " << degrees << " degrees, parallel " << parallel;
            }
          }
      }
}

// Normals of a plane's pixels are the same but for rounding, in each triangle and from one to the
// next.
TEST_P(ImageOutlines, FindNoCreaseInAPlaneByAnyAngle)
{
  for (const double degrees : {10.0, 33.0, 50.0})
    for (const NormalSource source : {NormalSource::kTriangle, NormalSource::kVertex}) {
      const double s = std::sin(degrees * kPi / 180), c = std::cos(degrees * kPi / 180);
      OwnedMesh plane = sheet(Vec3d{-40, -40 * c, -40 * s}, {80, 0, 0}, {0, 80 * c, 80 * s}, 60);
      const Vec3d normal = {0, -s, c};
      plane.vertexNormals.assign(plane.positions.size(), vec3Cast<float>(normal));
      Stage stage;
      stage.view = perspectiveView({1, 2, 8}, {0.3, 0.2, 0}, 30);
      stage.view.far = 200;
      stage.instances = {outlined(plane, 2)};
      stage.instances[0].style.normals = source;
      stage.instances[0].style.imageOutline.creaseDegrees = 0;
      EXPECT_EQ(darkness(drawOverWhite(stage, GetParam())), 0) << degrees;
    }
}

TEST_P(ImageOutlines, DrawSobelsFalseEdgesOnTiltedPlanes)
{
  const double s = std::sin(85 * kPi / 180), c = std::cos(85 * kPi / 180);
  const OwnedMesh plane = sheet(Vec3d{-4, -4 * c, -4 * s}, {8, 0, 0}, {0, 8 * c, 8 * s});
  Stage stage;
  stage.view = parallelView({0, 0, 8}, {0, 0, 0}, 0.4, {1, 20});
  stage.instances = {outlined(plane, 1)};
  stage.instances[0].style.imageOutline.detector = OutlineDetector::kLaplacian;
  EXPECT_EQ(at(stage.draw(GetParam()), 48, 48).g, 255) << "the slope has no slope";
  stage.instances[0].style.imageOutline.detector = OutlineDetector::kSobel;
  EXPECT_EQ(at(stage.draw(GetParam()), 48, 48).g, 0) << "the fault that plane prediction mends";
}

TEST_P(ImageOutlines, FindStepsInsideOfAnInstanceByEveryDetector)
{
  // One mesh: a square behind, and another 20 pixels before it, within it.
  constexpr int kSide = 64;
  const std::vector<Vec3d> points = {{4, 4, 0},    {60, 4, 0},   {60, 60, 0},  {4, 4, 0},
                                     {60, 60, 0},  {4, 60, 0},   {20, 20, 20}, {44, 20, 20},
                                     {44, 44, 20}, {20, 20, 20}, {44, 44, 20}, {20, 44, 20}};
  const OwnedMesh mesh = soup(points);
  Stage stage = flatStage(kSide, 1);
  stage.view.eye.z = stage.view.near = 30;
  stage.view.near = 1;
  stage.view.far = 50;
  for (const OutlineDetector detector :
       {OutlineDetector::kPlane, OutlineDetector::kSobel, OutlineDetector::kLaplacian}) {
    stage.instances = {outlined(mesh, 2)};
    stage.instances[0].style.imageOutline.detector = detector;
    const Picture picture = drawOverWhite(stage, GetParam());
    for (const int x : {20, 21, 42, 43, 4, 5, 58, 59})
      EXPECT_EQ(at(picture, x, 32).g, 0) << x << " by " << static_cast<int>(detector);
    for (const int x : {19, 18, 22, 32, 41, 44, 45, 6, 57})
      EXPECT_EQ(at(picture, x, 32).g, 255) << x << " by " << static_cast<int>(detector);
  }
}

TEST_P(ImageOutlines, PutCreasesInTheMiddle)
{
  // Two sides of a roof whose ridge runs at some angle.
  constexpr int kSide = 64;
  for (const double degrees : {0.0, 17.0, 45.0}) {
    const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
    const Vec3d middle = {32.37, 31.81, 10}, along = {80 * c, 80 * s, 0},
                aside = {-60 * s, 60 * c, 0}, down = {0, 0, -40};
    const Vec3d a = middle - along, b = middle + along;
    const OwnedMesh roof = soup({a, b, b + aside + down, a, b + aside + down, a + aside + down, b,
                                 a, a - aside + down, b, a - aside + down, b - aside + down});
    Stage stage = flatStage(kSide, 1);
    stage.view.eye.z = 40;
    stage.view.near = 1;
    stage.view.far = 200;
    stage.instances = {outlined(roof, 3)};
    const Picture picture = drawOverWhite(stage, GetParam());
    for (int y = 12; y < 52; ++y)
      for (int x = 12; x < 52; ++x) {
        const double off = std::fabs((x + 0.5 - middle.x) * -s + (y + 0.5 - middle.y) * c);
        if (off < 1.5 - 0.75) {
          EXPECT_EQ(at(picture, x, y).g, 0) << x << ", " << y;
        } else if (off > 1.5 + 0.75) {
          EXPECT_EQ(at(picture, x, y).g, 255) << x << ", " << y;
        }
      }
    double sum = 0;
    for (int x = 12; x < 52; ++x)
      for (int y = 4; y < 60; ++y)
        sum += darknessOf(at(picture, x, y));
    EXPECT_NEAR(sum, 3 * 40 / c, 3 * 40 / c * 0.005) << degrees;
    stage.instances[0].style.imageOutline.creaseDegrees = 100;
    EXPECT_EQ(darkness(drawOverWhite(stage, GetParam())), 0);
  }
}

TEST_P(ImageOutlines, RunCreasesUpToWhatHidesThem)
{
  // A sheet without lines before a half of the roof, at several angles to its ridge: all that it
  // does not touch is as without it.
  constexpr int kSide = 64;
  for (const auto& [samples, width] : {std::pair{1, 1.5f}, {1, 6.0f}, {4, 1.5f}, {4, 3.0f}})
    for (const double degrees : {4.0, 45.0})
      for (const double turn : {40.0, 90.0, 115.0, 140.0}) {
        const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
        const Vec3d middle = {32.37, 31.81, 10}, along = {80 * c, 80 * s, 0},
                    aside = {-60 * s, 60 * c, 0}, down = {0, 0, -40};
        const Vec3d a = middle - along, b = middle + along;
        const OwnedMesh roof =
            soup({a, b, b + aside + down, a, b + aside + down, a + aside + down, b, a,
                  a - aside + down, b, a - aside + down, b - aside + down});
        const OwnedMesh front = halfPlane(kSide, degrees + turn, 0.3, 20);
        Stage stage = flatStage(kSide, samples);
        stage.view.eye.z = 40;
        stage.view.near = 1;
        stage.view.far = 200;
        stage.instances = {outlined(roof, width, 1)};
        const Picture whole = drawOverWhite(stage, GetParam());
        stage.instances.push_back(painted(front, {1, 1, 1}, 2));
        const Picture picture = drawOverWhite(stage, GetParam());
        const double cosine = std::cos((degrees + turn) * kPi / 180),
                     sine = std::sin((degrees + turn) * kPi / 180);
        for (int y = 0; y < kSide; ++y)
          for (int x = 0; x < kSide; ++x) {
            const double above = (y + 0.5 - 32.3) * cosine - (x + 0.5 - 32) * sine;
            if (above < 0.75) continue;
            EXPECT_NEAR(at(picture, x, y).g, at(whole, x, y).g, 2)
                << x << ", " << y << " at " << degrees << " and " << turn << ", " << samples
                << " samples, width " << width;
          }
      }
}

/// Flat strips across the picture, `width` wide, with normals at `degrees` to the right of the eye,
/// from left to right; the first and the last reach over its borders.
OwnedMesh strips(const std::vector<double>& degrees, double width)
{
  OwnedMesh mesh;
  const double first = 32 - 0.5 * width * static_cast<double>(degrees.size() - 2);
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double left = i == 0 ? -40 : first + width * static_cast<double>(i - 1);
    const double right = i + 1 == degrees.size() ? 104 : first + width * static_cast<double>(i);
    const double angle = degrees[i] * kPi / 180;
    const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [x, y] :
         {std::pair{left, -40.0}, {right, -40.0}, {right, 104.0}, {left, 104.0}}) {
      mesh.positions.push_back(vec3Cast<float>(Vec3d{x, y, 0}));
      mesh.vertexNormals.push_back(vec3Cast<float>(Vec3d{std::sin(angle), 0, std::cos(angle)}));
    }
    mesh.triangles.push_back({{vertex, vertex + 1, vertex + 2}});
    mesh.triangles.push_back({{vertex, vertex + 2, vertex + 3}});
  }
  finish(mesh);
  return mesh;
}

TEST_P(ImageOutlines, FindSharpCreasesByEveryDetector)
{
  for (const CreaseDetector detector :
       {CreaseDetector::kAngle, CreaseDetector::kSobel, CreaseDetector::kLaplacian})
    for (const double turn : {39.0, 41.0}) {
      const OwnedMesh mesh = strips({-turn / 2, turn / 2}, 1);
      Stage stage = flatStage(64, 1);
      stage.instances = {outlined(mesh, 2)};
      stage.instances[0].style.normals = NormalSource::kVertex;
      stage.instances[0].style.imageOutline.creases = detector;
      const Picture picture = drawOverWhite(stage, GetParam());
      for (const int x : {30, 31, 32, 33}) {
        const bool isLine = turn > 40 && (x == 31 || x == 32);
        EXPECT_EQ(at(picture, x, 32).g, isLine ? 0 : 255)
            << x << " by " << static_cast<int>(detector) << " of " << turn;
      }
      stage.instances[0].style.imageOutline.creaseDegrees = 180;
      EXPECT_EQ(at(drawOverWhite(stage, GetParam()), 31, 32).g, 255);
    }
}

// Each of its pixels turns by 25 degrees from the one before.
TEST_P(ImageOutlines, FindBevelsOfTwoPixelsBySobelsOperator)
{
  const OwnedMesh mesh = strips({-25, 0, 25}, 1);
  Stage stage = flatStage(64, 1);
  stage.instances = {outlined(mesh, 2)};
  stage.instances[0].style.normals = NormalSource::kVertex;
  EXPECT_EQ(at(drawOverWhite(stage, GetParam()), 32, 32).g, 255) << "25 degrees are no crease";
  stage.instances[0].style.imageOutline.creases = CreaseDetector::kSobel;
  EXPECT_EQ(at(drawOverWhite(stage, GetParam()), 32, 32).g, 0) << "50 within two pixels are";
}

// A wall that rises by ten pixels within each pixel of the picture leaves the floor's plane by more
// than a step does.
TEST_P(ImageOutlines, DrawALineWhereASteepWallStandsOnAFloor)
{
  for (const int samples : {1, 8})
    for (const double degrees : {0.0, 9.0, 40.0}) {
      const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
      const Vec3d middle = {32.37, 31.81, 10}, along = {80 * c, 80 * s, 0};
      const Vec3d aside = {60 * s, -60 * c, 0}, up = {-8 * s, 8 * c, 80};
      const Vec3d a = middle - along, b = middle + along;
      const OwnedMesh corner =
          soup({a, b, b + up, a, b + up, a + up, b, a, a + aside, b, a + aside, b + aside});
      Stage stage = flatStage(64, samples);
      stage.view.eye.z = 120;
      stage.view.near = 1;
      stage.view.far = 200;
      stage.instances = {outlined(corner, 3)};
      const Picture picture = drawOverWhite(stage, GetParam());
      SCOPED_TRACE(::testing::Message() << samples << " samples");
      expectEvenLine(picture, middle, degrees);
    }
}

TEST_P(ImageOutlines, AskNothingOfPixelsThatAreNotDrawn)
{
  // What the picture before left there names an instance that this one has not: to look it up
  // changes nothing, but only sanitizers can tell.
  constexpr int kSide = 128;
  const OwnedMesh full = turnedSquare(kSide, 60, 0);
  const OwnedMesh small = sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const double width : {53.4, 54.4, 55.4, 56.4, 57.4, 58.4, 59.4}) {
    const OwnedMesh left = sheet({4, 4, 0}, {width, 0, 0}, {0, 110, 0});
    Stage many = flatStage(kSide, 1), one = flatStage(kSide, 1);
    one.instances = {outlined(left, 3)};
    many.instances = {outlined(small, 3), outlined(full, 3)};
    const Picture fresh = drawOverWhite(one, GetParam());
    drawOverWhite(many, GetParam());
    EXPECT_EQ(drawOverWhite(one, GetParam()).differingPixels(fresh), 0u) << width;
  }
}

TEST_P(ImageOutlines, MixByOpacityAndByTheResolve)
{
  const OwnedMesh square = sheet({4, 4, 0}, {24, 0, 0}, {0, 24, 0});
  Stage stage = pixelStage(32, 4);
  stage.instances = {outlined(square, 3)};
  stage.instances[0].style.outlineColor = {1, 0, 0.5f};
  stage.instances[0].style.outlineOpacity = 0.25f;
  const Picture picture = stage.draw(GetParam());
  EXPECT_EQ(at(picture, 5, 16).r, 255);
  EXPECT_EQ(at(picture, 5, 16).g, 191);
  EXPECT_EQ(at(picture, 5, 16).b, 223);
  // Half a pixel of line, at gamma 2.2.
  stage.instances[0].style.outlineWidth = 2.5f;
  stage.instances[0].style.outlineOpacity = 1;
  stage.instances[0].style.outlineColor = {0, 0, 0};
  EXPECT_EQ(at(stage.draw(GetParam()), 6, 16).g, 186);
  stage.resolve = Resolve::kLinear;
  EXPECT_NEAR(at(stage.draw(GetParam()), 6, 16).g, 127.5, 0.5);
}

TEST_P(ImageOutlines, AreTheSameInLayersAndInRadiance)
{
  const OwnedMesh square = turnedSquare(48, 15, 20);
  Stage stage = flatStage(48, 8);
  stage.instances = {outlined(square, 2)};
  const Picture blended = stage.draw(GetParam());
  Picture apart(48, 48), radiant(48, 48);
  stage.drawOver(apart, GetParam(), Background::kKeepApart);
  radiant.addRadiance();
  stage.drawOver(radiant, GetParam());
  for (std::size_t i = 0; i < blended.color.size(); ++i) {
    const double share = bitCount(apart.coverage[i]) / 8.0;
    ASSERT_NEAR(apart.color[i].g * share, blended.color[i].g, 1.01) << i;
    ASSERT_NEAR(radiant.radiance[1][i] * 255, blended.color[i].g, 1.01) << i;
  }
}

TEST_P(ImageOutlines, LeaveTranslucentInstancesAlone)
{
  const OwnedMesh square = turnedSquare(48, 15, 20);
  Stage stage = flatStage(48, 4);
  stage.instances = {outlined(square, 2)};
  stage.instances[0].material.opacity = 0.5f;
  const Picture lined = stage.draw(GetParam());
  stage.instances[0].style.imageOutline = {};
  EXPECT_EQ(lined.differingPixels(stage.draw(GetParam())), 0u);
}

TEST_P(ImageOutlines, RefuseSenselessValues)
{
  const OwnedMesh square = turnedSquare(48, 15, 20);
  Picture picture(48, 48);
  const auto errorOf = [&](const auto& change) {
    Stage stage = flatStage(48, 1);
    stage.instances = {outlined(square, 2)};
    change(stage.instances[0].style);
    return render(stage.scene(), picture.frame(Background::kBlend), {GetParam(), 1}).error;
  };
  EXPECT_EQ(errorOf([](Style&) {}), Error::kNone);
  EXPECT_EQ(errorOf([](Style& s) { s.imageOutline.depthTolerance = -1; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](Style& s) { s.imageOutline.creaseDegrees = 181; }), Error::kNotFinite);
  EXPECT_EQ(errorOf([](Style& s) { s.imageOutline.creaseDegrees = std::nanf(""); }),
            Error::kNotFinite);
  EXPECT_EQ(errorOf([](Style& s) { s.outlineWidth = 65; }), Error::kNotFinite);
}

}  // namespace
}  // namespace limn::testing
