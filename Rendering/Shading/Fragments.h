// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Raster/VisibilityTile.h"

#include <cstdint>
#include <vector>

namespace limn {

/// A triangle seen in a pixel: shaded once, whatever number of the pixel's samples show it.
struct Fragment {
  std::uint32_t owner;    ///< TileOwner
  std::uint16_t pixel;    ///< row * kTileSide + column, within the tile
  std::uint8_t coverage;  ///< bit s set: sample s shows it
};

/// Lists the fragments of a tile, pixel by pixel. Within a pixel they follow their first sample.
void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      std::vector<Fragment>& fragments);

/// Up to kCapacity fragments of one instance as arrays, ready to be shaded: which mixture of its
/// corners a fragment is, and what the corners carry. Arrays that the instance's style does not
/// need are not filled; vectors may read up to kCapacity.
struct alignas(64) FragmentBatch {
  static constexpr int kCapacity = 64;
  struct Vectors {
    float x[kCapacity], y[kCapacity], z[kCapacity];

    void set(int i, Vec3f v)
    {
      x[i] = v.x;
      y[i] = v.y;
      z[i] = v.z;
    }
  };

  float share[3][kCapacity];   ///< per corner: edge value times 1/w, not yet divided by the sum
  float weight[3][kCapacity];  ///< per corner: (12.4)
  float side[kCapacity];       ///< 1 seen from outside, -1 from inside
  Vectors corner[3];           ///< local positions; in view space if the mesh has low parts
  Vectors cornerNormal[3];     ///< local; [0] alone for a cell, or a triangle with low parts
  Vectors cornerColor[3];      ///< 0 ... 255; [0] alone for colours of a cell
  Vectors facePosition;        ///< centroid in view space; for flat frequency
  Vectors faceNormal;          ///< local; for flat frequency
  Vectors color;               ///< the result, before clamping
  int count = 0;               ///< last, so that every array starts at a multiple of 64 bytes
};

/// Colours of the fragments of one tile, in the order of `fragments`; alpha 255.
class FragmentShader {
 public:
  void shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
             const std::vector<Fragment>& fragments, std::vector<Rgba8>& colors);

 private:
  struct Corners;

  const ScreenVertices& screenOf(const PlacedCluster& cluster, std::uint32_t slot);
  Corners cornersAt(const PlacedCluster& cluster, const Fragment& fragment,
                    const TileRectangle& pixels, int samples);
  void fill(const PlacedCluster& cluster, const Fragment& fragment, const Corners& corners, int i);

  FragmentBatch batch_;
  std::vector<std::uint32_t> order_;        ///< fragments by instance
  std::vector<std::uint32_t> blockOfSlot_;  ///< where in blocks_ a cluster's vertices are
  std::vector<ScreenVertices> blocks_;      ///< of the clusters seen so far, transformed again
};

/// What a light equation needs besides the fragments.
struct ShadingContext {
  const PlacedScene* scene;
  const PlacedInstance* placed;
};

/// Divides the shares by their sum: fills `weight`.
void weighFragments(FragmentBatch& batch);
/// Fills `color` by the instance's style.
void lightFragments(const ShadingContext& context, FragmentBatch& batch);
/// Clamps to [0, 1], scales to bytes, rounds to even.
void quantizeFragments(const FragmentBatch& batch, Rgba8* colors);

}  // namespace limn
