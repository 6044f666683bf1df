// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Raster/EdgeFunction.h"
#include "Rendering/Shading/RunSurfaceShader.h"
#include "Rendering/Shading/ShadingOffsets.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace limn {
namespace {

/// Where a fragment is shaded, in viewport subpixels: the pixel's centre if it has all samples,
/// which surround the centre, else its first sample; so never outside the triangle.
struct ShadingPoint {
  std::int32_t x, y;
};

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

/// The weights of the whole triangle's corners at a point of a piece.
void weighPiece(const ClippedTriangle& polygon, const FanPiece& piece, ShadingPoint p,
                float (&weight)[3][FragmentBatch::kCapacity], int i)
{
  const float share[3] = {shareAt(piece.triangle, 0, p), shareAt(piece.triangle, 1, p),
                          shareAt(piece.triangle, 2, p)};
  const float inverse = 1.0f / ((share[0] + share[1]) + share[2]);
  const float b[3] = {share[0] * inverse, share[1] * inverse, share[2] * inverse};
  for (int corner = 0; corner < 3; ++corner) {
    const auto w = [&](int k) {
      return static_cast<float>(polygon.weight[piece.vertex[k]][corner]);
    };
    weight[corner][i] = (b[0] * w(0) + b[1] * w(1)) + b[2] * w(2);
  }
}

/// placeFragments() of one fragment of a triangle that has to be clipped.
void placeClipped(const PlacedCluster& cluster, const ClippedTriangle& polygon, bool footprint,
                  FragmentBatch& batch, int i)
{
  const ShadingPoint p = {batch.pointX[i], batch.pointY[i]};
  const FanPiece piece = pieceAt(polygon, *cluster.placed->instance, p);
  batch.side[i] = piece.triangle.clockwise != cluster.placed->transform.mirrored ? -1.0f : 1.0f;
  weighPiece(polygon, piece, p, batch.weight, i);
  if (footprint) {
    weighPiece(polygon, piece, {p.x + kSubpixels, p.y}, batch.rightWeight, i);
    weighPiece(polygon, piece, {p.x, p.y + kSubpixels}, batch.aboveWeight, i);
  }
}

void setPoint(FragmentBatch& batch, std::size_t i, std::uint32_t pixel, SampleOffset offset)
{
  batch.pixel[i] = static_cast<std::int32_t>(pixel);
  batch.pointX[i] = offset.x;
  batch.pointY[i] = offset.y;
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
        readsAlpha_(placed.instance->style.readsAlpha),
        normals_(placed.instance->style.normals),
        uv_(*placed.instance),
        smoothLevels_(smoothLevelsOf(*placed.instance)),
        batch_(batch)
  {
  }

  void fill(const PlacedCluster& cluster, std::uint32_t t, int i) const
  {
    const std::size_t place = cluster.cluster->firstTriangle + t;
    for (int k = 0; k < 3; ++k)
      fillCorner(cluster.cluster->firstVertex + mesh_.corner[k][place], mesh_.triangle[place], k,
                 i);
    const bool needsCell = flat_ || normals_ == NormalSource::kCell ||
                           (data_.vertexColors.empty() && !data_.cellColors.empty());
    if (needsCell) fillCell(mesh_.triangle[place], i);
  }

 private:
  void fillCorner(std::size_t v, std::uint32_t triangle, int k, int i) const
  {
    batch_.corner[k].set(i, {mesh_.x[v], mesh_.y[v], mesh_.z[v]});
    if (transform_.hasLowParts)
      batch_.cornerLow[k].set(i, {mesh_.xLow[v], mesh_.yLow[v], mesh_.zLow[v]});
    const std::uint32_t vertex = mesh_.vertex[v];
    if (!flat_ && normals_ == NormalSource::kVertex)
      batch_.cornerNormal[k].set(
          i, data_.vertexNormals[data_.normalOfCorner.empty()
                                     ? vertex
                                     : data_.normalOfCorner[std::size_t{3} * triangle +
                                                            static_cast<std::size_t>(k)]]);
    if (!data_.vertexColors.empty()) setColor(data_.vertexColors[vertex], k, i);
    if (uv_.set[0]) batch_.cornerUv[0][k].set(i, data_.uv[vertex]);
    if (uv_.set[1]) batch_.cornerUv[1][k].set(i, data_.uv2[vertex]);
    for (int level = 0; level < smoothLevels_; ++level)
      batch_.smoothNormal[level][k].set(i, smoothNormal(vertex, triangle, k, level));
  }

  Vec3f smoothNormal(std::uint32_t vertex, std::uint32_t triangle, int k, int level) const
  {
    const std::size_t number =
        data_.smoothOfCorner.empty()
            ? vertex
            : data_.smoothOfCorner[std::size_t{3} * triangle + static_cast<std::size_t>(k)];
    return unpackedNormal(data_.smoothNormals[number * static_cast<std::size_t>(smoothLevels_) +
                                              static_cast<std::size_t>(level)]);
  }

  void setColor(Rgba8 color, int k, int i) const
  {
    batch_.cornerColor[k].set(i, bytes(color));
    if (readsAlpha_) batch_.cornerAlpha[k][i] = static_cast<float>(color.a);
  }

  void fillCell(std::uint32_t triangle, int i) const
  {
    const std::uint32_t cell = data_.cells.empty() ? triangle : data_.cells[triangle];
    if (data_.vertexColors.empty() && !data_.cellColors.empty())
      setColor(data_.cellColors[cell], 0, i);
    if (flat_) {
      batch_.facePosition.set(
          i, viewPosition(transform_, toLocal(data_.facePoints[cell], mesh_.origin)));
      batch_.faceNormal.set(i, data_.faceNormals[cell]);
    } else if (normals_ == NormalSource::kCell) {
      batch_.cornerNormal[0].set(i, data_.cellNormals[cell]);
    }
  }

  const ClusteredMesh& mesh_;
  const InstanceTransform& transform_;
  const Attributes& data_;
  bool flat_, readsAlpha_;
  NormalSource normals_;
  UvUse uv_;
  int smoothLevels_;
  FragmentBatch& batch_;
};

/// Whether ascending numbers leave none out.
bool isRun(Span<const std::uint32_t> numbers)
{
  return numbers[numbers.size() - 1] - numbers[0] == numbers.size() - 1;
}

/// Puts a batch's values where its fragments' numbers say.
template <class Value>
void keep(const Value* values, Span<const std::uint32_t> numbers, Array<Value>& fragments)
{
  if (isRun(numbers))
    std::copy_n(values, numbers.size(), &fragments[numbers[0]]);
  else
    for (std::size_t i = 0; i < numbers.size(); ++i)
      fragments[numbers[i]] = values[i];
}

/// kPixelCentre as often as a batch has fragments. Copied, as the compiler's own loops do not go by
/// vectors here.
struct PixelCentres {
  std::int32_t x[FragmentBatch::kCapacity] = {}, y[FragmentBatch::kCapacity] = {};

