// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FindEdges.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Lines/IdBorders.h"
#include "Rendering/Lines/PixelArea.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace limn {
namespace {

/// Creases go on so far behind what hides them, in pixels beyond half of the line's width: their
/// last crossing may lie so far before it.
constexpr float kHiddenCrease = 2.0f;

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
    const bool isOutlined = hasImageOutline(instance);
    const float crease = larger(1.0f - static_cast<float>(cosineOfDegrees(outline.creaseDegrees)),
                                ImageOutline::kSameNormals);
    settings_.push_back(
        {isOutlined, outline.detector, outline.creases, crease, hasIdBorders(instance)});
    // Of what has no lines, pixels that it shares with what has some: of several samples.
    const std::int32_t asksWithoutLines = pass.scene.samples > 1 ? kMayHaveEdge : 0;
    bounds_.asks.push_back(
        !isOutlined
            ? asksWithoutLines
            : kMayHaveEdge | kMayCreaseRight | kMayCreaseAbove |
                  (outline.detector == OutlineDetector::kPlane ? 0 : NeighbourBounds::kAlways));
    bounds_.tolerance.push_back(outline.depthTolerance);
    bounds_.crease.push_back(outline.creases == CreaseDetector::kAngle
                                 ? crease
                                 : -std::numeric_limits<float>::infinity());
  }
}

EdgeFinder::Pixel EdgeFinder::pixelAt(int x, int y) const
{
  Pixel pixel;
  pixel.x = x;
  pixel.y = y;
  pixel.index = layers_.indexOf(x, y);
  pixel.instance = layers_.instance[pixel.index];
  if (pixel.instance != kNobody) pixel.layer = layers_.patchAt(x, y);
  return pixel;
}

float EdgeFinder::shareShown(const Pixel& pixel) const
{
  return static_cast<float>(layers_.countAt(pixel.index)) / samples_;
}

float EdgeFinder::tolerance(const Pixel& first, const Pixel& second) const
{
  return larger(toleranceOf(first), toleranceOf(second));
}

float EdgeFinder::toleranceOf(const Pixel& pixel) const
{
  return stepTolerance(pass_.scene.instances[pixel.instance].style, pixel.layer.point);
}

/// Distance along the gaze of a neighbour; the pixel's own where another instance is.
float EdgeFinder::distanceBeside(const Pixel& pixel, int dx, int dy) const
{
  const int x = pixel.x + dx, y = pixel.y + dy;
  const bool isInside = layers_.isInside(x, y);
  const bool isSame = isInside && layers_.instance[layers_.indexOf(x, y)] == pixel.instance;
  return -(isSame ? layers_.pointAt(x, y) : pixel.layer.point).position.z;
}

Vec2f EdgeFinder::sobel(const Pixel& pixel) const
{
  const auto z = [&](int dx, int dy) { return distanceBeside(pixel, dx, dy); };
  const float x = ((z(1, -1) - z(-1, -1)) + 2.0f * (z(1, 0) - z(-1, 0))) + (z(1, 1) - z(-1, 1));
  const float y = ((z(-1, 1) - z(-1, -1)) + 2.0f * (z(0, 1) - z(0, -1))) + (z(1, 1) - z(1, -1));
  return {x * 0.125f, y * 0.125f};
}

float EdgeFinder::laplacian(const Pixel& pixel) const
{
  const auto z = [&](int dx, int dy) { return distanceBeside(pixel, dx, dy); };
  return ((z(1, 0) + z(-1, 0)) + (z(0, 1) + z(0, -1))) - 4.0f * z(0, 0);
}

bool EdgeFinder::isConvolved(const Pixel& first, const Pixel& second) const
{
  const float bound = tolerance(first, second);
  if (settings_[first.instance].detector == OutlineDetector::kSobel) {
    const auto x = static_cast<float>(second.x - first.x),
               y = static_cast<float>(second.y - first.y);
    const float perPixel = x != 0.0f && y != 0.0f ? 0.707106781f : 1.0f;
    const auto slope = [&](const Pixel& pixel) {
      const Vec2f gradient = sobel(pixel);
      return std::fabs((gradient.x * x + gradient.y * y) * perPixel);
    };
    return slope(first) > bound && slope(second) > bound;
  }
  const float la = laplacian(first), lb = laplacian(second);
  return ((la > 0.0f && lb < 0.0f) || (la < 0.0f && lb > 0.0f)) &&
         std::fabs(la - lb) > bound * 2.0f;
}

