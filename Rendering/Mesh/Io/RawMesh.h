// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/MeshFile.h"

#include <cstdint>
#include <vector>

namespace limn::meshio {

/// What one corner of a face knows by itself.
struct CornerAttributes {
  bool hasNormal = false;
  bool hasTexCoord = false;
  Vec3f normal{};
  TexCoord texCoord{};
};

/// What a parser found, before corners that disagree split their vertex. Arrays as in MeshFile.
struct RawMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<TexCoord> texCoords;
  std::vector<Rgba8> vertexColors;
  std::vector<Rgba8> faceColors;
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint32_t> corners;
  std::vector<CornerAttributes> cornerAttributes;  ///< one for each corner, or none

  std::size_t faceCount() const { return offsets.size() - 1; }
};

}  // namespace limn::meshio
