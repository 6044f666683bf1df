// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"
#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"
#include "Rendering/Shading/TranslucentFragments.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// What a line looks like at a pixel.
struct LineColor {
  Vec3f color;  ///< 0 to 1
  Vec3f radiance;
};

/// The translucent surfaces of one tile, among which its lines are seen.
class TilePanes {
 public:
  /// Those of a pixel: one list for all of its samples, or one for each.
  struct Pixel {
    std::uint32_t pixel;  ///< row * kTileSide + column, within the tile
    std::uint32_t firstList, lists;
  };
  /// Requires: fragments that are shaded and have their depths.
  void add(const TileClusters& clusters, int samples, const TranslucentFragments& fragments);
  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// A line of an instance behind the surfaces of other instances that are not farther, each of
  /// which leaves 1 - alpha of what is below; mean over the samples.
  LineColor before(const Pixel& pixel, Vec3f color, float depth, std::uint32_t instance) const;

 private:
  struct Pane {
    float depth;
    std::uint32_t instance;  ///< place in Scene::instances
    Vec4f color;             ///< TranslucentFragments::colors()
  };
  std::vector<Pixel> pixels_;
  std::vector<std::uint32_t> listEnd_;  ///< in panes_
  std::vector<Pane> panes_;             ///< of each list the farthest first
};

/// Those of a frame, tile by tile.
class Panes {
 public:
  /// Whether a translucent surface may lie before a line of another instance. With
  /// Background::kKeepApart never: the host lays it over what is behind.
  static bool areNeeded(const Scene& scene, const FrameView& frame);

  explicit Panes(std::size_t tiles) : tiles_(tiles) {}
  TilePanes& tile(std::size_t number) { return tiles_[number]; }
  const TilePanes& tile(std::size_t number) const { return tiles_[number]; }

 private:
  std::vector<TilePanes> tiles_;
};

}  // namespace limn
