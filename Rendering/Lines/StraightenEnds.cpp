// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/StraightenEnds.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// How many pixels away the edges before an end may be, how far their normals may be turned, and
/// how far off their line the end may lie.
constexpr int kReach = 6;
constexpr float kSameWay = 0.7f;
constexpr float kSameBorder = 1.0f;

float dot(Vec2f a, Vec2f b)
{
  return a.x * b.x + a.y * b.y;
}

}  // namespace

void straightenEnds(const SurfaceLayers& layers, const StepGrid& steps, int y,
                    std::vector<EdgeRow>& edges)
{
  const int first = std::max(y - kReach, 0), last = std::min(y + kReach, layers.height - 1);
  for (EdgePoint& end : edges[static_cast<std::size_t>(y)].points) {
    if (!end.isBesideHidden) continue;
    // Weighted by their distance: those beside the end are turned a little, too.
    Vec2f normals = {0.0f, 0.0f}, ways = {0.0f, 0.0f};
    float weights = 0.0f;
    for (int row = first; row <= last; ++row) {
      const std::vector<EdgePoint>& points = edges[static_cast<std::size_t>(row)].points;
      auto edge = std::lower_bound(
          points.begin(), points.end(), end.column - kReach,
          [](const EdgePoint& point, int column) { return point.column < column; });
      for (; edge != points.end() && edge->column <= end.column + kReach; ++edge) {
        if (edge->isBesideHidden || edge->instance != end.instance) continue;
        const Vec2f way = edge->foot - end.foot;
        if (!(dot(edge->normal, end.normal) >= kSameWay)) continue;
        if (!(std::fabs(dot(edge->normal, way)) <= kSameBorder)) continue;
        if (!steps.areJoined(end.shown, edge->shown)) continue;
        const float weight = std::sqrt(dot(way, way));
        normals = normals + edge->normal * weight;
        ways = ways + way * weight;
        weights = weights + weight;
      }
    }
    const float length = std::sqrt(dot(normals, normals));
    if (!(length > 0.0f)) continue;
    end.normal = normals * (1.0f / length);
    end.foot = end.foot + end.normal * (dot(end.normal, ways) / weights);
  }
}

}  // namespace limn
