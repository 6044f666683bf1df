// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/MeasureLines.h"

#include "Rendering/Lines/PixelArea.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace limn {
namespace {

constexpr float kSpan = BorderRule::kSpan, kSameWay = BorderRule::kSameWay;
constexpr float kSameBorder = BorderRule::kSameBorder, kBeside = BorderRule::kBeside;
/// A border goes on beyond one of its pixels if another's foot lies farther along it by more.
constexpr float kFurther = 0.5f;
/// How far outside of an edge a pixel's centre may lie that still shows the surface: of one that
/// it cuts and of a whole one. What lies farther out is behind a step, beyond its end; steps by
/// convolution may lie side by side.
constexpr float kOutside = 0.75f, kOutsideOfWhole = 0.25f;

float dot(Vec2f a, Vec2f b)
{
  return a.x * b.x + a.y * b.y;
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

  bool isByPlanes() const { return style->imageOutline.detector == OutlineDetector::kPlane; }
};

LineMeasure::LineMeasure(const OutlinePass& pass, const FoundLines& lines, int y, int reach)
    : scene_(pass.scene),
      layers_(pass.layers),
      finder_(lines.finder),
      steps_(lines.steps),
      y_(y),
      reach_(reach),
      end_(std::min(pass.touched.x1, pass.layers.width)),
      batchEnd_(std::numeric_limits<int>::min())
{
  const int end = std::min(y + reach + 1, lines.edges.end());
  edgeRows_.reserve(static_cast<std::size_t>(2 * reach + 1));
  batch_.y = y;
  for (int row = std::max(y - reach, lines.edges.first()); row < end; ++row) {
    const std::vector<EdgePoint>& points = lines.edges[row].points;
    const std::vector<CreaseSegment>& segments = lines.creases[row].segments;
    if (!points.empty()) edgeRows_.emplace_back(row, points);
    if (!segments.empty()) creaseRows_.emplace_back(row, segments);
  }
}

void LineMeasure::moveTo(int x)
{
  for (NearRow<EdgePoint>& row : edgeRows_)
    row.moveTo(x - reach_);
  for (NearRow<CreaseSegment>& row : creaseRows_)
    row.moveTo(x - reach_);
}

void LineMeasure::findEdges(const Pixel& pixel)
{
  near_.clear();
  nearest_ = 0;
  haveParts_ = false;
  float squared = 0.0f;
  const float outside = pixel.own < 1.0f || !pixel.isByPlanes() ? kOutside : kOutsideOfWhole;
  const int first = pixel.x - pixel.reach, last = pixel.x + pixel.reach;
  for (const NearRow<EdgePoint>& row : edgeRows_) {
    if (row.y < pixel.y - pixel.reach || row.y > pixel.y + pixel.reach) continue;
    for (const EdgePoint* edge = row.at; edge != row.end && edge->column <= last; ++edge) {
      if (edge->column < first || edge->instance != pixel.instance) continue;
      const Vec2f way = edge->foot - pixel.centre;
      if (dot(edge->normal, way) < -outside) continue;
      const float other = dot(way, way);
      if (near_.empty() || other < squared) {
        nearest_ = near_.size();
        squared = other;
      }
      // Number by number: pairs that are put together to be copied whole wait for each other.
      NearEdge& near = near_.emplace_back();
      near.edge = edge;
      near.place.x = edge->shown.x;
      near.place.y = edge->shown.y;
      near.way.x = way.x;
      near.way.y = way.y;
      haveParts_ |= edge->part < 1.0f;
    }
  }
  if (!haveParts_) return;
  nearest_ = 0;
  float least = outsideOf(pixel, near_[0]);
  for (std::size_t i = 1; i < near_.size(); ++i)
    if (const float other = outsideOf(pixel, near_[i]); other < least) {
      nearest_ = i;
      least = other;
    }
}

/// For comparisons: how far the pixel's centre is from an edge's line; if all lines are as wide,
/// from the edge.
float LineMeasure::outsideOf(const Pixel& pixel, const NearEdge& edge) const
{
  const float squared = dot(edge.way, edge.way);
  return haveParts_ ? std::sqrt(squared) - pixel.style->outlineWidth * edge.edge->part : squared;
}

const LineMeasure::NearEdge* LineMeasure::nearestJoined(const Pixel& pixel) const
{
  const NearEdge* nearest = nullptr;
  float outside = 0.0f;
  for (const NearEdge& edge : near_) {
    const float other = outsideOf(pixel, edge);
    if (nearest != nullptr && !(other < outside)) continue;
    if (!steps_.areJoined(pixel.shown, edge.place)) continue;
    nearest = &edge;
    outside = other;
  }
  return nearest;
}

/// Whether a step's line comes to its end beside a pixel, rather than that it goes round a corner.
/// Not of convolutions, whose lines come to an end at every turn.
bool LineMeasure::isBeyondEnd(const Pixel& pixel, const NearEdge& nearest, bool areAlone) const
{
  if (!pixel.isByPlanes()) return false;
  const Vec2f normal = nearest.edge->normal;
  Vec2f towards = {-normal.y, normal.x};
  if (dot(towards, nearest.way) > 0.0f) towards = towards * -1.0f;
  for (const NearEdge& near : near_) {
    const Vec2f apart = near.edge->foot - nearest.edge->foot;
    const bool isSameWay = dot(near.edge->normal, normal) >= kSameWay;
    const bool isFurther = dot(towards, apart) > kFurther;
    const bool isOn = dot(apart, apart) <= kSpan * kSpan
                          ? isFurther || !isSameWay
                          : isFurther && isSameWay && std::fabs(dot(normal, apart)) <= kSameBorder;
    if (isOn && dot(near.edge->normal, near.way) > 0.0f &&
        (areAlone || steps_.areJoined(pixel.shown, near.place)))
      return false;
  }
  return true;
}

/// Whether beyond the end of a border another surface is seen, or the layers end, and
/// also where the border would pass the pixel: then it goes on behind that. One that comes to its
/// end has its own surface on both sides there. Where the surface ends at the border what matters
/// is beyond it, and not the part of a pixel up to there.
bool LineMeasure::isHiddenBeyond(const Pixel& pixel, const NearEdge& nearest) const
{
  const Vec2f normal = nearest.edge->normal;
  Vec2f towards = {-normal.y, normal.x};
  if (dot(towards, nearest.way) > 0.0f) towards = towards * -1.0f;
  const auto isOther = [&](Vec2f place) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    return !layers_.isInside(x, y) || !steps_.areJoined(pixel.shown, {x, y});
  };
  const float straight = dot(normal, nearest.way);
  const float passed = nearest.edge->part < 1.0f ? straight : straight + 0.5f;
  return isOther(nearest.edge->foot + (towards * kBeside + normal * 0.5f)) &&
         isOther(pixel.centre + normal * passed);
}

