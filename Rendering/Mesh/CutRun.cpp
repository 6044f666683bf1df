// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/CutRun.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kFill = 80;  // triangles in a cluster, if the vertices allow it

/// Vertex numbers of the cluster being filled: open addressing, emptied by counting clusters.
class ClusterVertices {
 public:
  void startCluster() { ++generation_; }
  /// Place in the cluster of `vertex`, which is `count` if that is the first time.
  int findOrAdd(std::uint32_t vertex, int count)
  {
    Entry* entry = &entries_[vertex * 2654435761u >> (32 - kSlotBits)];
    while (entry->generation == generation_ && entry->vertex != vertex)
      entry = entry == &entries_.back() ? &entries_.front() : entry + 1;
    if (entry->generation != generation_)
      *entry = {vertex, generation_, static_cast<std::uint16_t>(count)};
    return entry->place;
  }

 private:
  struct Entry {
    std::uint32_t vertex = 0;
    std::uint16_t generation = 0, place = 0;
  };
  // Several times a cluster's vertices, so that two seldom meet.
  static constexpr int kSlotBits = 9;

  std::array<Entry, 1 << kSlotBits> entries_;
  std::uint16_t generation_ = 1;  // no entry is of it yet
};
static_assert(4 * kUnitsOfRun < 1 << 16, "a run has no more generations");

/// A unit of a run: where its first triangle's centroid is, in steps of the run's box, and its
/// number in the run, below which a bit tells whether it is two triangles.
struct Member {
  std::uint16_t centroid[3];
  std::uint16_t numberAndPair;

  std::size_t number() const { return numberAndPair >> 1; }
  std::size_t triangles() const { return 1u + (numberAndPair & 1u); }
};
static_assert(2 * kUnitsOfRun <= 1 << 16, "a number must fit");

/// Three times the centroid, which has the same order.
template <class Vec>
Vec cornerSum(Span<const Vec> positions, const Triangle& t)
{
  return (positions[t.vertex[0]] + positions[t.vertex[1]]) + positions[t.vertex[2]];
}

/// Cuts the triangles of a run into slices across its longest side, and each of these likewise,
/// until a part fits into a cluster.
class RunCutter {
 public:
  RunCutter(const MeshView& mesh, ClusterRun& run, ClusteredMesh& clusters)
      : mesh_(mesh),
        run_(run),
        triangleCount_(run.firstTriangle),
        triangle_(clusters.triangle.data()),
        corner_{clusters.corner[0].data(), clusters.corner[1].data(), clusters.corner[2].data()}
  {
    listUnits();
    if (mesh.positions.empty())
      placeMembers(mesh.precisePositions);
    else
      placeMembers(mesh.positions);
  }

  void cut()
  {
    cut(0, unitCount_);
    run_.vertex.assign(vertex_, vertex_ + vertexCount_);
  }

 private:
  struct Range {
    std::uint16_t low, high;

    int width() const { return high - low; }
  };

  void listUnits()
  {
    for (const TriangleGroup& group : run_.groups) {
      std::uint32_t pairs = group.pairs(), triangle = group.first;
      for (std::size_t u = 0; u < group.units(); ++u, pairs >>= 1) {
        first_[unitCount_] = triangle;
        member_[unitCount_].numberAndPair =
            static_cast<std::uint16_t>(2 * unitCount_ + (pairs & 1));
        triangle += 1 + (pairs & 1);
        ++unitCount_;
      }
    }
  }

  /// Where the units are, in steps of their box.
  template <class Vec>
  void placeMembers(Span<const Vec> positions)
  {
    using Number = decltype(Vec::x);
    constexpr std::size_t kAhead = 16;
    std::vector<Vec> sum(unitCount_);
    Vec low = {}, high = {};
    for (std::size_t i = 0; i < unitCount_; ++i) {
      if (i + 2 * kAhead < unitCount_) {
        hwy::Prefetch(&mesh_.triangles[first_[i + 2 * kAhead]]);
        for (const std::uint32_t vertex : mesh_.triangles[first_[i + kAhead]].vertex)
          hwy::Prefetch(&positions[vertex]);
      }
      const Vec c = cornerSum(positions, mesh_.triangles[first_[i]]);
      sum[i] = c;
      if (i == 0) low = high = c;
      low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    }
    const Vec size = high - low;
    const Number extent = std::max({size.x, size.y, size.z});
    const Number steps = extent > 0 ? Number{65535} / extent : Number{0};
    const auto step = [&](Number x, Number from) {
      // Also of what is no number, as the sums of the largest have no differences.
      return static_cast<std::uint16_t>(std::min(Number{65535}, (x - from) * steps));
    };
    ranges_ = {{{0, step(high.x, low.x)}, {0, step(high.y, low.y)}, {0, step(high.z, low.z)}}};
    for (std::size_t i = 0; i < unitCount_; ++i) {
      member_[i].centroid[0] = step(sum[i].x, low.x);
      member_[i].centroid[1] = step(sum[i].y, low.y);
      member_[i].centroid[2] = step(sum[i].z, low.z);
    }
  }

  void cut(std::size_t begin, std::size_t end)
  {
    const std::size_t count = end - begin;
    std::size_t triangles = 0;
    for (std::size_t i = begin; i < end; ++i)
      triangles += member_[i].triangles();
    if (triangles <= kFill && emit(begin, end)) return;
    // Slices are multiples of a full cluster, so that no small rest is left.
    const std::size_t parts = std::max<std::size_t>((triangles + kFill - 1) / kFill, 2);
    const std::size_t slices = sortForSlices(begin, end, parts);
    const auto cutAt = [&](std::size_t slice) {
      return begin + count * (parts * slice / slices) / parts;
    };
    for (std::size_t slice = 0; slice < slices; ++slice)
      cut(cutAt(slice), cutAt(slice + 1));
  }

