// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/BuildClusters.h"

#include "Data/Generator/GeneratedMeshes.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3d> precise;
  std::vector<Triangle> triangles;

  MeshView view() const { return {positions, precise, triangles}; }
};

Mesh meshOf(const GeneratedMesh& generated)
{
  return {generated.positions, {}, generated.triangles()};
}

ClusteredMesh clustersOf(const Mesh& mesh, int threads = 0)
{
  ClusteredMesh clusters;
  const Status status = buildClusters(mesh.view(), threads, clusters);
  EXPECT_TRUE(status.ok()) << status.message;
  return clusters;
}

/// Checks every promise of ClusteredMesh.h, and returns how often each triangle was found.
std::vector<int> checkedTriangleCounts(const Mesh& mesh, const ClusteredMesh& clusters)
{
  std::vector<int> counts(mesh.triangles.size(), 0);
  for (const Cluster& cluster : clusters.clusters) {
    EXPECT_TRUE(cluster.vertexCount >= 1 && cluster.vertexCount <= kMaxClusterVertices);
    EXPECT_TRUE(cluster.triangleCount >= 1 && cluster.triangleCount <= kMaxClusterTriangles);
    for (std::size_t v = cluster.firstVertex; v < cluster.firstVertex + cluster.vertexCount; ++v) {
      const LocalPosition expected =
          toLocal(mesh.view().position(clusters.vertex[v]), clusters.origin);
      EXPECT_EQ(clusters.x[v], expected.high.x);
      EXPECT_EQ(clusters.y[v], expected.high.y);
      EXPECT_EQ(clusters.z[v], expected.high.z);
      EXPECT_TRUE(clusters.x[v] >= cluster.low.x && clusters.x[v] <= cluster.high.x);
      EXPECT_TRUE(clusters.y[v] >= cluster.low.y && clusters.y[v] <= cluster.high.y);
      EXPECT_TRUE(clusters.z[v] >= cluster.low.z && clusters.z[v] <= cluster.high.z);
    }
    for (std::size_t t = cluster.firstTriangle; t < cluster.firstTriangle + cluster.triangleCount;
         ++t) {
      ++counts[clusters.triangle[t]];
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(clusters.vertex[cluster.firstVertex + clusters.corner[k][t]],
                  mesh.triangles[clusters.triangle[t]].vertex[k]);
    }
  }
  return counts;
}

void expectEachTriangleOnce(const Mesh& mesh)
{
  const ClusteredMesh clusters = clustersOf(mesh);
  const std::vector<int> counts = checkedTriangleCounts(mesh, clusters);
  EXPECT_EQ(std::count(counts.begin(), counts.end(), 1),
            static_cast<std::ptrdiff_t>(mesh.triangles.size()));
  EXPECT_EQ(clusters.triangleCount, mesh.triangles.size());
  EXPECT_EQ(clusters.meshVertexCount, mesh.view().vertexCount());
  EXPECT_EQ(clusters.meshTriangleCount, mesh.triangles.size());
}

TEST(BuildClusters, HoldEachTriangleOfAClosedMeshOnce)
{
  expectEachTriangleOnce(meshOf(torus(200, 150, 1, 0.4)));
}

TEST(BuildClusters, HoldEachTriangleOfSoupOnce)
{
  Mesh soup;
  for (std::uint32_t i = 0; i < 900; ++i) {
    const float x = static_cast<float>(i % 31), y = static_cast<float>(i / 31);
    soup.positions.push_back({x, y, static_cast<float>(i % 3)});
    if (i % 3 == 2) soup.triangles.push_back({{i - 2, i - 1, i}});
  }
  expectEachTriangleOnce(soup);
}

