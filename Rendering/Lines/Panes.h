// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"
#include "Rendering/Binning/TileGrid.h"
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

/// Blocks of a tile, bit by bit, row by row from below.
using TileBlocks = std::uint16_t;
inline constexpr int kPaneBlockSide = 16;  ///< pixels
static_assert(kTileSide == 4 * kPaneBlockSide, "a bit of TileBlocks for each block");

/// The translucent surfaces of one tile, among which its lines are seen; those in blocks that no
/// line reaches are not kept.
class TilePanes {
 public:
  /// Those of a pixel: one list for all of its samples, or one for each.
  struct Pixel {
    std::uint32_t pixel;  ///< row * kTileSide + column, within the tile
    std::uint32_t firstList, lists;
  };
  void reach(TileBlocks blocks) { reached_ = blocks; }
  bool isReached() const { return reached_ != 0; }
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
  bool isReached(std::uint32_t pixel) const
  {
    constexpr std::uint32_t kSide = kTileSide, kBlock = kPaneBlockSide;
    const std::uint32_t row = pixel / kSide / kBlock, column = pixel % kSide / kBlock;
    return (reached_ >> (row * (kSide / kBlock) + column) & 1u) != 0;
  }

  TileBlocks reached_ = 0;
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

  Panes(const Scene& scene, const TileGrid& grid, int threads);
  TilePanes& tile(std::size_t number) { return tiles_[number]; }
  const TilePanes& tile(std::size_t number) const { return tiles_[number]; }

 private:
  std::vector<TilePanes> tiles_;
};

}  // namespace limn
