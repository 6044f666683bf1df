// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/TestScene.h"
#include "Testing/Unit/WorldStage.h"

namespace limn {
namespace {

using testing::chainCount;
using testing::closedChains;
using testing::lengthOf;
using testing::placed;
using testing::Polyhedron;
using testing::WorldStage;

constexpr double kPi = 3.14159265358979323846;

TEST(Intersections, OfTwoSpheresAreTheKnownCircle)
{
  const testing::OwnedMesh ball = testing::sphere(64, 96);
  const double R1 = 1, R2 = 0.8, d = 1.1;
  const Vec3d axis = normalized(Vec3d{1, 0.3, -0.4});
  const WorldStage stage({{ball.view(), placed(R1, {})}, {ball.view(), placed(R2, axis * d)}});
  const ContourLines lines = stage.cuts();
  EXPECT_EQ(chainCount(lines), 1u);
  EXPECT_EQ(closedChains(lines), 1u);
  const double along = (d * d + R1 * R1 - R2 * R2) / (2 * d);
  const double radius = std::sqrt(R1 * R1 - along * along);
  for (const Vec3d& p : lines.points) {
    EXPECT_NEAR(dot(p, axis), along, 2e-3);
    const Vec3d off = p - axis * dot(p, axis);
    EXPECT_NEAR(std::sqrt(dot(off, off)), radius, 3e-3);
  }
  EXPECT_NEAR(lengthOf(lines), 2 * kPi * radius, 0.01);
  EXPECT_TRUE(stage.cuts(1).chains.empty()) << "the first one's alone";
}

TEST(Intersections, OfSpheresThatOnlyComeNearAreNone)
{
  const testing::OwnedMesh ball = testing::sphere(30, 40);
  EXPECT_TRUE(WorldStage({{ball.view(), placed(1, {})}, {ball.view(), placed(1, {2.01, 0, 0})}})
                  .cuts()
                  .chains.empty());
  EXPECT_TRUE(WorldStage({{ball.view(), placed(1, {})}, {ball.view(), placed(0.5, {})}})
                  .cuts()
                  .chains.empty());
}

TEST(Intersections, OfACubeInAPlaneAreASquare)
{
  const Polyhedron cube = testing::cube(), plane = testing::plane(9);
  const ContourLines lines =
      WorldStage({{plane.view(), placed(3, {0, 0, 0.2})}, {cube.view(), placed(1, {0.1, 0, 0})}})
          .cuts();
  EXPECT_EQ(closedChains(lines), 1u);
  EXPECT_EQ(chainCount(lines), 1u);
  EXPECT_NEAR(lengthOf(lines), 8, 1e-9);
}

// The later one counts as lifted by as good as nothing.
TEST(Intersections, TouchingIsAllOrNothing)
{
  const Polyhedron cube = testing::cube(), plane = testing::plane(4);
  EXPECT_TRUE(WorldStage({{plane.view(), placed(3, {})}, {cube.view(), placed(1, {0, 0, 1})}})
                  .cuts()
                  .chains.empty());
  const ContourLines lines =
      WorldStage({{cube.view(), placed(1, {0, 0, 1})}, {plane.view(), placed(3, {})}}).cuts();
  EXPECT_EQ(closedChains(lines), 1u);
  EXPECT_NEAR(lengthOf(lines), 8, 1e-9);
}

TEST(Intersections, OfMeridiansInOrNearAPlaneAreTheCircle)
{
  // From pole to pole and back, with all of the vertices a little above the plane or below.
  const testing::OwnedMesh ball = testing::sphere(16, 32);
  const Polyhedron plane = testing::plane(4);
  for (const float off : {0.0f, 1e-17f, -1e-17f, 1e-12f, -1e-12f, 1e-8f, -1e-8f, 1e-5f, -1e-5f}) {
    Polyhedron turned;
    turned.triangles = ball.triangles;
    // Exact, so that the seam and the poles are each one place.
    const auto snapped = [](float x, float to) { return std::fabs(x) < 1e-6f ? to : x; };
    for (const Vec3f& p : ball.positions)
      turned.positions.push_back({snapped(p.z, 0), snapped(p.x, 0), snapped(p.y, off)});
    const ContourLines lines =
        WorldStage({{turned.view(), placed(1, {})}, {plane.view(), placed(1.5, {})}}).cuts();
    EXPECT_EQ(chainCount(lines), 1u) << off;
    EXPECT_EQ(closedChains(lines), 1u) << off;
    EXPECT_NEAR(lengthOf(lines), 2 * kPi, 0.03) << off;
  }
}

TEST(Intersections, WithinOneMeshAreFoundAndItsOwnEdgesAreNone)
{
  const testing::OwnedMesh ball = testing::sphere(24, 32);
  Polyhedron two;
  for (const double x : {0.0, 1.2}) {
    const auto first = static_cast<std::uint32_t>(two.positions.size());
    for (const Vec3f& p : ball.positions)
      two.positions.push_back(p + Vec3f{static_cast<float>(x), 0, 0});
    for (const Triangle& t : ball.triangles)
      two.triangles.push_back({{t.vertex[0] + first, t.vertex[1] + first, t.vertex[2] + first}});
  }
  const ContourLines lines = WorldStage({{two.view(), placed(1, {})}}).cuts();
  EXPECT_EQ(closedChains(lines), 1u);
  EXPECT_NEAR(lengthOf(lines), 2 * kPi * std::sqrt(1 - 0.36), 0.05);
  EXPECT_TRUE(WorldStage({{ball.view(), placed(1, {})}}).cuts().chains.empty());
  EXPECT_TRUE(
      WorldStage({{testing::torus(1, 0.3, 40, 20).view(), placed(1, {})}}).cuts().chains.empty());
}

TEST(Intersections, AreOfABodyThatWantsThem)
{
  const testing::OwnedMesh ball = testing::sphere(24, 32);
  WorldStage stage({{ball.view(), placed(1, {})}, {ball.view(), placed(1, {1, 0, 0})}});
  stage.isWanted = {0, 1};
  EXPECT_TRUE(stage.cuts(0).chains.empty());
  EXPECT_NEAR(lengthOf(stage.cuts(1)), 2 * kPi * std::sqrt(0.75), 0.05);
  stage.isWanted = {0, 0};
  EXPECT_TRUE(stage.cuts(1).chains.empty());
}

}  // namespace
}  // namespace limn
