// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where things appear on the screen, how deep, and how attributes run across a face.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

class Projections : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Projections);

double diskRadius(const Picture& picture)
{
  double samples = 0;
  for (const std::uint8_t coverage : picture.coverage)
    samples += bitCount(coverage);
  return std::sqrt(samples / kPi);
}
float depthAt(const Picture& picture, int x, int y)
{
  return picture.depth[static_cast<std::size_t>(y * picture.width + x)];
}

TEST_P(Projections, ASpheresNearestPointHasTheAnalyticDepth)
{
  for (const bool parallel : {false, true}) {
    Stage stage;
    stage.width = stage.height = 95;
    stage.view.parallel = parallel;
    stage.instances = {instanceOf(fineSphere())};
    // z_eye = 2, near 0.5, far 10: (f+n)/(f-n) - 2fn/((f-n) z), and 2 (z-n)/(f-n) - 1.
    const double ndc = parallel ? 3 / 9.5 - 1 : 10.5 / 9.5 - 10 / (9.5 * 2);
    // Depths near 0.8 have steps of 6e-8; the plane takes three roundings.
    EXPECT_NEAR(depthAt(draw(stage), 47, 47), 0.5 + 0.5 * ndc, 2e-7);
  }
}

TEST_P(Projections, ASpheresOutlineHasTheAnalyticRadius)
{
  Stage stage;
  stage.width = stage.height = 1000;
  stage.instances = {instanceOf(fineSphere())};
  // f R / sqrt(d^2 - R^2), f = 500 / tan(25 degrees).
  constexpr double kPerspective = 379.099;
  // The polyhedron lies 1.25e-4 inside: 0.05 pixels. Counting pixels finds the area to 50: 0.02.
  EXPECT_NEAR(diskRadius(draw(stage)), kPerspective - 0.03, 0.05);
  stage.view.parallel = true;
  EXPECT_NEAR(diskRadius(draw(stage)), 500 / 1.2 - 0.03, 0.05);
}

TEST_P(Projections, ANonSquareWindowKeepsCirclesRound)
{
  Stage stage;
  stage.width = 300;
  stage.height = 100;
  stage.view.eye = {0, 0, 4};
  stage.view.target = {-1.5, 0, 0};
  stage.instances = {instanceOf(fineSphere())};
  // Off the axis the outline is a conic: its box against the silhouette's points.
  const Picture picture = draw(stage);
  int left = stage.width, right = -1, bottom = stage.height, top = -1;
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x)
      if (covered(picture, x, y)) {
        left = std::min(left, x);
        right = std::max(right, x + 1);
        bottom = std::min(bottom, y);
        top = std::max(top, y + 1);
      }
  double minX = 1e9, maxX = -1e9, minY = 1e9, maxY = -1e9;
  for (int i = 0; i < 3600; ++i) {
    // The contour's circle lies in the plane z = R^2/d.
    const double radius = std::sqrt(1 - 1.0 / 16), angle = i * kPi / 1800;
    const Vec3d p = stage.project({radius * std::cos(angle), radius * std::sin(angle), 0.25});
    minX = std::min(minX, p.x);
    maxX = std::max(maxX, p.x);
    minY = std::min(minY, p.y);
    maxY = std::max(maxY, p.y);
  }
  // A pixel is covered if its centre is: half a pixel, and what a curve's last row may hide.
  EXPECT_NEAR(left, minX, 0.75);
  EXPECT_NEAR(right, maxX, 0.75);
  EXPECT_NEAR(bottom, minY, 0.75);
  EXPECT_NEAR(top, maxY, 0.75);
}

TEST_P(Projections, RowZeroIsAtTheBottomAndColumnZeroAtTheLeft)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {0.9, 0, 0}, {0, 0.9, 0});
  Stage stage;
  stage.view = parallelView({0, 0, 3}, {0, 0, 0}, 1);
  stage.instances = {instanceOf(mesh)};
  const Picture picture = draw(stage);
  EXPECT_TRUE(covered(picture, 2, 2));
  EXPECT_FALSE(covered(picture, 2, 93));
  EXPECT_FALSE(covered(picture, 93, 2));
}

