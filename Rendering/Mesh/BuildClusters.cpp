// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/BuildClusters.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/SortTriangles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kRun = 1 << 11;  // units of the curve cut into clusters by one task
constexpr std::size_t kFill = 80;      // triangles in a cluster, if the vertices allow it

float roundedDown(double value)
{
  const auto nearest = static_cast<float>(value);
  return nearest > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
                         : nearest;
}
float roundedUp(double value)
{
  const auto nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                         : nearest;
}

/// The clusters of one run of sorted triangles; vertices count from the run's start.
struct Run {
  std::size_t firstTriangle = 0;
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> vertex;
};

/// Vertex numbers of the cluster being filled: open addressing, emptied by counting clusters.
class ClusterVertices {
 public:
  void startCluster()
  {
    ++generation_;
    count_ = 0;
  }
  int count() const { return count_; }
  /// Place of `vertex` in the cluster.
  int findOrAdd(std::uint32_t vertex)
  {
    std::size_t i = slotOf(vertex);
    for (; entries_[i].generation == generation_; i = next(i))
      if (entries_[i].vertex == vertex) return entries_[i].place;
    entries_[i] = {generation_, vertex, count_};
    return count_++;
  }

 private:
  struct Entry {
    std::uint32_t generation = 0, vertex = 0;
    int place = 0;
  };
  static constexpr std::size_t kSlots = 256;
  static std::size_t slotOf(std::uint32_t vertex) { return vertex * 2654435761u >> 24; }
  static std::size_t next(std::size_t slot) { return (slot + 1) % kSlots; }

  std::array<Entry, kSlots> entries_;
  std::uint32_t generation_ = 1;  // no entry is of it yet
  int count_ = 0;
};

/// A unit of a run: where its first triangle's centroid is, in steps of the run's box, and its
/// number in the run.
struct Member {
  std::uint16_t centroid[3];
  std::uint16_t number;
};

