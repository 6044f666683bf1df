// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/NormalForm.h"
#include "Rendering/Base/Span.h"
#include "Rendering/Mesh/Io/MeshFile.h"

#include <cstdint>

namespace limn::meshio {

/// Appends in little-endian order.
void appendUint32(std::string& bytes, std::uint32_t value);
void appendFloat(std::string& bytes, float value);

/// Writes the one layout of PLY that everything readable as PLY is brought to: binary, little
/// endian, float positions, normals and texture coordinates, 8-bit RGBA, 32-bit indices.
class PlyForm {
 public:
  struct Attributes {
    bool normals = false;
    bool texCoords = false;
    bool vertexColors = false;
    bool faceColors = false;
  };
  struct Vertex {
    Vec3d position{};
    Vec3f normal{};
    TexCoord texCoord{};
    Rgba8 color{255, 255, 255, 255};
  };

  explicit PlyForm(Attributes attributes) : attributes_(attributes) {}

  void addVertex(const Vertex& vertex);
  void addFace(Span<const std::uint32_t> corners, Rgba8 color);
  NormalForm finish();

 private:
  std::string header() const;

  Attributes attributes_;
  std::vector<Vec3d> positions_;
  std::size_t faceCount_ = 0;
  std::string vertices_;
  std::string faces_;
};

}  // namespace limn::meshio
