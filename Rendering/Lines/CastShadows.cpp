// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CastShadows.h"

#include "Rendering/Lines/ShadowPlane.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn {
namespace {

constexpr std::size_t kEdgesPerTask = 512;
/// The part of an edge that a cone holds.
bool clipToCone(const LightRays& light, Vec3d a, Vec3d b, double& low, double& high)
{
  low = 0;
  high = 1;
  if (!light.isCone) return true;
  const auto at = [&](double u) { return a + (b - a) * u; };
  const auto depth = [&](double u) {
    const Vec3d way = at(u) - light.source;
    return dot(way, light.axis) - light.cosine * std::sqrt(dot(way, way));
  };
  constexpr int kHalvings = 60;
  double best = light.holds(a) ? 0.0 : 1.0;
  if (!light.holds(a) && !light.holds(b)) {
    double left = 0, right = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const double p = left + (right - left) / 3, q = right - (right - left) / 3;
      (depth(p) < depth(q) ? left : right) = depth(p) < depth(q) ? p : q;
    }
    best = 0.5 * (left + right);
    if (!light.holds(at(best))) return false;
  }
  const auto border = [&](double outside) {
    double inside = best;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (light.holds(at(middle)) ? inside : outside) = middle;
    }
    return inside;
  };
  if (!light.holds(a)) low = border(0);
  if (!light.holds(b)) high = border(1);
  return low < high;
}

class ShadowCaster {
 public:
  ShadowCaster(const WorldMesh& world, const TriangleTree& tree, const LightRays& light,
               Span<const double> creaseDegrees)
      : world_(world), tree_(tree), light_(light)
  {
    for (const double degrees : creaseDegrees)
      cosine_.push_back(cosineOfDegrees(degrees));
  }

  void cast(std::uint32_t edge, std::vector<ShadowPiece>& pieces)
  {
    const WorldEdge& e = world_.edges[edge];
    const Vec3d a = world_.points[e.point[0]], b = world_.points[e.point[1]];
    const HalfPlane plane(light_, a, b, world_.size);
    double low, high;
    if (!plane.isProper() || !isFold(e, plane) || !clipToCone(light_, a, b, low, high)) return;
    gather(e, plane);
    slices_.clear();
    for (const std::uint32_t t : found_)
      if (Slice slice; cut(plane, t, low, high, slice)) slices_.push_back(slice);
    for (const Stretch& stretch : FirstMet(slices_).find())
      add(edge, plane, stretch, pieces);
  }

 private:
  std::uint32_t apex(const WorldEdge& edge, int face) const
  {
    for (const std::uint32_t v : world_.triangles[edge.triangle[face]].vertex)
      if (v != edge.point[0] && v != edge.point[1]) return v;
    return edge.point[0];
  }
  bool isFold(const WorldEdge& edge, const HalfPlane& plane) const
  {
    if (edge.triangle[1] == kNoCorner) return true;
    const double first = plane.side(world_.points[apex(edge, 0)]);
    const double second = plane.side(world_.points[apex(edge, 1)]);
    return (first >= 0) == (second >= 0);
  }
  Vec3d normal(std::uint32_t triangle) const
  {
    const Vec3d p = world_.corner(triangle, 0);
    return normalized(cross(world_.corner(triangle, 1) - p, world_.corner(triangle, 2) - p));
  }

  /// Triangles that the half plane may cut, by number, but for those at the edge.
  void gather(const WorldEdge& edge, const HalfPlane& plane)
  {
    found_.clear();
    tree_.visit([&](const Box& box) { return plane.meets(box); },
                [&](std::uint32_t t) {
                  if (!has(t, edge.point[0]) || !has(t, edge.point[1])) found_.push_back(t);
                });
    std::sort(found_.begin(), found_.end());
  }
  bool has(std::uint32_t triangle, std::uint32_t point) const
  {
    const auto& v = world_.triangles[triangle].vertex;
    return v[0] == point || v[1] == point || v[2] == point;
  }
  /// Whether a piece is one that a smooth surface does not show: near its edge, or where the ray
  /// has gone into the body, as it does where facets make dents that the surface has not.
  bool isSpared(const WorldEdge& edge, const HalfPlane& plane, const ShadowPiece& piece) const
  {
    const std::uint32_t t = piece.receiver, body = world_.body[t];
    if (edge.triangle[1] == kNoCorner || body != world_.body[edge.triangle[0]]) return false;
    const Vec3d first = normal(edge.triangle[0]), own = normal(t);
    Vec3d second = normal(edge.triangle[1]);
    if (!edge.isWoundAlike) second = -second;
    if (dot(first, second) < cosine_[body]) return false;
    const Vec3d a = world_.points[edge.point[0]], b = world_.points[edge.point[1]];
    const Vec3d c = world_.points[apex(edge, 0)], d = world_.points[apex(edge, 1)];
    const bool bulgesOut = dot(first, d - a) < 0;
    const bool showsOut = dot(own, light_.towardLight(world_.corner(t, 0))) > 0;
    if (edge.isWoundAlike && bulgesOut != showsOut) return true;
    if (dot(own, first) < cosine_[body] && dot(own, second) < cosine_[body]) return false;
    const Vec3d areaC = cross(b - a, c - a), areaD = cross(b - a, d - a);
    const double wide = std::max(dot(areaC, areaC), dot(areaD, areaD)) / dot(b - a, b - a);
    const Vec3d from = piece.from - plane.point(piece.u0, 0),
                to = piece.to - plane.point(piece.u1, 0);
    return std::max(dot(from, from), dot(to, to)) < kShadowFacets * kShadowFacets * wide;
  }

