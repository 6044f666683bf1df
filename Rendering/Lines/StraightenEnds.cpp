// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/StraightenEnds.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// How many pixels away the edges before an end may be, how far their normals may be turned, and
/// how far off their line they may lie, and the end.
constexpr int kReach = 6;
constexpr float kSameWay = 0.7f;
constexpr float kSameBorder = 1.0f;
/// Of the nearest of them, which tells the border: how many pixels away it may be, and how far its
/// normal may be turned from the end's, which what hides turns.
constexpr float kNext = 3.0f;
constexpr float kTurned = 0.4f;
/// How far the end may lie off the line of them all, as it is known to half a pixel.
constexpr float kMostOff = 0.5f;

float dot(Vec2f a, Vec2f b)
{
  return a.x * b.x + a.y * b.y;
}

/// Calls visit(edge, way to its foot) for those of a border that the end may be of, row by row; it
/// is of row y.
template <class Visit>
void forEachBefore(const EdgePoint& end, int y, const LayerRows<EdgeRow>& edges, const Visit& visit)
{
  const int first = std::max(y - kReach, edges.first()),
            last = std::min(y + kReach, edges.end() - 1);
  for (int row = first; row <= last; ++row) {
    const std::vector<EdgePoint>& points = edges[row].points;
    auto edge =
        std::lower_bound(points.begin(), points.end(), end.column - kReach,
                         [](const EdgePoint& point, int column) { return point.column < column; });
    for (; edge != points.end() && edge->column <= end.column + kReach; ++edge)
      if (!edge->isBesideHidden && edge->instance == end.instance)
        visit(*edge, edge->foot - end.foot);
  }
}

/// The nearest on whose line the end lies; none: null.
const EdgePoint* nextBefore(const EdgePoint& end, int y, const StepGrid& steps,
                            const LayerRows<EdgeRow>& edges)
{
  const EdgePoint* next = nullptr;
  float least = kNext * kNext;
  forEachBefore(end, y, edges, [&](const EdgePoint& edge, Vec2f way) {
    const float squared = dot(way, way);
    if (!(squared < least) || !(dot(edge.normal, end.normal) >= kTurned)) return;
    if (!(std::fabs(dot(edge.normal, way)) <= kSameBorder)) return;
    if (!steps.areJoined(end.shown, edge.shown)) return;
    least = squared;
    next = &edge;
  });
  return next;
}

}  // namespace

void straightenEnds(const StepGrid& steps, int y, LayerRows<EdgeRow>& edges)
{
  for (EdgePoint& end : edges[y].points) {
    if (!end.isBesideHidden) continue;
    const EdgePoint* const next = nextBefore(end, y, steps, edges);
    if (next == nullptr) continue;
    // Weighted by their distance: those beside the end are turned a little, too.
    Vec2f normals = {0.0f, 0.0f}, ways = {0.0f, 0.0f};
    float weights = 0.0f;
    forEachBefore(end, y, edges, [&](const EdgePoint& edge, Vec2f way) {
      if (!(dot(edge.normal, next->normal) >= kSameWay)) return;
      if (!(std::fabs(dot(next->normal, edge.foot - next->foot)) <= kSameBorder)) return;
      if (!steps.areJoined(end.shown, edge.shown)) return;
      const float weight = std::sqrt(dot(way, way));
      normals = normals + edge.normal * weight;
      ways = ways + way * weight;
      weights = weights + weight;
    });
    const float length = std::sqrt(dot(normals, normals));
    if (!(length > 0.0f)) continue;
    const Vec2f normal = normals * (1.0f / length);
    const float off = dot(normal, ways) / weights;
    if (!(std::fabs(off) <= kMostOff)) continue;
    end.normal = normal;
    // Where two surfaces cut each other planes tell the place.
    if (!(end.part < 1.0f)) end.foot = end.foot + normal * off;
  }
}

}  // namespace limn
