// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ImageOutline.h"

namespace limn {

/// One channel of a pixel, and of those of its samples that change.
struct ChannelChange {
  std::uint8_t pixel, from, to;
};

/// The channel of the pixel, a mean of `shared` samples, after `samples` of them have changed.
std::uint8_t changed(ChannelChange c, double samples, int shared, Resolve resolve);

/// Gives a share of a pixel, which is its layer's, the colour of the layer's line: as if that share
/// of the pixel's samples had it. Requires: 0 < share <= count of the layer / samples.
void paintLine(const OutlinePass& pass, int x, int y, float share);

}  // namespace limn