/// Cuts a run of triangles into clusters: halves it across its longest side until a part fits.
class RunCutter {
 public:
  RunCutter(const MeshView& mesh, Span<const TriangleUnit> units, Run& run, ClusteredMesh& clusters)
      : mesh_(mesh),
        units_(units),
        run_(run),
        triangleCount_(run.firstTriangle),
        triangle_(clusters.triangle.data()),
        corner_{clusters.corner[0].data(), clusters.corner[1].data(), clusters.corner[2].data()}
  {
    std::vector<Vec3d> centroid(units.size());
    Box box;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Triangle& t = mesh_.triangles[units_[i].first];
      centroid[i] = (mesh_.position(t.vertex[0]) + mesh_.position(t.vertex[1]) +
                     mesh_.position(t.vertex[2])) *
                    (1.0 / 3);
      box.add(centroid[i]);
    }
    const Vec3d size = box.high - box.low;
    const double extent = std::max({size.x, size.y, size.z});
    const double steps = extent > 0 ? 65535.0 / extent : 0.0;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Vec3d c = (centroid[i] - box.low) * steps;
      member_[i] = {{static_cast<std::uint16_t>(c.x), static_cast<std::uint16_t>(c.y),
                     static_cast<std::uint16_t>(c.z)},
                    static_cast<std::uint16_t>(i)};
    }
  }

  void cut()
  {
    cut(0, units_.size());
    run_.vertex.assign(vertex_, vertex_ + vertexCount_);
  }

 private:
  void cut(std::size_t begin, std::size_t end)
  {
    const std::size_t count = end - begin;
    std::size_t triangles = 0;
    for (std::size_t i = begin; i < end; ++i)
      triangles += units_[member_[i].number].count();
    if (triangles <= kFill && emit(begin, end)) return;
    // Parts are multiples of a full cluster, so that no small rest is left.
    const std::size_t parts = (triangles + kFill - 1) / kFill;
    const std::size_t middle = begin + (parts > 1 ? count * (parts / 2) / parts : count / 2);
    splitAt(begin, middle, end);
    cut(begin, middle);
    cut(middle, end);
  }

  struct Range {
    std::uint16_t low, high;
  };
  Range rangeOf(int axis, std::size_t begin, std::size_t end) const
  {
    Range range = {member_[begin].centroid[axis], member_[begin].centroid[axis]};
    for (std::size_t i = begin; i < end; ++i) {
      range.low = std::min(range.low, member_[i].centroid[axis]);
      range.high = std::max(range.high, member_[i].centroid[axis]);
    }
    return range;
  }

  /// Orders the members so that those before `middle` have the smaller centroids on the longest
  /// axis: first by buckets, then exactly in the bucket where the middle lies.
  void splitAt(std::size_t begin, std::size_t middle, std::size_t end)
  {
    int axis = 0;
    Range range = rangeOf(0, begin, end);
    for (const int other : {1, 2}) {
      const Range r = rangeOf(other, begin, end);
      if (r.high - r.low > range.high - range.low) {
        range = r;
        axis = other;
      }
    }
    constexpr int kBuckets = 64;
    const std::uint32_t scale = (std::uint32_t{kBuckets} << 16) / (range.high - range.low + 1u);
    const auto bucket = [&](const Member& m) {
      return static_cast<std::uint32_t>(m.centroid[axis] - range.low) * scale >> 16;
    };
    std::uint32_t count[kBuckets] = {};
    for (std::size_t i = begin; i < end; ++i)
      ++count[bucket(member_[i])];
    std::uint32_t split = 0;
    std::size_t before = begin;
    while (before + count[split] <= middle)
      before += count[split++];

    // Below, in and above the middle's bucket.
    std::size_t next[3] = {begin, before, before + count[split]};
    std::copy(member_ + begin, member_ + end, old_ + begin);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t b = bucket(old_[i]);
      member_[next[(b >= split) + (b > split)]++] = old_[i];
    }
    std::nth_element(member_ + before, member_ + middle, member_ + before + count[split],
                     [axis](const Member& a, const Member& b) {
                       return a.centroid[axis] < b.centroid[axis] ||
                              (a.centroid[axis] == b.centroid[axis] && a.number < b.number);
                     });
  }

  /// Makes a cluster of a part, unless it has too many vertices.
  bool emit(std::size_t begin, std::size_t end)
  {
    vertices_.startCluster();
    std::size_t triangleCount = triangleCount_;
    for (std::size_t i = begin; i < end; ++i) {
      const TriangleUnit& unit = units_[member_[i].number];
      for (std::uint32_t triangle = unit.first; triangle < unit.first + unit.count(); ++triangle) {
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t v = mesh_.triangles[triangle].vertex[k];
          const auto place = static_cast<std::size_t>(vertices_.findOrAdd(v));
          vertex_[vertexCount_ + place] = v;
          corner_[k][triangleCount] = static_cast<std::uint8_t>(place);
        }
        triangle_[triangleCount++] = triangle;
      }
      if (vertices_.count() > kMaxClusterVertices) return false;
    }
    Cluster cluster = {};
    cluster.firstVertex = static_cast<std::uint32_t>(vertexCount_);
    cluster.firstTriangle = static_cast<std::uint32_t>(triangleCount_);
    cluster.vertexCount = static_cast<std::uint8_t>(vertices_.count());
    cluster.triangleCount = static_cast<std::uint8_t>(triangleCount - triangleCount_);
    run_.clusters.push_back(cluster);
    vertexCount_ += cluster.vertexCount;
    triangleCount_ = triangleCount;
    return true;
  }

  const MeshView& mesh_;
  Span<const TriangleUnit> units_;
  Run& run_;
  ClusterVertices vertices_;
  Member member_[kRun], old_[kRun];
  std::size_t vertexCount_ = 0;  ///< of the run's clusters so far
  std::uint32_t vertex_[3 * 2 * kRun];
  std::size_t triangleCount_;  ///< of all runs before, and of this one's clusters so far
  std::uint32_t* triangle_;
  std::uint8_t* corner_[3];
};

template <class T>
void allocate(std::size_t count, std::size_t spare, Array<T>& array)
{
  array.resize(count + spare);
  std::fill(array.end() - static_cast<std::ptrdiff_t>(spare), array.end(), T{0});
}

void allocateTriangles(ClusteredMesh& clusters)
{
  for (Array<std::uint8_t>& corner : clusters.corner)
    allocate(clusters.triangleCount, kMaxClusterTriangles, corner);
  allocate(clusters.triangleCount, kMaxClusterTriangles, clusters.triangle);
}

