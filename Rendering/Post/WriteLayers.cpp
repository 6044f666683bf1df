// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/WriteLayers.h"

#include "Rendering/Base/BitCount.h"
#include "Rendering/Post/ColorSum.h"
#include "Rendering/Post/NearestSample.h"
#include "Rendering/Post/TilePlace.h"

#include <hwy/base.h>

#include <algorithm>
#include <cstring>

namespace limn {
namespace {

/// The layers of one tile.
class LayerWriter {
 public:
  LayerWriter(const TileClusters& clusters, const VisibilityTile& tile, const TileRectangle& pixels,
              const FragmentList& fragments, const TileColors& colors, const LayerTarget& target,
              const ResolvedTile* resolved)
      : clusters_(clusters),
        scene_(*clusters.scene->scene),
        tile_(tile),
        pixels_(pixels),
        fragments_(fragments),
        colors_(colors),
        isAlone_(clusters.scene->instances.size() == 1),
        isKeptApart_(target.background == Background::kKeepApart),
        allSamples_(static_cast<std::uint8_t>(scene_.samples)),
        resolved_(resolved),
        layers_(target.layers)
  {
  }

  void writeRuns()
  {
    for (std::size_t r = 0; r < fragments_.runCount; ++r) {
      const FragmentRun& run = fragments_.run[r];
      if (run.length == 0) continue;
      const std::size_t index = indexOf(run.pixel), length = run.length;
      if (isAlone_)
        setLone(index, length);
      else
        std::fill_n(layers_.instance.data() + index, length, instanceOf(tile_.owner[0][run.pixel]));
      copyVectors(colors_.pixelNormal, run.pixel, length, layers_.normal, index);
      copyVectors(colors_.pixelPlane, run.pixel, length, layers_.plane, index);
      if (colors_.hasColors)
        std::copy_n(colors_.pixel + run.pixel, length, layers_.color.data() + index);
      writeNearest(run, index);
      for (std::size_t i = 0; colors_.hasRadiance && i < length; ++i)
        layers_.radiance[index + i] = radianceOf(colors_.pixelRadiance, run.pixel + i);
    }
  }

  void writeFragments()
  {
    if (scene_.samples == 1) return writeSingles();
    for (std::size_t first = 0; first < fragments_.count;) {
      const std::uint32_t pixel = fragments_.pixel[first];
      std::size_t end = first + 1;
      while (end < fragments_.count && fragments_.pixel[end] == pixel)
        ++end;
      if (end - first == 1)
        writeAlone(first);
      else
        writePixel(first, end);
      first = end;
    }
  }

  /// SurfaceLayers::id, of what the two above have written.
  void writeIds()
  {
    for (std::size_t r = 0; r < fragments_.runCount; ++r) {
      const FragmentRun& run = fragments_.run[r];
      if (run.length == 0) continue;
      const std::size_t index = indexOf(run.pixel), length = run.length;
      std::fill_n(layers_.id.data() + index, length, idOf(tile_.owner[0][run.pixel]));
      std::fill_n(layers_.idSamples.data() + index, length, allSamples_);
    }
    for (std::size_t first = 0; first < fragments_.count;) {
      std::size_t end = first + 1;
      while (end < fragments_.count && fragments_.pixel[end] == fragments_.pixel[first])
        ++end;
      writeId(first, end);
      first = end;
    }
  }

 private:
  struct Sample {
    int number;
    float depth;
  };

  /// Of a run's pixels, all samples of which have one owner: no names to compare.
  void writeNearest(const FragmentRun& run, std::size_t index)
  {
    const std::size_t length = run.length;
    if (scene_.samples == 1) {
      std::copy_n(tile_.depth[0] + run.pixel, length, layers_.depth.data() + index);
      return;
    }
    std::fill_n(layers_.count.data() + index, length, allSamples_);
    std::fill_n(layers_.shared.data() + index, length, allSamples_);
    std::fill_n(layers_.covered.data() + index, length, allSamples_);
    for (std::size_t i = 0; i < length; ++i)
      setSample(index + i, nearestOf((1u << scene_.samples) - 1u, run.pixel + i));
  }

