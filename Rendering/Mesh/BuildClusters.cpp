// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/BuildClusters.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kRun = 1 << 16;  // triangles packed by one task
constexpr int kMortonBitsPerAxis = 10;

/// Every third bit of the result is a bit of x.
std::uint32_t spreadBits(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000FFu;
  x = (x | x << 8) & 0x0300F00Fu;
  x = (x | x << 4) & 0x030C30C3u;
  return (x | x << 2) & 0x09249249u;
}

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

enum class Fault : std::uint8_t { kNone, kOutOfRange, kNotFinite };

Fault faultOf(const MeshView& mesh, const Triangle& triangle, Vec3d origin)
{
  for (const std::uint32_t v : triangle.vertex)
    if (v >= mesh.vertexCount()) return Fault::kOutOfRange;
  for (const std::uint32_t v : triangle.vertex) {
    const Vec3d p = mesh.position(v);
    if (!isFinite(p) || !isFinite(toLocal(p, origin).high)) return Fault::kNotFinite;
  }
  return Fault::kNone;
}

/// The clusters of one run of sorted triangles; element numbers count from the run's start.
struct Run {
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint8_t> corner[3];
  std::vector<std::uint32_t> triangle;
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
  /// Place of `vertex` in the cluster, or -1.
  int find(std::uint32_t vertex) const
  {
    for (std::size_t i = slotOf(vertex); entries_[i].generation == generation_; i = next(i))
      if (entries_[i].vertex == vertex) return entries_[i].place;
    return -1;
  }
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

/// Packs triangles greedily, in the order given.
class Packer {
 public:
  Packer(const MeshView& mesh, Run& run) : mesh_(mesh), run_(run) {}

  void add(std::uint32_t triangle)
  {
    const Triangle& t = mesh_.triangles[triangle];
    int fresh = 0;
    for (int k = 0; k < 3; ++k)
      fresh += vertices_.find(t.vertex[k]) < 0;
    if (members_.size() == kMaxClusterTriangles || vertices_.count() + fresh > kMaxClusterVertices)
      close();
    if (members_.empty()) vertices_.startCluster();
    for (const std::uint32_t v : t.vertex)
      vertices_.findOrAdd(v);
    members_.push_back(triangle);
  }

  void close()
  {
    if (members_.empty()) return;
    std::sort(members_.begin(), members_.end());
    Cluster cluster = {};
    cluster.firstVertex = static_cast<std::uint32_t>(run_.vertex.size());
    cluster.firstTriangle = static_cast<std::uint32_t>(run_.triangle.size());
    vertices_.startCluster();
    for (const std::uint32_t triangle : members_) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh_.triangles[triangle].vertex[k];
        const int place = vertices_.findOrAdd(v);
        if (cluster.firstVertex + static_cast<std::uint32_t>(place) == run_.vertex.size())
          run_.vertex.push_back(v);
        run_.corner[k].push_back(static_cast<std::uint8_t>(place));
      }
      run_.triangle.push_back(triangle);
    }
    cluster.vertexCount = static_cast<std::uint8_t>(vertices_.count());
    cluster.triangleCount = static_cast<std::uint8_t>(members_.size());
    run_.clusters.push_back(cluster);
    members_.clear();
    vertices_.startCluster();
  }

 private:
  const MeshView& mesh_;
  Run& run_;
  ClusterVertices vertices_;
  std::vector<std::uint32_t> members_;
};

/// Drawable triangles along the Morton curve, as curve position << 32 | triangle: no two are equal,
/// so any sort gives the same order.
std::vector<std::uint64_t> sortedTriangles(const MeshView& mesh, const Box& box, int threads,
                                           ClusteredMesh& clusters)
{
  const std::size_t count = mesh.triangles.size();
  constexpr std::uint64_t kDropped = std::numeric_limits<std::uint64_t>::max();
  constexpr double kCells = 1 << kMortonBitsPerAxis;
  const Vec3d size = box.high - box.low;
  const auto scale = [](double extent) { return extent > 0 ? kCells / extent : 0.0; };
  const Vec3d toCells = {scale(size.x), scale(size.y), scale(size.z)};
  const auto cell = [](double x) {
    return static_cast<std::uint32_t>(std::clamp(x, 0.0, kCells - 1));
  };
  std::vector<std::uint64_t> keys(count);
  std::atomic<std::size_t> outOfRange = 0, notFinite = 0;
  parallelFor(threads, (count + kRun - 1) / kRun, [&](std::size_t run) {
    for (std::size_t t = run * kRun; t < std::min(count, (run + 1) * kRun); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      const Fault fault = faultOf(mesh, triangle, clusters.origin);
      if (fault != Fault::kNone) {
        ++(fault == Fault::kOutOfRange ? outOfRange : notFinite);
        keys[t] = kDropped;
        continue;
      }
      const Vec3d centroid = (mesh.position(triangle.vertex[0]) - box.low) * (1.0 / 3) +
                             (mesh.position(triangle.vertex[1]) - box.low) * (1.0 / 3) +
                             (mesh.position(triangle.vertex[2]) - box.low) * (1.0 / 3);
      const Vec3d c = centroid * toCells;
      const std::uint32_t code =
          spreadBits(cell(c.x)) | spreadBits(cell(c.y)) << 1 | spreadBits(cell(c.z)) << 2;
      keys[t] = std::uint64_t{code} << 32 | t;
    }
  });
  clusters.outOfRangeTriangles = outOfRange;
  clusters.notFiniteTriangles = notFinite;
  parallelSort(threads, keys);
  keys.resize(count - outOfRange - notFinite);
  return keys;
}

