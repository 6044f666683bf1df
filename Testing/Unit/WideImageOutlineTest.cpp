// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines from the finished picture that are wider than what they have room in, or than a step is
// high.
#include "Testing/Unit/OutlinedScene.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace limn::testing {
namespace {

class WideImageOutlines : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(WideImageOutlines);

/// Sees what lies between z = 0 and 29.
Stage deepStage(int side, int samples)
{
  Stage stage = flatStage(side, samples);
  stage.view.eye.z = 30;
  stage.view.near = 1;
  stage.view.far = 50;
  return stage;
}

/// One mesh of several.
OwnedMesh together(const std::vector<OwnedMesh>& meshes)
{
  std::vector<Vec3d> points;
  for (const OwnedMesh& mesh : meshes)
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle.vertex)
        points.push_back(vec3Cast<double>(mesh.positions[vertex]));
  return soup(points);
}

/// How far a pixel's centre is above a line through the middle of a picture.
double above(int side, double degrees, int x, int y)
{
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  return (x + 0.5 - side / 2.0) * -s + (y + 0.5 - side / 2.0) * c;
}

TEST_P(WideImageOutlines, FillGroovesThatAreNarrowerThanThey)
{
  // From below upwards a surface, `groove` pixels of another one behind that, and a third: the
  // first one's line and the second's lie side by side, with nothing between them.
  constexpr int kSide = 64, kFrom = 14, kTo = 50;
  const bool isFast = GetParam() == Backend::kPipeline;
  for (const bool isOneMesh : {true, false})
    for (const int samples : isFast ? std::vector<int>{4, 16} : std::vector<int>{4})
      for (const double degrees : {0.0, 13.0, 38.0})
        for (const double groove : {2.6, 5.0, 7.3})
          for (const float width : {4.0f, 6.0f, 8.0f}) {
            const double height = groove / std::cos(degrees * kPi / 180);
            const OwnedMesh front = halfPlane(kSide, degrees, 0, 20),
                            middle = halfPlane(kSide, degrees, height, 10),
                            back = halfPlane(kSide, degrees, 60, 0),
                            all = together({back, middle, front});
            Stage stage = deepStage(kSide, samples);
            if (isOneMesh)
              stage.instances = {outlined(all, width)};
            else
              stage.instances = {outlined(back, width, 1), outlined(middle, width, 2),
                                 outlined(front, width, 3)};
            const Picture picture = drawOverWhite(stage, GetParam());
            const double end = std::min<double>(groove, width);
            double sum = 0;
            for (int y = 0; y < kSide; ++y)
              for (int x = kFrom; x < kTo; ++x) {
                const double off = above(kSide, degrees, x, y);
                sum += darknessOf(at(picture, x, y));
                const bool isInLine = off > 0.75 - width && off < end - 0.75;
                if (isInLine && width >= groove) {
                  ASSERT_LE(at(picture, x, y).g, 16) << x << ", " << y << ": groove " << groove
                                                     << ", width " << width << " at " << degrees;
                }
              }
            const double length = (kTo - kFrom) / std::cos(degrees * kPi / 180);
            EXPECT_NEAR(sum / length, width + end, 0.03 + 0.4 / samples)
                << "groove " << groove << ", width " << width << " at " << degrees << ", "
                << samples << " samples, one mesh: " << isOneMesh;
          }
}

TEST_P(WideImageOutlines, LeaveTheFarSideOfLowStepsAlone)
{
  // Steps of a little more than the tolerance of 3 pixels.
  constexpr int kSide = 64, kFrom = 20, kTo = 44;
  const bool isFast = GetParam() == Backend::kPipeline;
  for (const int samples : isFast ? std::vector<int>{1, 4, 8} : std::vector<int>{1})
    for (const double degrees : {0.0, 17.0, 29.0, 44.0})
      for (const double step : {3.5, 5.0, 8.0})
        for (const float width : {6.0f, 12.0f}) {
          const OwnedMesh both = together(
              {halfPlane(kSide, degrees, 90, 10), halfPlane(kSide, degrees, 0, 10 + step)});
          Stage stage = deepStage(kSide, samples);
          stage.instances = {outlined(both, width)};
          const Picture picture = drawOverWhite(stage, GetParam());
          double sum = 0;
          for (int y = 0; y < kSide; ++y)
            for (int x = kFrom; x < kTo; ++x) {
              sum += darknessOf(at(picture, x, y));
              if (above(kSide, degrees, x, y) > 0.75) {
                ASSERT_EQ(at(picture, x, y).g, 255)
                    << x << ", " << y << " behind a step of " << step << " at " << degrees << ", "
                    << samples << " samples";
              }
            }
          const double length = (kTo - kFrom) / std::cos(degrees * kPi / 180);
          EXPECT_NEAR(sum / length, width, samples == 1 ? 0.3 : 0.08)
              << "step " << step << " at " << degrees << ", " << samples << " samples";
        }
}