  /// Of some of a pixel's samples, which have one owner: the first nearest.
  Sample nearestOf(std::uint32_t coverage, std::size_t pixel) const
  {
    const auto first = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(coverage));
    Sample nearest = {first, tile_.depth[first][pixel]};
    for (int s = first + 1; s < scene_.samples; ++s)
      if ((coverage >> s & 1u) != 0 && tile_.depth[s][pixel] < nearest.depth)
        nearest = {s, tile_.depth[s][pixel]};
    return nearest;
  }

  /// With one sample a pixel: stretches of fragments whose pixels lie beside each other.
  void writeSingles()
  {
    const std::uint32_t* const pixel = fragments_.pixel.data();
    const std::size_t count = fragments_.count;
    for (std::size_t first = 0; first < count;) {
      const std::size_t toRowsEnd = kTileSide - pixel[first] % kTileSide;
      const std::size_t most = std::min(count, first + toRowsEnd);
      std::size_t end = first + 1;
      while (end < most && pixel[end] == pixel[end - 1] + 1)
        ++end;
      writeStretch(first, end - first);
      first = end;
    }
  }
  void writeStretch(std::size_t first, std::size_t length)
  {
    const std::size_t pixel = fragments_.pixel[first], index = indexOf(pixel);
    if (isAlone_)
      setLone(index, length);
    else
      setInstances(first, length, index);
    std::copy_n(tile_.depth[0] + pixel, length, layers_.depth.data() + index);
    if (colors_.hasColors)
      std::copy_n(colors_.fragment.data() + first, length, layers_.color.data() + index);
    copyVectors(colors_.fragmentNormal, first, length, layers_.normal, index);
    copyVectors(colors_.fragmentPlane, first, length, layers_.plane, index);
    for (std::size_t i = 0; colors_.hasRadiance && i < length; ++i)
      layers_.radiance[index + i] = radianceOf(colors_.fragmentRadiance, first + i);
  }

  /// Of the scene's only instance. Not by a loop of the compiler's, which would not go by vectors.
  void setLone(std::size_t index, std::size_t length)
  {
    std::memset(layers_.instance.data() + index, 0, length * sizeof(std::uint32_t));
  }
  void setInstances(std::size_t first, std::size_t length, std::size_t index)
  {
    std::uint32_t* const instance = layers_.instance.data() + index;
    std::uint32_t owner = fragments_.owner[first], number = instanceOf(owner);
    for (std::size_t i = 0; i < length; ++i) {
      const std::uint32_t next = fragments_.owner[first + i];
      if (TileOwner::slot(next) != TileOwner::slot(owner)) number = instanceOf(next);
      owner = next;
      instance[i] = number;
    }
  }

  /// Of a pixel that shows one triangle and nothing else.
  void writeAlone(std::size_t f)
  {
    const std::size_t pixel = fragments_.pixel[f];
    const std::size_t index = indexOf(pixel);
    const std::uint32_t coverage = fragments_.coverage[f];
    setSample(index, nearestOf(coverage, pixel));
    const std::uint32_t samples = bitCount(coverage);
    setCounts(index, samples, samples);
    setSurface(index, fragments_.owner[f], f);
    if (colors_.hasColors) layers_.color[index] = colors_.fragment[f];
    if (!colors_.hasRadiance) return;
    const auto n = static_cast<float>(samples);
    const Vec3f sum = radianceOf(colors_.fragmentRadiance, f) * n;
    layers_.radiance[index] = {sum.x / n, sum.y / n, sum.z / n};
  }

