// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"

#include <cstdint>

namespace limn {

/// A tile of a frame whose old picture is of no account, drawn in memory that stays in a core's own
/// caches. The frame's memory is then only written, once, and need not be read to be written.
class TileFrame {
 public:
  /// The planes that `frame` has, cleared by FrameView::clear; pixels() of it are the tile. Valid
  /// until the next call. The depth lies in `depth`, room for kTilePixels, unless that is null.
  const FrameView& begin(const FrameView& frame, const TileRectangle& place, float* depth);
  TileRectangle pixels() const { return {0, 0, place_.x1 - place_.x0, place_.y1 - place_.y0}; }
  /// Copies the tile to its place in the frame.
  void write() const;
  /// The same of a tile in which nothing is drawn, from rows that are cleared once.
  static void clear(const FrameView& frame, const TileRectangle& place);

 private:
  FrameView frame_, tile_;
  TileRectangle place_;
  Array<Rgba8> color_;
  Array<float> depth_;
  Array<std::uint8_t> coverage_;
  Array<std::uint32_t> instance_, cell_;
  Array<float> red_, green_, blue_;
  Array<float> normalX_, normalY_, normalZ_;
};

/// Rows of bytes, to memory that nobody reads soon: past the caches where that can be done.
struct StreamedRows {
  const void* from;
  void* to;
  std::ptrdiff_t fromStride, toStride;  ///< bytes
  std::size_t bytes;                    ///< of a row
  int count;
};
void streamRows(const StreamedRows& rows);

}  // namespace limn
