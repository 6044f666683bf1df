// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/TestScene.h"
#include "Testing/Unit/WorldStage.h"

namespace limn {
namespace {

using testing::chainCount;
using testing::closedChains;
using testing::lamp;
using testing::lengthOf;
using testing::placed;
using testing::Polyhedron;
using testing::sunlight;
using testing::WorldStage;

constexpr double kPi = 3.14159265358979323846;

// Over finer and finer floors: the border is cut at their edges, and stays one chain.
TEST(CastShadows, OfASquareInSunlightIsTheSameSquareMoved)
{
  for (const std::uint32_t cells : {1u, 7u, 40u}) {
    const Polyhedron square = testing::plane(2), floor = testing::plane(cells);
    const WorldStage stage(
        {{square.view(), placed(1, {0.1, 0.2, 2})}, {floor.view(), placed(9, {})}});
    const ContourLines lines = stage.shadowOf(0, sunlight({1, 0.5, -2}));
    EXPECT_EQ(chainCount(lines), 1u) << cells;
    EXPECT_EQ(closedChains(lines), 1u) << cells;
    EXPECT_NEAR(lengthOf(lines), 8, 1e-9);
    for (const Vec3d& p : lines.points) {
      EXPECT_NEAR(p.z, 0, 1e-12);
      // The middle has moved by the light's slope.
      EXPECT_NEAR(std::max(std::fabs(p.x - 1.1), std::fabs(p.y - 0.7)), 1, 1e-12);
    }
    EXPECT_TRUE(stage.shadowOf(1, sunlight({1, 0.5, -2})).chains.empty()) << "the floor's own";
  }
}

// A sheared square: sides of the parallelogram that a tilted one casts.
TEST(CastShadows, OfATiltedSquareIsAParallelogram)
{
  const Polyhedron square = testing::plane(1), floor = testing::plane(3);
  const Mat4d tilted = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0.5, 0, 1, 3}, {0, 0, 0, 1}}};
  const WorldStage stage({{square.view(), tilted}, {floor.view(), placed(9, {})}});
  const ContourLines lines = stage.shadowOf(0, sunlight({0.6, 0.8, -1}));
  EXPECT_EQ(closedChains(lines), 1u);
  // x runs to (1, 0, 0.5), which falls on (1.3, 0.4).
  EXPECT_NEAR(lengthOf(lines), 2 * (2 * std::hypot(1.3, 0.4) + 2), 1e-9);
}

TEST(CastShadows, OfASquareInALampIsAScaledSquare)
{
  const Polyhedron square = testing::plane(2), floor = testing::plane(5);
  const WorldStage stage({{square.view(), placed(1, {0.3, 0, 1})}, {floor.view(), placed(20, {})}});
  const ContourLines lines = stage.shadowOf(0, lamp({0.3, 0, 4}));
  EXPECT_EQ(closedChains(lines), 1u);
  EXPECT_NEAR(lengthOf(lines), 8 * 4.0 / 3, 1e-9);
  for (const Vec3d& p : lines.points)
    EXPECT_NEAR(std::max(std::fabs(p.x - 0.3), std::fabs(p.y)), 4.0 / 3, 1e-12);
}

TEST(CastShadows, OfASphereInSunlightIsAnEllipse)
{
  const testing::OwnedMesh ball = testing::sphere(60, 90);
  const Polyhedron floor = testing::plane(6);
  const WorldStage stage({{ball.view(), placed(1, {0, 0, 3})}, {floor.view(), placed(20, {})}});
  const ContourLines lines = stage.shadowOf(0, sunlight({1, 0, -1}));
  EXPECT_EQ(chainCount(lines), 1u);
  EXPECT_EQ(closedChains(lines), 1u);
  for (const Vec3d& p : lines.points) {
    EXPECT_NEAR(p.z, 0, 1e-12);
    EXPECT_NEAR(std::hypot((p.x - 3) / std::sqrt(2), p.y), 1, 2e-3);
  }
  // Ramanujan's length of an ellipse.
  const double a = std::sqrt(2), h = (a - 1) * (a - 1) / ((a + 1) * (a + 1));
  EXPECT_NEAR(lengthOf(lines), kPi * (a + 1) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))), 0.02);
}

TEST(CastShadows, NothingBehindOrNothingCastsGivesNone)
{
  const Polyhedron square = testing::plane(2), floor = testing::plane(5);
  const testing::OwnedMesh ball = testing::sphere(30, 40);
  const WorldStage alone({{ball.view(), placed(1, {})}});
  EXPECT_TRUE(alone.shadowOf(0, sunlight({1, 2, 3})).chains.empty());
  EXPECT_TRUE(alone.shadowOf(0, lamp({3, 1, 0})).chains.empty());
  const WorldStage below({{square.view(), placed(1, {0, 0, 2})}, {floor.view(), placed(9, {})}});
  EXPECT_TRUE(below.shadowOf(0, sunlight({0, 0, 1})).chains.empty()) << "light from below";
  // Not the floor's border either, whose shadow has nothing to fall on.
  EXPECT_TRUE(below.shadowOf(1, sunlight({0, 0, -1})).chains.empty());
  EXPECT_TRUE(below.shadowOf(0, lamp({0, 0, 1})).chains.empty()) << "a lamp under it";
}

