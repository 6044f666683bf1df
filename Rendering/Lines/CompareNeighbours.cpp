// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CompareNeighbours.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Lines/CompareNeighbours.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Lines/CompareNeighbours-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(placeRowKernel);
HWY_EXPORT(comparePairsKernel);
HWY_EXPORT(compareIdsKernel);

NeighbourRows::NeighbourRows(const SurfaceLayers& layers, const NeighbourBounds& bounds,
                             int samples, const PixelRectangle& touched)
    : layers_(layers),
      bounds_(bounds),
      samples_(samples),
      touched_(touched),
      count_(static_cast<std::size_t>(touched.x1 - touched.x0))
{
  // One before the first pixel, and a vector behind the last.
  const std::size_t room = count_ + 1 + SurfaceLayers::kSpare;
  for (PlacedRow& row : rows_)
    row.resize(room);
  for (std::vector<std::uint8_t>* bytes : {&pairs_, &below_, &asks_, &marks_})
    bytes->assign(room, 0);
}

void NeighbourRows::placeRow(int y)
{
  HWY_DYNAMIC_DISPATCH(placeRowKernel)
  ({layers_, bounds_, samples_, touched_.x0, y, layers_.indexOf(touched_.x0, y), count_},
   rows_[y & 1]);
  placed_ = y;
}

/// Between a row's pixels, and from it to the row above.
void NeighbourRows::comparePairs(int y)
{
  if (placed_ != y) placeRow(y);
  if (y + 1 < layers_.height) placeRow(y + 1);
  const RowJob job = {layers_, bounds_, samples_, touched_.x0, y, layers_.indexOf(touched_.x0, y),
                      count_};
  HWY_DYNAMIC_DISPATCH(comparePairsKernel)
  (job, rows_[y & 1], rows_[(y + 1) & 1], pairs_.data() + 1, asks_.data());
  if (layers_.hasIds) HWY_DYNAMIC_DISPATCH(compareIdsKernel)(job, pairs_.data() + 1);
  // Next to the frame's border, and to what was not touched.
  pairs_[0] = kStepRight;
  pairs_[count_] |= kStepRight;
  compared_ = y;
}

const std::uint8_t* NeighbourRows::marksOf(int y)
{
  if (compared_ != y - 1 && y > touched_.y0) comparePairs(y - 1);
  if (y == touched_.y0)
    std::fill(below_.begin(), below_.end(), std::uint8_t{kStepAbove});
  else
    std::swap(pairs_, below_);
  comparePairs(y);
  const std::uint8_t *const left = pairs_.data(), *const pairs = left + 1,
                            *const below = below_.data() + 1, *const asks = asks_.data();
  std::uint8_t* const marks = marks_.data();
  const std::size_t count = count_;
  for (std::size_t i = 0; i < count; ++i) {
    const auto steps = static_cast<std::uint8_t>(pairs[i] | left[i] | pairs[i] / kStepAbove |
                                                 below[i] / kStepAbove);
    constexpr unsigned kCreases = kMayCreaseRight | kMayCreaseAbove;
    marks[i] =
        static_cast<std::uint8_t>(((steps & kMayHaveEdge) | (pairs[i] & kCreases)) & asks[i]);
  }
  return marks_.data();
}

}  // namespace limn
#endif  // HWY_ONCE
