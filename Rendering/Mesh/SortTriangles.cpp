// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/SortTriangles.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kChunk = 1 << 18;  // triangles per task
constexpr int kMortonBitsPerAxis = 7;    // finer order is the cluster builder's task
constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = 1 << kDigitBits;
static_assert(3 * kMortonBitsPerAxis < 2 * kDigitBits, "two passes sort the codes");

/// Every third bit of the result is a bit of x.
std::uint32_t spreadBits(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000FFu;
  x = (x | x << 8) & 0x0300F00Fu;
  x = (x | x << 4) & 0x030C30C3u;
  return (x | x << 2) & 0x09249249u;
}

enum class Fault : std::uint8_t { kNone, kOutOfRange, kNotFinite };

/// Whether all corners are numbers, far from what a float cannot hold.
bool areModest(const MeshView& mesh, const Triangle& triangle)
{
  constexpr double kModest = 1e30;
  const auto [a, b, c] = triangle.vertex;
  if (!mesh.positions.empty()) {
    const auto size = [&](std::uint32_t v) {
      const Vec3f p = mesh.positions[v];
      return (std::fabs(p.x) + std::fabs(p.y)) + std::fabs(p.z);
    };
    return (size(a) + size(b)) + size(c) < static_cast<float>(kModest);
  }
  const auto size = [&](std::uint32_t v) {
    const Vec3d p = mesh.precisePositions[v];
    return (std::fabs(p.x) + std::fabs(p.y)) + std::fabs(p.z);
  };
  return (size(a) + size(b)) + size(c) < kModest;
}

Fault faultOf(const MeshView& mesh, const Triangle& triangle, Vec3d origin)
{
  const std::size_t count = mesh.vertexCount();
  const auto [a, b, c] = triangle.vertex;
  if (a >= count || b >= count || c >= count) return Fault::kOutOfRange;
  // The origin is no farther out than the mesh.
  if (areModest(mesh, triangle)) return Fault::kNone;
  for (const std::uint32_t v : triangle.vertex) {
    const Vec3d p = mesh.position(v);
    if (!isFinite(p) || !isFinite(toLocal(p, origin).high)) return Fault::kNotFinite;
  }
  return Fault::kNone;
}

/// Cells of the curve's grid, 2^kMortonBitsPerAxis a side.
class MortonGrid {
 public:
  explicit MortonGrid(const Box& box) : low_(box.low)
  {
    const Vec3d size = box.high - box.low;
    // Cubes, so that cells are as wide as they are high.
    const double extent = std::max({size.x, size.y, size.z});
    scale_ = extent > 0 ? kCells / extent : 0.0;
  }
  std::uint32_t code(Vec3d point) const
  {
    const Vec3d p = (point - low_) * scale_;
    return spreadBits(cell(p.x)) | spreadBits(cell(p.y)) << 1 | spreadBits(cell(p.z)) << 2;
  }

 private:
  static constexpr double kCells = 1 << kMortonBitsPerAxis;
  static std::uint32_t cell(double x)
  {
    return static_cast<std::uint32_t>(std::clamp(x, 0.0, kCells - 1));
  }
  Vec3d low_;
  double scale_;
};

bool shareAnEdge(const Triangle& a, const Triangle& b)
{
  int common = 0;
  for (const std::uint32_t v : a.vertex)
    common += v == b.vertex[0] || v == b.vertex[1] || v == b.vertex[2];
  return common >= 2;
}

/// Units in chunks: chunk c's are the first count[c] from c * kChunk on.
struct Chunks {
  Array<TriangleUnit> units;
  std::vector<std::size_t> count;
};

/// One pass of a stable radix sort, by the digit that begins at `bit`.
void sortByDigit(const Chunks& from, int bit, int threads, Array<TriangleUnit>& to)
{
  const std::size_t chunks = from.count.size();
  const auto digit = [&](const TriangleUnit& unit) { return unit.code >> bit & (kDigits - 1); };
  std::vector<std::array<std::uint32_t, kDigits>> next(chunks);
  const auto forEachOf = [&](std::size_t chunk, auto visit) {
    for (std::size_t i = 0; i < from.count[chunk]; ++i)
      visit(from.units[chunk * kChunk + i]);
  };
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    next[chunk].fill(0);
    forEachOf(chunk, [&](const TriangleUnit& unit) { ++next[chunk][digit(unit)]; });
  });
  std::uint32_t place = 0;
  for (std::size_t d = 0; d < kDigits; ++d)
    for (auto& counts : next)
      place += std::exchange(counts[d], place);
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    forEachOf(chunk, [&](const TriangleUnit& unit) { to[next[chunk][digit(unit)]++] = unit; });
  });
}

}  // namespace

SortedTriangles sortTriangles(const MeshView& mesh, const Box& box, Vec3d origin, int threads)
{
  const std::size_t triangles = mesh.triangles.size();
  const std::size_t chunks = (triangles + kChunk - 1) / kChunk;
  const MortonGrid grid(box);
  Chunks unsorted;
  unsorted.units.resize(triangles);
  unsorted.count.resize(chunks);
  std::atomic<std::size_t> outOfRange = 0, notFinite = 0;
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    TriangleUnit* const begin = unsorted.units.data() + chunk * kChunk;
    TriangleUnit* next = begin;
    bool mayGrow = false;  // the last unit has one triangle, the one before this
    for (std::size_t t = chunk * kChunk; t < std::min(triangles, (chunk + 1) * kChunk); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const Fault fault = faultOf(mesh, triangle, origin);
      if (fault != Fault::kNone) {
        ++(fault == Fault::kOutOfRange ? outOfRange : notFinite);
        mayGrow = false;
      } else if (mayGrow && shareAnEdge(mesh.triangles[t - 1], triangle)) {
        next[-1].code |= TriangleUnit::kPair;
        mayGrow = false;
      } else {
        *next++ = {grid.code(mesh.position(triangle.vertex[0])), static_cast<std::uint32_t>(t)};
        mayGrow = true;
      }
    }
    unsorted.count[chunk] = static_cast<std::size_t>(next - begin);
  });

  SortedTriangles sorted;
  sorted.outOfRange = outOfRange;
  sorted.notFinite = notFinite;
  const std::size_t count =
      std::accumulate(unsorted.count.begin(), unsorted.count.end(), std::size_t{0});
  Chunks half;
  half.units.resize(count);
  for (std::size_t first = 0; first < count; first += kChunk)
    half.count.push_back(std::min(kChunk, count - first));
  sortByDigit(unsorted, 0, threads, half.units);
  sorted.units = std::move(unsorted.units);
  sorted.units.resize(count);
  sortByDigit(half, kDigitBits, threads, sorted.units);
  return sorted;
}

}  // namespace limn
