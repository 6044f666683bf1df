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
  std::vector<Triangle> triangles;     ///< broken ones have three times the same point
  std::vector<std::uint32_t> body;     ///< of each triangle
  std::vector<WorldEdge> edges;        ///< of bodies that have been asked for, in their order
  std::vector<std::size_t> firstEdge;  ///< by body, and the end
  double size = 0;                     ///< the diagonal of the box of all that is not broken

  bool isBroken(std::size_t triangle) const
  {
    return triangles[triangle].vertex[0] == triangles[triangle].vertex[1];
  }
  Vec3d corner(std::size_t triangle, int k) const { return points[triangles[triangle].vertex[k]]; }
};

/// `wantsEdges` by body. Errors: kTooManyPrimitives for 2^32 / 3 triangles and more.
Status buildWorldMesh(Span<const PlacedMesh> meshes, Span<const std::uint8_t> wantsEdges,
                      int threads, WorldMesh& world);

}  // namespace limn
