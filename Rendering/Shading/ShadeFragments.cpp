// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Raster/EdgeFunction.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace limn {
namespace {

/// Where a fragment is shaded, in viewport subpixels: the pixel's centre if it has all samples,
/// which surround the centre, else its first sample; so never outside the triangle.
struct ShadingPoint {
  std::int32_t x, y;
};

/// Offsets of the shading point in the pixel, by coverage.
using ShadingOffsets = std::array<SampleOffset, 1 << kMaxSamples>;

ShadingOffsets shadingOffsets(int samples)
{
  ShadingOffsets offsets;
  for (std::size_t coverage = 1; coverage < offsets.size(); ++coverage) {
    int first = 0;
    while ((coverage >> first & 1) == 0)
      ++first;
    offsets[coverage] = coverage == (1u << samples) - 1u || first >= samples
                            ? kPixelCentre
                            : samplePositions(samples)[static_cast<std::size_t>(first)];
  }
  return offsets;
}
const ShadingOffsets& shadingOffsetsOf(int samples)
{
  static const ShadingOffsets k1 = shadingOffsets(1), k2 = shadingOffsets(2),
                              k4 = shadingOffsets(4), k8 = shadingOffsets(8);
  return samples == 8 ? k8 : samples == 4 ? k4 : samples == 2 ? k2 : k1;
}

/// The piece of a clipped triangle that is drawn at a point: the first of the fan that covers it,
/// or, where rounding leaves a gap at the outer border, the first that is drawn at all.
struct FanPiece {
  OrientedTriangle triangle;
  int vertex[3];  ///< of the polygon, in the triangle's order of corners
};
FanPiece pieceAt(const ClippedTriangle& polygon, const Instance& instance, ShadingPoint p)
{
  FanPiece fallback = {};
  bool haveFallback = false;
  for (int i = 1; i + 1 < polygon.count; ++i) {
    FanPiece piece;
    if (!orient(polygon.vertex[0], polygon.vertex[i], polygon.vertex[i + 1], piece.triangle))
      continue;
    if (piece.triangle.clockwise ? instance.cullBackFaces : instance.cullFrontFaces) continue;
    piece.vertex[0] = 0;
    piece.vertex[1] = piece.triangle.clockwise ? i + 1 : i;
    piece.vertex[2] = piece.triangle.clockwise ? i : i + 1;
    if (piece.triangle.covers(p.x, p.y)) return piece;
    if (!haveFallback) fallback = piece;
    haveFallback = true;
  }
  return fallback;
}

float shareAt(const OrientedTriangle& triangle, int i, ShadingPoint p)
{
  return static_cast<float>(triangle.edge[i].at(p.x, p.y)) * triangle.corner[i].inverseW;
}

/// placeFragments() of one fragment of a triangle that has to be clipped.
void placeClipped(const PlacedCluster& cluster, std::uint32_t triangle, FragmentBatch& batch, int i)
{
  const ShadingPoint p = {batch.pointX[i], batch.pointY[i]};
  const ClippedTriangle polygon = clipClusterTriangle(cluster, triangle);
  const FanPiece piece = pieceAt(polygon, *cluster.placed->instance, p);
  batch.side[i] = piece.triangle.clockwise != cluster.placed->transform.mirrored ? -1.0f : 1.0f;
  const float share[3] = {shareAt(piece.triangle, 0, p), shareAt(piece.triangle, 1, p),
                          shareAt(piece.triangle, 2, p)};
  const float inverse = 1.0f / ((share[0] + share[1]) + share[2]);
  const float b[3] = {share[0] * inverse, share[1] * inverse, share[2] * inverse};
  for (int corner = 0; corner < 3; ++corner) {
    const auto w = [&](int k) {
      return static_cast<float>(polygon.weight[piece.vertex[k]][corner]);
    };
    batch.weight[corner][i] = (b[0] * w(0) + b[1] * w(1)) + b[2] * w(2);
  }
}

Vec3f bytes(Rgba8 c)
{
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

/// Collects fragments of one instance into a batch.
class BatchFiller {
 public:
  BatchFiller(const PlacedInstance& placed, FragmentBatch& batch)
      : mesh_(placed.mesh()),
        transform_(placed.transform),
        data_(placed.instance->attributes),
        flat_(placed.instance->style.frequency == ShadingFrequency::kFlat),
        normals_(placed.instance->style.normals),
        batch_(batch)
  {
  }

  void fill(const PlacedCluster& cluster, std::uint32_t t, int i) const
  {
    const std::size_t place = cluster.cluster->firstTriangle + t;
    for (int k = 0; k < 3; ++k)
      fillCorner(cluster.cluster->firstVertex + mesh_.corner[k][place], k, i);
    const bool needsCell = flat_ || normals_ == NormalSource::kCell ||
                           (data_.vertexColors.empty() && !data_.cellColors.empty());
    if (needsCell) fillCell(mesh_.triangle[place], i);
  }

 private:
  void fillCorner(std::size_t v, int k, int i) const
  {
    batch_.corner[k].set(i, {mesh_.x[v], mesh_.y[v], mesh_.z[v]});
    if (transform_.hasLowParts)
      batch_.cornerLow[k].set(i, {mesh_.xLow[v], mesh_.yLow[v], mesh_.zLow[v]});
    const std::uint32_t vertex = mesh_.vertex[v];
    if (!flat_ && normals_ == NormalSource::kVertex)
      batch_.cornerNormal[k].set(i, data_.vertexNormals[vertex]);
    if (!data_.vertexColors.empty())
      batch_.cornerColor[k].set(i, bytes(data_.vertexColors[vertex]));
  }

  void fillCell(std::uint32_t triangle, int i) const
  {
    const std::uint32_t cell = data_.cells.empty() ? triangle : data_.cells[triangle];
    if (data_.vertexColors.empty() && !data_.cellColors.empty())
      batch_.cornerColor[0].set(i, bytes(data_.cellColors[cell]));
    if (flat_) {
      batch_.facePosition.set(
          i, viewPosition(transform_, toLocal(data_.faceCentroids[cell], mesh_.origin)));
      batch_.faceNormal.set(i, data_.faceNormals[cell]);
    } else if (normals_ == NormalSource::kCell) {
      batch_.cornerNormal[0].set(i, data_.cellNormals[cell]);
    }
  }

  const ClusteredMesh& mesh_;
  const InstanceTransform& transform_;
  const Attributes& data_;
  bool flat_;
  NormalSource normals_;
  FragmentBatch& batch_;
};

}  // namespace

void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      std::vector<Fragment>& fragments)
{
  // Room for all that can come, so that the loops only write.
  fragments.resize(static_cast<std::size_t>(kTilePixels) * static_cast<std::size_t>(samples));
  std::size_t count = 0;
  for (int y = 0; y < pixels.y1 - pixels.y0; ++y)
    for (int x = 0; x < pixels.x1 - pixels.x0; ++x) {
      const int pixel = y * kTileSide + x;
      if (samples == 1) {
        fragments[count] = {tile.owner[0][pixel], static_cast<std::uint16_t>(pixel), 1};
        count += tile.owner[0][pixel] != kNobody;
        continue;
      }
      const std::size_t first = count;
      for (int s = 0; s < samples; ++s) {
        const std::uint32_t owner = tile.owner[s][pixel];
        if (owner == kNobody) continue;
        const auto bit = static_cast<std::uint8_t>(1u << s);
        std::size_t f = first;
        while (f < count && fragments[f].owner != owner)
          ++f;
        if (f == count)
          fragments[count++] = {owner, static_cast<std::uint16_t>(pixel), bit};
        else
          fragments[f].coverage = static_cast<std::uint8_t>(fragments[f].coverage | bit);
      }
    }
  fragments.resize(count);
}

