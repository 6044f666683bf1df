// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FindEdges.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Lines/PixelArea.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

float absolute(float x)
{
  return x < 0.0f ? -x : x;
}

float larger(float a, float b)
{
  return a < b ? b : a;
}

}  // namespace

EdgeFinder::EdgeFinder(const OutlinePass& pass)
    : pass_(pass), layers_(pass.layers), samples_(static_cast<float>(pass.scene.samples))
{
  for (const Instance& instance : pass.scene.instances) {
    const ImageOutline& outline = instance.style.imageOutline;
    settings_.push_back({hasImageOutline(instance), outline.detector, outline.depthTolerance,
                         1.0f - static_cast<float>(cosineOfDegrees(outline.creaseDegrees))});
  }
}

float EdgeFinder::tolerance(std::size_t first, std::size_t second) const
{
  const auto of = [&](std::size_t index) {
    return stepTolerance(pass_.scene.instances[layers_.instance[index]].style,
                         layers_.surface[index].point);
  };
  return larger(of(first), of(second));
}

/// Distance along the gaze of a neighbour; the pixel's own where another instance is.
float EdgeFinder::distanceBeside(Pixel pixel, int dx, int dy) const
{
  const std::size_t here = layers_.indexOf(pixel.x, pixel.y);
  const int x = pixel.x + dx, y = pixel.y + dy;
  const bool isInside = x >= 0 && y >= 0 && x < layers_.width && y < layers_.height;
  const std::size_t there = isInside ? layers_.indexOf(x, y) : here;
  const bool isSame = layers_.instance[there] == layers_.instance[here];
  return -layers_.surface[isSame ? there : here].point.position.z;
}

Vec2f EdgeFinder::sobel(Pixel pixel) const
{
  const auto z = [&](int dx, int dy) { return distanceBeside(pixel, dx, dy); };
  const float x = ((z(1, -1) - z(-1, -1)) + 2.0f * (z(1, 0) - z(-1, 0))) + (z(1, 1) - z(-1, 1));
  const float y = ((z(-1, 1) - z(-1, -1)) + 2.0f * (z(0, 1) - z(0, -1))) + (z(1, 1) - z(1, -1));
  return {x * 0.125f, y * 0.125f};
}

float EdgeFinder::laplacian(Pixel pixel) const
{
  const auto z = [&](int dx, int dy) { return distanceBeside(pixel, dx, dy); };
  return ((z(1, 0) + z(-1, 0)) + (z(0, 1) + z(0, -1))) - 4.0f * z(0, 0);
}

bool EdgeFinder::isConvolved(Pixel first, Pixel second) const
{
  const std::size_t a = layers_.indexOf(first.x, first.y), b = layers_.indexOf(second.x, second.y);
  const float bound = tolerance(a, b);
  if (settings_[layers_.instance[a]].detector == OutlineDetector::kSobel) {
    const auto x = static_cast<float>(second.x - first.x),
               y = static_cast<float>(second.y - first.y);
    const float perPixel = x != 0.0f && y != 0.0f ? 0.707106781f : 1.0f;
    const auto slope = [&](Pixel pixel) {
      const Vec2f gradient = sobel(pixel);
      return absolute((gradient.x * x + gradient.y * y) * perPixel);
    };
    return slope(first) > bound && slope(second) > bound;
  }
  const float la = laplacian(first), lb = laplacian(second);
  return ((la > 0.0f && lb < 0.0f) || (la < 0.0f && lb > 0.0f)) && absolute(la - lb) > bound * 2.0f;
}

/// Of two pixels of one instance.
bool EdgeFinder::isStep(Pixel first, Pixel second) const
{
  const std::size_t a = layers_.indexOf(first.x, first.y), b = layers_.indexOf(second.x, second.y);
  if (settings_[layers_.instance[a]].detector != OutlineDetector::kPlane)
    return isConvolved(first, second);
  return PlaneDistances(layers_.surface[a], layers_.surface[b]).areStep(tolerance(a, b));
}

