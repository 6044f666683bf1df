// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/SortTriangles.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kChunk = 1 << 18;  // triangles per task
constexpr int kMortonBitsPerAxis = 7;    // finer order is the cluster builder's task
constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = 1 << kDigitBits;
static_assert(3 * kMortonBitsPerAxis < 2 * kDigitBits, "two passes sort the codes");

constexpr std::size_t kCellsPerAxis = 1 << kMortonBitsPerAxis;
constexpr double kModest = 1e30;  ///< far from what a float cannot hold

/// For each number of a cell on an axis the number of which every third bit is one of its bits.
const std::array<std::uint32_t, kCellsPerAxis>& spreadBits()
{
  static const std::array<std::uint32_t, kCellsPerAxis> table = [] {
    std::array<std::uint32_t, kCellsPerAxis> spread = {};
    for (std::size_t cell = 0; cell < kCellsPerAxis; ++cell)
      for (int bit = 0; bit < kMortonBitsPerAxis; ++bit)
        spread[cell] |= static_cast<std::uint32_t>(cell >> bit & 1) << 3 * bit;
    return spread;
  }();
  return table;
}

enum class Fault : std::uint8_t { kNone, kOutOfRange, kNotFinite };

/// Whether all corners are numbers, and modest ones.
bool areModest(const MeshView& mesh, const Triangle& triangle)
{
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

/// The same of all vertices.
template <class Vec>
bool areModest(Span<const Vec> positions, int threads)
{
  using Number = decltype(Vec::x);
  constexpr std::size_t kVertices = 1 << 16;
  std::atomic<bool> all = true;
  parallelFor(threads, (positions.size() + kVertices - 1) / kVertices, [&](std::size_t chunk) {
    int immodest = 0;
    for (std::size_t v = chunk * kVertices; v < std::min(positions.size(), (chunk + 1) * kVertices);
         ++v) {
      const Vec p = positions[v];
      const Number size = (std::fabs(p.x) + std::fabs(p.y)) + std::fabs(p.z);
      immodest += size < static_cast<Number>(kModest) ? 0 : 1;
    }
    if (immodest > 0) all = false;
  });
  return all;
}

Fault faultOf(const MeshView& mesh, const Triangle& triangle, Vec3d origin, bool isModest)
{
  const std::size_t count = mesh.vertexCount();
  const auto [a, b, c] = triangle.vertex;
  if (a >= count || b >= count || c >= count) return Fault::kOutOfRange;
  // The origin is no farther out than the mesh.
  if (isModest || areModest(mesh, triangle)) return Fault::kNone;
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
    const auto toFloat = [](double x) {
      constexpr double kLargest = std::numeric_limits<float>::max();
      return static_cast<float>(std::clamp(x, -kLargest, kLargest));
    };
    lowFloat_ = {toFloat(low_.x), toFloat(low_.y), toFloat(low_.z)};
    scaleFloat_ = toFloat(scale_);
  }
  std::uint32_t code(Vec3d point) const
  {
    const Vec3d p = (point - low_) * scale_;
    return code(cell(p.x), cell(p.y), cell(p.z));
  }
  /// Of a vertex of floats, which are cheaper.
  std::uint32_t code(Vec3f point) const
  {
    const Vec3f p = (point - lowFloat_) * scaleFloat_;
    return code(cell(p.x), cell(p.y), cell(p.z));
  }

 private:
  static constexpr double kCells = kCellsPerAxis;
  /// Requires: no negative number. The last one for what is no number.
  template <class Number>
  static std::size_t cell(Number x)
  {
    return static_cast<std::size_t>(static_cast<std::int32_t>(std::min(Number{kCells - 1}, x)));
  }
  std::uint32_t code(std::size_t x, std::size_t y, std::size_t z) const
  {
    return spread_[x] | spread_[y] << 1 | spread_[z] << 2;
  }
  const std::array<std::uint32_t, kCellsPerAxis>& spread_ = spreadBits();
  Vec3d low_;
  double scale_;
  Vec3f lowFloat_;
  float scaleFloat_;
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
  const bool isFloat = !mesh.positions.empty();
  const bool isModest =
      isFloat ? areModest(mesh.positions, threads) : areModest(mesh.precisePositions, threads);
  std::atomic<std::size_t> outOfRange = 0, notFinite = 0;
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    TriangleUnit* const begin = unsorted.units.data() + chunk * kChunk;
    TriangleUnit* next = begin;
    bool mayGrow = false;  // the last unit has one triangle, the one before this
    for (std::size_t t = chunk * kChunk; t < std::min(triangles, (chunk + 1) * kChunk); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const Fault fault = faultOf(mesh, triangle, origin, isModest);
      if (fault != Fault::kNone) {
        ++(fault == Fault::kOutOfRange ? outOfRange : notFinite);
        mayGrow = false;
      } else if (mayGrow && shareAnEdge(mesh.triangles[t - 1], triangle)) {
        next[-1].code |= TriangleUnit::kPair;
        mayGrow = false;
      } else {
        const std::uint32_t vertex = triangle.vertex[0];
        *next++ = {isFloat ? grid.code(mesh.positions[vertex]) : grid.code(mesh.position(vertex)),
                   static_cast<std::uint32_t>(t)};
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
