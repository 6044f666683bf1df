// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ChainEdges.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Mesh/WeldVertices.h"
#include "Testing/Unit/Polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

using testing::Polyhedron;

constexpr double kPi = 3.14159265358979323846;

EdgeTable tableOf(const MeshView& mesh, double tolerance = 0)
{
  EdgeTable table;
  const Status status = buildEdgeTable(mesh, tolerance, 2, table);
  EXPECT_TRUE(status.ok()) << status.message;
  return table;
}

std::size_t countOf(const MeshView& mesh, unsigned kind, double degrees = 30,
                    const FeatureArrays& arrays = {}, double tolerance = 0)
{
  const EdgeTable table = tableOf(mesh, tolerance);
  const auto kinds = edgeKinds(mesh, table, arrays, degrees, 2);
  return static_cast<std::size_t>(
      std::count_if(kinds.begin(), kinds.end(), [&](std::uint8_t k) { return (k & kind) != 0; }));
}

TEST(EdgeTable, PlatonicSolidsHaveCreasesUpToTheirDihedralAngle)
{
  const struct {
    Polyhedron solid;
    double cosine;  ///< between the normals of two faces
    std::size_t edges;
  } solids[] = {{testing::tetrahedron(), -1.0 / 3, 6},
                {testing::cube(), 0, 12},
                {testing::octahedron(), 1.0 / 3, 12},
                {testing::dodecahedron(), 1 / std::sqrt(5.0), 30},
                {testing::icosahedron(), std::sqrt(5.0) / 3, 30}};
  for (const auto& [solid, cosine, edges] : solids) {
    const double degrees = std::acos(cosine) * 180 / kPi;
    FeatureArrays arrays;
    arrays.cells = solid.cells;
    EXPECT_EQ(countOf(solid.view(), kCreaseEdge, degrees - 1e-3, arrays), edges) << degrees;
    EXPECT_EQ(countOf(solid.view(), kCreaseEdge, degrees + 1e-3, arrays), 0u) << degrees;
    EXPECT_EQ(countOf(solid.view(), kBorderEdge, 30, arrays), 0u) << degrees;
  }
}

TEST(EdgeTable, SoupOfATriangleEachIsWeldedFirst)
{
  const Polyhedron cube = testing::cube();
  const Polyhedron soup = cube.unwelded();
  ASSERT_EQ(soup.positions.size(), 36u);
  EXPECT_EQ(countOf(soup.view(), kCreaseEdge), 12u);
  EXPECT_EQ(countOf(soup.view(), kBorderEdge), 0u);
  EXPECT_EQ(tableOf(soup.view()).edges.size(), 18u) << "with the diagonals";
}

TEST(EdgeTable, ZeroAndMinusZeroAreOnePlace)
{
  Polyhedron mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, -0.0f, 0}, {0, 1, -0.0f}, {-1, 0, 0}};
  mesh.triangles = {{{0, 1, 2}}, {{3, 4, 5}}};
  EXPECT_EQ(countOf(mesh.view(), kBorderEdge), 4u);
}

TEST(EdgeTable, TheEndOfAWholeTurnIsItsBeginning)
{
  // As VTK's parametric surfaces have it: the points of a seam differ by what the sine of 2 pi, a
  // number near that, lacks of 0.
  constexpr std::uint32_t kSteps = 24, kRow = kSteps + 1;
  for (const double size : {1e-3, 1.0, 3e5}) {
    std::vector<Vec3f> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i <= kSteps; ++i)
      for (std::uint32_t j = 0; j <= kSteps; ++j) {
        const double u = 2 * kPi * i / kSteps, v = 2 * kPi * j / kSteps, r = 1 + 0.5 * std::cos(v);
        positions.push_back(
            vec3Cast<float>(Vec3d{r * std::cos(u), r * std::sin(u), 0.5 * std::sin(v)} * size));
        if (i == kSteps || j == kSteps) continue;
        const std::uint32_t a = i * kRow + j;
        triangles.push_back({{a, a + kRow, a + kRow + 1}});
        triangles.push_back({{a, a + kRow + 1, a + 1}});
      }
    MeshView mesh;
    mesh.positions = positions;
    mesh.triangles = triangles;
    EXPECT_FALSE(positions[0].y == positions[kSteps * kRow].y);
    EXPECT_EQ(countOf(mesh, kBorderEdge), 0u) << size;
  }
  // But not what a float tells apart.
  const std::vector<Vec3f> apart = {{1, 0, 0}, {1, 1e-7f, 0}, {1, 0, 1}};
  MeshView mesh;
  mesh.positions = apart;
  EXPECT_EQ(weldVertices(mesh, 0, 1), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(EdgeTable, AToleranceWeldsWhatIsNearButNotFarther)
{
  Polyhedron mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9e-4f, 0, 0}, {0, 1.0009f, 0}, {-1, 0, 0}};
  mesh.triangles = {{{0, 1, 2}}, {{3, 4, 5}}};
  EXPECT_EQ(countOf(mesh.view(), kBorderEdge), 6u);
  EXPECT_EQ(countOf(mesh.view(), kBorderEdge, 30, {}, 1e-3), 4u);
  EXPECT_EQ(countOf(mesh.view(), kBorderEdge, 30, {}, 8e-4), 6u);
}

