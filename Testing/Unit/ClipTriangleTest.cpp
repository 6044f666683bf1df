// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ClipTriangle.h"

#include "Testing/Unit/TestScene.h"

#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace limn::testing {
namespace {

InstanceTransform transformOf(bool precise)
{
  Stage stage;
  stage.width = 640;
  stage.height = 480;
  stage.view = perspectiveView({0, 0, 0}, {0, 0, -1}, 60, {0.1, 20});
  const LocalFrame frame = {{0, 0, 0}, {-1, -1, -1}, {1, 1, 1}, precise};
  return makeInstanceTransform(stage.camera(), Mat4d::identity(), frame, stage.width, stage.height);
}

using Corners = std::array<Vec3f, 3>;

struct Clipped {
  ClipPoint clip[3];
  bool needed = false;
  ClippedTriangle polygon;
};
Clipped clipped(const InstanceTransform& transform, const Corners& corners)
{
  Clipped result;
  ScreenVertex screen[3];
  for (std::size_t i = 0; i < 3; ++i) {
    result.clip[i] = clipPoint(transform, {corners[i], {0, 0, 0}});
    screen[i] = screenVertex(transform, result.clip[i]);
    result.needed = result.needed || screen[i].needsClip;
  }
  if (result.needed) result.polygon = clipTriangle(transform, result.clip, screen);
  return result;
}

/// Corners near and far, before and behind the eye, so that every plane cuts now and then.
Vec3f cornerOf(Random& random)
{
  const double half = random.chance(3) ? 2000 : 2;
  return vec3Cast<float>(random.inBox(half));
}

TEST(ClipTriangle, WeightsAreMixturesAndReproduceThePositions)
{
  for (const bool precise : {false, true}) {
    const InstanceTransform transform = transformOf(precise);
    Random random(11);
    int vertices = 0;
    for (int i = 0; i < 20000; ++i) {
      const Clipped c = clipped(transform, {cornerOf(random), cornerOf(random), cornerOf(random)});
      if (!c.needed) continue;
      for (int v = 0; v < c.polygon.count; ++v) {
        const double(&weight)[3] = c.polygon.weight[v];
        ASSERT_NEAR(weight[0] + weight[1] + weight[2], 1, 1e-9);
        Vec3d xyw = {0, 0, 0};
        double z = 0;
        for (int k = 0; k < 3; ++k) {
          ASSERT_GE(weight[k], -1e-9);
          xyw = xyw + Vec3d{c.clip[k].x, c.clip[k].y, c.clip[k].w} * weight[k];
          z += c.clip[k].z * weight[k];
        }
        const ScreenVertex& vertex = c.polygon.vertex[v];
        // Rounding to a subpixel, in float where the transform is: 2^23 has steps of 1/2 there.
        const double tolerance = precise ? 0.6 : 1.1;
        ASSERT_NEAR(vertex.x, (xyw.x / xyw.z + 1) * transform.subpixelsX, tolerance);
        ASSERT_NEAR(vertex.y, (xyw.y / xyw.z + 1) * transform.subpixelsY, tolerance);
        ASSERT_NEAR(vertex.depth, z / xyw.z * 0.5 + 0.5, 2e-6);
        ASSERT_NEAR(vertex.inverseW * xyw.z, 1, 1e-5);
        ++vertices;
      }
    }
    EXPECT_GT(vertices, 10000);
  }
}

TEST(ClipTriangle, WhatIsLeftLiesBehindTheNearPlaneAndInsideTheGuardBand)
{
  const InstanceTransform transform = transformOf(true);
  Random random(12);
  int cut = 0;
  for (int i = 0; i < 20000; ++i) {
    const Clipped c = clipped(transform, {cornerOf(random), cornerOf(random), cornerOf(random)});
    if (!c.needed) continue;
    ASSERT_TRUE(c.polygon.count == 0 ||
                (c.polygon.count >= 3 && c.polygon.count <= ClippedTriangle::kMaxVertices));
    for (int v = 0; v < c.polygon.count; ++v) {
      const ScreenVertex& vertex = c.polygon.vertex[v];
      ASSERT_FALSE(vertex.needsClip);
      ASSERT_LE(std::abs(vertex.x), kGuardSubpixels);
      ASSERT_LE(std::abs(vertex.y), kGuardSubpixels);
      ASSERT_GE(vertex.depth, -1e-6f);
    }
    cut += c.polygon.count > 0;
  }
  EXPECT_GT(cut, 5000);
}

using Bits = std::tuple<std::int32_t, std::int32_t, float, float>;

/// New vertices on the edge between corners 0 and 1: those to which corner 2 adds nothing.
std::set<Bits> cutsOnFirstEdge(const Clipped& c)
{
  std::set<Bits> cuts;
  for (int v = 0; v < c.polygon.count; ++v) {
    const double(&weight)[3] = c.polygon.weight[v];
    if (weight[2] != 0 || weight[0] == 0 || weight[1] == 0) continue;
    const ScreenVertex& vertex = c.polygon.vertex[v];
    cuts.insert({vertex.x, vertex.y, vertex.depth, vertex.inverseW});
  }
  return cuts;
}

TEST(ClipTriangle, NeighboursGetTheSameNewVerticesOnTheirCommonEdge)
{
  for (const bool precise : {false, true}) {
    const InstanceTransform transform = transformOf(precise);
    Random random(13);
    std::size_t cuts = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3f a = cornerOf(random), b = cornerOf(random);
      const Clipped left = clipped(transform, {a, b, cornerOf(random)});
      const Clipped right = clipped(transform, {b, a, cornerOf(random)});
      if (!left.needed || !right.needed) continue;
      const auto ofLeft = cutsOnFirstEdge(left), ofRight = cutsOnFirstEdge(right);
      ASSERT_EQ(ofLeft, ofRight) << "triangle " << i;
      cuts += ofLeft.size();
    }
    EXPECT_GT(cuts, 5000u);
  }
}

TEST(ClipTriangle, NothingIsLeftOfATriangleBehindTheEye)
{
  const InstanceTransform transform = transformOf(false);
  EXPECT_EQ(clipped(transform, {Vec3f{0, 0, 1}, Vec3f{1, 0, 2}, Vec3f{0, 1, 3}}).polygon.count, 0);
}

TEST(ClipTriangle, OneCornerBehindTheNearPlaneLeavesAQuadWithItsCutsOnThePlane)
{
  const InstanceTransform transform = transformOf(true);
  // Corner 0 lies at the eye's depth + 0.1 behind: the near plane at -0.1 cuts at equal shares.
  const Clipped c = clipped(transform, {Vec3f{0, 0, 0.8f}, Vec3f{-1, 0, -1}, Vec3f{1, 0.5f, -1}});
  ASSERT_EQ(c.polygon.count, 4);
  int onPlane = 0;
  for (int v = 0; v < 4; ++v) {
    const double(&weight)[3] = c.polygon.weight[v];
    if (weight[0] == 0) continue;
    // 0.8 w - (1 - w) = -0.1: w = 0.5, up to 0.8f.
    EXPECT_NEAR(weight[0], 0.5, 1e-7);
    EXPECT_NEAR(c.polygon.vertex[v].depth, 0, 1e-7);
    EXPECT_NEAR(c.polygon.vertex[v].inverseW, 10, 1e-5);
    ++onPlane;
  }
  EXPECT_EQ(onPlane, 2);
}

}  // namespace
}  // namespace limn::testing
