// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/TestScene.h"
#include "Testing/Unit/WorldStage.h"

#include <algorithm>

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

/// A trefoil of a round tube.
Polyhedron knot(std::uint32_t along, std::uint32_t across)
{
  const auto center = [](double t) {
    return Vec3d{std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                 -std::sin(3 * t)};
  };
  Polyhedron mesh;
  for (std::uint32_t i = 0; i < along; ++i) {
    const double t = 2 * kPi * i / along;
    const Vec3d way = normalized(center(t + 1e-4) - center(t - 1e-4));
    const Vec3d x = normalized(cross(way, {0.3, 0.2, 1})), y = cross(way, x);
    for (std::uint32_t j = 0; j < across; ++j) {
      const double a = 2 * kPi * j / across;
      mesh.positions.push_back(
          vec3Cast<float>(center(t) + (x * std::cos(a) + y * std::sin(a)) * 0.6));
      const std::uint32_t next = (i + 1) % along * across, side = (j + 1) % across;
      mesh.triangles.push_back({{i * across + j, next + j, next + side}});
      mesh.triangles.push_back({{i * across + j, next + side, i * across + side}});
    }
  }
  return mesh;
}

double distanceTo(Vec3d a, Vec3d b, Vec3d p)
{
  const Vec3d e = b - a;
  const double t = dot(e, e) > 0 ? dot(p - a, e) / dot(e, e) : 0.0;
  const Vec3d apart = a + e * std::min(std::max(t, 0.0), 1.0) - p;
  return std::sqrt(dot(apart, apart));
}

/// Ends of chains that are farther than `near` from all contours seen from the light, the closed
/// body's only other lines, and from all borders but their own last stretch.
std::size_t looseEnds(const WorldStage& stage, const LightRays& light, const ContourLines& lines,
                      double near)
{
  const auto casters = shadowCasters(stage.refined.mesh, stage.refined.normals, light, 2);
  const LineChains& chains = lines.chains;
  const auto point = [&](std::uint32_t i) { return lines.points[chains.vertex[i]]; };
  const auto isAtLine = [&](std::uint32_t end) {
    const Vec3d p = point(end);
    for (const ShadowCaster& caster : casters)
      if (distanceTo(caster.end[0], caster.end[1], p) <= near) return true;
    for (std::size_t c = 0; c < chainCount(lines); ++c) {
      const std::uint32_t first = chains.first[c], last = chains.first[c + 1] - 1;
      double since = end == first || end == last ? 0 : HUGE_VAL;
      for (std::uint32_t k = first; k < last; ++k) {
        const std::uint32_t i = end == last ? last - 1 - (k - first) : k;
        if (since > 3 * near && distanceTo(point(i), point(i + 1), p) <= near) return true;
        since += std::sqrt(dot(point(i) - point(i + 1), point(i) - point(i + 1)));
      }
    }
    return false;
  };
  std::size_t count = 0;
  for (std::size_t c = 0; c < chainCount(lines); ++c) {
    const std::uint32_t first = chains.first[c], last = chains.first[c + 1] - 1;
    if (chains.vertex[first] == chains.vertex[last]) continue;
    for (const std::uint32_t end : {first, last})
      count += isAtLine(end) ? 0 : 1;
  }
  return count;
}

// Where light grazes. Each of the two borders in the hole runs from a cusp of the contour to where
// the contour below it hides it: both on n.l = 0.
TEST(CastShadows, OfATorusIsTwoLinesFromTerminatorToTerminator)
{
  const Polyhedron torus = testing::torus(1, 0.4, 64, 32);
  const WorldStage stage({{torus.view(), placed(1, {})}});
  for (const double turn : {0.0, 0.4, 1.1, 2.9}) {
    const LightRays light =
        sunlight({std::sqrt(2) * std::cos(turn), std::sqrt(2) * std::sin(turn), -1});
    const ContourLines lines = stage.shadowOf(0, light);
    ASSERT_EQ(chainCount(lines), 2u) << turn;
    EXPECT_EQ(closedChains(lines), 0u);
    EXPECT_NEAR(lengthOf(lines), 1.14, 0.06);
    for (std::size_t c = 0; c < 2; ++c)
      for (const std::uint32_t i : {lines.chains.first[c], lines.chains.first[c + 1] - 1}) {
        const Vec3d p = lines.points[lines.chains.vertex[i]];
        const double ring = std::hypot(p.x, p.y);
        const Vec3d normal = (p - Vec3d{p.x / ring, p.y / ring, 0}) * (1 / 0.4);
        EXPECT_NEAR(dot(normal, light.source), 0, 0.05) << turn;
      }
  }
}

