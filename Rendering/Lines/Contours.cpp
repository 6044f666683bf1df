// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Contours.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Lines/Facing.h"
#include "Rendering/Lines/FindCrossings.h"
#include "Rendering/Mesh/EdgesAhead.h"
#include "Rendering/Mesh/FetchPosition.h"
#include "Rendering/Mesh/RecentValues.h"
#include "Rendering/Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 8192;

/// Share of an edge's length by which facets may lie before the contour of the smooth surface.
constexpr double kFacetSlack = 0.15;

/// One side of an edge as its face has it.
struct EdgeSide {
  std::uint32_t corner[2];  ///< at the edge's two places
  bool isFront[2];

  bool crosses() const { return isFront[0] != isFront[1]; }
};

/// Where a triangle's contour comes in or goes out. Of the edges in their order.
struct Passage {
  std::uint32_t triangle, point;
};

/// What some edges add.
struct EdgeContours {
  std::vector<Vec3d> points;
  std::vector<float> lengths;  ///< of the points' edges, in view units
  std::vector<Passage> passages;
  /// Along an edge, between points: of this list, or a place of the mesh.
  struct Along {
    std::uint32_t a, b;
    bool aIsPlace, bIsPlace;
  };
  std::vector<Along> along;
};

/// Points of which only the edge is known.
struct PendingPoints {
  CrossingBatch batch;
  std::uint32_t point[CrossingBatch::kCapacity];
};

/// Edges of which the faces are looked at once they may have come from memory.
struct PendingEdges {
  static constexpr std::size_t kCapacity = 16;

  std::size_t edge[kCapacity];
  std::size_t count = 0;
};

using Fronts = RecentValues<bool>;  ///< by normal

/// Calls find(edge's number) for those of a task's edges about which a viewer may see both sides.
template <class Fetch, class Find>
void findTurning(const EdgeTable& table, const BoundedFacing& facing, std::size_t first,
                 std::size_t end, const Fetch& fetch, const Find& find)
{
  static_assert(kPerTask % kEdgesPerBound == 0, "tasks begin where boxes do");
  forEachBoundedEdge(
      table, first, end,
      [&](std::size_t box) { return facing.side(box) != BoundedFacing::Side::kBoth; }, fetch, find);
}

/// Begins to read the places of an edge's ends and its triangles.
void fetchEdge(const MeshView& mesh, const MeshEdge& edge)
{
  for (const std::uint32_t vertex : edge.vertex)
    fetchPosition(mesh, vertex);
  forEachFace(edge, [&](std::uint32_t corner) { prefetch(mesh.triangles.data() + corner / 3); });
}

class ContourFinder {
 public:
  ContourFinder(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                const FacingBounds& bounds, const Camera& camera, const Mat4d& modelToWorld,
                bool isSmooth)
      : mesh_(mesh),
        table_(table),
        arrays_(arrays),
        isSmooth_(isSmooth),
        facing_(mesh, camera, modelToWorld),
        bounds_(bounds, camera, modelToWorld),
        eye_(camera, modelToWorld)
  {
  }

  /// Of the edges [first, end).
  void add(std::size_t first, std::size_t end, EdgeContours& found) const
  {
    PendingPoints pending;
    Fronts fronts;
    PendingEdges edges;
    const auto addAll = [&] {
      for (std::size_t i = 0; i < edges.count; ++i)
        add(table_.edges[edges.edge[i]], fronts, pending, found);
      edges.count = 0;
    };
    findTurning(
        table_, bounds_, first, end,
        [&](const MeshEdge& edge) {
          arrays_.normalOfVertex.empty() ? fetch(edge) : fetchEnds(edge);
        },
        [&](std::size_t e) {
          if (isPlain(table_.edges[e], fronts)) return;
          if (!arrays_.normalOfVertex.empty()) fetch(table_.edges[e]);
          edges.edge[edges.count++] = e;
          if (edges.count == PendingEdges::kCapacity) addAll();
        });
    addAll();
    settle(pending, found);
  }

  Vec3d toward(Vec3d place) const { return eye_.toward(place); }