  std::array<Range, 3> rangesOf(std::size_t begin, std::size_t end) const
  {
    if (end - begin == unitCount_) return ranges_;
    std::array<Range, 3> ranges = {{{65535, 0}, {65535, 0}, {65535, 0}}};
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint16_t c = member_[i].centroid[axis];
        ranges[axis].low = std::min(ranges[axis].low, c);
        ranges[axis].high = std::max(ranges[axis].high, c);
      }
    return ranges;
  }

  /// Sorts the members along their longest axis, as finely as it pays. Returns in how many slices
  /// across it they are best cut that will become `parts` clusters: so many that the clusters of a
  /// slice, side by side, are about as wide as it is thick.
  std::size_t sortForSlices(std::size_t begin, std::size_t end, std::size_t parts)
  {
    const std::array<Range, 3> ranges = rangesOf(begin, end);
    std::size_t order[3] = {0, 1, 2};
    std::sort(order, order + 3,
              [&](std::size_t a, std::size_t b) { return ranges[a].width() > ranges[b].width(); });
    const std::size_t axis = order[0];
    const int low = ranges[axis].low, width = ranges[axis].width();
    constexpr std::uint32_t kBuckets = 256;
    const std::uint32_t scale = (kBuckets << 16) / (static_cast<std::uint32_t>(width) + 1u);
    const auto bucketOf = [&](const Member& m) {
      return static_cast<std::uint32_t>(m.centroid[axis] - low) * scale >> 16;
    };
    std::size_t next[kBuckets] = {};
    for (std::size_t i = begin; i < end; ++i)
      ++next[bucketOf(member_[i])];
    std::size_t first = begin;
    for (std::size_t& count : next)
      first += std::exchange(count, first);
    std::copy(member_ + begin, member_ + end, old_ + begin);
    for (std::size_t i = begin; i < end; ++i)
      member_[next[bucketOf(old_[i])]++] = old_[i];

    const double aspect = width / std::max(static_cast<double>(ranges[order[1]].width()), 1.0);
    const double slices = std::sqrt(static_cast<double>(parts) * aspect) + 0.5;
    return std::clamp(static_cast<std::size_t>(std::min(slices, 1e9)), std::size_t{2}, parts);
  }

  /// Makes a cluster of a part, unless it has too many vertices.
  bool emit(std::size_t begin, std::size_t end)
  {
    vertices_.startCluster();
    // Copies, as the compiler cannot know that bytes written below are none of these.
    std::uint8_t* const corner[3] = {corner_[0], corner_[1], corner_[2]};
    std::uint32_t* const triangles = triangle_;
    std::uint32_t* const vertex = vertex_ + vertexCount_;
    const Triangle* const meshTriangles = mesh_.triangles.data();
    int count = 0;
    std::size_t triangleCount = triangleCount_;
    for (std::size_t i = begin; i < end; ++i) {
      const Member member = member_[i];
      const std::uint32_t first = first_[member.number()];
      const auto add = [&](std::uint32_t v, int k) {
        const int place = vertices_.findOrAdd(v, count);
        count += place == count ? 1 : 0;
        vertex[place] = v;
        corner[k][triangleCount] = static_cast<std::uint8_t>(place);
        return place;
      };
      const Triangle one = meshTriangles[first];
      const int place[3] = {add(one.vertex[0], 0), add(one.vertex[1], 1), add(one.vertex[2], 2)};
      triangles[triangleCount++] = first;
      if (member.triangles() > 1) {
        const Triangle other = meshTriangles[first + 1];
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t v = other.vertex[k];
          int known = v == one.vertex[0] ? place[0] : -1;
          known = v == one.vertex[1] ? place[1] : known;
          known = v == one.vertex[2] ? place[2] : known;
          if (known < 0)
            add(v, k);
          else
            corner[k][triangleCount] = static_cast<std::uint8_t>(known);
        }
        triangles[triangleCount++] = first + 1;
      }
      if (count > kMaxClusterVertices) return false;
    }
    Cluster cluster = {};
    cluster.firstVertex = static_cast<std::uint32_t>(vertexCount_);
    cluster.firstTriangle = static_cast<std::uint32_t>(triangleCount_);
    cluster.vertexCount = static_cast<std::uint8_t>(count);
    cluster.triangleCount = static_cast<std::uint8_t>(triangleCount - triangleCount_);
    run_.clusters.push_back(cluster);
    vertexCount_ += cluster.vertexCount;
    triangleCount_ = triangleCount;
    return true;
  }

  const MeshView& mesh_;
  ClusterRun& run_;
  ClusterVertices vertices_;
  std::size_t unitCount_ = 0;
  std::array<Range, 3> ranges_ = {};  ///< of all units
  std::uint32_t first_[kUnitsOfRun];  ///< triangle of each unit, in the run's order
  Member member_[kUnitsOfRun], old_[kUnitsOfRun];
  std::size_t vertexCount_ = 0;  ///< of the run's clusters so far
  std::uint32_t vertex_[3 * 2 * kUnitsOfRun];
  std::size_t triangleCount_;  ///< of all runs before, and of this one's clusters so far
  std::uint32_t* triangle_;
  std::uint8_t* corner_[3];
};

}  // namespace

void cutRun(const MeshView& mesh, ClusterRun& run, ClusteredMesh& clusters)
{
  // Too large for a stack.
  std::make_unique<RunCutter>(mesh, run, clusters)->cut();
}

}  // namespace limn
