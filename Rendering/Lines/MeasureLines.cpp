// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/MeasureLines.h"

#include "Rendering/Lines/PixelArea.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A straight border is found in several pixels, each of which knows it to a part of a pixel: their
// mean is taken, of those that lie along it by less than kSpan, point the same way and are no other
// border's.
constexpr float kSpan = 3.0f;
constexpr float kSameWay = 0.7f;
constexpr float kSameBorder = 1.0f;
/// At a corner no edge lies beside the pixel, and its distance is that to a point.
constexpr float kBeside = 1.5f;
/// How far outside of an edge a pixel's centre may lie that still shows the surface.
constexpr float kOutside = 0.75f;

float dot(Vec2f a, Vec2f b)
{
  return a.x * b.x + a.y * b.y;
}

float absolute(float x)
{
  return x < 0.0f ? -x : x;
}

/// Of the places that come before `column`.
template <class Items>
auto firstFrom(const Items& items, int column)
{
  return std::lower_bound(items.begin(), items.end(), column,
                          [](const auto& item, int x) { return item.column < x; });
}

}  // namespace

int reachOf(const Style& style)
{
  return static_cast<int>(std::ceil(style.outlineWidth)) + 2;
}

struct LineMeasure::Pixel {
  int x, y, reach;
  std::size_t index;
  std::uint32_t instance;
  Vec2f centre;
  const Style* style;
};

/// Whether a pixel near by shows the surface that this one shows.
bool LineMeasure::areJoined(const Pixel& pixel, std::size_t index) const
{
  if (layers_.instance[index] != pixel.instance) return false;
  const SurfaceLayer &here = layers_.surface[pixel.index], &there = layers_.surface[index];
  const float x = absolute(here.x - there.x), y = absolute(here.y - there.y);
  const float a = stepTolerance(*pixel.style, here.point),
              b = stepTolerance(*pixel.style, there.point);
  const float tolerance = (a < b ? b : a) * (1.0f + (x < y ? y : x));
  return !PlaneDistances(here, there).areStep(tolerance);
}

template <class Visit>
void LineMeasure::forEachEdge(const Pixel& pixel, Visit visit) const
{
  const int end = std::min(pixel.y + pixel.reach + 1, layers_.height);
  for (int row = std::max(pixel.y - pixel.reach, 0); row < end; ++row) {
    const std::vector<EdgePoint>& points = edges_[static_cast<std::size_t>(row)].points;
    for (auto edge = firstFrom(points, pixel.x - pixel.reach);
         edge != points.end() && edge->column <= pixel.x + pixel.reach; ++edge)
      if (!(dot(edge->normal, edge->foot - pixel.centre) < -kOutside) &&
          areJoined(pixel, edge->index))
        visit(*edge);
  }
}

float LineMeasure::borderShare(const Pixel& pixel) const
{
  const EdgePoint* nearest = nullptr;
  float squared = 0.0f;
  forEachEdge(pixel, [&](const EdgePoint& edge) {
    const Vec2f way = edge.foot - pixel.centre;
    if (nearest != nullptr && !(dot(way, way) < squared)) return;
    nearest = &edge;
    squared = dot(way, way);
  });
  const float own =
      static_cast<float>(layers_.surface[pixel.index].count) / static_cast<float>(scene_.samples);
  if (nearest == nullptr) return 0.0f;
  const Vec2f normal = nearest->normal, way = nearest->foot - pixel.centre;
  if (normal == Vec2f{0.0f, 0.0f}) return nearest->index == pixel.index ? own : 0.0f;

  const auto along = [&](Vec2f to) { return absolute(normal.x * to.y - normal.y * to.x); };
  float distance = std::sqrt(squared);
  Vec2f across = normal;
  if (along(way) > kBeside) {
    across = way * (1.0f / distance);
  } else {
    float sum = 0.0f, weights = 0.0f;
    forEachEdge(pixel, [&](const EdgePoint& edge) {
      const Vec2f to = edge.foot - pixel.centre;
      const float weight = kSpan - along(to);
      if (!(weight > 0.0f) || !(dot(edge.normal, normal) >= kSameWay)) return;
      if (!(absolute(dot(normal, edge.foot - nearest->foot)) <= kSameBorder)) return;
      // The mean of both normals: exact to the second order on a circle.
      sum = sum + weight * (0.5f * (dot(edge.normal, to) + dot(normal, to)));
      weights = weights + weight;
    });
    distance = sum / weights;
  }
  const float share = own - CutPixel(across).areaBelow(distance - pixel.style->outlineWidth);
  return share > 0.0f ? share : 0.0f;
}

float LineMeasure::creaseShare(const Pixel& pixel) const
{
  bool isNear = false;
  float squared = 0.0f;
  Vec2f nearest = {0.0f, 0.0f}, direction = {0.0f, 0.0f};
  const int end = std::min(pixel.y + pixel.reach + 1, layers_.height);
  for (int row = std::max(pixel.y - pixel.reach, 0); row < end; ++row) {
    const std::vector<CreaseSegment>& segments = creases_[static_cast<std::size_t>(row)].segments;
    for (auto segment = firstFrom(segments, pixel.x - pixel.reach);
         segment != segments.end() && segment->column <= pixel.x + pixel.reach; ++segment) {
      if (!areJoined(pixel, segment->index)) continue;
      const Vec2f side = segment->to - segment->from, from = segment->from - pixel.centre;
      const float length = dot(side, side);
      const float t = length > 0.0f ? -(dot(from, side) / length) : 0.0f;
      const float bounded = t > 0.0f ? (t < 1.0f ? t : 1.0f) : 0.0f;
      const Vec2f way = from + side * bounded;
      if (isNear && !(dot(way, way) < squared)) continue;
      isNear = true;
      squared = dot(way, way);
      nearest = way;
      direction = side;
    }
  }
  if (!isNear) return 0.0f;
  const float distance = std::sqrt(squared);
  Vec2f across = {1.0f, 0.0f};
  if (distance > 0.0f)
    across = nearest * (1.0f / distance);
  else if (const float length = std::sqrt(dot(direction, direction)); length > 0.0f)
    across = {direction.y / length, -direction.x / length};
  const CutPixel cut(across);
  const float half = pixel.style->outlineWidth * 0.5f;
  return cut.areaBelow(half - distance) - cut.areaBelow(-half - distance);
}

float LineMeasure::shareAt(int x, int y) const
{
  Pixel pixel;
  pixel.index = layers_.indexOf(x, y);
  pixel.instance = layers_.instance[pixel.index];
  if (pixel.instance == kNobody || !hasImageOutline(scene_.instances[pixel.instance])) return 0.0f;
  pixel.style = &scene_.instances[pixel.instance].style;
  pixel.x = x;
  pixel.y = y;
  pixel.reach = reachOf(*pixel.style);
  pixel.centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
  const float border = borderShare(pixel);
  const float own =
      static_cast<float>(layers_.surface[pixel.index].count) / static_cast<float>(scene_.samples);
  const float crease = creaseShare(pixel) * own;
  return crease > border ? crease : border;
}

}  // namespace limn
