// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/TransformVertices.h"

#include "Testing/Unit/TestScene.h"

#include <cmath>
#include <cstring>

namespace limn::testing {
namespace {

class TransformVertices : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(useTarget(GetParam())); }
  void TearDown() override { useTarget(""); }
};
INSTANTIATE_TEST_SUITE_P(Targets, TransformVertices, ::testing::ValuesIn(availableTargets()),
                         [](const auto& target) { return target.param; });

/// Calls visit(world position, scalar transform's clip point, kernel's vertex) for all vertices.
template <class Visit>
void forEachVertex(const Stage& stage, const OwnedMesh& mesh, Visit visit)
{
  const Scene scene = stage.scene();
  const PlacedScene placed = placeScene(scene, {stage.width, stage.height});
  for (const Cluster& cluster : mesh.clusters.clusters) {
    const PlacedCluster here = {&placed.instances[0], &cluster};
    ScreenVertices screen;
    transformVertices(here, screen);
    for (std::uint32_t v = 0; v < cluster.vertexCount; ++v)
      visit(mesh.view().position(mesh.clusters.vertex[cluster.firstVertex + v]),
            placed.instances[0].transform, here.position(v), screen.vertex(v));
  }
}

/// Points all around a camera that stands among them.
OwnedMesh cloud(std::uint32_t seed, double half, bool precise)
{
  Random random(seed);
  std::vector<Vec3d> points(3000);
  for (Vec3d& p : points)
    p = random.inBox(half);
  OwnedMesh mesh = soup(points);
  if (precise) {
    mesh.positions.clear();
    mesh.precise = points;
    finish(mesh);
  }
  return mesh;
}
Stage amidst(const OwnedMesh& mesh, bool parallel)
{
  Stage stage;
  stage.width = 640;
  stage.height = 480;
  const Vec3d eye = {0.3, 0.2, 1}, target = {0, 0, -1};
  stage.view = parallel ? parallelView(eye, target, 1, {0.1, 20})
                        : perspectiveView(eye, target, 60, {0.1, 20});
  stage.instances = {painted(mesh, {1, 1, 1})};
  return stage;
}

TEST_P(TransformVertices, VerticesLandWhereTheCameraSeesThem)
{
  int visible = 0;
  for (const bool parallel : {false, true})
    for (const bool precise : {false, true}) {
      const OwnedMesh mesh = cloud(3, 4, precise);
      const Stage stage = amidst(mesh, parallel);
      forEachVertex(stage, mesh, [&](Vec3d world, const auto&, const auto&, ScreenVertex vertex) {
        if (vertex.needsClip) return;
        const Vec3d expected = stage.project(world);
        // Half a subpixel of rounding, and 1/32 pixel where floats may do.
        const double tolerance = precise ? 0.51 : 8.5;
        ASSERT_NEAR(vertex.x, expected.x * kSubpixels, tolerance);
        ASSERT_NEAR(vertex.y, expected.y * kSubpixels, tolerance);
        ASSERT_NEAR(vertex.depth, expected.z, precise ? 1e-7 : 1e-4);
        ++visible;
      });
    }
  EXPECT_GT(visible, 4000);
}

TEST_P(TransformVertices, ANarrowViewIntoAWideMeshMissesByNoMoreThanAnotherView)
{
  // A telephoto view of a corner of the mesh: sums in float would miss by some 30 subpixels.
  const Vec3d target = {3, 2, -1};
  Random random(6);
  std::vector<Vec3d> points(300);
  for (Vec3d& p : points)
    p = random.inBox(4);
  for (int i = 0; i < 3000; ++i)
    points.push_back(target + random.inBox(1e-3));
  const OwnedMesh mesh = soup(points);
  Stage stage = amidst(mesh, false);
  stage.view = perspectiveView({0.3, 0.2, 4}, target, 0.02, {0.1, 20});
  int visible = 0;
  forEachVertex(stage, mesh, [&](Vec3d world, const auto&, const auto&, ScreenVertex vertex) {
    const Vec3d expected = stage.project(world);
    if (vertex.needsClip || std::fabs(expected.x - 320) > 640) return;
    ASSERT_NEAR(vertex.x, expected.x * kSubpixels, 8.5);
    ASSERT_NEAR(vertex.y, expected.y * kSubpixels, 8.5);
    ++visible;
  });
  EXPECT_GT(visible, 2000);
}

TEST_P(TransformVertices, NeedsClipIsSetExactlyBeforeTheNearPlaneAndBeyondTheGuardBand)
{
  const OwnedMesh mesh = cloud(4, 300, true);
  const Stage stage = amidst(mesh, false);
  const Vec3d back = axesOf(stage.view).back;
  int clipped = 0, kept = 0;
  forEachVertex(stage, mesh, [&](Vec3d world, const auto&, const auto&, ScreenVertex vertex) {
    const double distance = -dot(back, world - stage.view.eye);
    const Vec3d p = stage.project(world);
    const double outermost = std::max(std::fabs(p.x), std::fabs(p.y)) * kSubpixels;
    if (std::fabs(distance - 0.1) < 1e-6 || std::fabs(outermost - kGuardSubpixels) < 1) return;
    const bool expected = distance < 0.1 || outermost > kGuardSubpixels;
    ASSERT_EQ(vertex.needsClip, expected);
    ++(expected ? clipped : kept);
  });
  EXPECT_GT(clipped, 1000);
  EXPECT_GT(kept, 1000);
}

TEST_P(TransformVertices, TheKernelIsTheScalarFunctionToTheBit)
{
  for (const bool precise : {false, true}) {
    const OwnedMesh mesh = cloud(5, 30, precise);
    const Stage stage = amidst(mesh, false);
    forEachVertex(
        stage, mesh, [](Vec3d, const auto& transform, const auto& local, ScreenVertex vertex) {
          const ScreenVertex expected = screenVertex(transform, clipPoint(transform, local));
          ASSERT_EQ(vertex.needsClip, expected.needsClip);
          if (expected.needsClip) return;
          ASSERT_EQ(vertex.x, expected.x);
          ASSERT_EQ(vertex.y, expected.y);
          ASSERT_EQ(std::memcmp(&vertex.depth, &expected.depth, sizeof vertex.depth), 0);
          ASSERT_EQ(std::memcmp(&vertex.inverseW, &expected.inverseW, sizeof vertex.inverseW), 0);
        });
  }
}

}  // namespace
}  // namespace limn::testing