  constexpr PixelCentres()
  {
    for (int i = 0; i < FragmentBatch::kCapacity; ++i) {
      x[i] = kPixelCentre.x;
      y[i] = kPixelCentre.y;
    }
  }
};
constexpr PixelCentres kPixelCentres;

/// setPoint() of one sample a pixel.
void setCentres(FragmentBatch& batch, Span<const std::uint32_t> pixels,
                Span<const std::uint32_t> numbers)
{
  if (isRun(numbers))
    std::memcpy(batch.pixel, pixels.data() + numbers[0], numbers.size() * sizeof *batch.pixel);
  else
    for (std::size_t i = 0; i < numbers.size(); ++i)
      batch.pixel[i] = static_cast<std::int32_t>(pixels[numbers[i]]);
  std::copy_n(kPixelCentres.x, numbers.size(), batch.pointX);
  std::copy_n(kPixelCentres.y, numbers.size(), batch.pointY);
}

bool isProgrammed(const PlacedInstance& placed)
{
  return placed.instance->style.surfaceShader != nullptr;
}

}  // namespace

bool FragmentShader::orderByInstance(const TileClusters& clusters, Span<const std::uint32_t> owners)
{
  const PlacedInstance* const scene = clusters.scene->instances.data();
  numberInTile_.resize(clusters.scene->instances.size(), kNobody);
  instance_.clear();
  next_.clear();
  number_.resize(owners.size());
  for (std::size_t f = 0; f < owners.size(); ++f) {
    const PlacedInstance* placed = clusters.at(TileOwner::slot(owners[f])).placed;
    const auto instance = static_cast<std::uint32_t>(placed - scene);
    if (numberInTile_[instance] == kNobody) {
      numberInTile_[instance] = static_cast<std::uint32_t>(instance_.size());
      instance_.push_back(instance);
      next_.push_back(0);
    }
    number_[f] = numberInTile_[instance];
    ++next_[number_[f]];
  }
  for (const std::uint32_t instance : instance_)
    numberInTile_[instance] = kNobody;
  if (instance_.size() <= 1) return false;
  std::uint32_t first = 0;
  for (std::uint32_t& next : next_)
    first += std::exchange(next, first);
  order_.resize(owners.size());
  for (std::size_t f = 0; f < owners.size(); ++f)
    order_[next_[number_[f]]++] = static_cast<std::uint32_t>(f);
  return true;
}

