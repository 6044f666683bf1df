// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace limn {

/// What triangles have at vertices: items [first[v], first[v + 1]) are those of vertex v.
template <class Item>
struct ItemsByVertex {
  Array<std::uint32_t> first;
  Array<Item> items;
};

/// Sorts what `elementCount` elements have at vertices; items of a vertex stay in the order in
/// which they come. forEachOf(begin, end, visit) calls visit(vertex, item) for each item of the
/// elements [begin, end), twice the same. The same on any number of threads. Requires: fewer than
/// 2^32 items.
template <class Item, class ForEachOf>
ItemsByVertex<Item> sortByVertex(std::size_t vertexCount, std::size_t elementCount, int threads,
                                 const ForEachOf& forEachOf)
{
  // First into buckets of vertices in a row, then by vertex in each, where all that is written to
  // fits the caches, in whatever order the elements name the vertices.
  constexpr std::size_t kManyBuckets = 1024, kManyTasks = 1024, kLeastPerTask = 65536;
  const std::size_t perTask = std::max(kLeastPerTask, elementCount / kManyTasks + 1);
  unsigned shift = 10;
  while (shift < 16 && (vertexCount >> shift) >= kManyBuckets)
    ++shift;
  const std::size_t buckets = (vertexCount >> shift) + 1;
  const std::size_t tasks = stretchCount(elementCount, perTask);
  // For each task and bucket, first a number of items and then the place of the next.
  std::vector<std::uint32_t> next(tasks * buckets);
  parallelForStretches(
      threads, elementCount, perTask, [&](std::size_t task, std::size_t begin, std::size_t end) {
        std::uint32_t* const count = next.data() + task * buckets;
        forEachOf(begin, end, [&](std::size_t vertex, const Item&) { ++count[vertex >> shift]; });
      });
  std::vector<std::uint32_t> firstOf;
  firstOf.reserve(buckets + 1);
  std::uint32_t all = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    firstOf.push_back(all);
    for (std::size_t task = 0; task < tasks; ++task)
      all += std::exchange(next[task * buckets + bucket], all);
  }
  firstOf.push_back(all);
  ItemsByVertex<Item> sorted;
  sorted.first.resize(vertexCount + 1);
  sorted.first[vertexCount] = all;
  sorted.items.resize(all);
  Array<std::uint16_t> vertexOf(all);  // within the bucket
  const std::size_t mask = (std::size_t{1} << shift) - 1;
  parallelForStretches(threads, elementCount, perTask,
                       [&](std::size_t task, std::size_t begin, std::size_t end) {
                         std::uint32_t* const place = next.data() + task * buckets;
                         forEachOf(begin, end, [&](std::size_t vertex, const Item& item) {
                           const std::uint32_t at = place[vertex >> shift]++;
                           sorted.items[at] = item;
                           vertexOf[at] = static_cast<std::uint16_t>(vertex & mask);
                         });
                       });
  parallelFor(threads, buckets, [&](std::size_t bucket) {
    const std::size_t begin = bucket << shift;
    const std::size_t end = std::min(vertexCount, (bucket + 1) << shift);
    const std::uint32_t first = firstOf[bucket], last = firstOf[bucket + 1];
    const std::vector<Item> items(sorted.items.begin() + first, sorted.items.begin() + last);
    std::vector<std::uint32_t> place(end - begin);
    for (std::uint32_t i = first; i < last; ++i)
      ++place[vertexOf[i]];
    std::uint32_t sum = first;
    for (std::size_t v = begin; v < end; ++v) {
      sorted.first[v] = sum;
      sum += std::exchange(place[v - begin], sum);
    }
    for (std::uint32_t i = first; i < last; ++i)
      sorted.items[place[vertexOf[i]]++] = items[i - first];
  });
  return sorted;
}

}  // namespace limn
