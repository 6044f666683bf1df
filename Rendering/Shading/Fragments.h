// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Raster/VisibilityTile.h"
#include "Rendering/Shading/FragmentList.h"
#include "Rendering/SurfaceShader.h"
#include "Rendering/Shading/TranslucentFragments.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Up to kCapacity fragments of one instance as arrays, ready to be shaded: which mixture of its
/// corners a fragment is, and what the corners carry. Vectors may read up to kCapacity.
struct alignas(64) FragmentBatch {
  static constexpr int kCapacity = FragmentVectors::kCapacity;
  using Vectors = FragmentVectors;

  struct Pairs {
    float x[kCapacity], y[kCapacity];

    void set(int i, Vec2f v)
    {
      x[i] = v.x;
      y[i] = v.y;
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
  std::int32_t screenX[3][kCapacity], screenY[3][kCapacity];  ///< of the corners; subpixels
  float inverseW[3][kCapacity];                               ///< likewise
  float weight[3][kCapacity];                                 ///< per corner: (12.4)
  /// A pixel to the right, and above, in the triangle's plane; if UvUse::footprint.
  float rightWeight[3][kCapacity], aboveWeight[3][kCapacity];
  float side[kCapacity];              ///< 1 seen from outside, -1 from inside
  std::int32_t needsClip[kCapacity];  ///< not 0: the five above mean nothing
  Vectors viewCorner[3];              ///< only if the mesh has low parts
  Vectors edge[2];                    ///< likewise: from corner 0 to the others, local
  // By what the instance's style and attributes are:
  Vectors cornerNormal[3];          ///< local; [0] alone for normals of a cell
  Vectors cornerColor[3];           ///< 0 ... 255; [0] alone for colours of a cell
  float cornerAlpha[3][kCapacity];  ///< likewise; only with Style::readsAlpha
  Pairs cornerUv[2][3];             ///< by UvUse::set
  Vectors facePosition;             ///< where it is lit, in view space; for flat frequency
  Vectors faceNormal;               ///< local; for flat frequency
  Vectors smoothNormal[kMaxSmoothLevels][3];  ///< by smoothLevelsOf(); local
  Vectors color;                              ///< the result, before clamping
  float alpha[kCapacity];                     ///< by fadeFragments()
  bool anyNeedsClip = false;                  ///< by placeFragments()
  int count = 0;  ///< last, so that every array starts at a multiple of 64 bytes
};

/// Colours before they are clamped to bytes, one array a channel; 0 to kMaxRadiance.
struct RadianceArrays {
  Array<float> r, g, b;

  void resize(std::size_t size)
  {
    r.resize(size);
    g.resize(size);
    b.resize(size);
  }
};

/// Vectors, one array a component.
struct VectorArrays {
  Array<float> x, y, z;

  void resize(std::size_t size)
  {
    x.resize(size);
    y.resize(size);
    z.resize(size);
  }
};

/// What of texture coordinates an instance's textures read.
struct UvUse {
  bool set[2] = {false, false};
  bool footprint = false;  ///< how they, or what the style reads, change from pixel to pixel

  explicit UvUse(const Instance& instance) : footprint(instance.style.readsFootprint())
  {
    for (const TextureLayer& layer : instance.layers) {
      if (layer.readsUv()) set[layer.uvSet] = true;
      footprint = footprint || layer.readsFootprint();
    }
    if (instance.style.surfaceShader != nullptr && !instance.attributes.uv.empty()) set[0] = true;
    if (instance.style.isHatched() && instance.style.hatching.place == HatchPlace::kTexture)
      set[0] = true;
  }
  bool any() const { return set[0] || set[1]; }
};

/// Levels of Attributes::smoothNormals that an instance's style reads.
inline int smoothLevelsOf(const Instance& instance)
{
  return instance.style.isExaggerated() ? instance.attributes.smoothLevels : 0;
}

/// Colours of the fragments of one tile; alpha 255.
struct TileColors {
  Rgba8* pixel;           ///< where runs lie; room for kTilePixels, aligned to 64 bytes
  Array<Rgba8> fragment;  ///< as FragmentList lists them
  bool hasColors = true;  ///< asks the shader for them
  RadianceArrays pixelRadiance, fragmentRadiance;  ///< of the two; only with hasRadiance
  bool hasRadiance = false;                        ///< asks the shader for them
  VectorArrays pixelNormal, fragmentNormal;        ///< FrameView::normal; only with hasNormals
  bool hasNormals = false;                         ///< asks the shader for them
  VectorArrays pixelPlane, fragmentPlane;          ///< the triangles' own; only with hasPlanes
  bool hasPlanes = false;                          ///< asks the shader for them
};

/// What a light equation needs besides the fragments.
struct ShadingContext {
  const PlacedScene* scene;
  const PlacedInstance* placed;
};

class FragmentShader {
 public:
  /// Lists runs that it does not serve as fragments.
  void shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
             FragmentList& fragments, TileColors& colors);
  void shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
             TranslucentFragments& fragments);

