// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/BitCount.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <cstdint>

namespace limn {

/// Units of a mesh that follow each other in it and begin in one cell of the curve. A unit is a
/// triangle, or two in a row that share an edge, as the halves of a quadrilateral do: kept
/// together, they save a cluster vertices at its border.
struct TriangleGroup {
  static constexpr std::size_t kMaxUnits = 8;
  static constexpr int kUnitsBits = 3, kShapeBits = kUnitsBits + static_cast<int>(kMaxUnits);

  /// From the highest bit on: the cell's place on the curve, the number of units less 1, and for
  /// each unit, the first's bit being the lowest, whether it has two triangles.
  std::uint32_t bits;
  std::uint32_t first;  ///< of the mesh's triangles

  std::size_t units() const { return 1 + (bits >> kMaxUnits & ((1u << kUnitsBits) - 1)); }
  std::size_t triangles() const { return units() + bitCount(pairs()); }
  /// Bit u: whether unit u has two triangles.
  std::uint32_t pairs() const { return bits & ((1u << kMaxUnits) - 1); }
};

/// The drawable triangles of a mesh along a Morton curve, so that neighbours in the list are mostly
/// neighbours in space.
struct SortedTriangles {
  Array<TriangleGroup> groups;
  std::size_t outOfRange = 0, notFinite = 0;  ///< left out, as ClusteredMesh counts them
};

/// `box` and `origin` are the mesh's own (LocalPosition.h). The result does not depend on
/// `threads`.
SortedTriangles sortTriangles(const MeshView& mesh, const FiniteBox& box, Vec3d origin,
                              int threads);

}  // namespace limn