void FragmentShader::shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                           const std::vector<Fragment>& fragments, std::vector<Rgba8>& colors)
{
  colors.resize(fragments.size());
  const auto placedOf = [&](std::uint32_t f) {
    return clusters.at(TileOwner::slot(fragments[f].owner)).placed;
  };
  order_.resize(fragments.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (clusters.scene->instances.size() > 1)
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return placedOf(a) < placedOf(b); });

  const ShadingOffsets& offsets = shadingOffsetsOf(samples);
  std::size_t next = 0;
  while (next < order_.size()) {
    const PlacedInstance* placed = placedOf(order_[next]);
    const BatchFiller filler(*placed, batch_);
    const bool gathers = placed->instance->style.frequency != ShadingFrequency::kFlat &&
                         isGatherable(placed->mesh());
    const std::size_t first = next;
    batch_.count = 0;
    while (next < order_.size() && batch_.count < FragmentBatch::kCapacity) {
      const Fragment& fragment = fragments[order_[next]];
      const PlacedCluster& cluster = clusters.at(TileOwner::slot(fragment.owner));
      if (cluster.placed != placed) break;
      const int i = batch_.count++;
      const SampleOffset offset = offsets[fragment.coverage];
      batch_.pointX[i] = (pixels.x0 + fragment.pixel % kTileSide) * kSubpixels + offset.x;
      batch_.pointY[i] = (pixels.y0 + fragment.pixel / kTileSide) * kSubpixels + offset.y;
      batch_.owner[i] = fragment.owner;
      if (!gathers) filler.fill(cluster, TileOwner::triangle(fragment.owner), i);
      ++next;
    }
    if (gathers) gatherFragments(clusters, *placed, batch_);
    placeFragments(placed->transform, batch_);
    for (int i = 0; i < batch_.count; ++i)
      if (batch_.needsClip[i] != 0) {
        const std::uint32_t owner = fragments[order_[first + static_cast<std::size_t>(i)]].owner;
        placeClipped(clusters.at(TileOwner::slot(owner)), TileOwner::triangle(owner), batch_, i);
      }
    lightFragments({clusters.scene, placed}, batch_);
    Rgba8 shaded[FragmentBatch::kCapacity];
    quantizeFragments(batch_, shaded);
    for (std::size_t i = first; i < next; ++i)
      colors[order_[i]] = shaded[i - first];
  }
}

}  // namespace limn
