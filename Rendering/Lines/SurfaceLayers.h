// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenToView.h"

#include <cstddef>
#include <cstdint>

namespace limn {

/// What a pixel shows of the surface that its nearest sample lies on.
struct SurfaceLayer {
  ViewPoint point;       ///< at the nearest sample
  Vec3f normal;          ///< FrameView::normal
  Vec3f plane;           ///< that of the triangle's plane, which the former need not be
  float x, y;            ///< of the nearest sample, in pixels from the frame's corner
  Rgba8 color;           ///< the mean of the samples that show it
  std::uint8_t count;    ///< samples that show it
  std::uint8_t shared;   ///< samples whose mean the pixel's colour is, at least `count`
  std::uint8_t covered;  ///< samples that show any opaque instance
  /// Instance of the first sample that shows another surface, if `covered` is more than `count`.
  std::uint32_t other;
};

/// The layers of a frame, row by row from below, without gaps between rows. Kept from frame to
/// frame for their memory.
struct SurfaceLayers {
  int width = 0, height = 0;
  Array<std::uint32_t> instance;  ///< place in Scene::instances; kNobody: the others mean nothing
  Array<SurfaceLayer> surface;
  Array<Vec3f> radiance;  ///< the mean of the layer's; empty unless the frame has radiance
  Array<float> halo;      ///< share of the layer that a halo has; empty: none

  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

inline bool hasImageOutline(const Instance& instance)
{
  return instance.style.imageOutline.detector != OutlineDetector::kNone &&
         instance.style.outlineWidth > 0.0f && !instance.isTranslucent();
}

inline bool hasCues(const Instance& instance)
{
  return instance.style.cues.any() && instance.hull == nullptr && !instance.isTranslucent();
}

/// How far one layer may lie off another's plane.
inline float stepTolerance(const Style& style, const ViewPoint& point)
{
  return style.imageOutline.depthTolerance * point.pixel + point.rounding;
}

/// How two layers lie to each other: how far each is before the other's plane.
struct PlaneDistances {
  float ofSecond, ofFirst;

  PlaneDistances(const SurfaceLayer& first, const SurfaceLayer& second)
  {
    const Vec3f way = second.point.position - first.point.position;
    ofSecond = dot(first.plane, way);
    ofFirst = -dot(second.plane, way);
  }
  /// OutlineDetector::kPlane. Each lies behind the other's plane where a surface is rounded.
  bool areStep(float tolerance) const
  {
    const bool isOff = ofSecond > tolerance || ofSecond < -tolerance || ofFirst > tolerance ||
                       ofFirst < -tolerance;
    return isOff && (ofSecond > 0.0f || ofFirst > 0.0f);
  }
};

}  // namespace limn