/// Of two pixels of one instance.
bool EdgeFinder::isStep(const Pixel& first, const Pixel& second) const
{
  return isByPlanes(first) ? isPlaneStep(first, second) : isConvolved(first, second);
}

/// OutlineDetector::kPlane.
bool EdgeFinder::isPlaneStep(const Pixel& first, const Pixel& second) const
{
  const PlaneDistances distances(first.layer, second.layer);
  return distances.areStep(tolerance(first, second)) && !isGroove(first, second, distances);
}

/// Whether two surfaces meet between two pixels, as in a groove, however steep one of them is.
bool EdgeFinder::isGroove(const Pixel& first, const Pixel& second,
                          const PlaneDistances& distances) const
{
  const auto isFlat = [&](const Pixel& pixel, const Pixel& other) {
    const int x = 2 * pixel.x - other.x, y = 2 * pixel.y - other.y;
    if (!layers_.isInside(x, y)) return false;
    const std::size_t behind = layers_.indexOf(x, y);
    return layers_.instance[behind] == pixel.instance &&
           1.0f - dot(layers_.normal[behind], layers_.normal[pixel.index]) <= ImageOutline::kFlat;
  };
  if (!(distances.ofFirst > 0.0f && distances.ofSecond > 0.0f)) return false;
  return isSteeper(first.layer, second.layer) ? isFlat(first, second) : isFlat(second, first);
}

/// From between them, of some length.
Vec3f EdgeFinder::towardEye(const SurfacePatch& first, const SurfacePatch& second) const
{
  return pass_.scene.camera.parallel ? Vec3f{0, 0, 1}
                                     : -(first.point.position + second.point.position);
}

bool EdgeFinder::isSteeper(const SurfacePatch& first, const SurfacePatch& second) const
{
  const Vec3f eye = towardEye(first, second);
  return dot(first.plane, eye) < dot(second.plane, eye);
}

/// Of two pixels with an edge between them: which one's line it is.
bool EdgeFinder::isBefore(const Pixel& first, const Pixel& second) const
{
  const std::uint32_t ia = first.instance, ib = second.instance;
  const SurfacePatch &la = first.layer, &lb = second.layer;
  const bool isByDepth = ia == ib && settings_[ia].detector != OutlineDetector::kPlane;
  const PlaneDistances distances(la, lb);
  const float ofFirst = std::fabs(distances.ofFirst), ofSecond = std::fabs(distances.ofSecond);
  const float off = larger(ofFirst, ofSecond);
  const bool isNoise = off <= larger(la.point.rounding, lb.point.rounding);
  const bool isFirstBehind = !(distances.ofFirst > 0.0f),
             isSecondBehind = !(distances.ofSecond > 0.0f);
  if (ia != ib &&
      (isNoise || (isFirstBehind && isSecondBehind && off <= tolerance(first, second)))) {
    // They touch: that which has lines, or was there first.
    return isOutlined(ia) != isOutlined(ib) ? isOutlined(ia) : ia < ib;
  }
  // A rounded one's plane falls off behind what is behind it.
  if (!isByDepth && !isFirstBehind && !isSecondBehind) return isSteeper(la, lb);
  if (isByDepth || ofFirst == ofSecond) {
    if (la.point.position.z != lb.point.position.z)
      return la.point.position.z > lb.point.position.z;
    return first.index < second.index;
  }
  return ofFirst > ofSecond ? distances.ofFirst > 0.0f : distances.ofSecond < 0.0f;
}

/// Pixels that are only promised to be cleared count as such.
float EdgeFinder::depthAt(int x, int y) const
{
  const FrameView& frame = pass_.frame;
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height)
    return layers_.depth[layers_.indexOf(x, y)];
  const PixelRectangle& touched = pass_.touched;
  const bool isTouched = x >= touched.x0 && x < touched.x1 && y >= touched.y0 && y < touched.y1;
  return isTouched || frame.clear.extent != FrameClear::Extent::kTouched
             ? frame.depth[y * frame.rowStride + x]
             : frame.clear.depth;
}

