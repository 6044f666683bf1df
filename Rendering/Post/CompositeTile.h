// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Shading/Fragments.h"
#include "Rendering/Lines/Veil.h"
#include "Rendering/Shading/TranslucentFragments.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Lays translucent fragments over a tile, as Instance says, while its opaque surfaces and the
/// frame's old picture are still at hand, and writes the pixels when these are resolved.
class TileCompositor {
 public:
  /// Borrows all of them until write() or veil(), of which `isVeiled` tells.
  void begin(const TileClusters& clusters, const TileRectangle& pixels,
             const FragmentList& fragments, const TileColors& colors, const FrameView& frame,
             bool isVeiled);
  /// Each pixel once. Requires: begin(), and fragments that are shaded.
  void add(const TranslucentFragments& fragments);
  /// Requires: resolveTile().
  void write() const;
  /// Leaves the picture without translucent surfaces and lists what write() would write. `pixels`
  /// are the tile in the frame that is veiled. Requires: resolveTile().
  void veil(const TileRectangle& pixels, VeiledTile& veiled) const;

 private:
  /// A sample before it becomes bytes.
  struct Sample {
    Vec4f color;  ///< 0 to 1
    Vec3f radiance;
    bool isShown;  ///< takes part in the pixel's mean
  };
  struct Pixel {
    std::uint32_t pixel;
    Rgba8 color;
    Vec3f radiance;
    std::uint16_t coverage;
    float rest = 0;  ///< of what is below, mean over the samples; only if veiled
  };
  /// Returns whether all samples are the same.
  bool findOpaque(std::uint32_t pixel, std::ptrdiff_t index);
  void set(std::uint32_t sample, Rgba8 color, Vec3f radiance);
  Vec3f radianceOf(const RadianceArrays& from, std::size_t i) const;
  Rgba8 opaqueColor(std::uint32_t pixel, std::ptrdiff_t index) const;
  void addSinglePixel(const TranslucentFragments& fragments, TranslucentFragments::Pixel touched);
  void addPixel(const TranslucentFragments& fragments, TranslucentFragments::Pixel touched);
  float restOf(const TranslucentFragments& fragments, const std::uint32_t* layers) const;
  void cover(const TranslucentFragments& fragments, const std::uint32_t* layers,
             std::uint32_t count, Sample& sample) const;
  Pixel meanOf(std::uint32_t pixel) const;
  Pixel meanOfEqual(std::uint32_t pixel) const;

  const TileClusters* clusters_;
  TileRectangle tile_;
  const FragmentList* fragments_;
  const TileColors* colors_;
  const FrameView* frame_;
  std::uint32_t samples_;
  bool hasRadiance_;
  bool isVeiled_;
  std::uint32_t firstFragment_[kTilePixels];  ///< opaque, by pixel; or one of two marks
  Sample sample_[kMaxSamples];
  std::uint32_t coverage_;
  std::vector<Pixel> pixels_;
};

}  // namespace limn
