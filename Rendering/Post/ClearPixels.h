// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"

namespace limn {

/// Gives a rectangle of the frame the values of `frame.clear`, whatever its extent.
void clearPixels(const FrameView& frame, const TileRectangle& pixels);

/// Calls visit(plane, what its pixels are cleared to) for the planes of a frame, those that it does
/// not have included: these are null.
template <class Visit>
void forEachClearedPlane(const FrameView& frame, const Visit& visit)
{
  visit(frame.color, frame.clear.color);
  const auto intensity = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  visit(frame.radiance.r, intensity(frame.clear.color.r));
  visit(frame.radiance.g, intensity(frame.clear.color.g));
  visit(frame.radiance.b, intensity(frame.clear.color.b));
  visit(frame.depth, frame.clear.depth);
  visit(frame.coverage, std::uint8_t{0});
  visit(frame.instance, kNobody);
  visit(frame.cell, kNobody);
  visit(frame.normal.x, 0.0f);
  visit(frame.normal.y, 0.0f);
  visit(frame.normal.z, 0.0f);
}

}  // namespace limn
