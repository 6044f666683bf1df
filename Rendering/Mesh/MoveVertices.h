// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"
#include "Rendering/Mesh/VertexShader.h"

#include <cstddef>
#include <vector>

namespace limn {

/// Where a shader has moved a mesh's vertices.
struct MovedVertices {
  // As MeshView's, of which one is empty.
  std::vector<Vec3f> positions;
  std::vector<Vec3d> precisePositions;
  std::vector<Vec3f> normals;  ///< empty unless the shader moves normals and was given some

  /// Vertices whose position became NaN or infinite, or too large for a float mesh.
  std::size_t lostVertices = 0;
  std::size_t firstLost = 0;  ///< the first of them

  MeshView view(Span<const Triangle> triangles) const
  {
    return {positions, precisePositions, triangles};
  }
};

/// Runs the shader over all vertices, on at most `threads` threads (0: all); the result does not
/// depend on it. It stays good until the mesh or the shader changes. Clusters follow by
/// refitClusters() or buildClusters(), which leaves out the triangles of lost vertices; normals, if
/// none come out, by vertexNormals().
/// Requires: normals.size() is mesh.vertexCount() or 0.
void moveVertices(const VertexShader& shader, const MeshView& mesh, Span<const Vec3f> normals,
                  int threads, MovedVertices& moved);

}  // namespace limn