TEST(BuildClusters, HoldEachTriangleOnceOfStripsMetByOthers)
{
  // All but the last vertices lie in one cell of the curve: quadrilaterals, of which some lack
  // their second half, and triangles that cannot be drawn, in every order.
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Mesh strip;
  std::vector<int> expected;
  const auto add = [&](Triangle triangle, int times) {
    strip.triangles.push_back(triangle);
    expected.push_back(times);
  };
  std::uint32_t random = 1;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const float x = 1e-3f * static_cast<float>(i);
    strip.positions.push_back({x, 0, 0});
    strip.positions.push_back({x, 1e-3f, 0});
    random = random * 1664525u + 1013904223u;
    const std::uint32_t kind = random >> 29;
    add({{2 * i, 2 * i + 2, 2 * i + 1}}, 1);
    if (kind == 0) add({{0, 6002, 1}}, 0);
    if (kind != 1) add({{2 * i + 1, 2 * i + 2, 2 * i + 3}}, 1);
    if (kind == 2) add({{0, 9000, 1}}, 0);
  }
  strip.positions.insert(strip.positions.end(),
                         {{3, 0, 0}, {3, 1e-3f, 0}, {0, kInfinity, 0}, {1000, 1000, 1000}});
  EXPECT_EQ(checkedTriangleCounts(strip, clustersOf(strip)), expected);
}

TEST(BuildClusters, KeepDegenerateTriangles)
{
  expectEachTriangleOnce({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}, {{{0, 1, 2}}, {{1, 1, 1}}}});
}

TEST(BuildClusters, KeepOnlyNeighboursTogether)
{
  // Triangles of two far clouds, in turn.
  Mesh clouds;
  for (std::uint32_t t = 0; t < 2000; ++t) {
    const float x = t % 2 == 0 ? 0.0f : 1000.0f, y = static_cast<float>(t / 2 % 32),
                z = static_cast<float>(t / 64);
    clouds.positions.insert(clouds.positions.end(), {{x, y, z}, {x + 1, y, z}, {x, y + 1, z}});
    clouds.triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
  }
  const ClusteredMesh clusters = clustersOf(clouds);
  const auto spansBoth = [](const Cluster& c) { return c.high.x - c.low.x > 500; };
  EXPECT_LE(std::count_if(clusters.clusters.begin(), clusters.clusters.end(), spansBoth), 2);
}

TEST(BuildClusters, AreWellFilledOnAGrid)
{
  const ClusteredMesh clusters = clustersOf(meshOf(torus(300, 300, 1, 0.4)));
  const double fill =
      static_cast<double>(clusters.triangleCount) / static_cast<double>(clusters.clusters.size());
  EXPECT_GT(fill, 72.0);
  const double bytes =
      static_cast<double>(clusters.bytes()) / static_cast<double>(clusters.triangleCount);
  EXPECT_LT(bytes, 20.0);
}

TEST(BuildClusters, AreAboutAsWideAsHighOnAPlane)
{
  constexpr std::uint32_t kSide = 250;
  Mesh grid;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    grid.positions.push_back(
        {1.5f * static_cast<float>(i % kSide), static_cast<float>(i / kSide), 0});
  for (std::uint32_t i = 0; i + kSide + 1 < kSide * kSide; ++i) {
    if (i % kSide == kSide - 1) continue;
    grid.triangles.push_back({{i, i + 1, i + kSide + 1}});
    grid.triangles.push_back({{i, i + kSide + 1, i + kSide}});
  }
  const ClusteredMesh clusters = clustersOf(grid);
  double side = 0;
  for (const Cluster& c : clusters.clusters)
    side += static_cast<double>((c.high.x - c.low.x) + (c.high.y - c.low.y)) / 2;
  side /= static_cast<double>(clusters.clusters.size());
  const double area =
      1.5 * (kSide - 1) * (kSide - 1) / static_cast<double>(clusters.clusters.size());
  EXPECT_LT(side, 1.25 * std::sqrt(area));
}

TEST(BuildClusters, DoNotDependOnTheThreads)
{
  const Mesh mesh = meshOf(torus(400, 300, 1, 0.4));
  const ClusteredMesh one = clustersOf(mesh, 1);
  for (const int threads : {2, 3, 8}) {
    const ClusteredMesh many = clustersOf(mesh, threads);
    EXPECT_EQ(many.triangle, one.triangle);
    EXPECT_EQ(many.vertex, one.vertex);
    EXPECT_EQ(many.x, one.x);
  }
}

