// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ReadMesh.h"

#include "TemporaryMesh.h"

#include <gtest/gtest.h>

#include <locale>

#include <sys/stat.h>

namespace limn {
namespace {

struct Malformed {
  const char* what;
  const char* file;
  std::string content;
  std::string message;  ///< a part of it
  Error error = Error::kFile;
};

std::string ofBytes(std::initializer_list<int> values)
{
  std::string bytes;
  for (const int value : values)
    bytes += static_cast<char>(value);
  return bytes;
}

void expectRefused(const Malformed& malformed)
{
  testing::internal::CaptureStderr();
  const ReadResult result = readContent(malformed.file, malformed.content);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << malformed.what;
  const std::string& message = result.status.message;
  EXPECT_EQ(result.status.error, malformed.error) << malformed.what << ": " << message;
  EXPECT_NE(message.find(std::string(malformed.file) + ": "), std::string::npos) << message;
  EXPECT_NE(message.find(malformed.message), std::string::npos) << message;
  EXPECT_EQ(result.mesh.vertexCount(), 0u) << malformed.what;
  EXPECT_EQ(result.mesh.polygonCount(), 0u) << malformed.what;
}

TEST(ReadMeshErrors, NamesWhatIsWrongWithAnObj)
{
  const std::string v = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  for (const Malformed& malformed : {
           Malformed{"index too large", "a.obj", v + "\nf 1 2 4\n",
                     "line 5: a face names vertex 4, but there are 3", Error::kIndexOutOfRange},
           {"index zero", "a.obj", v + "f 0 1 2\n", "line 4: a face names vertex 0",
            Error::kIndexOutOfRange},
           {"relative index too large", "a.obj", v + "f -4 1 2\n", "line 4: a face names vertex -4",
            Error::kIndexOutOfRange},
           {"huge index", "a.obj", v + "f 1 2 99999999999999999999\n",
            "line 4: a corner of a face names '99999999999999999999'"},
           {"texture coordinate not there", "a.obj", v + "f 1/1 2/1 3/1\n",
            "line 4: a face names texture coordinate 1, but there are 0", Error::kIndexOutOfRange},
           {"normal not there", "a.obj", v + "vn 0 0 1\nf 1//1 2//1 3//2\n",
            "line 5: a face names normal 2, but there are 1", Error::kIndexOutOfRange},
           {"corner without vertex", "a.obj", v + "vt 0 0\nf /1 2/1 3/1\n", "line 5: "},
           {"too many slashes", "a.obj", v + "f 1/// 2 3\n", "line 4: a corner"},
           {"coordinate missing", "a.obj", "v 0 0\n", "line 1: the line ends before a coordinate"},
           {"coordinate not a number", "a.obj", "v 0 0 x\n", "line 1: a coordinate is 'x'"},
           {"NaN", "a.obj", "\nv 0 nan 0\n", "line 2: a coordinate is 'nan'", Error::kNotFinite},
           {"infinity", "a.obj", "v 0 0 -inf\n", "line 1: a coordinate", Error::kNotFinite},
           {"beyond float", "a.obj", "v 0 0 1e39\n", "line 1: a coordinate", Error::kNotFinite},
           {"beyond double", "a.obj", "v 0 0 1e999\n", "line 1: a coordinate", Error::kNotFinite},
           {"no vertices", "a.obj", "# only a comment\n", "no vertices"},
           {"too many corners", "a.obj",
            v + "f" +
                [] {
                  std::string corners;
                  for (int i = 0; i < 20000; ++i)
                    corners += " 1";
                  return corners;
                }(),
            "line 4: a face of 20000 corners"},
       }) {
    expectRefused(malformed);
  }
}

TEST(ReadMeshErrors, NamesWhatIsWrongWithAnOff)
{
  const std::string v = "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n";
  for (const Malformed& malformed : {
           Malformed{"no keyword", "a.off", "3 1 0\n0 0 0\n", "starts with the word OFF"},
           {"binary", "a.off", "OFF BINARY\n", "binary OFF"},
           {"four dimensions", "a.off", "4OFF\n1 0 0\n0 0 0 0\n", "dimension 3"},
           {"ends after the header", "a.off", "OFF\n", "line 1: the file ends"},
           {"truncated", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0     \n",
            "line 5: the file ends before its last face"},
           {"counts larger than the file", "a.off", "OFF\n4000000000 1 0\n0 0 0\n",
            "line 2: the number of vertices", Error::kIndexOutOfRange},
           {"many vertices", "a.off", "OFF\n2000000000 1 0\n0 0 0\n", "line 2: the vertices and"},
           {"index out of range", "a.off", v + "3 0 1 3\n", "line 6: a corner's vertex is '3'",
            Error::kIndexOutOfRange},
           {"negative index", "a.off", v + "3 0 1 -1\n", "line 6: a corner's vertex is '-1'"},
           {"more corners than words", "a.off", v + "4 0 1 2\n", "line 6: the number of corners",
            Error::kIndexOutOfRange},
           {"NaN", "a.off", "OFF\n1 0 0\nnan 0 0\n", "line 3: ", Error::kNotFinite},
           {"colour of five channels", "a.off", v + "3 0 1 2 1 1 1 1 1\n", "line 6: a colour"},
       }) {
    expectRefused(malformed);
  }
}

std::string ply(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

std::string byte(std::size_t offset)
{
  return "byte " + std::to_string(offset) + ": ";
}

TEST(ReadMeshErrors, NamesWhatIsWrongWithAPly)
{
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string list = "property list uchar int vertex_indices\n";
  const std::string one = "element vertex 1\n" + xyz + "element face 1\n" + list;
  const std::string point(12, '\0');
  for (const Malformed& malformed : {
           Malformed{"not a ply", "a.ply", "hello\n", "line 1: a PLY file starts with"},
           {"only the first line", "a.ply", "ply\n", "line 2: the file ends before end_header"},
           {"unknown format", "a.ply", "ply\nformat utf8 1.0\n", "line 2: unknown format 'utf8'"},
           {"no format", "a.ply", "ply\nend_header\n", "no format line"},
           {"unknown keyword", "a.ply", "ply\nelment vertex 3\n", "line 2: unknown keyword"},
           {"unknown type", "a.ply", "ply\nelement vertex 1\nproperty half x\n",
            "line 3: unknown type 'half'"},
           {"property without element", "a.ply", "ply\nproperty float x\n", "line 2: a property"},
           {"real count of a list", "a.ply",
            "ply\nelement face 1\nproperty list float int vertex_indices\n", "line 3: the count"},
           {"no vertices", "a.ply", ply("ascii", "element face 0\n" + list), "no vertices"},
           {"no z", "a.ply", ply("ascii", "element vertex 1\nproperty float x\n") + "1\n",
            "x, y and z"},
           {"vertices twice", "a.ply",
            ply("ascii", "element vertex 1\n" + xyz + "element vertex 1\n" + xyz) + "1 1 1 1 1 1\n",
            "twice"},
           {"no list of corners", "a.ply",
            ply("ascii", "element vertex 1\n" + xyz + "element face 1\nproperty int a\n") +
                "1 1 1 1\n",
            "vertex_indices"},
           {"triangle strips", "a.ply",
            ply("ascii", "element vertex 1\n" + xyz + "element tristrips 1\n" + list) + "1 1 1 0\n",
            "triangle strips"},
           {"huge count", "a.ply",
            ply("binary_little_endian", "element vertex 4000000000\n" + xyz) + point,
            "line 3: 4000000000 of element 'vertex' do not fit"},
           {"count beyond 64 bits", "a.ply",
            ply("ascii", "element vertex 99999999999999999999\n" + xyz), "line 3: the count"},
           {"truncated ASCII", "a.ply", ply("ascii", one) + "0 0 0\n3 0 0\n",
            "line 12: the file ends"},
           {"truncated binary", "a.ply",
            ply("binary_big_endian", one) + point + std::string("\x03\0\0\0\0", 5),
            byte(ply("binary_big_endian", one).size() + 12) + "3 corners do not fit"},
           {"huge list", "a.ply",
            ply("binary_little_endian",
                "element vertex 1\n" + xyz +
                    "element face 1\nproperty list uint int vertex_index\n") +
                point + "\xff\xff\xff\xff",
            "4294967295 corners do not fit"},
           {"huge skipped list", "a.ply",
            ply("binary_little_endian",
                "element vertex 1\n" + xyz + "property list uint int bones\n") +
                point + "\xff\xff\xff\xff",
            "4294967295 values of a list do not fit"},
           {"index out of range", "a.ply", ply("ascii", one) + "0 0 0\n3 0 0 1\n",
            "line 11: a corner's vertex", Error::kIndexOutOfRange},
           {"negative index", "a.ply", ply("ascii", one) + "0 0 0\n3 0 0 -1\n",
            "line 11: a corner's vertex", Error::kIndexOutOfRange},
           {"half a corner", "a.ply", ply("ascii", one) + "0 0 0\n2.5 0 0 0\n",
            "line 11: the number of corners", Error::kIndexOutOfRange},
           {"word for a number", "a.ply", ply("ascii", one) + "0 zero 0\n3 0 0 0\n",
            "line 10: here is 'zero'"},
           {"NaN", "a.ply", ply("ascii", one) + "0 nan 0\n3 0 0 0\n", "line 10: a coordinate",
            Error::kNotFinite},
           {"NaN in binary", "a.ply",
            ply("binary_little_endian", "element vertex 1\n" + xyz) + std::string(8, '\0') +
                ofBytes({0, 0, 0xc0, 0x7f}),
            byte(ply("binary_little_endian", "element vertex 1\n" + xyz).size() + 8) +
                "a coordinate",
            Error::kNotFinite},
       }) {
    expectRefused(malformed);
  }
}

TEST(ReadMeshErrors, NamesWhatIsWrongWithAnStl)
{
  const std::string title(80, ' ');
  const std::string facet =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  std::string notANumber(50, '\0');
  notANumber.replace(20, 4, ofBytes({0, 0, 0x80, 0x7f}));
  for (const Malformed& malformed : {
           Malformed{"neither", "a.stl", "hello", "neither 'solid' nor"},
           {"truncated binary", "a.stl", title + ofBytes({2, 0, 0, 0}) + std::string(99, '\0'),
            "byte 80: the header announces 2 triangles, but the file ends after 1"},
           {"huge count", "a.stl", title + ofBytes({255, 255, 255, 255}) + std::string(50, '\0'),
            "announces 4294967295"},
           {"no triangles", "a.stl", title + ofBytes({0, 0, 0, 0}), "no triangles"},
           {"infinite", "a.stl", title + ofBytes({1, 0, 0, 0}) + notANumber,
            "byte 104: ", Error::kNotFinite},
           {"truncated ASCII", "a.stl", facet, "line 6: the file ends inside"},
           {"four vertices", "a.stl", facet + "vertex 1 1 1\n", "line 7: a facet of STL has 3"},
           {"two vertices", "a.stl", facet.substr(0, facet.rfind("vertex")) + "endloop\n",
            "line 6: a facet of STL has 3"},
           {"out of place", "a.stl", facet + "endsolid\n", "line 7: 'endsolid' is out of place"},
           {"unknown keyword", "a.stl", "solid a\nface\n", "line 2: unknown keyword 'face'"},
           {"empty solid", "a.stl", "solid a\nendsolid\n", "no triangles"},
           {"NaN", "a.stl", "solid\nfacet\nouter loop\nvertex 0 nan 0\n",
            "line 4: ", Error::kNotFinite},
       }) {
    expectRefused(malformed);
  }
}

std::string om(int version, int vertices, int faces, int edges)
{
  return "OM" + ofBytes({'P', version, vertices, 0, 0, 0, faces, 0, 0, 0, edges, 0, 0, 0});
}

TEST(ReadMeshErrors, NamesWhatIsWrongWithAnOm)
{
  // Chunks: positions 0x1000 (float, dimension 3); half-edges 0x00f8; faces 0x00e8 (8 bits).
  const std::string points = ofBytes({0x00, 0x10}) + std::string(36, '\0');
  const std::string edges =
      ofBytes({0xf8, 0x00, 2, 1, 0, 4, 0, -1, 4, 2, 0, 0, 1, -1, 0, 0, 0, 2, 2, -1});
  const std::string lostEdges =
      ofBytes({0xf8, 0x00, 2, 1, 0, 4, 0, -1, 2, 2, 0, 0, 1, -1, 0, 0, 0, 2, 2, -1});
  const int now = 2 << 5 | 2;
  for (const Malformed& malformed : {
           Malformed{"not an om", "a.om", "hello", "starts with the letters OM"},
           {"short header", "a.om", "OMP", "truncated"},
           {"unknown kind", "a.om", "OMX" + std::string(13, '\0'), "byte 2: "},
           {"newer version", "a.om", om(255, 3, 1, 3), "byte 3: version 7.31"},
           {"only the header", "a.om", om(now, 3, 1, 3), "no vertex positions"},
           {"truncated positions", "a.om", om(now, 4, 1, 3) + points,
            "byte 18: 48 bytes should follow, but the file has 36"},
           {"huge counts", "a.om", "OMP" + ofBytes({now}) + std::string(12, '\x7f') + points,
            "byte 4: more"},
           {"no faces", "a.om", om(now, 3, 1, 3) + points, "no faces"},
           {"no edges", "a.om", om(now, 3, 1, 3) + points + ofBytes({0xe8, 0, 0}), "no edges"},
           {"NaN", "a.om",
            om(now, 3, 0, 0) + points.substr(0, 2) + ofBytes({0, 0, 0xc0, 0xff}) + points.substr(6),
            "byte 18: ", Error::kNotFinite},
           {"unknown chunk", "a.om", om(now, 3, 1, 3) + points + ofBytes({0xa0, 0}), "unknown"},
           {"vertex of an edge not there", "a.om",
            om(now, 2, 1, 3) + points.substr(0, 26) + edges + ofBytes({0xe8, 0, 0}),
            "names vertex 2", Error::kIndexOutOfRange},
           {"half-edge of a face not there", "a.om",
            om(now, 3, 1, 3) + points + edges + ofBytes({0xe8, 0, 6}), "names half-edge 6",
            Error::kIndexOutOfRange},
           {"half-edges that form no ring", "a.om",
            om(now, 3, 1, 3) + points + lostEdges + ofBytes({0xe8, 0, 0}), "do not form a ring"},
       }) {
    expectRefused(malformed);
  }
}

TEST(ReadMeshErrors, NamesFilesThatCannotBeRead)
{
  const TemporaryFolder folder;
  MeshFile mesh;
  const auto messageOf = [&mesh](const std::string& path) {
    const Status status = readMesh(path, mesh);
    EXPECT_EQ(status.error, Error::kFile);
    EXPECT_EQ(status.message.rfind(path + ": ", 0), 0u) << status.message;
    return status.message;
  };
  EXPECT_NE(messageOf(folder.file("gone.obj")).find("no such file"), std::string::npos);
  EXPECT_NE(messageOf(folder.write("empty.ply", "")).find("empty"), std::string::npos);
  EXPECT_NE(messageOf(folder.write("a.xyz", "x")).find("unknown mesh format"), std::string::npos);
  EXPECT_NE(messageOf(folder.write("obj", "x")).find("unknown mesh format"), std::string::npos);
  std::filesystem::create_directory(folder.file("folder.stl"));
  EXPECT_NE(messageOf(folder.file("folder.stl")).find("directory"), std::string::npos);
  ASSERT_EQ(mkfifo(folder.file("pipe.off").c_str(), 0600), 0);
  EXPECT_NE(messageOf(folder.file("pipe.off")).find("regular file"), std::string::npos);
}

TEST(ReadMeshErrors, NamesAFileWithoutPermission)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", "v 0 0 0\n");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  MeshFile mesh;
  const Status status = readMesh(path, mesh);
  // Root may read everything.
  if (geteuid() == 0) {
    EXPECT_TRUE(status.ok()) << status.message;
  } else {
    EXPECT_NE(status.message.find("Permission denied"), std::string::npos) << status.message;
  }
}

TEST(ReadMeshErrors, NamesALocaleInWhichObjCannotBeRead)
{
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const ReadResult obj = readContent("a.obj", "v 0.5 0 0\n");
  const ReadResult off = readContent("a.off", "OFF\n1 0 0\n0.5 0 0\n");
  std::locale::global(before);
  EXPECT_NE(obj.status.message.find("locale"), std::string::npos) << obj.status.message;
  ASSERT_TRUE(off.status.ok()) << off.status.message;
  EXPECT_EQ(off.mesh.positions[0].x, 0.5f);
}

TEST(ReadMeshErrors, KnowsItsExtensions)
{
  for (const char* name : {"a.obj", "a.OFF", "b/a.Ply", "a.stl", "a.om"}) {
    EXPECT_TRUE(isMeshFileName(name)) << name;
  }
  for (const char* name : {"a.vtp", "a", "obj", "a.obj.gz", ""}) {
    EXPECT_FALSE(isMeshFileName(name)) << name;
  }
}

}  // namespace
}  // namespace limn
