// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/EdgeTable.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/HalfEdges.h"
#include "Rendering/Mesh/WeldVertices.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kVerticesPerTask = 8192;
constexpr std::size_t kEdgesPerTask = 8192;

bool isUsed(const MeshView& mesh, const EdgeTable& table, const Triangle& triangle)
{
  for (const std::uint32_t v : triangle.vertex)
    if (v >= mesh.vertexCount() || !isFinite(mesh.position(v))) return false;
  const auto place = [&](int i) { return table.place[triangle.vertex[i]]; };
  return place(0) != place(1) && place(1) != place(2) && place(2) != place(0);
}

/// Appends the edges whose lower place is `v`.
void addEdges(std::uint32_t v, Span<const HalfEdge> halves, std::vector<MeshEdge>& edges)
{
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const HalfEdge& half = halves[i];
    if (i > 0 && halves[i - 1].end == half.end) {
      MeshEdge& edge = edges.back();
      if (edge.faceCount == 1) edge.corner[1] = half.corner;
      ++edge.faceCount;
    } else {
      edges.push_back({{v, half.end}, {half.corner, kNoCorner}, 1});
    }
  }
}

void findEdges(const MeshView& mesh, int threads, EdgeTable& table)
{
  HalfEdges halves(mesh, table.place, threads,
                   [&](std::size_t t) { return isUsed(mesh, table, mesh.triangles[t]); });
  std::vector<std::vector<MeshEdge>> found(stretchCount(mesh.vertexCount(), kVerticesPerTask));
  parallelFor(threads, found.size(), [&](std::size_t task) {
    const std::size_t end = std::min(mesh.vertexCount(), (task + 1) * kVerticesPerTask);
    for (std::size_t v = task * kVerticesPerTask; v < end; ++v) {
      const Span<HalfEdge> at = halves.sorted(v);
      addEdges(static_cast<std::uint32_t>(v), {at.data(), at.size()}, found[task]);
    }
  });
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const std::vector<MeshEdge>& some : found) {
    first.push_back(count);
    count += some.size();
  }
  table.edges.resize(count);
  parallelFor(threads, found.size(), [&](std::size_t task) {
    std::copy(found[task].begin(), found[task].end(),
              table.edges.begin() + static_cast<std::ptrdiff_t>(first[task]));
  });
}

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
  findEdges(mesh, threads, table);
  table.woundAlike.assign(table.edges.size(), 0);
  parallelFor(threads, stretchCount(table.edges.size(), kEdgesPerTask), [&](std::size_t task) {
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
  parallelFor(threads, stretchCount(kinds.size(), kEdgesPerTask), [&](std::size_t task) {
    const std::size_t end = std::min(kinds.size(), (task + 1) * kEdgesPerTask);
    for (std::size_t e = task * kEdgesPerTask; e < end; ++e)
      kinds[e] = finder.kindsOf(table.edges[e]);
  });
  return kinds;
}

}  // namespace limn