template <class Shade>
void FragmentShader::forEachBatch(const TileClusters& clusters, Span<const std::uint32_t> owners,
                                  Shade shade)
{
  const bool isOrdered = clusters.scene->instances.size() > 1 && orderByInstance(clusters, owners);
  const auto numberOf = [&](std::size_t i) {
    return isOrdered ? order_[i] : static_cast<std::uint32_t>(i);
  };
  const auto placedOf = [&](std::size_t i) {
    return clusters.at(TileOwner::slot(owners[numberOf(i)])).placed;
  };
  for (std::size_t first = 0; first < owners.size();) {
    const PlacedInstance& placed = *placedOf(first);
    std::size_t end = std::min<std::size_t>(first + FragmentBatch::kCapacity, owners.size());
    if (isOrdered)
      while (placedOf(end - 1) != &placed)
        --end;
    std::uint32_t numbers[FragmentBatch::kCapacity];
    if (isOrdered)
      for (std::size_t i = first; i < end; ++i) {
        numbers[i - first] = order_[i];
        batch_.owner[i - first] = owners[order_[i]];
      }
    else {
      std::iota(numbers, numbers + (end - first), static_cast<std::uint32_t>(first));
      std::copy(&owners[first], &owners[first] + (end - first), batch_.owner);
    }
    batch_.count = static_cast<int>(end - first);
    shade(placed, Span<const std::uint32_t>(numbers, end - first));
    first = end;
  }
}

void FragmentShader::fillBatch(const TileClusters& clusters, const PlacedInstance& placed,
                               const TileRectangle& pixels)
{
  if (placed.instance->style.frequency != ShadingFrequency::kFlat && isGatherable(placed)) {
    gatherFragments(clusters, placed, batch_);
  } else {
    const BatchFiller filler(placed, batch_);
    for (int i = 0; i < batch_.count; ++i)
      filler.fill(clusters.at(TileOwner::slot(batch_.owner[i])),
                  TileOwner::triangle(batch_.owner[i]), i);
  }
  placeFragments(placed.transform, pixels, UvUse(*placed.instance).footprint, batch_);
}

void FragmentShader::placeClippedFragments(const TileClusters& clusters)
{
  if (!batch_.anyNeedsClip) return;
  for (int i = 0; i < batch_.count; ++i) {
    if (batch_.needsClip[i] == 0) continue;
    const PlacedCluster& cluster = clusters.at(TileOwner::slot(batch_.owner[i]));
    // Clipped triangles are mostly large: the next fragment shows the same.
    if (batch_.owner[i] != clippedOwner_)
      clipped_ = clipClusterTriangle(cluster, TileOwner::triangle(batch_.owner[i]));
    clippedOwner_ = batch_.owner[i];
    placeClipped(cluster, clipped_, UvUse(*cluster.placed->instance).footprint, batch_, i);
  }
}

void FragmentShader::keepRadiance(Span<const std::uint32_t> numbers, RadianceArrays& fragments)
{
  boundRadiance(batch_);
  const FragmentVectors& from = batch_.color;
  keep(from.x, numbers, fragments.r);
  keep(from.y, numbers, fragments.g);
  keep(from.z, numbers, fragments.b);
}

void FragmentShader::keepVectors(Span<const std::uint32_t> numbers, VectorArrays& fragments) const
{
  const FragmentVectors& from = batch_.color;
  keep(from.x, numbers, fragments.x);
  keep(from.y, numbers, fragments.y);
  keep(from.z, numbers, fragments.z);
}

template <class Keep>
void FragmentShader::forEachPlaced(const TileClusters& clusters, const TileRectangle& pixels,
                                   int samples, const Places& places, Keep keep)
{
  const ShadingOffsets offsets(samples);
  forEachBatch(clusters, places.owner, [&](const PlacedInstance& placed, auto numbers) {
    if (samples == 1)
      setCentres(batch_, places.pixel, numbers);
    else
      for (std::size_t i = 0; i < numbers.size(); ++i)
        setPoint(batch_, i, places.pixel[numbers[i]], offsets[places.coverage[numbers[i]]]);
    fillBatch(clusters, placed, pixels);
    placeClippedFragments(clusters);
    keep(placed, numbers);
  });
}

