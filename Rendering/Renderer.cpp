// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Renderer.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/FloatMode.h"
#include "Rendering/Binning/BinClusters.h"
#include "Rendering/CheckEffects.h"
#include "Rendering/CheckScene.h"
#include "Rendering/Lines/ApronDepths.h"
#include "Rendering/Lines/DrawStrokes.h"
#include "Rendering/Lines/ImageOutline.h"
#include "Rendering/Lines/Panes.h"
#include "Rendering/Lines/StrokePieces.h"
#include "Rendering/Lines/Veil.h"
#include "Rendering/Post/ClearPixels.h"
#include "Rendering/Post/CompositeTile.h"
#include "Rendering/Post/DrawCues.h"
#include "Rendering/Post/EffectPass.h"
#include "Rendering/Post/ResolveNormals.h"
#include "Rendering/Post/ResolveRadiance.h"
#include "Rendering/Post/ResolveTile.h"
#include "Rendering/Post/TileFrame.h"
#include "Rendering/Post/WriteLayers.h"
#include "Rendering/Raster/TranslucentTile.h"
#include "Rendering/Raster/VisibilityTile.h"
#include "Rendering/Reference/ReferenceEffects.h"
#include "Rendering/Reference/ReferenceRenderer.h"
#include "Rendering/Shading/Fragments.h"
#include "Rendering/Shading/TranslucentFragments.h"
#include "Rendering/Vertex/PlacedScene.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

namespace limn {
namespace {

/// What a thread needs for one tile; kept from frame to frame, so that no tile allocates.
struct TileMemory {
  alignas(64) Rgba8 runColor[kTilePixels];  ///< of tiles that are drawn in the frame itself
  FragmentShader shader;
  VisibilityTile visible;
  std::vector<TileCluster> ordered;
  TileColors colors;
  TileFrame fresh;
  FragmentList fragments;
};

TileMemory& tileMemory()
{
  thread_local const auto memory = std::make_unique<TileMemory>();
  return *memory;
}

/// Likewise, for tiles with translucent surfaces.
struct TranslucentMemory {
  TranslucentTile samples;
  TranslucentFragments fragments;
  TileCompositor compositor;
};

TranslucentMemory& translucentMemory()
{
  thread_local const auto memory = std::make_unique<TranslucentMemory>();
  return *memory;
}

/// What one tile adds to RenderStats.
struct TileStats {
  std::size_t occludedClusters = 0, truncatedPixels = 0;
};

class Stopwatch {
 public:
  double milliseconds() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

bool meet(const TileRectangle& a, const TileRectangle& b)
{
  return std::max(a.x0, b.x0) < std::min(a.x1, b.x1) && std::max(a.y0, b.y0) < std::min(a.y1, b.y1);
}

bool isToBeCleared(const FrameClear& clear, const TileRectangle& pixels,
                   const TileRectangle& touched)
{
  return clear.extent == FrameClear::Extent::kAll ||
         (clear.extent == FrameClear::Extent::kTouched && meet(pixels, touched));
}

/// The translucent surfaces of a tile: clusters from `firstSlot` on.
class TranslucentLayers {
 public:
  /// `panes`, or null, get them too.
  TranslucentLayers(const TileClusters& clusters, std::size_t firstSlot,
                    const TileRectangle& pixels, TilePanes* panes, TileMemory& opaque)
      : clusters_(clusters),
        firstSlot_(firstSlot),
        pixels_(pixels),
        samples_(clusters.scene->scene->samples),
        panes_(panes),
        opaque_(opaque)
  {
  }

  /// Returns the number of truncated pixels. The tile lies at `place` in the frame.
  std::size_t composite(const FrameView& frame, const TileRectangle& place, bool isVeiled)
  {
    memory_.compositor.begin(clusters_, place, opaque_.fragments, opaque_.colors, frame, isVeiled);
    return compositeRows({pixels_.y0, pixels_.y1});
  }
  void write() const { memory_.compositor.write(); }
  void veil(VeiledTile& veiled) const { memory_.compositor.veil(pixels_, veiled); }

