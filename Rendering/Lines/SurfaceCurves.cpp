// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/SurfaceCurves.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/FetchPosition.h"
#include "Rendering/Mesh/RecentValues.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 8192;

/// Where curvature falls by a smaller share of itself within a feature size, rounding makes the
/// extremes: on cylinders and tori.
constexpr double kLeastFall = 0.02;
/// Between an edge and the way across a ridge: edges along it say little of how curvature falls.
constexpr double kLeastCosine = 0.25;

/// A point of a curve on an edge, as the faces at it have it.
struct EdgeCrossing {
  std::uint32_t triangle[2];  ///< kNoCorner where there is none
  Vec3d point;
};

/// Joins the crossings of each triangle that has two.
ContourLines linked(const std::vector<std::vector<EdgeCrossing>>& found)
{
  struct Passage {
    std::uint32_t triangle, point;
  };
  ContourLines lines;
  std::vector<Passage> passages;
  for (const auto& some : found)
    for (const EdgeCrossing& crossing : some) {
      const auto point = static_cast<std::uint32_t>(lines.points.size());
      lines.points.push_back(crossing.point);
      for (const std::uint32_t triangle : crossing.triangle)
        if (triangle != kNoCorner) passages.push_back({triangle, point});
    }
  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.triangle < b.triangle; });
  std::vector<LineLink> links;
  for (std::size_t i = 0; i < passages.size();) {
    std::size_t next = i;
    while (next < passages.size() && passages[next].triangle == passages[i].triangle)
      ++next;
    if (next - i == 2)
      links.push_back({passages[i].point, passages[i + 1].point, passages[i].triangle});
    i = next;
  }
  chainLinks(links, lines.points.size(), lines.chains, nullptr);
  return lines;
}

/// Crossings on the edges of triangles of which all vertices are chosen. `find(first, end, found)`
/// of the edges [first, end) calls found(edge, t) for those that are crossed.
template <class Choose, class Find>
ContourLines crossedEdges(const CurvedSurface& surface, const EdgeTable& table, int threads,
                          const Choose& isChosen, const Find& find)
{
  const MeshView& mesh = surface.mesh;
  const auto isWhole = [&](std::uint32_t triangle) {
    const auto& vertex = mesh.triangles[triangle].vertex;
    return std::all_of(vertex, vertex + 3,
                       [&](std::uint32_t v) { return v < mesh.vertexCount() && isChosen(v); });
  };
  std::vector<std::vector<EdgeCrossing>> found(stretchCount(table.edges.size(), kPerTask));
  parallelForStretches(
      threads, table.edges.size(), kPerTask,
      [&](std::size_t task, std::size_t first, std::size_t end) {
        find(first, end, [&](const MeshEdge& edge, double t) {
          EdgeCrossing crossing = {{kNoCorner, kNoCorner}, {}};
          for (int f = 0; f < (edge.isShared() ? 2 : 1); ++f)
            if (isWhole(edge.corner[f] / 3)) crossing.triangle[f] = edge.corner[f] / 3;
          if (crossing.triangle[0] == kNoCorner && crossing.triangle[1] == kNoCorner) return;
          const Vec3d a = mesh.position(edge.vertex[0]);
          crossing.point = a + (mesh.position(edge.vertex[1]) - a) * t;
          found[task].push_back(crossing);
        });
      });
  return linked(found);
}

/// What suggestive contours are at a vertex.
struct RadialCurvature {
  double radial;  ///< k_r sin^2
  double slope;   ///< of it along the view, before its division by n.v
  double facing;  ///< n.v
};

RadialCurvature radialAt(const VertexCurvature& c, Vec3d n, Vec3d v)
{
  const double facing = dot(n, v);
  const double u = dot(v, vec3Cast<double>(c.direction[0]));
  const double w = dot(v, vec3Cast<double>(c.direction[1]));
  const double u2 = u * u, w2 = w * w, sum = u2 + w2;
  const auto k1 = static_cast<double>(c.curvature[0]), k2 = static_cast<double>(c.curvature[1]);
  if (!(sum > 0)) return {0, 0, facing};
  const auto d = [&](int i) { return static_cast<double>(c.derivative[i]); };
  const double cubic = u2 * (u * d(0) + 3 * w * d(1)) + w2 * (3 * u * d(2) + w * d(3));
  const double torsion = (k2 - k1) * u * w / sum;
  return {k1 * u2 + k2 * w2, cubic / sum - 2 * facing * torsion * torsion, facing};
}

/// What a camera sees of a surface's curvature.
class RadialField {
 public:
  RadialField(const CurvedSurface& surface, const Camera& camera, const Mat4d& modelToWorld)
      : surface_(surface),
        toView_(camera.worldToView * modelToWorld),
        toModel_(toView_),
        isParallel_(camera.parallel)
  {
  }

  /// Begins to read what at() reads at an edge's ends.
  void fetch(const MeshEdge& edge) const
  {
    for (const std::uint32_t vertex : edge.vertex) {
      prefetch(surface_.normals.data() + vertex);
      prefetch(surface_.curvature.data() + vertex);
      fetchPosition(surface_.mesh, vertex);
    }
  }