  bool cut(const HalfPlane& plane, std::uint32_t t, double low, double high, Slice& slice) const
  {
    const auto& v = world_.triangles[t].vertex;
    double side[3];
    for (int k = 0; k < 3; ++k)
      side[k] = plane.side(world_.points[v[k]]);
    Vec3d cuts[3];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = k == 2 ? 0 : k + 1;
      if ((side[k] >= 0) == (side[next] >= 0)) continue;
      // From the lower point on, so that neighbours have the same.
      const int from = v[k] < v[next] ? k : next, to = from == k ? next : k;
      const Vec3d p = world_.points[v[from]], q = world_.points[v[to]];
      cuts[count++] = p + (q - p) * (side[from] / (side[from] - side[to]));
    }
    if (count != 2) return false;
    slice.triangle = t;
    return plane.slice(cuts[0], cuts[1], low, high, slice);
  }

  void add(std::uint32_t edge, const HalfPlane& plane, Stretch stretch,
           std::vector<ShadowPiece>& pieces) const
  {
    const Slice& slice = slices_[stretch.slice];
    const double limit = -plane.contact();
    const double w0 = slice.at(stretch.u0), w1 = slice.at(stretch.u1);
    if (!(w0 < limit) && !(w1 < limit)) return;
    if (!(w0 < limit) || !(w1 < limit)) {
      const double u =
          slice.u0 + (slice.u1 - slice.u0) * ((limit - slice.w0) / (slice.w1 - slice.w0));
      (w0 < limit ? stretch.u1 : stretch.u0) = u;
    }
    if (!(stretch.u1 - stretch.u0 > kShadowSliver)) return;
    const ShadowPiece piece = {edge,
                               slice.triangle,
                               stretch.u0,
                               stretch.u1,
                               plane.point(stretch.u0, slice.at(stretch.u0)),
                               plane.point(stretch.u1, slice.at(stretch.u1))};
    if (!isSpared(world_.edges[edge], plane, piece)) pieces.push_back(piece);
  }

  const WorldMesh& world_;
  const TriangleTree& tree_;
  const LightRays& light_;
  std::vector<double> cosine_;  ///< by body
  std::vector<std::uint32_t> found_;
  std::vector<Slice> slices_;
};

/// Gives ends of pieces that meet one number.
class BorderPoints {
 public:
  BorderPoints(const WorldMesh& world, std::vector<Vec3d>& points)
      : world_(world), near_(kShadowContact * world.size), points_(points)
  {
  }

  LineLink link(const ShadowPiece& piece)
  {
    const bool goesOn = before_ != nullptr && before_->edge == piece.edge &&
                        piece.u0 - before_->u1 <= kShadowSliver && areNear(piece.from, before_->to);
    const std::uint32_t from = goesOn                      ? last_
                               : piece.u0 <= kShadowSliver ? atEnd(piece, 0, piece.from)
                                                           : add(piece.from);
    last_ = piece.u1 >= 1 - kShadowSliver ? atEnd(piece, 1, piece.to) : add(piece.to);
    before_ = &piece;
    return {from, last_, piece.receiver};
  }

 private:
  bool areNear(Vec3d a, Vec3d b) const { return dot(a - b, a - b) <= near_ * near_; }
  std::uint32_t add(Vec3d p)
  {
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  /// What other edges at that end of the edge cast there.
  std::uint32_t atEnd(const ShadowPiece& piece, int end, Vec3d p)
  {
    std::vector<std::uint32_t>& there = cast_[world_.edges[piece.edge].point[end]];
    for (const std::uint32_t point : there)
      if (areNear(points_[point], p)) return point;
    there.push_back(add(p));
    return there.back();
  }

  const WorldMesh& world_;
  double near_;
  std::vector<Vec3d>& points_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> cast_;  ///< by point of the world
  const ShadowPiece* before_ = nullptr;
  std::uint32_t last_ = 0;
};

}  // namespace

std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const TriangleTree& tree,
                                      const LightRays& light, Span<const double> creaseDegrees,
                                      int threads)
{
  const std::size_t tasks = (world.edges.size() + kEdgesPerTask - 1) / kEdgesPerTask;
  std::vector<std::vector<ShadowPiece>> found(tasks);
  parallelFor(threads, tasks, [&](std::size_t task) {
    ShadowCaster caster(world, tree, light, creaseDegrees);
    const std::size_t end = std::min(world.edges.size(), (task + 1) * kEdgesPerTask);
    for (std::size_t e = task * kEdgesPerTask; e < end; ++e)
      caster.cast(static_cast<std::uint32_t>(e), found[task]);
  });
  std::vector<ShadowPiece> pieces;
  for (const std::vector<ShadowPiece>& some : found)
    pieces.insert(pieces.end(), some.begin(), some.end());
  return pieces;
}

ContourLines shadowBorder(const WorldMesh& world, Span<const ShadowPiece> pieces, std::size_t body,
                          const Mat4d& worldToModel)
{
  ContourLines lines;
  BorderPoints ends(world, lines.points);
  std::vector<LineLink> links;
  for (const ShadowPiece& piece : pieces)
    if (piece.edge >= world.firstEdge[body] && piece.edge < world.firstEdge[body + 1])
      links.push_back(ends.link(piece));
  chainLinks(links, lines.points.size(), lines.chains, nullptr);
  for (Vec3d& p : lines.points)
    p = transformPoint(worldToModel, p);
  return lines;
}

}  // namespace limn
