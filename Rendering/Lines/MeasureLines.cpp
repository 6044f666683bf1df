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
  SurfacePatch layer;
  float tolerance, own;
};

LineMeasure::LineMeasure(const OutlinePass& pass, const std::vector<EdgeRow>& edges,
                         const std::vector<CreaseRow>& creases, int y, int reach)
    : scene_(pass.scene), layers_(pass.layers), y_(y), reach_(reach)
{
  const int end = std::min(y + reach + 1, layers_.height);
  for (int row = std::max(y - reach, 0); row < end; ++row) {
    const std::vector<EdgePoint>& points = edges[static_cast<std::size_t>(row)].points;
    const std::vector<CreaseSegment>& segments = creases[static_cast<std::size_t>(row)].segments;
    if (points.empty() && segments.empty()) continue;
    rows_.push_back({row, points.data(), points.data() + points.size(), segments.data(),
                     segments.data() + segments.size()});
  }
}

void LineMeasure::moveTo(int x)
{
  for (NearRow& row : rows_) {
    while (row.edge != row.lastEdge && row.edge->column < x - reach_)
      ++row.edge;
    while (row.segment != row.lastSegment && row.segment->column < x - reach_)
      ++row.segment;
  }
}

/// Whether a pixel of the same instance near by shows the surface that this one shows.
bool LineMeasure::areJoined(const Pixel& pixel, const SurfacePatch& there, float tolerance) const
{
  const SurfacePatch& here = pixel.layer;
  const float x = absolute(here.x - there.x), y = absolute(here.y - there.y);
  const float larger = pixel.tolerance < tolerance ? tolerance : pixel.tolerance;
  return !PlaneDistances(here, there).areStep(larger * (1.0f + (x < y ? y : x)));
}
bool LineMeasure::areJoined(const Pixel& pixel, const CreaseSegment& segment) const
{
  const auto areLayers = [&](const SurfacePatch& there) {
    return areJoined(pixel, there, stepTolerance(*pixel.style, there.point));
  };
  return areLayers(segment.layer) || areLayers(segment.beyond);
}

void LineMeasure::findEdges(const Pixel& pixel)
{
  near_.clear();
  for (const NearRow& row : rows_) {
    if (row.y < pixel.y - pixel.reach || row.y > pixel.y + pixel.reach) continue;
    for (const EdgePoint* edge = row.edge;
         edge != row.lastEdge && edge->column <= pixel.x + pixel.reach; ++edge) {
      if (edge->column < pixel.x - pixel.reach || edge->instance != pixel.instance) continue;
      const Vec2f way = edge->foot - pixel.centre;
      if (!(dot(edge->normal, way) < -kOutside) && areJoined(pixel, edge->layer, edge->tolerance))
        near_.push_back({edge, way});
    }
  }
}

float LineMeasure::borderShare(const Pixel& pixel)
{
  findEdges(pixel);
  if (near_.empty()) return 0.0f;
  const NearEdge* nearest = &near_[0];
  float squared = dot(nearest->way, nearest->way);
  for (const NearEdge& edge : near_) {
    const float other = dot(edge.way, edge.way);
    if (!(other < squared)) continue;
    nearest = &edge;
    squared = other;
  }
  const Vec2f normal = nearest->edge->normal, way = nearest->way;
  if (normal == Vec2f{0.0f, 0.0f}) return nearest->edge->index == pixel.index ? pixel.own : 0.0f;

  const auto along = [&](Vec2f to) { return absolute(normal.x * to.y - normal.y * to.x); };
  float distance = std::sqrt(squared);
  Vec2f across = normal;
  if (along(way) > kBeside) {
    across = way * (1.0f / distance);
  } else {
    float sum = 0.0f, weights = 0.0f;
    for (const NearEdge& near : near_) {
      const EdgePoint& edge = *near.edge;
      const float weight = kSpan - along(near.way);
      if (!(weight > 0.0f) || !(dot(edge.normal, normal) >= kSameWay)) continue;
      if (!(absolute(dot(normal, edge.foot - nearest->edge->foot)) <= kSameBorder)) continue;
      // The mean of both normals: exact to the second order on a circle.
      sum = sum + weight * (0.5f * (dot(edge.normal, near.way) + dot(normal, near.way)));
      weights = weights + weight;
    }
    distance = sum / weights;
  }
  const float share = pixel.own - CutPixel(across).areaBelow(distance - pixel.style->outlineWidth);
  return share > 0.0f ? share : 0.0f;
}

float LineMeasure::creaseShare(const Pixel& pixel) const
{
  bool isNear = false;
  float squared = 0.0f;
  Vec2f nearest = {0.0f, 0.0f}, direction = {0.0f, 0.0f};
  for (const NearRow& row : rows_) {
    if (row.y < pixel.y - pixel.reach || row.y > pixel.y + pixel.reach) continue;
    for (const CreaseSegment* segment = row.segment;
         segment != row.lastSegment && segment->column <= pixel.x + pixel.reach; ++segment) {
      if (segment->column < pixel.x - pixel.reach ||
          layers_.instance[segment->index] != pixel.instance)
        continue;
      const Vec2f side = segment->to - segment->from, from = segment->from - pixel.centre;
      const float length = dot(side, side);
      const float t = length > 0.0f ? -(dot(from, side) / length) : 0.0f;
      const float bounded = t > 0.0f ? (t < 1.0f ? t : 1.0f) : 0.0f;
      const Vec2f way = from + side * bounded;
      if ((isNear && !(dot(way, way) < squared)) || !areJoined(pixel, *segment)) continue;
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

float LineMeasure::shareAt(int x)
{
  Pixel pixel;
  pixel.index = layers_.indexOf(x, y_);
  pixel.instance = layers_.instance[pixel.index];
  if (pixel.instance == kNobody || !hasImageOutline(scene_.instances[pixel.instance])) return 0.0f;
  moveTo(x);
  pixel.style = &scene_.instances[pixel.instance].style;
  pixel.x = x;
  pixel.y = y_;
  pixel.reach = reachOf(*pixel.style);
  pixel.centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y_) + 0.5f};
  pixel.layer = layers_.patchAt(x, y_);
  pixel.tolerance = stepTolerance(*pixel.style, pixel.layer.point);
  pixel.own = static_cast<float>(layers_.countAt(pixel.index)) / static_cast<float>(scene_.samples);
  const float border = borderShare(pixel);
  const float crease = creaseShare(pixel) * pixel.own;
  return crease > border ? crease : border;
}

}  // namespace limn
