// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normals of vertices by their three weights, and split where edges are sharp.
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace limn::testing {
namespace {

constexpr double kDegrees = 3.14159265358979323846 / 180;

/// The cube from -1 to 1, two triangles a side; cells are the sides.
OwnedMesh cube()
{
  OwnedMesh mesh;
  for (int v = 0; v < 8; ++v)
    mesh.positions.push_back({v & 1 ? 1.0f : -1.0f, v & 2 ? 1.0f : -1.0f, v & 4 ? 1.0f : -1.0f});
  mesh.triangles = {{{0, 2, 3}}, {{0, 3, 1}}, {{4, 5, 7}}, {{4, 7, 6}}, {{0, 1, 5}}, {{0, 5, 4}},
                    {{2, 6, 7}}, {{2, 7, 3}}, {{0, 4, 6}}, {{0, 6, 2}}, {{1, 3, 7}}, {{1, 7, 5}}};
  for (std::uint32_t t = 0; t < 12; ++t)
    mesh.cells.push_back(t / 2);
  mesh.cellCount = 6;
  return mesh;
}

/// Two unit squares that meet in the y axis, their normals `degrees` apart; two triangles each.
OwnedMesh roof(double degrees)
{
  const auto c = static_cast<float>(std::cos(degrees * kDegrees)),
             s = static_cast<float>(std::sin(degrees * kDegrees));
  OwnedMesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {c, 0, -s}, {-1, 1, 0}, {0, 1, 0}, {c, 1, -s}};
  mesh.triangles = {{{0, 1, 4}}, {{0, 4, 3}}, {{1, 2, 5}}, {{1, 5, 4}}};
  return mesh;
}

SplitNormals split(const OwnedMesh& mesh, double degrees, NormalWeight weight = NormalWeight::kArea,
                   int threads = 2)
{
  SplitNormals normals;
  const Status status =
      splitVertexNormals(mesh.view(), mesh.cells, weight, degrees, threads, normals);
  EXPECT_TRUE(status.ok()) << status.message;
  return normals;
}

void expectNear(Vec3f actual, Vec3d expected)
{
  EXPECT_NEAR(actual.x, expected.x, 1e-6);
  EXPECT_NEAR(actual.y, expected.y, 1e-6);
  EXPECT_NEAR(actual.z, expected.z, 1e-6);
}

TEST(VertexNormals, AngleOfIsTheArcTangent)
{
  for (int i = 0; i <= 1000; ++i) {
    const double angle = 3.14159265358979323846 * i / 1000;
    for (const double length : {1e-30, 1.0, 7e20})
      ASSERT_NEAR(angleOf(length * std::cos(angle), length * std::sin(angle)), angle, 1e-12);
  }
  EXPECT_EQ(angleOf(0, 0), 0);
}

TEST(VertexNormals, AngleWeightsDoNotSeeHowTheSidesOfACubeAreCut)
{
  const OwnedMesh mesh = cube();
  const auto normals = vertexNormals(mesh.view(), NormalWeight::kAngle);
  for (std::size_t v = 0; v < 8; ++v)
    expectNear(normals[v], normalized(vec3Cast<double>(mesh.positions[v])));
}

TEST(VertexNormals, UniformWeightsCountTriangles)
{
  // At vertex 1 the sides z, y and x have 1, 1 and 2 triangles.
  const auto normals = vertexNormals(cube().view(), NormalWeight::kUniform);
  expectNear(normals[1], normalized(Vec3d{2, -1, -1}));
}

TEST(VertexNormals, AreaWeightsCountAreas)
{
  OwnedMesh mesh = roof(90);
  mesh.positions[2].z = mesh.positions[5].z = -3;
  const auto normals = vertexNormals(mesh.view(), NormalWeight::kArea);
  // Half of the first square, all of the second, three times as large.
  expectNear(normals[1], normalized(Vec3d{6, 0, 1}));
}

TEST(VertexNormals, AFeatureAngleGivesACubeItsSidesNormals)
{
  const OwnedMesh mesh = cube();
  for (const NormalWeight weight :
       {NormalWeight::kUniform, NormalWeight::kArea, NormalWeight::kAngle}) {
    const SplitNormals normals = split(mesh, 30, weight);
    EXPECT_EQ(normals.normals.size(), 24u);
    for (std::size_t t = 0; t < 12; ++t) {
      const auto& v = mesh.triangles[t].vertex;
      const Vec3d a = vec3Cast<double>(mesh.positions[v[0]]);
      const Vec3d side = normalized(cross(vec3Cast<double>(mesh.positions[v[1]]) - a,
                                          vec3Cast<double>(mesh.positions[v[2]]) - a));
      for (std::size_t k = 0; k < 3; ++k)
        expectNear(normals.normals[normals.ofCorner[3 * t + k]], side);
    }
  }
}

TEST(VertexNormals, AnEdgeIsSplitAboveTheFeatureAngleOnly)
{
  const OwnedMesh mesh = roof(60);
  EXPECT_EQ(split(mesh, 59).normals.size(), 8u);
  const SplitNormals smooth = split(mesh, 61);
  EXPECT_EQ(smooth.normals.size(), 6u);
  const auto whole = vertexNormals(mesh.view(), NormalWeight::kArea);
  expectNear(smooth.normals[smooth.ofCorner[1]], vec3Cast<double>(whole[1]));
}

TEST(VertexNormals, AnEdgeAsSharpAsTheFeatureAngleIsSmooth)
{
  OwnedMesh mesh = cube();
  EXPECT_EQ(split(mesh, 90).normals.size(), 8u);
  EXPECT_EQ(split(mesh, 89.9).normals.size(), 24u);
}

TEST(VertexNormals, TheTrianglesOfACellStayTogether)
{
  OwnedMesh mesh = roof(60);
  mesh.cells = {0, 1, 2, 1};
  mesh.cellCount = 3;
  const SplitNormals normals = split(mesh, 10);
  // Vertex 4: triangle 1 and 3 are of one cell, but 1 joins 0 and 3 joins 2 as coplanar ones do.
  const auto at = [&](std::size_t t, std::size_t k) { return normals.ofCorner[3 * t + k]; };
  EXPECT_NE(at(0, 1), at(2, 0)) << "vertex 1 lies on the sharp edge";
  EXPECT_NE(at(1, 1), at(3, 2)) << "one cell, but no edge in common";
  mesh.cells = {0, 1, 2, 0};
  const SplitNormals joined = split(mesh, 10);
  EXPECT_EQ(joined.ofCorner[1], joined.ofCorner[9]) << "one cell, with the edge in common";
}

TEST(VertexNormals, WithoutSharpEdgesNothingIsSplit)
{
  const OwnedMesh mesh = sphere(24, 31);
  const auto whole = vertexNormals(mesh.view(), NormalWeight::kAngle);
  const SplitNormals normals = split(mesh, 180, NormalWeight::kAngle);
  ASSERT_EQ(normals.ofCorner.size(), 3 * mesh.triangles.size());
  for (std::size_t corner = 0; corner < normals.ofCorner.size(); ++corner) {
    const Vec3f a = normals.normals[normals.ofCorner[corner]];
    const Vec3f b = whole[mesh.triangles[corner / 3].vertex[corner % 3]];
    ASSERT_TRUE(a == b) << corner;
  }
}

TEST(VertexNormals, TheBytesDoNotDependOnThreads)
{
  const OwnedMesh mesh = sphere(120, 200);
  const SplitNormals one = split(mesh, 2, NormalWeight::kAngle, 1);
  for (const int threads : {2, 3, 8}) {
    const SplitNormals many = split(mesh, 2, NormalWeight::kAngle, threads);
    EXPECT_EQ(many.ofCorner, one.ofCorner);
    ASSERT_EQ(many.normals.size(), one.normals.size());
    for (std::size_t i = 0; i < one.normals.size(); ++i)
      ASSERT_TRUE(many.normals[i] == one.normals[i]) << i;
  }
}

TEST(VertexNormals, BrokenTrianglesDoNotCount)
{
  OwnedMesh mesh = roof(60);
  const auto expected = vertexNormals(mesh.view(), NormalWeight::kAngle);
  mesh.positions.push_back({NAN, 0, 0});
  mesh.triangles.push_back({{0, 1, 77}});
  mesh.triangles.push_back({{0, 1, 6}});
  mesh.triangles.push_back({{1, 1, 4}});
  for (const NormalWeight weight :
       {NormalWeight::kUniform, NormalWeight::kArea, NormalWeight::kAngle}) {
    const auto whole = vertexNormals(mesh.view(), weight);
    const auto sound = vertexNormals(roof(60).view(), weight);
    for (std::size_t v = 0; v < 6; ++v)
      EXPECT_TRUE(whole[v] == sound[v]) << v;
    EXPECT_TRUE(whole[6] == (Vec3f{0, 0, 0}));
    const SplitNormals parts = split(mesh, 59, weight);
    ASSERT_EQ(parts.ofCorner.size(), 21u);
    for (const std::uint32_t normal : parts.ofCorner)
      EXPECT_LT(normal, parts.normals.size());
    const SplitNormals soundParts = split(roof(60), 59, weight);
    for (std::size_t corner = 0; corner < 12; ++corner)
      EXPECT_TRUE(parts.normals[parts.ofCorner[corner]] ==
                  soundParts.normals[soundParts.ofCorner[corner]])
          << corner;
  }
  SplitNormals none;
  EXPECT_TRUE(splitVertexNormals({}, {}, NormalWeight::kArea, 30, 2, none).ok());
  EXPECT_TRUE(none.ofCorner.empty());
}

}  // namespace
}  // namespace limn::testing
