// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/FullIntensity.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Binning/TileBins.h"
#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"
#include "Rendering/Lines/HaloCut.h"
#include "Rendering/Shading/TranslucentFragments.h"
#include "Rendering/Vertex/PlacedScene.h"

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

/// Of a tile what may need its panes.
struct PaneReach {
  TileBlocks ofLines = 0, ofHalos = 0;
  float nearestHalo = 0;  ///< a depth that nothing with a halo is before
};

/// The translucent surfaces of one tile, among which its lines are seen, and which halos cut; those
/// that neither lines nor halos reach are not kept, nor those that only lie before halos.
class TilePanes {
 public:
  /// Those of a pixel: one list for all of its samples, or one for each.
  struct Pixel {
    std::uint32_t pixel;  ///< row * kTileSide + column, within the tile
    std::uint32_t firstList, lists;
  };
  void reach(const PaneReach& reach) { reach_ = reach; }
  bool isReached() const { return (reach_.ofLines | reach_.ofHalos) != 0; }
  /// Requires: fragments that are shaded and have their depths.
  void add(const TileClusters& clusters, int samples, const TranslucentFragments& fragments);
  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// A line of an instance behind the surfaces of other instances that are not farther, each of
  /// which leaves 1 - alpha of what is below; mean over the samples.
  LineColor before(const Pixel& pixel, Vec3f color, float depth, std::uint32_t instance) const;
  /// Gives the surfaces in a pixel the colours of the halos over them; by shareOver(depth,
  /// instance), which returns a HaloShare. Returns by how much what is seen of them changes, mean
  /// over the samples.
  template <class ShareOver>
  LineColor colorByHalos(const Pixel& pixel, const ShareOver& shareOver);

 private:
  struct Pane {
    float depth;
    std::uint32_t instance;  ///< place in Scene::instances
    Vec4f color;             ///< TranslucentFragments::colors()
  };
  std::size_t firstPane(const Pixel& pixel) const
  {
    return pixel.firstList == 0 ? 0 : listEnd_[pixel.firstList - 1];
  }
  LineColor meanOf(const Pixel& pixel, LineColor sum) const
  {
    const auto count = static_cast<float>(pixel.lists);
    const Vec3f c = sum.color, r = sum.radiance;
    return {{c.x / count, c.y / count, c.z / count}, {r.x / count, r.y / count, r.z / count}};
  }
  static bool isIn(TileBlocks blocks, std::uint32_t pixel)
  {
    constexpr std::uint32_t kSide = kTileSide, kBlock = kPaneBlockSide;
    const std::uint32_t row = pixel / kSide / kBlock, column = pixel % kSide / kBlock;
    return (blocks >> (row * (kSide / kBlock) + column) & 1u) != 0;
  }
  bool isNeeded(const Pixel& pixel) const;
  void dropLast();

  PaneReach reach_;
  std::vector<Pixel> pixels_;
  std::vector<std::uint32_t> listEnd_;  ///< in panes_
  std::vector<Pane> panes_;             ///< of each list the farthest first
};

/// Those of a frame, tile by tile.
class Panes {
 public:
  /// Whether a translucent surface may lie before a line of another instance. With
  /// Background::kKeepApart never: the host lays it over what is behind.
  static bool areBeforeLines(const Scene& scene, const FrameView& frame);
  /// Likewise of one behind the halo of an instance.
  static bool areBehindHalos(const Scene& scene, const FrameView& frame);

  Panes(const PlacedScene& scene, const TileBins& bins, int threads);
  TilePanes& tile(std::size_t number) { return tiles_[number]; }
  const TilePanes& tile(std::size_t number) const { return tiles_[number]; }

 private:
  std::vector<TilePanes> tiles_;
};

template <class ShareOver>
LineColor TilePanes::colorByHalos(const Pixel& pixel, const ShareOver& shareOver)
{
  LineColor sum = {{0, 0, 0}, {0, 0, 0}};
  std::size_t next = firstPane(pixel);
  for (std::uint32_t list = 0; list < pixel.lists; ++list) {
    LineColor change = {{0, 0, 0}, {0, 0, 0}};
    for (; next < listEnd_[pixel.firstList + list]; ++next) {
      Pane& pane = panes_[next];
      const HaloShare halo = shareOver(pane.depth, pane.instance);
      const Vec3f old = {pane.color.x, pane.color.y, pane.color.z};
      const Vec3f now = halo.share > 0.0f ? old + (halo.color - old) * halo.share : old;
      const float a = pane.color.w, rest = 1.0f - a;
      change = {(full(now) - full(old)) * a + change.color * rest,
                (now - old) * a + change.radiance * rest};
      pane.color = {now.x, now.y, now.z, a};
    }
    sum = {sum.color + change.color, sum.radiance + change.radiance};
  }
  return meanOf(pixel, sum);
}

}  // namespace limn
