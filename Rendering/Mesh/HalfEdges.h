// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/MeshView.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

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
      : first_(mesh.vertexCount() + 1, 0)
  {
    std::vector<std::atomic<std::uint32_t>> next(mesh.vertexCount());
    const auto forEach = [&](const auto& visit) {
      parallelForEach(threads, mesh.triangles.size(), kPerTask, [&](std::size_t t) {
        if (!isUsed(t)) return;
        const auto& vertex = mesh.triangles[t].vertex;
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t a = place[vertex[k]], b = place[vertex[(k + 1) % 3]];
          visit(next[std::min(a, b)],
                HalfEdge{std::max(a, b), static_cast<std::uint32_t>(3 * t) + k});
        }
      });
    };
    forEach([](std::atomic<std::uint32_t>& count, const HalfEdge&) {
      count.fetch_add(1, std::memory_order_relaxed);
    });
    for (std::size_t v = 0; v < next.size(); ++v) {
      first_[v + 1] = first_[v] + next[v].load(std::memory_order_relaxed);
      next[v].store(first_[v], std::memory_order_relaxed);
    }
    halves_.resize(first_.back());
    forEach([&](std::atomic<std::uint32_t>& number, const HalfEdge& half) {
      halves_[number.fetch_add(1, std::memory_order_relaxed)] = half;
    });
  }

  /// Those at a place, sorted by end and corner; once a place, as they are sorted only now.
  Span<HalfEdge> sorted(std::size_t v)
  {
    HalfEdge* const begin = halves_.data() + first_[v];
    HalfEdge* const end = halves_.data() + first_[v + 1];
    // Undoes the order in which threads came.
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.end != b.end ? a.end < b.end : a.corner < b.corner;
    });
    return {begin, static_cast<std::size_t>(end - begin)};
  }

 private:
  static constexpr std::size_t kPerTask = 8192;

  std::vector<std::uint32_t> first_;
  Array<HalfEdge> halves_;
};

}  // namespace limn
