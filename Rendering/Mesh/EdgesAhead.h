// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/EdgeTable.h"

#include <cstddef>

namespace limn {

/// Calls body(corner) for the corners that name an edge's faces, of which there are one or two.
template <class Body>
void forEachFace(const MeshEdge& edge, const Body& body)
{
  body(edge.corner[0]);
  if (edge.isShared()) body(edge.corner[1]);
}

/// Calls visit(edge's number) for the edges [first, end). What is read of so many lies far apart in
/// memory where a mesh is in no order: fetchFirst(edge) is to begin with what the edge itself
/// names, and fetchThen(edge), later but still a while before the visit, with what that names.
template <class FetchFirst, class FetchThen, class Visit>
void forEachEdgeAhead(const EdgeTable& table, std::size_t first, std::size_t end,
                      const FetchFirst& fetchFirst, const FetchThen& fetchThen, const Visit& visit)
{
  constexpr std::size_t kFirst = 24, kThen = 12;
  for (std::size_t e = first; e < end; ++e) {
    if (e + kFirst < end) fetchFirst(table.edges[e + kFirst]);
    if (e + kThen < end) fetchThen(table.edges[e + kThen]);
    visit(e);
  }
}

}  // namespace limn