void allocateLowParts(ClusteredMesh& clusters)
{
  for (Array<float>* positions : {&clusters.xLow, &clusters.yLow, &clusters.zLow})
    allocate(clusters.vertexCount, kMaxClusterVertices, *positions);
}
void dropLowParts(ClusteredMesh& clusters)
{
  for (Array<float>* positions : {&clusters.xLow, &clusters.yLow, &clusters.zLow})
    Array<float>().swap(*positions);
}
/// Whether no vertex can need a low part.
bool isFloatAtZero(const MeshView& mesh, Vec3d origin)
{
  return !mesh.positions.empty() && origin == Vec3d{0, 0, 0};
}

void allocateVertices(const std::vector<Run>& runs, ClusteredMesh& clusters)
{
  std::size_t clusterCount = 0;
  for (const Run& run : runs) {
    clusterCount += run.clusters.size();
    clusters.vertexCount += run.vertex.size();
  }
  clusters.clusters.resize(clusterCount);
  for (Array<float>* positions : {&clusters.x, &clusters.y, &clusters.z})
    allocate(clusters.vertexCount, kMaxClusterVertices, *positions);
  allocate(clusters.vertexCount, kMaxClusterVertices, clusters.vertex);
}

/// Where a run's elements go.
struct Place {
  std::size_t cluster, vertex;
};

/// Fills positions and boxes of the vertices from `first` on; true if a low part is needed.
bool placeVertices(const MeshView& mesh, Cluster& cluster, ClusteredMesh& clusters)
{
  bool anyLow = false;
  Box box;
  for (std::size_t i = cluster.firstVertex; i < cluster.firstVertex + cluster.vertexCount; ++i) {
    const LocalPosition p = toLocal(mesh.position(clusters.vertex[i]), clusters.origin);
    clusters.x[i] = p.high.x;
    clusters.y[i] = p.high.y;
    clusters.z[i] = p.high.z;
    if (clusters.hasLowParts()) {
      clusters.xLow[i] = p.low.x;
      clusters.yLow[i] = p.low.y;
      clusters.zLow[i] = p.low.z;
    }
    anyLow = anyLow || !(p.low == Vec3f{0, 0, 0});
    box.add(vec3Cast<double>(p.high) + vec3Cast<double>(p.low));
  }
  cluster.low = {roundedDown(box.low.x), roundedDown(box.low.y), roundedDown(box.low.z)};
  cluster.high = {roundedUp(box.high.x), roundedUp(box.high.y), roundedUp(box.high.z)};
  return anyLow;
}

bool copyRun(const MeshView& mesh, const Run& run, Place to, ClusteredMesh& clusters)
{
  std::copy(run.vertex.begin(), run.vertex.end(), clusters.vertex.data() + to.vertex);
  bool anyLow = false;
  for (std::size_t c = 0; c < run.clusters.size(); ++c) {
    Cluster cluster = run.clusters[c];
    cluster.firstVertex += static_cast<std::uint32_t>(to.vertex);
    if (placeVertices(mesh, cluster, clusters)) anyLow = true;
    clusters.clusters[to.cluster + c] = cluster;
  }
  return anyLow;
}

double extentOf(Vec3f low, Vec3f high)
{
  const Vec3d size = vec3Cast<double>(high) - vec3Cast<double>(low);
  return size.x + size.y + size.z;
}

/// Fills the mesh's box. Returns the mean extent of the clusters, the mesh's being 1.
double uniteBoxes(ClusteredMesh& clusters)
{
  Box box;
  double sum = 0;
  for (const Cluster& cluster : clusters.clusters) {
    box.add(vec3Cast<double>(cluster.low));
    box.add(vec3Cast<double>(cluster.high));
    sum += extentOf(cluster.low, cluster.high);
  }
  if (box.empty()) return 0;
  clusters.low = vec3Cast<float>(box.low);
  clusters.high = vec3Cast<float>(box.high);
  const double whole = extentOf(clusters.low, clusters.high);
  return whole > 0 ? sum / (whole * static_cast<double>(clusters.clusters.size())) : 0;
}

