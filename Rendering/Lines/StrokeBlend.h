// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"
#include "Rendering/Lines/HaloCut.h"
#include "Rendering/Lines/Panes.h"
#include "Rendering/Lines/StrokePieces.h"

#include <cstddef>
#include <vector>

namespace limn {

/// What the lines of one tile lay over samples that show nothing, for FrameView::linePixels.
class OpenSamples {
 public:
  void begin(const TileRectangle& tile);
  /// A share of the pixel (x, y) of the frame in the color `line`, of which 255 is full.
  void add(int x, int y, Vec4f line, float share, float depth);
  /// Appends the pixels that still have samples that show nothing.
  void collect(const FrameView& frame, int samples, std::vector<LinePixel>& pixels) const;

 private:
  struct Pixel {
    Vec4f color;  ///< multiplied by alpha; 255 is full
    float depth;
  };
  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>((y - tile_.y0) * kTileSide + (x - tile_.x0));
  }

  TileRectangle tile_ = {0, 0, 0, 0};
  TileRectangle used_ = {0, 0, 0, 0};  ///< pixels outside of which nothing was added
  std::vector<Pixel> pixels_;          ///< those outside of used_ are clear
};

/// Lays one group over the pixels of a frame.
class StrokeBlend {
 public:
  /// `cut` and `open` may be null; with `open`, what the samples that show nothing get goes there.
  StrokeBlend(const StrokeGroup& group, const FrameView& frame, const HaloCut* cut,
              OpenSamples* open, int samples);

  /// In the group's color.
  void blend(int x, int y, float coverage, float depth) const
  {
    blend(x, y, coverage, depth, own_);
  }
  /// In what translucent surfaces make of it.
  void blend(int x, int y, float coverage, float depth, const LineColor& color) const
  {
    blend(x, y, coverage, depth, inkOf(color));
  }

 private:
  enum class Shown { kNothing, kMore, kFirst };
  struct Ink {
    Vec4f bytes;  ///< of which 255 is full
    Vec3f radiance;
  };
  static Ink inkOf(const LineColor& color);

  void blend(int x, int y, float coverage, float depth, const Ink& ink) const;
  void mix(std::ptrdiff_t index, float a, const Ink& ink) const;
  /// Whether the pixel shows something, and whether only now.
  Shown blendSamples(std::ptrdiff_t index, float a) const;
  Shown coverSamples(std::ptrdiff_t index, float a, std::uint32_t more) const;

  const FrameView& frame_;
  const HaloCut* cut_;
  OpenSamples* open_;
  std::uint32_t instance_;
  float opacity_;
  Ink own_;
  std::uint32_t samples_;
  bool keepsApart_;
};

/// Whether what lines lay over samples that show nothing is to be kept.
inline bool wantsLinePixels(const FrameView& frame)
{
  return frame.linePixels != nullptr && frame.coverage != nullptr &&
         frame.background == Background::kKeepApart;
}

}  // namespace limn
