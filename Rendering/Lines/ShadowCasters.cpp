// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ShadowCasters.h"

#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kEdgesPerTask = 8192;

/// Where a triangle's contour comes in or goes out.
struct Passage {
  std::uint32_t triangle;
  std::uint64_t place;
  Vec3d at;
  bool comesIn;  ///< whether the way about the triangle, seen from outside, enters its front here
};

struct FoundCasters {
  std::vector<ShadowCaster> edges;
  std::vector<Passage> passages;
};

class CasterFinder {
 public:
  CasterFinder(const WorldMesh& world, const WorldNormals& normals, const LightRays& light)
      : world_(world), normals_(normals), light_(light)
  {
  }

  void add(std::uint32_t number, FoundCasters& found) const
  {
    const WorldEdge& edge = world_.edges[number];
    if (edge.triangle[1] == kNoCorner) {
      addBorder(edge, number, found);
      return;
    }
    const Side first = side(edge, 0), second = side(edge, 1);
    if (first.isFront[0] == first.isFront[1] && first.isFront[0] == second.isFront[0] &&
        first.isFront[0] == second.isFront[1])
      return;
    if (first.normal[0] == second.normal[0] && first.normal[1] == second.normal[1]) {
      const Vec3d at = crossing(edge, first, true).second;
      for (int f = 0; f < 2; ++f)
        found.passages.push_back(
            {edge.triangle[f], placeOf(number, 0), at, comesIn(edge, f, f == 0 ? first : second)});
      return;
    }
    addSplit(edge, number, first, second, found);
  }

  /// From outside the front lies on the left of it, and on a surface that bulges so does the light;
  /// it is on the other side from where contours turn back as the light sees them.
  ShadowCaster contour(const Passage& a, const Passage& b) const
  {
    const std::uint32_t t = a.triangle;
    Vec3d sum = {0, 0, 0};
    for (int k = 0; k < 3; ++k)
      sum = sum + vec3Cast<double>(normals_.at(t, k));
    const Vec3d along = a.comesIn ? a.at - b.at : b.at - a.at;
    const double bulge = dot(sum, cross(along, light_.towardLight(a.at)));
    const double reach = kShadowFacets * longestSide(t),
                 gap = std::min(reach, kShadowGap * shortestSide(t));
    return {{a.at, b.at},   {a.place, b.place}, {t, t}, {kNoCorner, kNoCorner},
            world_.body[t], bulge > 0,          reach,  gap};
  }

 private:
  struct Side {
    Vec3f normal[2];
    bool isFront[2];
  };

  Vec3d normal(std::uint32_t triangle, int k) const
  {
    return normalized(vec3Cast<double>(normals_.at(triangle, k)));
  }
  Side side(const WorldEdge& edge, int face) const
  {
    Side result = {};
    const auto& v = world_.triangles[edge.triangle[face]].vertex;
    for (int end = 0; end < 2; ++end)
      for (int k = 0; k < 3; ++k)
        if (v[k] == edge.point[end]) {
          result.normal[end] = normals_.at(edge.triangle[face], k);
          if (face == 1 && !edge.isWoundAlike) result.normal[end] = -result.normal[end];
          result.isFront[end] = dot(vec3Cast<double>(result.normal[end]),
                                    light_.towardLight(world_.points[v[k]])) >= 0;
        }
    return result;
  }
  bool comesIn(const WorldEdge& edge, int face, const Side& side) const
  {
    bool isForward = false;
    const auto& v = world_.triangles[edge.triangle[face]].vertex;
    for (int k = 0; k < 3; ++k)
      if (v[k] == edge.point[0]) isForward = v[k == 2 ? 0 : k + 1] == edge.point[1];
    const bool isTurned = face == 1 && !edge.isWoundAlike;
    return (side.isFront[0] == isForward) == isTurned;
  }
  std::uint64_t placeOf(std::uint32_t edge, int side) const
  {
    return world_.points.size() + 2 * std::uint64_t{edge} + static_cast<unsigned>(side);
  }

  /// Share of the edge, and place, as smoothContours() has them.
  std::pair<double, Vec3d> crossing(const WorldEdge& edge, const Side& side, bool isCurved) const
  {
    const Vec3d p = world_.points[edge.point[0]], q = world_.points[edge.point[1]];
    const Vec3d n0 = normalized(vec3Cast<double>(side.normal[0])),
                n1 = normalized(vec3Cast<double>(side.normal[1]));
    const Vec3d e = q - p, sum = n0 + n1;
    const double squared = dot(e, e);
    const Vec3d middle = normalized(sum - e * (squared > 0 ? 2 * dot(e, sum) / squared : 0));
    const Vec3d p1 = p + (e - n0 * dot(e, n0)) * (1.0 / 3),
                q1 = q - (e - n1 * dot(e, n1)) * (1.0 / 3);
    const auto place = [&](double t) {
      const double s = 1 - t;
      if (!isCurved) return p * s + q * t;
      return (p * (s * s * s) + p1 * (3 * s * s * t)) + (q1 * (3 * s * t * t) + q * (t * t * t));
    };
    double low = 0, high = 1;
    for (int i = 0; i < kShadowHalvings; ++i) {
      const double t = 0.5 * (low + high), s = 1 - t;
      const Vec3d n = (n0 * (s * s) + middle * (2 * s * t)) + n1 * (t * t);
      const bool isFront = dot(n, light_.towardLight(place(t))) >= 0;
      (isFront == side.isFront[0] ? low : high) = t;
    }
    return {low, place(low)};
  }

