// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Raster/EdgeFunction.h"

#include <algorithm>
#include <numeric>

namespace limn {

void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      std::vector<Fragment>& fragments)
{
  fragments.clear();
  for (int y = 0; y < pixels.y1 - pixels.y0; ++y)
    for (int x = 0; x < pixels.x1 - pixels.x0; ++x) {
      const int pixel = y * kTileSide + x;
      const std::size_t first = fragments.size();
      for (int s = 0; s < samples; ++s) {
        const std::uint32_t owner = tile.owner[s][pixel];
        if (owner == kNobody) continue;
        const auto bit = static_cast<std::uint8_t>(1u << s);
        std::size_t f = first;
        while (f < fragments.size() && fragments[f].owner != owner)
          ++f;
        if (f == fragments.size())
          fragments.push_back({owner, static_cast<std::uint16_t>(pixel), bit});
        else
          fragments[f].coverage = static_cast<std::uint8_t>(fragments[f].coverage | bit);
      }
    }
}

/// A fragment's triangle on the screen, and how the shading point lies in it.
struct FragmentShader::Corners {
  float share[3];   ///< of the corners as the mesh orders them; unless clipped
  float weight[3];  ///< only if clipped
  bool clipped;
  bool clockwise;
};

namespace {

/// Where a fragment is shaded, in viewport subpixels: the pixel's centre if it has all samples,
/// which surround the centre, else its first sample; so never outside the triangle.
struct ShadingPoint {
  std::int64_t x, y;
};
ShadingPoint shadingPoint(const Fragment& fragment, const TileRectangle& pixels, int samples)
{
  const bool all = fragment.coverage == (1u << samples) - 1u;
  int first = 0;
  while ((fragment.coverage >> first & 1) == 0)
    ++first;
  const SampleOffset offset =
      all ? kPixelCentre : samplePositions(samples)[static_cast<std::size_t>(first)];
  return {std::int64_t{pixels.x0 + fragment.pixel % kTileSide} * kSubpixels + offset.x,
          std::int64_t{pixels.y0 + fragment.pixel / kTileSide} * kSubpixels + offset.y};
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

Vec3f bytes(Rgba8 c)
{
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

}  // namespace

const ScreenVertices& FragmentShader::screenOf(const PlacedCluster& cluster, std::uint32_t slot)
{
  if (blockOfSlot_[slot] == kNobody) {
    blockOfSlot_[slot] = static_cast<std::uint32_t>(blocks_.size());
    blocks_.emplace_back();
    transformVertices(cluster, blocks_.back());
  }
  return blocks_[blockOfSlot_[slot]];
}

FragmentShader::Corners FragmentShader::cornersAt(const PlacedCluster& cluster,
                                                  const Fragment& fragment,
                                                  const TileRectangle& pixels, int samples)
{
  const ScreenVertices& screen = screenOf(cluster, TileOwner::slot(fragment.owner));
  const std::uint32_t t = TileOwner::triangle(fragment.owner);
  const ScreenVertex v[3] = {screen.vertex(cluster.corner(t, 0)),
                             screen.vertex(cluster.corner(t, 1)),
                             screen.vertex(cluster.corner(t, 2))};
  const ShadingPoint p = shadingPoint(fragment, pixels, samples);
  Corners corners = {};
  corners.clipped = v[0].needsClip || v[1].needsClip || v[2].needsClip;
  if (!corners.clipped) {
    OrientedTriangle triangle = {};
    orient(v[0], v[1], v[2], triangle);
    corners.clockwise = triangle.clockwise;
    for (int k = 0; k < 3; ++k)
      corners.share[triangle.clockwise && k != 0 ? 3 - k : k] = shareAt(triangle, k, p);
    return corners;
  }
  const ClippedTriangle polygon = clipClusterTriangle(cluster, t, screen);
  const FanPiece piece = pieceAt(polygon, *cluster.placed->instance, p);
  corners.clockwise = piece.triangle.clockwise;
  const float share[3] = {shareAt(piece.triangle, 0, p), shareAt(piece.triangle, 1, p),
                          shareAt(piece.triangle, 2, p)};
  const float inverse = 1.0f / ((share[0] + share[1]) + share[2]);
  const float b[3] = {share[0] * inverse, share[1] * inverse, share[2] * inverse};
  for (int corner = 0; corner < 3; ++corner) {
    const auto w = [&](int k) {
      return static_cast<float>(polygon.weight[piece.vertex[k]][corner]);
    };
    corners.weight[corner] = (b[0] * w(0) + b[1] * w(1)) + b[2] * w(2);
  }
  return corners;
}

void FragmentShader::fill(const PlacedCluster& cluster, const Fragment& fragment,
                          const Corners& corners, int i)
{
  const Instance& instance = *cluster.placed->instance;
  const Attributes& data = instance.attributes;
  const Style& style = instance.style;
  const std::uint32_t t = TileOwner::triangle(fragment.owner);
  const std::uint32_t triangle = cluster.meshTriangle(t);
  const std::uint32_t cell = data.cells.empty() ? triangle : data.cells[triangle];
  const bool flat = style.frequency == ShadingFrequency::kFlat;

  const InstanceTransform& transform = cluster.placed->transform;
  batch_.side[i] = corners.clockwise != transform.mirrored ? -1.0f : 1.0f;
  LocalPosition position[3];
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t local = cluster.corner(t, k);
    const std::uint32_t vertex = cluster.mesh().vertex[cluster.cluster->firstVertex + local];
    batch_.share[k][i] = corners.share[k];
    position[k] = cluster.position(local);
    batch_.corner[k].set(
        i, transform.hasLowParts ? viewPosition(transform, position[k]) : position[k].high);
    if (!flat && style.normals == NormalSource::kVertex)
      batch_.cornerNormal[k].set(i, data.vertexNormals[vertex]);
    if (!data.vertexColors.empty()) batch_.cornerColor[k].set(i, bytes(data.vertexColors[vertex]));
  }
  if (data.vertexColors.empty() && !data.cellColors.empty())
    batch_.cornerColor[0].set(i, bytes(data.cellColors[cell]));
  if (flat) {
    batch_.facePosition.set(
        i, viewPosition(transform, toLocal(data.faceCentroids[cell], cluster.mesh().origin)));
    batch_.faceNormal.set(i, data.faceNormals[cell]);
  } else if (style.normals == NormalSource::kCell) {
    batch_.cornerNormal[0].set(i, data.cellNormals[cell]);
  } else if (style.normals == NormalSource::kTriangle && transform.hasLowParts) {
    batch_.cornerNormal[0].set(i, triangleNormal(position[0], position[1], position[2]));
  }
}

void FragmentShader::shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                           const std::vector<Fragment>& fragments, std::vector<Rgba8>& colors)
{
  colors.resize(fragments.size());
  blocks_.clear();
  blockOfSlot_.assign(clusters.list.size(), kNobody);

  const auto instanceOf = [&](std::uint32_t f) {
    return clusters.scene->instanceOf(clusters.list[TileOwner::slot(fragments[f].owner)]);
  };
  order_.resize(fragments.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (clusters.scene->instances.size() > 1)
    std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return instanceOf(a) < instanceOf(b);
    });

  std::size_t next = 0;
  while (next < order_.size()) {
    const PlacedInstance* placed =
        clusters.at(TileOwner::slot(fragments[order_[next]].owner)).placed;
    Corners corners[FragmentBatch::kCapacity];
    const std::size_t first = next;
    batch_.count = 0;
    while (next < order_.size() && batch_.count < FragmentBatch::kCapacity) {
      const Fragment& fragment = fragments[order_[next]];
      const PlacedCluster cluster = clusters.at(TileOwner::slot(fragment.owner));
      if (cluster.placed != placed) break;
      corners[batch_.count] = cornersAt(cluster, fragment, pixels, samples);
      fill(cluster, fragment, corners[batch_.count], batch_.count);
      ++batch_.count;
      ++next;
    }
    weighFragments(batch_);
    for (int i = 0; i < batch_.count; ++i)
      for (int k = 0; k < 3; ++k)
        if (corners[i].clipped) batch_.weight[k][i] = corners[i].weight[k];
    lightFragments({clusters.scene, placed}, batch_);
    Rgba8 shaded[FragmentBatch::kCapacity];
    quantizeFragments(batch_, shaded);
    for (std::size_t i = first; i < next; ++i)
      colors[order_[i]] = shaded[i - first];
  }
}

}  // namespace limn
