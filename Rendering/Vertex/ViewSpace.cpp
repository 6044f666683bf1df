// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ViewSpace.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int kHalfPixel = kSubpixels / 2;
constexpr double kFloatRounding = 1.0 / (1 << 24);
constexpr double kLargestErrorPixels = 1.0 / 32;

/// w at the near plane of a perspective projection; 0 if the matrix is of another kind.
double nearW(const Mat4d& viewToClip)
{
  const auto& p = viewToClip.m;
  if (p[3][0] != 0 || p[3][1] != 0 || p[3][2] != -1 || p[3][3] != 0) return 0;
  return p[2][3] / (p[2][2] - 1.0);
}

struct Range {
  double low, high, largestTerm;
};

/// Bounds of a matrix row over a box, and of the terms that are summed to it.
Range rowOverBox(const Mat4d& m, int row, const LocalFrame& frame)
{
  const double low[3] = {frame.low.x, frame.low.y, frame.low.z};
  const double high[3] = {frame.high.x, frame.high.y, frame.high.z};
  Range range = {m.m[row][3], m.m[row][3], std::fabs(m.m[row][3])};
  for (int axis = 0; axis < 3; ++axis) {
    const double a = m.m[row][axis] * low[axis], b = m.m[row][axis] * high[axis];
    range.low += std::min(a, b);
    range.high += std::max(a, b);
    range.largestTerm += std::max(std::fabs(a), std::fabs(b));
  }
  return range;
}

/// Whether transforming in float could move a visible vertex noticeably. A bound: four roundings a
/// row, the divide and the viewport, on the largest terms, at the nearest visible w.
bool needsDouble(const Mat4d& toClip, const Mat4d& viewToClip, const LocalFrame& frame,
                 int largestSide)
{
  const Range x = rowOverBox(toClip, 0, frame), y = rowOverBox(toClip, 1, frame);
  const Range w = rowOverBox(toClip, 3, frame);
  const double nearestW = std::max(w.low, nearW(viewToClip));
  if (!(nearestW > 0)) return true;
  const double terms = std::max(x.largestTerm, y.largestTerm) + w.largestTerm;
  const double pixels = 8.0 * kFloatRounding * terms / nearestW * largestSide / 2.0;
  return !(pixels <= kLargestErrorPixels);
}

Mat4f normalMatrix(const Mat4d& localToView)
{
  Mat4d cofactor = cofactor3(localToView);
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      largest = std::max(largest, std::fabs(cofactor.m[row][column]));
  // A flat actor (a scale of zero) has no normals: any finite matrix will do.
  double scale = largest > 0 ? 1.0 / largest : 0.0;
  if (determinant3(localToView) < 0) scale = -scale;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      cofactor.m[row][column] *= scale;
  return toFloat(cofactor);
}

float edgeScaleOf(const LocalFrame& frame)
{
  const Vec3d size = vec3Cast<double>(frame.high) - vec3Cast<double>(frame.low);
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0)) return 1.0f;
  // Of meshes of these sizes also triangles far smaller than the box have theirs as they are.
  constexpr double kSmall = 0x1p-16, kLarge = 0x1p30;
  if (largest >= kSmall && largest <= kLarge) return 1.0f;
  constexpr int kMostExponent = 126;  // of both signs, as floats without denormals have it
  return std::ldexp(1.0f, std::clamp(-std::ilogb(largest), -kMostExponent, kMostExponent));
}

template <class T>
ClipPoint clipPointIn(const Mat4<T>& m, Vec3<T> p)
{
  const auto row = [&](int r) -> double {
    return (m.m[r][0] * p.x + m.m[r][1] * p.y) + (m.m[r][2] * p.z + m.m[r][3]);
  };
  return {row(0), row(1), row(2), row(3)};
}

template <class T>
ScreenVertex screenVertexIn(const InstanceTransform& transform, ClipPoint clip)
{
  const T x = static_cast<T>(clip.x), y = static_cast<T>(clip.y), z = static_cast<T>(clip.z),
          w = static_cast<T>(clip.w);
  const T subpixelsX = static_cast<T>(transform.subpixelsX);
  const T subpixelsY = static_cast<T>(transform.subpixelsY);
  ScreenVertex vertex = {0, 0, 0.0f, 0.0f, true};
  if (!(z + w >= T(0)) || !(w >= static_cast<T>(kSmallestW))) return vertex;
  const T inverseW = T(1) / w;
  const T screenX = (x * inverseW) * subpixelsX + subpixelsX;
  const T screenY = (y * inverseW) * subpixelsY + subpixelsY;
  const T guard = static_cast<T>(kGuardSubpixels);
  if (!(std::fabs(screenX) <= guard) || !(std::fabs(screenY) <= guard)) return vertex;
  vertex.x = static_cast<std::int32_t>(std::nearbyint(screenX));
  vertex.y = static_cast<std::int32_t>(std::nearbyint(screenY));
  vertex.depth = static_cast<float>((z * inverseW) * T(0.5) + T(0.5));
  vertex.inverseW = static_cast<float>(inverseW);
  vertex.needsClip = false;
  return vertex;
}

}  // namespace

InstanceTransform makeInstanceTransform(const Camera& camera, const Mat4d& modelToWorld,
                                        const LocalFrame& frame, int width, int height)
{
  const Mat4d localToWorld = modelToWorld * translation(frame.origin);
  const Mat4d localToView = camera.worldToView * localToWorld;
  InstanceTransform transform;
  transform.toClip = camera.viewToClip * localToView;
  transform.toClipFloat = toFloat(transform.toClip);
  transform.toView = localToView;
  transform.toViewFloat = toFloat(localToView);
  transform.normalToView = normalMatrix(localToView);
  transform.subpixelsX = width * kHalfPixel;
  transform.subpixelsY = height * kHalfPixel;
  transform.precise = frame.hasLowParts || needsDouble(transform.toClip, camera.viewToClip, frame,
                                                       std::max(width, height));
  transform.hasLowParts = frame.hasLowParts;
  transform.edgeScale = edgeScaleOf(frame);
  transform.mirrored = determinant3(modelToWorld) < 0;
  return transform;
}

ClipPoint clipPoint(const InstanceTransform& transform, LocalPosition p)
{
  if (!transform.precise) return clipPointIn<float>(transform.toClipFloat, p.high);
  return clipPointIn<double>(transform.toClip, exact(p));
}

Vec3f viewPosition(const InstanceTransform& transform, LocalPosition p)
{
  if (!transform.hasLowParts) return transformPoint(transform.toViewFloat, p.high);
  return vec3Cast<float>(transformPoint(transform.toView, exact(p)));
}

ScreenVertex screenVertex(const InstanceTransform& transform, ClipPoint clip)
{
  return transform.precise ? screenVertexIn<double>(transform, clip)
                           : screenVertexIn<float>(transform, clip);
}

}  // namespace limn
