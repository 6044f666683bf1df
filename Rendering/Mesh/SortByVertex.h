// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// What triangles have at vertices: items [first[v], first[v + 1]) are those of vertex v.
template <class Item>
struct ItemsByVertex {
  std::vector<std::uint32_t> first;
  Array<Item> items;
};

/// A counting sort. forEach(visit) calls visit(vertex, item) for each item, on any threads, twice
/// the same; in which order the items of a vertex come is open. Requires: fewer than 2^32 items.
template <class Item, class ForEach>
ItemsByVertex<Item> sortByVertex(std::size_t vertexCount, const ForEach& forEach)
{
  ItemsByVertex<Item> sorted;
  std::vector<std::uint32_t>& first = sorted.first;
  first.assign(vertexCount + 1, 0);
  std::vector<std::atomic<std::uint32_t>> next(vertexCount);
  forEach([&](std::size_t vertex, const Item&) {
    next[vertex].fetch_add(1, std::memory_order_relaxed);
  });
  for (std::size_t v = 0; v < vertexCount; ++v) {
    first[v + 1] = first[v] + next[v].load(std::memory_order_relaxed);
    next[v].store(first[v], std::memory_order_relaxed);
  }
  sorted.items.resize(first.back());
  forEach([&](std::size_t vertex, const Item& item) {
    sorted.items[next[vertex].fetch_add(1, std::memory_order_relaxed)] = item;
  });
  return sorted;
}

}  // namespace limn
