// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/PlyForm.h"

#include <cstring>
#include <utility>

namespace limn::meshio {
namespace {

void appendColor(std::string& bytes, Rgba8 color)
{
  for (const std::uint8_t channel : {color.r, color.g, color.b, color.a}) {
    bytes += static_cast<char>(channel);
  }
}

constexpr const char* kColorProperties =
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";

}  // namespace

void appendUint32(std::string& bytes, std::uint32_t value)
{
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(value >> shift & 0xffu);
}

void appendFloat(std::string& bytes, float value)
{
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  appendUint32(bytes, bits);
}

void PlyForm::addVertex(const Vertex& vertex)
{
  positions_.push_back(vertex.position);
  const Vec3f position = vec3Cast<float>(vertex.position);
  for (const float value : {position.x, position.y, position.z})
    appendFloat(vertices_, value);
  if (attributes_.normals) {
    for (const float value : {vertex.normal.x, vertex.normal.y, vertex.normal.z}) {
      appendFloat(vertices_, value);
    }
  }
  if (attributes_.texCoords) {
    appendFloat(vertices_, vertex.texCoord.u);
    appendFloat(vertices_, vertex.texCoord.v);
  }
  if (attributes_.vertexColors) appendColor(vertices_, vertex.color);
}

void PlyForm::addFace(Span<const std::uint32_t> corners, Rgba8 color)
{
  ++faceCount_;
  appendUint32(faces_, static_cast<std::uint32_t>(corners.size()));
  for (const std::uint32_t corner : corners)
    appendUint32(faces_, corner);
  if (attributes_.faceColors) appendColor(faces_, color);
}

std::string PlyForm::header() const
{
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += "element vertex " + std::to_string(positions_.size()) + "\n";
  text += "property float x\nproperty float y\nproperty float z\n";
  if (attributes_.normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (attributes_.texCoords) text += "property float u\nproperty float v\n";
  if (attributes_.vertexColors) text += kColorProperties;
  text += "element face " + std::to_string(faceCount_) + "\n";
  text += "property list int int vertex_indices\n";
  if (attributes_.faceColors) text += kColorProperties;
  return text + "end_header\n";
}

NormalForm PlyForm::finish()
{
  NormalForm form;
  form.parser = Parser::kPly;
  form.bytes = header();
  form.bytes.reserve(form.bytes.size() + vertices_.size() + faces_.size());
  form.bytes += vertices_;
  form.bytes += faces_;
  form.vertexCount = positions_.size();
  form.faceCount = faceCount_;
  form.positions = std::move(positions_);
  form.hasNormals = attributes_.normals;
  form.hasTexCoords = attributes_.texCoords;
  form.hasVertexColors = attributes_.vertexColors;
  form.hasFaceColors = attributes_.faceColors;
  return form;
}

}  // namespace limn::meshio