void allocate(const std::vector<Run>& runs, ClusteredMesh& clusters)
{
  std::size_t clusterCount = 0;
  for (const Run& run : runs) {
    clusterCount += run.clusters.size();
    clusters.vertexCount += run.vertex.size();
    clusters.triangleCount += run.triangle.size();
  }
  clusters.clusters.resize(clusterCount);
  for (auto* positions :
       {&clusters.x, &clusters.y, &clusters.z, &clusters.xLow, &clusters.yLow, &clusters.zLow})
    positions->resize(clusters.vertexCount + kMaxClusterVertices);
  clusters.vertex.resize(clusters.vertexCount + kMaxClusterVertices);
  for (auto& corner : clusters.corner)
    corner.resize(clusters.triangleCount + kMaxClusterTriangles);
  clusters.triangle.resize(clusters.triangleCount + kMaxClusterTriangles);
}

/// Where a run's elements go.
struct Place {
  std::size_t cluster, vertex, triangle;
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
    clusters.xLow[i] = p.low.x;
    clusters.yLow[i] = p.low.y;
    clusters.zLow[i] = p.low.z;
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
  std::copy(run.triangle.begin(), run.triangle.end(), clusters.triangle.data() + to.triangle);
  for (int k = 0; k < 3; ++k)
    std::copy(run.corner[k].begin(), run.corner[k].end(), clusters.corner[k].data() + to.triangle);
  bool anyLow = false;
  for (std::size_t c = 0; c < run.clusters.size(); ++c) {
    Cluster cluster = run.clusters[c];
    cluster.firstVertex += static_cast<std::uint32_t>(to.vertex);
    cluster.firstTriangle += static_cast<std::uint32_t>(to.triangle);
    if (placeVertices(mesh, cluster, clusters)) anyLow = true;
    clusters.clusters[to.cluster + c] = cluster;
  }
  return anyLow;
}

void uniteBoxes(ClusteredMesh& clusters)
{
  Box box;
  for (const Cluster& cluster : clusters.clusters) {
    box.add(vec3Cast<double>(cluster.low));
    box.add(vec3Cast<double>(cluster.high));
  }
  if (box.empty()) return;
  clusters.low = vec3Cast<float>(box.low);
  clusters.high = vec3Cast<float>(box.high);
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
  const Box box = finiteBox(mesh);
  clusters.origin = localOrigin(box);

  std::vector<std::uint64_t> sorted = sortedTriangles(mesh, box, threads, clusters);
  std::vector<Run> runs((sorted.size() + kRun - 1) / kRun);
  parallelFor(threads, runs.size(), [&](std::size_t r) {
    Packer packer(mesh, runs[r]);
    for (std::size_t i = r * kRun; i < std::min(sorted.size(), (r + 1) * kRun); ++i)
      packer.add(static_cast<std::uint32_t>(sorted[i]));
    packer.close();
  });
  std::vector<std::uint64_t>().swap(sorted);

  allocate(runs, clusters);
  std::vector<Place> places;
  Place next = {0, 0, 0};
  for (const Run& run : runs) {
    places.push_back(next);
    next = {next.cluster + run.clusters.size(), next.vertex + run.vertex.size(),
            next.triangle + run.triangle.size()};
  }
  std::atomic<bool> anyLow = false;
  parallelFor(threads, runs.size(), [&](std::size_t r) {
    if (copyRun(mesh, runs[r], places[r], clusters)) anyLow = true;
    runs[r] = {};
  });
  if (!anyLow)
    for (auto* low : {&clusters.xLow, &clusters.yLow, &clusters.zLow})
      std::vector<float>().swap(*low);
  uniteBoxes(clusters);
  return {};
}

}  // namespace limn
