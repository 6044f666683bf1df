// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ClipTriangle.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace limn {
namespace {

struct Vertex {
  ClipPoint clip;
  double weight[3];
  double screenX, screenY;  ///< before snapping, in subpixels; set after the near plane
  ScreenVertex snapped;     ///< of an untouched corner
  bool untouched;
};

struct Polygon {
  int count = 0;
  Vertex vertex[ClippedTriangle::kMaxVertices];

  void add(const Vertex& v)
  {
    // A convex polygon gains one vertex a plane; rounding must not make it gain more.
    if (count < ClippedTriangle::kMaxVertices) vertex[count++] = v;
  }
};

bool lessLexicographically(const ClipPoint& a, const ClipPoint& b)
{
  return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
}

/// The point where the edge meets a plane to which its ends have the signed distances given.
Vertex cutEdge(const Vertex& from, double fromDistance, const Vertex& to, double toDistance)
{
  const Vertex *a = &from, *b = &to;
  double da = fromDistance, db = toDistance;
  if (lessLexicographically(b->clip, a->clip)) {
    std::swap(a, b);
    std::swap(da, db);
  }
  // The ends' sides are decided on rounded screen positions, so the quotient may stray a little.
  const double t = da == db ? 0.5 : std::clamp(da / (da - db), 0.0, 1.0);
  const auto mix = [t](double p, double q) { return p + t * (q - p); };
  Vertex cut;
  cut.clip = {mix(a->clip.x, b->clip.x), mix(a->clip.y, b->clip.y), mix(a->clip.z, b->clip.z),
              mix(a->clip.w, b->clip.w)};
  for (int i = 0; i < 3; ++i)
    cut.weight[i] = mix(a->weight[i], b->weight[i]);
  cut.screenX = cut.screenY = 0;
  cut.snapped = {};
  cut.untouched = false;
  return cut;
}

/// One step of Sutherland and Hodgman's algorithm (1974).
template <class Inside, class Distance, class Place>
Polygon cutAtPlane(const Polygon& polygon, Inside inside, Distance distance, Place place)
{
  Polygon result;
  for (int i = 0; i < polygon.count; ++i) {
    const Vertex& current = polygon.vertex[i];
    const Vertex& next = polygon.vertex[(i + 1) % polygon.count];
    if (inside(current)) result.add(current);
    if (inside(current) != inside(next)) {
      Vertex cut = cutEdge(current, distance(current.clip), next, distance(next.clip));
      place(cut);
      result.add(cut);
    }
  }
  return result;
}

}  // namespace

ClippedTriangle clipTriangle(const InstanceTransform& transform, const ClipPoint (&clip)[3],
                             const ScreenVertex (&corner)[3])
{
  const double sx = transform.subpixelsX, sy = transform.subpixelsY;
  const double guard = kGuardSubpixels;
  const auto place = [&](Vertex& v) {
    if (v.untouched) {
      v.screenX = v.snapped.x;
      v.screenY = v.snapped.y;
    } else {
      const double inverseW = 1.0 / v.clip.w;
      v.screenX = (v.clip.x * inverseW) * sx + sx;
      v.screenY = (v.clip.y * inverseW) * sy + sy;
    }
  };

  Polygon polygon;
  for (int i = 0; i < 3; ++i)
    polygon.add({clip[i],
                 {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0},
                 0,
                 0,
                 corner[i],
                 !corner[i].needsClip});

  const auto nearDistance = [](const ClipPoint& c) { return c.z + c.w; };
  polygon = cutAtPlane(
      polygon, [&](const Vertex& v) { return nearDistance(v.clip) >= 0; }, nearDistance,
      [](Vertex&) {});
  for (int i = 0; i < polygon.count; ++i) {
    if (!(polygon.vertex[i].clip.w >= kSmallestW)) return {};
    place(polygon.vertex[i]);
  }

  // Screen position minus or plus the guard, times w: linear in clip space.
  const double leftOf = guard + sx, rightOf = guard - sx, belowOf = guard + sy,
               aboveOf = guard - sy;
  polygon = cutAtPlane(
      polygon, [&](const Vertex& v) { return v.screenX >= -guard; },
      [&](const ClipPoint& c) { return c.x * sx + c.w * leftOf; }, place);
  polygon = cutAtPlane(
      polygon, [&](const Vertex& v) { return v.screenX <= guard; },
      [&](const ClipPoint& c) { return c.w * rightOf - c.x * sx; }, place);
  polygon = cutAtPlane(
      polygon, [&](const Vertex& v) { return v.screenY >= -guard; },
      [&](const ClipPoint& c) { return c.y * sy + c.w * belowOf; }, place);
  polygon = cutAtPlane(
      polygon, [&](const Vertex& v) { return v.screenY <= guard; },
      [&](const ClipPoint& c) { return c.w * aboveOf - c.y * sy; }, place);
  if (polygon.count < 3) return {};

  ClippedTriangle result;
  result.count = polygon.count;
  const auto snap = [guard](double position) {
    return static_cast<std::int32_t>(std::nearbyint(std::clamp(position, -guard, guard)));
  };
  for (int i = 0; i < polygon.count; ++i) {
    const Vertex& v = polygon.vertex[i];
    std::copy(v.weight, v.weight + 3, result.weight[i]);
    if (v.untouched) {
      result.vertex[i] = v.snapped;
      continue;
    }
    const double inverseW = 1.0 / v.clip.w;
    result.vertex[i] = {snap(v.screenX), snap(v.screenY),
                        static_cast<float>((v.clip.z * inverseW) * 0.5 + 0.5),
                        static_cast<float>(inverseW), false};
  }
  return result;
}

}  // namespace limn
