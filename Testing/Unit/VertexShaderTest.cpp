// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that move vertices before they are placed.
#include "Rendering/Mesh/MoveVertices.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Testing/Unit/TestScene.h"

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace limn::testing {
namespace {

class VertexShaders : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(VertexShaders);

/// One vertex after the other.
template <class Move>
class PointwiseShader final : public VertexShader {
 public:
  explicit PointwiseShader(Move move) : move_(move) {}
  void move(VertexBatch& vertices) const override
  {
    for (int i = 0; i < vertices.count; ++i) {
      const Vec3d p = move_(vertices.first + static_cast<std::uint32_t>(i),
                            Vec3d{vertices.x[i], vertices.y[i], vertices.z[i]});
      vertices.x[i] = p.x;
      vertices.y[i] = p.y;
      vertices.z[i] = p.z;
    }
  }

 private:
  Move move_;
};

/// A quarter turn about z, of normals too.
class QuarterTurn final : public VertexShader {
 public:
  void move(VertexBatch& v) const override
  {
    for (int i = 0; i < v.count; ++i) {
      const double x = v.x[i];
      v.x[i] = -v.y[i];
      v.y[i] = x;
      const float normalX = v.normalX[i];
      v.normalX[i] = -v.normalY[i];
      v.normalY[i] = normalX;
    }
  }
  bool movesNormals() const override { return true; }
};

Vec3d rippled(Vec3d p)
{
  return {p.x, p.y, p.z + 0.3 * p.x * p.x - 0.2 * p.y / (1 + p.x * p.x)};
}

/// What a host makes of a mesh and its shader.
void takeOver(const MovedVertices& moved, OwnedMesh& mesh)
{
  mesh.positions = moved.positions;
  mesh.precise = moved.precisePositions;
  mesh.vertexNormals =
      moved.normals.empty() ? vertexNormals(mesh.view(), NormalWeight::kArea) : moved.normals;
  if (refitClusters(mesh.view(), 2, mesh.clusters)) return;
  ASSERT_TRUE(buildClusters(mesh.view(), 2, mesh.clusters).ok());
}

TEST_P(VertexShaders, DrawAsAMeshGivenWithThosePositions)
{
  const PointwiseShader shader([](std::uint32_t, Vec3d p) { return rippled(p); });
  for (const bool precise : {false, true}) {
    OwnedMesh mesh = sphere(40, 60);
    OwnedMesh given = sphere(40, 60);
    if (precise) {
      for (OwnedMesh* one : {&mesh, &given}) {
        for (const Vec3f p : one->positions)
          one->precise.push_back(vec3Cast<double>(p));
        one->positions.clear();
        finish(*one);
      }
    }
    for (Vec3f& p : given.positions)
      p = vec3Cast<float>(rippled(vec3Cast<double>(p)));
    for (Vec3d& p : given.precise)
      p = rippled(p);
    given.vertexNormals = vertexNormals(given.view(), NormalWeight::kArea);
    finish(given);

    MovedVertices moved;
    moveVertices(shader, mesh.view(), mesh.vertexNormals, 2, moved);
    takeOver(moved, mesh);
    Stage stage;
    stage.samples = 4;
    stage.lights = {Light{}};
    stage.instances = {instanceOf(mesh)};
    const Picture actual = draw(stage);
    stage.instances = {instanceOf(given)};
    EXPECT_EQ(actual.differingPixels(draw(stage)), 0u);
    EXPECT_TRUE(covered(actual, 48, 48));
  }
}

TEST_P(VertexShaders, AHalfSphereSizeDoubledIsTheUnitSphere)
{
  OwnedMesh mesh = sphere(128, 256);
  for (Vec3f& p : mesh.positions)
    p = p * 0.5f;
  finish(mesh);
  const PointwiseShader shader([](std::uint32_t, Vec3d p) { return p * 2.0; });
  MovedVertices moved;
  moveVertices(shader, mesh.view(), mesh.vertexNormals, 2, moved);
  EXPECT_TRUE(moved.normals.empty());
  takeOver(moved, mesh);
  Stage stage;
  // From the side: at the poles the cuts of the quads weigh on the normals.
  stage.view.eye = {3, 0, 0};
  stage.instances = {instanceOf(mesh)};
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-3, -1, -2};
  stage.lights = {light};
  const Vec3d l = normalized(Vec3d{3, 1, 2});
  const auto lit = [&](const Hit& hit) {
    const double nl = std::max(0.0, dot(hit.normal, l));
    return Vec3d{nl, nl, nl};
  };
  // Normals by area are off by as much as facets are, once more.
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

TEST_P(VertexShaders, NormalsTurnWithTheShaderThatTurnsThem)
{
  OwnedMesh mesh = sphere(128, 256);
  // As if lit from +x all over.
  mesh.vertexNormals.assign(mesh.positions.size(), Vec3f{1, 0, 0});
  MovedVertices moved;
  moveVertices(QuarterTurn(), mesh.view(), mesh.vertexNormals, 2, moved);
  takeOver(moved, mesh);
  Stage stage;
  stage.instances = {instanceOf(mesh)};
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {0, -1, 0};
  stage.lights = {light};
  const auto lit = [](const Hit&) { return Vec3d{1, 1, 1}; };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding);
}

TEST_P(VertexShaders, TrianglesOfLostVerticesAreLeftOut)
{
  OwnedMesh mesh = sheet({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 4);
  const PointwiseShader shader([](std::uint32_t number, Vec3d p) {
    return number == 12 ? Vec3d{std::numeric_limits<double>::quiet_NaN(), p.y, p.z} : p;
  });
  MovedVertices moved;
  moveVertices(shader, mesh.view(), {}, 2, moved);
  EXPECT_EQ(moved.lostVertices, 1u);
  EXPECT_EQ(moved.firstLost, 12u);
  takeOver(moved, mesh);
  EXPECT_EQ(mesh.clusters.notFiniteTriangles, 6u);
  Stage stage;
  stage.instances = {painted(mesh, {1, 1, 1})};
  const Picture picture = draw(stage);
  EXPECT_FALSE(covered(picture, 48, 48));
  EXPECT_TRUE(covered(picture, 5, 5));
}

TEST(MoveVertices, MovesEachVertexOnceByItsOwnNumber)
{
  for (const std::size_t count : {std::size_t{1}, std::size_t{255}, std::size_t{256},
                                  std::size_t{257}, std::size_t{100003}}) {
    std::vector<Vec3f> positions(count, Vec3f{1, 2, 3});
    const MeshView mesh = {positions, {}, {}};
    std::vector<std::atomic<int>> calls(count);
    const PointwiseShader shader([&](std::uint32_t number, Vec3d p) {
      ++calls[number];
      return p + Vec3d{static_cast<double>(number), 0, 0};
    });
    MovedVertices moved;
    moveVertices(shader, mesh, {}, 3, moved);
    ASSERT_EQ(moved.positions.size(), count);
    EXPECT_TRUE(moved.precisePositions.empty());
    for (std::size_t v = 0; v < count; ++v) {
      ASSERT_EQ(calls[v], 1);
      ASSERT_TRUE((moved.positions[v] == Vec3f{1 + static_cast<float>(v), 2, 3}));
    }
  }
}

TEST(MoveVertices, DoesNotDependOnTheNumberOfThreads)
{
  const OwnedMesh& mesh = fineSphere();
  const PointwiseShader shader([](std::uint32_t, Vec3d p) { return rippled(p); });
  MovedVertices one;
  moveVertices(shader, mesh.view(), mesh.vertexNormals, 1, one);
  for (const int threads : {2, 3, 8}) {
    MovedVertices several;
    moveVertices(shader, mesh.view(), mesh.vertexNormals, threads, several);
    ASSERT_EQ(several.positions.size(), one.positions.size());
    EXPECT_EQ(std::memcmp(several.positions.data(), one.positions.data(),
                          one.positions.size() * sizeof(Vec3f)),
              0);
  }
}

TEST(MoveVertices, KeepsWhatOnlyADoubleHolds)
{
  const std::vector<Vec3d> positions = {{1e7 + 0.125, 0, 0}};
  const PointwiseShader shader([](std::uint32_t, Vec3d p) { return p + Vec3d{0.0625, 1e39, 0}; });
  MovedVertices moved;
  moveVertices(shader, {{}, positions, {}}, {}, 1, moved);
  EXPECT_TRUE((moved.precisePositions[0] == Vec3d{1e7 + 0.1875, 1e39, 0}));
  EXPECT_EQ(moved.lostVertices, 0u);
}

TEST(MoveVertices, CountsVerticesBeyondAFloatAsLost)
{
  const std::vector<Vec3f> positions(100000, Vec3f{0, 0, 0});
  const PointwiseShader shader([](std::uint32_t number, Vec3d p) {
    return number % 30000 == 29999 ? Vec3d{p.x, 1e39, p.z} : p;
  });
  MovedVertices moved;
  moveVertices(shader, {positions, {}, {}}, {}, 2, moved);
  EXPECT_EQ(moved.lostVertices, 3u);
  EXPECT_EQ(moved.firstLost, 29999u);
}

TEST(MoveVertices, VerticesThatWereNotFiniteAreNotLost)
{
  const std::vector<Vec3f> positions = {{0, 0, 0}, {std::numeric_limits<float>::infinity(), 0, 0}};
  const PointwiseShader shader([](std::uint32_t, Vec3d p) { return p; });
  MovedVertices moved;
  moveVertices(shader, {positions, {}, {}}, {}, 2, moved);
  EXPECT_EQ(moved.lostVertices, 0u);
}

}  // namespace
}  // namespace limn::testing
