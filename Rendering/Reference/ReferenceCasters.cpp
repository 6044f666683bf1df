// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceShadows.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn::reference {
namespace {

/// What stands along one side of an edge.
struct Flank {
  Vec3f atLow, atHigh;  ///< normals
  bool lowIsLit, highIsLit;
  bool runsUp;  ///< whether the triangle goes round from the lower point to the higher
};

/// Where the light's contour crosses an edge, for the triangle that it goes on in.
struct Crossing {
  std::uint32_t triangle;
  std::uint64_t place;
  Vec3d at;
  bool entersLit;  ///< going round the triangle
};

class Casters {
 public:
  Casters(const WorldMesh& world, const WorldNormals& normals, const LightRays& light)
      : world_(world), normals_(normals), light_(light)
  {
  }

  std::vector<ShadowCaster> find()
  {
    for (std::uint32_t e = 0; e < world_.edges.size(); ++e)
      addEdge(e);
    for (std::uint32_t t = 0; t < world_.triangles.size(); ++t) {
      std::vector<Crossing> here;
      for (const Crossing& crossing : crossings_)
        if (crossing.triangle == t) here.push_back(crossing);
      if (here.size() >= 2) addContour(here[0], here[1]);
    }
    return casters_;
  }

 private:
  Flank flank(const WorldEdge& edge, int face) const
  {
    const std::uint32_t t = edge.triangle[face];
    const auto& v = world_.triangles[t].vertex;
    const bool isTurned = face == 1 && !edge.isWoundAlike;
    Flank result = {};
    for (int k = 0; k < 3; ++k) {
      Vec3f n = normals_.at(t, k);
      if (isTurned) n = -n;
      const bool isLit = dot(vec3Cast<double>(n), light_.towardLight(world_.points[v[k]])) >= 0;
      if (v[k] == edge.point[0]) {
        result.atLow = n;
        result.lowIsLit = isLit;
        result.runsUp = v[(k + 1) % 3] == edge.point[1];
      } else if (v[k] == edge.point[1]) {
        result.atHigh = n;
        result.highIsLit = isLit;
      }
    }
    return result;
  }

  /// The share of an edge at which n(t).l changes its sign, n the quadratic of Vlachos et al.; on
  /// the straight edge, or on their cubic.
  double share(const WorldEdge& edge, const Flank& flank, bool isCubic) const
  {
    double low = 0, high = 1;
    for (int i = 0; i < kShadowHalvings; ++i) {
      const double t = 0.5 * (low + high), s = 1 - t;
      const Vec3d p = world_.points[edge.point[0]], q = world_.points[edge.point[1]], e = q - p;
      const Vec3d n0 = normalized(vec3Cast<double>(flank.atLow)),
                  n1 = normalized(vec3Cast<double>(flank.atHigh));
      const Vec3d sum = n0 + n1;
      const Vec3d n01 = normalized(sum - e * (dot(e, e) > 0 ? 2 * dot(e, sum) / dot(e, e) : 0));
      const Vec3d n = (n0 * (s * s) + n01 * (2 * s * t)) + n1 * (t * t);
      const bool isLit = dot(n, light_.towardLight(place(edge, flank, isCubic, t))) >= 0;
      if (isLit == flank.lowIsLit)
        low = t;
      else
        high = t;
    }
    return low;
  }
  Vec3d place(const WorldEdge& edge, const Flank& flank, bool isCubic, double t) const
  {
    const Vec3d p = world_.points[edge.point[0]], q = world_.points[edge.point[1]], e = q - p;
    const double s = 1 - t;
    if (!isCubic) return p * s + q * t;
    const Vec3d n0 = normalized(vec3Cast<double>(flank.atLow)),
                n1 = normalized(vec3Cast<double>(flank.atHigh));
    const Vec3d b210 = p + (e - n0 * dot(e, n0)) * (1.0 / 3),
                b120 = q - (e - n1 * dot(e, n1)) * (1.0 / 3);
    return (p * (s * s * s) + b210 * (3 * s * s * t)) + (b120 * (3 * s * t * t) + q * (t * t * t));
  }