/// How far a place is from the triangles of a mesh that lie below or above it.
double distanceFrom(const WorldMesh& mesh, Vec3d p)
{
  double least = HUGE_VAL;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3d a = mesh.corner(t, 0), e1 = mesh.corner(t, 1) - a, e2 = mesh.corner(t, 2) - a;
    const Vec3d n = cross(e1, e2);
    const double v = dot(cross(p - a, e2), n) / dot(n, n), w = dot(cross(e1, p - a), n) / dot(n, n);
    if (v < -1e-6 || w < -1e-6 || v + w > 1 + 1e-6) continue;
    least = std::min(least, std::fabs(dot(normalized(n), p - a)));
  }
  return least;
}

// Though it is found on curved patches.
TEST(CastShadows, LieInTheFacetsThatAreDrawn)
{
  const Polyhedron torus = testing::torus(1, 0.4, 32, 16);
  const WorldStage stage({{torus.view(), placed(1, {})}});
  const ContourLines lines = stage.shadowOf(0, sunlight({1, 1, -1}));
  EXPECT_GT(lines.points.size(), 50u);
  for (const std::uint32_t i : lines.chains.vertex)
    EXPECT_LT(distanceFrom(stage.world, lines.points[i]), 1e-9);
}

// All about a torus and a knot: a border ends at the contour or another border, to within less than
// a third of a facet and a facet as they are drawn, or not at all.
TEST(CastShadows, HasNoGapsWhileTheLightTurns)
{
  const Polyhedron torus = testing::torus(1, 0.4, 64, 32), tube = knot(160, 20);
  const WorldStage rings({{torus.view(), placed(1, {})}}), knots({{tube.view(), placed(1, {})}});
  std::size_t ofTorus = 0, ofKnot = 0, chains = 0;
  for (int step = 0; step < 90; ++step) {
    const double turn = 2 * kPi * step / 90;
    const LightRays light = sunlight({std::cos(turn), std::sin(turn), -0.8});
    const ContourLines onTorus = rings.shadowOf(0, light);
    ofTorus += looseEnds(rings, light, onTorus, 0.03);
    chains += chainCount(onTorus);
    if (step % 3 != 0) continue;
    const ContourLines onKnot = knots.shadowOf(0, light);
    ofKnot += looseEnds(knots, light, onKnot, 0.15);
    chains += chainCount(onKnot);
  }
  EXPECT_EQ(ofTorus, 0u);
  EXPECT_EQ(ofKnot, 0u);
  EXPECT_GT(chains, 200u);
  EXPECT_LT(chains, 600u);
}

// Which side of a closed body is wound to be outside does not matter.
TEST(CastShadows, OfAMirroredTorusIsTheMirroredShadow)
{
  const Polyhedron torus = testing::torus(1, 0.4, 32, 16);
  Mat4d mirrored = placed(1, {});
  mirrored.m[0][0] = -1;
  const WorldStage stage({{torus.view(), placed(1, {})}}), mirror({{torus.view(), mirrored}});
  const ContourLines lines = stage.shadowOf(0, sunlight({1, 1, -1}));
  const ContourLines other = mirror.shadowOf(0, sunlight({-1, 1, -1}));
  EXPECT_GT(chainCount(lines), 0u);
  EXPECT_EQ(chainCount(lines), chainCount(other));
  EXPECT_NEAR(lengthOf(lines), lengthOf(other), 0.02);
}

// What falls on a sheet from below does not show from above.
TEST(CastShadows, OnASheetShowsOnTheSideOfTheLight)
{
  const Polyhedron square = testing::plane(1), sheet = testing::plane(1);
  const WorldStage stage({{square.view(), placed(1, {0, 0, 2})}, {sheet.view(), placed(9, {})}});
  const LightRays light = sunlight({0, 0.1, -1});
  const WorldMesh& mesh = stage.refined.mesh;
  const auto casters = shadowCasters(mesh, stage.refined.normals, light, 2);
  const auto pieces = shadowPieces(mesh, *stage.tree, light, casters, stage.creaseDegrees, 2);
  const ShadowLines shadow =
      shadowBorder(stage.refined, casters, pieces, light, 0, Mat4d::identity());
  std::vector<std::uint8_t> flags;
  Camera camera = {translation({0, 0, -5}), Mat4d::identity(), false};
  EXPECT_FALSE(concealBehindSheets(shadow, camera, Mat4d::identity(), flags));
  camera.worldToView = translation({0, 0, 5});
  EXPECT_TRUE(concealBehindSheets(shadow, camera, Mat4d::identity(), flags));
  EXPECT_EQ(std::count(flags.begin(), flags.end(), kConcealedLine),
            static_cast<std::ptrdiff_t>(flags.size()) - 1);
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