/// Of a round end in the middle of the line.
float LineMeasure::capShare(const Pixel& pixel, const NearEdge& nearest) const
{
  const float radius = pixel.style->outlineWidth * nearest.edge->part * 0.5f;
  const Vec2f way = nearest.way - nearest.edge->normal * radius;
  const float distance = std::sqrt(dot(way, way));
  const Vec2f across = distance > 0.0f ? way * (1.0f / distance) : nearest.edge->normal;
  const float share = CutPixel(across).areaBelow(radius - distance);
  return share < pixel.own ? share : pixel.own;
}

float LineMeasure::borderShare(const Pixel& pixel)
{
  findEdges(pixel);
  // Where the nearest of all is joined there is no other surface's between.
  if (near_.empty()) return 0.0f;
  const NearEdge* nearest = &near_[nearest_];
  const bool areAlone = steps_.areJoined(pixel.shown, nearest->place);
  if (!areAlone) nearest = nearestJoined(pixel);
  if (nearest == nullptr) return 0.0f;
  const Vec2f normal = nearest->edge->normal, way = nearest->way;
  if (normal == Vec2f{0.0f, 0.0f}) return nearest->edge->index == pixel.index ? pixel.own : 0.0f;

  const auto along = [&](Vec2f to) { return std::fabs(normal.x * to.y - normal.y * to.x); };
  float distance = std::sqrt(dot(way, way)), part = nearest->edge->part;
  Vec2f across = normal;
  if (along(way) > kBeside) {
    if (!isBeyondEnd(pixel, *nearest, areAlone))
      across = way * (1.0f / distance);
    else if (isHiddenBeyond(pixel, *nearest))
      distance = dot(normal, way);
    else
      return capShare(pixel, *nearest);
  } else {
    float sum = 0.0f, parts = 0.0f, weights = 0.0f;
    for (const NearEdge& near : near_) {
      const EdgePoint& edge = *near.edge;
      const float weight = kSpan - along(near.way);
      if (!(weight > 0.0f) || !(dot(edge.normal, normal) >= kSameWay)) continue;
      if (!(std::fabs(dot(normal, edge.foot - nearest->edge->foot)) <= kSameBorder)) continue;
      if (!areAlone && !steps_.areJoined(pixel.shown, near.place)) continue;
      // The mean of both normals: exact to the second order on a circle.
      sum = sum + weight * (0.5f * (dot(edge.normal, near.way) + dot(normal, near.way)));
      parts = parts + weight * edge.part;
      weights = weights + weight;
    }
    distance = sum / weights;
    part = parts / weights;
  }
  const float width = pixel.style->outlineWidth * part;
  const float share = pixel.own - CutPixel(across).areaBelow(distance - width);
  return share > 0.0f ? share : 0.0f;
}