  /// Of the fragments [first, end), which are all of a pixel.
  void writePixel(std::size_t first, std::size_t end)
  {
    const std::size_t pixel = fragments_.pixel[first];
    const std::size_t index = indexOf(pixel);
    const NearestSample nearest = nearestSample(clusters_, tile_, scene_.samples, pixel);
    std::size_t own = first;
    while (fragments_.owner[own] != nearest.owner)
      ++own;
    setSample(index, {nearest.sample, nearest.depth});
    setSurface(index, nearest.owner, own);
    layers_.other[index] = kNobody;
    const SurfacePatch layer = layers_.patchAt(columnOf(pixel), rowOf(pixel));
    ColorSum sum(scene_.resolve);
    Vec3f radiance = {0, 0, 0};
    std::uint32_t count = 0, covered = 0;
    for (std::size_t f = first; f < end; ++f) {
      const std::uint32_t samples = bitCount(fragments_.coverage[f]);
      covered += samples;
      if (f != own && !isSameLayer(layer, nearest.owner, f)) {
        std::uint32_t& other = layers_.other[index];
        if (other == kNobody) other = instanceOf(fragments_.owner[f]);
        continue;
      }
      if (colors_.hasColors) sum.add(colors_.fragment[f], samples);
      if (colors_.hasRadiance)
        radiance = radiance + radianceOf(colors_.fragmentRadiance, f) * static_cast<float>(samples);
      count += samples;
    }
    if (colors_.hasColors)
      layers_.color[index] =
          resolved_ != nullptr && count == allSamples_ ? resolvedAt(pixel) : sum.mean();
    setCounts(index, count, covered);
    const auto n = static_cast<float>(count);
    if (colors_.hasRadiance)
      layers_.radiance[index] = {radiance.x / n, radiance.y / n, radiance.z / n};
  }

  /// Of the fragments [first, end), which are all of a pixel.
  void writeId(std::size_t first, std::size_t end)
  {
    const std::size_t pixel = fragments_.pixel[first], index = indexOf(pixel);
    layers_.id[index] = idOf(fragments_.owner[first]);
    layers_.idSamples[index] = layers_.count[index];
    if (end - first > 1) writeMixedId(first, end, index);
  }
  void writeMixedId(std::size_t first, std::size_t end, std::size_t index)
  {
    const std::size_t pixel = fragments_.pixel[first];
    const std::uint32_t nearest = nearestSample(clusters_, tile_, scene_.samples, pixel).owner;
    const SurfacePatch layer = layers_.patchAt(columnOf(pixel), rowOf(pixel));
    // By ids, in the order of the first samples that show them.
    std::uint32_t ids[kMaxSamples], samples[kMaxSamples];
    int count = 0;
    for (std::size_t f = first; f < end; ++f) {
      const std::uint32_t owner = fragments_.owner[f];
      if (owner != nearest && !isSameLayer(layer, nearest, f)) continue;
      const std::uint32_t id = idOf(owner);
      const int at = static_cast<int>(std::find(ids, ids + count, id) - ids);
      if (at == count) {
        ids[count] = id;
        samples[count++] = 0;
      }
      samples[at] += bitCount(fragments_.coverage[f]);
    }
    const auto most = std::max_element(samples, samples + count) - samples;
    layers_.id[index] = ids[most];
    layers_.idSamples[index] = static_cast<std::uint8_t>(samples[most]);
  }
  std::uint32_t idOf(std::uint32_t owner) const
  {
    const PlacedCluster cluster = clusters_.at(TileOwner::slot(owner));
    const Instance& instance = *cluster.placed->instance;
    if (!hasIdBorders(instance)) return 0;
    const std::uint32_t triangle = cluster.meshTriangle(TileOwner::triangle(owner));
    const Attributes& attributes = instance.attributes;
    return attributes.cellIds[attributes.cells.empty() ? triangle : attributes.cells[triangle]];
  }

  bool isSameLayer(const SurfacePatch& layer, std::uint32_t owner, std::size_t f) const
  {
    const PlacedInstance* const placed = placedOf(owner);
    if (placedOf(fragments_.owner[f]) != placed) return false;
    const std::size_t pixel = fragments_.pixel[f];
    const std::size_t sample = hwy::Num0BitsBelowLS1Bit_Nonzero32(fragments_.coverage[f]);
    const SampleOffset offset = layers_.offsets[sample];
    SurfacePatch other;
    other.x = static_cast<float>(columnOf(pixel) * kSubpixels + offset.x) * (1.0f / kSubpixels);
    other.y = static_cast<float>(rowOf(pixel) * kSubpixels + offset.y) * (1.0f / kSubpixels);
    other.point = layers_.toView->at(other.x, other.y, tile_.depth[sample][pixel]);
    other.plane = vectorOf(colors_.fragmentPlane, f);
    const PlaneDistances distances(layer, other);
    const float tolerance = stepTolerance(placed->instance->style, layer.point);
    return !distances.areStep(tolerance) || distances.areGroove(tolerance);
  }

