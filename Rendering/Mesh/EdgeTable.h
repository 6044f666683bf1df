// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Status.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

namespace limn {

inline constexpr std::uint32_t kNoCorner = 0xFFFFFFFFu;

/// An edge between two places, the lower first. A face at it is named by the corner at which it
/// sets out along the edge: three times the triangle's number and 0 to 2.
struct MeshEdge {
  std::uint32_t vertex[2];
  std::uint32_t corner[2];  ///< of the two first triangles; the second kNoCorner at a border
  std::uint32_t faceCount;  ///< 1 or more

  bool isShared() const { return faceCount > 1; }
};

/// Where a triangle's edge from a corner ends.
inline std::uint32_t nextCorner(std::uint32_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// The edges of a mesh whose vertices are welded, in the order of their places. Triangles with a
/// vertex out of range, not finite, or two corners in one place are left out.
struct EdgeTable {
  std::vector<std::uint32_t> place;  ///< by vertex: see weldVertices()
  Array<MeshEdge> edges;
  Array<std::uint32_t> firstEdge;        ///< by place, and one more: of those it is the lower of
  std::vector<std::uint8_t> woundAlike;  ///< by edge: isWoundAlike() of those that are shared

  /// Number of the edge between two places, low < high; kNoCorner if there is none.
  std::uint32_t edgeBetween(std::uint32_t low, std::uint32_t high) const
  {
    for (std::uint32_t e = firstEdge[low]; e < firstEdge[low + 1]; ++e)
      if (edges[e].vertex[1] == high) return e;
    return kNoCorner;
  }
  /// Whether the face sets out from edge.vertex[0]. Faces that are wound alike run along an edge
  /// in opposite directions.
  bool runsForward(const MeshView& mesh, const MeshEdge& edge, int face) const
  {
    const std::uint32_t corner = edge.corner[face];
    return place[mesh.triangles[corner / 3].vertex[corner % 3]] == edge.vertex[0];
  }
  bool isWoundAlike(const MeshView& mesh, const MeshEdge& edge) const
  {
    return runsForward(mesh, edge, 0) != runsForward(mesh, edge, 1);
  }
};

/// `tolerance` as in weldVertices(). The same table on any number of threads. Errors:
/// kTooManyPrimitives for 2^32 / 3 triangles and more.
Status buildEdgeTable(const MeshView& mesh, double tolerance, int threads, EdgeTable& table);

/// What makes an edge one to draw.
enum EdgeKind : std::uint8_t {
  kCreaseEdge = 1,       ///< its two faces' normals are more than an angle apart
  kBorderEdge = 2,       ///< of one face
  kNonManifoldEdge = 4,  ///< of three or more
  kIdEdge = 8,           ///< its faces differ in FeatureArrays::ids
  kNormalEdge = 16,      ///< its faces have other vertex normals at one of its ends
};

/// What edgeKinds() reads beside the mesh; all may be empty.
struct FeatureArrays {
  Span<const std::uint32_t> cells;  ///< as in Attributes; edges inside of a cell have no kind
  Span<const std::uint32_t> ids;    ///< by cell: parts, materials
  Span<const Vec3f> vertexNormals;  ///< by vertex, or by normalOfCorner
  Span<const std::uint32_t> normalOfCorner;  ///< as in Attributes
  /// By vertex the one that all corners there name, or 0xFFFFFFFF; of a mesh whose vertices are
  /// welded. It tells nothing new, but at once.
  Span<const std::uint32_t> normalOfVertex;
};

/// Kinds of each edge. The angle between normals does not depend on how faces are wound; faces
/// without an area make no crease.
std::vector<std::uint8_t> edgeKinds(const MeshView& mesh, const EdgeTable& table,
                                    const FeatureArrays& arrays, double creaseDegrees, int threads);

/// Creases that hold together fewer edges than asked for are shown if one of these is sharper than
/// this, as edges of solids with few faces are.
inline constexpr double kSharpDegrees = 60;

/// Edges of `drawn` kinds hang together where they share a place. Takes kCreaseEdge from the edges
/// of groups of fewer than `fewest` edges in which all are creases and no more, of kSharpDegrees or
/// less: on rough surfaces bends exceed any angle here and there.
void dropLooseCreases(const MeshView& mesh, const EdgeTable& table, unsigned drawn,
                      std::uint32_t fewest, std::vector<std::uint8_t>& kinds);

}  // namespace limn
