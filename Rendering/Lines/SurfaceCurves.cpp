// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/SurfaceCurves.h"

#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Base/ParallelStretches.h"

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

/// Crossings on the edges of triangles of which all vertices are chosen. `find(a, b, t)` for the
/// two vertices of an edge.
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
        for (std::size_t e = first; e < end; ++e) {
          const MeshEdge& edge = table.edges[e];
          if (!isChosen(edge.vertex[0]) || !isChosen(edge.vertex[1])) continue;
          double t;
          if (!find(edge.vertex[0], edge.vertex[1], t)) continue;
          EdgeCrossing crossing = {{kNoCorner, kNoCorner}, {}};
          for (int f = 0; f < (edge.isShared() ? 2 : 1); ++f)
            if (isWhole(edge.corner[f] / 3)) crossing.triangle[f] = edge.corner[f] / 3;
          if (crossing.triangle[0] == kNoCorner && crossing.triangle[1] == kNoCorner) continue;
          const Vec3d a = mesh.position(edge.vertex[0]);
          crossing.point = a + (mesh.position(edge.vertex[1]) - a) * t;
          found[task].push_back(crossing);
        }
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

}  // namespace

double featureSize(const MeshView& mesh)
{
  const Box box = finiteBox(mesh);
  if (box.empty()) return 1;
  const Vec3d diagonal = box.high - box.low;
  const double size = 0.025 * std::sqrt(dot(diagonal, diagonal));
  return size > 0 ? size : 1;
}

ContourLines extremeLines(const CurvedSurface& surface, const EdgeTable& table, ExtremeKind kind,
                          const CurveThresholds& thresholds, int threads)
{
  const double sign = kind == ExtremeKind::kRidge ? 1 : -1;
  const double least = thresholds.ridge / featureSize(surface.mesh);
  const auto bend = [&](std::uint32_t v) {
    return sign * static_cast<double>(surface.curvature[v].curvature[0]);
  };
  const auto isChosen = [&](std::uint32_t v) { return bend(v) > least; };
  // Along this k_1 becomes more extreme.
  const auto toMore = [&](std::uint32_t v) {
    const VertexCurvature& c = surface.curvature[v];
    return vec3Cast<double>(c.direction[0]) * (sign * static_cast<double>(c.derivative[0]));
  };
  const double size = featureSize(surface.mesh);
  const auto isCrest = [&](Vec3d change, Vec3d edge, double curvature) {
    const double squared = dot(change, change), most = std::sqrt(squared * dot(edge, edge));
    const double along = std::max(std::fabs(dot(change, edge)), kLeastCosine * most);
    return squared * (size * size) >= 2 * kLeastFall * curvature * along;
  };
  return crossedEdges(
      surface, table, threads, isChosen, [&](std::uint32_t a, std::uint32_t b, double& t) {
        const Vec3d atA = toMore(a), atB = toMore(b);
        const Vec3d e = surface.mesh.position(b) - surface.mesh.position(a);
        const double lengthA = std::sqrt(dot(atA, atA)), lengthB = std::sqrt(dot(atB, atB));
        if (!(dot(atA, atB) <= 0) || !(lengthA + lengthB > 0)) return false;
        if (!(dot(atA, e) >= 0) && !(dot(atB, e) <= 0)) return false;
        if (!isCrest(atA - atB, e, 0.5 * (bend(a) + bend(b)))) return false;
        t = lengthA / (lengthA + lengthB);
        return true;
      });
}

ContourLines suggestiveContours(const CurvedSurface& surface, const EdgeTable& table,
                                const Camera& camera, const Mat4d& modelToWorld,
                                const CurveThresholds& thresholds, int threads)
{
  // The view in the model's own space, where curvature is known.
  const Mat4d toView = camera.worldToView * modelToWorld;
  const Mat4d cofactor = cofactor3(toView);
  const double determinant = determinant3(toView);
  const auto toModel = [&](Vec3d d) {
    const auto column = [&](int c) {
      return (cofactor.m[0][c] * d.x + cofactor.m[1][c] * d.y) + cofactor.m[2][c] * d.z;
    };
    return Vec3d{column(0), column(1), column(2)} * (1.0 / determinant);
  };
  const std::size_t count = surface.mesh.vertexCount();
  std::vector<RadialCurvature> radial(count);
  enum Side : std::uint8_t { kBehind, kBentAway, kBentTowards };
  std::vector<Side> side(count, kBehind);
  parallelForStretches(threads, count, kPerTask,
                       [&](std::size_t, std::size_t first, std::size_t end) {
                         for (std::size_t v = first; v < end; ++v) {
                           const Vec3d p = transformPoint(toView, surface.mesh.position(v));
                           const Vec3d n = vec3Cast<double>(surface.normals[v]);
                           const Vec3d toEye = toModel(camera.parallel ? Vec3d{0, 0, 1} : -p);
                           if (!(dot(n, toEye) > 0)) continue;
                           radial[v] = radialAt(surface.curvature[v], n, normalized(toEye));
                           side[v] = radial[v].radial >= 0 ? kBentTowards : kBentAway;
                         }
                       });
  const double size = featureSize(surface.mesh);
  const double least = thresholds.suggestive / (size * size);
  const auto isChosen = [&](std::uint32_t v) { return side[v] != kBehind; };
  return crossedEdges(surface, table, threads, isChosen,
                      [&](std::uint32_t a, std::uint32_t b, double& t) {
                        if (side[a] == side[b]) return false;
                        const RadialCurvature &atA = radial[a], &atB = radial[b];
                        t = atA.radial / (atA.radial - atB.radial);
                        const double slope = atA.slope + t * (atB.slope - atA.slope);
                        const double facing = atA.facing + t * (atB.facing - atA.facing);
                        return slope > least * facing;
                      });
}

}  // namespace limn
