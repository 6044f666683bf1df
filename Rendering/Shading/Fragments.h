// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Raster/VisibilityTile.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Triangles seen in the pixels of a tile; each is shaded once, whatever number of the pixel's
/// samples show it.
struct FragmentList {
  std::size_t count = 0;
  Array<std::uint32_t> owner;  ///< TileOwner
  Array<std::uint32_t> pixel;  ///< row * kTileSide + column, within the tile
  Array<std::uint8_t>
      coverage;  ///< bit s set: sample s shows it; not filled with one sample a pixel

  /// Makes room for all that `samples` samples can show, and for a vector more.
  void reserve(int samples);
};

/// Lists the fragments of a tile, pixel by pixel. Within a pixel they follow their first sample.
void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      FragmentList& fragments);

/// Up to kCapacity fragments of one instance as arrays, ready to be shaded: which mixture of its
/// corners a fragment is, and what the corners carry. Vectors may read up to kCapacity.
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

  // Filled for all instances:
  std::uint32_t owner[kCapacity];  ///< TileOwner
  std::int32_t pixel[kCapacity];   ///< as FragmentList's
  std::int32_t pointX[kCapacity],
      pointY[kCapacity];  ///< where it is shaded: first from the pixel's
                          ///< corner, then in the viewport; subpixels
  Vectors corner[3];      ///< local positions, high parts
  Vectors cornerLow[3];   ///< if the mesh has low parts
  // By placeFragments():
  float weight[3][kCapacity];         ///< per corner: (12.4)
  float side[kCapacity];              ///< 1 seen from outside, -1 from inside
  std::int32_t needsClip[kCapacity];  ///< not 0: the two above mean nothing
  Vectors viewCorner[3];              ///< only if the mesh has low parts
  Vectors edge[2];                    ///< likewise: from corner 0 to the others, local
  // By what the instance's style and attributes are:
  Vectors cornerNormal[3];  ///< local; [0] alone for normals of a cell
  Vectors cornerColor[3];   ///< 0 ... 255; [0] alone for colours of a cell
  Vectors facePosition;     ///< centroid in view space; for flat frequency
  Vectors faceNormal;       ///< local; for flat frequency
  Vectors color;            ///< the result, before clamping
  int count = 0;            ///< last, so that every array starts at a multiple of 64 bytes
};

/// Colours of the fragments of one tile, in the order of `fragments`; alpha 255.
class FragmentShader {
 public:
  void shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
             const FragmentList& fragments, Array<Rgba8>& colors);

 private:
  /// Lists the fragments instance by instance; false if all are of one.
  bool orderByInstance(const TileClusters& clusters, const FragmentList& fragments);
  void shadeBatch(const TileClusters& clusters, const PlacedInstance& placed,
                  const TileRectangle& pixels);

  FragmentBatch batch_;
  std::uint32_t clippedOwner_ = kNobody;  ///< of the tile being shaded
  ClippedTriangle clipped_;
  std::vector<std::uint32_t> order_;  ///< numbers of fragments
  // For orderByInstance(): by instance of the scene, by number in the tile, by fragment.
  std::vector<std::uint32_t> numberInTile_;
  std::vector<std::uint32_t> instance_, next_, number_;
};

/// What a light equation needs besides the fragments.
struct ShadingContext {
  const PlacedScene* scene;
  const PlacedInstance* placed;
};

/// Fills all that the fragments' corners and cells carry, by `owner`. Not for flat frequency.
/// Requires: isGatherable().
void gatherFragments(const TileClusters& clusters, const PlacedInstance& placed,
                     FragmentBatch& batch);
/// Whether a mesh's arrays are within the reach of 32-bit indices.
bool isGatherable(const ClusteredMesh& mesh);

/// Moves the fragments' points from their pixels to the viewport. Puts the corners on the screen
/// again, bit for bit as transformVertices(), and finds where in its triangle each fragment lies.
/// Corners before the near plane or outside the guard band are left to the caller.
void placeFragments(const InstanceTransform& transform, const TileRectangle& pixels,
                    FragmentBatch& batch);
/// Fills `color` by the instance's style.
void lightFragments(const ShadingContext& context, FragmentBatch& batch);
/// Clamps to [0, 1], scales to bytes, rounds to even.
void quantizeFragments(const FragmentBatch& batch, Rgba8* colors);

}  // namespace limn