  void addBorder(const WorldEdge& edge, std::uint32_t number, FoundCasters& found) const
  {
    const Side only = side(edge, 0);
    addEdge(edge, {world_.points[edge.point[0]], edge.point[0]},
            {world_.points[edge.point[1]], edge.point[1]}, found);
    if (only.isFront[0] != only.isFront[1])
      found.passages.push_back({edge.triangle[0], placeOf(number, 0),
                                crossing(edge, only, true).second, comesIn(edge, 0, only)});
  }
  struct Stop {
    Vec3d at;
    std::uint64_t place;
    double t = 0;
  };
  void addEdge(const WorldEdge& edge, const Stop& from, const Stop& to, FoundCasters& found) const
  {
    const bool isBorder = edge.triangle[1] == kNoCorner;
    double gap = 0;
    for (const std::uint32_t t : edge.triangle)
      if (t != kNoCorner && !isFlat(t)) gap = std::max(gap, kShadowFacets * shortestSide(t));
    found.edges.push_back({{from.at, to.at},
                           {from.place, to.place},
                           {edge.triangle[0], edge.triangle[1]},
                           {edge.point[0], edge.point[1]},
                           world_.body[edge.triangle[0]],
                           true,
                           isBorder ? 0.0 : gap,
                           gap});
  }
  double longestSide(std::uint32_t t) const
  {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3d side = world_.corner(t, k == 2 ? 0 : k + 1) - world_.corner(t, k);
      longest = std::max(longest, dot(side, side));
    }
    return std::sqrt(longest);
  }
  double shortestSide(std::uint32_t t) const
  {
    double shortest = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
      const Vec3d side = world_.corner(t, k == 2 ? 0 : k + 1) - world_.corner(t, k);
      shortest = std::min(shortest, dot(side, side));
    }
    return std::sqrt(shortest);
  }
  bool isFlat(std::uint32_t t) const
  {
    const Vec3d a = world_.corner(t, 0);
    const Vec3d own = normalized(cross(world_.corner(t, 1) - a, world_.corner(t, 2) - a));
    for (int k = 0; k < 3; ++k) {
      const Vec3d apart = vec3Cast<double>(normals_.at(t, k)) - own;
      if (!(dot(apart, apart) <= kShadowFlat * kShadowFlat)) return false;
    }
    return true;
  }
  /// Both sides' crossings, and the edge where one side is lit and the other is not.
  void addSplit(const WorldEdge& edge, std::uint32_t number, const Side& first, const Side& second,
                FoundCasters& found) const
  {
    Stop stops[4] = {{world_.points[edge.point[0]], edge.point[0], 0}};
    int count = 1;
    for (int f = 0; f < 2; ++f) {
      const Side& side = f == 0 ? first : second;
      if (side.isFront[0] == side.isFront[1]) continue;
      const auto [t, at] = crossing(edge, side, false);
      found.passages.push_back({edge.triangle[f], placeOf(number, f), at, comesIn(edge, f, side)});
      stops[count++] = {at, placeOf(number, f), t};
    }
    if (count == 3 && stops[2].t < stops[1].t) std::swap(stops[1], stops[2]);
    stops[count++] = {world_.points[edge.point[1]], edge.point[1], 1};
    bool differs = first.isFront[0] != second.isFront[0];
    for (int i = 0; i + 1 < count; ++i) {
      if (differs) addEdge(edge, stops[i], stops[i + 1], found);
      differs = !differs;
    }
  }

  const WorldMesh& world_;
  const WorldNormals& normals_;
  const LightRays& light_;
};

}  // namespace

std::vector<ShadowCaster> shadowCasters(const WorldMesh& world, const WorldNormals& normals,
                                        const LightRays& light, int threads)
{
  const CasterFinder finder(world, normals, light);
  std::vector<FoundCasters> found(stretchCount(world.edges.size(), kEdgesPerTask));
  parallelForStretches(threads, world.edges.size(), kEdgesPerTask,
                       [&](std::size_t task, std::size_t first, std::size_t end) {
                         for (std::size_t e = first; e < end; ++e)
                           finder.add(static_cast<std::uint32_t>(e), found[task]);
                       });
  std::vector<ShadowCaster> casters;
  std::vector<Passage> passages;
  for (const FoundCasters& some : found) {
    casters.insert(casters.end(), some.edges.begin(), some.edges.end());
    passages.insert(passages.end(), some.passages.begin(), some.passages.end());
  }
  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.triangle < b.triangle; });
  for (std::size_t i = 0; i + 1 < passages.size(); ++i)
    if (passages[i].triangle == passages[i + 1].triangle) {
      const ShadowCaster caster = finder.contour(passages[i], passages[i + 1]);
      if (caster.bulgesOut || !world.isClosed[caster.body]) casters.push_back(caster);
      ++i;
    }
  return casters;
}

}  // namespace limn
