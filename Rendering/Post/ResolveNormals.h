// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Shading/Fragments.h"

namespace limn {

/// Writes the normals of a tile to the frame, as NormalView says.
/// Requires: as resolveTile(), and TileColors::hasNormals.
void resolveNormals(const TileClusters& clusters, const VisibilityTile& tile,
                    const TileRectangle& pixels, const FragmentList& fragments,
                    const TileColors& colors, const FrameView& frame);

}  // namespace limn