void FragmentShader::light(const TileClusters& clusters, const PlacedInstance& placed,
                           const TileRectangle& pixels)
{
  if (isProgrammed(placed))
    runSurfaceShader({clusters.scene, &placed}, clusters, pixels, batch_);
  else
    lightFragments({clusters.scene, &placed}, batch_);
}

void FragmentShader::shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                           TranslucentFragments& fragments)
{
  clippedOwner_ = kNobody;
  forEachBatch(clusters, fragments.runOwners(), [&](const PlacedInstance& placed, auto numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      setPoint(batch_, i, fragments.pixels()[fragments.runs()[numbers[i]].first], kPixelCentre);
    fillBatch(clusters, placed, pixels);
    if (!isProgrammed(placed))
      shadeRuns({clusters.scene, &placed}, pixels, samples, numbers, batch_, fragments);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (isProgrammed(placed) || batch_.needsClip[i] != 0) fragments.breakRun(numbers[i]);
  });

  const TranslucentFragments::Rest& rest = fragments.rest();
  const Places places = {
      {rest.owner.data(), rest.count}, {rest.pixel.data(), rest.count}, rest.coverage.data()};
  forEachPlaced(clusters, pixels, samples, places, [&](const PlacedInstance& placed, auto numbers) {
    light(clusters, placed, pixels);
    fadeFragments({clusters.scene, &placed}, batch_);
    boundRadiance(batch_);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      fragments.colors()[rest.fragment[numbers[i]]] = {batch_.color.x[i], batch_.color.y[i],
                                                       batch_.color.z[i], batch_.alpha[i]};
  });
}

void FragmentShader::shade(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                           FragmentList& fragments, TileColors& colors)
{
  clippedOwner_ = kNobody;
  if (colors.hasRadiance) colors.pixelRadiance.resize(kTilePixels);
  if (colors.hasNormals) colors.pixelNormal.resize(kTilePixels);
  if (colors.hasPlanes) colors.pixelPlane.resize(kTilePixels);
  const Span<const std::uint32_t> triangles(fragments.triangleOwner.data(),
                                            fragments.triangleCount);
  forEachBatch(clusters, triangles, [&](const PlacedInstance& placed, auto numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      setPoint(batch_, i, fragments.run[fragments.firstRun[numbers[i]]].pixel, kPixelCentre);
    fillBatch(clusters, placed, pixels);
    const ShadingContext context = {clusters.scene, &placed};
    if (colors.hasColors && isProgrammed(placed))
      runSurfaceShader(context, clusters, pixels, fragments, numbers, batch_, colors);
    else if (colors.hasColors)
      shadeTriangles(context, pixels, fragments, numbers, batch_, colors);
    if (colors.hasNormals) findNormals(context, pixels, fragments, numbers, batch_, colors);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (batch_.needsClip[i] != 0) fragments.breakRuns(numbers[i], samples);
  });

  colors.fragment.resize(fragments.count);
  if (colors.hasRadiance) colors.fragmentRadiance.resize(fragments.count);
  if (colors.hasNormals) colors.fragmentNormal.resize(fragments.count);
  if (colors.hasPlanes) colors.fragmentPlane.resize(fragments.count);
  const Places places = {{fragments.owner.data(), fragments.count},
                         {fragments.pixel.data(), fragments.count},
                         fragments.coverage.data()};
  forEachPlaced(clusters, pixels, samples, places, [&](const PlacedInstance& placed, auto numbers) {
    if (colors.hasColors) {
      light(clusters, placed, pixels);
      Rgba8 shaded[FragmentBatch::kCapacity];
      quantizeFragments(batch_, shaded);
      keep(shaded, numbers, colors.fragment);
    }
    if (colors.hasRadiance) keepRadiance(numbers, colors.fragmentRadiance);
    if (colors.hasNormals) {
      findNormals({clusters.scene, &placed}, batch_);
      keepVectors(numbers, colors.fragmentNormal);
    }
    if (colors.hasPlanes) {
      findPlanes({clusters.scene, &placed}, batch_);
      keepVectors(numbers, colors.fragmentPlane);
    }
  });
}

}  // namespace limn
