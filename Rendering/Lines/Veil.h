// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Lines/Panes.h"
#include "Rendering/Lines/SurfaceLayers.h"
#include "Rendering/Scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// A pixel with translucent surfaces, which lie over what outlines from the picture and depth cues
/// make of opaque ones: these are drawn on the picture without them.
struct VeiledPixel {
  std::uint16_t x, y;
  Rgba8 below, seen;  ///< without and with translucent surfaces
  float rest;         ///< the share of `below` in `seen`, mean over the samples
};
struct VeiledRadiance {
  Vec3f below, seen;
};
/// What halos over the translucent surfaces of a pixel change in what is seen.
struct VeiledChange {
  std::size_t pixel;  ///< place in VeiledTile::pixels
  LineColor change;
};
struct VeiledTile {
  std::vector<VeiledPixel> pixels;
  std::vector<VeiledRadiance> radiance;  ///< one a pixel if the frame has radiance
  std::vector<VeiledChange> changes;     ///< in the order of pixels
};

/// The translucent surfaces over a frame, tile by tile.
class Veil {
 public:
  /// Whether outlines or cues change what translucent surfaces lie before. With
  /// Background::kKeepApart never: nobody knows what lies below.
  static bool isNeeded(const Scene& scene, const FrameView& frame);

  explicit Veil(std::size_t tiles) : tiles_(tiles) {}
  VeiledTile& tile(std::size_t number) { return tiles_[number]; }
  /// Adds what the halos of `layers` change in panes, which get these colours. Requires: panes that
  /// are all among the tiles' pixels.
  void addHalos(const Scene& scene, const SurfaceLayers& layers, const TileGrid& grid, Panes& panes,
                int threads);
  /// Where the frame's pixel became N from `below`, it becomes seen + change + rest (N - below).
  void lay(const FrameView& frame, int threads) const;

 private:
  static void lay(const VeiledTile& all, const FrameView& frame);

  std::vector<VeiledTile> tiles_;
};

}  // namespace limn