 private:
  std::size_t compositeRows(TileRows rows)
  {
    memory_.samples.clear();
    rasterize(rows);
    std::size_t truncated = 0;
    if (memory_.samples.isOverfull()) {
      if (rows.end - rows.first > 1) {
        const int middle = (rows.first + rows.end) / 2;
        truncated += compositeRows({rows.first, middle});
        return truncated + compositeRows({middle, rows.end});
      }
      memory_.samples.keepNearest(clusters_, samples_);
      rasterize(rows);
      truncated = memory_.samples.settle();
    }
    memory_.fragments.collect(clusters_, samples_, memory_.samples,
                              panes_ != nullptr ? TranslucentFragments::Depths::kKept
                                                : TranslucentFragments::Depths::kForgotten);
    opaque_.shader.shade(clusters_, pixels_, samples_, memory_.fragments);
    memory_.compositor.add(memory_.fragments);
    if (panes_ != nullptr) panes_->add(clusters_, samples_, memory_.fragments);
    return truncated;
  }
  void rasterize(TileRows rows)
  {
    rasterizeTranslucent(clusters_, firstSlot_, pixels_, rows, samples_, opaque_.visible,
                         memory_.samples);
  }

  const TileClusters& clusters_;
  std::size_t firstSlot_;
  TileRectangle pixels_;
  int samples_;
  TilePanes* panes_;
  TileMemory& opaque_;
  TranslucentMemory& memory_ = translucentMemory();
};

void resolve(const TileClusters& clusters, const TileRectangle& pixels, const FrameView& frame,
             TileMemory& memory)
{
  if (memory.colors.hasRadiance)
    resolveRadiance(clusters, pixels, memory.fragments, memory.colors, frame);
  if (!frame.normal.empty())
    resolveNormals(clusters, memory.visible, pixels, memory.fragments, memory.colors, frame);
  resolveTile(clusters, memory.visible, pixels, memory.fragments, memory.colors, frame);
}

/// What passes over the finished picture need of it; any may be null.
struct PassInputs {
  const LayerTarget* surfaces;
  Veil* veil;
  Panes* panes;
};

/// Draws pixels of the viewport, which lie at `place` in the frame.
TileStats drawClusters(const PlacedScene& scene, const TileBins& bins, std::size_t tile,
                       const TileRectangle& pixels, const FrameView& frame,
                       const TileRectangle& place, PassInputs passes)
{
  const LayerTarget* const surfaces = passes.surfaces;
  const bool isVeiled = passes.veil != nullptr;
  TilePanes* const panes = passes.panes != nullptr && passes.panes->tile(tile).isReached()
                               ? &passes.panes->tile(tile)
                               : nullptr;
  const int samples = scene.scene->samples;
  TileMemory& memory = tileMemory();
  const std::size_t opaque = orderClusters(scene, bins, tile, memory.ordered);
  const TileClusters clusters = {&scene, memory.ordered};
  clearTile(frame, place, samples, memory.visible);
  TileStats stats;
  stats.occludedClusters =
      rasterizeTile({&scene, {memory.ordered.data(), opaque}}, pixels, samples, memory.visible);
  collectFragments(memory.visible, pixels, samples, scene.optimizations.fragmentRuns,
                   memory.fragments);
  memory.colors.hasColors = true;
  memory.colors.hasRadiance = !frame.radiance.empty();
  memory.colors.hasNormals = !frame.normal.empty() || surfaces != nullptr;
  memory.colors.hasPlanes = surfaces != nullptr;
  memory.shader.shade(clusters, pixels, samples, memory.fragments, memory.colors);
  const auto writeSurfaces = [&](const ResolvedTile* resolved) {
    if (surfaces != nullptr)
      writeLayers(clusters, memory.visible, pixels, memory.fragments, memory.colors, *surfaces,
                  resolved);
  };
  if (opaque == memory.ordered.size()) {
    resolve(clusters, place, frame, memory);
    const ResolvedTile resolved = {frame, place};
    writeSurfaces(&resolved);
    return stats;
  }
  writeSurfaces(nullptr);
  TranslucentLayers layers(clusters, opaque, pixels, panes, memory);
  stats.truncatedPixels = layers.composite(frame, place, isVeiled);
  resolve(clusters, place, frame, memory);
  if (isVeiled)
    layers.veil(passes.veil->tile(tile));
  else
    layers.write();
  return stats;
}

/// Whether pixels are among those touched, or next to them.
bool areNear(const TileRectangle& pixels, const TileRectangle& touched)
{
  return pixels.x0 <= touched.x1 && touched.x0 <= pixels.x1 && pixels.y0 <= touched.y1 &&
         touched.y0 <= pixels.y1;
}

/// The nearest depths of a tile beside the frame.
void writeDepths(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                 ApronDepths& around)
{
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    float* const row = around.at(pixels.x0, y);
    const int first = (y - pixels.y0) * kTileSide, width = pixels.x1 - pixels.x0;
    std::copy_n(tile.depth[0] + first, width, row);
    for (int s = 1; s < samples; ++s)
      for (int x = 0; x < width; ++x)
        row[x] = std::min(row[x], tile.depth[s][first + x]);
  }
}

/// Draws opaque surfaces beside the frame: their depths, and their layers unless `surfaces` is
/// null.
void drawApron(const PlacedScene& scene, const TileBins& bins, std::size_t tile,
               ApronDepths& around, const LayerTarget* surfaces)
{
  const TileRectangle pixels = bins.rectangle(tile);
  if (surfaces != nullptr && (surfaces->isWhole || areNear(pixels, bins.touchedWithApron))) {
    SurfaceLayers& layers = surfaces->layers;
    clearLayers(pixels, layers);
    for (int y = pixels.y0; y < pixels.y1; ++y)
      std::copy_n(around.at(pixels.x0, y), pixels.x1 - pixels.x0,
                  layers.depth.data() + layers.indexOf(pixels.x0, y));
  }
  if (bins.clustersOf(tile).empty()) return;
  const int samples = scene.scene->samples;
  TileMemory& memory = tileMemory();
  const std::size_t opaque = orderClusters(scene, bins, tile, memory.ordered);
  const TileClusters clusters = {&scene, {memory.ordered.data(), opaque}};
  clearTile({around.at(pixels.x0, pixels.y0), around.strideAt(pixels.y0)}, pixels, samples,
            memory.visible);
  rasterizeTile(clusters, pixels, samples, memory.visible);
  writeDepths(memory.visible, pixels, samples, around);
  if (surfaces == nullptr) return;
  collectFragments(memory.visible, pixels, samples, scene.optimizations.fragmentRuns,
                   memory.fragments);
  TileColors& colors = memory.colors;
  colors.pixel = memory.runColor;
  colors.hasColors = colors.hasRadiance = false;
  colors.hasNormals = colors.hasPlanes = true;
  memory.shader.shade(clusters, pixels, samples, memory.fragments, colors);
  writeLayers(clusters, memory.visible, pixels, memory.fragments, colors, *surfaces, nullptr);
}

TileStats drawTile(const PlacedScene& scene, const TileBins& bins, std::size_t tile,
                   const FrameView& frame, PassInputs passes)
{
  const LayerTarget* const layers = passes.surfaces;
  const TileRectangle pixels = bins.grid.rectangle(tile);
  const bool isEmpty = bins.clustersOf(tile).empty();
  if (layers != nullptr && (layers->isWhole || areNear(pixels, bins.touchedWithApron)))
    clearLayers(pixels, layers->layers);
  TileMemory& memory = tileMemory();
  memory.colors.pixel = memory.runColor;
  if (!isToBeCleared(frame.clear, pixels, bins.touched))
    return isEmpty ? TileStats{} : drawClusters(scene, bins, tile, pixels, frame, pixels, passes);
  if (isEmpty) {
    TileFrame::clear(frame, pixels);
    return {};
  }
  // What need not be mixed is drawn where it stays.
  TileFrame& fresh = memory.fresh;
  const FrameView& cleared =
      fresh.begin(frame, pixels, scene.scene->samples == 1 ? memory.visible.depth[0] : nullptr);
  memory.colors.pixel = cleared.color;
  const TileStats stats = drawClusters(scene, bins, tile, pixels, cleared, fresh.pixels(), passes);
  fresh.write();
  return stats;
}

void addTouched(const TileRectangle& more, TileRectangle& all)
{
  if (more.x0 >= more.x1 || more.y0 >= more.y1) return;
  if (all.x0 >= all.x1)
    all = more;
  else
    all = {std::min(all.x0, more.x0), std::min(all.y0, more.y0), std::max(all.x1, more.x1),
           std::max(all.y1, more.y1)};
}

PixelRectangle rectangleOf(const TileRectangle& pixels)
{
  return {pixels.x0, pixels.y0, pixels.x1, pixels.y1};
}

/// What is around the frame before anything is drawn.
ApronDepths& depthsAround(const FrameView& frame, int apron)
{
  thread_local ApronDepths depths;
  depths.begin(frame, apron);
  return depths;
}

/// Room for what the pixels show, if a pass over the finished picture asks for that.
std::optional<LayerTarget> layersFor(const Scene& scene, const FrameView& frame, int apron)
{
  const auto asks = [](const Instance& one) { return hasImageOutline(one) || hasCues(one); };
  if (std::none_of(scene.instances.begin(), scene.instances.end(), asks)) return {};
  thread_local SurfaceLayers layers;
  beginLayers(scene, frame, apron, layers);
  const bool isWhole = std::any_of(scene.instances.begin(), scene.instances.end(), hasCues);
  return LayerTarget{frame.background, layers, isWhole};
}

void countScene(const PlacedScene& scene, const TileBins& bins, RenderStats& stats)
{
  stats.instances = scene.instances.size();
  stats.clusters = scene.clusterCount;
  for (const PlacedInstance& placed : scene.instances) {
    stats.triangles += placed.mesh().triangleCount;
    stats.vertices += placed.mesh().vertexCount;
    stats.bytes += placed.mesh().bytes();
  }
  stats.binnedClusters = bins.cluster.size();
  stats.bytes +=
      bins.cluster.size() * sizeof(std::uint32_t) + scene.clusterCount * sizeof(ClusterBounds);
  if (bins.touched.x0 < bins.touched.x1) stats.touched = rectangleOf(bins.touched);
}

Status renderPipeline(const Scene& scene, const FrameView& frame, const RenderOptions& options,
                      RenderStats& stats)
{
  const Stopwatch binTime;
  const int apron = std::max({outlineApron(scene), haloApron(scene), strokeApron(scene)});
  const PlacedScene placed =
      placeScene(scene, {frame.width, frame.height, apron}, options.optimizations, options.threads);
  TileBins bins;
  if (Status status = binClusters(placed, options.threads, bins); !status.ok()) return status;
  const bool drawsStrokes = hasLines(scene);
  if (drawsStrokes)
    addTouched(boundStrokes(scene, frame.width, frame.height, options.threads), bins.touched);
  addTouched(bins.touched, bins.touchedWithApron);
  for (std::size_t tile = 0; tile < bins.count(); ++tile)
    if (bins.clustersOf(tile).size() > TileOwner::kMaxClustersPerTile)
      return {Error::kTooManyPrimitives,
              "More than 33554431 clusters meet one tile of 64 x 64 pixels; draw fewer meshes at "
              "once or a larger image."};
  stats.binMilliseconds = binTime.milliseconds();

  const Stopwatch tileTime;
  ApronDepths& around = depthsAround(frame, apron);
  const std::optional<LayerTarget> layers = layersFor(scene, frame, apron);
  const LayerTarget* const withApron = layers && layers->layers.apron > 0 ? &*layers : nullptr;
  std::optional<Veil> veil;
  if (Veil::isNeeded(scene, frame)) veil.emplace(bins.grid.count());
  std::optional<Panes> panes;
  const bool haveHalos = Panes::areBehindHalos(scene, frame);
  const bool areBeforeLines = Panes::areBeforeLines(scene, frame);
  if (haveHalos || areBeforeLines) panes.emplace(placed, bins, options.threads);
  const PassInputs passes = {layers ? &*layers : nullptr, veil ? &*veil : nullptr,
                             panes ? &*panes : nullptr};
  std::atomic<std::size_t> occluded = 0, truncated = 0;
  parallelFor(options.threads, bins.count(), [&](std::size_t tile) {
    if (tile >= bins.grid.count()) return drawApron(placed, bins, tile, around, withApron);
    const TileStats drawn = drawTile(placed, bins, tile, frame, passes);
    occluded.fetch_add(drawn.occludedClusters, std::memory_order_relaxed);
    truncated.fetch_add(drawn.truncatedPixels, std::memory_order_relaxed);
  });
  if (layers && bins.touched.x0 < bins.touched.x1) {
    const PixelRectangle touched = rectangleOf(bins.touched);
    if (std::any_of(scene.instances.begin(), scene.instances.end(), hasCues))
      drawCues({scene, frame, layers->layers, touched, options.threads});
    if (outlineApron(scene) > 0)
      drawImageOutlines(
          {scene, frame, layers->layers, rectangleOf(bins.touchedWithApron), options.threads});
  }
  if (veil && haveHalos) veil->addHalos(scene, layers->layers, bins.grid, *panes, options.threads);
  if (veil) veil->lay(frame, options.threads);
  if (drawsStrokes)
    drawStrokes({scene, frame, around, layers ? &layers->layers : nullptr,
                 areBeforeLines ? passes.panes : nullptr, options.threads});
  stats.occludedClusters = occluded;
  stats.truncatedPixels = truncated;
  stats.tileMilliseconds = tileTime.milliseconds();
  countScene(placed, bins, stats);
  return {};
}

}  // namespace

Status render(const Scene& scene, const FrameView& frame, const RenderOptions& options,
              RenderStats* stats)
{
  const FloatMode mode;
  if (Status status = checkScene(scene, frame, options.backend); !status.ok()) return status;
  if (frame.linePixels != nullptr) frame.linePixels->clear();
  RenderStats frameStats;
  if (options.backend == Backend::kReference) {
    const Stopwatch time;
    if (frame.clear.extent != FrameClear::Extent::kNothing)
      clearPixels(frame, {0, 0, frame.width, frame.height});
    frameStats.truncatedPixels = reference::render(scene, frame);
    frameStats.instances = scene.instances.size();
    for (const Instance& instance : scene.instances)
      frameStats.triangles += instance.mesh.triangles.size();
    frameStats.tileMilliseconds = time.milliseconds();
    frameStats.touched = {0, 0, frame.width, frame.height};
  } else if (Status status = renderPipeline(scene, frame, options, frameStats); !status.ok()) {
    return status;
  }
  if (stats != nullptr) *stats = frameStats;
  return {};
}

Status applyEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame,
                    EffectPlanes& planes, const RenderOptions& options)
{
  const FloatMode mode;
  if (Status status = checkEffects(effects, camera, frame); !status.ok()) return status;
  if (options.backend == Backend::kReference) {
    reference::applyEffects(effects, camera, frame);
    return {};
  }
  const EffectPass pass = {effects, frame, planes, options.threads};
  if (effects.needRadiance()) {
    exposeRadiance(pass);
    if (effects.depthOfField.aperture > 0)
      blurOutOfFocus(pass, thinLens(effects.depthOfField, camera, frame.height));
    if (effects.bloom.strength > 0) addBloom(pass);
    mapTones(pass);
  }
  if (effects.fxaa.enabled) smoothEdges(pass);
  return {};
}

}  // namespace limn
