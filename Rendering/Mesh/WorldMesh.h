// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Mesh/EdgeTable.h"

#include <vector>

/// Meshes put together in the world, for what they do to each other: shadows and intersections.
namespace limn {

struct PlacedMesh {
  MeshView mesh;
  Mat4d modelToWorld;
};

/// An edge of a body between two points, the lower first.
struct WorldEdge {
  std::uint32_t point[2];
  std::uint32_t triangle[2];  ///< the second kNoCorner at a border
  bool isWoundAlike;          ///< of two triangles: whether they run along it in opposite ways
};

/// Points of one body in one place are one; bodies share none.
struct WorldMesh {
  std::vector<Vec3d> points;
  /// Broken ones have three times the same point. Of closed bodies with edges all are wound the
  /// other way if they were inside out.
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> body;     ///< of each triangle
  std::vector<WorldEdge> edges;        ///< of bodies that have been asked for, in their order
  std::vector<std::size_t> firstEdge;  ///< by body, and the end
  std::vector<std::uint8_t> isClosed;  ///< by body: whether it has edges and none is a border
  double size = 0;                     ///< the diagonal of the box of all that is not broken

  bool isBroken(std::size_t triangle) const
  {
    return triangles[triangle].vertex[0] == triangles[triangle].vertex[1];
  }
  Vec3d corner(std::size_t triangle, int k) const { return points[triangles[triangle].vertex[k]]; }
};

/// Vertex normals of a WorldMesh as contours have them.
struct WorldNormals {
  std::vector<Vec3f> normals;           ///< unit, or zero
  std::vector<std::uint32_t> ofCorner;  ///< three a triangle

  Vec3f at(std::size_t triangle, int k) const
  {
    return normals[ofCorner[3 * triangle + static_cast<std::size_t>(k)]];
  }
};

/// `wantsEdges` by body. Errors: kTooManyPrimitives for 2^32 / 3 triangles and more.
Status buildWorldMesh(Span<const PlacedMesh> meshes, Span<const std::uint8_t> wantsEdges,
                      int threads, WorldMesh& world);

/// splitVertexNormals() of each body, by angles, apart at edges of more than `creaseDegrees`, by
/// body. Errors: as that.
Status worldNormals(const WorldMesh& world, Span<const double> creaseDegrees, int threads,
                    WorldNormals& normals);

}  // namespace limn
