// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/BuildClusters.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/CutRun.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/SortTriangles.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace limn {
namespace {

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

/// Runs of consecutive groups. Counts the triangles in clusters.triangleCount.
std::vector<ClusterRun> divide(Span<const TriangleGroup> groups, ClusteredMesh& clusters)
{
  std::vector<ClusterRun> runs;
  std::size_t units = kUnitsOfRun;  // of the last run
  for (const TriangleGroup& group : groups) {
    units += group.units();
    if (units > kUnitsOfRun) {
      units = group.units();
      runs.push_back({});
      runs.back().groups = {&group, 0};
      runs.back().firstTriangle = clusters.triangleCount;
    }
    runs.back().groups = {runs.back().groups.data(), runs.back().groups.size() + 1};
    clusters.triangleCount += group.triangles();
  }
  return runs;
}

void allocateVertices(const std::vector<ClusterRun>& runs, ClusteredMesh& clusters)
{
  std::size_t clusterCount = 0;
  for (const ClusterRun& run : runs) {
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

/// placeVertices() of positions that are floats and stay as they are.
void copyVertices(Span<const Vec3f> positions, Cluster& cluster, ClusteredMesh& clusters)
{
  Vec3f low = positions[clusters.vertex[cluster.firstVertex]], high = low;
  for (std::size_t i = cluster.firstVertex; i < cluster.firstVertex + cluster.vertexCount; ++i) {
    const Vec3f p = positions[clusters.vertex[i]];
    clusters.x[i] = p.x;
    clusters.y[i] = p.y;
    clusters.z[i] = p.z;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  cluster.low = low;
  cluster.high = high;
}

/// Fills positions and boxes of the vertices from `first` on; true if a low part is needed.
bool placeVertices(const MeshView& mesh, Cluster& cluster, ClusteredMesh& clusters)
{
  if (isFloatAtZero(mesh, clusters.origin)) {
    copyVertices(mesh.positions, cluster, clusters);
    return false;
  }
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

void prefetch(const MeshView& mesh, Span<const std::uint32_t> vertices)
{
  for (const std::uint32_t v : vertices)
    if (mesh.positions.empty())
      hwy::Prefetch(&mesh.precisePositions[v]);
    else
      hwy::Prefetch(&mesh.positions[v]);
}

Span<const std::uint32_t> verticesOf(const ClusterRun& run, std::size_t cluster)
{
  const Cluster& one = run.clusters[cluster];
  return {run.vertex.data() + one.firstVertex, one.vertexCount};
}

bool copyRun(const MeshView& mesh, const ClusterRun& run, Place to, ClusteredMesh& clusters)
{
  std::copy(run.vertex.begin(), run.vertex.end(), clusters.vertex.data() + to.vertex);
  bool anyLow = false;
  for (std::size_t c = 0; c < run.clusters.size(); ++c) {
    if (c + 1 < run.clusters.size()) prefetch(mesh, verticesOf(run, c + 1));
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

/// Within a float's range of the clusters' origin, too.
bool areFinite(const MeshView& mesh, const Cluster& cluster, const ClusteredMesh& clusters)
{
  for (std::size_t i = cluster.firstVertex; i < cluster.firstVertex + cluster.vertexCount; ++i) {
    const Vec3d p = mesh.position(clusters.vertex[i]);
    if (!isFinite(p) || !isFinite(toLocal(p, clusters.origin).high)) return false;
  }
  return true;
}

/// Some are named more than once. Those of triangles that are not finite are missing.
Span<const std::uint32_t> usedVertices(const ClusteredMesh& clusters)
{
  return {clusters.vertex.data(), clusters.vertexCount};
}

/// Fills all but the counts of the mesh, in coordinates relative to `origin`.
void buildAround(Vec3d origin, const FiniteBox& box, const MeshView& mesh, int threads,
                 ClusteredMesh& clusters)
{
  clusters.origin = origin;
  SortedTriangles sorted = sortTriangles(mesh, box, origin, threads);
  clusters.outOfRangeTriangles = sorted.outOfRange;
  clusters.notFiniteTriangles = sorted.notFinite;
  std::vector<ClusterRun> runs = divide(sorted.groups, clusters);
  allocateTriangles(clusters);
  parallelFor(threads, runs.size(), [&](std::size_t r) { cutRun(mesh, runs[r], clusters); });
  sorted = {};

  allocateVertices(runs, clusters);
  if (!isFloatAtZero(mesh, origin)) allocateLowParts(clusters);
  std::vector<Place> places;
  Place next = {0, 0};
  for (const ClusterRun& run : runs) {
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
}

ClusteredMesh emptyOf(const MeshView& mesh)
{
  ClusteredMesh clusters;
  clusters.meshVertexCount = mesh.vertexCount();
  clusters.meshTriangleCount = mesh.triangles.size();
  return clusters;
}

/// finiteBox() of a mesh with clusters.
Box usedBox(const MeshView& mesh, int threads, const ClusteredMesh& clusters)
{
  if (clusters.notFiniteTriangles > 0) return finiteBox(mesh, threads);
  if (!isFloatAtZero(mesh, clusters.origin) || clusters.clusters.empty())
    return finiteBox(mesh, usedVertices(clusters), threads);
  return {vec3Cast<double>(clusters.low), vec3Cast<double>(clusters.high)};
}

/// Whether triangles of `used` sorted by their places in `all` have few bits left to tell them
/// apart.
bool isFarWider(const Box& all, const Box& used)
{
  constexpr double kFar = 8;
  const auto extent = [](const Box& box) {
    const Vec3d size = box.high - box.low;
    return size.x + size.y + size.z;
  };
  return !used.empty() && extent(all) > kFar * extent(used);
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
  clusters = emptyOf(mesh);
  const FiniteBox all = finiteBoxOfAll(mesh, threads);
  buildAround(localOrigin(all), all, mesh, threads, clusters);
  // Points that no triangle uses are seldom: looking for them first would cost every mesh a pass.
  const Box used = usedBox(mesh, threads, clusters);
  if (localOrigin(used) == clusters.origin && !isFarWider(all, used)) return {};
  clusters = emptyOf(mesh);
  const FiniteBox box = finiteBox(mesh, threads);
  buildAround(localOrigin(box), box, mesh, threads, clusters);
  return {};
}

bool refitClusters(const MeshView& mesh, int threads, ClusteredMesh& clusters)
{
  if (clusters.notFiniteTriangles > 0) return false;
  clusters.origin = localOrigin(finiteBox(mesh, usedVertices(clusters), threads));
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

namespace {

std::uint32_t bitsOf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

bool areInPlace(const MeshView& mesh, int threads, const ClusteredMesh& clusters)
{
  if (clusters.notFiniteTriangles > 0 || !isFloatAtZero(mesh, clusters.origin)) return false;
  constexpr std::size_t kChunk = 1 << 14;
  std::atomic<bool> haveMoved = false;
  parallelFor(threads, (clusters.vertexCount + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    const std::size_t end = std::min(clusters.vertexCount, (chunk + 1) * kChunk);
    if (haveMoved) return;
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const Vec3f& p = mesh.positions[clusters.vertex[i]];
      if (bitsOf(p.x) != bitsOf(clusters.x[i]) || bitsOf(p.y) != bitsOf(clusters.y[i]) ||
          bitsOf(p.z) != bitsOf(clusters.z[i])) {
        haveMoved = true;
        return;
      }
    }
  });
  return !haveMoved;
}

bool areInDisorder(const ClusteredMesh& clusters)
{
  constexpr double kOfSmoothSurfaces = 3;
  return clusters.builtExtent * std::sqrt(static_cast<double>(clusters.clusters.size())) >
         kOfSmoothSurfaces;
}

}  // namespace limn
