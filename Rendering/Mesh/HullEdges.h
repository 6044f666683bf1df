// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

namespace limn {

/// An edge of two triangles that point away from each other: from some side it is the outline. Or a
/// border, whose triangle is named twice, unless others lie all along it but for rounding. Edges
/// between coplanar triangles and in hollows are none.
struct HullEdge {
  std::uint32_t vertex[2];    ///< as HullEdges::weld names them
  std::uint32_t triangle[2];  ///< the first has the edge from vertex[0] to vertex[1]
};

/// What an inverted hull needs of a mesh, whatever the view; see Instance::hull.
struct HullEdges {
  Vec3d origin = {0, 0, 0};  ///< localOrigin() of the mesh
  /// Per vertex: the first that lies in the same place, to the bit. So meshes whose triangles have
  /// their vertices apart, or whose normals are split, are closed, too.
  std::vector<std::uint32_t> weld;
  /// Per triangle: unit, outward; zero for one that cannot be drawn or has no area. A closed mesh
  /// that is inside out is turned; so are triangles that are not wound as their neighbours.
  std::vector<Vec3f> normal;
  std::vector<HullEdge> edges;
};

/// Ensures: the same result on any number of threads (0: all). An edge of more than two triangles
/// joins each with the first after it that has the edge the other way round, and has no border.
/// Errors: kTooManyPrimitives for 2^32 / 3 triangles and more; `hull` is as it was then.
Status buildHullEdges(const MeshView& mesh, int threads, HullEdges& hull);

}  // namespace limn
