// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of EdgeFinder that tells how borders between two instances lie to them: whether one ends
// before the other, or they cut each other.
#include "Rendering/Lines/FindEdges.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Up to how many pixels from a surface's own outline its line lies on its side, all of it.
constexpr float kNearestOutline = 3;
/// Pixels between those that tell how normals turn, so that their places within their pixels matter
/// less; nearer ones where the surface is narrower, or has a sharp edge.
constexpr int kApart = 4;
/// Of 1 - n.n' of such pixels, that of 30 degrees: beyond it another face may begin, whose tilt
/// says nothing of where this one ends.
constexpr float kSharpEdge = 0.134f;
/// Within how many pixels of a pair the planes that they show have to meet, or how many pixels off
/// each other these may be, for the line to lie on both sides in part.
constexpr float kMeetingReach = 2, kMeetingDepth = 0.5f;
/// Beside what has no line, a line is whole unless so much of it, as one part of as many, or more
/// would be on that side.
constexpr float kFade = 4;

/// 0 and 1 if it is less or more.
float clamped(float x)
{
  return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}

/// A vector times the power of two that makes its largest component 1 to 2: its fourth power is a
/// float's then, whatever the unit of length, and no bit of what does not depend on that changes.
Vec3f scaledToOne(Vec3f v)
{
  const float largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest > 0.0f ? v * std::ldexp(1.0f, -std::ilogb(largest)) : v;
}

}  // namespace

/// How far the surfaces that two pixels of two instances show are from meeting between them: 0
/// where they do, 1 where one ends well before the other.
float EdgeFinder::gapBetween(const Pixel& first, const Pixel& second) const
{
  const SurfacePatch &a = first.layer, &b = second.layer;
  const PlaneDistances distances(a, b);
  if (distances.ofFirst > 0.0f && distances.ofSecond > 0.0f) return 0.0f;
  const float ofFirst = std::fabs(distances.ofFirst), ofSecond = std::fabs(distances.ofSecond);
  const float more = ofFirst < ofSecond ? ofSecond : ofFirst;
  const float offRidge = more / tolerance(first, second) - 1.0f;
  if (!(distances.ofFirst > 0.0f || distances.ofSecond > 0.0f)) return clamped(offRidge);
  // Along the gaze, but for a common factor, at either pixel.
  const Vec3f eye = towardEye(a, b);
  const float atFirst = ofFirst * dot(a.plane, eye), atSecond = ofSecond * dot(b.plane, eye);
  const float less = atFirst < atSecond ? atFirst : atSecond;
  const float pixels = less / (std::fabs(atFirst - atSecond) * kMeetingReach);
  const float noise = a.point.rounding < b.point.rounding ? b.point.rounding : a.point.rounding;
  const float pixel = a.point.pixel < b.point.pixel ? b.point.pixel : a.point.pixel;
  const float off = more / (noise + kMeetingDepth * pixel);
  const float gap = pixels < off ? pixels : off;
  // They meet at that pixel which lies in the other's plane: in a groove if that is the one behind.
  const bool isAtRidge = distances.ofFirst > 0.0f ? atFirst < atSecond : atSecond < atFirst;
  return clamped(isAtRidge && gap < offRidge ? offRidge : gap);
}

/// How the line between what two pixels of two instances show lies to their border: by what share
/// of its width more than half of it is on the first's side. 0.5 where that ends before the
/// second's, -0.5 the other way round; in between where they cut each other, near there, or both.
float EdgeFinder::leanOf(const Pixel& first, const Pixel& second) const
{
  const bool isLined = isOutlined(first.instance) || isOutlined(second.instance);
  const float gap = isLined ? gapBetween(first, second) : 1.0f;
  const float whole = gap > 0.0f && isBefore(first, second) ? 0.5f : -0.5f;
  if (!(gap < 1.0f)) return whole;
  const Vec3f eye = scaledToOne(towardEye(first.layer, second.layer));
  const float more = nearness(first, eye) - nearness(second, eye);
  const float lean = more > -0.5f ? (more < 0.5f ? more : 0.5f) : -0.5f;
  return gap > 0.0f ? lean + (whole - lean) * gap : lean;
}

/// What part of its own line a surface draws, with what is beyond the border.
float EdgeFinder::partOf(const Pixel& beyond, float lean) const
{
  const float part = 0.5f + lean;
  return isOutlined(beyond.instance) ? part : clamped(kFade * part);
}

bool EdgeFinder::isInstanceAt(int x, int y, std::uint32_t instance) const
{
  // Farther out the layers may be an earlier frame's.
  const PixelRectangle& touched = pass_.touched;
  const bool isTouched = x >= touched.x0 && x < touched.x1 && y >= touched.y0 && y < touched.y1;
  return isTouched && layers_.instance[layers_.indexOf(x, y)] == instance;
}

/// Of a pixel to its surface's own outline: 0.5 or more where that is within kNearestOutline pixels
/// or its plane is too steep to tell, 0 far from it.
float EdgeFinder::nearness(const Pixel& pixel, Vec3f eye) const
{
  const float cosine = dot(pixel.layer.plane, eye);
  const float steep = 2.0f - cosine * cosine * (2.0f * ImageOutline::kSteepestCut) / dot(eye, eye);
  const float near = fall(pixel, eye);
  const float most = steep > near ? (steep < 1.0f ? steep : 1.0f) : near;
  return most * (0.5f * kNearestOutline);
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
  const auto riseOn = [&](int dx, int dy) {
    for (int apart = kApart; apart > 0; apart /= 2) {
      const int x = pixel.x + apart * dx, y = pixel.y + apart * dy;
      if (!isInstanceAt(x, y, pixel.instance)) continue;
      const std::size_t index = layers_.indexOf(x, y);
      if (1.0f - dot(layers_.normal[pixel.index], layers_.normal[index]) > kSharpEdge) continue;
      return (squaredAt(index) - here) * static_cast<float>(kApart / apart);
    }
    return 0.0f;
  };
  const auto most = [&](int dx, int dy) {
    const float first = riseOn(-dx, -dy), second = riseOn(dx, dy);
    const float more = first < second ? second : first;
    return more > 0.0f ? more : 0.0f;
  };
  const float x = most(1, 0), y = most(0, 1);
  const float slope = std::sqrt(x * x + y * y), whole = here * static_cast<float>(kApart);
  return slope < whole ? slope / whole : 1.0f;
}

/// Where they meet, on the way from one to the other, or half way where one ends before the other.
Vec2f EdgeFinder::cutPlace(const Pixel& first, const Pixel& second) const
{
  const SurfacePatch &a = first.layer, &b = second.layer;
  const float meeting = clamped(wayToMeeting(a, b));
  const float t = meeting + (0.5f - meeting) * gapBetween(first, second);
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

}  // namespace limn