std::optional<LineMeasure::NearCrease> LineMeasure::nearestCrease(const Pixel& pixel,
                                                                  bool isJoined) const
{
  std::optional<NearCrease> nearest;
  float squared = 0.0f;
  for (const NearRow<CreaseSegment>& row : creaseRows_) {
    if (row.y < pixel.y - pixel.reach || row.y > pixel.y + pixel.reach) continue;
    for (const CreaseSegment* segment = row.at;
         segment != row.end && segment->column <= pixel.x + pixel.reach; ++segment) {
      if (segment->column < pixel.x - pixel.reach || segment->instance != pixel.instance) continue;
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

float LineMeasure::linesShare(const Pixel& pixel, float border) const
{
  if (creaseRows_.empty()) return border;
  const float crease = creaseShare(pixel) * pixel.own;
  return crease > border ? crease : border;
}

void LineMeasure::addToBatch(int lane, std::size_t index)
{
  const std::uint32_t instance = layers_.instance[index];
  if (lane > 0 && layers_.isSingle && instance == layers_.instance[index - 1]) {
    for (std::int32_t* numbers : {batch_.reach, batch_.instance})
      numbers[lane] = numbers[lane - 1];
    for (float* values : {batch_.outside, batch_.width, batch_.own})
      values[lane] = values[lane - 1];
    return;
  }
  batch_.reach[lane] = -1;
  batch_.instance[lane] = static_cast<std::int32_t>(instance);
  batch_.outside[lane] = batch_.width[lane] = batch_.own[lane] = 0.0f;
  if (instance == kNobody || !hasImageOutline(scene_.instances[instance])) return;
  const Pixel pixel = pixelAt(batch_.x + lane, instance);
  batch_.reach[lane] = pixel.reach;
  batch_.own[lane] =
      static_cast<float>(layers_.countAt(index)) / static_cast<float>(scene_.samples);
  batch_.outside[lane] =
      batch_.own[lane] < 1.0f || !pixel.isByPlanes() ? kOutside : kOutsideOfWhole;
  batch_.width[lane] = pixel.style->outlineWidth;
}

/// Those near any of the batch's pixels.
void LineMeasure::gatherEdges()
{
  const int last = batchEnd_ - 1 + reach_;
  batch_.edges.clear();
  for (const NearRow<EdgePoint>& row : edgeRows_)
    for (const EdgePoint* edge = row.at; edge != row.end && edge->column <= last; ++edge)
      batch_.edges.push_back({edge, std::abs(row.y - y_)});
}

/// Whether a pixel's nearest edge lies beside it, with nothing between that parts them.
bool LineMeasure::isBeside(int lane) const
{
  if (batch_.haveParts[lane] != 0) return false;
  const EdgePoint& edge = *batch_.edges[static_cast<std::size_t>(batch_.nearest[lane])].edge;
  if (edge.normal == Vec2f{0.0f, 0.0f}) return false;
  const int x = batch_.x + lane;
  const Vec2f centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y_) + 0.5f};
  const Vec2f way = edge.foot - centre;
  if (std::fabs(edge.normal.x * way.y - edge.normal.y * way.x) > kBeside) return false;
  return steps_.areJoined({x, y_}, edge.shown);
}

void LineMeasure::measureBatch(int x)
{
  moveTo(x);
  batch_.x = x;
  batchEnd_ = std::min(x + BorderBatch::kPixels, end_);
  const std::size_t index = layers_.indexOf(x, y_);
  for (int lane = 0; lane < BorderBatch::kPixels; ++lane)
    if (lane < batchEnd_ - x)
      addToBatch(lane, index + static_cast<std::size_t>(lane));
    else
      batch_.reach[lane] = -1;
  gatherEdges();
  findNearestEdges(batch_);
  bool isAny = false;
  for (int lane = 0; lane < BorderBatch::kPixels; ++lane) {
    const bool isAlone = batch_.nearest[lane] == BorderBatch::kNoEdge;
    isMeasured_[lane] = isAlone || isBeside(lane);
    Vec2f normal = {0.0f, 0.0f}, foot = {0.0f, 0.0f};
    if (isMeasured_[lane] && !isAlone) {
      const EdgePoint& edge = *batch_.edges[static_cast<std::size_t>(batch_.nearest[lane])].edge;
      normal = edge.normal;
      foot = edge.foot;
      isAny = true;
    }
    batch_.normalX[lane] = normal.x;
    batch_.normalY[lane] = normal.y;
    batch_.footX[lane] = foot.x;
    batch_.footY[lane] = foot.y;
  }
  if (isAny) coverBorders(batch_);
  for (int lane = 0; lane < BorderBatch::kPixels; ++lane)
    if (batch_.nearest[lane] == BorderBatch::kNoEdge) batch_.share[lane] = 0.0f;
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
  if (x >= batchEnd_) measureBatch(x);
  const auto lane = static_cast<std::size_t>(x - batch_.x);
  if (isMeasured_[lane] && creaseRows_.empty()) return withoutHalo(batch_.share[lane], {x, y_});
  moveTo(x);
  Pixel pixel = pixelAt(x, instance);
  pixel.own = batch_.own[lane];
  const float border = isMeasured_[lane] ? batch_.share[lane] : borderShare(pixel);
  return withoutHalo(linesShare(pixel, border), pixel.shown);
}

/// Where a pixel around shows what this pixel's other samples do: the farthest of those that lie
/// behind the end of its layer, or that end there themselves.
std::optional<LineMeasure::Behind> LineMeasure::placeBehind(int x) const
{
  const std::size_t index = layers_.indexOf(x, y_);
  const std::uint32_t wanted = layers_.other[index];
  // A speck's step parts nothing.
  if (wanted == layers_.instance[index] && steps_.isUnited(index)) return Behind{{x, y_}, false};
  std::optional<Behind> farthest;
  float depth = 0.0f;
  // There is an apron: no pixel of the frame is at the layers' end.
  for (int row = y_ - 1; row <= y_ + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column) {
      const std::size_t other = layers_.indexOf(column, row);
      if (layers_.instance[other] != wanted || (farthest && !(layers_.depth[other] > depth)))
        continue;
      const bool isJoined =
          wanted == layers_.instance[index] && steps_.areJoined({x, y_}, {column, row});
      if (isJoined) continue;
      const EdgeFinder::Order order = finder_.orderOf({x, y_}, {column, row});
      if (wanted == layers_.instance[index] && order == EdgeFinder::Order::kBehind) continue;
      depth = layers_.depth[other];
      farthest = {{column, row}, order != EdgeFinder::Order::kBefore};
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
  const std::optional<Behind> behind = placeBehind(x);
  if (!behind) return 0.0f;
  moveTo(x);
  Pixel pixel = pixelAt(x, layers_.other[index]);
  pixel.shown = behind->place;
  const float part = static_cast<float>(others) / static_cast<float>(scene_.samples);
  if (!behind->endsHere)
    return withoutHalo(linesShare(pixel, borderShare(pixel)) * part, pixel.shown);
  pixel.own = part;
  return withoutHalo(linesShare(pixel, borderShare(pixel)), pixel.shown);
}

}  // namespace limn