/// Two rows of squares, the second raised by an angle: creases in a row between them.
Polyhedron foldedStrip(std::uint32_t creases, double degrees)
{
  const double angle = degrees * kPi / 180;
  Polyhedron strip;
  for (std::uint32_t x = 0; x <= creases; ++x) {
    const auto at = static_cast<float>(x);
    strip.positions.push_back({at, -1, 0});
    strip.positions.push_back({at, 0, 0});
    strip.positions.push_back(
        {at, static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
  }
  for (std::uint32_t x = 0; x < creases; ++x)
    for (const std::uint32_t a : {3 * x, 3 * x + 1}) {
      strip.triangles.push_back({{a, a + 3, a + 4}});
      strip.triangles.push_back({{a, a + 4, a + 1}});
    }
  return strip;
}

std::size_t creasesLeft(const Polyhedron& solid, std::uint32_t fewest, unsigned drawn = kCreaseEdge)
{
  const EdgeTable table = tableOf(solid.view());
  FeatureArrays arrays;
  arrays.cells = solid.cells;
  auto kinds = edgeKinds(solid.view(), table, arrays, 30, 1);
  dropLooseCreases(solid.view(), table, drawn, fewest, kinds);
  return static_cast<std::size_t>(std::count_if(
      kinds.begin(), kinds.end(), [](std::uint8_t kind) { return (kind & kCreaseEdge) != 0; }));
}

TEST(EdgeTable, CreasesOfFewEdgesAreLeftOut)
{
  const Polyhedron strip = foldedStrip(5, 45);
  for (const std::uint32_t fewest : {0u, 1u, 5u})
    EXPECT_EQ(creasesLeft(strip, fewest), 5u) << fewest;
  for (const std::uint32_t fewest : {6u, 0xFFFFFFFFu})
    EXPECT_EQ(creasesLeft(strip, fewest), 0u) << fewest;
}

TEST(EdgeTable, CreasesOfFewEdgesStayWhereTheyAreSharpOrHangAtOtherLines)
{
  EXPECT_EQ(creasesLeft(foldedStrip(5, 59.9), 6), 0u);
  EXPECT_EQ(creasesLeft(foldedStrip(5, 60.1), 6), 5u);
  EXPECT_EQ(creasesLeft(testing::tetrahedron(), 100), 6u);
  EXPECT_EQ(creasesLeft(testing::dodecahedron(), 100), 30u);
  EXPECT_EQ(creasesLeft(testing::icosahedron(), 31), 0u);
  EXPECT_EQ(creasesLeft(testing::icosahedron(), 30), 30u);
  EXPECT_EQ(creasesLeft(foldedStrip(5, 45), 0xFFFFFFFFu, kCreaseEdge | kBorderEdge), 5u)
      << "its ends are corners of the border";
}

// vtkPolyDataSilhouette gives 16 border edges here although it is told to give none.
TEST(EdgeTable, BordersOfAPlaneAreBordersAndNoCreases)
{
  const Polyhedron plane = testing::plane(4);
  EXPECT_EQ(countOf(plane.view(), kBorderEdge), 16u);
  for (const double degrees : {0.0, 30.0, 60.0, 89.0, 91.0})
    EXPECT_EQ(countOf(plane.view(), kCreaseEdge, degrees), 0u) << degrees;
  const EdgeTable table = tableOf(plane.view());
  const auto kinds = edgeKinds(plane.view(), table, {}, 30, 1);
  const EdgeChains borders = chainEdges(table, kinds, kBorderEdge);
  ASSERT_EQ(borders.chains.first.size(), 2u) << "one chain";
  EXPECT_EQ(borders.chains.vertex.size(), 17u);
  EXPECT_EQ(borders.chains.vertex.front(), borders.chains.vertex.back()) << "closed";
}

TEST(EdgeTable, ThreeSheetsMeetInANonManifoldEdge)
{
  Polyhedron mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  mesh.triangles = {{{0, 1, 2}}, {{0, 1, 3}}, {{0, 1, 4}}};
  EXPECT_EQ(countOf(mesh.view(), kNonManifoldEdge), 1u);
  EXPECT_EQ(countOf(mesh.view(), kBorderEdge), 6u);
}

TEST(EdgeTable, WindingNeitherMakesNorLosesCreases)
{
  const Polyhedron cube = testing::cube();
  for (unsigned turned = 0; turned < 4096; turned += 37) {
    Polyhedron mixed = cube;
    for (std::size_t t = 0; t < mixed.triangles.size(); ++t)
      if ((turned >> t & 1) != 0)
        std::swap(mixed.triangles[t].vertex[1], mixed.triangles[t].vertex[2]);
    ASSERT_EQ(countOf(mixed.view(), kCreaseEdge), 12u) << turned;
    ASSERT_EQ(countOf(mixed.view(), kCreaseEdge, 91), 0u) << turned;
  }
}

TEST(EdgeTable, EdgesBetweenCellsOfOtherIdsAreIdEdges)
{
  const Polyhedron plane = testing::plane(4);  // 4 x 4 squares of 2 triangles
  std::vector<std::uint32_t> ids;
  for (std::uint32_t cell = 0; cell < 16; ++cell)
    ids.push_back(cell % 4 < 2 ? 5 : 9);
  FeatureArrays arrays;
  arrays.cells = plane.cells;
  arrays.ids = ids;
  EXPECT_EQ(countOf(plane.view(), kIdEdge, 30, arrays), 4u);
}

TEST(EdgeTable, SplitNormalsAreFeatureEdges)
{
  const Polyhedron cube = testing::cube();
  const Polyhedron soup = cube.unwelded();
  std::vector<Vec3f> normals;
  for (const Triangle& triangle : soup.triangles) {
    const auto p = [&](int i) { return soup.positions[triangle.vertex[i]]; };
    normals.insert(normals.end(), 3, normalized(cross(p(1) - p(0), p(2) - p(0))));
  }
  FeatureArrays arrays;
  arrays.vertexNormals = normals;
  EXPECT_EQ(countOf(soup.view(), kNormalEdge, 180, arrays), 12u);
  std::vector<Vec3f> smooth;
  for (const Vec3f& p : soup.positions)
    smooth.push_back(p);
  arrays.vertexNormals = smooth;
  EXPECT_EQ(countOf(soup.view(), kNormalEdge, 180, arrays), 0u);
}

TEST(EdgeTable, FacesWithoutAreaMakeNoCrease)
{
  Polyhedron mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}};
  // The second lies in the edge between the others.
  mesh.triangles = {{{0, 2, 3}}, {{0, 1, 2}}, {{2, 0, 4}}};
  EXPECT_EQ(countOf(mesh.view(), kCreaseEdge), 0u);
}

