// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/RefineWorld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limn {
namespace {

/// Less is no turn, but rounding's.
constexpr double kLeastTurn = 1e-3;

/// Triangles of each body, and the end.
std::vector<std::size_t> firstTriangles(const WorldMesh& world)
{
  std::vector<std::size_t> first(world.firstEdge.size(), world.triangles.size());
  for (std::size_t t = world.triangles.size(); t-- > 0;)
    first[world.body[t]] = t;
  for (std::size_t body = first.size() - 1; body-- > 0;)
    first[body] = std::min(first[body], first[body + 1]);
  return first;
}

/// How much the normals turn along an edge of these triangles, in the mean of those where they do.
double meanTurn(const WorldMesh& world, const WorldNormals& normals, std::size_t first,
                std::size_t end)
{
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t t = first; t < end; ++t) {
    if (world.isBroken(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3d turn =
          vec3Cast<double>(normals.at(t, k)) - vec3Cast<double>(normals.at(t, k == 2 ? 0 : k + 1));
      const double length = std::sqrt(dot(turn, turn));
      if (!(length > kLeastTurn)) continue;
      sum += length;
      ++count;
    }
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

/// Places in a triangle by numbers i and j of steps from corner 0 to corners 1 and 2.
class Grid {
 public:
  explicit Grid(std::uint32_t k) : k_(k) {}

  std::uint32_t k() const { return k_; }
  std::uint32_t placeCount() const { return (k_ + 1) * (k_ + 2) / 2; }
  std::uint32_t place(std::uint32_t i, std::uint32_t j) const
  {
    return i * (k_ + 1) - i * (i - 1) / 2 + j;
  }
  /// Facets with two sides towards corners 1 and 2, and those that stand on their head.
  std::uint32_t up(std::uint32_t i, std::uint32_t j) const { return rowStart(i) + 2 * j; }
  std::uint32_t down(std::uint32_t i, std::uint32_t j) const { return rowStart(i) + 2 * j + 1; }
  /// The facet at step s of the side from a corner to the next.
  std::uint32_t atSide(int corner, std::uint32_t s) const
  {
    return corner == 0 ? up(s, 0) : corner == 1 ? up(k_ - s - 1, s) : up(0, k_ - s - 1);
  }
  /// The place at step s of that side.
  std::uint32_t sidePlace(int corner, std::uint32_t s) const
  {
    return corner == 0 ? place(s, 0) : corner == 1 ? place(k_ - s, s) : place(0, k_ - s);
  }

 private:
  /// Rows before hold 2 (k - i) - 1 facets each.
  std::uint32_t rowStart(std::uint32_t i) const { return i * (2 * k_ - i); }

  std::uint32_t k_;
};

/// Refines one body.
class BodyRefiner {
 public:
  BodyRefiner(const WorldMesh& from, const WorldNormals& normals, std::uint32_t k,
              RefinedWorld& refined)
      : from_(from), normals_(normals), grid_(k), refined_(refined), to_(refined.mesh)
  {
  }

  void refine(std::uint32_t body, std::size_t first, std::size_t end)
  {
    first_ = first;
    findSides(end);
    firstFacet_.assign(end - first, kNoCorner);
    for (std::size_t t = first; t < end; ++t)
      if (!from_.isBroken(t)) addFacets(t, body);
    for (std::size_t e = from_.firstEdge[body]; e < from_.firstEdge[body + 1]; ++e)
      addSideEdges(from_.edges[e]);
    if (from_.firstEdge[body] < from_.firstEdge[body + 1])
      for (std::size_t t = first; t < end; ++t)
        if (!from_.isBroken(t)) addInnerEdges(firstFacet_[t - first_]);
  }

 private:
  struct Side {
    std::uint32_t low, high;
    std::size_t corner;
    std::uint32_t normal[2];  ///< numbers, at the lower vertex and at the higher
  };
  std::uint32_t vertex(std::size_t t, int k) const { return from_.triangles[t].vertex[k]; }

  /// Gives each side of the triangles the number of its edge.
  void findSides(std::size_t end)
  {
    std::vector<Side> sides;
    for (std::size_t t = first_; t < end; ++t)
      if (!from_.isBroken(t))
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t a = vertex(t, k), b = vertex(t, k == 2 ? 0 : k + 1);
          const auto first = static_cast<std::size_t>(k);
          const std::uint32_t na = normals_.ofCorner[3 * t + first],
                              nb = normals_.ofCorner[3 * t + (first + 1) % 3];
          sides.push_back({std::min(a, b),
                           std::max(a, b),
                           3 * (t - first_) + static_cast<std::size_t>(k),
                           {a < b ? na : nb, a < b ? nb : na}});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return a.low != b.low     ? a.low < b.low
             : a.high != b.high ? a.high < b.high
                                : a.corner < b.corner;
    });
    sideOf_.assign(3 * (end - first_), 0);
    isStraight_.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i == 0 || sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high)
        isStraight_.push_back({{0, 0}});
      else
        for (std::size_t side = 0; side < 2; ++side)
          if (sides[i].normal[side] != sides[i - 1].normal[side]) isStraight_.back()[side] = 1;
      sideOf_[sides[i].corner] = static_cast<std::uint32_t>(isStraight_.size() - 1);
    }
    sidePoint_.assign(isStraight_.size(), kNoCorner);
  }
  std::size_t side(std::size_t t, int corner) const
  {
    return sideOf_[3 * (t - first_) + static_cast<std::size_t>(corner)];
  }
  Vec3d normal(std::size_t t, int k) const
  {
    return normalized(vec3Cast<double>(normals_.at(t, k)));
  }
  /// The control point next to corner `a` on the side to `b`.
  Vec3d handle(std::size_t t, int a, int b) const
  {
    const Vec3d p = from_.corner(t, a), e = from_.corner(t, b) - p;
    const int corner = b == (a == 2 ? 0 : a + 1) ? a : b;
    const std::size_t end = vertex(t, a) < vertex(t, b) ? 0 : 1;
    if (isStraight_[side(t, corner)][end] != 0) return p + e * (1.0 / 3);
    const Vec3d n = normal(t, a);
    return p + (e - n * dot(e, n)) * (1.0 / 3);
  }
  std::uint32_t addPoint(Vec3d curved, Vec3d flat)
  {
    to_.points.push_back(curved);
    refined_.flat.push_back(flat);
    return static_cast<std::uint32_t>(to_.points.size() - 1);
  }

  /// Points inside of a side, in the order from its lower vertex, made when first met.
  std::uint32_t sidePoints(std::size_t t, int corner)
  {
    std::uint32_t& first = sidePoint_[side(t, corner)];
    if (first != kNoCorner) return first;
    int a = corner, b = corner == 2 ? 0 : corner + 1;
    if (vertex(t, a) > vertex(t, b)) std::swap(a, b);
    const Vec3d p = from_.corner(t, a), q = from_.corner(t, b);
    const Vec3d p1 = handle(t, a, b), q1 = handle(t, b, a);
    first = static_cast<std::uint32_t>(to_.points.size());
    for (std::uint32_t s = 1; s < grid_.k(); ++s) {
      const double y = static_cast<double>(s) / grid_.k(), x = 1 - y;
      addPoint((p * (x * x * x) + p1 * (3 * x * x * y)) + (q1 * (3 * x * y * y) + q * (y * y * y)),
               p * x + q * y);
    }
    return first;
  }

  void addFacets(std::size_t t, std::uint32_t body)
  {
    placePoints(t);
    placeNormals(t);
    firstFacet_[t - first_] = static_cast<std::uint32_t>(to_.triangles.size());
    const auto firstNormal =
        static_cast<std::uint32_t>(refined_.normals.normals.size()) - grid_.placeCount();
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      to_.triangles.push_back({{point_[a], point_[b], point_[c]}});
      to_.body.push_back(body);
      for (const std::uint32_t place : {a, b, c})
        refined_.normals.ofCorner.push_back(firstNormal + place);
    };
    const std::uint32_t k = grid_.k();
    for (std::uint32_t i = 0; i < k; ++i)
      for (std::uint32_t j = 0; i + j < k; ++j) {
        add(grid_.place(i, j), grid_.place(i + 1, j), grid_.place(i, j + 1));
        if (i + j + 1 < k)
          add(grid_.place(i + 1, j), grid_.place(i + 1, j + 1), grid_.place(i, j + 1));
      }
  }
  void placePoints(std::size_t t)
  {
    const std::uint32_t k = grid_.k();
    point_.assign(grid_.placeCount(), 0);
    for (int c = 0; c < 3; ++c) {
      point_[grid_.sidePlace(c, 0)] = vertex(t, c);
      const std::uint32_t first = sidePoints(t, c);
      const bool isForward = vertex(t, c) < vertex(t, c == 2 ? 0 : c + 1);
      for (std::uint32_t s = 1; s < k; ++s)
        point_[grid_.sidePlace(c, s)] = first + (isForward ? s : k - s) - 1;
    }
    const Vec3d p[3] = {from_.corner(t, 0), from_.corner(t, 1), from_.corner(t, 2)};
    Vec3d h[3][2];  // at a corner, to the next and to the one before
    Vec3d sum = {0, 0, 0};
    for (int c = 0; c < 3; ++c) {
      h[c][0] = handle(t, c, c == 2 ? 0 : c + 1);
      h[c][1] = handle(t, c, c == 0 ? 2 : c - 1);
      sum = sum + (h[c][0] + h[c][1]);
    }
    const Vec3d mean = sum * (1.0 / 6), centre = (p[0] + p[1] + p[2]) * (1.0 / 3);
    const Vec3d middle = mean + (mean - centre) * 0.5;
    for (std::uint32_t i = 1; i < k; ++i)
      for (std::uint32_t j = 1; i + j < k; ++j) {
        const double v = static_cast<double>(i) / k, w = static_cast<double>(j) / k, u = 1 - v - w;
        const Vec3d corners = (p[0] * (u * u * u) + p[1] * (v * v * v)) + p[2] * (w * w * w);
        const Vec3d sides = (h[0][0] * (u * u * v) + h[1][1] * (u * v * v)) +
                            (h[1][0] * (v * v * w) + h[2][1] * (v * w * w)) +
                            (h[2][0] * (w * w * u) + h[0][1] * (w * u * u));
        point_[grid_.place(i, j)] = addPoint((corners + sides * 3.0) + middle * (6 * u * v * w),
                                             (p[0] * u + p[1] * v) + p[2] * w);
      }
  }

  /// Between two of a triangle's normals, as on an edge e from the first to the second.
  static Vec3d between(Vec3d n0, Vec3d n1, Vec3d e)
  {
    const Vec3d sum = n0 + n1;
    const double squared = dot(e, e);
    return normalized(sum - e * (squared > 0 ? 2 * dot(e, sum) / squared : 0));
  }
  void placeNormals(std::size_t t)
  {
    const Vec3d n[3] = {normal(t, 0), normal(t, 1), normal(t, 2)};
    Vec3d m[3];  // of the side from a corner to the next
    for (int c = 0; c < 3; ++c) {
      int a = c, b = c == 2 ? 0 : c + 1;
      if (vertex(t, a) > vertex(t, b)) std::swap(a, b);
      m[c] = between(n[a], n[b], from_.corner(t, b) - from_.corner(t, a));
    }
    const std::uint32_t k = grid_.k();
    std::vector<Vec3f>& to = refined_.normals.normals;
    const std::size_t first = to.size();
    to.resize(first + grid_.placeCount());
    for (std::uint32_t i = 0; i <= k; ++i)
      for (std::uint32_t j = 0; i + j <= k; ++j) {
        const double v = static_cast<double>(i) / k, w = static_cast<double>(j) / k,
                     u = static_cast<double>(k - i - j) / k;
        const Vec3d ends = (n[0] * (u * u) + n[1] * (v * v)) + n[2] * (w * w);
        const Vec3d sides = (m[0] * (2 * u * v) + m[1] * (2 * v * w)) + m[2] * (2 * w * u);
        to[first + grid_.place(i, j)] = vec3Cast<float>(normalized(ends + sides));
      }
    // The same bits on both sides of an edge, and those of the vertices.
    for (int c = 0; c < 3; ++c) {
      to[first + grid_.sidePlace(c, 0)] = normals_.at(t, c);
      int a = c, b = c == 2 ? 0 : c + 1;
      const bool isForward = vertex(t, a) < vertex(t, b);
      if (!isForward) std::swap(a, b);
      for (std::uint32_t s = 1; s < k; ++s) {
        const double y = static_cast<double>(isForward ? s : k - s) / k, x = 1 - y;
        to[first + grid_.sidePlace(c, s)] =
            vec3Cast<float>(normalized((n[a] * (x * x) + m[c] * (2 * x * y)) + n[b] * (y * y)));
      }
    }
  }

  void addEdge(std::uint32_t a, std::uint32_t b, std::uint32_t first, std::uint32_t second,
               bool isWoundAlike)
  {
    to_.edges.push_back({{std::min(a, b), std::max(a, b)}, {first, second}, isWoundAlike});
  }
  void addSideEdges(const WorldEdge& edge)
  {
    const std::uint32_t k = grid_.k();
    int corner[2] = {0, 0};
    bool isForward[2] = {true, true};
    const int faces = edge.triangle[1] == kNoCorner ? 1 : 2;
    for (int f = 0; f < faces; ++f)
      for (int c = 0; c < 3; ++c) {
        const std::uint32_t a = vertex(edge.triangle[f], c),
                            b = vertex(edge.triangle[f], c == 2 ? 0 : c + 1);
        if (std::min(a, b) != edge.point[0] || std::max(a, b) != edge.point[1]) continue;
        corner[f] = c;
        isForward[f] = a == edge.point[0];
      }
    const std::uint32_t inside = sidePoints(edge.triangle[0], corner[0]);
    for (std::uint32_t s = 0; s < k; ++s) {
      std::uint32_t facet[2] = {kNoCorner, kNoCorner};
      for (int f = 0; f < faces; ++f)
        facet[f] = firstFacet_[edge.triangle[f] - first_] +
                   grid_.atSide(corner[f], isForward[f] ? s : k - 1 - s);
      addEdge(s == 0 ? edge.point[0] : inside + s - 1, s + 1 == k ? edge.point[1] : inside + s,
              facet[0], facet[1], edge.isWoundAlike);
    }
  }
  void addInnerEdges(std::uint32_t facet)
  {
    const std::uint32_t k = grid_.k();
    for (std::uint32_t i = 0; i + 1 < k; ++i)
      for (std::uint32_t j = 0; i + j + 1 < k; ++j) {
        const std::uint32_t down = facet + grid_.down(i, j);
        const auto& v = to_.triangles[down].vertex;
        addEdge(v[0], v[1], facet + grid_.up(i + 1, j), down, true);
        addEdge(v[1], v[2], facet + grid_.up(i, j + 1), down, true);
        addEdge(v[2], v[0], facet + grid_.up(i, j), down, true);
      }
  }

  const WorldMesh& from_;
  const WorldNormals& normals_;
  Grid grid_;
  RefinedWorld& refined_;
  WorldMesh& to_;
  std::size_t first_ = 0;
  std::vector<std::uint32_t> sideOf_, sidePoint_, firstFacet_, point_;
  std::vector<std::array<std::uint8_t, 2>>
      isStraight_;  ///< by edge, at its lower end and the other
};