 private:
  /// Fragments in any order, their coverage not read with one sample a pixel.
  struct Places {
    Span<const std::uint32_t> owner, pixel;
    const std::uint16_t* coverage;
  };
  /// Fills `batch_` with them and calls keep(placed, numbers) for each batch.
  template <class Keep>
  void forEachPlaced(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                     const Places& places, Keep keep);
  /// The fragments in `batch_`.
  void light(const TileClusters& clusters, const PlacedInstance& placed,
             const TileRectangle& pixels);
  /// Calls shade(placed, numbers) for batches of one instance, with their owners in `batch_`, until
  /// each owner has had its turn. `numbers` say which owners.
  template <class Shade>
  void forEachBatch(const TileClusters& clusters, Span<const std::uint32_t> owners, Shade shade);
  /// Lists owners instance by instance in `order_`; false if all are of one.
  bool orderByInstance(const TileClusters& clusters, Span<const std::uint32_t> owners);
  void fillBatch(const TileClusters& clusters, const PlacedInstance& placed,
                 const TileRectangle& pixels);
  void placeClippedFragments(const TileClusters& clusters);
  /// Of the batch, whose fragments have these numbers in the tile.
  void keepRadiance(Span<const std::uint32_t> numbers, RadianceArrays& fragments);
  /// Likewise what findNormals() or findPlanes() have left.
  void keepVectors(Span<const std::uint32_t> numbers, VectorArrays& fragments) const;

  FragmentBatch batch_;
  std::uint32_t clippedOwner_ = kNobody;  ///< of the tile being shaded
  ClippedTriangle clipped_;
  std::vector<std::uint32_t> order_;  ///< numbers of owners
  // For orderByInstance(): by instance of the scene, by number in the tile, by owner.
  std::vector<std::uint32_t> numberInTile_;
  std::vector<std::uint32_t> instance_, next_, number_;
};

/// Fills all that the fragments' corners and cells carry, by `owner`. Not for flat frequency.
/// Requires: isGatherable().
void gatherFragments(const TileClusters& clusters, const PlacedInstance& placed,
                     FragmentBatch& batch);
/// Whether an instance's arrays are within the reach of 32-bit indices.
bool isGatherable(const PlacedInstance& placed);

/// Moves the fragments' points from their pixels to the viewport. Puts the corners on the screen
/// again, bit for bit as transformVertices(), and finds where in its triangle each fragment lies.
/// Corners before the near plane or outside the guard band are left to the caller.
void placeFragments(const InstanceTransform& transform, const TileRectangle& pixels, bool footprint,
                    FragmentBatch& batch);
/// Fills `color` by the instance's style.
void lightFragments(const ShadingContext& context, FragmentBatch& batch);
/// Fills `alpha` by the instance's opacity, colours and textures; 0 to 1.
void fadeFragments(const ShadingContext& context, FragmentBatch& batch);
/// Shades a batch of runs, one for each of `numbers`, but for those of triangles that have to be
/// clipped. Requires: as shadeTriangles().
void shadeRuns(const ShadingContext& context, const TileRectangle& pixels, int samples,
               Span<const std::uint32_t> numbers, const FragmentBatch& batch,
               TranslucentFragments& fragments);
/// Shades the runs of a batch of triangles, one for each of `numbers`, but for those that have to
/// be clipped. Requires: gatherFragments() or the like, and placeFragments().
void shadeTriangles(const ShadingContext& context, const TileRectangle& pixels,
                    const FragmentList& fragments, Span<const std::uint32_t> numbers,
                    const FragmentBatch& batch, TileColors& colors);
/// Puts the normals of a batch of fragments, or of their triangles' planes, in the place of their
/// colours.
void findNormals(const ShadingContext& context, FragmentBatch& batch);
void findPlanes(const ShadingContext& context, FragmentBatch& batch);
/// As shadeTriangles(), the runs' normals and, if TileColors::hasPlanes, those of their planes.
void findNormals(const ShadingContext& context, const TileRectangle& pixels,
                 const FragmentList& fragments, Span<const std::uint32_t> numbers,
                 const FragmentBatch& batch, TileColors& colors);
/// Clamps to [0, 1], scales to bytes, rounds to even.
void quantizeFragments(const FragmentBatch& batch, Rgba8* colors);
/// Clamps the batch's colours to what a RadianceView holds.
void boundRadiance(FragmentBatch& batch);

}  // namespace limn
