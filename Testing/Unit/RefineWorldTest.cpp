// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/TestScene.h"
#include "Testing/Unit/WorldStage.h"

#include <algorithm>
#include <map>
#include <utility>

namespace limn {
namespace {

using testing::placed;
using testing::Polyhedron;
using testing::WorldStage;

double farthestFromTorus(Span<const Vec3d> points, double r)
{
  double most = 0;
  for (const Vec3d& p : points)
    most = std::max(most, std::fabs(std::hypot(std::hypot(p.x, p.y) - 1, p.z) - r));
  return most;
}

/// How often each side of the triangles occurs, and those of the edges.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> sidesOf(const WorldMesh& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> count;
  for (const Triangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle.vertex[k], b = triangle.vertex[(k + 1) % 3];
      ++count[{std::min(a, b), std::max(a, b)}];
    }
  return count;
}

TEST(RefineWorld, PointsLieOnTheSmoothSurface)
{
  const Polyhedron torus = testing::torus(1, 0.4, 32, 16);
  const WorldStage stage({{torus.view(), placed(1, {})}});
  const RefinedWorld& refined = stage.refined;
  // As fine as the number of triangles allows: 8 x 8 of each were too many.
  EXPECT_EQ(refined.fineness[0], 7u);
  EXPECT_EQ(refined.mesh.triangles.size(), 49 * torus.triangles.size());
  // The middles of the drawn facets' sides are 0.0077 below the surface across the tube.
  EXPECT_LT(farthestFromTorus(refined.mesh.points, 0.4), 0.0007);
  EXPECT_GT(farthestFromTorus(refined.flat, 0.4), 0.007);
}

TEST(RefineWorld, IsWatertightAndKnowsItsEdges)
{
  const Polyhedron torus = testing::torus(1, 0.4, 12, 9);
  const WorldStage stage({{torus.view(), placed(1, {})}});
  const WorldMesh& mesh = stage.refined.mesh;
  const auto sides = sidesOf(mesh);
  EXPECT_EQ(mesh.edges.size(), sides.size());
  for (const auto& [side, count] : sides)
    EXPECT_EQ(count, 2);
  for (const WorldEdge& edge : mesh.edges)
    for (const std::uint32_t t : edge.triangle) {
      ASSERT_LT(t, mesh.triangles.size());
      const auto& v = mesh.triangles[t].vertex;
      for (const std::uint32_t p : edge.point)
        EXPECT_EQ(std::count(v, v + 3, p), 1);
    }
  // The Euler characteristic of a torus.
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size(), mesh.edges.size());
}

TEST(RefineWorld, LeavesFlatFacesAsTheyAre)
{
  const Polyhedron cube = testing::cube(), torus = testing::torus(1, 0.4, 12, 9);
  const WorldStage alone({{cube.view(), placed(1, {})}});
  EXPECT_EQ(alone.refined.mesh.triangles.size(), cube.triangles.size());
  EXPECT_EQ(alone.refined.mesh.edges.size(), alone.world.edges.size());
  const WorldStage both({{cube.view(), placed(1, {})}, {torus.view(), placed(1, {5, 0, 0})}});
  EXPECT_EQ(both.refined.fineness[0], 1u);
  EXPECT_GT(both.refined.fineness[1], 1u);
  EXPECT_EQ(both.refined.mesh.firstEdge[1], both.world.firstEdge[1]);
}

// A lid on a tube: its rim is an edge at which the patches on both sides meet.
TEST(RefineWorld, PatchesMeetAtCreases)
{
  Polyhedron can;
  constexpr std::uint32_t kSides = 12;
  for (std::uint32_t i = 0; i < kSides; ++i)
    for (const float z : {0.0f, 1.0f}) {
      const double a = 2 * 3.14159265358979323846 * i / kSides;
      can.positions.push_back(
          {static_cast<float>(std::cos(a)), static_cast<float>(std::sin(a)), z});
    }
  can.positions.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
    can.triangles.push_back({{a, b, b + 1}});
    can.triangles.push_back({{a, b + 1, a + 1}});
    can.triangles.push_back({{a + 1, b + 1, 2 * kSides}});
  }
  const WorldStage stage({{can.view(), placed(1, {})}});
  EXPECT_GT(stage.refined.fineness[0], 1u);
  int borders = 0;
  for (const auto& [side, count] : sidesOf(stage.refined.mesh))
    borders += count == 1 ? 1 : 0;
  EXPECT_EQ(borders, static_cast<int>(kSides * stage.refined.fineness[0]));
  std::size_t curved = 0;
  for (std::size_t i = 0; i < stage.refined.flat.size(); ++i) {
    const Vec3d p = stage.refined.mesh.points[i], apart = p - stage.refined.flat[i];
    EXPECT_LE(p.z, 1 + 1e-6);
    if (p.z > 1 - 1e-6) {
      EXPECT_LT(dot(apart, apart), 1e-12) << "the lid, with its rim";
    }
    curved += dot(apart, apart) > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(curved, 100u) << "the tube";
}

}  // namespace
}  // namespace limn
