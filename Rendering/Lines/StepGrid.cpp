// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/StepGrid.h"

#include <algorithm>
#include <utility>

namespace limn {

void StepGrid::begin(const SurfaceLayers& layers)
{
  layers_ = &layers;
  width_ = layers.stride();
  parted_.resize(layers.indexOf(-layers.apron, layers.endY()));
}

void StepGrid::clearRow(int y, int x0, int x1)
{
  std::fill(parted_.data() + layers_->indexOf(x0, y), parted_.data() + layers_->indexOf(x1, y),
            std::uint8_t{0});
}

void StepGrid::unite(std::size_t index)
{
  const auto remove = [&](std::size_t from, Side side) {
    parted_[from] = static_cast<std::uint8_t>(parted_[from] & ~side);
  };
  parted_[index] = kUnited;
  remove(index - 1, kRight);
  remove(index + 1, kLeft);
  remove(index - width_, kAbove);
  remove(index + width_, kBelow);
}

bool StepGrid::areJoined(PixelPlace from, PixelPlace to) const
{
  struct Axis {
    int length;
    std::ptrdiff_t next;  ///< to the next pixel
    Side side;
  };
  const auto width = static_cast<std::ptrdiff_t>(width_);
  Axis longer = to.x < from.x ? Axis{from.x - to.x, -1, kLeft} : Axis{to.x - from.x, 1, kRight};
  Axis shorter =
      to.y < from.y ? Axis{from.y - to.y, -width, kBelow} : Axis{to.y - from.y, width, kAbove};
  if (longer.length < shorter.length) std::swap(longer, shorter);
  const std::uint8_t* at = parted_.data() + layers_->indexOf(from.x, from.y);
  // Of the shorter way as much as of the longer one, rounded; in halves of a pixel.
  const int pixel = 2 * longer.length;
  int rest = longer.length;
  for (int i = 0; i < longer.length; ++i) {
    rest += 2 * shorter.length;
    if (rest < pixel) {
      if ((*at & longer.side) != 0) return false;
    } else {
      rest -= pixel;
      const bool isFree = ((*at & longer.side) == 0 && (at[longer.next] & shorter.side) == 0) ||
                          ((*at & shorter.side) == 0 && (at[shorter.next] & longer.side) == 0);
      if (!isFree) return false;
      at += shorter.next;
    }
    at += longer.next;
  }
  return true;
}

}  // namespace limn
