// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/EdgeTable.h"

#include "Rendering/Base/Components.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/EdgesAhead.h"
#include "Rendering/Mesh/FetchPosition.h"
#include "Rendering/Mesh/HalfEdges.h"
#include "Rendering/Mesh/RecentValues.h"
#include "Rendering/Mesh/WeldVertices.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kVerticesPerTask = 8192;
constexpr std::size_t kTrianglesPerTask = 8192;
constexpr std::size_t kEdgesPerTask = 8192;

/// By triangle: whether all its vertices are finite and in places of their own.
Array<std::uint8_t> usedTriangles(const MeshView& mesh, Span<const std::uint32_t> place,
                                  int threads)
{
  // Of vertices once: triangles in no order find these bytes in the caches.
  Array<std::uint8_t> isFiniteAt(mesh.vertexCount()), isUsed(mesh.triangles.size());
  parallelForEach(threads, isFiniteAt.size(), kVerticesPerTask,
                  [&](std::size_t v) { isFiniteAt[v] = isFinite(mesh.position(v)) ? 1 : 0; });
  parallelForEach(threads, isUsed.size(), kTrianglesPerTask, [&](std::size_t t) {
    const auto [a, b, c] = mesh.triangles[t].vertex;
    const std::size_t count = mesh.vertexCount();
    const bool counts = a < count && b < count && c < count &&
                        (isFiniteAt[a] & isFiniteAt[b] & isFiniteAt[c]) != 0 &&
                        place[a] != place[b] && place[b] != place[c] && place[c] != place[a];
    isUsed[t] = counts ? 1 : 0;
  });
  return isUsed;
}

/// Whether a half edge is not of the same edge as the one before it, in the order of HalfEdges.
bool isFirstOfEdge(Span<const HalfEdge> halves, std::size_t i)
{
  return i == 0 || halves[i - 1].end != halves[i].end;
}

/// Writes the edges whose lower place is `v`; what comes after them.
MeshEdge* writeEdges(std::uint32_t v, Span<const HalfEdge> halves, MeshEdge* out)
{
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const HalfEdge& half = halves[i];
    if (isFirstOfEdge(halves, i)) {
      *out++ = {{v, half.end}, {half.corner, kNoCorner}, 1};
    } else {
      MeshEdge& edge = out[-1];
      if (edge.faceCount == 1) edge.corner[1] = half.corner;
      ++edge.faceCount;
    }
  }
  return out;
}

void findEdges(const MeshView& mesh, int threads, EdgeTable& table)
{
  const Array<std::uint8_t> isUsed = usedTriangles(mesh, table.place, threads);
  HalfEdges halves(mesh, table.place, threads, [&](std::size_t t) { return isUsed[t] != 0; });
  // By task, first how many edges it has and then where they begin.
  std::vector<std::size_t> first(stretchCount(mesh.vertexCount(), kVerticesPerTask));
  parallelForStretches(threads, mesh.vertexCount(), kVerticesPerTask,
                       [&](std::size_t task, std::size_t begin, std::size_t end) {
                         std::size_t count = 0;
                         for (std::size_t v = begin; v < end; ++v) {
                           const std::size_t size = halves.sorted(v).size();
                           for (std::size_t i = 0; i < size; ++i)
                             count += isFirstOfEdge(halves.of(v), i) ? 1 : 0;
                         }
                         first[task] = count;
                       });
  std::size_t count = 0;
  for (std::size_t& ofTask : first)
    count += std::exchange(ofTask, count);
  table.edges.resize(count);
  table.firstEdge.resize(mesh.vertexCount() + 1);
  table.firstEdge.back() = static_cast<std::uint32_t>(count);
  parallelForStretches(threads, mesh.vertexCount(), kVerticesPerTask,
                       [&](std::size_t task, std::size_t begin, std::size_t end) {
                         MeshEdge* out = table.edges.data() + first[task];
                         for (std::size_t v = begin; v < end; ++v) {
                           table.firstEdge[v] =
                               static_cast<std::uint32_t>(out - table.edges.data());
                           out = writeEdges(static_cast<std::uint32_t>(v), halves.of(v), out);
                         }
                       });
}

class KindFinder {
 public:
  KindFinder(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
             double creaseDegrees)
      : mesh_(mesh), table_(table), arrays_(arrays), cosine_(cosineOfDegrees(creaseDegrees))
  {
  }

  /// Of the edges [first, end).
  void find(std::size_t first, std::size_t end, std::vector<std::uint8_t>& kinds) const
  {
    RecentAreas areas;
    const auto forEachUnknown = [&](const MeshEdge& edge, const auto& body) {
      forEachFace(edge, [&](std::uint32_t corner) {
        if (!areas.has(corner / 3)) body(mesh_.triangles.data() + corner / 3);
      });
    };
    forEachEdgeAhead(
        table_, first, end,
        [&](const MeshEdge& edge) {
          forEachUnknown(edge, [](const Triangle* triangle) { prefetch(triangle); });
        },
        [&](const MeshEdge& edge) {
          forEachUnknown(edge, [&](const Triangle* triangle) {
            for (const std::uint32_t v : triangle->vertex)
              fetchPosition(mesh_, v);
          });
        },
        [&](std::size_t e) { kinds[e] = kindsOf(e, areas); });
  }
  /// Of an edge that is shared.
  bool isCrease(std::size_t e) const
  {
    RecentAreas areas;
    return isCrease(e, areas);
  }

