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
  PixelPlace shown;  ///< shows the surface: this pixel, or one next to it
  std::size_t index;
  std::uint32_t instance;
  Vec2f centre;
  const Style* style;
  float own;
};

LineMeasure::LineMeasure(const OutlinePass& pass, const FoundLines& lines, int y, int reach)
    : scene_(pass.scene),
      layers_(pass.layers),
      finder_(lines.finder),
      steps_(lines.steps),
      y_(y),
      reach_(reach)
{
  const int end = std::min(y + reach + 1, layers_.height);
  for (int row = std::max(y - reach, 0); row < end; ++row) {
    const std::vector<EdgePoint>& points = lines.edges[static_cast<std::size_t>(row)].points;
    const std::vector<CreaseSegment>& segments =
        lines.creases[static_cast<std::size_t>(row)].segments;
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

void LineMeasure::findEdges(const Pixel& pixel)
{
  near_.clear();
  for (const NearRow& row : rows_) {
    if (row.y < pixel.y - pixel.reach || row.y > pixel.y + pixel.reach) continue;
    for (const EdgePoint* edge = row.edge;
         edge != row.lastEdge && edge->column <= pixel.x + pixel.reach; ++edge) {
      if (edge->column < pixel.x - pixel.reach || edge->instance != pixel.instance) continue;
      const Vec2f way = edge->foot - pixel.centre;
      if (dot(edge->normal, way) < -kOutside) continue;
      // Number by number: pairs that are put together to be copied whole wait for each other.
      NearEdge& near = near_.emplace_back();
      near.edge = edge;
      near.place.x = edge->column;
      near.place.y = row.y;
      near.way.x = way.x;
      near.way.y = way.y;
    }
  }
}

const LineMeasure::NearEdge* LineMeasure::nearestOf(const Pixel& pixel, bool isJoined) const
{
  const NearEdge* nearest = nullptr;
  float squared = 0.0f;
  for (const NearEdge& edge : near_) {
    const float other = dot(edge.way, edge.way);
    if (nearest != nullptr && !(other < squared)) continue;
    if (isJoined && !steps_.areJoined(pixel.shown, edge.place)) continue;
    nearest = &edge;
    squared = other;
  }
  return nearest;
}

float LineMeasure::borderShare(const Pixel& pixel)
{
  findEdges(pixel);
  // Where the nearest of all is joined there is no other surface's between.
  const NearEdge* nearest = nearestOf(pixel, false);
  const bool areAlone = nearest != nullptr && steps_.areJoined(pixel.shown, nearest->place);
  if (!areAlone) nearest = nearestOf(pixel, true);
  if (nearest == nullptr) return 0.0f;
  const Vec2f normal = nearest->edge->normal, way = nearest->way;
  if (normal == Vec2f{0.0f, 0.0f}) return nearest->edge->index == pixel.index ? pixel.own : 0.0f;

  const auto along = [&](Vec2f to) { return absolute(normal.x * to.y - normal.y * to.x); };
  float distance = std::sqrt(dot(way, way));
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
      if (!areAlone && !steps_.areJoined(pixel.shown, near.place)) continue;
      // The mean of both normals: exact to the second order on a circle.
      sum = sum + weight * (0.5f * (dot(edge.normal, near.way) + dot(normal, near.way)));
      weights = weights + weight;
    }
    distance = sum / weights;
  }
  const float share = pixel.own - CutPixel(across).areaBelow(distance - pixel.style->outlineWidth);
  return share > 0.0f ? share : 0.0f;
}

std::optional<LineMeasure::NearCrease> LineMeasure::nearestCrease(const Pixel& pixel,
                                                                  bool isJoined) const
{
  std::optional<NearCrease> nearest;
  float squared = 0.0f;
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
      if (nearest && !(dot(way, way) < squared)) continue;
      if (isJoined && !areJoined(pixel, *segment)) continue;
      squared = dot(way, way);
      nearest = {segment, way};
    }
  }
  return nearest;
}

bool LineMeasure::areJoined(const Pixel& pixel, const CreaseSegment& segment) const
{
  return steps_.areJoined(pixel.shown, segment.beside) ||
         steps_.areJoined(pixel.shown, segment.beyond);
}