/// A long floor running away from the eye, red growing from 0 at z = 0 to 255 at z = -40.
struct Floor {
  OwnedMesh mesh = sheet({-20, 0, 0}, {40, 0, 0}, {0, 0, -40});
  Stage stage;

  Floor()
  {
    mesh.vertexColors = {{0, 0, 255, 255}, {0, 0, 255, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}};
    stage.view = perspectiveView({0, 1, 2}, {0, 0.6, 0}, 50, {0.5, 100});
    stage.instances = {painted(mesh, {1, 1, 1})};
  }
  /// How far down the floor a pixel's ray meets it, 0 to 1; nothing beside it.
  std::optional<double> along(double x, double y) const
  {
    const Ray ray = stage.ray(x, y);
    if (ray.direction.y >= 0) return std::nullopt;
    const Vec3d p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
    if (std::fabs(p.x) > 19 || p.z > 0 || p.z < -40) return std::nullopt;
    return -p.z / 40;
  }
};

TEST_P(Projections, AttributesArePerspectiveCorrectWhereAffineOnesAreFarOff)
{
  const Floor floor;
  const Picture picture = draw(floor.stage);
  // Colours along the middle column, if they ran evenly from the floor's lower to its upper end.
  const double lower = floor.stage.project({0, 0, 0}).y, upper = floor.stage.project({0, 0, -40}).y;
  double worst = 0, worstAffine = 0;
  int compared = 0;
  for (int y = 0; y < floor.stage.height; ++y) {
    const auto t = floor.along(48.5, y + 0.5);
    if (!t || !covered(picture, 48, y)) continue;
    worst = std::max(worst, std::fabs(at(picture, 48, y).r - 255 * *t));
    worstAffine = std::max(worstAffine, 255 * std::fabs((y + 0.5 - lower) / (upper - lower) - *t));
    ++compared;
  }
  EXPECT_GT(compared, 30);
  // Snapping to 1/256 pixel moves the far end's rows, of 60 bytes each, by up to 1/512.
  EXPECT_LT(worst, kRounding + 0.2);
  EXPECT_GT(worstAffine, 100);
}

TEST_P(Projections, ColorsOfAFaceAreRightEverywhereOnIt)
{
  const Floor floor;
  const Picture picture = draw(floor.stage);
  int compared = 0;
  for (int y = 0; y < floor.stage.height; ++y)
    for (int x = 0; x < floor.stage.width; ++x) {
      const auto t = floor.along(x + 0.5, y + 0.5);
      if (!t || !covered(picture, x, y)) continue;
      ASSERT_NEAR(at(picture, x, y).r, 255 * *t, kRounding + 0.2);
      ASSERT_NEAR(at(picture, x, y).b, 255 * (1 - *t), kRounding + 0.2);
      ++compared;
    }
  EXPECT_GT(compared, 3000);
}

TEST_P(Projections, DepthIsLinearOnTheScreenAndAnalytic)
{
  const Floor floor;
  const Picture picture = draw(floor.stage);
  int compared = 0;
  for (int y = 0; y < floor.stage.height; ++y)
    for (int x = 0; x < floor.stage.width; ++x) {
      const auto t = floor.along(x + 0.5, y + 0.5);
      if (!t || !covered(picture, x, y)) continue;
      const Ray ray = floor.stage.ray(x + 0.5, y + 0.5);
      const Vec3d p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
      // Depth runs by 0.005 a row, which snapping moves by 1/512; and floats near 1.
      ASSERT_NEAR(depthAt(picture, x, y), floor.stage.project(p).z, 0.005 / 512 + 2e-7);
      if (y > 1 && covered(picture, x, y - 1) && covered(picture, x, y - 2)) {
        ASSERT_NEAR(depthAt(picture, x, y) - depthAt(picture, x, y - 1),
                    depthAt(picture, x, y - 1) - depthAt(picture, x, y - 2), 3e-7);
      }
      ++compared;
    }
  EXPECT_GT(compared, 3000);
}

}  // namespace
}  // namespace limn::testing
