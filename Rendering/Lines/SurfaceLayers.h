// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenToView.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace limn {

/// Where a pixel's nearest sample lies, and how the surface lies there.
struct SurfacePatch {
  ViewPoint point;
  Vec3f plane;  ///< unit normal of the triangle's plane
  float x, y;   ///< of the sample, in pixels from the frame's corner
};

/// What a pixel shows of the surface that its nearest sample lies on.
struct SurfaceLayer : SurfacePatch {
  Vec3f normal;          ///< FrameView::normal, which the plane's need not be
  Rgba8 color;           ///< the mean of the samples that show it
  std::uint8_t count;    ///< samples that show it
  std::uint8_t shared;   ///< samples whose mean the pixel's colour is, at least `count`
  std::uint8_t covered;  ///< samples that show any opaque instance
  /// Instance of the first sample that shows another surface, if `covered` is more than `count`.
  std::uint32_t other;
};

/// Vectors, one array a component.
struct LayerVectors {
  Array<float> x, y, z;

  void resize(std::size_t size)
  {
    x.resize(size);
    y.resize(size);
    z.resize(size);
  }
  Vec3f operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

struct PixelPlace {
  int x, y;
};

/// The layers of a frame and its apron, row by row from below, without gaps between rows. Kept from
/// frame to frame for their memory.
struct SurfaceLayers {
  /// Elements behind the last pixel's, for vectors to read.
  static constexpr std::size_t kSpare = 64;

  int width = 0, height = 0;  ///< of the frame
  /// Pixels around it, which have numbers below 0, and from `width` or `height` on. They have no
  /// colours, no radiance and no halos over them.
  int apron = 0;
  Span<const SampleOffset> offsets;
  std::optional<ScreenToView> toView;
  /// Place in Scene::instances; kNobody: the others mean nothing. Set in and next to the pixels
  /// that were touched; in all, if there are depth cues.
  Array<std::uint32_t> instance;
  // As SurfaceLayer has them:
  // The next five are not written with one sample a pixel, which leaves them nothing to say.
  bool isSingle = false;       ///< they are 0, 1, 1, 1 and of no meaning
  Array<std::uint8_t> sample;  ///< the nearest
  Array<std::uint8_t> count, shared, covered;
  Array<std::uint32_t> other;
  Array<float> depth;  ///< of that sample; in the apron also what was there before
  LayerVectors normal, plane;
  Array<Rgba8> color;
  Array<Vec3f> radiance;  ///< the mean of the layer's; empty unless the frame has radiance
  /// Share of the layer that a halo has; of nobody's pixels what it would have of a layer far
  /// behind, if the scene has lines or translucent surfaces. Empty: there are no halos.
  Array<float> halo;
  Array<std::uint32_t> haloOwner;  ///< where that is not 0: the pixel whose surface has the halo
  /// Likewise, the pixel whose halo reaches farthest beyond it, which need not be that of the
  /// nearest surface; if the scene has translucent surfaces.
  Array<std::uint32_t> haloBorder;
  Array<std::uint8_t> ends;       ///< 1 where a surface with a halo ends; else 0
  bool hasIds = false;            ///< the next two are written
  Array<std::uint32_t> id;        ///< of Attributes::cellIds that of most samples, or the first of
                                  ///< these; 0: there are none
  Array<std::uint8_t> idSamples;  ///< how many of `count` show it