bool areFinite(const MeshView& mesh, const Cluster& cluster, const ClusteredMesh& clusters)
{
  for (std::size_t i = cluster.firstVertex; i < cluster.firstVertex + cluster.vertexCount; ++i)
    if (!isFinite(mesh.position(clusters.vertex[i]))) return false;
  return true;
}

}  // namespace

std::size_t ClusteredMesh::bytes() const
{
  const std::size_t floats =
      x.size() + y.size() + z.size() + xLow.size() + yLow.size() + zLow.size();
  return clusters.size() * sizeof(Cluster) + floats * sizeof(float) +
         (vertex.size() + triangle.size()) * sizeof(std::uint32_t) + corner[0].size() * 3;
}

Status buildClusters(const MeshView& mesh, int threads, ClusteredMesh& clusters)
{
  constexpr std::size_t kLimit = std::numeric_limits<std::uint32_t>::max();
  if (mesh.vertexCount() >= kLimit || mesh.triangles.size() >= kLimit)
    return {Error::kTooManyPrimitives,
            "The mesh has more than 4294967294 vertices or triangles; cut it into parts."};
  clusters = {};
  clusters.meshVertexCount = mesh.vertexCount();
  clusters.meshTriangleCount = mesh.triangles.size();
  const Box box = finiteBox(mesh, threads);
  clusters.origin = localOrigin(box);

  SortedTriangles sorted = sortTriangles(mesh, box, clusters.origin, threads);
  clusters.outOfRangeTriangles = sorted.outOfRange;
  clusters.notFiniteTriangles = sorted.notFinite;
  const Span<const TriangleUnit> order = {sorted.units.data(), sorted.units.size()};
  std::vector<Run> runs((order.size() + kRun - 1) / kRun);
  const auto unitsOf = [&](std::size_t r) {
    return Span<const TriangleUnit>(order.data() + r * kRun,
                                    std::min(kRun, order.size() - r * kRun));
  };
  parallelFor(threads, runs.size(), [&](std::size_t r) {
    for (const TriangleUnit& unit : unitsOf(r))
      runs[r].firstTriangle += unit.count();
  });
  for (Run& run : runs)
    clusters.triangleCount += std::exchange(run.firstTriangle, clusters.triangleCount);
  allocateTriangles(clusters);
  parallelFor(threads, runs.size(), [&](std::size_t r) {
    std::make_unique<RunCutter>(mesh, unitsOf(r), runs[r], clusters)->cut();
  });
  sorted = {};

  allocateVertices(runs, clusters);
  if (!isFloatAtZero(mesh, clusters.origin)) allocateLowParts(clusters);
  std::vector<Place> places;
  Place next = {0, 0};
  for (const Run& run : runs) {
    places.push_back(next);
    next = {next.cluster + run.clusters.size(), next.vertex + run.vertex.size()};
  }
  std::atomic<bool> anyLow = false;
  parallelFor(threads, runs.size(), [&](std::size_t r) {
    if (copyRun(mesh, runs[r], places[r], clusters)) anyLow = true;
    runs[r] = {};
  });
  if (!anyLow) dropLowParts(clusters);
  clusters.builtExtent = uniteBoxes(clusters);
  return {};
}

bool refitClusters(const MeshView& mesh, int threads, ClusteredMesh& clusters)
{
  if (clusters.notFiniteTriangles > 0) return false;
  clusters.origin = localOrigin(finiteBox(mesh, threads));
  if (isFloatAtZero(mesh, clusters.origin))
    dropLowParts(clusters);
  else if (!clusters.hasLowParts())
    allocateLowParts(clusters);

  constexpr std::size_t kChunk = 256;
  const std::size_t count = clusters.clusters.size();
  std::atomic<bool> allFinite = true, anyLow = false;
  parallelFor(threads, (count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    for (std::size_t c = chunk * kChunk; c < std::min(count, (chunk + 1) * kChunk); ++c) {
      Cluster& cluster = clusters.clusters[c];
      if (!areFinite(mesh, cluster, clusters)) {
        allFinite = false;
        return;
      }
      if (placeVertices(mesh, cluster, clusters)) anyLow = true;
    }
  });
  if (!anyLow) dropLowParts(clusters);
  constexpr double kApart = 2;
  return allFinite && uniteBoxes(clusters) <= kApart * clusters.builtExtent;
}

}  // namespace limn
