// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ReadMesh.h"

#include "TemporaryMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>

namespace limn {
namespace {

MeshFile readOk(const std::string& name, const std::string& content)
{
  const ReadResult result = readContent(name, content);
  EXPECT_TRUE(result.status.ok()) << result.status.message;
  return result.mesh;
}

std::string bytesOf(std::uint64_t bits, std::size_t size, bool bigEndian)
{
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(bits >> 8 * i & 0xff);
  if (bigEndian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string bytesOfFloat(float value, bool bigEndian)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bytesOf(bits, 4, bigEndian);
}

std::string bytesOfDouble(double value, bool bigEndian)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bytesOf(bits, 8, bigEndian);
}

const char* const kSquareObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";

TEST(ReadObj, KeepsPolygonsNormalsAndTextureCoordinates)
{
  const MeshFile mesh =
      readOk("a.obj", std::string(kSquareObj) + "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 1/1/1 3/3/1 2/2/1");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2, 3}, {0, 2, 1}}));
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], (Vec3f{1, 1, 0}));
  ASSERT_EQ(mesh.normals.size(), 4u);
  EXPECT_EQ(mesh.normals[3], (Vec3f{0, 0, 1}));
  ASSERT_EQ(mesh.texCoords.size(), 4u);
  EXPECT_EQ(mesh.texCoords[3].v, 1.0f);
  EXPECT_EQ(mesh.texCoords[3].u, 0.0f);
  EXPECT_EQ(mesh.splitVertices, 0u);
}

TEST(ReadObj, SplitsAVertexWhereCornersDisagree)
{
  const MeshFile mesh = readOk("a.OBJ", std::string(kSquareObj) +
                                            "vn 0 1 0\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/2 4/1/1\n"
                                            "f 1/1/1 3/3/2 4/1/1\n");
  EXPECT_EQ(mesh.splitVertices, 1u);
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 4, 3}, {0, 4, 3}}));
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[4], mesh.positions[2]);
  EXPECT_EQ(mesh.normals[2], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.normals[4], (Vec3f{0, 1, 0}));
  EXPECT_EQ(mesh.texCoords[4].v, 1.0f);
}

TEST(ReadObj, GivesACornerWithoutNormalItsPolygons)
{
  const MeshFile mesh =
      readOk("a.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 4 3\n");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {4, 3, 5}}));
  for (const std::size_t vertex : {4u, 3u, 5u})
    EXPECT_EQ(mesh.normals[vertex], (Vec3f{0, 0, -1}));
}

TEST(ReadObj, SplitsAVertexOfVeryManyCornersInTime)
{
  std::string content = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  constexpr std::size_t kFaces = 100000;
  for (std::size_t i = 1; i <= kFaces; ++i) {
    const std::string number = std::to_string(i);
    content += "vt " + number + " 0\nf 1/" + number + " 2/1 3/1\n";
  }
  const MeshFile mesh = readOk("a.obj", content);
  EXPECT_EQ(mesh.splitVertices, kFaces - 1);
  EXPECT_EQ(mesh.texCoords[mesh.polygonCorners[3 * (kFaces - 1)]].u, float{kFaces});
}

TEST(ReadObj, TakesRelativeIndicesContinuationCarriageReturnsAndNoLastNewline)
{
  const MeshFile mesh = readOk("a.obj",
                               "# comment\r\n\r\ng\r\no\r\nmtllib gone.mtl\r\nusemtl gone\r\n"
                               "v 0 0 0\r\nv +1 0 0\r\nv 1 1e0 0 1.0\r\nf -3 -2 \\\r\n-1\r\n"
                               "v 0 1 0\r\nl 1 2\r\ns off\r\nf 1 2 3 -1");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 1, 2, 3}}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.texCoords.empty());
  EXPECT_TRUE(mesh.vertexColors.empty());
  EXPECT_TRUE(mesh.faceColors.empty());
}