  std::size_t stride() const { return static_cast<std::size_t>(width + 2 * apron); }
  int endX() const { return width + apron; }
  int endY() const { return height + apron; }
  bool isInside(int x, int y) const
  {
    return x >= -apron && y >= -apron && x < endX() && y < endY();
  }
  bool isAtEnd(int x, int y) const
  {
    return x == -apron || y == -apron || x + 1 == endX() || y + 1 == endY();
  }
  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y + apron) * stride() + static_cast<std::size_t>(x + apron);
  }
  PixelPlace pixelOf(std::size_t index) const
  {
    return {static_cast<int>(index % stride()) - apron, static_cast<int>(index / stride()) - apron};
  }
  // Of these, all require that an instance is there.
  Vec2f placeAt(int x, int y) const
  {
    const SampleOffset offset = offsets[isSingle ? 0 : sample[indexOf(x, y)]];
    return {static_cast<float>(x * kSubpixels + offset.x) * (1.0f / kSubpixels),
            static_cast<float>(y * kSubpixels + offset.y) * (1.0f / kSubpixels)};
  }
  ViewPoint pointAt(int x, int y) const
  {
    const Vec2f place = placeAt(x, y);
    return toView->at(place.x, place.y, depth[indexOf(x, y)]);
  }
  SurfacePatch patchAt(int x, int y) const
  {
    const std::size_t i = indexOf(x, y);
    const Vec2f place = placeAt(x, y);
    return {toView->at(place.x, place.y, depth[i]), plane[i], place.x, place.y};
  }
  SurfaceLayer at(int x, int y) const
  {
    const std::size_t i = indexOf(x, y);
    SurfaceLayer layer;
    static_cast<SurfacePatch&>(layer) = patchAt(x, y);
    layer.normal = normal[i];
    layer.color = color[i];
    layer.count = countAt(i);
    layer.shared = isSingle ? std::uint8_t{1} : shared[i];
    layer.covered = isSingle ? std::uint8_t{1} : covered[i];
    layer.other = isSingle ? kNobody : other[i];
    return layer;
  }
  std::uint8_t countAt(std::size_t i) const { return isSingle ? std::uint8_t{1} : count[i]; }
  ViewPoint pointAt(std::size_t index) const
  {
    const PixelPlace pixel = pixelOf(index);
    return pointAt(pixel.x, pixel.y);
  }
};

inline bool hasImageOutline(const Instance& instance)
{
  return instance.style.imageOutline.detector != OutlineDetector::kNone &&
         instance.style.outlineWidth > 0.0f && !instance.isTranslucent();
}

/// How many pixels outside of a frame the lines of its outlines come from.
inline int outlineApron(const Scene& scene)
{
  int apron = 0;
  for (const Instance& instance : scene.instances)
    if (hasImageOutline(instance))
      apron = std::max(
          apron, static_cast<int>(std::ceil(instance.style.outlineWidth)) + ImageOutline::kApron);
  return apron;
}

inline bool hasIdBorders(const Instance& instance)
{
  return hasImageOutline(instance) && instance.style.imageOutline.ids && instance.hull == nullptr &&
         !instance.attributes.cellIds.empty();
}

inline bool hasCues(const Instance& instance)
{
  return instance.style.cues.any() && instance.hull == nullptr && !instance.isTranslucent();
}

/// Of an instance's halo; 0: it has none.
inline float haloWidth(const Instance& instance)
{
  return hasCues(instance) ? instance.style.cues.halo.width : 0.0f;
}

/// How many pixels away from where a surface ends its halo may be.
inline int haloReach(float width)
{
  return static_cast<int>(std::ceil(width)) + 1;
}

/// How many pixels outside of a frame its halos come from.
inline int haloApron(const Scene& scene)
{
  // Whether a surface ends in a pixel is told by its neighbours and theirs.
  constexpr int kNeighbours = 2;
  int apron = 0;
  for (const Instance& instance : scene.instances)
    if (const float width = haloWidth(instance); width > 0.0f)
      apron = std::max(apron, haloReach(width) + kNeighbours);
  return apron;
}

/// How far one layer may lie off another's plane.
inline float stepTolerance(const Style& style, const ViewPoint& point)
{
  return style.imageOutline.depthTolerance * point.pixel + point.rounding;
}

/// How two layers lie to each other: how far each is before the other's plane.
struct PlaneDistances {
  float ofSecond, ofFirst;

  struct Patch {
    Vec3f position, plane;
  };

  PlaneDistances(const SurfacePatch& first, const SurfacePatch& second)
      : PlaneDistances(Patch{first.point.position, first.plane},
                       Patch{second.point.position, second.plane})
  {
  }
  PlaneDistances(const Patch& first, const Patch& second)
  {
    const Vec3f way = second.position - first.position;
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
  /// Of two samples of a pixel: ImageOutline::kGroove.
  bool areGroove(float tolerance) const
  {
    const float most = ImageOutline::kGroove * tolerance;
    return ofSecond > 0.0f && ofSecond <= most && ofFirst > 0.0f && ofFirst <= most;
  }
};

}  // namespace limn
