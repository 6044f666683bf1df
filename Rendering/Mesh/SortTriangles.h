// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <cstdint>

namespace limn {

/// A triangle of a mesh, or two that follow each other in it and share an edge, as the halves of a
/// quadrilateral do: kept together, they save a cluster vertices at its border.
struct TriangleUnit {
  static constexpr std::uint32_t kPair = 1u << 31;

  std::uint32_t code;   ///< place on the curve, and kPair if there are two
  std::uint32_t first;  ///< of the mesh's triangles

  std::uint32_t count() const { return 1 + (code >> 31); }
};

/// The drawable triangles of a mesh along a Morton curve, so that neighbours in the list are mostly
/// neighbours in space.
struct SortedTriangles {
  Array<TriangleUnit> units;
  std::size_t outOfRange = 0, notFinite = 0;  ///< left out, as ClusteredMesh counts them
};

/// `box` and `origin` are the mesh's own (LocalPosition.h). The result does not depend on
/// `threads`.
SortedTriangles sortTriangles(const MeshView& mesh, const Box& box, Vec3d origin, int threads);

}  // namespace limn