/// Takes a body as it is.
void copyBody(const WorldMesh& world, const WorldNormals& normals, std::uint32_t body,
              std::size_t first, std::size_t end, RefinedWorld& refined)
{
  WorldMesh& to = refined.mesh;
  const auto shift = static_cast<std::uint32_t>(to.triangles.size() - first);
  const auto firstNormal = static_cast<std::uint32_t>(refined.normals.normals.size());
  refined.normals.normals.insert(refined.normals.normals.end(), normals.normals.begin(),
                                 normals.normals.end());
  for (std::size_t t = first; t < end; ++t) {
    to.triangles.push_back(world.triangles[t]);
    to.body.push_back(body);
    for (std::size_t k = 0; k < 3; ++k)
      refined.normals.ofCorner.push_back(firstNormal + normals.ofCorner[3 * t + k]);
  }
  for (std::size_t e = world.firstEdge[body]; e < world.firstEdge[body + 1]; ++e) {
    WorldEdge edge = world.edges[e];
    for (std::uint32_t& t : edge.triangle)
      if (t != kNoCorner) t += shift;
    to.edges.push_back(edge);
  }
}

}  // namespace

RefinedWorld refineWorld(WorldMesh world, WorldNormals normals)
{
  RefinedWorld refined;
  const std::vector<std::size_t> first = firstTriangles(world);
  const std::size_t bodies = first.size() - 1;
  bool isAny = false;
  for (std::size_t body = 0; body < bodies; ++body) {
    const double turn = meanTurn(world, normals, first[body], first[body + 1]);
    std::uint32_t k = 1;
    while (k < kMostFineness && turn > kFineTurn * k &&
           (k + 1) * (k + 1) * world.triangles.size() <= kMostRefined)
      ++k;
    refined.fineness.push_back(k);
    isAny = isAny || k > 1;
  }
  refined.flat = world.points;
  if (!isAny) {
    refined.mesh = std::move(world);
    refined.normals = std::move(normals);
    return refined;
  }
  refined.mesh.points = world.points;
  refined.mesh.isClosed = world.isClosed;
  refined.mesh.size = world.size;
  refined.mesh.firstEdge.push_back(0);
  for (std::uint32_t body = 0; body < bodies; ++body) {
    if (refined.fineness[body] == 1)
      copyBody(world, normals, body, first[body], first[body + 1], refined);
    else
      BodyRefiner(world, normals, refined.fineness[body], refined)
          .refine(body, first[body], first[body + 1]);
    refined.mesh.firstEdge.push_back(refined.mesh.edges.size());
  }
  return refined;
}

}  // namespace limn
