// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/NormalForm.h"
#include "Rendering/Mesh/Io/RawMesh.h"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

namespace limn::meshio {

/// Takes what OpenMesh's parsers find into plain arrays. OpenMesh's own importer builds a half-edge
/// mesh, which refuses non-manifold faces and forgets the attributes of corners.
///
/// Throws Fault, through the parser, for an index that is out of range and if the user cancels.
class ArrayImporter : public OpenMesh::IO::BaseImporter {
 public:
  ArrayImporter(Source& source, const NormalForm& form);

  /// To be called once, after the parser.
  RawMesh finishMesh();

  OpenMesh::VertexHandle add_vertex(const OpenMesh::Vec3f& point) override;
  OpenMesh::VertexHandle add_vertex() override;
  void set_point(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& point) override;
  OpenMesh::FaceHandle add_face(const VHandles& vertices) override;

  // Half-edges, as OM files have them.
  OpenMesh::HalfedgeHandle add_edge(OpenMesh::VertexHandle from,
                                    OpenMesh::VertexHandle to) override;
  void set_next(OpenMesh::HalfedgeHandle halfedge, OpenMesh::HalfedgeHandle next) override;
  OpenMesh::FaceHandle add_face(OpenMesh::HalfedgeHandle halfedge) override;
  void set_texcoord(OpenMesh::HalfedgeHandle halfedge, const OpenMesh::Vec2f& texCoord) override;

  void set_normal(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& normal) override;
  void set_normal(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3d& normal) override;
  void set_texcoord(OpenMesh::VertexHandle vertex, const OpenMesh::Vec2f& texCoord) override;
  void set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3uc& color) override;
  void set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec4uc& color) override;
  void set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& color) override;
  void set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec4f& color) override;
  void set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec3uc& color) override;
  void set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec4uc& color) override;
  void set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec3f& color) override;
  void set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec4f& color) override;

  OpenMesh::BaseKernel* kernel() override { return &kernel_; }
  size_t n_vertices() const override { return mesh_.positions.size(); }
  size_t n_faces() const override { return mesh_.faceCount() + faceHalfedges_.size(); }
  size_t n_edges() const override { return halfedges_.size() / 2; }

  // What nobody draws.
  using Status = OpenMesh::Attributes::StatusInfo;
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle,
                          const std::vector<OpenMesh::Vec2f>&) override
  {
  }
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle,
                          const std::vector<OpenMesh::Vec3f>&) override
  {
  }
  void set_face_texindex(OpenMesh::FaceHandle, int) override {}
  void set_halfedge(OpenMesh::VertexHandle, OpenMesh::HalfedgeHandle) override {}
  void set_face(OpenMesh::HalfedgeHandle, OpenMesh::FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_texcoord(OpenMesh::HalfedgeHandle, const OpenMesh::Vec3f&) override {}
  void set_status(OpenMesh::VertexHandle, const Status&) override {}
  void set_status(OpenMesh::HalfedgeHandle, const Status&) override {}
  void set_status(OpenMesh::EdgeHandle, const Status&) override {}
  void set_status(OpenMesh::FaceHandle, const Status&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_normal(OpenMesh::FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(OpenMesh::FaceHandle, const OpenMesh::Vec3d&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  struct Halfedge {
    std::uint32_t to = 0;
    std::size_t next = 0;
    bool isVisited = false;
    bool hasTexCoord = false;
    TexCoord texCoord{};
  };

  std::size_t indexOf(OpenMesh::VertexHandle vertex) const;
  std::size_t indexOf(OpenMesh::HalfedgeHandle halfedge) const;
  void setVertexColor(OpenMesh::VertexHandle vertex, Rgba8 color);
  void setFaceColor(OpenMesh::FaceHandle face, Rgba8 color);
  void addCorner(std::size_t vertex, const CornerAttributes& attributes);
  OpenMesh::FaceHandle closeFace();
  void walkFace(std::size_t face);
  void reportProgress();

  Source& source_;
  const NormalForm& form_;
  bool cornersHaveAttributes_;
  RawMesh mesh_;
  OpenMesh::BaseKernel kernel_;
  /// Corners that OpenMesh's parser for OBJ has named on the line of a face, before the face.
  std::vector<std::uint32_t> announcedVertices_;
  std::vector<CornerAttributes> announcedAttributes_;
  std::vector<Halfedge> halfedges_;
  std::vector<std::size_t> faceHalfedges_;
  std::vector<Rgba8> faceColors_;  ///< of the faces as OpenMesh counts them
};

}  // namespace limn::meshio
