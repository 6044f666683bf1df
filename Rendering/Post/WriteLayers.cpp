// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/WriteLayers.h"

#include "Rendering/Post/ColorSum.h"
#include "Rendering/Post/NearestSample.h"
#include "Rendering/Post/TilePlace.h"

#include <hwy/base.h>

namespace limn {
namespace {

/// The layers of one tile.
class LayerWriter {
 public:
  LayerWriter(const TileClusters& clusters, const VisibilityTile& tile, const TileRectangle& pixels,
              const FragmentList& fragments, const TileColors& colors, const LayerTarget& target)
      : clusters_(clusters),
        scene_(*clusters.scene->scene),
        tile_(tile),
        pixels_(pixels),
        fragments_(fragments),
        colors_(colors),
        isKeptApart_(target.background == Background::kKeepApart),
        offsets_(samplePositions(scene_.samples)),
        toView_(target.toView),
        layers_(target.layers)
  {
  }

  void writeRuns()
  {
    const auto samples = static_cast<std::uint8_t>(scene_.samples);
    for (std::size_t r = 0; r < fragments_.runCount; ++r) {
      const FragmentRun& run = fragments_.run[r];
      for (std::size_t pixel = run.pixel; pixel < std::size_t{run.pixel} + run.length; ++pixel) {
        // All samples have one owner: no names to compare.
        int nearest = 0;
        for (int s = 1; s < samples; ++s)
          if (tile_.depth[s][pixel] < tile_.depth[nearest][pixel]) nearest = s;
        SurfaceLayer layer = layerAt(pixel, nearest);
        layer.normal = normalOf(colors_.pixelNormal, pixel);
        layer.plane = normalOf(colors_.pixelPlane, pixel);
        layer.color = colors_.pixel[pixel];
        layer.count = layer.shared = layer.covered = samples;
        layer.other = kNobody;
        if (colors_.hasRadiance)
          layers_.radiance[indexOf(pixel)] = radianceOf(colors_.pixelRadiance, pixel);
        write(pixel, tile_.owner[nearest][pixel], layer);
      }
    }
  }

  void writeFragments()
  {
    for (std::size_t first = 0; first < fragments_.count;) {
      std::size_t end = first + 1;
      while (end < fragments_.count && fragments_.pixel[end] == fragments_.pixel[first])
        ++end;
      writePixel(first, end);
      first = end;
    }
  }

 private:
  /// Of the fragments [first, end), which are all of a pixel.
  void writePixel(std::size_t first, std::size_t end)
  {
    const std::size_t pixel = fragments_.pixel[first];
    const NearestSample nearest = nearestSample(clusters_, tile_, scene_.samples, pixel);
    std::size_t own = first;
    while (fragments_.owner[own] != nearest.owner)
      ++own;
    SurfaceLayer layer = layerAt(pixel, nearest.sample);
    layer.normal = normalOf(colors_.fragmentNormal, own);
    layer.plane = normalOf(colors_.fragmentPlane, own);
    layer.other = kNobody;
    ColorSum sum(scene_.resolve);
    Vec3f radiance = {0, 0, 0};
    std::uint32_t count = 0, covered = 0;
    for (std::size_t f = first; f < end; ++f) {
      const std::uint32_t samples = scene_.samples == 1 ? 1 : bitCount(fragments_.coverage[f]);
      covered += samples;
      if (f != own && !isSameLayer(layer, nearest.owner, f)) {
        if (layer.other == kNobody) layer.other = instanceOf(fragments_.owner[f]);
        continue;
      }
      sum.add(colors_.fragment[f], samples);
      if (colors_.hasRadiance)
        radiance = radiance + radianceOf(colors_.fragmentRadiance, f) * static_cast<float>(samples);
      count += samples;
    }
    layer.color = sum.mean();
    layer.count = static_cast<std::uint8_t>(count);
    layer.covered = static_cast<std::uint8_t>(covered);
    layer.shared = static_cast<std::uint8_t>(
        isKeptApart_ ? covered : static_cast<std::uint32_t>(scene_.samples));
    const auto n = static_cast<float>(count);
    if (colors_.hasRadiance)
      layers_.radiance[indexOf(pixel)] = {radiance.x / n, radiance.y / n, radiance.z / n};
    write(pixel, nearest.owner, layer);
  }

  bool isSameLayer(const SurfaceLayer& layer, std::uint32_t owner, std::size_t f) const
  {
    const PlacedInstance* const placed = clusters_.at(TileOwner::slot(owner)).placed;
    if (clusters_.at(TileOwner::slot(fragments_.owner[f])).placed != placed) return false;
    SurfaceLayer other =
        layerAt(fragments_.pixel[f],
                static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(fragments_.coverage[f])));
    other.plane = normalOf(colors_.fragmentPlane, f);
    return !PlaneDistances(layer, other)
                .areStep(stepTolerance(placed->instance->style, layer.point));
  }

  SurfaceLayer layerAt(std::size_t pixel, int sample) const
  {
    const SampleOffset offset = offsets_[static_cast<std::size_t>(sample)];
    const auto column = pixels_.x0 + static_cast<int>(pixel % kTileSide);
    const auto row = pixels_.y0 + static_cast<int>(pixel / kTileSide);
    SurfaceLayer layer;
    layer.x = static_cast<float>(column * kSubpixels + offset.x) * (1.0f / kSubpixels);
    layer.y = static_cast<float>(row * kSubpixels + offset.y) * (1.0f / kSubpixels);
    layer.point = toView_.at(layer.x, layer.y, tile_.depth[sample][pixel]);
    return layer;
  }
  std::size_t indexOf(std::size_t pixel) const
  {
    return layers_.indexOf(pixels_.x0 + static_cast<int>(pixel % kTileSide),
                           pixels_.y0 + static_cast<int>(pixel / kTileSide));
  }
  void write(std::size_t pixel, std::uint32_t owner, const SurfaceLayer& layer)
  {
    const std::size_t index = indexOf(pixel);
    layers_.instance[index] = instanceOf(owner);
    layers_.surface[index] = layer;
  }
  std::uint32_t instanceOf(std::uint32_t owner) const
  {
    const PlacedInstance* const placed = clusters_.at(TileOwner::slot(owner)).placed;
    return static_cast<std::uint32_t>(placed - clusters_.scene->instances.data());
  }
  static Vec3f normalOf(const VectorArrays& normals, std::size_t i)
  {
    return {normals.x[i], normals.y[i], normals.z[i]};
  }
  static Vec3f radianceOf(const RadianceArrays& radiance, std::size_t i)
  {
    return {radiance.r[i], radiance.g[i], radiance.b[i]};
  }

  const TileClusters& clusters_;
  const Scene& scene_;
  const VisibilityTile& tile_;
  const TileRectangle& pixels_;
  const FragmentList& fragments_;
  const TileColors& colors_;
  bool isKeptApart_;
  Span<const SampleOffset> offsets_;
  const ScreenToView& toView_;
  SurfaceLayers& layers_;
};

}  // namespace

void writeLayers(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const TileColors& colors, const LayerTarget& target)
{
  LayerWriter writer(clusters, tile, pixels, fragments, colors, target);
  writer.writeRuns();
  writer.writeFragments();
}

}  // namespace limn
