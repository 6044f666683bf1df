// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of the finished picture between parts of one instance: their place, their width, what they
// leave alone.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

class IdBorders : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(IdBorders);

/// White, with black lines between `ids`, which has to outlive it.
Instance parted(const OwnedMesh& mesh, const std::vector<std::uint32_t>& ids, float width)
{
  Instance instance = painted(mesh, {1, 1, 1});
  instance.style.imageOutline.detector = OutlineDetector::kPlane;
  instance.style.imageOutline.ids = true;
  instance.style.outlineWidth = width;
  instance.attributes.cellIds = ids;
  return instance;
}

Stage flatStage(int side, int samples)
{
  Stage stage = pixelStage(side, samples);
  stage.view.eye.z = 200;
  stage.view.near = 1;
  stage.view.far = 400;
  stage.resolve = Resolve::kLinear;
  return stage;
}

double darknessAt(const Picture& picture, int x, int y)
{
  return (255.0 - at(picture, x, y).g) / 255.0;
}

struct Box {
  int x0, y0, x1, y1;
};
double darkness(const Picture& picture, const Box& box)
{
  double sum = 0;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
      sum += darknessAt(picture, x, y);
  return sum;
}

/// A plane larger than a picture of 100 pixels, of two cells whose border passes (50.3, 49.8).
OwnedMesh splitPlane(double degrees, double slope)
{
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  const auto at = [&](double u, double v) {
    const double x = 50.3 + c * u - s * v, y = 49.8 + s * u + c * v;
    return Vec3d{x, y, slope * (x + 0.5 * y)};
  };
  constexpr double kFar = 150;
  OwnedMesh mesh = soup({at(-kFar, 0), at(kFar, 0), at(kFar, kFar), at(-kFar, 0), at(kFar, kFar),
                         at(-kFar, kFar), at(-kFar, -kFar), at(kFar, -kFar), at(kFar, 0),
                         at(-kFar, -kFar), at(kFar, 0), at(-kFar, 0)});
  return mesh;
}

TEST_P(IdBorders, CoverWidthTimesLengthInAPlane)
{
  // Samples tell the border to some hundredths of a pixel, by which a line sways and gets longer.
  constexpr double kSampling = 0.027;
  const std::vector<std::uint32_t> ids = {7, 7, 3, 3};
  const bool isFast = GetParam() == Backend::kPipeline;
  const std::vector<double> angles =
      isFast ? std::vector<double>{0, 3, 11, 18, 27, 31, 38, 44} : std::vector<double>{11, 31};
  for (const int samples : {8, 16})
    for (const double slope : {0.0, 1.0})
      for (const double degrees : angles)
        for (const float width : {1.0f, 2.0f, 3.5f}) {
          if (!isFast && width != 2.0f) continue;
          const OwnedMesh plane = splitPlane(degrees, slope);
          Stage stage = flatStage(100, samples);
          stage.instances = {parted(plane, ids, width)};
          const double length = 60 / std::cos(degrees * kPi / 180);
          const Picture picture = draw(stage);
          EXPECT_NEAR(darkness(picture, {20, 0, 80, 100}) / length, width,
                      std::max(0.005 * width, samples == 8 ? kSampling : 0.005))
              << degrees << " degrees, " << samples << " samples, slope " << slope << ", width "
              << width;
        }
}

TEST_P(IdBorders, LieInTheMiddleToAPartOfAPixel)
{
  const std::vector<std::uint32_t> ids = {7, 7, 3, 3};
  for (const double slope : {0.0, 1.0})
    for (const double degrees : {0.0, 17.0, 45.0, 70.0, 100.0}) {
      const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
      const OwnedMesh plane = splitPlane(degrees, slope);
      Stage stage = flatStage(100, 8);
      stage.instances = {parted(plane, ids, 3)};
      const Picture picture = draw(stage);
      for (int y = 20; y < 80; ++y)
        for (int x = 20; x < 80; ++x) {
          const double off = std::fabs((x + 0.5 - 50.3) * -s + (y + 0.5 - 49.8) * c);
          if (off < 1.5 - 0.9) {
            EXPECT_EQ(at(picture, x, y).g, 0) << x << ", " << y << " at " << degrees;
          } else if (off > 1.5 + 0.9) {
            EXPECT_EQ(at(picture, x, y).g, 255) << x << ", " << y << " at " << degrees;
          }
        }
    }
}

