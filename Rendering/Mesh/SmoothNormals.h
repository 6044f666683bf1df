// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Mesh/MeshView.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace limn {

inline constexpr int kMaxSmoothLevels = 8;
/// Most steps from one level's scale to the next: its powers up to the fourth stay within a float.
inline constexpr float kMaxSmoothRatio = 16;

/// A unit vector on the octahedron |x| + |y| + |z| = 1, whose lower half is folded outwards
/// (Meyer et al. 2010): x and y in 1/32767, the lower 16 bits and the upper. To 7e-5.
std::uint32_t packedNormal(Vec3d normal);

/// Unit, but for rounding.
inline Vec3f unpackedNormal(std::uint32_t packed)
{
  constexpr float kUnit = 1.0f / 32767.0f;
  const auto low = static_cast<std::int16_t>(packed & 0xFFFFu);
  const auto high = static_cast<std::int16_t>(packed >> 16);
  const float x = static_cast<float>(low) * kUnit, y = static_cast<float>(high) * kUnit;
  const float z = 1.0f - (std::fabs(x) + std::fabs(y));
  const float fold = z < 0.0f ? -z : 0.0f;
  return normalized(Vec3f{x < 0.0f ? x + fold : x - fold, y < 0.0f ? y + fold : y - fold, z});
}

/// How far smoothNormals() goes.
struct SmoothScales {
  int levels = 5;  ///< 1 to kMaxSmoothLevels
  /// sigma of the coarsest level as a share of the square root of the mesh's area, above 0.
  float coarsest = 0.06f;
  /// Nothing is spread over edges whose two faces' normals are farther apart, 0 to 180.
  double creaseDegrees = 180;

  bool operator==(const SmoothScales& other) const
  {
    return levels == other.levels && coarsest == other.coarsest &&
           creaseDegrees == other.creaseDegrees;
  }
};

/// What normals are smoothed on.
struct SmoothedSurface {
  MeshView mesh;
  /// One a vertex, of any length. Empty: area-weighted ones.
  Span<const Vec3f> normals = {};
  Span<const std::uint32_t> cells = {};  ///< as in Attributes; no crease is inside of a cell
};

/// Normals at several scales: of number i those at i * levels, the finest first.
struct SmoothNormals {
  std::vector<std::uint32_t> packed;
  /// Three a triangle: the number of each corner's, Attributes::smoothOfCorner. Empty, as where
  /// there are no creases: that of its vertex.
  std::vector<std::uint32_t> ofCorner;
  int levels = 0;
  /// From sigma to the next level's. That of the finest level is the mean distance of neighbours,
  /// (2 A / (sqrt(3) V))^1/2 of a mesh of area A and V vertices.
  float ratio = 1;

  /// Attributes::smoothCount
  std::size_t count() const
  {
    return levels > 0 ? packed.size() / static_cast<std::size_t>(levels) : 0;
  }
};

/// The vertex normals spread over the surface as heat spreads, so that a level of sigma is their
/// mean by the Gaussian of that deviation, along the surface; exp(-t L) n for t = sigma^2 / 2 and
/// the Laplacian L by cotangents of angles (Pinkall and Polthier 1993), by its expansion in
/// Chebyshev's polynomials of L, to 1e-3. Scales are in even ratios from the mean distance of
/// neighbours to `coarsest`, but the ratio is at least sqrt(2) and the coarsest at most 32
/// distances. Where vertices lie much denser than in the mean, the deviation is less.
///
/// Vertices in one place have one normal, but for where creases part the triangles about it, so
/// that a flat face between them keeps its own at all scales. Where normals are given, an edge is a
/// crease only if they differ on its two sides: else they say that it is smooth. Triangles as for
/// vertexNormals(). The same bits on any number of threads. While it runs it takes 150 to 200 bytes
/// a vertex.
/// Errors: those of buildEdgeTable().
Status smoothNormals(const SmoothedSurface& surface, const SmoothScales& scales, int threads,
                     SmoothNormals& smooth);

}  // namespace limn
