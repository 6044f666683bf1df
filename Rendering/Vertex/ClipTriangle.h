// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Vertex/ViewSpace.h"

namespace limn {

/// What is left of a triangle after the near plane and the guard band: a convex polygon, drawn as
/// the fan (0, i, i+1). Weights say which mixture of the triangle's corners a vertex is.
struct ClippedTriangle {
  static constexpr int kMaxVertices = 8;  // three corners and one more for each of five planes

  int count = 0;  ///< 0, or 3 to kMaxVertices
  ScreenVertex vertex[kMaxVertices];
  double weight[kMaxVertices][3];
};

/// Clips a triangle of which at least one corner needsClip. `corner[i]` must be
/// screenVertex(transform, clip[i]).
/// Ensures: two triangles with a common edge get the same new vertices on it, bit for bit (edges
/// are cut from their lexicographically smaller end), so no crack opens.
ClippedTriangle clipTriangle(const InstanceTransform& transform, const ClipPoint (&clip)[3],
                             const ScreenVertex (&corner)[3]);

}  // namespace limn
