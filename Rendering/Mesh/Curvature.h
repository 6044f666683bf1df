// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Mesh/MeshView.h"

namespace limn {

/// How a surface bends at a vertex. Curvatures are positive where it bulges outwards.
struct VertexCurvature {
  Vec3f direction[2];  ///< principal, unit, perpendicular to the normal and to each other
  float curvature[2];  ///< along them, 1 / length; the first is the larger by size
  /// Of the curvature tensor along the principal directions: D_1 k_1, then mixed, to D_2 k_2.
  float derivative[4];
};

/// Curvature and its derivative at each vertex, after Rusinkiewicz 2004: per face the tensor that
/// fits the differences of its vertex normals best, by least squares; at a vertex the mean over
/// its faces, each turned into the vertex' plane and weighed by the part of its area that is
/// nearest to the vertex; and the derivative likewise from differences of tensors.
/// `normals` are unit, one per vertex. Vertices without a proper face get zeros, as do those with
/// one that is broken. The same bits on any number of threads.
/// Requires: fewer than 2^32 / 3 triangles.
Array<VertexCurvature> vertexCurvature(const MeshView& mesh, Span<const Vec3f> normals,
                                       int threads);

}  // namespace limn
