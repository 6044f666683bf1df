// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Raster/TranslucentTile.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Translucent triangles in the pixels of some rows of a tile, each a fragment that is shaded once
/// a pixel, and in which order the samples show them.
class TranslucentFragments {
 public:
  /// A pixel with fragments.
  struct Pixel {
    std::uint32_t pixel;  ///< row * kTileSide + column, within the tile
    std::size_t first;    ///< in layers()
  };
  /// Fragments [first, end) of one triangle, enough to be shaded by what the triangle is.
  struct Run {
    static constexpr std::uint32_t kShortest = 16;
    std::uint32_t first, end;
  };
  /// The fragments of no run, as arrays.
  struct Rest {
    std::size_t count = 0;
    Array<std::uint32_t> fragment, owner, pixel;
    Array<std::uint16_t> coverage;
  };

  enum class Depths { kForgotten, kKept };
  /// Depths that are kept depths() tells.
  void collect(const TileClusters& clusters, int samples, const TranslucentTile& tile,
               Depths depths);

  // By fragment:
  const std::uint32_t* owners() const { return owner_.data(); }
  const std::uint32_t* pixels() const { return pixel_.data(); }
  const std::uint16_t* coverage() const { return coverage_.data(); }
  /// Red, green and blue as RadianceView holds them, and alpha, 0 to 1.
  Vec4f* colors() { return color_.data(); }
  const Vec4f* colors() const { return color_.data(); }

  const std::vector<Run>& runs() const { return runs_; }
  const std::vector<std::uint32_t>& runOwners() const { return runOwners_; }
  const Rest& rest() const { return rest_; }
  /// Moves a run's fragments to rest().
  void breakRun(std::size_t run);

  const std::vector<Pixel>& touched() const { return touched_; }
  /// For each pixel, for each of its samples: a number of fragments, and these, the farthest first.
  const std::uint32_t* layers() const { return layers_.data(); }
  /// By place in layers(), of those that are fragments.
  const float* depths() const { return depth_.data(); }
  /// Whether all samples of a pixel have the same fragments, in the same order.
  bool areSameInAll(Pixel touched, std::uint32_t samples) const;

 private:
  struct Layer {
    float depth;
    std::uint32_t fragment;
  };
  void reserve(const TranslucentTile& tile, int samples);
  void findFragments(int samples, const TranslucentTile& tile);
  std::uint32_t fragmentOf(std::uint32_t owner, std::uint32_t pixel, int most);
  void takeEach(const TranslucentTile& tile);
  void findRuns();
  void sortByPixel(const TranslucentTile& tile);
  void collectPixel(const TileClusters& clusters, int samples, const TranslucentTile& tile,
                    std::uint32_t pixel);
  void addLayers(const TileClusters& clusters, std::uint32_t pixel, Layer* first, Layer* end);
  void sortLayers(const TileClusters& clusters, Layer* first, Layer* end) const;
  static Layer* withoutRepetition(Layer* first, Layer* end);

  std::size_t count_ = 0;
  Array<std::uint32_t> owner_, pixel_;
  Array<std::uint16_t> coverage_;
  Array<Vec4f> color_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> runOwners_;
  Rest rest_;
  std::vector<Pixel> touched_;
  Array<std::uint32_t> layers_;
  Array<float> depth_;  ///< by place in layers_
  bool keepsDepths_ = false;
  std::size_t layerCount_ = 0;

  Array<std::uint32_t> fragment_;  ///< by sample of the tile; unless each is its own
  bool isEachItsOwn_ = false;
  Array<std::uint32_t> older_;            ///< by fragment: the one before in its pixel
  std::uint32_t newest_[kTilePixels];     ///< fragment, by pixel
  bool isRepeated_[kTilePixels];          ///< a triangle has a sample more than once
  std::uint32_t first_[kTilePixels + 1];  ///< in order_, by pixel
  Array<std::uint32_t> order_;            ///< numbers of samples, by pixel
  Array<Layer> sorted_;                   ///< of one pixel
};

}  // namespace limn
