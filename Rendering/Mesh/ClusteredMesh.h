// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

inline constexpr int kMaxClusterVertices = 64;
inline constexpr int kMaxClusterTriangles = 128;

/// A patch of neighbouring triangles with its own vertex numbering.
struct Cluster {
  Vec3f low,
      high;  ///< box of the vertices, local coordinates, low parts included (rounded outward)
  std::uint32_t firstVertex;
  std::uint32_t firstTriangle;
  std::uint8_t vertexCount;    ///< 1 ... kMaxClusterVertices
  std::uint8_t triangleCount;  ///< 1 ... kMaxClusterTriangles
};

/// The geometry of a mesh in the order in which the pipeline reads it. Built once by
/// buildClusters(); holds no attribute (normals, colours), so that changing those costs nothing.
///
///   clusters   |  c0                 |  c1             | ...
///   x, y, z    |  up to 64 vertices  |  up to 64       | ...   structure of arrays, one run a
///   cluster corner[k]  |  up to 128 bytes    |  ...                    vertex number within the
///   cluster triangle   |  up to 128 words    |  ...                    which triangle of the
///   MeshView
///
/// About 20 bytes a triangle for a closed mesh. Each array of vertices ends in kMaxClusterVertices
/// spare elements and each array of triangles in kMaxClusterTriangles, so vectors may read over a
/// cluster's end.
struct ClusteredMesh {
  Vec3d origin = {0, 0, 0};                 ///< local coordinates are relative to this point
  Vec3f low = {0, 0, 0}, high = {0, 0, 0};  ///< box of the used vertices, local coordinates
  std::vector<Cluster> clusters;
  Array<float> x, y, z;           ///< high parts
  Array<float> xLow, yLow, zLow;  ///< low parts; empty if all are zero
  Array<std::uint32_t> vertex;    ///< vertex of the MeshView
  Array<std::uint8_t> corner[3];
  Array<std::uint32_t> triangle;  ///< triangle of the MeshView

  /// Mean extent (width + height + depth) of a cluster's box, the mesh's being 1, when built.
  double builtExtent = 0;

  std::size_t triangleCount = 0;  ///< without the spare elements
  std::size_t vertexCount = 0;    ///< cluster vertices, without the spare elements

  /// Of the MeshView: attribute arrays must have this many elements.
  std::size_t meshVertexCount = 0, meshTriangleCount = 0;

  /// Triangles of the MeshView that cannot be drawn, left out and counted.
  std::size_t outOfRangeTriangles = 0;  ///< name a vertex that is not there
  std::size_t notFiniteTriangles = 0;   ///< use a vertex with a NaN or infinite coordinate

  bool hasLowParts() const { return !xLow.empty(); }
  std::size_t bytes() const;
};

}  // namespace limn
