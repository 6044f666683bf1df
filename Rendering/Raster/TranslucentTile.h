// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/TranslucencyBound.h"
#include "Rendering/Raster/VisibilityTile.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// Rows [first, end) of a tile, counted in the viewport.
struct TileRows {
  int first, end;
};

/// The samples of translucent triangles in some rows of a tile, as they come: those of one triangle
/// in a pixel have samples of fewer than kMostMixed other triangles among them.
class TranslucentTile {
 public:
  static constexpr std::uint32_t kSampleBits = 4;
  static constexpr std::size_t kMostMixed = 16;
  static_assert(kMaxSamples <= 1 << kSampleBits, "a sample's number must fit");

  std::size_t count() const { return count_; }
  std::uint32_t pixel(std::size_t i) const { return place_[i] >> kSampleBits; }
  std::uint32_t sample(std::size_t i) const { return place_[i] & ((1u << kSampleBits) - 1u); }
  std::uint32_t owner(std::size_t i) const { return owner_[i]; }
  float depth(std::size_t i) const { return depth_[i]; }
  /// There were more than kMaxTranslucentSamples; what is kept means nothing.
  bool isOverfull() const { return isOverfull_; }
  /// Some triangle was drawn by pieces, which rounding may have laid over each other.
  bool hasPieces() const { return hasPieces_; }

  void clear();
  /// From here on each sample keeps the translucentLayersKept() nearest of what is added. Requires:
  /// only samples of one row are added; `clusters` lives until settle().
  void keepNearest(const TileClusters& clusters, int samples);
  /// Brings what keepNearest() has kept to where the functions above find it. Returns the number of
  /// pixels that lost some.
  std::size_t settle();

  const std::uint32_t* owners() const { return owner_.data(); }

  // For the kernel, which writes whole vectors behind the last element and then calls grow().
  std::uint32_t* placeEnd() { return place_.data() + count_; }
  std::uint32_t* ownerEnd() { return owner_.data() + count_; }
  float* depthEnd() { return depth_.data() + count_; }
  void notePieces() { hasPieces_ = true; }
  void grow(std::size_t added)
  {
    count_ += added;
    if (count_ > kMaxTranslucentSamples) makeRoom();
  }

 private:
  struct Layer {
    float depth;
    std::uint32_t owner;
  };
  struct Kept {
    Layer layer;
    std::uint32_t sample;
  };
  void makeRoom();
  void sift();
  bool isNearer(Layer a, Layer b) const;

  std::size_t count_ = 0;
  bool isOverfull_ = false, hasPieces_ = false;
  Array<std::uint32_t> place_;  ///< pixel of the tile, and sample
  Array<std::uint32_t> owner_;  ///< TileOwner
  Array<float> depth_;

  // For keepNearest(): by sample of the row a heap with the farthest on top.
  const TileClusters* clusters_ = nullptr;
  int samples_ = 0;
  Array<Layer> heap_;
  std::vector<Kept> ofPixel_;
  std::uint32_t heapSize_[kTileSide << kSampleBits];
  std::uint32_t row_ = 0;        ///< pixel where it starts
  std::uint64_t truncated_ = 0;  ///< bit by column: lost some
};

/// Adds the samples of the clusters [firstSlot, end) of the tile's list that lie in `rows` and are
/// not behind the opaque surfaces; stops once `translucent` is overfull.
void rasterizeTranslucent(const TileClusters& clusters, std::size_t firstSlot,
                          const TileRectangle& pixels, TileRows rows, int samples,
                          VisibilityTile& tile, TranslucentTile& translucent);

}  // namespace limn