TEST(EdgeTable, BrokenTrianglesAreLeftOut)
{
  Polyhedron mesh = testing::cube();
  const std::size_t edges = tableOf(mesh.view()).edges.size();
  mesh.positions.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  mesh.triangles.push_back({{0, 1, 8}});
  mesh.triangles.push_back({{0, 1, 77}});
  mesh.triangles.push_back({{0, 1, 1}});
  EXPECT_EQ(tableOf(mesh.view()).edges.size(), edges);
}

TEST(EdgeTable, FindsEdgesByTheirPlaces)
{
  const EdgeTable table = tableOf(testing::plane(9).unwelded().view());
  const auto count = static_cast<std::uint32_t>(table.place.size());
  std::uint32_t found = 0;
  for (std::uint32_t low = 0; low < count; ++low)
    for (std::uint32_t high = low + 1; high < count; ++high) {
      const std::uint32_t e = table.edgeBetween(low, high);
      if (e == kNoCorner) continue;
      EXPECT_EQ(e, found++);
      EXPECT_EQ(table.edges[e].vertex[0], low);
      EXPECT_EQ(table.edges[e].vertex[1], high);
    }
  EXPECT_EQ(found, table.edges.size());
}

TEST(EdgeTable, AnyNumberOfThreadsMakesTheSameTable)
{
  const Polyhedron mesh = testing::plane(150).unwelded();
  const auto bytesOf = [&](int threads) {
    EdgeTable table;
    EXPECT_TRUE(buildEdgeTable(mesh.view(), 0, threads, table).ok());
    std::vector<std::uint32_t> all = table.place;
    all.insert(all.end(), table.firstEdge.begin(), table.firstEdge.end());
    for (const MeshEdge& e : table.edges)
      all.insert(all.end(), {e.vertex[0], e.vertex[1], e.corner[0], e.corner[1], e.faceCount});
    return all;
  };
  const auto one = bytesOf(1);
  EXPECT_EQ(bytesOf(2), one);
  EXPECT_EQ(bytesOf(8), one);
}

TEST(ChainLinks, ChainsEndWhereThreeMeetAndLoopsClose)
{
  //  0 - 1 - 2 - 3 and 2 - 4, and a loop 5 6 7
  const std::vector<LineLink> links = {{1, 0, 10}, {2, 3, 11}, {1, 2, 12}, {4, 2, 13},
                                       {5, 6, 14}, {7, 6, 15}, {5, 7, 16}};
  LineChains chains;
  std::vector<std::uint32_t> source;
  chainLinks(links, 8, chains, &source);
  const std::vector<std::uint32_t> first = {0, 3, 5, 7, 11};
  EXPECT_EQ(chains.first, first);
  const std::vector<std::uint32_t> vertex = {0, 1, 2, 2, 3, 4, 2, 5, 6, 7, 5};
  EXPECT_EQ(chains.vertex, vertex);
  const std::vector<std::uint32_t> made = {10,        12, kNoCorner, 11, kNoCorner, 13,
                                           kNoCorner, 14, 15,        16, kNoCorner};
  EXPECT_EQ(source, made);
}

}  // namespace
}  // namespace limn
