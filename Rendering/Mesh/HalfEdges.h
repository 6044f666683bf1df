// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"
#include "Rendering/Mesh/SortByVertex.h"

#include <algorithm>
#include <cstdint>

namespace limn {

/// One side of a triangle, listed at the lower of its two places.
struct HalfEdge {
  std::uint32_t end;     ///< the higher place
  std::uint32_t corner;  ///< three times the triangle's number and the corner that it starts at
};

/// The sides of a mesh's triangles, by place; `place` is that of each vertex (WeldVertices.h).
class HalfEdges {
 public:
  /// Of the triangles that isUsed(number) names. Requires: fewer than 2^32 / 3 triangles, and of
  /// those that are used vertices that exist.
  template <class IsUsed>
  HalfEdges(const MeshView& mesh, Span<const std::uint32_t> place, int threads,
            const IsUsed& isUsed)
      : sorted_(sortByVertex<HalfEdge>(
            mesh.vertexCount(), mesh.triangles.size(), threads,
            [&](std::size_t begin, std::size_t end, const auto& visit) {
              for (std::size_t t = begin; t < end; ++t) {
                if (!isUsed(t)) continue;
                const auto& vertex = mesh.triangles[t].vertex;
                for (std::uint32_t k = 0; k < 3; ++k) {
                  const std::uint32_t a = place[vertex[k]], b = place[vertex[(k + 1) % 3]];
                  visit(std::min(a, b),
                        HalfEdge{std::max(a, b), static_cast<std::uint32_t>(3 * t) + k});
                }
              }
            }))
  {
  }

  /// Those at a place, sorted by end and corner; once a place, as they are sorted only now.
  Span<HalfEdge> sorted(std::size_t v)
  {
    HalfEdge* const begin = sorted_.items.data() + sorted_.first[v];
    HalfEdge* const end = sorted_.items.data() + sorted_.first[v + 1];
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.end != b.end ? a.end < b.end : a.corner < b.corner;
    });
    return {begin, static_cast<std::size_t>(end - begin)};
  }
  /// Those at a place, as they have been sorted.
  Span<const HalfEdge> of(std::size_t v) const
  {
    return {sorted_.items.data() + sorted_.first[v], sorted_.first[v + 1] - sorted_.first[v]};
  }

 private:
  ItemsByVertex<HalfEdge> sorted_;
};

}  // namespace limn
