// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/WeldVertices.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>

namespace limn {
namespace {

constexpr std::size_t kVerticesPerTask = 16384;
constexpr std::size_t kBuckets = 1024;

std::uint64_t bitsOf(double value)
{
  const double positiveZero = value + 0.0;
  std::uint64_t bits;
  std::memcpy(&bits, &positiveZero, sizeof bits);
  return bits;
}

std::uint64_t mixed(std::uint64_t a, std::uint64_t b)
{
  const std::uint64_t product = (a ^ b) * 0x9E3779B97F4A7C15u;
  return product ^ (product >> 29);
}

std::uint64_t hashOf(Vec3d p)
{
  return mixed(mixed(mixed(0, bitsOf(p.x)), bitsOf(p.y)), bitsOf(p.z));
}

bool isBefore(Vec3d a, Vec3d b)
{
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Vertices of a bucket by place, then number: the first of equal ones stands for all.
void weldBucket(const MeshView& mesh, std::uint32_t* first, std::uint32_t* end,
                std::vector<std::uint32_t>& place)
{
  std::sort(first, end, [&](std::uint32_t a, std::uint32_t b) {
    const Vec3d p = mesh.position(a), q = mesh.position(b);
    return p == q ? a < b : isBefore(p, q);
  });
  for (const std::uint32_t* v = first; v < end; ++v)
    place[*v] = v > first && mesh.position(*v) == mesh.position(v[-1]) ? place[v[-1]] : *v;
}

std::vector<std::uint32_t> weldEqual(const MeshView& mesh, int threads)
{
  const std::size_t count = mesh.vertexCount();
  const std::size_t tasks = (count + kVerticesPerTask - 1) / kVerticesPerTask;
  std::vector<std::uint32_t> place(count);
  std::vector<std::atomic<std::uint32_t>> next(kBuckets);
  const auto forEachVertex = [&](const auto& visit) {
    parallelFor(threads, tasks, [&](std::size_t task) {
      const std::size_t end = std::min(count, (task + 1) * kVerticesPerTask);
      for (std::size_t v = task * kVerticesPerTask; v < end; ++v)
        if (const Vec3d p = mesh.position(v); isFinite(p))
          visit(static_cast<std::uint32_t>(v), hashOf(p) % kBuckets);
    });
  };
  std::iota(place.begin(), place.end(), 0u);
  forEachVertex([&](std::uint32_t, std::size_t bucket) {
    next[bucket].fetch_add(1, std::memory_order_relaxed);
  });
  std::vector<std::uint32_t> first(kBuckets + 1, 0);
  for (std::size_t b = 0; b < kBuckets; ++b) {
    first[b + 1] = first[b] + next[b].load();
    next[b].store(first[b]);
  }
  std::vector<std::uint32_t> vertices(first.back());
  forEachVertex([&](std::uint32_t v, std::size_t bucket) {
    vertices[next[bucket].fetch_add(1, std::memory_order_relaxed)] = v;
  });
  // Sorting undoes the order in which threads came.
  parallelFor(threads, kBuckets, [&](std::size_t b) {
    weldBucket(mesh, vertices.data() + first[b], vertices.data() + first[b + 1], place);
  });
  return place;
}

/// Places are looked up in a grid of cells as wide as the tolerance.
std::vector<std::uint32_t> weldNear(const MeshView& mesh, double tolerance)
{
  const std::size_t count = mesh.vertexCount();
  std::vector<std::uint32_t> place(count);
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
  const auto keyOf = [](double x, double y, double z) { return hashOf({x, y, z}); };
  for (std::uint32_t v = 0; v < count; ++v) {
    place[v] = v;
    const Vec3d p = mesh.position(v);
    if (!isFinite(p)) continue;
    const double x = std::floor(p.x / tolerance), y = std::floor(p.y / tolerance),
                 z = std::floor(p.z / tolerance);
    for (int n = 0; n < 27; ++n) {
      const int aside = n % 3 - 1, up = n / 3 % 3 - 1, ahead = n / 9 - 1;
      const auto cell = cells.find(keyOf(x + aside, y + up, z + ahead));
      if (cell == cells.end()) continue;
      for (const std::uint32_t other : cell->second) {
        const Vec3d apart = mesh.position(other) - p;
        if (dot(apart, apart) <= tolerance * tolerance) place[v] = std::min(place[v], other);
      }
    }
    if (place[v] == v) cells[keyOf(x, y, z)].push_back(v);
  }
  return place;
}

}  // namespace

std::vector<std::uint32_t> weldVertices(const MeshView& mesh, double tolerance, int threads)
{
  return tolerance > 0 ? weldNear(mesh, tolerance) : weldEqual(mesh, threads);
}

}  // namespace limn