TEST_P(WideImageOutlines, AreEvenlyWideAroundALowDisc)
{
  constexpr int kSide = 80, kSectors = 24;
  const Vec3d middle = {40.2, 39.6, 14};
  constexpr double kRadius = 30.4;
  const OwnedMesh both = together({halfPlane(kSide, 0, 60, 10), disc(middle, kRadius)});
  for (const float width : {4.0f, 6.0f, 8.0f}) {
    Stage stage = deepStage(kSide, 8);
    stage.instances = {outlined(both, width)};
    const Picture picture = drawOverWhite(stage, GetParam());
    std::vector<double> ink(kSectors, 0.0);
    constexpr int kFine = 8;  // of pixels that lie in two sectors
    for (int y = 0; y < kSide * kFine; ++y)
      for (int x = 0; x < kSide * kFine; ++x) {
        const double angle = std::atan2((y + 0.5) / kFine - middle.y, (x + 0.5) / kFine - middle.x);
        const int sector = static_cast<int>((angle + kPi) / (2 * kPi) * kSectors) % kSectors;
        ink[static_cast<std::size_t>(sector)] +=
            darknessOf(at(picture, x / kFine, y / kFine)) / (kFine * kFine);
      }
    const double inner = kRadius - width;
    const double area = kPi * (kRadius * kRadius - inner * inner) / kSectors;
    for (int i = 0; i < kSectors; ++i)
      EXPECT_NEAR(ink[static_cast<std::size_t>(i)] / area, 1, 0.03)
          << "sector " << i << ", width " << width;
  }
}

TEST_P(WideImageOutlines, RunUpToTheBorderOfWhatLiesBeforeThem)
{
  // A red sheet without lines ends in the middle of pixels; the line of a square behind it goes on
  // to its border.
  constexpr int kSide = 40;
  const OwnedMesh back = sheet({2, 6, 0}, {34, 0, 0}, {0, 24, 0}),
                  front = sheet({-5, -5, 20}, {25.5, 0, 0}, {0, 50, 0});
  for (const int samples : {4, 8, 16}) {
    Stage stage = deepStage(kSide, samples);
    stage.instances = {outlined(back, 4, 1), painted(front, {1, 0, 0}, 2)};
    const Picture picture = drawOverWhite(stage, GetParam());
    for (const int y : {7, 8, 27, 28}) {
      EXPECT_EQ(at(picture, 19, y).r, 255) << y;
      EXPECT_NEAR(at(picture, 20, y).r, 127.5, 1) << y;
      EXPECT_EQ(at(picture, 20, y).g, 0) << y;
      EXPECT_EQ(at(picture, 21, y).r, 0) << y;
    }
    for (const int y : {12, 18, 23}) {
      EXPECT_EQ(at(picture, 20, y).r, 255) << "no line " << y;
      EXPECT_NEAR(at(picture, 20, y).g, 127.5, 1) << "no line " << y;
    }
  }
}