TEST(BuildClusters, DoNotDependOnTheThreadsWhereSomeVerticesAreNotToBeHad)
{
  // Far out, and a triangle that is not finite asks what the others use.
  Mesh mesh;
  for (const Vec3f& p : meshOf(torus(400, 300, 1, 0.4)).positions)
    mesh.precise.push_back(Vec3d{1e6, 2e6, -3e6} + vec3Cast<double>(p));
  mesh.triangles = meshOf(torus(400, 300, 1, 0.4)).triangles;
  const ClusteredMesh whole = clustersOf(mesh, 1);
  mesh.precise.push_back({std::nan(""), 0, 0});
  mesh.precise.push_back({0, 0, 0});
  mesh.triangles.push_back({{0, 1, static_cast<std::uint32_t>(mesh.precise.size() - 2)}});
  for (const int threads : {1, 2, 3, 8}) {
    const ClusteredMesh many = clustersOf(mesh, threads);
    EXPECT_TRUE(many.origin == whole.origin);
    EXPECT_EQ(many.notFiniteTriangles, 1u);
    EXPECT_EQ(many.triangle, whole.triangle);
    EXPECT_EQ(many.x, whole.x);
    EXPECT_EQ(many.xLow, whole.xLow);
  }
}

TEST(BuildClusters, AreAsGoodBesideAPointThatNoTriangleUses)
{
  Mesh mesh = meshOf(torus(90, 70, 1, 0.4));
  const ClusteredMesh alone = clustersOf(mesh, 1);
  mesh.positions.push_back({1e9f, 0, 0});
  const ClusteredMesh beside = clustersOf(mesh, 1);
  EXPECT_EQ(beside.triangle, alone.triangle);
  EXPECT_EQ(beside.builtExtent, alone.builtExtent);
}

TEST(BuildClusters, LeaveOutAndCountWhatCannotBeDrawn)
{
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {kInfinity, 0, 0}, {0, std::nanf(""), 0}},
                     {},
                     {{{0, 1, 2}}, {{0, 1, 5}}, {{0, 1, 3}}, {{4, 1, 2}}, {{2, 1, 0}}}};
  const ClusteredMesh clusters = clustersOf(mesh);
  EXPECT_EQ(clusters.outOfRangeTriangles, 1u);
  EXPECT_EQ(clusters.notFiniteTriangles, 2u);
  EXPECT_EQ(checkedTriangleCounts(mesh, clusters), (std::vector<int>{1, 0, 0, 0, 1}));
}

TEST(BuildClusters, OfNothingAreNone)
{
  const ClusteredMesh clusters = clustersOf({});
  EXPECT_TRUE(clusters.clusters.empty());
  EXPECT_EQ(clusters.triangleCount, 0u);
}

TEST(BuildClusters, KeepMillimetresTenThousandKilometresOut)
{
  Mesh mesh;
  for (std::uint32_t i = 0; i < 300; ++i)
    mesh.precise.push_back({1e7 + 1.1e-3 * i, -1e7 + 1.3e-3 * (i % 17), 1e7 / 3 + 1e-3 * (i % 5)});
  for (std::uint32_t i = 0; i + 2 < 300; ++i)
    mesh.triangles.push_back({{i, i + 1, i + 2}});
  const ClusteredMesh clusters = clustersOf(mesh);
  ASSERT_TRUE(clusters.hasLowParts());
  for (std::size_t v = 0; v < clusters.vertexCount; ++v) {
    const Vec3d p = mesh.precise[clusters.vertex[v]] - clusters.origin;
    EXPECT_NEAR(static_cast<double>(clusters.x[v]) + clusters.xLow[v], p.x, 1e-9);
    EXPECT_NEAR(static_cast<double>(clusters.y[v]) + clusters.yLow[v], p.y, 1e-9);
    EXPECT_NEAR(static_cast<double>(clusters.z[v]) + clusters.zLow[v], p.z, 1e-9);
  }
}

void expectEqual(const ClusteredMesh& a, const ClusteredMesh& b)
{
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
  EXPECT_EQ(a.xLow, b.xLow);
  EXPECT_EQ(a.yLow, b.yLow);
  EXPECT_EQ(a.zLow, b.zLow);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
}

