// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceLayers.h"

#include <cstddef>
#include <cstdint>

namespace limn {

/// Where steps by OutlineDetector::kPlane part pixels of one instance that are next to each other,
/// and other instances begin;
/// and which pixels farther apart show one surface: those between which a straight way crosses
/// neither.
class StepGrid {
 public:
  enum Side : std::uint8_t { kRight = 1, kLeft = 2, kAbove = 4, kBelow = 8 };

  /// For a frame's layers. Rows are to be cleared before they are written.
  void begin(const SurfaceLayers& layers);
  void clearRow(int y, int x0, int x1);

  /// Of a pixel: a sum of Side.
  void part(std::size_t index, unsigned sides)
  {
    parted_[index] = static_cast<std::uint8_t>(sides);
  }
  /// Takes away all that parts a pixel. Requires: it is not at the end of the layers.
  void unite(std::size_t index);
  bool isUnited(std::size_t index) const { return parted_[index] >= kUnited; }

  /// By a way from pixel to pixel, over sides or corners; at a corner one of its two other pixels
  /// has to be joined with both. Requires: `from` shows an instance that has lines.
  bool areJoined(PixelPlace from, PixelPlace to) const;

 private:
  static constexpr std::uint8_t kUnited = 16;

  const SurfaceLayers* layers_ = nullptr;
  std::size_t width_ = 0;
  Array<std::uint8_t> parted_;
};

}  // namespace limn