TEST_P(IdBorders, CoverTheLinesOfACheckeredPlane)
{
  // 6 x 6 squares of 16.25 pixels; lines between them, and none of their triangles' diagonals.
  constexpr double kCell = 16.25;
  const OwnedMesh plane = sheet({2.3, 2.7, 0}, {6 * kCell, 0, 0}, {0, 6 * kCell, 0}, 6);
  std::vector<std::uint32_t> ids;
  for (std::uint32_t cell = 0; cell < 36; ++cell)
    ids.push_back((cell / 6 + cell % 6) % 2);
  // Where lines cross a pixel has the larger of two shares, not their union: looked at apart.
  constexpr int kNear = 5;
  const auto isNear = [](int x, double corner) {
    const double cells = (x + 0.5 - corner) / kCell;
    return std::fabs(cells - std::round(cells)) * kCell < kNear;
  };
  for (const int samples : {1, 4, 8, 16})
    for (const float width : {1.0f, 2.0f, 3.0f}) {
      Stage stage = flatStage(100, samples);
      stage.instances = {parted(plane, ids, width)};
      const Picture picture = draw(stage);
      double lines = 0, crossings = 0;
      int length = 0;
      for (int y = 11; y < 91; ++y)
        for (int x = 11; x < 91; ++x) {
          const bool isNearX = isNear(x, 2.3), isNearY = isNear(y, 2.7);
          (isNearX && isNearY ? crossings : lines) += darknessAt(picture, x, y);
        }
      for (int x = 11; x < 91; ++x)
        length += 5 * (!isNear(x, 2.3) + !isNear(x, 2.7));
      EXPECT_NEAR(lines / length / width, 1, 0.005) << samples << " samples, width " << width;
      const double w = width, expected = 5 * w * (2 * 80 - length / 5) - 25 * w * w;
      EXPECT_NEAR(crossings / 25, expected / 25, 1.2) << samples << " samples, width " << width;
    }
}

TEST_P(IdBorders, LieAtBothSidesOfANarrowPart)
{
  // A part of 2.2 pixels, and then of 1.4: a window about one border sees the other, too.
  const std::vector<std::uint32_t> ids = {1, 1, 2, 2, 1, 1};
  struct Case {
    double left, right;
    float width;
    std::vector<double> columns;  ///< from 49 on
  };
  const Case cases[] = {{50.1, 52.3, 1, {0.4, 0.6, 0.2, 0.8}},
                        {50.4, 51.8, 0.6f, {0, 0.6, 0.5, 0.1}}};
  for (const Case& one : cases) {
    std::vector<Vec3d> points;
    const double x[] = {-10, one.left, one.right, 110};
    for (int i = 0; i < 3; ++i) {
      const Vec3d a = {x[i], -10, 0}, b = {x[i + 1], -10, 0}, up = {0, 120, 0};
      points.insert(points.end(), {a, b, b + up, a, b + up, a + up});
    }
    const OwnedMesh mesh = soup(points);
    Stage stage = flatStage(100, 16);
    stage.instances = {parted(mesh, ids, one.width)};
    const Picture picture = draw(stage);
    for (std::size_t i = 0; i < one.columns.size(); ++i)
      EXPECT_NEAR(darknessAt(picture, 49 + static_cast<int>(i), 50), one.columns[i], 0.04)
          << "column " << i << " of " << one.left;
  }
}

TEST_P(IdBorders, CrossACurvedSurfaceAndLieNowhereElse)
{
  const OwnedMesh& ball = fineSphere();
  std::vector<std::uint32_t> ids(ball.cellCount);
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    double y = 0;
    for (const std::uint32_t vertex : ball.triangles[t].vertex)
      y += ball.positions[vertex].y;
    ids[ball.cells[t]] = y > 0 ? 5 : 9;
  }
  for (const int samples : {1, 8}) {
    Stage stage;
    stage.width = stage.height = 120;
    stage.samples = samples;
    stage.view = perspectiveView({0, 0, 3}, {0, 0, 0}, 50);
    stage.instances = {parted(ball, ids, 2)};
    stage.instances[0].style.normals = NormalSource::kVertex;
    const Picture lined = draw(stage);
    stage.instances[0].style.imageOutline.ids = false;
    const Picture plain = draw(stage);
    int changed = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 120; ++x) {
        if (at(lined, x, y).g == at(plain, x, y).g) continue;
        ++changed;
        // The equator is seen edge on, but for the mesh's cells.
        EXPECT_NEAR(y + 0.5, 60, 3) << x << ", " << y;
      }
    EXPECT_GT(changed, 150);
  }
}