  /// Whether the front lies towards the viewer, as where a surface bulges; contours of others are
  /// behind the surface itself.
  bool bulges(std::uint32_t triangle) const
  {
    if (!isSmooth_) return false;
    Vec3d p[3];
    double g[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
      p[k] = facing_.inView(mesh_.triangles[triangle].vertex[k]);
      g[k] = slope(mesh_.position(mesh_.triangles[triangle].vertex[k]),
                   unit(normalNumber(3 * triangle + k)));
    }
    const Vec3d e1 = p[1] - p[0], e2 = p[2] - p[0], v = facing_.towardEye(p[0]);
    const double d11 = dot(e1, e1), d12 = dot(e1, e2), d22 = dot(e2, e2);
    const double v1 = dot(v, e1), v2 = dot(v, e2);
    return (v1 * d22 - v2 * d12) * (g[1] - g[0]) + (d11 * v2 - d12 * v1) * (g[2] - g[0]) > 0;
  }

 private:
  /// Of most edges the ends tell all there is: they have one normal each, both of one side.
  bool isPlain(const MeshEdge& edge, Fronts& fronts) const
  {
    if (arrays_.normalOfVertex.empty()) return false;
    const std::uint32_t first = arrays_.normalOfVertex[edge.vertex[0]];
    const std::uint32_t second = arrays_.normalOfVertex[edge.vertex[1]];
    return first != kNoOnlyNormal && second != kNoOnlyNormal &&
           isFrontAt(first, edge.vertex[0], fronts) == isFrontAt(second, edge.vertex[1], fronts);
  }
  void fetchEnds(const MeshEdge& edge) const
  {
    for (const std::uint32_t vertex : edge.vertex) {
      fetchPosition(mesh_, vertex);
      prefetch(arrays_.normalOfVertex.data() + vertex);
    }
  }
  void fetch(const MeshEdge& edge) const
  {
    fetchEdge(mesh_, edge);
    for (const std::uint32_t vertex : edge.vertex)
      prefetch(table_.place.data() + vertex);
    if (arrays_.normalOfCorner.empty()) return;
    forEachFace(edge,
                [this](std::uint32_t corner) { prefetch(arrays_.normalOfCorner.data() + corner); });
  }

  void add(const MeshEdge& edge, Fronts& fronts, PendingPoints& pending, EdgeContours& found) const
  {
    EdgeSide sides[2] = {side(edge, 0, fronts), {}};
    sides[1] = edge.isShared() ? side(edge, 1, fronts) : sides[0];
    if (sides[0].isFront[0] == sides[0].isFront[1] && sides[0].isFront[0] == sides[1].isFront[0] &&
        sides[0].isFront[0] == sides[1].isFront[1])
      return;
    const bool isSmooth =
        normal(sides[0], 0) == normal(sides[1], 0) && normal(sides[0], 1) == normal(sides[1], 1);
    if (isSmooth) {
      if (!sides[0].crosses()) return;
      const std::uint32_t point =
          addPoint(edge, found, isSmooth_ ? Vec3d{0, 0, 0} : crossing(edge, sides[0]).second);
      if (isSmooth_) addPending(edge, sides[0], point, pending);
      if (pending.batch.count == CrossingBatch::kCapacity) settle(pending, found);
      for (int f = 0; f < (edge.isShared() ? 2 : 1); ++f)
        found.passages.push_back({edge.corner[f] / 3, point});
      return;
    }
    addAlong(edge, sides, found);
  }

  void addPending(const MeshEdge& edge, const EdgeSide& side, std::uint32_t point,
                  PendingPoints& pending) const
  {
    pending.point[pending.batch.count] = point;
    pending.batch.add(curveOf(edge, side), side.isFront[0]);
  }
  void settle(PendingPoints& pending, EdgeContours& found) const
  {
    findCrossings(eye_.place, eye_.isParallel, pending.batch);
    for (std::size_t i = 0; i < pending.batch.count; ++i)
      found.points[pending.point[i]] = pending.batch.place(i);
    pending.batch.count = 0;
  }

  double viewLength(const MeshEdge& edge) const
  {
    const Vec3d apart = facing_.inView(edge.vertex[0]) - facing_.inView(edge.vertex[1]);
    return std::sqrt(dot(apart, apart));
  }

  std::uint32_t normalNumber(std::uint32_t corner) const
  {
    return arrays_.normalOfCorner.empty() ? mesh_.triangles[corner / 3].vertex[corner % 3]
                                          : arrays_.normalOfCorner[corner];
  }
  Vec3d unit(std::uint32_t normal) const
  {
    return normalized(vec3Cast<double>(arrays_.vertexNormals[normal]));
  }
  Vec3d normal(const EdgeSide& side, int end) const { return unit(normalNumber(side.corner[end])); }
  /// n.v times lengths, above 0 in front.
  double slope(Vec3d position, Vec3d normal) const { return dot(normal, eye_.toward(position)); }