/// Of two pixels with an edge between them: which one's line it is.
bool EdgeFinder::isBefore(Pixel first, Pixel second) const
{
  const std::size_t a = layers_.indexOf(first.x, first.y), b = layers_.indexOf(second.x, second.y);
  const std::uint32_t ia = layers_.instance[a], ib = layers_.instance[b];
  const SurfaceLayer &la = layers_.surface[a], &lb = layers_.surface[b];
  const bool isPlain = ia == ib && settings_[ia].detector != OutlineDetector::kPlane;
  const PlaneDistances distances(la, lb);
  const float ofFirst = absolute(distances.ofFirst), ofSecond = absolute(distances.ofSecond);
  const float off = larger(ofFirst, ofSecond);
  const bool isNoise = off <= larger(la.point.rounding, lb.point.rounding);
  const bool areBent = (distances.ofFirst > 0.0f) == (distances.ofSecond > 0.0f);
  if (ia != ib && (isNoise || (areBent && off <= tolerance(a, b)))) {
    // They touch: that which has lines, or was there first.
    return isOutlined(ia) != isOutlined(ib) ? isOutlined(ia) : ia < ib;
  }
  if (isPlain || ofFirst == ofSecond) {
    if (la.point.position.z != lb.point.position.z)
      return la.point.position.z > lb.point.position.z;
    return a < b;
  }
  return ofFirst > ofSecond ? distances.ofFirst > 0.0f : distances.ofSecond < 0.0f;
}

/// Pixels that are only promised to be cleared count as such.
float EdgeFinder::depthAt(Pixel pixel) const
{
  const FrameView& frame = pass_.frame;
  const PixelRectangle& touched = pass_.touched;
  const bool isTouched = pixel.x >= touched.x0 && pixel.x < touched.x1 && pixel.y >= touched.y0 &&
                         pixel.y < touched.y1;
  return isTouched || frame.clear.extent != FrameClear::Extent::kTouched
             ? frame.depth[pixel.y * frame.rowStride + pixel.x]
             : frame.clear.depth;
}

float EdgeFinder::shareOf(Pixel pixel, Pixel other) const
{
  if (other.x < 0 || other.y < 0 || other.x >= layers_.width || other.y >= layers_.height)
    return 1.0f;
  const std::size_t here = layers_.indexOf(pixel.x, pixel.y),
                    there = layers_.indexOf(other.x, other.y);
  const std::uint32_t instance = layers_.instance[there];
  if (instance == kNobody) {
    const float own = depthAt(pixel);
    return depthAt(other) < own ? 1.0f : 0.0f;
  }
  if (instance == layers_.instance[here] && !isStep(pixel, other))
    return static_cast<float>(layers_.surface[there].count) / samples_;
  return isBefore(pixel, other) ? 0.0f : 1.0f;
}

/// Of most pixels, without the others' bookkeeping: certain that no edge is there.
bool EdgeFinder::isInside(Pixel pixel, std::size_t index) const
{
  const std::uint32_t instance = layers_.instance[index];
  const Settings& settings = settings_[instance];
  const SurfaceLayer& here = layers_.surface[index];
  if (settings.detector != OutlineDetector::kPlane || here.count < pass_.scene.samples ||
      pixel.x == 0 || pixel.y == 0 || pixel.x + 1 == layers_.width || pixel.y + 1 == layers_.height)
    return false;
  const float tolerance = settings.depthTolerance * here.point.pixel + here.point.rounding;
  const auto width = static_cast<std::size_t>(layers_.width);
  for (const std::size_t beside : {index + 1, index - 1, index + width, index - width})
    if (layers_.instance[beside] != instance ||
        PlaneDistances(here, layers_.surface[beside]).areStep(tolerance))
      return false;
  return true;
}

void EdgeFinder::addEdge(Pixel pixel, EdgeRow& edges) const
{
  const std::size_t index = layers_.indexOf(pixel.x, pixel.y);
  if (isInside(pixel, index)) return;
  const auto share = [&](int dx, int dy) { return shareOf(pixel, {pixel.x + dx, pixel.y + dy}); };
  const float right = share(1, 0), left = share(-1, 0), above = share(0, 1), below = share(0, -1);
  const float own = static_cast<float>(layers_.surface[index].count) / samples_;
  const bool isCut = own < 1.0f;
  if (!isCut && right > 0.0f && left > 0.0f && above > 0.0f && below > 0.0f) return;

  const float rightAbove = share(1, 1), leftAbove = share(-1, 1), rightBelow = share(1, -1),
              leftBelow = share(-1, -1);
  constexpr float kSqrt2 = 1.41421356f;
  const Vec2f inwards = {
      kSqrt2 * (right - left) + ((rightAbove + rightBelow) - (leftAbove + leftBelow)),
      kSqrt2 * (above - below) + ((rightAbove + leftAbove) - (rightBelow + leftBelow))};
  const float length = std::sqrt(inwards.x * inwards.x + inwards.y * inwards.y);
  const Vec2f centre = {static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f};
  EdgePoint edge = {centre, {0.0f, 0.0f}, pixel.x, static_cast<std::uint32_t>(index)};
  if (length > 0.0f) {
    edge.normal = {-inwards.x / length, -inwards.y / length};
    float distance = 1.0f;
    if (isCut) {
      distance = CutPixel(edge.normal).distanceOf(own);
    } else {
      // Half way to the neighbours that show nothing of it.
      const auto shorten = [&](float towards, float shareThere) {
        if (shareThere > 0.0f || !(towards > 0.0f)) return;
        if (towards * 0.5f < distance) distance = towards * 0.5f;
      };
      shorten(edge.normal.x, right);
      shorten(-edge.normal.x, left);
      shorten(edge.normal.y, above);
      shorten(-edge.normal.y, below);
    }
    edge.foot = centre + edge.normal * distance;
  }
  edges.points.push_back(edge);
}

