// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceShadows.h"

#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>

namespace limn::reference {
namespace {

/// A triangle's corners in the order of their numbers.
Triangle sorted(Triangle triangle)
{
  std::sort(triangle.vertex, triangle.vertex + 3);
  return triangle;
}

double size1(Vec3d v)
{
  return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z);
}

/// Whether the edge from p to q goes through a triangle, and where. What touches it counts as moved
/// if `isMoved`, else the triangle does.
bool goesThrough(const WorldMesh& world, std::uint32_t p, std::uint32_t q, std::uint32_t triangle,
                 bool isMoved, CutPoint& cut)
{
  const Triangle through = sorted(world.triangles[triangle]);
  const Vec3d a = world.points[through.vertex[0]], b = world.points[through.vertex[1]],
              c = world.points[through.vertex[2]];
  const Vec3d from = world.points[p], to = world.points[q];
  const Vec3d n = cross(b - a, c - a);
  const double atFrom = dot(n, from - a), atTo = dot(n, to - a);
  const double rounding = kCutRounding * world.size;
  const auto isAbove = [&](double volume, double area, Vec3d gradient) {
    if (std::fabs(volume) > rounding * area) return volume > 0;
    return (dot(gradient, kCutMove) >= 0) == isMoved;
  };
  const double area = size1(b - a) * size1(c - a);
  if (isAbove(atFrom, area, n) == isAbove(atTo, area, n)) return false;
  const auto turns = [&](Vec3d x, Vec3d y) {
    const Vec3d side = (y - from) - (x - from);
    return isAbove(dot(to - from, cross(x - from, y - from)), size1(to - from) * size1(side),
                   cross(to - from, side));
  };
  if (turns(a, b) != turns(b, c) || turns(b, c) == turns(a, c)) return false;
  cut = {{p, q}, triangle, from + (to - from) * (atFrom / (atFrom - atTo))};
  return true;
}

bool boxesMeet(const WorldMesh& world, const Triangle& s, const Triangle& t)
{
  Box first, second;
  for (const std::uint32_t v : s.vertex)
    first.add(world.points[v]);
  for (const std::uint32_t v : t.vertex)
    second.add(world.points[v]);
  const Vec3d before = first.high - second.low, after = second.high - first.low;
  return std::min({before.x, before.y, before.z, after.x, after.y, after.z}) >=
         -kCutBoxRoundings * (kCutRounding * world.size);
}

bool shareAPoint(const Triangle& s, const Triangle& t)
{
  return std::any_of(s.vertex, s.vertex + 3,
                     [&](std::uint32_t p) { return std::count(t.vertex, t.vertex + 3, p) > 0; });
}

}  // namespace

std::vector<CutPiece> intersections(const WorldMesh& world, Span<const std::uint8_t> isWanted)
{
  std::vector<CutPiece> pieces;
  const auto count = static_cast<std::uint32_t>(world.triangles.size());
  for (std::uint32_t s = 0; s < count; ++s)
    for (std::uint32_t t = s + 1; t < count; ++t) {
      if (world.isBroken(s) || world.isBroken(t)) continue;
      if (isWanted[world.body[s]] == 0 && isWanted[world.body[t]] == 0) continue;
      const Triangle first = sorted(world.triangles[s]), second = sorted(world.triangles[t]);
      if (world.body[s] == world.body[t] && shareAPoint(first, second)) continue;
      if (!boxesMeet(world, first, second)) continue;
      const bool isFirstMoved = world.body[s] > world.body[t];
      std::vector<CutPoint> ends;
      for (const auto& [triangle, other] : {std::pair{first, t}, std::pair{second, s}})
        for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}})
          if (CutPoint cut; goesThrough(world, triangle.vertex[i], triangle.vertex[j], other,
                                        (other == t) == isFirstMoved, cut))
            ends.push_back(cut);
      if (ends.size() == 2) pieces.push_back({{s, t}, {ends[0], ends[1]}});
    }
  return pieces;
}

}  // namespace limn::reference