TEST(ReadObj, TakesColorsOfVerticesAndOfMaterials)
{
  const TemporaryFolder folder;
  folder.write("my colors.mtl", "newmtl red\nKd 1 0 0\nnewmtl none\nKa 1 1 1\n");
  const std::string path = folder.write(
      "a.obj",
      "mtllib my colors.mtl\nv 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 1 1 0\nf 1 2 3\nusemtl red\n"
      "f 3 2 1\nusemtl gone\nf 1 2 3\n");
  MeshFile mesh;
  testing::internal::CaptureStderr();
  const Status status = readMesh(path, mesh);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(channels(mesh.vertexColors),
            (std::vector<int>{255, 0, 128, 255, 0, 255, 0, 255, 255, 255, 255, 255}));
  EXPECT_EQ(channels(mesh.faceColors),
            (std::vector<int>{255, 255, 255, 255, 255, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(ReadObj, KeepsAPolygonThatTouchesAVertexTwice)
{
  const MeshFile mesh = readOk("a.obj", std::string(kSquareObj) + "f 1 2 1\nf 1 2 3 1 4 3\nf 1\n");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2, 0, 3, 2}}));
  EXPECT_EQ(mesh.droppedFaces, 2u);
}

TEST(ReadObj, KeepsDoublePrecisionFarFromTheOriginOnly)
{
  const std::string faces = "f 1 2 3\nf 3 2 1\n";
  const MeshFile far =
      readOk("a.obj",
             "v 1e7 0 0\nv 10000000.001 0 0\nv 10000000 0.001 0\nvn 0 0 1\nvn 1 0 0\n"
             "f 1//1 2//1 3//1\nf 1//2 2//2 3//2\n");
  EXPECT_TRUE(far.positions.empty());
  ASSERT_EQ(far.precisePositions.size(), 6u);
  EXPECT_EQ(far.precisePositions[1].x, 10000000.001);
  EXPECT_EQ(far.precisePositions[4].x, 10000000.001);
  const MeshFile near = readOk("a.obj", "v 0.1 0 0\nv 0.2 0 0\nv 0 1 0\n" + faces);
  EXPECT_EQ(near.positions.size(), 3u);
  EXPECT_EQ(near.positions[0].x, 0.1f);
}

TEST(ReadOff, KeepsEverything)
{
  const MeshFile mesh = readOk("a.off",
                               "# first\nSTCNOFF\n4 2 0 # counts\n"
                               "0 0 0  0 0 1\t10 20 30   0.25 0.75\n\n"
                               "1 0 0  0 0 1  10 20 30 40  1 0\n"
                               "1 1 0  0 1 0  0.5 1 0  1 1\n0 1 0  0 0 1 0 1\n"
                               "4 0 1 2 3  255 0 0\n3 0 2 1");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2, 3}, {0, 2, 1}}));
  EXPECT_EQ(mesh.normals[2], (Vec3f{0, 1, 0}));
  EXPECT_EQ(mesh.texCoords[0].v, 0.75f);
  EXPECT_EQ(channels(mesh.vertexColors), (std::vector<int>{10, 20, 30, 255, 10, 20, 30, 40, 128,
                                                           255, 0, 255, 255, 255, 255, 255}));
  EXPECT_EQ(channels(mesh.faceColors), (std::vector<int>{255, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(ReadOff, TakesCountsBesideTheKeyword)
{
  const MeshFile mesh = readOk("a.off", "OFF 3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}}));
  EXPECT_TRUE(mesh.faceColors.empty());
}

TEST(ReadOff, DropsFacesOfFewerThanThreeVertices)
{
  const MeshFile mesh = readOk(
      "a.off", "OFF 3 5 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 0 1 1 2 3\n3 0 1 2 4 5 6\n0\n1 2\n");
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}}));
  EXPECT_EQ(channels(mesh.faceColors), (std::vector<int>{4, 5, 6, 255}));
  EXPECT_EQ(mesh.droppedFaces, 4u);
}

TEST(ReadOff, TakesNumbersTooSmallForADoubleAsZero)
{
  for (const char* tiny : {"1e-400", "-1E-999", "0.0000001e-330"}) {
    const MeshFile mesh = readOk("a.off", "OFF 1 0 0\n1 2 " + std::string(tiny) + "\n");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{1, 2, 0}})) << tiny;
  }
}

struct PlyCase {
  const char* format;
  bool ascii, bigEndian;
};

