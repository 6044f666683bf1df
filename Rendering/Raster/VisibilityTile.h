// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Binning/TileBins.h"
#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"
#include "Rendering/Vertex/TransformVertices.h"

#include <cstdint>
#include <vector>

namespace limn {

inline constexpr int kBlockSide = 8;
inline constexpr int kBlocksPerRow = kTileSide / kBlockSide;
inline constexpr int kTileBlocks = kBlocksPerRow * kBlocksPerRow;
static_assert(kTileBlocks == 64, "a bit of VisibilityTile::stale for each block");

/// Names the triangle that a sample shows: the cluster's place in its tile's list, and the triangle
/// within the cluster. kNobody where the sample shows none.
struct TileOwner {
  static constexpr int kTriangleBits = 7;
  static_assert(kMaxClusterTriangles <= 1 << kTriangleBits, "a triangle's number must fit");
  static constexpr std::size_t kMaxClustersPerTile = kNobody >> kTriangleBits;

  static std::uint32_t make(std::uint32_t slot, std::uint32_t triangle)
  {
    return slot << kTriangleBits | triangle;
  }
  static std::uint32_t slot(std::uint32_t owner) { return owner >> kTriangleBits; }
  static std::uint32_t triangle(std::uint32_t owner) { return owner & ((1u << kTriangleBits) - 1); }
};

/// A cluster that a tile may show.
struct TileCluster {
  PlacedCluster cluster;
  ClusterBounds bounds;
};

/// The clusters of one tile, by slot.
struct TileClusters {
  const PlacedScene* scene;
  Span<const TileCluster> list;

  const PlacedCluster& at(std::uint32_t slot) const { return list[slot].cluster; }
  /// Whether a sample of equal depth goes from `old` to `fresh`: the later in draw order wins.
  bool drawnLater(std::uint32_t fresh, std::uint32_t old) const;
};

/// What each sample of a tile shows: sample plane by sample plane, pixels row by row from below.
struct alignas(64) VisibilityTile {
  float depth[kMaxSamples][kTilePixels];          ///< a plane: 16 KiB
  std::uint32_t owner[kMaxSamples][kTilePixels];  ///< a plane: 16 KiB
  /// Largest depth of any sample in a block of kBlockSide x kBlockSide pixels, where not stale.
  float farthest[kTileBlocks];
  std::uint64_t stale;  ///< bit per block, row by row from below: drawn to since
};

/// Fills the planes of `samples` samples with the frame's depth and nobody. Pixels outside the
/// frame get a depth before everything.
void clearTile(const FrameView& frame, const TileRectangle& pixels, int samples,
               VisibilityTile& tile);
/// Depths of a tile's pixels, row by row.
struct DepthRows {
  const float* first;
  std::ptrdiff_t stride;
};
/// The same with these.
void clearTile(const DepthRows& depths, const TileRectangle& pixels, int samples,
               VisibilityTile& tile);

/// Lists a tile's clusters, first those of opaque instances, roughly from front to back if
/// occlusion culling is on, then those of translucent ones. Returns how many are opaque.
std::size_t orderClusters(const PlacedScene& scene, const TileBins& bins, std::size_t tile,
                          std::vector<TileCluster>& ordered);

/// Finds for each sample the nearest triangle: smallest depth, then latest in draw order; so the
/// order of clusters and triangles does not matter. Returns how many clusters were left out because
/// all that they could show lies behind.
/// Requires: clearTile(); at most TileOwner::kMaxClustersPerTile clusters.
std::size_t rasterizeTile(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                          VisibilityTile& tile);

}  // namespace limn
