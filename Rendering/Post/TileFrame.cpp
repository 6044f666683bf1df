// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/TileFrame.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/TileFrame.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/StreamRows-inl.h"

#if HWY_ONCE
#include "Rendering/Post/ClearPixels.h"

#include <algorithm>
#include <type_traits>

namespace limn {

HWY_EXPORT(streamRowsKernel);

void streamRows(const StreamedRows& rows)
{
  HWY_DYNAMIC_DISPATCH(streamRowsKernel)(rows);
}

namespace {

/// A plane of the tile if the frame has it.
template <class T>
T* planeFor(const T* ofFrame, Array<T>& memory)
{
  if (ofFrame == nullptr) return nullptr;
  memory.resize(kTilePixels);
  return memory.data();
}

}  // namespace

const FrameView& TileFrame::begin(const FrameView& frame, const TileRectangle& place, float* depth)
{
  frame_ = frame;
  place_ = place;
  tile_ = frame;
  tile_.width = tile_.height = kTileSide;
  tile_.rowStride = kTileSide;
  tile_.color = planeFor(frame.color, color_);
  tile_.depth = depth != nullptr ? depth : planeFor(frame.depth, depth_);
  tile_.coverage = planeFor(frame.coverage, coverage_);
  tile_.instance = planeFor(frame.instance, instance_);
  tile_.cell = planeFor(frame.cell, cell_);
  tile_.radiance = {planeFor(frame.radiance.r, red_), planeFor(frame.radiance.g, green_),
                    planeFor(frame.radiance.b, blue_)};
  tile_.normal = {planeFor(frame.normal.x, normalX_), planeFor(frame.normal.y, normalY_),
                  planeFor(frame.normal.z, normalZ_)};
  clearPixels(tile_, pixels());
  return tile_;
}

void TileFrame::write() const
{
  const auto copy = [&](const auto* plane, auto* ofFrame) {
    if (ofFrame == nullptr) return;
    constexpr auto kSize = static_cast<std::ptrdiff_t>(sizeof *plane);
    const TileRectangle size = pixels();
    streamRows({plane, ofFrame + place_.y0 * frame_.rowStride + place_.x0, kTileSide * kSize,
                frame_.rowStride * kSize, static_cast<std::size_t>(size.x1 * kSize), size.y1});
  };
  copy(tile_.color, frame_.color);
  copy(tile_.depth, frame_.depth);
  copy(tile_.coverage, frame_.coverage);
  copy(tile_.instance, frame_.instance);
  copy(tile_.cell, frame_.cell);
  copy(tile_.radiance.r, frame_.radiance.r);
  copy(tile_.radiance.g, frame_.radiance.g);
  copy(tile_.radiance.b, frame_.radiance.b);
  copy(tile_.normal.x, frame_.normal.x);
  copy(tile_.normal.y, frame_.normal.y);
  copy(tile_.normal.z, frame_.normal.z);
}

void TileFrame::clear(const FrameView& frame, const TileRectangle& place)
{
  const auto clearPlane = [&](auto* ofFrame, auto value) {
    if (ofFrame == nullptr) return;
    using Element = std::remove_pointer_t<decltype(ofFrame)>;
    alignas(64) Element row[kTileSide];
    std::fill_n(row, kTileSide, value);
    constexpr auto kSize = static_cast<std::ptrdiff_t>(sizeof(Element));
    streamRows({row, ofFrame + place.y0 * frame.rowStride + place.x0, 0, frame.rowStride * kSize,
                static_cast<std::size_t>((place.x1 - place.x0) * kSize), place.y1 - place.y0});
  };
  forEachClearedPlane(frame, clearPlane);
}

}  // namespace limn
#endif  // HWY_ONCE
