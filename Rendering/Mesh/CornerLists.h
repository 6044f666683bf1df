// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"
#include "Rendering/Mesh/SortByVertex.h"

#include <cstdint>

namespace limn {

/// For each vertex the corners that triangles have there, ascending: three times the triangle's
/// number and 0 to 2.
class CornerLists {
 public:
  /// Of the triangles that isUsed(number) names, without corners at vertices that do not exist.
  /// Requires: fewer than 2^32 / 3 triangles. The same on any number of threads.
  template <class IsUsed>
  CornerLists(const MeshView& mesh, int threads, const IsUsed& isUsed)
      : lists_(sortByVertex<std::uint32_t>(
            mesh.vertexCount(), mesh.triangles.size(), threads,
            [&](std::size_t begin, std::size_t end, const auto& visit) {
              const std::size_t vertices = mesh.vertexCount();
              for (std::size_t t = begin; t < end; ++t) {
                if (!isUsed(t)) continue;
                for (std::uint32_t k = 0; k < 3; ++k)
                  if (const std::uint32_t v = mesh.triangles[t].vertex[k]; v < vertices)
                    visit(v, static_cast<std::uint32_t>(3 * t) + k);
              }
            }))
  {
  }

  Span<const std::uint32_t> of(std::size_t vertex) const
  {
    const std::uint32_t first = lists_.first[vertex];
    return {lists_.items.data() + first, lists_.first[vertex + 1] - first};
  }

 private:
  ItemsByVertex<std::uint32_t> lists_;
};

}  // namespace limn
