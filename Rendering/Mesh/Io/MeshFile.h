// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"
#include "Rendering/Scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// (0, 0) is the lower left of the picture.
struct TexCoord {
  float u, v;
};

/// A polygon mesh as a file gives it. Owns its arrays. Attribute arrays are empty where the file
/// has none of that kind, else they have one value for each vertex or each polygon.
struct MeshFile {
  /// Exactly one of these two is not empty. Coordinates are double only where float would move
  /// vertices by more than 2^-20 of the mesh's diagonal, i.e. far from the origin.
  std::vector<Vec3f> positions;
  std::vector<Vec3d> precisePositions;

  std::vector<Vec3f> normals;  ///< as the file gives them, not normalized
  std::vector<TexCoord> texCoords;
  std::vector<Rgba8> vertexColors;
  std::vector<Rgba8> faceColors;

  /// Polygon i has the corners polygonCorners[polygonOffsets[i] .. polygonOffsets[i + 1]), in the
  /// order of the file, with at least 3 different vertices; polygonOffsets starts with 0.
  std::vector<std::uint64_t> polygonOffsets;
  std::vector<std::uint32_t> polygonCorners;

  /// Polygons that run along an edge in the same direction as one before them: a third face on an
  /// edge, a repeated face, a face wound the other way than its neighbour. A half-edge mesh refuses
  /// these; here they are kept as they are and only counted.
  std::size_t nonManifoldFaces = 0;
  /// Polygons left out because they have fewer than 3 different vertices.
  std::size_t droppedFaces = 0;
  /// Vertices added because corners at one vertex disagree on normal or texture coordinates.
  std::size_t splitVertices = 0;

  std::size_t vertexCount() const { return positions.size() + precisePositions.size(); }
  std::size_t polygonCount() const
  {
    return polygonOffsets.empty() ? 0 : polygonOffsets.size() - 1;
  }
};

}  // namespace limn
