// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data/Generator, and with its meshes the normals and faces that Rendering/Mesh computes.
#include "Data/Generator/GeneratedMeshes.h"

#include "Rendering/Mesh/FaceGeometry.h"
#include "Rendering/Mesh/VertexNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace limn {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, int> directedEdges(const GeneratedMesh& mesh)
{
  std::map<Edge, int> edges;
  for (const auto& polygon : mesh.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++edges[{polygon[i], polygon[(i + 1) % polygon.size()]}];
  return edges;
}

void expectClosed(const GeneratedMesh& mesh, long eulerCharacteristic)
{
  const auto edges = directedEdges(mesh);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(static_cast<long>(mesh.positions.size()) - static_cast<long>(edges.size() / 2) +
                static_cast<long>(mesh.polygons.size()),
            eulerCharacteristic);
}

double volume(const GeneratedMesh& mesh)
{
  double sum = 0;
  for (const Triangle& t : mesh.triangles())
    sum += dot(vec3Cast<double>(mesh.positions[t.vertex[0]]),
               cross(vec3Cast<double>(mesh.positions[t.vertex[1]]),
                     vec3Cast<double>(mesh.positions[t.vertex[2]]))) /
           6;
  return sum;
}

void expectNormalsAgreeWithFaces(const GeneratedMesh& mesh)
{
  const auto triangles = mesh.triangles();
  const auto computed = vertexNormals({mesh.positions, {}, triangles}, NormalWeight::kArea);
  ASSERT_EQ(computed.size(), mesh.normals.size());
  for (std::size_t v = 0; v < computed.size(); ++v) {
    EXPECT_NEAR(dot(mesh.normals[v], mesh.normals[v]), 1.0f, 1e-5f);
    EXPECT_GT(dot(mesh.normals[v], computed[v]), 0.5f) << "vertex " << v;
  }
}

TEST(GeneratedMeshes, AreClosedAndOfTheRightGenus)
{
  expectClosed(sphere(16, 8, 1), 2);
  expectClosed(rock(16, 8), 2);
  expectClosed(torus(16, 8, 1, 0.4), 0);
  expectClosed(knot(60, 8, 0.4), 0);
  expectClosed(gear(12, 0.4), 0);
  expectClosed(cube(), 2);
}

TEST(GeneratedMeshes, HaveTheirOutsideOutside)
{
  EXPECT_NEAR(volume(sphere(128, 64, 1)), 4.18879, 0.02);
  EXPECT_NEAR(volume(rock(128, 64)), 4.18879, 0.5);
  EXPECT_NEAR(volume(torus(128, 64, 1, 0.4)), 2 * 9.8696 * 0.16, 0.02);
  EXPECT_NEAR(volume(cube()), 8.0, 1e-12);
  EXPECT_GT(volume(knot(160, 20, 0.45)), 10.0);
  EXPECT_GT(volume(gear(16, 0.4)), 0.5);
}

TEST(GeneratedMeshes, HaveNormalsThatFitTheirFaces)
{
  expectNormalsAgreeWithFaces(sphere(24, 12, 2));
  expectNormalsAgreeWithFaces(rock(128, 64));
  expectNormalsAgreeWithFaces(board(4));
  expectNormalsAgreeWithFaces(torus(24, 12, 1, 0.4));
  expectNormalsAgreeWithFaces(knot(160, 20, 0.45));
  expectNormalsAgreeWithFaces(extrudedSine(64, 16));
  expectNormalsAgreeWithFaces(sheet(32));
  expectNormalsAgreeWithFaces(teapot(10));
}

TEST(Teapot, HasItsKnownExtentsAndWeldedSeams)
{
  const GeneratedMesh mesh = teapot(10);
  Vec3f low = mesh.positions[0], high = low;
  for (const Vec3f p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  EXPECT_NEAR(low.y, 0, 1e-6);
  EXPECT_NEAR(high.y, 3.15, 1e-6);
  EXPECT_NEAR(low.x, -3.0, 0.01);
  EXPECT_NEAR(high.x, 3.434, 0.01);
  EXPECT_NEAR(high.z, 2.0, 0.01);
  // 32 patches of 11 x 11 points that shared nothing would be 3872.
  EXPECT_LT(mesh.positions.size(), 3400u);
}

TEST(AreaWeightedNormals, WeighByAreaAndIgnoreWhatCannotBeDrawn)
{
  // Two faces at a right angle, one of three times the area; and a vertex without a face.
  const std::vector<Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {9, 9, 9}};
  const std::vector<Triangle> triangles = {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 1, 77}}};
  const auto normals = vertexNormals({positions, {}, triangles}, NormalWeight::kArea);
  const Vec3f expected = normalized(Vec3f{3, 0, 1});
  EXPECT_NEAR(normals[0].x, expected.x, 1e-6);
  EXPECT_NEAR(normals[0].y, expected.y, 1e-6);
  EXPECT_NEAR(normals[0].z, expected.z, 1e-6);
  EXPECT_EQ(normals[1], (Vec3f{0, 0, 1}));
  EXPECT_EQ(normals[4], (Vec3f{0, 0, 0}));
}

TEST(FaceGeometry, JoinsTheTrianglesOfACell)
{
  const std::vector<Vec3f> positions = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {5, 5, 5}};
  const std::vector<Triangle> triangles = {{{0, 1, 2}}, {{0, 2, 3}}, {{4, 4, 4}}};
  const std::vector<std::uint32_t> cells = {0, 0, 1};
  const FaceGeometry faces = faceGeometry({positions, {}, triangles}, cells, 2);
  EXPECT_NEAR(faces.centroid[0].x, 2, 1e-6);
  EXPECT_NEAR(faces.centroid[0].y, 1, 1e-6);
  EXPECT_EQ(faces.normal[0], (Vec3f{0, 0, 1}));
  EXPECT_EQ(faces.centroid[1], (Vec3d{5, 5, 5}));
  EXPECT_EQ(faces.normal[1], (Vec3f{0, 0, 0}));
}

}  // namespace
}  // namespace limn
