// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Shading/Fragments.h"

namespace limn {

/// Writes the radiance of a tile to the frame, as RadianceView says.
/// Requires: as resolveTile(), and TileColors::hasRadiance.
void resolveRadiance(const TileClusters& clusters, const TileRectangle& pixels,
                     const FragmentList& fragments, const TileColors& colors,
                     const FrameView& frame);

}  // namespace limn