  EdgeSide side(const MeshEdge& edge, int face, Fronts& fronts) const
  {
    const std::uint32_t corner = edge.corner[face];
    const std::uint32_t next = nextCorner(corner);
    const bool isForward = table_.runsForward(mesh_, edge, face);
    EdgeSide result;
    result.corner[0] = isForward ? corner : next;
    result.corner[1] = isForward ? next : corner;
    for (int end = 0; end < 2; ++end)
      result.isFront[end] = isFrontAt(normalNumber(result.corner[end]), edge.vertex[end], fronts);
    return result;
  }
  bool isFrontAt(std::uint32_t normal, std::uint32_t vertex, Fronts& fronts) const
  {
    return fronts.at(normal, [&](std::uint32_t number) {
      return slope(mesh_.position(vertex), vec3Cast<double>(arrays_.vertexNormals[number])) >= 0;
    });
  }

  EdgeCurve curveOf(const MeshEdge& edge, const EdgeSide& side) const
  {
    const Vec3d p = mesh_.position(edge.vertex[0]), q = mesh_.position(edge.vertex[1]);
    const Vec3d n0 = normal(side, 0), n1 = normal(side, 1);
    const Vec3d e = q - p, sum = n0 + n1;
    const double squared = dot(e, e);
    const Vec3d middle = normalized(sum - e * (squared > 0 ? 2 * dot(e, sum) / squared : 0));
    const Vec3d p1 = p + (e - n0 * dot(e, n0)) * (1.0 / 3),
                q1 = q - (e - n1 * dot(e, n1)) * (1.0 / 3);
    return {{p, p1, q1, q}, {n0, middle, n1}};
  }

  /// Share of a straight edge, and place, where a side that crosses does so.
  std::pair<double, Vec3d> crossing(const MeshEdge& edge, const EdgeSide& side) const
  {
    const EdgeCurve curve = curveOf(edge, side);
    const auto place = [&](double t) { return curve.point[0] * (1 - t) + curve.point[3] * t; };
    double low = 0, high = 1;
    for (int i = 0; i < kCrossingHalvings; ++i) {
      const double t = 0.5 * (low + high), s = 1 - t;
      const Vec3d n = isSmooth_ ? (curve.normal[0] * (s * s) + curve.normal[1] * (2 * s * t)) +
                                      curve.normal[2] * (t * t)
                                : curve.normal[0] * s + curve.normal[2] * t;
      const bool isFront = slope(place(t), n) >= 0;
      (isFront == side.isFront[0] ? low : high) = t;
    }
    return {low, place(low)};
  }

  std::uint32_t addPoint(const MeshEdge& edge, EdgeContours& found, Vec3d place) const
  {
    found.points.push_back(place);
    found.lengths.push_back(static_cast<float>(viewLength(edge)));
    return static_cast<std::uint32_t>(found.points.size() - 1);
  }

  /// Both sides' crossings, and the edge itself where one side is front and the other is not.
  void addAlong(const MeshEdge& edge, const EdgeSide (&sides)[2], EdgeContours& found) const
  {
    struct Stop {
      double t;
      std::uint32_t point;
      bool isPlace;
    };
    std::vector<Stop> stops = {{0, edge.vertex[0], true}};
    for (int f = 0; f < 2; ++f) {
      if (!sides[f].crosses()) continue;
      const auto [t, place] = crossing(edge, sides[f]);
      const std::uint32_t point = addPoint(edge, found, place);
      found.passages.push_back({edge.corner[f] / 3, point});
      stops.push_back({t, point, false});
    }
    if (stops.size() == 3 && stops[2].t < stops[1].t) std::swap(stops[1], stops[2]);
    stops.push_back({1, edge.vertex[1], true});
    bool differs = sides[0].isFront[0] != sides[1].isFront[0];
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (differs)
        found.along.push_back(
            {stops[i].point, stops[i + 1].point, stops[i].isPlace, stops[i + 1].isPlace});
      differs = !differs;
    }
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  const FeatureArrays& arrays_;
  bool isSmooth_;
  Facing facing_;
  BoundedFacing bounds_;
  ModelEye eye_;
};

/// Puts what the edges found together.
class ContourAssembler {
 public:
  explicit ContourAssembler(const MeshView& mesh) : mesh_(mesh) {}

