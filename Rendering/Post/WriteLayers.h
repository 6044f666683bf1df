// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceLayers.h"
#include "Rendering/Shading/Fragments.h"

namespace limn {

/// Where the layers of a frame go.
struct LayerTarget {
  Background background;
  SurfaceLayers& layers;
  bool isWhole;  ///< pixels far from all that were touched are set to nobody's, too
};

/// Pixels of a tile that hold their means already, all of them of opaque surfaces.
struct ResolvedTile {
  const FrameView& frame;
  TileRectangle pixels;
};

/// Leaves pixels to nobody, until writeLayers() says otherwise.
void clearLayers(const TileRectangle& pixels, SurfaceLayers& layers);

/// Writes what the pixels of a tile show first. `pixels` are the tile's in the viewport.
/// `resolved`, or null, saves means that are known.
/// Requires: as resolveTile(), and TileColors::hasNormals.
void writeLayers(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const TileColors& colors, const LayerTarget& target, const ResolvedTile* resolved);

}  // namespace limn