/// What of a pixel of another instance shows a pixel's surface, which does not end behind it.
float EdgeFinder::shareBeyond(const Pixel& pixel, const Pixel& other) const
{
  const std::size_t i = other.index;
  if (layers_.isSingle || layers_.covered[i] == layers_.count[i]) return 0.0f;
  if (layers_.other[i] != pixel.instance) return 0.0f;
  return static_cast<float>(layers_.covered[i] - layers_.count[i]) / samples_;
}

EdgeFinder::Neighbour EdgeFinder::neighbourAt(const Pixel& pixel, int x, int y) const
{
  if (!layers_.isInside(x, y)) return {1.0f, true, false, false, false, 0.0f, 0.0f, true};
  const Pixel other = pixelAt(x, y);
  if (other.instance == kNobody) {
    const bool isBehind = !(depthAt(x, y) < depthAt(pixel.x, pixel.y));
    return {isBehind ? 0.0f : 1.0f, true, false,    false, false,
            isBehind ? 1.0f : 0.0f, 0.0f, !isBehind};
  }
  if (other.instance != pixel.instance) {
    const float lean = leanOf(pixel, other);
    const float share = lean > -0.5f ? shareBeyond(pixel, other) : 1.0f;
    return {share, true, true, false, isCutBy(lean), partOf(other, lean), lean, lean == -0.5f};
  }
  if (!isOutlined(pixel.instance))
    return {shareShown(other), false, false, false, false, 0.0f, 0.0f, false};
  const bool isEdge = isStep(pixel, other);
  // What convolutions find may be within a surface.
  const bool isOther = isByPlanes(pixel) ? isEdge : isPlaneStep(pixel, other);
  if (!isEdge) return {shareShown(other), isOther, false, false, false, 0.0f, 0.0f, false};
  const bool isNearer = isBefore(pixel, other);
  return {isNearer ? 0.0f : 1.0f,        isOther, false, true, false, isNearer ? 1.0f : 0.0f, 0.0f,
          !isNearer && isByPlanes(pixel)};
}

/// A pixel's neighbours: those at its sides, and then those at its corners.
struct EdgeFinder::Around {
  static constexpr int kSides = 4, kAll = 8;
  static constexpr int kX[kAll] = {1, -1, 0, 0, 1, -1, 1, -1};
  static constexpr int kY[kAll] = {0, 0, 1, -1, 1, 1, -1, -1};

  const Pixel& pixel;
  Neighbour at[kAll];

  PixelPlace placeOf(int i) const { return {pixel.x + kX[i], pixel.y + kY[i]}; }
};

/// Of a pixel that no border cuts: half way to the neighbours that show nothing of its surface, or
/// where these cut it.
void EdgeFinder::addWhole(const Around& around, EdgePoint edge, EdgeRow& edges) const
{
  const Vec2f centre = edge.foot;
  float distance = 1.0f;
  bool isBare = false;
  for (int i = 0; i < Around::kSides; ++i) {
    const Neighbour& neighbour = around.at[i];
    if (neighbour.share > 0.0f || neighbour.isCut) continue;
    isBare = true;
    const float towards = edge.normal.x * static_cast<float>(Around::kX[i]) +
                          edge.normal.y * static_cast<float>(Around::kY[i]);
    if (towards > 0.0f && towards * 0.5f < distance) distance = towards * 0.5f;
  }
  if (isBare) {
    edge.foot = centre + edge.normal * distance;
    edges.points.push_back(edge);
  }
  for (int i = 0; i < Around::kSides; ++i) {
    const Neighbour& neighbour = around.at[i];
    if (neighbour.share > 0.0f || !neighbour.isCut || !(neighbour.part > 0.0f)) continue;
    const auto [x, y] = around.placeOf(i);
    edge.foot = cutPlace(around.pixel, pixelAt(x, y));
    edge.part = neighbour.part;
    edges.points.push_back(edge);
  }
}