  void add(const EdgeContours& some)
  {
    const auto first = static_cast<std::uint32_t>(lines_.points.size());
    lines_.points.insert(lines_.points.end(), some.points.begin(), some.points.end());
    lengths_.insert(lengths_.end(), some.lengths.begin(), some.lengths.end());
    for (const Passage& passage : some.passages)
      passages_.push_back({passage.triangle, passage.point + first});
    for (const EdgeContours::Along& along : some.along)
      along_.push_back({along.aIsPlace ? along.a : along.a + first,
                        along.bIsPlace ? along.b : along.b + first, along.aIsPlace,
                        along.bIsPlace});
  }

  ContourLines assemble(const ContourFinder& finder, std::uint8_t flag)
  {
    lines_.slack.assign(lines_.points.size(), 0.0f);
    linkTriangles(finder);
    linkEdges();
    lines_.slack.resize(lines_.points.size(), 0.0f);
    std::vector<std::uint32_t> links;
    chainLinks(links_, lines_.points.size(), lines_.chains, &links);
    for (const std::uint32_t link : links)
      lines_.facets.push_back(link != kNoCorner ? facets_[link] : kNoFacet);
    lines_.chains.flags.assign(lines_.chains.vertex.size(), flag);
    for (std::size_t c = 0; c + 1 < lines_.chains.first.size(); ++c)
      concealBehindTurns(finder, lines_.chains.first[c], lines_.chains.first[c + 1] - 1);
    return std::move(lines_);
  }

 private:
  static constexpr ContourFacet kNoFacet = {kNoCorner, false};

  void addLink(std::uint32_t a, std::uint32_t b, ContourFacet facet)
  {
    links_.push_back({a, b, static_cast<std::uint32_t>(links_.size())});
    facets_.push_back(facet);
  }
  void linkTriangles(const ContourFinder& finder)
  {
    std::stable_sort(passages_.begin(), passages_.end(),
                     [](const Passage& a, const Passage& b) { return a.triangle < b.triangle; });
    for (std::size_t i = 0; i + 1 < passages_.size(); ++i) {
      const Passage a = passages_[i], b = passages_[i + 1];
      if (a.triangle != b.triangle) continue;
      const bool bulges = finder.bulges(a.triangle);
      addLink(a.point, b.point, {a.triangle, bulges});
      if (bulges)
        for (const std::uint32_t point : {a.point, b.point})
          lines_.slack[point] = static_cast<float>(kFacetSlack) * lengths_[point];
      ++i;
    }
  }
  void linkEdges()
  {
    std::vector<std::uint32_t> places;
    for (const EdgeContours::Along& along : along_) {
      if (along.aIsPlace) places.push_back(along.a);
      if (along.bIsPlace) places.push_back(along.b);
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto first = static_cast<std::uint32_t>(lines_.points.size());
    for (const std::uint32_t place : places)
      lines_.points.push_back(mesh_.position(place));
    const auto pointOf = [&](std::uint32_t number, bool isPlace) {
      if (!isPlace) return number;
      const auto at = std::lower_bound(places.begin(), places.end(), number);
      return first + static_cast<std::uint32_t>(at - places.begin());
    };
    for (const EdgeContours::Along& along : along_)
      addLink(pointOf(along.a, along.aIsPlace), pointOf(along.b, along.bIsPlace), kNoFacet);
  }

  /// Of the chain whose points are [first, last].
  void concealBehindTurns(const ContourFinder& finder, std::size_t first, std::size_t last)
  {
    const std::vector<std::uint32_t>& vertex = lines_.chains.vertex;
    const std::size_t count = last - first;
    const bool isClosed = count > 2 && vertex[first] == vertex[last];
    for (std::size_t i = isClosed ? 0 : 1; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      const ContourFacet a = lines_.facets[first + before], b = lines_.facets[first + i];
      if (a.triangle == kNoCorner || b.triangle == kNoCorner || a.bulges == b.bulges) continue;
      const Vec3d in = along(first + before), out = along(first + i);
      const Vec3d toward = normalized(finder.toward(lines_.points[vertex[first + i]]));
      const Vec3d farther = a.bulges ? -toward : toward;  // from the turn on, or up to there
      const double inFarther = dot(in, farther), outFarther = dot(out, farther);
      if (!(inFarther > 0 && outFarther > 0)) continue;
      // On the screen, across the gaze, they run against each other.
      if (!(dot(in, out) < inFarther * outFarther)) continue;
      const std::size_t most = isClosed ? count : a.bulges ? count - i : i;
      for (std::size_t k = 0; k < most; ++k) {
        const std::size_t place = a.bulges ? i + k : before + count - k;
        if (!conceal(first + place % count, farther)) break;
      }
    }
  }
  /// A segment, if it does not bulge and goes on farther.
  bool conceal(std::size_t segment, Vec3d farther)
  {
    const ContourFacet facet = lines_.facets[segment];
    if (facet.triangle == kNoCorner || facet.bulges) return false;
    if (!(dot(along(segment), farther) > 0)) return false;
    lines_.chains.flags[segment] |= kConcealedLine;
    return true;
  }
  Vec3d along(std::size_t segment) const
  {
    const std::vector<std::uint32_t>& vertex = lines_.chains.vertex;
    return lines_.points[vertex[segment + 1]] - lines_.points[vertex[segment]];
  }

  const MeshView& mesh_;
  ContourLines lines_;
  std::vector<float> lengths_;
  std::vector<Passage> passages_;
  std::vector<EdgeContours::Along> along_;
  std::vector<LineLink> links_;
  std::vector<ContourFacet> facets_;  ///< by link
};

ContourLines findContours(const ContourFinder& finder, const MeshView& mesh, const EdgeTable& table,
                          std::uint8_t flag, int threads)
{
  std::vector<EdgeContours> found(stretchCount(table.edges.size(), kPerTask));
  parallelForStretches(threads, table.edges.size(), kPerTask,
                       [&](std::size_t task, std::size_t first, std::size_t end) {
                         finder.add(first, end, found[task]);
                       });
  ContourAssembler assembler(mesh);
  for (const EdgeContours& some : found)
    assembler.add(some);
  return assembler.assemble(finder, flag);
}

}  // namespace

