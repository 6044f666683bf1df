// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of EdgeFinder that tells where two instances cut each other.
#include "Rendering/Lines/FindEdges.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// How many pixels a surface has to go on where another hides it, by its normals, whose places
/// within their pixels differ.
constexpr float kNearestOutline = 3;
/// Pixels between those that tell how normals turn, so that these places matter less.
constexpr int kApart = 4;

}  // namespace

/// Whether the surfaces that two pixels of two instances show meet between them, rather than that
/// one ends before the other.
bool EdgeFinder::areCut(const Pixel& first, const Pixel& second) const
{
  if (first.instance == second.instance) return false;
  if (!isOutlined(first.instance) && !isOutlined(second.instance)) return false;
  const SurfacePatch &a = first.layer, &b = second.layer;
  const PlaneDistances distances(a, b);
  const bool isLess = distances.ofFirst < distances.ofSecond;
  const float less = isLess ? distances.ofFirst : distances.ofSecond;
  const float more = isLess ? distances.ofSecond : distances.ofFirst;
  const float noise = a.point.rounding < b.point.rounding ? b.point.rounding : a.point.rounding;
  if (!(more > noise) || !(less >= -(noise + ImageOutline::kBesideCut * more))) return false;
  const Vec3f eye = towardEye(a, b);
  return isSteeper(a, b) ? goesOn(first, second, eye) : goesOn(second, first, eye);
}

/// Whether the surface that a pixel shows goes on, behind another, well beyond the next pixel.
bool EdgeFinder::goesOn(const Pixel& pixel, const Pixel& next, Vec3f eye) const
{
  const float steep = dot(pixel.layer.plane, eye);
  if (!(steep * steep * ImageOutline::kSteepestCut >= dot(eye, eye))) return false;
  const int x = pixel.x + (pixel.x - next.x) * kApart, y = pixel.y + (pixel.y - next.y) * kApart;
  if (!isInstanceAt(x, y, pixel.instance)) {
    const PlaneDistances distances(pixel.layer, next.layer);
    const float most = tolerance(pixel, next);
    return distances.ofFirst <= most && distances.ofSecond <= most;
  }
  return fall(pixel, eye) * kNearestOutline <= 1.0f;
}

bool EdgeFinder::isInstanceAt(int x, int y, std::uint32_t instance) const
{
  const bool isInside = x >= 0 && y >= 0 && x < layers_.width && y < layers_.height;
  return isInside && layers_.instance[layers_.indexOf(x, y)] == instance;
}

/// One over the distance, in pixels, at which a rounded surface comes to its outline, by how its
/// normals turn: the square of their cosine to the gaze falls along a straight line towards that.
/// At most 1, as of normals perpendicular to the gaze.
float EdgeFinder::fall(const Pixel& pixel, Vec3f eye) const
{
  const auto squaredAt = [&](std::size_t index) {
    const float cosine = dot(layers_.normal[index], eye);
    return cosine * cosine;
  };
  const float here = squaredAt(pixel.index);
  const auto most = [&](int dx, int dy) {
    float result = 0.0f;
    for (const int way : {-kApart, kApart}) {
      const int x = pixel.x + way * dx, y = pixel.y + way * dy;
      if (!isInstanceAt(x, y, pixel.instance)) continue;
      const float rise = squaredAt(layers_.indexOf(x, y)) - here;
      if (rise > result) result = rise;
    }
    return result;
  };
  const float x = most(1, 0), y = most(0, 1);
  const float slope = std::sqrt(x * x + y * y), whole = here * static_cast<float>(kApart);
  return slope < whole ? slope / whole : 1.0f;
}

/// The line goes over into that of the outline of either, which lies on its side.
float EdgeFinder::leanOfCut(const Pixel& first, const Pixel& second) const
{
  const Vec3f eye = towardEye(first.layer, second.layer);
  const float more = (fall(first, eye) - fall(second, eye)) * (0.5f * kNearestOutline);
  const float lean = more > -0.5f ? (more < 0.5f ? more : 0.5f) : -0.5f;
  return first.instance < second.instance ? lean : -lean;
}

/// Where they meet, on the way from one to the other.
Vec2f EdgeFinder::cutPlace(const Pixel& first, const Pixel& second) const
{
  const SurfacePatch &a = first.layer, &b = second.layer;
  const float way = wayToMeeting(a, b);
  const float t = way > 0.0f ? (way < 1.0f ? way : 1.0f) : 0.0f;
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

void EdgeFinder::addCut(const Pixel& pixel, int x, int y, std::vector<CreaseCrossing>& found) const
{
  const Pixel other = pixelAt(x, y);
  found.push_back({cutPlace(pixel, other),
                   pixel.x,
                   static_cast<std::uint32_t>(pixel.index),
                   {x, y},
                   {pixel.instance, other.instance},
                   false,
                   false,
                   leanOfCut(pixel, other)});
}

/// Of a pixel whose instance has no lines.
void EdgeFinder::addCuts(const Pixel& pixel, CreaseRow& creases) const
{
  const auto addTo = [&](int x, int y, std::vector<CreaseCrossing>& found) {
    if (x >= layers_.width || y >= layers_.height) return;
    const std::uint32_t instance = layers_.instance[layers_.indexOf(x, y)];
    if (instance != kNobody && isOutlined(instance) && areCut(pixel, pixelAt(x, y)))
      addCut(pixel, x, y, found);
  };
  addTo(pixel.x + 1, pixel.y, creases.toRight);
  addTo(pixel.x, pixel.y + 1, creases.toAbove);
}

/// Of its samples, how many show its layer, or what this is cut by.
float EdgeFinder::shareUpToBorder(const Pixel& pixel) const
{
  const float own = shareShown(pixel);
  if (!(own < 1.0f) || layers_.covered[pixel.index] == layers_.countAt(pixel.index)) return own;
  const std::uint32_t wanted = layers_.other[pixel.index];
  if (wanted == pixel.instance) return own;
  const int x1 = std::min(pixel.x + 1, layers_.width - 1);
  const int y1 = std::min(pixel.y + 1, layers_.height - 1);
  for (int y = std::max(pixel.y - 1, 0); y <= y1; ++y)
    for (int x = std::max(pixel.x - 1, 0); x <= x1; ++x)
      if (layers_.instance[layers_.indexOf(x, y)] == wanted && areCut(pixel, pixelAt(x, y)))
        return static_cast<float>(layers_.covered[pixel.index]) / samples_;
  return own;
}

}  // namespace limn
