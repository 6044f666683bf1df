// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/WeldVertices.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kVerticesPerTask = 65536;
constexpr std::size_t kBuckets = 1024;

std::uint64_t bitsOf(double value)
{
  const double positiveZero = value + 0.0;
  std::uint64_t bits;
  std::memcpy(&bits, &positiveZero, sizeof bits);
  return bits;
}

/// With 0 for coordinates below 2^-46 of the largest: what the sine of a whole turn, a number near
/// that, lacks of 0 is less.
Vec3d cleaned(Vec3d p)
{
  constexpr double kNothing = 0x1p-46;
  const double size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const auto round = [least = size * kNothing](double x) { return std::fabs(x) < least ? 0.0 : x; };
  return {round(p.x), round(p.y), round(p.z)};
}

std::uint64_t mixed(std::uint64_t a, std::uint64_t b)
{
  const std::uint64_t product = (a ^ b) * 0x9E3779B97F4A7C15u;
  return product ^ (product >> 32);
}

std::uint64_t hashOf(Vec3d p)
{
  // Once more, as only the high bits of a product depend on all of a factor's.
  return mixed(mixed(mixed(mixed(0, bitsOf(p.x)), bitsOf(p.y)), bitsOf(p.z)), 0);
}

struct HashedVertex {
  std::uint32_t vertex, hash;
};

/// Finds the first vertex in a place; as large as there are places, at most half full.
class PlaceTable {
 public:
  explicit PlaceTable(const MeshView& mesh) : mesh_(mesh), slots_(16, kFree) {}

  std::uint32_t firstAt(const HashedVertex& one)
  {
    HashedVertex& found = slots_[slotOf(one)];
    if (found.vertex != kFree.vertex) return found.vertex;
    found = one;
    if (2 * ++count_ > slots_.size()) grow();
    return one.vertex;
  }

 private:
  static constexpr HashedVertex kFree = {0xFFFFFFFFu, 0};

  /// That of the place, or a free one.
  std::size_t slotOf(const HashedVertex& one) const
  {
    const auto isSame = [&](const HashedVertex& other) {
      return other.hash == one.hash &&
             cleaned(mesh_.position(other.vertex)) == cleaned(mesh_.position(one.vertex));
    };
    std::size_t slot = one.hash & (slots_.size() - 1);
    while (slots_[slot].vertex != kFree.vertex && !isSame(slots_[slot]))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow()
  {
    std::vector<HashedVertex> old(2 * slots_.size(), kFree);
    old.swap(slots_);
    for (const HashedVertex& one : old)
      if (one.vertex != kFree.vertex) slots_[slotOf(one)] = one;
  }

  const MeshView& mesh_;
  std::vector<HashedVertex> slots_;
  std::size_t count_ = 0;
};

/// Gives each vertex of a bucket, ascending, the first one that is where it is.
void weldBucket(const MeshView& mesh, Span<const HashedVertex> vertices,
                std::vector<std::uint32_t>& place)
{
  PlaceTable table(mesh);
  for (const HashedVertex& one : vertices)
    place[one.vertex] = table.firstAt(one);
}

std::vector<std::uint32_t> weldEqual(const MeshView& mesh, int threads)
{
  const std::size_t count = mesh.vertexCount();
  std::vector<std::uint32_t> place(count);
  std::iota(place.begin(), place.end(), 0u);
  // For each task and bucket, first a number of vertices and then the place of the next.
  using Buckets = std::array<std::uint32_t, kBuckets>;
  std::vector<Buckets> next(stretchCount(count, kVerticesPerTask));
  const auto forEachVertex = [&](const auto& visit) {
    parallelForStretches(threads, count, kVerticesPerTask,
                         [&](std::size_t task, std::size_t begin, std::size_t end) {
                           for (std::size_t v = begin; v < end; ++v)
                             if (const Vec3d p = mesh.position(v); isFinite(p)) {
                               const std::uint64_t hash = hashOf(cleaned(p));
                               visit(next[task][hash % kBuckets],
                                     HashedVertex{static_cast<std::uint32_t>(v),
                                                  static_cast<std::uint32_t>(hash >> 32)});
                             }
                         });
  };
  forEachVertex([](std::uint32_t& number, const HashedVertex&) { ++number; });
  std::vector<std::uint32_t> first;
  std::uint32_t all = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    first.push_back(all);
    for (Buckets& ofTask : next)
      all += std::exchange(ofTask[bucket], all);
  }
  first.push_back(all);
  Array<HashedVertex> vertices(all);
  forEachVertex([&](std::uint32_t& number, const HashedVertex& one) { vertices[number++] = one; });
  parallelFor(threads, kBuckets, [&](std::size_t bucket) {
    weldBucket(mesh, {vertices.data() + first[bucket], first[bucket + 1] - first[bucket]}, place);
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
