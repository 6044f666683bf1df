// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/LocalPosition.h"

#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

namespace limn {
namespace {

// Data nearer than this many box sizes keeps origin zero, so that float data needs no low part.
constexpr double kFarInBoxSizes = 16.0;

constexpr std::size_t kPerTask = 1 << 15;

/// For each vertex whether a triangle uses it. Relaxed, as all that write an element write the
/// same.
using Marks = std::vector<std::atomic<std::uint8_t>>;

Marks markUsed(const MeshView& mesh, int threads)
{
  const std::size_t count = mesh.vertexCount();
  Marks isUsed(count);
  parallelForEach(threads, mesh.triangles.size(), kPerTask, [&](std::size_t t) {
    const auto [a, b, c] = mesh.triangles[t].vertex;
    if (a >= count || b >= count || c >= count) return;
    for (const std::uint32_t v : {a, b, c})
      isUsed[v].store(1, std::memory_order_relaxed);
  });
  return isUsed;
}

/// In the numbers' own precision. forEachVertex(begin, end, visit) visits those that belong to
/// these of `count` elements.
template <class Vec, class ForEachVertex>
FiniteBox finiteBoxOf(Span<const Vec> positions, std::size_t count, int threads,
                      const ForEachVertex& forEachVertex)
{
  constexpr auto kInfinity = std::numeric_limits<decltype(Vec::x)>::infinity();
  std::vector<FiniteBox> boxes(stretchCount(count, kPerTask));
  parallelForStretches(
      threads, count, kPerTask, [&](std::size_t task, std::size_t begin, std::size_t end) {
        Vec low = {kInfinity, kInfinity, kInfinity}, high = -low;
        bool holdsAll = true;
        forEachVertex(begin, end, [&](std::size_t v) {
          const Vec p = positions[v];
          if (!isFinite(p)) {
            holdsAll = false;
            return;
          }
          low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
          high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        });
        boxes[task].holdsAll = holdsAll;
        if (low.x > high.x) return;
        boxes[task].low = vec3Cast<double>(low);
        boxes[task].high = vec3Cast<double>(high);
      });
  FiniteBox all;
  for (const FiniteBox& box : boxes) {
    all.holdsAll = all.holdsAll && box.holdsAll;
    if (box.empty()) continue;
    all.add(box.low);
    all.add(box.high);
  }
  return all;
}

template <class ForEachVertex>
FiniteBox finiteBoxOf(const MeshView& mesh, std::size_t count, int threads,
                      const ForEachVertex& forEachVertex)
{
  return mesh.positions.empty() ? finiteBoxOf(mesh.precisePositions, count, threads, forEachVertex)
                                : finiteBoxOf(mesh.positions, count, threads, forEachVertex);
}

}  // namespace

FiniteBox finiteBox(const MeshView& mesh, int threads)
{
  const Marks isUsed = markUsed(mesh, threads);
  return finiteBoxOf(mesh, isUsed.size(), threads,
                     [&](std::size_t begin, std::size_t end, const auto& visit) {
                       for (std::size_t v = begin; v < end; ++v)
                         if (isUsed[v].load(std::memory_order_relaxed) != 0) visit(v);
                     });
}

FiniteBox finiteBox(const MeshView& mesh, Span<const std::uint32_t> vertices, int threads)
{
  return finiteBoxOf(mesh, vertices.size(), threads,
                     [&](std::size_t begin, std::size_t end, const auto& visit) {
                       for (std::size_t i = begin; i < end; ++i)
                         visit(vertices[i]);
                     });
}

FiniteBox finiteBoxOfAll(const MeshView& mesh, int threads)
{
  return finiteBoxOf(mesh, mesh.vertexCount(), threads,
                     [](std::size_t begin, std::size_t end, const auto& visit) {
                       for (std::size_t v = begin; v < end; ++v)
                         visit(v);
                     });
}

Vec3d localOrigin(const Box& box)
{
  if (box.empty()) return {0, 0, 0};
  const Vec3d size = box.high - box.low;
  const Vec3d centre = box.low * 0.5 + box.high * 0.5;
  const double extent = std::max({size.x, size.y, size.z});
  const double distance = std::max({std::fabs(centre.x), std::fabs(centre.y), std::fabs(centre.z)});
  return distance > kFarInBoxSizes * extent ? centre : Vec3d{0, 0, 0};
}

}  // namespace limn
