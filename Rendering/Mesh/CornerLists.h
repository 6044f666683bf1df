// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/MeshView.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

namespace limn {

/// For each vertex the corners that triangles have there, ascending: three times the triangle's
/// number and 0 to 2.
class CornerLists {
 public:
  /// Of the triangles that isUsed(number) names, without corners at vertices that do not exist.
  /// Requires: fewer than 2^32 / 3 triangles. The same on any number of threads.
  template <class IsUsed>
  CornerLists(const MeshView& mesh, int threads, const IsUsed& isUsed)
      : first_(mesh.vertexCount() + 1, 0)
  {
    std::vector<std::atomic<std::uint32_t>> next(mesh.vertexCount());
    const auto forEachCorner = [&](const auto& visit) {
      parallelForEach(threads, mesh.triangles.size(), kPerTask, [&](std::size_t t) {
        if (!isUsed(t)) return;
        for (std::uint32_t k = 0; k < 3; ++k)
          if (const std::uint32_t v = mesh.triangles[t].vertex[k]; v < next.size())
            visit(next[v], static_cast<std::uint32_t>(3 * t) + k);
      });
    };
    forEachCorner([](std::atomic<std::uint32_t>& count, std::uint32_t) {
      count.fetch_add(1, std::memory_order_relaxed);
    });
    for (std::size_t v = 0; v < next.size(); ++v) {
      first_[v + 1] = first_[v] + next[v].load(std::memory_order_relaxed);
      next[v].store(first_[v], std::memory_order_relaxed);
    }
    corners_.resize(first_.back());
    forEachCorner([&](std::atomic<std::uint32_t>& place, std::uint32_t corner) {
      corners_[place.fetch_add(1, std::memory_order_relaxed)] = corner;
    });
    // Undoes the order in which threads came.
    parallelForEach(threads, next.size(), kPerTask, [&](std::size_t v) {
      std::uint32_t* const begin = corners_.data() + first_[v];
      std::uint32_t* const end = corners_.data() + first_[v + 1];
      if (!std::is_sorted(begin, end)) std::sort(begin, end);
    });
  }

  Span<const std::uint32_t> of(std::size_t vertex) const
  {
    return {corners_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  static constexpr std::size_t kPerTask = 8192;

  std::vector<std::uint32_t> first_, corners_;
};

}  // namespace limn