  bool isFront(std::uint32_t vertex) const { return dot(normal(vertex), toEye(vertex)) > 0; }
  /// Where the vertex is seen from behind, `facing` is not above 0, and the rest is 0.
  RadialCurvature at(std::uint32_t vertex) const
  {
    const Vec3d n = normal(vertex), v = toEye(vertex);
    if (!(dot(n, v) > 0)) return {0, 0, 0};
    return radialAt(surface_.curvature[vertex], n, normalized(v));
  }

 private:
  Vec3d normal(std::uint32_t vertex) const { return vec3Cast<double>(surface_.normals[vertex]); }
  /// In the model's own space, where curvature is known.
  Vec3d toEye(std::uint32_t vertex) const
  {
    return toModel_(isParallel_ ? Vec3d{0, 0, 1}
                                : -transformPoint(toView_, surface_.mesh.position(vertex)));
  }

  const CurvedSurface& surface_;
  Mat4d toView_;
  ModelDirections toModel_;
  bool isParallel_;
};

}  // namespace

ContourLines extremeLines(const CurvedSurface& surface, const EdgeTable& table, ExtremeKind kind,
                          const CurveThresholds& thresholds, double featureSize, int threads)
{
  const double sign = kind == ExtremeKind::kRidge ? 1 : -1;
  const double least = thresholds.ridge / featureSize;
  const auto bend = [&](std::uint32_t v) {
    return sign * static_cast<double>(surface.curvature[v].curvature[0]);
  };
  const auto isChosen = [&](std::uint32_t v) { return bend(v) > least; };
  // Along this k_1 becomes more extreme.
  const auto toMore = [&](std::uint32_t v) {
    const VertexCurvature& c = surface.curvature[v];
    return vec3Cast<double>(c.direction[0]) * (sign * static_cast<double>(c.derivative[0]));
  };
  const auto isCrest = [&](Vec3d change, Vec3d edge, double curvature) {
    const double squared = dot(change, change), most = std::sqrt(squared * dot(edge, edge));
    const double along = std::max(std::fabs(dot(change, edge)), kLeastCosine * most);
    return squared * (featureSize * featureSize) >= 2 * kLeastFall * curvature * along;
  };
  const auto crossing = [&](std::uint32_t a, std::uint32_t b, double& t) {
    const Vec3d atA = toMore(a), atB = toMore(b);
    const Vec3d e = surface.mesh.position(b) - surface.mesh.position(a);
    const double lengthA = std::sqrt(dot(atA, atA)), lengthB = std::sqrt(dot(atB, atB));
    if (!(dot(atA, atB) <= 0) || !(lengthA + lengthB > 0)) return false;
    if (!(dot(atA, e) >= 0) && !(dot(atB, e) <= 0)) return false;
    if (!isCrest(atA - atB, e, 0.5 * (bend(a) + bend(b)))) return false;
    t = lengthA / (lengthA + lengthB);
    return true;
  };
  return crossedEdges(surface, table, threads, isChosen,
                      [&](std::size_t first, std::size_t end, const auto& found) {
                        for (std::size_t e = first; e < end; ++e) {
                          const MeshEdge& edge = table.edges[e];
                          const std::uint32_t a = edge.vertex[0], b = edge.vertex[1];
                          double t;
                          if (isChosen(a) && isChosen(b) && crossing(a, b, t)) found(edge, t);
                        }
                      });
}

ContourLines suggestiveContours(const CurvedSurface& surface, const EdgeTable& table,
                                const CurveBounds& bounds, const Camera& camera,
                                const Mat4d& modelToWorld, const CurveThresholds& thresholds,
                                int threads)
{
  const RadialField field(surface, camera, modelToWorld);
  const BoundedCurves bounded(bounds, camera, modelToWorld);
  const double size =
      bounds.boxes.empty() ? featureSize(surface.mesh, threads) : bounds.featureSize;
  const double least = thresholds.suggestive / (size * size);
  const auto crossing = [&](const RadialCurvature& a, const RadialCurvature& b, double& t) {
    if ((a.radial >= 0) == (b.radial >= 0)) return false;
    t = a.radial / (a.radial - b.radial);
    return a.slope + t * (b.slope - a.slope) > least * (a.facing + t * (b.facing - a.facing));
  };
  return crossedEdges(
      surface, table, threads, [&](std::uint32_t v) { return field.isFront(v); },
      [&](std::size_t first, std::size_t end, const auto& found) {
        RecentValues<RadialCurvature> recent;
        const auto at = [&](std::uint32_t v) {
          return recent.at(v, [&](std::uint32_t vertex) { return field.at(vertex); });
        };
        static_assert(kPerTask % kEdgesPerBound == 0, "tasks begin where boxes do");
        forEachBoundedEdge(
            table, first, end, [&](std::size_t box) { return bounded.hasNone(box); },
            [&](const MeshEdge& edge) { field.fetch(edge); },
            [&](std::size_t e) {
              const MeshEdge& edge = table.edges[e];
              const RadialCurvature a = at(edge.vertex[0]);
              if (!(a.facing > 0)) return;
              const RadialCurvature b = at(edge.vertex[1]);
              double t;
              if (b.facing > 0 && crossing(a, b, t)) found(edge, t);
            });
      });
}

}  // namespace limn
