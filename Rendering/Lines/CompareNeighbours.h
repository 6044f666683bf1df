// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Lines/SurfaceLayers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

enum PixelMark : std::uint8_t {
  kMayHaveEdge = 1,
  kMayCreaseRight = 2,  ///< between it and the pixel to its right
  kMayCreaseAbove = 4,
};

/// What the instances ask of their pixels, one element each.
struct NeighbourBounds {
  static constexpr std::int32_t kAlways = 16;  ///< an edge may be anywhere

  std::vector<std::int32_t> asks;  ///< PixelMark bits and kAlways; 0: no lines are near it
  std::vector<float> tolerance;    ///< ImageOutline::depthTolerance
  std::vector<float> crease;       ///< of 1 - n.n'
};

/// What NeighbourRows knows of a frame before it looks at pixels.
struct PairTest {
  PairTest(const SurfaceLayers& layers, const NeighbourBounds& bounds, int samples);

  /// With w from ScreenToView: pixels next to each other of one instance are no step if the
  /// difference of their depths times perDepth is at most gentle |w|, for either w.
  float perDepth = 0, gentle = -1;
  float sharpest;  ///< smallest of NeighbourBounds::crease
  bool asksAlike;  ///< all of NeighbourBounds::asks are the same
  std::int32_t offsetX[kMaxSamples] = {}, offsetY[kMaxSamples] = {};  ///< SurfaceLayers::offsets

 private:
  void findGentle(const SurfaceLayers& layers, float tolerance, int samples);
};

/// For the kernels: some pixels of a row.
struct RowJob {
  const SurfaceLayers& layers;
  const NeighbourBounds& bounds;
  const PairTest& test;
  int samples;
  int x0, y;
  std::size_t first;  ///< index of the first pixel
  std::size_t count;
};
/// Bits of two pixels next to each other, beside kMayCreaseRight and kMayCreaseAbove.
inline constexpr std::int32_t kStepRight = 1, kStepAbove = 8;

/// Marks the pixels that lines may come from. Most of a picture is in the midst of a surface, where
/// a few vectors of arithmetic tell that there are none.
class NeighbourRows {
 public:
  /// Of the pixels [x0, x1) of rows from y0 on; those outside show nothing. `samples` a pixel.
  NeighbourRows(const SurfaceLayers& layers, const NeighbourBounds& bounds, int samples,
                const PixelRectangle& touched);

  /// PixelMark bits of a row's pixels from x0 on: all that are due, and some that are not. 0 for
  /// all up to the next multiple of eight. Row after row is cheaper than rows here and there.
  const std::uint8_t* marksOf(int y);

 private:
  void comparePairs(int y);

  const SurfaceLayers& layers_;
  const NeighbourBounds& bounds_;
  int samples_;
  PixelRectangle touched_;
  std::size_t count_;
  PairTest test_;
  int compared_;  ///< last row; at first none that is touched, nor the one below these
  std::vector<std::uint8_t> pairs_, below_, asks_, marks_;
};

}  // namespace limn
