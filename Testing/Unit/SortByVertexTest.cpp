// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/SortByVertex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace limn {
namespace {

/// Up to three vertices of each element, some far from those of its neighbours.
std::vector<std::vector<std::uint32_t>> elements(std::size_t count, std::uint32_t vertexCount)
{
  std::mt19937 random(20261130);
  std::vector<std::vector<std::uint32_t>> all(count);
  for (auto& vertices : all)
    for (unsigned i = random() % 4; i > 0; --i)
      vertices.push_back(static_cast<std::uint32_t>(random()) % vertexCount);
  return all;
}

// Of several tasks, with one bucket and many, narrow and wide ones.
TEST(SortByVertex, KeepsTheOrderOfTheItemsOfEachVertexOnAnyNumberOfThreads)
{
  for (const std::uint32_t vertexCount : {1u, 1000u, 1024u, 300000u, 3000000u}) {
    const auto all = elements(150000, vertexCount);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      for (const std::uint32_t vertex : all[i])
        expected.emplace_back(vertex, i);
    std::stable_sort(expected.begin(), expected.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const int threads : {1, 2, 8}) {
      const ItemsByVertex<std::uint32_t> sorted =
          sortByVertex<std::uint32_t>(vertexCount, all.size(), threads,
                                      [&](std::size_t begin, std::size_t end, const auto& visit) {
                                        for (std::size_t i = begin; i < end; ++i)
                                          for (const std::uint32_t vertex : all[i])
                                            visit(vertex, static_cast<std::uint32_t>(i));
                                      });
      ASSERT_EQ(sorted.first.size(), vertexCount + std::size_t{1});
      ASSERT_EQ(sorted.items.size(), expected.size());
      EXPECT_EQ(sorted.first.front(), 0u);
      EXPECT_EQ(sorted.first.back(), expected.size());
      EXPECT_TRUE(std::is_sorted(sorted.first.begin(), sorted.first.end()));
      bool isSame = true;
      for (std::uint32_t i = 0; i < expected.size(); ++i) {
        const auto [vertex, item] = expected[i];
        isSame = isSame && sorted.items[i] == item && sorted.first[vertex] <= i &&
                 i < sorted.first[vertex + 1];
      }
      EXPECT_TRUE(isSame) << vertexCount << " vertices, " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace limn
