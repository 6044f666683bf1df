// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"
#include "Rendering/Base/Vec.h"

#include <cstdint>

namespace limn {

/// Vertex numbers of one triangle, counter-clockwise seen from outside.
struct Triangle {
  std::uint32_t vertex[3];
};

/// A borrowed triangle mesh, in draw order: of coplanar triangles the later is seen.
/// Exactly one of `positions` and `precisePositions` is not empty; the second is for data given in
/// double, e.g. survey coordinates far from the origin.
struct MeshView {
  Span<const Vec3f> positions;
  Span<const Vec3d> precisePositions;
  Span<const Triangle> triangles;

  std::size_t vertexCount() const { return positions.size() + precisePositions.size(); }
  Vec3d position(std::size_t vertex) const
  {
    return positions.empty() ? precisePositions[vertex] : vec3Cast<double>(positions[vertex]);
  }
};

}  // namespace limn