/// How far from an edge, along its normal, the planes that its pixel and one beyond it show meet;
/// as far as the samples, which tell the edge's place to one of them, leave that open, and to the
/// degree to which they cut each other.
float EdgeFinder::shiftOf(const EdgePoint& edge, const Pixel& pixel, const Pixel& beyond,
                          float lean) const
{
  const Vec2f way = cutPlace(pixel, beyond) - edge.foot;
  const float off = edge.normal.x * way.x + edge.normal.y * way.y, most = 1.0f / samples_;
  const float bounded = off > -most ? (off < most ? off : most) : -most;
  return bounded * (1.0f - 2.0f * std::fabs(lean));
}

/// Of a pixel that a border cuts, which may be its surface's, that of what its other samples show,
/// or both.
void EdgeFinder::addParts(const Around& around, EdgePoint edge, EdgeRow& edges) const
{
  const Pixel& pixel = around.pixel;
  const bool isShared =
      !layers_.isSingle && layers_.covered[pixel.index] > layers_.count[pixel.index];
  const std::uint32_t other = isShared ? layers_.other[pixel.index] : pixel.instance;
  float own = 0.0f, others = 0.0f, any = 0.0f, shift = 0.0f;
  int count = 0, countOfAny = 0;
  EdgePoint beyond = edge;
  for (int i = 0; i < Around::kAll; ++i) {
    const Neighbour& neighbour = around.at[i];
    if (neighbour.part > 0.0f) {
      any += neighbour.part;
      ++countOfAny;
    }
    if (other == pixel.instance || !neighbour.isForeign) continue;
    const PixelPlace place = around.placeOf(i);
    if (layers_.instance[layers_.indexOf(place.x, place.y)] != other) continue;
    if (count == 0) beyond.shown = place;
    own += neighbour.part;
    others += partOf(pixel, -neighbour.lean);
    if (neighbour.isCut) shift += shiftOf(edge, pixel, pixelAt(place.x, place.y), neighbour.lean);
    ++count;
  }
  if (count > 0) {
    edge.part = own / static_cast<float>(count);
    edge.foot = edge.foot + edge.normal * (shift / static_cast<float>(count));
  } else if (countOfAny > 0) {
    edge.part = any / static_cast<float>(countOfAny);
  }
  if (isOutlined(pixel.instance) && edge.part > 0.0f) edges.points.push_back(edge);
  if (!isOutlined(other) || !(others > 0.0f) || edge.normal == Vec2f{0.0f, 0.0f}) return;
  beyond.foot = edge.foot;
  beyond.normal = edge.normal * -1.0f;
  beyond.instance = other;
  beyond.part = others / static_cast<float>(count);
  edges.points.push_back(beyond);
}

void EdgeFinder::addEdges(const Pixel& pixel, EdgeRow& edges, StepGrid& steps) const
{
  Around around = {pixel, {}};
  const auto compare = [&](int first, int end) {
    for (int i = first; i < end; ++i)
      around.at[i] = neighbourAt(pixel, pixel.x + Around::kX[i], pixel.y + Around::kY[i]);
  };
  compare(0, Around::kSides);
  const auto sideIf = [&](int i, unsigned side) { return around.at[i].isOther ? side : 0u; };
  steps.part(pixel.index, sideIf(0, StepGrid::kRight) | sideIf(1, StepGrid::kLeft) |
                              sideIf(2, StepGrid::kAbove) | sideIf(3, StepGrid::kBelow));
  const auto share = [&](int i) { return around.at[i].share; };
  const float own = shareShown(pixel);
  const bool isPart = own < 1.0f;
  if (!isPart && share(0) > 0.0f && share(1) > 0.0f && share(2) > 0.0f && share(3) > 0.0f) return;

  compare(Around::kSides, Around::kAll);
  constexpr float kSqrt2 = 1.41421356f;
  const Vec2f inwards = {
      kSqrt2 * (share(0) - share(1)) + ((share(4) + share(6)) - (share(5) + share(7))),
      kSqrt2 * (share(2) - share(3)) + ((share(4) + share(5)) - (share(6) + share(7)))};
  const float length = std::sqrt(inwards.x * inwards.x + inwards.y * inwards.y);
  const Vec2f centre = {static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f};
  EdgePoint edge = {
      centre,         {0.0f, 0.0f},       pixel.x, static_cast<std::uint32_t>(pixel.index),
      pixel.instance, {pixel.x, pixel.y}, 1.0f,    true,
      false};
  for (int i = 0; i < Around::kSides; ++i) {
    const auto [x, y] = around.placeOf(i);
    if (around.at[i].isStep && !isBent(pixel, pixelAt(x, y))) edge.isBent = false;
  }
  for (const Neighbour& neighbour : around.at)
    edge.isBesideHidden |= neighbour.isHiding;
  if (length > 0.0f) edge.normal = {-inwards.x / length, -inwards.y / length};
  if (!isPart) {
    if (isOutlined(pixel.instance)) addWhole(around, edge, edges);
    return;
  }
  if (length > 0.0f) edge.foot = centre + edge.normal * CutPixel(edge.normal).distanceOf(own);
  addParts(around, edge, edges);
}

