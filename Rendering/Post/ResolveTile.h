// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Shading/Fragments.h"

namespace limn {

/// Writes a tile to the frame: for each pixel that shows an instance the mean of its samples'
/// colours, the nearest sample's depth and names, and the coverage.
/// Requires: `fragments` from collectFragments() of the tile, `colors` theirs by FragmentShader.
void resolveTile(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const TileColors& colors, const FrameView& frame);

}  // namespace limn
