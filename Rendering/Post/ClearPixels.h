// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"

namespace limn {

/// Gives a rectangle of the frame the values of `frame.clear`, whatever its extent.
void clearPixels(const FrameView& frame, const TileRectangle& pixels);

}  // namespace limn
