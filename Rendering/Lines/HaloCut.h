// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceLayers.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace limn {

/// A pixel in which a surface with a halo ends.
struct HaloBorder {
  /// As far as anything: the halo has all of its width, however deep that is.
  static constexpr float kBehindAll = std::numeric_limits<float>::max();

  float distance;     ///< along the gaze
  float width, full;  ///< of the halo, in pixels: that from the difference of distances `full` on
  float covered;      ///< share of the pixel

  HaloBorder(const Scene& scene, const SurfaceLayers& layers, std::size_t index);

  /// How wide the halo is over what lies so far; 0: none.
  float widthOver(float other) const;
  /// The share of a pixel that a halo so wide has, (dx, dy) pixels away; below 0: none.
  float shareOf(float haloWidth, float dx, float dy) const;
  /// The same, and above 1 by how far the halo reaches beyond the pixel.
  float reachOver(float haloWidth, float dx, float dy) const;
  /// The share that a halo so wide has of what the surface leaves of its own pixel.
  float shareOfRest(float haloWidth) const;
};

/// What a halo has of something behind it.
struct HaloShare {
  float share;  ///< 0: nothing, and no colour
  Vec3f color;
};

/// What halos leave of strokes and of translucent surfaces. A stroke of another instance is cut as
/// a surface would be that lies as far; one of the same instance by the whole width where it lies
/// behind by that of the whole width and a horizon: the contour of a rounded surface lies far
/// behind the last pixel that shows it, on a circle by twice the slope there times the pixels in
/// between.
class HaloCut {
 public:
  /// Requires: SurfaceLayers::halo, haloOwner and ends; for translucent surfaces haloBorder.
  HaloCut(const Scene& scene, const SurfaceLayers& layers) : scene_(scene), layers_(layers) {}

  /// The share of a stroke's pixel that is cut. `depth` is the window's; above 1 where hidden.
  float shareAt(int x, int y, float depth, std::uint32_t instance) const;

  /// Whether anything of a pixel may be in a halo.
  bool isAny(int x, int y) const
  {
    const std::size_t index = layers_.indexOf(x, y);
    return layers_.halo[index] > 0.0f || layers_.ends[index] != 0;
  }
  /// Of a translucent surface: as shareAt(), and where the surface with the halo ends in the pixel
  /// what that leaves of it, too.
  HaloShare overPane(int x, int y, float depth, std::uint32_t instance) const;

 private:
  float shareBy(std::size_t owner, int x, int y, float depth, std::uint32_t instance) const;
  float distanceAt(int x, int y, float depth) const;
  float riseAt(std::size_t owner) const;

  const Scene& scene_;
  const SurfaceLayers& layers_;
};

}  // namespace limn