  void setSample(std::size_t index, Sample nearest)
  {
    layers_.sample[index] = static_cast<std::uint8_t>(nearest.number);
    layers_.depth[index] = nearest.depth;
  }
  void setCounts(std::size_t index, std::uint32_t count, std::uint32_t covered)
  {
    layers_.count[index] = static_cast<std::uint8_t>(count);
    layers_.covered[index] = static_cast<std::uint8_t>(covered);
    layers_.shared[index] = isKeptApart_ ? static_cast<std::uint8_t>(covered) : allSamples_;
  }
  void setSurface(std::size_t index, std::uint32_t owner, std::size_t f)
  {
    layers_.instance[index] = instanceOf(owner);
    const auto set = [&](const VectorArrays& from, LayerVectors& to) {
      to.x[index] = from.x[f];
      to.y[index] = from.y[f];
      to.z[index] = from.z[f];
    };
    set(colors_.fragmentNormal, layers_.normal);
    set(colors_.fragmentPlane, layers_.plane);
  }

  /// The mean of all of a pixel's samples.
  Rgba8 resolvedAt(std::size_t pixel) const
  {
    return resolved_->frame.color[TilePlace(resolved_->pixels, resolved_->frame).indexOf(pixel)];
  }

  int columnOf(std::size_t pixel) const { return pixels_.x0 + static_cast<int>(pixel % kTileSide); }
  int rowOf(std::size_t pixel) const { return pixels_.y0 + static_cast<int>(pixel / kTileSide); }
  std::size_t indexOf(std::size_t pixel) const
  {
    return layers_.indexOf(columnOf(pixel), rowOf(pixel));
  }
  const PlacedInstance* placedOf(std::uint32_t owner) const
  {
    return clusters_.at(TileOwner::slot(owner)).placed;
  }
  std::uint32_t instanceOf(std::uint32_t owner) const
  {
    return static_cast<std::uint32_t>(placedOf(owner) - clusters_.scene->instances.data());
  }
  static void copyVectors(const VectorArrays& from, std::size_t i, std::size_t count,
                          LayerVectors& to, std::size_t index)
  {
    std::copy_n(from.x.data() + i, count, to.x.data() + index);
    std::copy_n(from.y.data() + i, count, to.y.data() + index);
    std::copy_n(from.z.data() + i, count, to.z.data() + index);
  }
  static Vec3f vectorOf(const VectorArrays& vectors, std::size_t i)
  {
    return {vectors.x[i], vectors.y[i], vectors.z[i]};
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
  bool isAlone_, isKeptApart_;
  std::uint8_t allSamples_;
  const ResolvedTile* resolved_;
  SurfaceLayers& layers_;
};

}  // namespace

void clearLayers(const TileRectangle& pixels, SurfaceLayers& layers)
{
  static_assert(kNobody == 0xFFFFFFFFu, "bytes of 0xFF");
  for (int y = pixels.y0; y < pixels.y1; ++y)
    std::memset(layers.instance.data() + layers.indexOf(pixels.x0, y), 0xFF,
                static_cast<std::size_t>(pixels.x1 - pixels.x0) * sizeof(std::uint32_t));
}

void writeLayers(const TileClusters& clusters, const VisibilityTile& tile,
                 const TileRectangle& pixels, const FragmentList& fragments,
                 const TileColors& colors, const LayerTarget& target, const ResolvedTile* resolved)
{
  LayerWriter writer(clusters, tile, pixels, fragments, colors, target, resolved);
  writer.writeRuns();
  writer.writeFragments();
  if (target.layers.hasIds) writer.writeIds();
}

}  // namespace limn