float LineMeasure::creaseShare(const Pixel& pixel) const
{
  std::optional<NearCrease> nearest = nearestCrease(pixel, false);
  if (nearest && !areJoined(pixel, *nearest->segment)) nearest = nearestCrease(pixel, true);
  if (!nearest) return 0.0f;
  const Vec2f way = nearest->way, direction = nearest->segment->to - nearest->segment->from;
  const float distance = std::sqrt(dot(way, way));
  Vec2f across = {1.0f, 0.0f};
  if (distance > 0.0f)
    across = way * (1.0f / distance);
  else if (const float length = std::sqrt(dot(direction, direction)); length > 0.0f)
    across = {direction.y / length, -direction.x / length};
  const CutPixel cut(across);
  const float half = pixel.style->outlineWidth * 0.5f;
  return cut.areaBelow(half - distance) - cut.areaBelow(-half - distance);
}

LineMeasure::Pixel LineMeasure::pixelAt(int x, std::uint32_t instance) const
{
  Pixel pixel;
  pixel.index = layers_.indexOf(x, y_);
  pixel.instance = instance;
  pixel.style = &scene_.instances[instance].style;
  pixel.x = x;
  pixel.y = y_;
  pixel.reach = reachOf(*pixel.style);
  pixel.shown = {x, y_};
  pixel.centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y_) + 0.5f};
  pixel.own = 1.0f;
  return pixel;
}

float LineMeasure::linesShare(const Pixel& pixel)
{
  const float border = borderShare(pixel);
  const float crease = creaseShare(pixel) * pixel.own;
  return crease > border ? crease : border;
}

float LineMeasure::withoutHalo(float share, PixelPlace place) const
{
  return layers_.halo.empty() ? share
                              : share * (1.0f - layers_.halo[layers_.indexOf(place.x, place.y)]);
}

float LineMeasure::shareAt(int x)
{
  const std::size_t index = layers_.indexOf(x, y_);
  const std::uint32_t instance = layers_.instance[index];
  if (instance == kNobody || !hasImageOutline(scene_.instances[instance])) return 0.0f;
  moveTo(x);
  Pixel pixel = pixelAt(x, instance);
  pixel.own = static_cast<float>(layers_.countAt(index)) / static_cast<float>(scene_.samples);
  return withoutHalo(linesShare(pixel), pixel.shown);
}

/// Where a pixel around shows what this pixel's other samples do: the farthest of those that lie
/// behind the end of its layer.
std::optional<PixelPlace> LineMeasure::placeBehind(int x) const
{
  const std::size_t index = layers_.indexOf(x, y_);
  const std::uint32_t wanted = layers_.other[index];
  // A speck's step parts nothing.
  if (wanted == layers_.instance[index] && steps_.isUnited(index)) return PixelPlace{x, y_};
  std::optional<PixelPlace> farthest;
  float depth = 0.0f;
  const int x1 = std::min(x + 1, layers_.width - 1), y1 = std::min(y_ + 1, layers_.height - 1);
  for (int row = std::max(y_ - 1, 0); row <= y1; ++row)
    for (int column = std::max(x - 1, 0); column <= x1; ++column) {
      const std::size_t other = layers_.indexOf(column, row);
      if (layers_.instance[other] != wanted || (farthest && !(layers_.depth[other] > depth)))
        continue;
      const bool isJoined =
          wanted == layers_.instance[index] && steps_.areJoined({x, y_}, {column, row});
      if (isJoined || !finder_.endsBefore({x, y_}, {column, row})) continue;
      depth = layers_.depth[other];
      farthest = PixelPlace{column, row};
    }
  return farthest;
}

float LineMeasure::shareBehindAt(int x)
{
  if (layers_.isSingle) return 0.0f;
  const std::size_t index = layers_.indexOf(x, y_);
  if (layers_.instance[index] == kNobody) return 0.0f;
  const int others = layers_.covered[index] - layers_.count[index];
  if (others == 0 || !hasImageOutline(scene_.instances[layers_.other[index]])) return 0.0f;
  const std::optional<PixelPlace> shown = placeBehind(x);
  if (!shown) return 0.0f;
  moveTo(x);
  Pixel pixel = pixelAt(x, layers_.other[index]);
  pixel.shown = *shown;
  const float part = static_cast<float>(others) / static_cast<float>(scene_.samples);
  return withoutHalo(linesShare(pixel) * part, *shown);
}

}  // namespace limn