EdgeChains silhouetteEdges(const MeshView& mesh, const EdgeTable& table, const FacingBounds& bounds,
                           const Camera& camera, const Mat4d& modelToWorld, int threads)
{
  const Facing facing(mesh, camera, modelToWorld);
  const BoundedFacing bounded(bounds, camera, modelToWorld);
  std::vector<std::vector<std::uint32_t>> found(stretchCount(table.edges.size(), kPerTask));
  parallelForStretches(
      threads, table.edges.size(), kPerTask,
      [&](std::size_t task, std::size_t first, std::size_t end) {
        RecentValues<bool> fronts;
        RecentValues<Vec3d> places;
        const auto inView = [&](std::uint32_t vertex) {
          return places.at(vertex, [&](std::uint32_t v) { return facing.inView(v); });
        };
        const auto isFront = [&](std::uint32_t corner) {
          return fronts.at(corner / 3, [&](std::uint32_t face) {
            const auto [a, b, c] = mesh.triangles[face].vertex;
            return facing.isFront(inView(a), inView(b), inView(c));
          });
        };
        findTurning(
            table, bounded, first, end, [&](const MeshEdge& edge) { fetchEdge(mesh, edge); },
            [&](std::size_t e) {
              const MeshEdge& edge = table.edges[e];
              if (!edge.isShared()) return;
              const bool isTurned = isFront(edge.corner[0]) != isFront(edge.corner[1]);
              if (isTurned == (table.woundAlike[e] != 0))
                found[task].push_back(static_cast<std::uint32_t>(e));
            });
      });
  std::vector<std::uint32_t> chosen;
  for (const auto& some : found)
    chosen.insert(chosen.end(), some.begin(), some.end());
  EdgeChains chains = chainEdges(table, chosen);
  chains.chains.flags.assign(chains.edge.size(), kOuterLine);
  return chains;
}

ContourLines smoothContours(const MeshView& mesh, const EdgeTable& table,
                            const FeatureArrays& arrays, const FacingBounds& bounds,
                            const Camera& camera, const Mat4d& modelToWorld, int threads)
{
  return findContours(ContourFinder(mesh, table, arrays, bounds, camera, modelToWorld, true), mesh,
                      table, kOuterLine, threads);
}

ContourLines facetContours(const MeshView& mesh, const EdgeTable& table,
                           const FeatureArrays& arrays, const FacingBounds& bounds,
                           const Camera& camera, const Mat4d& modelToWorld, int threads)
{
  return findContours(ContourFinder(mesh, table, arrays, bounds, camera, modelToWorld, false), mesh,
                      table, 0, threads);
}

}  // namespace limn