 private:
  struct Area {
    Vec3d normal;  ///< as long as twice the area
    double length;
  };
  using RecentAreas = RecentValues<Area>;  ///< by triangle

  std::uint8_t kindsOf(std::size_t e, RecentAreas& areas) const
  {
    const MeshEdge& edge = table_.edges[e];
    if (!edge.isShared()) return kBorderEdge;
    unsigned kinds = edge.faceCount > 2 ? kNonManifoldEdge : 0;
    const std::size_t cells[2] = {cellOf(edge.corner[0]), cellOf(edge.corner[1])};
    if (edge.faceCount == 2 && !arrays_.cells.empty() && cells[0] == cells[1]) return 0;
    if (isCrease(e, areas)) kinds |= kCreaseEdge;
    if (idOf(cells[0]) != idOf(cells[1])) kinds |= kIdEdge;
    if (splitsNormals(edge)) kinds |= kNormalEdge;
    return static_cast<std::uint8_t>(kinds);
  }

  std::size_t cellOf(std::uint32_t corner) const
  {
    return arrays_.cells.empty() ? corner / 3 : arrays_.cells[corner / 3];
  }
  std::uint32_t idOf(std::size_t cell) const
  {
    return cell < arrays_.ids.size() ? arrays_.ids[cell] : 0;
  }
  Area areaOf(std::uint32_t triangle) const
  {
    const auto [a, b, c] = mesh_.triangles[triangle].vertex;
    const Vec3d p = mesh_.position(a);
    const Vec3d normal = cross(mesh_.position(b) - p, mesh_.position(c) - p);
    return {normal, std::sqrt(dot(normal, normal))};
  }
  bool isCrease(std::size_t e, RecentAreas& areas) const
  {
    const MeshEdge& edge = table_.edges[e];
    const auto areaAt = [&](std::uint32_t corner) {
      return areas.at(corner / 3, [this](std::uint32_t triangle) { return areaOf(triangle); });
    };
    const Area a = areaAt(edge.corner[0]), b = areaAt(edge.corner[1]);
    const double cosine = dot(a.normal, b.normal);
    const double product = table_.woundAlike[e] != 0 ? cosine : -cosine;
    return product < cosine_ * (a.length * b.length);  // not without an area
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
  parallelForStretches(threads, table.edges.size(), kEdgesPerTask,
                       [&](std::size_t, std::size_t begin, std::size_t end) {
                         forEachEdgeAhead(
                             table, begin, end,
                             [&](const MeshEdge& edge) {
                               forEachFace(edge, [&](std::uint32_t corner) {
                                 prefetch(mesh.triangles.data() + corner / 3);
                               });
                             },
                             [](const MeshEdge&) {},
                             [&](std::size_t e) {
                               const MeshEdge& edge = table.edges[e];
                               if (edge.isShared() && table.isWoundAlike(mesh, edge))
                                 table.woundAlike[e] = 1;
                             });
                       });
  return {};
}

std::vector<std::uint8_t> edgeKinds(const MeshView& mesh, const EdgeTable& table,
                                    const FeatureArrays& arrays, double creaseDegrees, int threads)
{
  const KindFinder finder(mesh, table, arrays, creaseDegrees);
  std::vector<std::uint8_t> kinds(table.edges.size());
  parallelForStretches(
      threads, kinds.size(), kEdgesPerTask,
      [&](std::size_t, std::size_t begin, std::size_t end) { finder.find(begin, end, kinds); });
  return kinds;
}

void dropLooseCreases(const MeshView& mesh, const EdgeTable& table, unsigned drawn,
                      std::uint32_t fewest, std::vector<std::uint8_t>& kinds)
{
  if (fewest <= 1) return;
  struct End {
    std::uint32_t place, edge;  ///< in `edges`
  };
  std::vector<std::uint32_t> edges;
  std::vector<End> ends;
  for (std::size_t e = 0; e < kinds.size(); ++e) {
    if ((kinds[e] & drawn) == 0) continue;
    for (const std::uint32_t place : table.edges[e].vertex)
      ends.push_back({place, static_cast<std::uint32_t>(edges.size())});
    edges.push_back(static_cast<std::uint32_t>(e));
  }
  std::sort(ends.begin(), ends.end(), [](End a, End b) { return a.place < b.place; });
  Components groups(edges.size());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i].place == ends[i + 1].place) groups.join(ends[i].edge, ends[i + 1].edge);
  const KindFinder sharp(mesh, table, {}, kSharpDegrees);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (groups.sizeAt(i) >= fewest) continue;
    if ((kinds[edges[i]] & drawn) != kCreaseEdge || sharp.isCrease(edges[i]))
      groups.grow(i, fewest - groups.sizeAt(i));
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (groups.sizeAt(i) < fewest) kinds[edges[i]] &= static_cast<std::uint8_t>(~kCreaseEdge);
}

}  // namespace limn
