// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ArrayImporter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn::meshio {
namespace {

constexpr Rgba8 kWhite{255, 255, 255, 255};

Vec3f vec3(const OpenMesh::Vec3f& v)
{
  return {v[0], v[1], v[2]};
}

std::uint8_t channel(float value)
{
  return static_cast<std::uint8_t>(std::round(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

template <class T>
T& grownElement(std::vector<T>& values, std::size_t i, T missing)
{
  if (values.size() <= i) values.resize(i + 1, missing);
  return values[i];
}

/// Attributes come vertex by vertex; the last ones may have none.
template <class T>
void complete(std::vector<T>& values, std::size_t count, T missing)
{
  if (!values.empty()) values.resize(count, missing);
}

bool hasThreeDistinct(const std::vector<std::uint32_t>& corners, std::size_t begin)
{
  const auto first = corners.begin() + static_cast<std::ptrdiff_t>(begin);
  if (first == corners.end()) return false;
  const auto second = std::find_if(first, corners.end(), [&](auto v) { return v != *first; });
  return std::any_of(second, corners.end(), [&](auto v) { return v != *first && v != *second; });
}

}  // namespace

ArrayImporter::ArrayImporter(Source& source, const NormalForm& form)
    : source_(source),
      form_(form),
      cornersHaveAttributes_(form.parser == Parser::kObj && (form.hasNormals || form.hasTexCoords))
{
}

void ArrayImporter::reportProgress()
{
  const std::size_t total = form_.vertexCount + form_.faceCount;
  source_.reportParsed(std::min(n_vertices() + n_faces(), total), total);
}

std::size_t ArrayImporter::indexOf(OpenMesh::VertexHandle vertex) const
{
  const std::size_t index = static_cast<std::size_t>(vertex.idx());
  if (vertex.idx() >= 0 && index < mesh_.positions.size()) return index;
  source_.fail("a face or an edge names vertex " + std::to_string(vertex.idx()) +
                   ", but there are " + std::to_string(mesh_.positions.size()) +
                   " and they count from 0",
               Error::kIndexOutOfRange);
}

std::size_t ArrayImporter::indexOf(OpenMesh::HalfedgeHandle halfedge) const
{
  const std::size_t index = static_cast<std::size_t>(halfedge.idx());
  if (halfedge.idx() >= 0 && index < halfedges_.size()) return index;
  source_.fail("a face or an edge names half-edge " + std::to_string(halfedge.idx()) +
                   ", but there are " + std::to_string(halfedges_.size()) +
                   " and they count from 0",
               Error::kIndexOutOfRange);
}

OpenMesh::VertexHandle ArrayImporter::add_vertex(const OpenMesh::Vec3f& point)
{
  mesh_.positions.push_back(vec3(point));
  reportProgress();
  return OpenMesh::VertexHandle(static_cast<int>(mesh_.positions.size() - 1));
}

OpenMesh::VertexHandle ArrayImporter::add_vertex()
{
  return add_vertex(OpenMesh::Vec3f(0, 0, 0));
}

void ArrayImporter::set_point(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& point)
{
  mesh_.positions[indexOf(vertex)] = vec3(point);
}

OpenMesh::FaceHandle ArrayImporter::add_face(const VHandles& vertices)
{
  if (form_.parser == Parser::kObj) {
    for (std::size_t i = 0; i < announcedVertices_.size(); ++i) {
      addCorner(announcedVertices_[i], announcedAttributes_[i]);
    }
    announcedVertices_.clear();
    announcedAttributes_.clear();
  } else {
    for (const OpenMesh::VertexHandle vertex : vertices)
      addCorner(indexOf(vertex), {});
  }
  return closeFace();
}

void ArrayImporter::addCorner(std::size_t vertex, const CornerAttributes& attributes)
{
  mesh_.corners.push_back(static_cast<std::uint32_t>(vertex));
  if (cornersHaveAttributes_) mesh_.cornerAttributes.push_back(attributes);
}

OpenMesh::FaceHandle ArrayImporter::closeFace()
{
  const std::size_t begin = static_cast<std::size_t>(mesh_.offsets.back());
  if (!hasThreeDistinct(mesh_.corners, begin)) {
    mesh_.corners.resize(begin);
    if (cornersHaveAttributes_) mesh_.cornerAttributes.resize(begin);
    return OpenMesh::FaceHandle();
  }
  mesh_.offsets.push_back(mesh_.corners.size());
  reportProgress();
  return OpenMesh::FaceHandle(static_cast<int>(mesh_.faceCount() - 1));
}

OpenMesh::HalfedgeHandle ArrayImporter::add_edge(OpenMesh::VertexHandle from,
                                                 OpenMesh::VertexHandle to)
{
  const OpenMesh::HalfedgeHandle first(static_cast<int>(halfedges_.size()));
  for (const OpenMesh::VertexHandle target : {to, from}) {
    Halfedge halfedge;
    halfedge.to = static_cast<std::uint32_t>(indexOf(target));
    halfedges_.push_back(halfedge);
  }
  return first;
}

void ArrayImporter::set_next(OpenMesh::HalfedgeHandle halfedge, OpenMesh::HalfedgeHandle next)
{
  halfedges_[indexOf(halfedge)].next = indexOf(next);
}

OpenMesh::FaceHandle ArrayImporter::add_face(OpenMesh::HalfedgeHandle halfedge)
{
  faceHalfedges_.push_back(indexOf(halfedge));
  return OpenMesh::FaceHandle(static_cast<int>(faceHalfedges_.size() - 1));
}

void ArrayImporter::set_texcoord(OpenMesh::HalfedgeHandle halfedge, const OpenMesh::Vec2f& texCoord)
{
  Halfedge& target = halfedges_[indexOf(halfedge)];
  target.texCoord = {texCoord[0], texCoord[1]};
  target.hasTexCoord = true;
  cornersHaveAttributes_ = true;
}

void ArrayImporter::walkFace(std::size_t face)
{
  std::size_t i = faceHalfedges_[face];
  do {
    Halfedge& halfedge = halfedges_[i];
    if (halfedge.isVisited) {
      source_.fail("the half-edges of face " + std::to_string(face) +
                   " do not form a ring of "
                   "their own; the file is damaged");
    }
    halfedge.isVisited = true;
    CornerAttributes attributes;
    attributes.hasTexCoord = halfedge.hasTexCoord;
    attributes.texCoord = halfedge.texCoord;
    addCorner(halfedge.to, attributes);
    i = halfedge.next;
  } while (i != faceHalfedges_[face]);
}

void ArrayImporter::set_normal(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& normal)
{
  const std::size_t index = indexOf(vertex);
  if (form_.parser != Parser::kObj) {
    grownElement(mesh_.normals, index, Vec3f{}) = vec3(normal);
  } else if (!announcedAttributes_.empty()) {
    announcedAttributes_.back().normal = vec3(normal);
    announcedAttributes_.back().hasNormal = true;
  }
}

void ArrayImporter::set_normal(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3d& normal)
{
  set_normal(vertex, OpenMesh::Vec3f(normal));
}

void ArrayImporter::set_texcoord(OpenMesh::VertexHandle vertex, const OpenMesh::Vec2f& texCoord)
{
  const std::size_t index = indexOf(vertex);
  const TexCoord value{texCoord[0], texCoord[1]};
  if (form_.parser != Parser::kObj) {
    grownElement(mesh_.texCoords, index, TexCoord{}) = value;
  } else if (!announcedAttributes_.empty()) {
    announcedAttributes_.back().texCoord = value;
    announcedAttributes_.back().hasTexCoord = true;
  }
}

void ArrayImporter::setVertexColor(OpenMesh::VertexHandle vertex, Rgba8 color)
{
  const std::size_t index = indexOf(vertex);
  if (form_.parser == Parser::kObj) {
    announcedVertices_.push_back(static_cast<std::uint32_t>(index));
    announcedAttributes_.emplace_back();
  }
  if (form_.hasVertexColors) grownElement(mesh_.vertexColors, index, kWhite) = color;
}

void ArrayImporter::setFaceColor(OpenMesh::FaceHandle face, Rgba8 color)
{
  // The parsers colour a face that was refused, too.
  if (!face.is_valid()) return;
  grownElement(faceColors_, static_cast<std::size_t>(face.idx()), kWhite) = color;
}

void ArrayImporter::set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3uc& color)
{
  setVertexColor(vertex, {color[0], color[1], color[2], 255});
}
void ArrayImporter::set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec4uc& color)
{
  setVertexColor(vertex, {color[0], color[1], color[2], color[3]});
}
void ArrayImporter::set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec3f& color)
{
  setVertexColor(vertex, {channel(color[0]), channel(color[1]), channel(color[2]), 255});
}
void ArrayImporter::set_color(OpenMesh::VertexHandle vertex, const OpenMesh::Vec4f& color)
{
  setVertexColor(vertex,
                 {channel(color[0]), channel(color[1]), channel(color[2]), channel(color[3])});
}
void ArrayImporter::set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec3uc& color)
{
  setFaceColor(face, {color[0], color[1], color[2], 255});
}
void ArrayImporter::set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec4uc& color)
{
  setFaceColor(face, {color[0], color[1], color[2], color[3]});
}
void ArrayImporter::set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec3f& color)
{
  setFaceColor(face, {channel(color[0]), channel(color[1]), channel(color[2]), 255});
}
void ArrayImporter::set_color(OpenMesh::FaceHandle face, const OpenMesh::Vec4f& color)
{
  setFaceColor(face, {channel(color[0]), channel(color[1]), channel(color[2]), channel(color[3])});
}

RawMesh ArrayImporter::finishMesh()
{
  if (faceHalfedges_.empty()) {
    mesh_.faceColors = std::move(faceColors_);
  } else {
    complete(faceColors_, faceHalfedges_.size(), kWhite);
    for (std::size_t face = 0; face < faceHalfedges_.size(); ++face) {
      walkFace(face);
      const bool isKept = closeFace().is_valid();
      if (isKept && !faceColors_.empty()) mesh_.faceColors.push_back(faceColors_[face]);
    }
  }
  complete(mesh_.normals, mesh_.positions.size(), Vec3f{});
  complete(mesh_.texCoords, mesh_.positions.size(), TexCoord{});
  complete(mesh_.vertexColors, mesh_.positions.size(), kWhite);
  complete(mesh_.faceColors, mesh_.faceCount(), kWhite);
  return std::move(mesh_);
}

}  // namespace limn::meshio