OwnedMesh cube()
{
  std::vector<Vec3d> points;
  const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const Vec3d n = axes[axis] * side, u = axes[(axis + 1) % 3], v = cross(n, u);
      const Vec3d a = n - u - v, b = n + u - v, c = n + u + v, d = n - u + v;
      points.insert(points.end(), {a, b, c, a, c, d});
    }
  return soup(points);
}

TEST_P(IdBorders, OfACubesFacesAreItsCreases)
{
  const OwnedMesh mesh = cube();
  std::vector<std::uint32_t> ids;
  for (std::uint32_t triangle = 0; triangle < 12; ++triangle)
    ids.push_back(triangle / 2);
  for (const int samples : {1, 4, 8}) {
    Stage stage;
    stage.samples = samples;
    stage.resolve = Resolve::kLinear;
    stage.view = perspectiveView({3, 2.2, 4}, {0, 0, 0}, 40);
    stage.view.far = 20;
    stage.instances = {parted(mesh, ids, 2)};
    stage.instances[0].style.imageOutline.ids = false;
    const Picture creased = draw(stage);
    stage.instances[0].style.imageOutline.ids = true;
    const Picture both = draw(stage);
    stage.instances[0].style.imageOutline.creaseDegrees = 180;
    const Picture parts = draw(stage);
    stage.instances[0].style.imageOutline.ids = false;
    const Box all = {0, 0, 96, 96};
    const double border = darkness(draw(stage), all);  // the background, too
    const double expected = darkness(creased, all) - border;
    EXPECT_GT(expected, 150);
    for (const Picture* picture : {&both, &parts}) {
      double off = 0;
      for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
          off = std::max(off, std::fabs(darknessAt(*picture, x, y) - darknessAt(creased, x, y)));
      // One sample tells no more than between which pixels the border lies.
      EXPECT_NEAR((darkness(*picture, all) - border) / expected, 1, samples == 1 ? 0.06 : 0.03);
      EXPECT_LT(off, samples == 1 ? 0.8 : 0.35) << samples;
    }
  }
}

TEST_P(IdBorders, BelongToTheNearerPartAtSteps)
{
  const OwnedMesh mesh = soup({{4, 4, 0},
                               {60, 4, 0},
                               {60, 60, 0},
                               {4, 4, 0},
                               {60, 60, 0},
                               {4, 60, 0},
                               {20, 20, 20},
                               {44, 20, 20},
                               {44, 44, 20},
                               {20, 20, 20},
                               {44, 44, 20},
                               {20, 44, 20}});
  const std::vector<std::uint32_t> ids = {1, 1, 2, 2};
  Stage stage = flatStage(64, 4);
  stage.instances = {parted(mesh, ids, 2)};
  const Picture parts = draw(stage);
  stage.instances[0].style.imageOutline.ids = false;
  EXPECT_EQ(draw(stage).differingPixels(parts), 0u);
  EXPECT_EQ(at(parts, 20, 32).g, 0);
  EXPECT_EQ(at(parts, 19, 32).g, 255);
}

TEST_P(IdBorders, AreOfCellsAndNotOfTriangles)
{
  const OwnedMesh plane = sheet({-8, -8, 0}, {80, 0, 0}, {0, 80, 0}, 2);
  const std::vector<std::uint32_t> ids = {1, 1, 2, 2}, same = {4, 4, 4, 4};
  Stage stage = flatStage(64, 1);
  stage.instances = {parted(plane, same, 2)};
  EXPECT_EQ(darkness(draw(stage), {8, 8, 56, 56}), 0);
  stage.instances = {parted(plane, ids, 2)};
  const Picture picture = draw(stage);
  for (const int y : {31, 32})
    EXPECT_EQ(at(picture, 20, y).g, 0) << y;
  for (const int y : {29, 30, 33, 34})
    EXPECT_EQ(at(picture, 20, y).g, 255) << y;
  EXPECT_EQ(at(picture, 32, 20).g, 255) << "cells of one id have no border";
}

TEST_P(IdBorders, NeedAnIdForEachCell)
{
  const OwnedMesh plane = sheet({4, 4, 0}, {40, 0, 0}, {0, 40, 0}, 2);
  const std::vector<std::uint32_t> few = {1, 2, 3};
  Stage stage = flatStage(64, 1);
  stage.instances = {parted(plane, few, 2)};
  Picture picture(64, 64);
  EXPECT_EQ(render(stage.scene(), picture.frame(Background::kBlend), {GetParam(), 1}).error,
            Error::kSizeMismatch);
  stage.instances[0].attributes.cellIds = {};
  EXPECT_TRUE(render(stage.scene(), picture.frame(Background::kBlend), {GetParam(), 1}).ok());
}

}  // namespace
}  // namespace limn::testing
