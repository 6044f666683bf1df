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
static_assert(3 * kMortonBitsPerAxis <= 2 * kDigitBits, "two passes sort the codes");
static_assert(3 * kMortonBitsPerAxis + TriangleGroup::kShapeBits <= 32, "a code must fit");

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

/// The same of all vertices, of which this is the box.
bool areModest(const FiniteBox& box)
{
  const auto isModest = [](Vec3d p) {
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < kModest;
  };
  return box.holdsAll && isModest(box.low) && isModest(box.high);
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

/// Puts units that come in the order of the mesh into groups.
class GroupMaker {
 public:
  explicit GroupMaker(Array<TriangleGroup>& groups) : groups_(groups) {}

  /// The unit has `triangles` from `first` on, which begin in the cell of `code`.
  void add(std::uint32_t first, std::uint32_t triangles, std::uint32_t code)
  {
    if (units_ == TriangleGroup::kMaxUnits || code != code_ || first != end_) {
      finish();
      code_ = code;
      first_ = first;
    }
    pairs_ |= (triangles - 1) << units_;
    ++units_;
    end_ = first + triangles;
  }
  void finish()
  {
    if (units_ == 0) return;
    groups_.push_back(
        {(code_ << TriangleGroup::kUnitsBits | (units_ - 1)) << TriangleGroup::kMaxUnits | pairs_,
         first_});
    units_ = 0;
    pairs_ = 0;
  }

 private:
  Array<TriangleGroup>& groups_;
  std::uint32_t units_ = 0, pairs_ = 0;  ///< of the group that is being filled
  std::uint32_t code_ = 0, first_ = 0, end_ = 0;
};

using Groups = Span<const TriangleGroup>;

/// One pass of a stable radix sort of all parts, one after the other, by the digit that begins at
/// `bit` of the code.
void sortByDigit(Span<const Groups> parts, int bit, int threads, TriangleGroup* to)
{
  const auto digit = [&](const TriangleGroup& group) {
    return group.bits >> (TriangleGroup::kShapeBits + bit) & (kDigits - 1);
  };
  std::vector<std::array<std::uint32_t, kDigits>> next(parts.size());
  parallelFor(threads, parts.size(), [&](std::size_t part) {
    next[part].fill(0);
    for (const TriangleGroup& group : parts[part])
      ++next[part][digit(group)];
  });
  std::uint32_t place = 0;
  for (std::size_t d = 0; d < kDigits; ++d)
    for (auto& counts : next)
      place += std::exchange(counts[d], place);
  parallelFor(threads, parts.size(), [&](std::size_t part) {
    for (const TriangleGroup& group : parts[part])
      to[next[part][digit(group)]++] = group;
  });
}

}  // namespace

SortedTriangles sortTriangles(const MeshView& mesh, const FiniteBox& box, Vec3d origin, int threads)
{
  const std::size_t triangles = mesh.triangles.size();
  const std::size_t chunks = (triangles + kChunk - 1) / kChunk;
  const MortonGrid grid(box);
  const bool isFloat = !mesh.positions.empty();
  const bool isModest = areModest(box);
  std::vector<Array<TriangleGroup>> unsorted(chunks);
  std::atomic<std::size_t> outOfRange = 0, notFinite = 0;
  parallelFor(threads, chunks, [&](std::size_t chunk) {
    GroupMaker maker(unsorted[chunk]);
    const std::size_t end = std::min(triangles, (chunk + 1) * kChunk);
    for (std::size_t t = chunk * kChunk; t < end;) {
      const Triangle& triangle = mesh.triangles[t];
      const Fault fault = faultOf(mesh, triangle, origin, isModest);
      if (fault != Fault::kNone) {
        ++(fault == Fault::kOutOfRange ? outOfRange : notFinite);
        ++t;
        continue;
      }
      const bool isPair = t + 1 < end && shareAnEdge(triangle, mesh.triangles[t + 1]) &&
                          faultOf(mesh, mesh.triangles[t + 1], origin, isModest) == Fault::kNone;
      const std::uint32_t unitTriangles = isPair ? 2 : 1, vertex = triangle.vertex[0];
      maker.add(static_cast<std::uint32_t>(t), unitTriangles,
                isFloat ? grid.code(mesh.positions[vertex]) : grid.code(mesh.position(vertex)));
      t += unitTriangles;
    }
    maker.finish();
  });

  SortedTriangles sorted;
  sorted.outOfRange = outOfRange;
  sorted.notFinite = notFinite;
  const std::vector<Groups> parts(unsorted.begin(), unsorted.end());
  const std::size_t count =
      std::accumulate(parts.begin(), parts.end(), std::size_t{0},
                      [](std::size_t sum, Groups part) { return sum + part.size(); });
  Array<TriangleGroup> half(count);
  sortByDigit(parts, 0, threads, half.data());
  unsorted.clear();
  std::vector<Groups> halfParts;
  for (std::size_t first = 0; first < count; first += kChunk)
    halfParts.push_back({half.data() + first, std::min(kChunk, count - first)});
  sorted.groups.resize(count);
  sortByDigit(halfParts, kDigitBits, threads, sorted.groups.data());
  return sorted;
}

}  // namespace limn