TEST_P(WideImageOutlines, GoOnBehindWhatHidesThemAndOutOfTheFrame)
{
  // A sheet without lines hides a half of the picture, at all angles to the border of another.
  constexpr int kSide = 64;
  for (const auto& [samples, width] : {std::pair{1, 6.0f}, {4, 6.0f}, {4, 4.0f}})
    for (const double degrees : {0.0, 13.0, 38.0})
      for (const double turn : {0.0, 40.0, 50.0, 90.0, 130.0, 140.0, 144.0}) {
        const OwnedMesh back = halfPlane(kSide, degrees, 0.3),
                        front = halfPlane(kSide, degrees + turn, 0.3, 20);
        Stage stage = deepStage(kSide, samples);
        stage.view.eye.z = 80;
        stage.view.far = 120;
        stage.instances = {outlined(back, width, 1)};
        if (turn > 0) stage.instances.push_back(painted(front, {1, 1, 1}, 2));
        const double error = samples == 1 ? 1.9 : 1.4;
        const Picture picture = drawOverWhite(stage, GetParam());
        const auto above = [&](double x, double y, double angle) {
          const double c = std::cos(angle * kPi / 180), s = std::sin(angle * kPi / 180);
          return (y - kSide / 2.0 - 0.3) * c - (x - kSide / 2.0) * s;
        };
        for (int y = 0; y < kSide; ++y)
          for (int x = 0; x < kSide; ++x) {
            const double inside = -above(x + 0.5, y + 0.5, degrees);
            if (turn > 0 && above(x + 0.5, y + 0.5, degrees + turn) < 1) continue;
            if (inside > error && inside < width - error) {
              EXPECT_LE(at(picture, x, y).g, 20)
                  << x << ", " << y << " at " << degrees << " and " << turn << " of " << samples;
            } else if (inside < -error || inside > width + error) {
              EXPECT_EQ(at(picture, x, y).g, 255)
                  << x << ", " << y << " at " << degrees << " and " << turn << " of " << samples;
            }
          }
      }
}

TEST_P(WideImageOutlines, BeginAtTheFramesBorder)
{
  // A sheet that ends there stands before another one, which has no line and goes on.
  constexpr int kSide = 64;
  const OwnedMesh back = sheet({-200, -200, -20}, {500, 0, 0}, {0, 500, 0}),
                  front = halfPlane(kSide, 180, -kSide / 2);
  for (const int samples : {1, 4})
    for (const int width : {8, 10, 20, 26}) {  // with aprons of whole bands of rows, and without
      Stage stage = deepStage(kSide, samples);
      stage.view.eye.z = 80;
      stage.view.far = 120;
      stage.instances = {painted(back, {1, 1, 1}, 1),
                         outlined(front, static_cast<float>(width), 2)};
      const Picture picture = drawOverWhite(stage, GetParam());
      for (int y = 0; y < width - 1; ++y)
        EXPECT_LE(at(picture, 20, y).g, 20) << y << " of " << width << ", samples: " << samples;
      EXPECT_EQ(at(picture, 20, width + 1).g, 255) << width << ", samples: " << samples;
    }
}

TEST_P(WideImageOutlines, LeaveTheFrameAsTheyDoInALargerPicture)
{
  // Balls whose borders leave the frame at all angles, come back, or stay outside, so that nothing
  // but their lines reaches into it.
  constexpr int kSide = 64, kMore = 32;
  const OwnedMesh unit = sphere(64, 128);
  const bool isFast = GetParam() == Backend::kPipeline;
  for (const Vec3d ball :
       {Vec3d{60.2, 20.1, 30.4}, Vec3d{32.3, 31.8, 33.5}, Vec3d{-9.2, 40.1, 45.7},
        Vec3d{70.3, 71.1, 24.2}, Vec3d{33.1, -150.4, 216.3}})
    for (const int samples : {1, 4})
      for (const float width : isFast ? std::vector<float>{2, 5, 8, 12} : std::vector<float>{8}) {
        const double radius = ball.z;
        Stage stage = deepStage(kSide, samples);
        stage.view.far = 300;
        stage.instances = {outlined(unit, width)};
        for (int i = 0; i < 3; ++i)
          stage.instances[0].modelToWorld.m[i][i] = radius;
        stage.instances[0].modelToWorld.m[0][3] = ball.x;
        stage.instances[0].modelToWorld.m[1][3] = ball.y;
        stage.instances[0].modelToWorld.m[2][3] = 20 - radius;
        Stage larger = stage;
        larger.width = larger.height = kSide + 2 * kMore;
        larger.view.halfHeight = kSide / 2 + kMore;
        const Picture picture = drawOverWhite(stage, GetParam());
        const Picture whole = drawOverWhite(larger, GetParam());
        for (int y = 0; y < kSide; ++y)
          for (int x = 0; x < kSide; ++x) {
            ASSERT_NEAR(at(picture, x, y).g, at(whole, x + kMore, y + kMore).g, 1)
                << x << ", " << y << ": radius " << radius << ", width " << width << ", " << samples
                << " samples";
            if (std::hypot(x + 0.5 - ball.x, y + 0.5 - ball.y) > radius - 1) continue;
            int inside = 0;
            constexpr int kFine = 8;
            for (int i = 0; i < kFine * kFine; ++i)
              inside += std::hypot(x + (i % kFine + 0.5) / kFine - ball.x,
                                   y + (i / kFine + 0.5) / kFine - ball.y) > radius - width;
            const double share = inside / double{kFine * kFine};
            EXPECT_NEAR(darknessOf(at(picture, x, y)), share, samples == 1 ? 0.65 : 0.3)
                << x << ", " << y << ": radius " << radius << ", width " << width << ", " << samples
                << " samples";
          }
      }
}