class ReadPly : public testing::TestWithParam<PlyCase> {
 protected:
  std::string header() const
  {
    return std::string("ply\r\nformat ") + GetParam().format +
           " 1.0\r\ncomment made by hand\r\n"
           "element material 1\r\nproperty list uint32 float shine\r\n"
           "element vertex 3\r\nproperty double x\r\nproperty double y\r\nproperty float z\r\n"
           "property short flags\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\n"
           "property float s\r\nproperty float t\r\n"
           "property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\n"
           "property uchar alpha\r\n"
           "element face 2\r\nproperty list uchar float texcoord\r\n"
           "property list int uint vertex_index\r\nproperty float red\r\nproperty float green\r\n"
           "property float blue\r\nelement edge 1\r\nproperty int vertex1\r\nend_header\r\n";
  }
  void real(double value) { put(value, bytesOfDouble(value, GetParam().bigEndian)); }
  void real(float value) { put(value, bytesOfFloat(value, GetParam().bigEndian)); }
  void whole(std::uint64_t value, std::size_t size)
  {
    put(value, bytesOf(value, size, GetParam().bigEndian));
  }
  template <class T>
  void put(T value, const std::string& binary)
  {
    data_ += GetParam().ascii ? std::to_string(value) + " " : binary;
  }

  std::string data_;
};

TEST_P(ReadPly, KeepsEverythingThatIsDrawn)
{
  whole(2, 4);
  for (const float shine : {1.0f, 2.0f})
    real(shine);
  for (const double x : {0.5, 1.5, 2.5}) {
    real(x);
    real(2 * x);
    real(4.0f);
    whole(9, 2);
    for (const float n : {0.0f, 0.0f, 1.0f})
      real(n);
    for (const float t : {0.25f, 0.75f})
      real(t);
    for (const std::uint64_t c : {10u, 20u, 30u, 40u})
      whole(c, 1);
  }
  for (const float red : {1.0f, 0.5f}) {
    whole(1, 1);
    real(7.0f);
    whole(3, 4);
    for (const std::uint64_t corner : {2u, 1u, 0u})
      whole(corner, 4);
    for (const float c : {red, 0.0f, 1.0f})
      real(c);
  }
  whole(5, 4);
  const MeshFile mesh = readOk("a.ply", header() + data_);
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{2, 1, 0}, {2, 1, 0}}));
  EXPECT_EQ(mesh.nonManifoldFaces, 1u);
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[1], (Vec3f{1.5, 3, 4}));
  EXPECT_EQ(mesh.normals[2], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.texCoords[2].v, 0.75f);
  EXPECT_EQ(channels({mesh.vertexColors[1]}), (std::vector<int>{10, 20, 30, 40}));
  EXPECT_EQ(channels(mesh.faceColors), (std::vector<int>{255, 0, 255, 255, 128, 0, 255, 255}));
}

INSTANTIATE_TEST_SUITE_P(Encodings, ReadPly,
                         testing::Values(PlyCase{"ascii", true, false},
                                         PlyCase{"binary_little_endian", false, false},
                                         PlyCase{"binary_big_endian", false, true}),
                         [](const auto& test) { return std::string(test.param.format); });

std::string asciiStl(const std::string& name)
{
  return "solid " + name +
         "\n FACET NORMAL 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
         "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
         "endloop\nendfacet\nendsolid " +
         name + "\n";
}

TEST(ReadStl, WeldsVerticesOfAsciiFiles)
{
  const MeshFile mesh = readOk("a.stl", asciiStl("of a router facet normal"));
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.positions[3], (Vec3f{0, 1, 0}));
  EXPECT_EQ(polygonsOf(readOk("a.stl", asciiStl("a") + asciiStl("b"))).size(), 4u);
}

std::string binaryStl(const std::string& title, const std::vector<float>& coordinates)
{
  std::string bytes = title;
  bytes.resize(80, ' ');
  bytes += bytesOf(coordinates.size() / 9, 4, false);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0) bytes += std::string(12, '\0');
    bytes += bytesOfFloat(coordinates[i], false);
    if (i % 9 == 8) bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(ReadStl, WeldsVerticesOfBinaryFilesWhateverTheirTitle)
{
  const std::vector<float> coordinates = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1,
                                          0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0};
  const MeshFile mesh = readOk("a.stl", binaryStl("solid outer loop", coordinates));
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.droppedFaces, 1u);
}