/// Where two planes that two pixels of a row or a column show meet: a part of the way between.
float EdgeFinder::wayToMeeting(const SurfacePatch& first, const SurfacePatch& second) const
{
  const Vec3f eye = towardEye(first, second);
  const PlaneDistances distances(first, second);
  // Along the gaze: how far the first plane is before the second at either pixel.
  const float atFirst = distances.ofFirst / dot(second.plane, eye);
  const float atSecond = -(distances.ofSecond / dot(first.plane, eye));
  return atFirst / (atFirst - atSecond);
}

Vec2f EdgeFinder::creasePlace(const SurfacePatch& first, const SurfacePatch& second) const
{
  const float way = wayToMeeting(first, second);
  const float t = way > 0.0f && way < 1.0f ? way : 0.5f;
  return {first.x + (second.x - first.x) * t, first.y + (second.y - first.y) * t};
}

/// The plane's normal where the axes are the screen's x and y and the window's depth.
Vec3f EdgeFinder::planeOnScreen(const SurfacePatch& patch) const
{
  const auto& m = layers_.toView->matrix().m;
  const Vec3f n = patch.plane;
  const float distance = dot(n, patch.point.position);
  const auto along = [&](int axis) {
    return ((n.x * m[0][axis] + n.y * m[1][axis]) + n.z * m[2][axis]) - distance * m[3][axis];
  };
  return {along(0), along(1), along(2)};
}

Vec2f EdgeFinder::endBehind(const CreaseCrossing& crossing, PixelPlace inwards) const
{
  const PixelPlace one = layers_.pixelOf(crossing.index), other = crossing.neighbour;
  // Normals need not tell where borders of ids go.
  if (!crossing.isBent) return crossing.place;
  const Pixel first = pixelAt(one.x, one.y), second = pixelAt(other.x, other.y);
  // Steps of its own mesh may end at the crease.
  const auto isHidden = [&](const Pixel& from) {
    const Neighbour into = neighbourAt(from, from.x + inwards.x, from.y + inwards.y);
    return into.isForeign && into.isHiding;
  };
  if (!isHidden(first) && !isHidden(second)) return crossing.place;
  if (!(1.0f - dot(first.layer.plane, second.layer.plane) > ImageOutline::kSameNormals))
    return crossing.place;
  // Along the line in which the planes meet.
  const Vec3f a = planeOnScreen(first.layer), b = planeOnScreen(second.layer);
  const Vec2f line = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z};
  const float length = std::sqrt(line.x * line.x + line.y * line.y);
  if (!(length > 0.0f && length <= std::numeric_limits<float>::max())) return crossing.place;
  const float towards =
      line.x * static_cast<float>(inwards.x) + line.y * static_cast<float>(inwards.y);
  const float width = pass_.scene.instances[crossing.instance].style.outlineWidth;
  const float way = (kHiddenCrease + 0.5f * width) / length;
  return crossing.place + line * (towards < 0.0f ? -way : way);
}

/// The pixel's own where another instance is.
Vec3f EdgeFinder::normalBeside(const Pixel& pixel, int dx, int dy) const
{
  const int x = pixel.x + dx, y = pixel.y + dy;
  const bool isInside = layers_.isInside(x, y);
  const bool isSame = isInside && layers_.instance[layers_.indexOf(x, y)] == pixel.instance;
  return layers_.normal[isSame ? layers_.indexOf(x, y) : pixel.index];
}