/// Where two planes that two pixels of a row or a column show meet.
bool EdgeFinder::crosses(Pixel pixel, Pixel other, CreaseCrossing& crossing) const
{
  if (other.x >= layers_.width || other.y >= layers_.height) return false;
  const std::size_t a = layers_.indexOf(pixel.x, pixel.y), b = layers_.indexOf(other.x, other.y);
  const std::uint32_t instance = layers_.instance[a];
  if (layers_.instance[b] != instance) return false;
  const SurfaceLayer &first = layers_.surface[a], &second = layers_.surface[b];
  if (!(1.0f - dot(first.normal, second.normal) > settings_[instance].creaseBound)) return false;
  if (isStep(pixel, other)) return false;
  const Vec3f towardEye = pass_.scene.camera.parallel
                              ? Vec3f{0, 0, 1}
                              : -(first.point.position + second.point.position);
  const PlaneDistances distances(first, second);
  // Along the gaze: how far the first plane is before the second at either pixel.
  const float atFirst = distances.ofFirst / dot(second.plane, towardEye);
  const float atSecond = -(distances.ofSecond / dot(first.plane, towardEye));
  const float way = atFirst / (atFirst - atSecond);
  const float t = way > 0.0f && way < 1.0f ? way : 0.5f;
  crossing = {{first.x + (second.x - first.x) * t, first.y + (second.y - first.y) * t},
              pixel.x,
              static_cast<std::uint32_t>(a)};
  return true;
}

void EdgeFinder::find(int y, EdgeRow& edges, CreaseRow& creases) const
{
  for (int x = pass_.touched.x0; x < pass_.touched.x1; ++x) {
    const std::uint32_t instance = layers_.instance[layers_.indexOf(x, y)];
    if (instance == kNobody || !isOutlined(instance)) continue;
    addEdge({x, y}, edges);
    CreaseCrossing crossing;
    if (crosses({x, y}, {x + 1, y}, crossing)) creases.toRight.push_back(crossing);
    if (crosses({x, y}, {x, y + 1}, crossing)) creases.toAbove.push_back(crossing);
  }
}

namespace {

const CreaseCrossing* crossingAt(const std::vector<CreaseCrossing>& crossings, int column)
{
  const auto found =
      std::lower_bound(crossings.begin(), crossings.end(), column,
                       [](const CreaseCrossing& one, int x) { return one.column < x; });
  return found != crossings.end() && found->column == column ? &*found : nullptr;
}

}  // namespace

void joinCrossings(const SurfaceLayers& layers, const CreaseRow& row, const CreaseRow& above,
                   CreaseRow& result)
{
  std::vector<int> columns;
  for (const auto* crossings : {&row.toRight, &above.toRight, &row.toAbove})
    for (const CreaseCrossing& crossing : *crossings)
      columns.push_back(crossing.column);
  for (const CreaseCrossing& crossing : row.toAbove)
    if (crossing.column > 0) columns.push_back(crossing.column - 1);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  for (const int x : columns) {
    const CreaseCrossing* const sides[] = {crossingAt(row.toRight, x), crossingAt(row.toAbove, x),
                                           crossingAt(row.toAbove, x + 1),
                                           crossingAt(above.toRight, x)};
    const CreaseCrossing* met[4];
    int count = 0;
    for (const CreaseCrossing* side : sides)
      if (side != nullptr &&
          (count == 0 || layers.instance[side->index] == layers.instance[met[0]->index]))
        met[count++] = side;
    if (count == 0) continue;
    const std::uint32_t index = met[0]->index;
    if (count <= 2) {
      result.segments.push_back({met[0]->place, met[count - 1]->place, x, index});
      continue;
    }
    Vec2f middle = {0.0f, 0.0f};
    for (int i = 0; i < count; ++i)
      middle = middle + met[i]->place;
    middle = middle * (1.0f / static_cast<float>(count));
    for (int i = 0; i < count; ++i)
      result.segments.push_back({middle, met[i]->place, x, index});
  }
}

}  // namespace limn
