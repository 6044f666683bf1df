// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/EdgeTable.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/WeldVertices.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kTrianglesPerTask = 8192;
constexpr std::size_t kVerticesPerTask = 8192;
constexpr std::size_t kEdgesPerTask = 8192;

std::size_t taskCount(std::size_t count, std::size_t perTask)
{
  return (count + perTask - 1) / perTask;
}

/// One side of a triangle, at the lower of its two places.
struct HalfEdge {
  std::uint32_t end;  ///< the higher place
  std::uint32_t corner;
};

class EdgeBuilder {
 public:
  EdgeBuilder(const MeshView& mesh, int threads, EdgeTable& table)
      : mesh_(mesh), threads_(threads), table_(table), first_(mesh.vertexCount() + 1, 0)
  {
  }

  void build()
  {
    gather();
    const std::size_t tasks = taskCount(mesh_.vertexCount(), kVerticesPerTask);
    std::vector<std::vector<MeshEdge>> found(tasks);
    parallelFor(threads_, tasks, [&](std::size_t task) {
      const std::size_t end = std::min(mesh_.vertexCount(), (task + 1) * kVerticesPerTask);
      for (std::size_t v = task * kVerticesPerTask; v < end; ++v)
        addEdges(static_cast<std::uint32_t>(v), found[task]);
    });
    table_.edges.clear();
    for (const std::vector<MeshEdge>& some : found)
      table_.edges.insert(table_.edges.end(), some.begin(), some.end());
  }

 private:
  bool isUsed(const Triangle& triangle) const
  {
    for (const std::uint32_t v : triangle.vertex)
      if (v >= mesh_.vertexCount() || !isFinite(mesh_.position(v))) return false;
    const auto place = [&](int i) { return table_.place[triangle.vertex[i]]; };
    return place(0) != place(1) && place(1) != place(2) && place(2) != place(0);
  }
  template <class Visit>
  void forEachHalfEdge(const Visit& visit) const
  {
    parallelFor(
        threads_, taskCount(mesh_.triangles.size(), kTrianglesPerTask), [&](std::size_t task) {
          const std::size_t end = std::min(mesh_.triangles.size(), (task + 1) * kTrianglesPerTask);
          for (std::size_t t = task * kTrianglesPerTask; t < end; ++t) {
            const Triangle& triangle = mesh_.triangles[t];
            if (!isUsed(triangle)) continue;
            for (std::uint32_t k = 0; k < 3; ++k) {
              const std::uint32_t a = table_.place[triangle.vertex[k]];
              const std::uint32_t b = table_.place[triangle.vertex[(k + 1) % 3]];
              visit(std::min(a, b),
                    HalfEdge{std::max(a, b), static_cast<std::uint32_t>(3 * t) + k});
            }
          }
        });
  }

  void gather()
  {
    std::vector<std::atomic<std::uint32_t>> next(mesh_.vertexCount());
    forEachHalfEdge(
        [&](std::uint32_t v, const HalfEdge&) { next[v].fetch_add(1, std::memory_order_relaxed); });
    for (std::size_t v = 0; v < next.size(); ++v) {
      first_[v + 1] = first_[v] + next[v].load();
      next[v].store(first_[v]);
    }
    halves_.resize(first_.back());
    forEachHalfEdge([&](std::uint32_t v, const HalfEdge& half) {
      halves_[next[v].fetch_add(1, std::memory_order_relaxed)] = half;
    });
  }

  void addEdges(std::uint32_t v, std::vector<MeshEdge>& edges)
  {
    HalfEdge* const begin = halves_.data() + first_[v];
    HalfEdge* const end = halves_.data() + first_[v + 1];
    // Undoes the order in which threads came.
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.end != b.end ? a.end < b.end : a.corner < b.corner;
    });
    for (const HalfEdge* half = begin; half < end; ++half) {
      if (half > begin && half[-1].end == half->end) {
        MeshEdge& edge = edges.back();
        if (edge.faceCount == 1) edge.corner[1] = half->corner;
        ++edge.faceCount;
      } else {
        edges.push_back({{v, half->end}, {half->corner, kNoCorner}, 1});
      }
    }
  }

  const MeshView& mesh_;
  int threads_;
  EdgeTable& table_;
  std::vector<std::uint32_t> first_;
  std::vector<HalfEdge> halves_;
};

class KindFinder {
 public:
  KindFinder(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
             double creaseDegrees)
      : mesh_(mesh), table_(table), arrays_(arrays), cosine_(cosineOfDegrees(creaseDegrees))
  {
  }

