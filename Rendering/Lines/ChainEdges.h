// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/LineSet.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Scene.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Owns what a LineSet borrows. Closed chains end with the vertex that they begin with.
struct LineChains {
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> first;
  std::vector<std::uint8_t> flags;  ///< empty, or one for each of `vertex`

  bool empty() const { return vertex.empty(); }
  /// Lines through the mesh's vertices. `mesh` is borrowed too.
  LineSet lines(const MeshView& mesh, const LineStyle& style) const
  {
    return {mesh, vertex, first, flags, {}, style};
  }
};

/// A pair of points, and what made it.
struct LineLink {
  std::uint32_t a, b;
  std::uint32_t source;
};

/// Joins links into chains. A chain goes on where exactly two links meet, and ends elsewhere.
/// `source[i]`, if not null, becomes that of the link from vertex[i]; of the last vertex of a chain
/// kNoCorner. In the order of the links.
void chainLinks(Span<const LineLink> links, std::size_t pointCount, LineChains& chains,
                std::vector<std::uint32_t>* source);

/// Chains of edges of a mesh, and which edges they are made of.
struct EdgeChains {
  LineChains chains;
  std::vector<std::uint32_t> edge;  ///< by vertex of the chains
};

/// Of the edges of these numbers, in ascending order.
EdgeChains chainEdges(const EdgeTable& table, Span<const std::uint32_t> edges);

/// Of all edges with one of `kinds`, a sum of EdgeKinds.
EdgeChains chainEdges(const EdgeTable& table, Span<const std::uint8_t> kindsOfEdges,
                      unsigned kinds);

/// Sets kOuterLine where of an edge's two faces one is seen from its front and the other from its
/// back, however they are wound, and at borders.
void markOuterEdges(const MeshView& mesh, const EdgeTable& table, const Camera& camera,
                    const Mat4d& modelToWorld, EdgeChains& chains);

}  // namespace limn