/// Draws each vertex somewhere else, the neighbours to neighbouring places.
Mesh bent(const Mesh& mesh, double far)
{
  Mesh moved;
  moved.triangles = mesh.triangles;
  for (std::size_t v = 0; v < mesh.view().vertexCount(); ++v) {
    const Vec3d p = mesh.view().position(v);
    moved.precise.push_back({far + p.x + 0.2 * std::sin(3 * p.y), p.y * 1.7, p.z - far});
  }
  return moved;
}

TEST(RefitClusters, HoldTheNewPositionsAsIfBuiltOfThem)
{
  const Mesh mesh = meshOf(torus(90, 70, 1, 0.4));
  for (const double far : {0.0, 1e6}) {
    const Mesh moved = bent(mesh, far);
    for (const int threads : {1, 3}) {
      ClusteredMesh clusters = clustersOf(mesh);
      ASSERT_TRUE(refitClusters(moved.view(), threads, clusters));
      checkedTriangleCounts(moved, clusters);
      EXPECT_TRUE(clusters.hasLowParts());
      // There and back again.
      ASSERT_TRUE(refitClusters(mesh.view(), threads, clusters));
      expectEqual(clusters, clustersOf(mesh));
    }
  }
}

TEST(RefitClusters, RefuseWhatHasToBeBuilt)
{
  const Mesh mesh = meshOf(torus(90, 70, 1, 0.4));
  Mesh broken = mesh;
  broken.positions[77].y = std::numeric_limits<float>::quiet_NaN();
  ClusteredMesh clusters = clustersOf(mesh);
  EXPECT_FALSE(refitClusters(broken.view(), 0, clusters));
  clusters = clustersOf(broken);
  EXPECT_FALSE(refitClusters(mesh.view(), 0, clusters)) << "triangles left out come back";

  Mesh precise = mesh;
  for (const Vec3f& p : mesh.positions)
    precise.precise.push_back(vec3Cast<double>(p));
  precise.positions.clear();
  clusters = clustersOf(precise);
  const std::uint32_t second = clusters.vertex[clusters.clusters[0].firstVertex + 1];
  precise.precise[second].x = 1e39;
  EXPECT_FALSE(refitClusters(precise.view(), 0, clusters)) << "beyond a float's range";

  Mesh shuffled = mesh;
  for (std::size_t v = 0; v < shuffled.positions.size(); ++v)
    shuffled.positions[v] = mesh.positions[v * 2741 % mesh.positions.size()];
  clusters = clustersOf(mesh);
  EXPECT_FALSE(refitClusters(shuffled.view(), 0, clusters)) << "the clusters have come apart";
}

TEST(RefitClusters, TellWhetherAnyVertexHasMoved)
{
  const Mesh mesh = meshOf(torus(90, 70, 1, 0.4));
  const ClusteredMesh clusters = clustersOf(mesh);
  for (const int threads : {1, 3}) {
    EXPECT_TRUE(areInPlace(mesh.view(), threads, clusters));
    for (const std::size_t v : {std::size_t{0}, mesh.positions.size() - 1}) {
      Mesh moved = mesh;
      moved.positions[v].z = std::nextafter(moved.positions[v].z, 9.0f);
      EXPECT_FALSE(areInPlace(moved.view(), threads, clusters)) << v;
    }
  }
  Mesh broken = mesh;
  broken.positions[77].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(areInPlace(broken.view(), 1, clusters));
  EXPECT_FALSE(areInPlace(mesh.view(), 1, clustersOf(broken))) << "it may be finite now";
  const Mesh far = bent(mesh, 1e6);
  EXPECT_FALSE(areInPlace(far.view(), 1, clustersOf(far))) << "the clusters do not tell";
}

TEST(BuildClusters, TellDisorder)
{
  const Mesh mesh = meshOf(torus(200, 150, 1, 0.4));
  EXPECT_FALSE(areInDisorder(clustersOf(mesh)));
  Mesh shuffled = mesh;
  for (std::size_t v = 0; v < shuffled.positions.size(); ++v)
    shuffled.positions[v] = mesh.positions[v * 2741 % mesh.positions.size()];
  EXPECT_TRUE(areInDisorder(clustersOf(shuffled)));
}

}  // namespace
}  // namespace limn