  std::uint8_t kindsOf(const MeshEdge& edge) const
  {
    if (!edge.isShared()) return kBorderEdge;
    unsigned kinds = edge.faceCount > 2 ? kNonManifoldEdge : 0;
    const std::size_t cells[2] = {cellOf(edge.corner[0]), cellOf(edge.corner[1])};
    if (edge.faceCount == 2 && !arrays_.cells.empty() && cells[0] == cells[1]) return 0;
    if (isCrease(edge)) kinds |= kCreaseEdge;
    if (idOf(cells[0]) != idOf(cells[1])) kinds |= kIdEdge;
    if (splitsNormals(edge)) kinds |= kNormalEdge;
    return static_cast<std::uint8_t>(kinds);
  }

 private:
  std::size_t cellOf(std::uint32_t corner) const
  {
    return arrays_.cells.empty() ? corner / 3 : arrays_.cells[corner / 3];
  }
  std::uint32_t idOf(std::size_t cell) const
  {
    return cell < arrays_.ids.size() ? arrays_.ids[cell] : 0;
  }
  Vec3d normalOf(std::uint32_t corner) const
  {
    const auto [a, b, c] = mesh_.triangles[corner / 3].vertex;
    const Vec3d p = mesh_.position(a);
    return cross(mesh_.position(b) - p, mesh_.position(c) - p);
  }
  bool isCrease(const MeshEdge& edge) const
  {
    const Vec3d a = normalOf(edge.corner[0]), b = normalOf(edge.corner[1]);
    const double lengths = std::sqrt(dot(a, a)) * std::sqrt(dot(b, b));
    const double product = table_.isWoundAlike(mesh_, edge) ? dot(a, b) : -dot(a, b);
    return product < cosine_ * lengths;  // not without an area
  }

  Vec3d vertexNormal(std::uint32_t corner) const
  {
    const std::uint32_t number = arrays_.normalOfCorner.empty()
                                     ? mesh_.triangles[corner / 3].vertex[corner % 3]
                                     : arrays_.normalOfCorner[corner];
    return vec3Cast<double>(arrays_.vertexNormals[number]);
  }
  /// Another direction than rounding makes.
  static bool differ(Vec3d a, Vec3d b)
  {
    constexpr double kCosineOfOneDegree = 0.99984769515639124;
    return dot(a, b) < kCosineOfOneDegree * std::sqrt(dot(a, a)) * std::sqrt(dot(b, b));
  }
  static std::uint32_t nextCorner(std::uint32_t corner)
  {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
  bool splitsNormals(const MeshEdge& edge) const
  {
    if (arrays_.vertexNormals.empty()) return false;
    const std::uint32_t a = edge.corner[0], b = edge.corner[1];
    const bool isAlike = table_.isWoundAlike(mesh_, edge);
    const std::uint32_t atA = isAlike ? nextCorner(b) : b, atNext = isAlike ? b : nextCorner(b);
    return differ(vertexNormal(a), vertexNormal(atA)) ||
           differ(vertexNormal(nextCorner(a)), vertexNormal(atNext));
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  const FeatureArrays& arrays_;
  double cosine_;
};

}  // namespace

Status buildEdgeTable(const MeshView& mesh, double tolerance, int threads, EdgeTable& table)
{
  if (mesh.triangles.size() >= std::numeric_limits<std::uint32_t>::max() / 3)
    return {Error::kTooManyPrimitives,
            "The mesh has too many triangles for lines along its edges; draw it in parts, or "
            "without them."};
  table.place = weldVertices(mesh, tolerance, threads);
  EdgeBuilder(mesh, threads, table).build();
  table.woundAlike.assign(table.edges.size(), 0);
  parallelFor(threads, taskCount(table.edges.size(), kEdgesPerTask), [&](std::size_t task) {
    const std::size_t end = std::min(table.edges.size(), (task + 1) * kEdgesPerTask);
    for (std::size_t e = task * kEdgesPerTask; e < end; ++e)
      if (table.edges[e].isShared() && table.isWoundAlike(mesh, table.edges[e]))
        table.woundAlike[e] = 1;
  });
  return {};
}

std::vector<std::uint8_t> edgeKinds(const MeshView& mesh, const EdgeTable& table,
                                    const FeatureArrays& arrays, double creaseDegrees, int threads)
{
  const KindFinder finder(mesh, table, arrays, creaseDegrees);
  std::vector<std::uint8_t> kinds(table.edges.size());
  parallelFor(threads, taskCount(kinds.size(), kEdgesPerTask), [&](std::size_t task) {
    const std::size_t end = std::min(kinds.size(), (task + 1) * kEdgesPerTask);
    for (std::size_t e = task * kEdgesPerTask; e < end; ++e)
      kinds[e] = finder.kindsOf(table.edges[e]);
  });
  return kinds;
}

}  // namespace limn