// A square under a larger one lies in its shadow and casts none.
TEST(CastShadows, WhatIsInShadowCastsNone)
{
  const Polyhedron square = testing::plane(2), floor = testing::plane(5);
  const WorldStage stage({{square.view(), placed(1, {0, 0, 1})},
                          {square.view(), placed(2, {0, 0, 2})},
                          {floor.view(), placed(9, {})}});
  EXPECT_TRUE(stage.shadowOf(0, sunlight({0.1, 0, -1})).chains.empty());
  EXPECT_NEAR(lengthOf(stage.shadowOf(1, sunlight({0.1, 0, -1}))), 16, 1e-9);
  // Half of it sticks out.
  const WorldStage half({{square.view(), placed(1, {1, 0, 1})},
                         {square.view(), placed(2, {-1, 0, 2})},
                         {floor.view(), placed(9, {})}});
  const LightRays light = sunlight({0, 0, -1});
  EXPECT_NEAR(lengthOf(half.shadowOf(0, light)), 1 + 2 + 1, 1e-9);
  // Of the upper one's border a part falls on the lower one.
  const ContourLines upper = half.shadowOf(1, light);
  double onLower = 0, onFloor = 0;
  for (const Vec3d& p : upper.points)
    (p.z > 0.5 ? onLower : onFloor) += 1;
  EXPECT_GT(onLower, 1);
  EXPECT_GT(onFloor, 3);
  EXPECT_NEAR(lengthOf(upper), 16, 1e-9);
}

// A cube that stands on the floor: the shadow begins at its feet, and the feet have none.
TEST(CastShadows, OfACubeOnTheFloorStartsAtItsFeet)
{
  const Polyhedron cube = testing::cube(), floor = testing::plane(8);
  const WorldStage stage({{cube.view(), placed(0.5, {0, 0, 0.5})}, {floor.view(), placed(6, {})}});
  const ContourLines oblique = stage.shadowOf(0, sunlight({1, 0.5, -1}));
  EXPECT_EQ(chainCount(oblique), 1u);
  // The shadow of the top, moved by (1, 1/2), has two sides whole; from its two outermost corners
  // the shadows of the vertical edges run back to the feet.
  EXPECT_NEAR(lengthOf(oblique), 1 + 1 + 2 * std::hypot(1, 0.5), 1e-4);
  for (const Vec3d& p : oblique.points)
    EXPECT_NEAR(p.z, 0, 1e-9);
}

// From each point of the border the way to the light touches the torus and goes on.
TEST(CastShadows, OfATorusFallsOnItselfToo)
{
  const Polyhedron torus = testing::torus(1, 0.3, 96, 48);
  const WorldStage stage({{torus.view(), placed(1, {})}});
  const LightRays light = sunlight({1, 0, -0.4});
  const ContourLines lines = stage.shadowOf(0, light);
  ASSERT_GT(lengthOf(lines), 1.5);
  const auto above = [](Vec3d p) {
    const double ring = std::hypot(p.x, p.y) - 1;
    return std::hypot(ring, p.z) - 0.3;
  };
  for (const Vec3d& p : lines.points) {
    EXPECT_NEAR(above(p), 0, 0.002);
    double least = 1;
    for (int i = 20; i < 400; ++i)
      least = std::min(least, above(p + light.source * (0.01 * i)));
    EXPECT_NEAR(least, 0, 0.04);
  }
}

TEST(CastShadows, OfASpotEndsAtItsCone)
{
  const Polyhedron square = testing::plane(1), floor = testing::plane(5);
  const WorldStage stage({{square.view(), placed(1, {0, 0, 1})}, {floor.view(), placed(20, {})}});
  // At the square the cone has a radius of sqrt(1.25): it holds the middle of each side, half of
  // it.
  const LightRays spot = {false, {0, 0, 4}, true, {0, 0, -1}, 3 / std::sqrt(9 + 1.25)};
  EXPECT_NEAR(lengthOf(stage.shadowOf(0, spot)), 4 * 4.0 / 3, 1e-6);
  const LightRays narrow = {false, {0, 0, 4}, true, {0, 0, -1}, 3 / std::sqrt(9 + 0.9)};
  EXPECT_TRUE(stage.shadowOf(0, narrow).chains.empty());
}

TEST(CastShadows, BrokenTrianglesDoNotCount)
{
  Polyhedron square = testing::plane(1);
  const Polyhedron floor = testing::plane(3);
  square.positions.push_back({HUGE_VALF, 0, 0});
  square.triangles.push_back({{0, 1, 4}});
  square.triangles.push_back({{0, 1, 99}});
  square.triangles.push_back({{0, 0, 1}});
  const WorldStage stage({{square.view(), placed(1, {0, 0, 2})}, {floor.view(), placed(9, {})}});
  ASSERT_TRUE(stage.status.ok());
  EXPECT_NEAR(lengthOf(stage.shadowOf(0, sunlight({0, 0.5, -2}))), 8, 1e-9);
}

}  // namespace
}  // namespace limn