TEST_P(WideImageOutlines, EndRoundlyWhereAStepFadesOut)
{
  // A sheet with a tear, from which on the lower part rises: by more than the tolerance of 3 pixels
  // from x = 23 on.
  constexpr double kRise = 50;
  const OwnedMesh all = together({sheet({-25, 32, 0}, {95, 0, 0}, {0, 70, 0}),
                                  sheet({-25, -25, 0}, {45, 0, 0}, {0, 57, 0}),
                                  sheet({20, -25, 0}, {kRise, 0, kRise}, {0, 57, 0})});
  for (const int samples : {1, 4})
    for (const float width : {4.0f, 8.0f}) {
      Stage stage = deepStage(64, samples);
      stage.view.eye.z = 80;
      stage.view.far = 120;
      stage.instances = {outlined(all, width)};
      stage.instances[0].style.imageOutline.creaseDegrees = 180;
      const Picture picture = drawOverWhite(stage, GetParam());
      const double radius = width / 2;
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 60; ++x) {
          const double px = x + 0.5, py = y + 0.5;
          const bool isBeyond = py > 32.5 || py < 32 - width - 1 ||
                                std::hypot(std::min(px - 23, 0.0), py - (32 - radius)) > radius + 2;
          if (isBeyond) {
            ASSERT_EQ(at(picture, x, y).g, 255) << x << ", " << y << " of " << samples;
          }
          if (px > 25 && py < 31.5 && py > 32 - width + 0.5) {
            ASSERT_EQ(at(picture, x, y).g, 0) << x << ", " << y << " of " << samples;
          }
        }
    }
}

TEST_P(WideImageOutlines, StayInTheMiddleOfCreasesThatAreStepsHereAndThere)
{
  // A table with a slope beside it; next to the table's border the slope has a hole of two pixels,
  // through which something deeper is seen that is steeper than either.
  const auto slope = [](double x0, double x1, double y0) {
    return sheet({x0, y0, 52 - y0}, {x1 - x0, 0, 0}, {0, 60 - y0, y0 - 60});
  };
  const OwnedMesh all =
      together({sheet({-5, -5, 20}, {74, 0, 0}, {0, 37, 0}), slope(-5, 30, 32), slope(32, 69, 32),
                slope(30, 32, 33), sheet({29, 31, 11.5}, {4, 0, -7}, {0, 3, 0})});
  Stage stage = deepStage(64, 1);
  stage.view.far = 90;
  stage.instances = {outlined(all, 6)};
  const Picture picture = drawOverWhite(stage, GetParam());
  for (int x = 20; x < 44; ++x) {
    for (const int y : {25, 26, 27, 28, 38, 39})
      EXPECT_EQ(at(picture, x, y).g, 255) << x << ", " << y;
    for (const int y : {29, 30, 31, 32, 33})
      EXPECT_EQ(at(picture, x, y).g, 0) << x << ", " << y;
  }
}

}  // namespace
}  // namespace limn::testing
