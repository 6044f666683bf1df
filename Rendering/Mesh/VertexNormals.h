// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Status.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

/// Normals of vertices as sums over the triangles around them. Sums run in double in the order of
/// the triangles: the same bits every time, on any number of threads. Triangles with a vertex out
/// of range or not finite are left out, as are those without area.
namespace limn {

/// How much a triangle counts at its corner.
enum class NormalWeight : std::uint8_t {
  kUniform,  ///< the same for all (Gouraud 1971)
  kArea,     ///< its area: (p1 - p0) x (p2 - p0) is summed as it is
  kAngle,    ///< its angle there (Thuermer and Wuethrich 1998), which no triangulation changes
};

/// Unit normal per vertex. Vertices without a proper triangle get the zero vector.
std::vector<Vec3f> vertexNormals(const MeshView& mesh, NormalWeight weight);

struct SplitNormals {
  std::vector<Vec3f> normals;     ///< unit, or zero; a vertex may have several
  Array<std::uint32_t> ofCorner;  ///< three a triangle: Attributes::normalOfCorner
};
inline constexpr std::uint32_t kNoOnlyNormal = 0xFFFFFFFFu;

/// As vertexNormals(), but apart on the two sides of a feature edge: a corner's normal is the sum
/// over those triangles around its vertex that are reached from its own over edges whose two
/// triangles' normals are at most `featureDegrees`, 0 to 180, apart, or are of one cell. `cells` as
/// in Attributes. An edge of more than two triangles joins each with the next in their order.
/// `only`, or null, gets by vertex the number of the normal that all its corners have, or
/// kNoOnlyNormal. Errors: kTooManyPrimitives for 2^32 / 3 triangles and more; `split` and `only`
/// are as they were then.
Status splitVertexNormals(const MeshView& mesh, Span<const std::uint32_t> cells,
                          NormalWeight weight, double featureDegrees, int threads,
                          SplitNormals& split, Array<std::uint32_t>* only = nullptr);

/// The vertex of each normal of splitVertexNormals(): it has one.
std::vector<std::uint32_t> verticesOfNormals(const MeshView& mesh, const SplitNormals& split);

}  // namespace limn