/// The square of the length of Sobel's gradient, per pixel.
float EdgeFinder::gradientOfNormals(const Pixel& pixel) const
{
  const auto n = [&](int dx, int dy) { return normalBeside(pixel, dx, dy); };
  const Vec3f x = ((n(1, -1) - n(-1, -1)) + (n(1, 0) - n(-1, 0)) * 2.0f) + (n(1, 1) - n(-1, 1));
  const Vec3f y = ((n(-1, 1) - n(-1, -1)) + (n(0, 1) - n(0, -1)) * 2.0f) + (n(1, 1) - n(1, -1));
  return (dot(x, x) + dot(y, y)) * (0.125f * 0.125f);
}

Vec3f EdgeFinder::laplacianOfNormals(const Pixel& pixel) const
{
  const auto n = [&](int dx, int dy) { return normalBeside(pixel, dx, dy); };
  return ((n(1, 0) + n(-1, 0)) + (n(0, 1) + n(0, -1))) - n(0, 0) * 4.0f;
}

/// Of two pixels of one instance in a row or a column.
bool EdgeFinder::isBent(const Pixel& first, const Pixel& second) const
{
  const Settings& settings = settings_[first.instance];
  const float bound = settings.creaseBound;
  const float turn = 1.0f - dot(layers_.normal[first.index], layers_.normal[second.index]);
  switch (settings.creases) {
    case CreaseDetector::kSobel:
      return bound < 2.0f && turn > bound * (1.0f / 9.0f) &&
             (gradientOfNormals(first) > 0.5f * bound || gradientOfNormals(second) > 0.5f * bound);
    case CreaseDetector::kLaplacian: {
      const Vec3f atFirst = laplacianOfNormals(first), atSecond = laplacianOfNormals(second);
      const Vec3f apart = atSecond - atFirst;
      return bound < 2.0f && dot(atFirst, atSecond) < 0.0f && dot(apart, apart) > 8.0f * bound;
    }
    case CreaseDetector::kAngle:
      break;
  }
  return turn > bound;
}

void EdgeFinder::addCrossing(const Pixel& pixel, int x, int y,
                             std::vector<CreaseCrossing>& found) const
{
  if (x >= layers_.endX() || y >= layers_.endY()) return;
  const Pixel other = pixelAt(x, y);
  if (other.instance != pixel.instance) return;
  const SurfacePatch &first = pixel.layer, &second = other.layer;
  const Settings& settings = settings_[pixel.instance];
  const bool isCrease = isBent(pixel, other);
  const bool isIdBorder = settings.hasIds && layers_.id[pixel.index] != layers_.id[other.index];
  if (!isCrease && !isIdBorder) return;
  found.push_back({isCrease ? creasePlace(first, second)
                            : placeOfIdBorder(layers_, {pixel.x, pixel.y, x != pixel.x}),
                   pixel.x,
                   static_cast<std::uint32_t>(pixel.index),
                   {x, y},
                   pixel.instance,
                   isStep(pixel, other),
                   isCrease && !isIdBorder});
}

void EdgeFinder::look(PixelPlace place, unsigned marks, EdgeRow& edges, CreaseRow& creases,
                      StepGrid& steps) const
{
  const auto [x, y] = place;
  const Pixel pixel = pixelAt(x, y);
  if ((marks & kMayHaveEdge) != 0) addEdges(pixel, edges, steps);
  if (!isOutlined(pixel.instance)) return;
  if ((marks & kMayCreaseRight) != 0) addCrossing(pixel, x + 1, y, creases.toRight);
  if ((marks & kMayCreaseAbove) != 0) addCrossing(pixel, x, y + 1, creases.toAbove);
}

void EdgeFinder::find(int y, const std::uint8_t* marks, EdgeRow& edges, CreaseRow& creases,
                      StepGrid& steps) const
{
  const auto count = static_cast<std::size_t>(pass_.touched.x1 - pass_.touched.x0);
  steps.clearRow(y, pass_.touched.x0, pass_.touched.x1);
  for (std::size_t i = 0; i < count;) {
    std::uint64_t eight;
    std::memcpy(&eight, marks + i, sizeof eight);
    if (eight == 0) {
      i += sizeof eight;
      continue;
    }
    for (const std::size_t end = i + sizeof eight; i < end; ++i)
      if (marks[i] != 0)
        look({pass_.touched.x0 + static_cast<int>(i), y}, marks[i], edges, creases, steps);
  }
}

}  // namespace limn