// Against a search through all places met so far, on more places than the table starts with.
TEST(ReadStl, NumbersPlacesAsTheyAreFirstMetInAnyOrderOfFacets)
{
  std::mt19937 random(7);
  const float values[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 3e5f, 1e-20f};
  for (const std::size_t facets : {1u, 7u, 300u}) {
    std::vector<float> coordinates;
    while (coordinates.size() < 9 * facets)
      coordinates.push_back(values[random() % std::size(values)]);
    std::vector<Vec3f> places;
    Polygons expected;
    for (std::size_t facet = 0; facet < facets; ++facet) {
      std::vector<std::uint32_t> corners;
      for (std::size_t i = 9 * facet; i < 9 * facet + 9; i += 3) {
        const Vec3f place{coordinates[i], coordinates[i + 1], coordinates[i + 2]};
        const auto found = std::find(places.begin(), places.end(), place);
        corners.push_back(static_cast<std::uint32_t>(found - places.begin()));
        if (found == places.end()) places.push_back(place);
      }
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        expected.push_back(corners);
    }
    const MeshFile mesh = readOk("a.stl", binaryStl("random", coordinates));
    EXPECT_EQ(polygonsOf(mesh), expected);
    EXPECT_EQ(mesh.droppedFaces, facets - expected.size());
    ASSERT_EQ(mesh.positions.size(), places.size());
    // Bytes, as the sign of 0 is that of the first one met.
    EXPECT_EQ(std::memcmp(mesh.positions.data(), places.data(), places.size() * sizeof(Vec3f)), 0);
  }
}

TEST(ReadStl, TakesCoordinatesNearerThanTheLeastNormalFloatForEqual)
{
  const MeshFile mesh = readOk(
      "a.stl", binaryStl("tiny", {0, 0, 0, 1, 0, 0, 1, 1, 0, 1e-39f, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadNonManifold, KeepsAndCountsEveryFace)
{
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\n";
  struct Case {
    const char* name;
    const char* faces;
    std::size_t faceCount, nonManifold;
  };
  const Case cases[] = {{"three faces on an edge", "f 1 2 3\nf 2 1 4\nf 1 2 5\n", 3, 1},
                        {"a repeated face", "f 1 2 3\nf 1 2 3\nf 2 3 1\n", 3, 2},
                        {"winding the other way", "f 1 2 3\nf 1 2 4\n", 2, 1},
                        {"an edge of a refused face", "f 1 2 3\nf 1 2 4\nf 2 4 5\n", 3, 1},
                        {"a bow tie", "f 1 2 3\nf 1 4 5\n", 2, 0},
                        {"two neighbours", "f 1 2 3\nf 2 1 4\n", 2, 0}};
  for (const Case& c : cases) {
    const MeshFile mesh = readOk("a.obj", corners + c.faces);
    EXPECT_EQ(mesh.polygonCount(), c.faceCount) << c.name;
    EXPECT_EQ(mesh.nonManifoldFaces, c.nonManifold) << c.name;
    EXPECT_EQ(mesh.droppedFaces, 0u) << c.name;
  }
}

TEST(ReadProgress, RisesToOneAndCancels)
{
  std::string content;
  for (int i = 0; i < 3000; ++i)
    content += "v 0 " + std::to_string(i) + " 1\n";
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", content + "f 1 2 3\n");
  std::vector<double> fractions;
  MeshFile mesh;
  EXPECT_TRUE(readMesh(path, mesh, [&fractions](double fraction) {
                fractions.push_back(fraction);
                return true;
              }).ok());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.size(), 50u);
  EXPECT_EQ(fractions.back(), 1.0);
  for (const double limit : {0.2, 0.8}) {
    const Status status = readMesh(path, mesh, [limit](double f) { return f < limit; });
    EXPECT_EQ(status.error, Error::kFile);
    EXPECT_NE(status.message.find("cancelled"), std::string::npos);
    EXPECT_EQ(mesh.vertexCount(), 0u);
  }
  EXPECT_TRUE(readMesh(path, mesh).ok());
}

}  // namespace
}  // namespace limn