  void addEdge(std::uint32_t number)
  {
    const WorldEdge& edge = world_.edges[number];
    const std::uint64_t low = edge.point[0], high = edge.point[1];
    const std::uint64_t between = world_.points.size() + 2 * std::uint64_t{number};
    const Flank first = flank(edge, 0);
    if (edge.triangle[1] == kNoCorner) {
      addPart(edge, world_.points[low], low, world_.points[high], high);
      if (first.lowIsLit != first.highIsLit)
        cross(edge, 0, first, between, place(edge, first, true, share(edge, first, true)));
      return;
    }
    const Flank second = flank(edge, 1);
    if (first.atLow == second.atLow && first.atHigh == second.atHigh) {
      if (first.lowIsLit == first.highIsLit) return;
      const Vec3d at = place(edge, first, true, share(edge, first, true));
      cross(edge, 0, first, between, at);
      cross(edge, 1, second, between, at);
      return;
    }
    // Along the edge, both sides are lit or one of them, up to where they cross.
    std::vector<std::pair<double, std::uint64_t>> stops = {{0.0, low}};
    if (first.lowIsLit != first.highIsLit) {
      stops.push_back({share(edge, first, false), between});
      cross(edge, 0, first, between, place(edge, first, false, stops.back().first));
    }
    if (second.lowIsLit != second.highIsLit) {
      stops.push_back({share(edge, second, false), between + 1});
      cross(edge, 1, second, between + 1, place(edge, second, false, stops.back().first));
    }
    std::stable_sort(stops.begin() + 1, stops.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    stops.push_back({1.0, high});
    bool casts = first.lowIsLit != second.lowIsLit;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i, casts = !casts)
      if (casts)
        addPart(edge, pointAt(edge, stops[i]), stops[i].second, pointAt(edge, stops[i + 1]),
                stops[i + 1].second);
  }
  Vec3d pointAt(const WorldEdge& edge, const std::pair<double, std::uint64_t>& stop) const
  {
    if (stop.second < world_.points.size()) return world_.points[stop.second];
    return place(edge, {}, false, stop.first);
  }
  void cross(const WorldEdge& edge, int face, const Flank& flank, std::uint64_t number, Vec3d at)
  {
    const bool isTurned = face == 1 && !edge.isWoundAlike;
    const bool startsLit = flank.runsUp ? flank.lowIsLit : flank.highIsLit;
    crossings_.push_back({edge.triangle[face], number, at, startsLit == isTurned});
  }

  std::vector<double> sides(std::uint32_t t) const
  {
    std::vector<double> result;
    for (int k = 0; k < 3; ++k) {
      const Vec3d side = world_.corner(t, (k + 1) % 3) - world_.corner(t, k);
      result.push_back(std::sqrt(dot(side, side)));
    }
    std::sort(result.begin(), result.end());
    return result;
  }
  double shortest(std::uint32_t t) const { return sides(t)[0]; }
  double longest(std::uint32_t t) const { return sides(t)[2]; }
  bool isCurved(std::uint32_t t) const
  {
    const Vec3d n = normalized(limn::cross(world_.corner(t, 1) - world_.corner(t, 0),
                                           world_.corner(t, 2) - world_.corner(t, 0)));
    for (int k = 0; k < 3; ++k) {
      const Vec3d apart = vec3Cast<double>(normals_.at(t, k)) - n;
      if (!(dot(apart, apart) <= kShadowFlat * kShadowFlat)) return true;
    }
    return false;
  }
  void addPart(const WorldEdge& edge, Vec3d from, std::uint64_t fromPlace, Vec3d to,
               std::uint64_t toPlace)
  {
    const std::uint32_t s = edge.triangle[0], t = edge.triangle[1];
    std::vector<double> gaps;
    if (isCurved(s)) gaps.push_back(kShadowFacets * shortest(s));
    if (t != kNoCorner && isCurved(t)) gaps.push_back(kShadowFacets * shortest(t));
    const double gap = gaps.empty() ? 0.0 : *std::max_element(gaps.begin(), gaps.end());
    const double reach = t == kNoCorner ? 0.0 : gap;
    casters_.push_back({{from, to},
                        {fromPlace, toPlace},
                        {s, t},
                        {edge.point[0], edge.point[1]},
                        world_.body[s],
                        true,
                        reach,
                        gap});
  }
  void addContour(const Crossing& a, const Crossing& b)
  {
    const std::uint32_t t = a.triangle;
    const Vec3d n = (vec3Cast<double>(normals_.at(t, 0)) + vec3Cast<double>(normals_.at(t, 1))) +
                    vec3Cast<double>(normals_.at(t, 2));
    // With the lit side on its left.
    const Vec3d along = a.entersLit ? a.at - b.at : b.at - a.at;
    const bool bulgesOut = dot(n, limn::cross(along, light_.towardLight(a.at))) > 0;
    if (!bulgesOut && world_.isClosed[world_.body[t]] != 0) return;
    casters_.push_back({{a.at, b.at},
                        {a.place, b.place},
                        {t, t},
                        {kNoCorner, kNoCorner},
                        world_.body[t],
                        bulgesOut,
                        kShadowFacets * longest(t),
                        std::min(kShadowFacets * longest(t), kShadowGap * shortest(t))});
  }

  const WorldMesh& world_;
  const WorldNormals& normals_;
  const LightRays& light_;
  std::vector<ShadowCaster> casters_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::vector<ShadowCaster> shadowCasters(const WorldMesh& world, const WorldNormals& normals,
                                        const LightRays& light)
{
  return Casters(world, normals, light).find();
}

}  // namespace limn::reference
