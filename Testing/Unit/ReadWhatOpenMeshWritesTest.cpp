// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ReadMesh.h"

#include "TemporaryMesh.h"

#include <gtest/gtest.h>

#if defined(__GNUC__) && !defined(__clang__)
// gcc 12 complains about the default constructor of OpenMesh's vectors wherever it is inlined.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

namespace limn {
namespace {

using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// A pyramid over a square, with every attribute that OpenMesh's OM files hold.
PolyMesh pyramid()
{
  PolyMesh mesh;
  mesh.request_vertex_normals();
  mesh.request_vertex_colors();
  mesh.request_vertex_texcoords2D();
  mesh.request_face_colors();
  mesh.request_face_normals();
  mesh.request_face_status();
  std::vector<PolyMesh::VertexHandle> v;
  for (const auto& p :
       {PolyMesh::Point(0, 0, 0), PolyMesh::Point(1, 0, 0), PolyMesh::Point(1, 1, 0),
        PolyMesh::Point(0, 1, 0), PolyMesh::Point(0.5f, 0.5f, 1)}) {
    v.push_back(mesh.add_vertex(p));
    mesh.set_normal(v.back(), p);
    mesh.set_color(v.back(), PolyMesh::Color(10, 20, static_cast<unsigned char>(v.size())));
    mesh.set_texcoord2D(v.back(), PolyMesh::TexCoord2D(p[0], p[1]));
  }
  mesh.add_face({v[3], v[2], v[1], v[0]});
  for (unsigned i = 0; i < 4; ++i)
    mesh.add_face({v[i], v[(i + 1) % 4], v[4]});
  for (const auto face : mesh.faces()) {
    mesh.set_color(face, PolyMesh::Color(static_cast<unsigned char>(face.idx()), 50, 60));
  }
  OpenMesh::FPropHandleT<std::string> label;
  mesh.add_property(label, "label");
  mesh.property(label).set_persistent(true);
  return mesh;
}

class ReadWhatOpenMeshWrites : public testing::TestWithParam<const char*> {};

TEST_P(ReadWhatOpenMeshWrites, KeepsThePyramid)
{
  using OpenMesh::IO::Options;
  const TemporaryFolder folder;
  const std::string name = GetParam();
  Options options = Options::VertexNormal;
  options += Options::VertexColor;
  options += Options::VertexTexCoord;
  options += Options::FaceColor;
  if (name == "binary.ply") options += Options::Binary;
  if (name == "all.om") options += Options::Status;
  omlog().disable();
  ASSERT_TRUE(OpenMesh::IO::write_mesh(pyramid(), folder.file(name), options));
  MeshFile mesh;
  const Status status = readMesh(folder.file(name), mesh);
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(polygonsOf(mesh), (Polygons{{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
  EXPECT_EQ(mesh.positions[4], (Vec3f{0.5f, 0.5f, 1}));
  EXPECT_EQ(mesh.normals[4], (Vec3f{0.5f, 0.5f, 1}));
  EXPECT_EQ(mesh.texCoords[3].v, 1.0f);
  EXPECT_EQ(channels({mesh.vertexColors[4]}), (std::vector<int>{10, 20, 5, 255}));
  ASSERT_EQ(mesh.faceColors.size(), 5u);
  EXPECT_EQ(channels({mesh.faceColors[3]}), (std::vector<int>{3, 50, 60, 255}));
  EXPECT_EQ(mesh.nonManifoldFaces + mesh.droppedFaces + mesh.splitVertices, 0u);
}

TEST(ReadOm, SplitsVerticesAlongASeamOfTheTexture)
{
  using OpenMesh::IO::Options;
  PolyMesh mesh = pyramid();
  mesh.request_halfedge_texcoords2D();
  for (const auto face : mesh.faces()) {
    for (const auto halfedge : face.halfedges()) {
      const PolyMesh::Point p = mesh.point(halfedge.to());
      mesh.set_texcoord2D(halfedge, PolyMesh::TexCoord2D(p[0], face.idx() == 0 ? 9.0f : p[1]));
    }
  }
  omlog().disable();
  const TemporaryFolder folder;
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, folder.file("a.om"), Options::FaceTexCoord));
  MeshFile read;
  const Status status = readMesh(folder.file("a.om"), read);
  ASSERT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(read.splitVertices, 4u);
  ASSERT_EQ(read.polygonCount(), 5u);
  for (std::size_t i = 0; i < read.polygonCorners.size(); ++i) {
    const std::uint32_t corner = read.polygonCorners[i];
    EXPECT_EQ(read.texCoords[corner].u, read.positions[corner].x);
    EXPECT_EQ(read.texCoords[corner].v, i < 4 ? 9.0f : read.positions[corner].y);
  }
}

TEST(ReadOm, KeepsDoublePrecision)
{
  struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
  };
  OpenMesh::PolyMesh_ArrayKernelT<Traits> mesh;
  const auto a = mesh.add_vertex({1e7, 0, 0});
  const auto b = mesh.add_vertex({1e7 + 0.125, 0, 0});
  const auto c = mesh.add_vertex({1e7, 0.0625, 0});
  mesh.add_face(a, b, c);
  omlog().disable();
  const TemporaryFolder folder;
  ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, folder.file("a.om")));
  MeshFile read;
  const Status status = readMesh(folder.file("a.om"), read);
  ASSERT_TRUE(status.ok()) << status.message;
  ASSERT_EQ(read.precisePositions.size(), 3u);
  EXPECT_EQ(read.precisePositions[1].x, 1e7 + 0.125);
  EXPECT_EQ(polygonsOf(read), (Polygons{{0, 1, 2}}));
}

INSTANTIATE_TEST_SUITE_P(Formats, ReadWhatOpenMeshWrites,
                         testing::Values("all.om", "text.ply", "binary.ply"), [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.')) + name.substr(name.find('.') + 1);
                         });

}  // namespace
}  // namespace limn
