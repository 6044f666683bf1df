// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ImageOutline.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Lines/DropShortCreases.h"
#include "Rendering/Lines/DropSpecks.h"
#include "Rendering/Lines/FindEdges.h"
#include "Rendering/Lines/JoinCrossings.h"
#include "Rendering/Lines/MeasureLines.h"
#include "Rendering/Lines/PaintLayer.h"
#include "Rendering/Lines/StraightenEnds.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace limn {
namespace {

constexpr int kRowsPerTask = 16;

/// Calls body(first row, row after the last), rows in any order, on several threads.
template <class Body>
void forEachBand(const OutlinePass& pass, const Body& body)
{
  const int y0 = pass.touched.y0, rows = pass.touched.y1 - y0;
  parallelFor(pass.threads, static_cast<std::size_t>((rows + kRowsPerTask - 1) / kRowsPerTask),
              [&](std::size_t task) {
                const int first = y0 + static_cast<int>(task) * kRowsPerTask;
                body(first, std::min(first + kRowsPerTask, pass.touched.y1));
              });
}

/// By rows; kept from frame to frame for their memory.
struct LineRows {
  LayerRows<EdgeRow> edges;
  LayerRows<CreaseRow> crossings, creases;
  StepGrid steps;

  void begin(const SurfaceLayers& layers)
  {
    steps.begin(layers);
    edges.begin(layers);
    crossings.begin(layers);
    creases.begin(layers);
    for (EdgeRow& row : edges.all())
      row.points.clear();
    for (LayerRows<CreaseRow>* some : {&crossings, &creases})
      for (CreaseRow& row : some->all()) {
        row.toRight.clear();
        row.toAbove.clear();
        row.segments.clear();
      }
  }
};

/// Which pixels of a row have edges near enough to be lines.
class NearPixels {
 public:
  /// Of the pixels [x0, x1).
  NearPixels(int x0, int x1) : x0_(x0), isNear_(static_cast<std::size_t>(x1 - x0)) {}

  void begin() { std::fill(isNear_.begin(), isNear_.end(), std::uint8_t{0}); }
  void add(int column, int reach)
  {
    const int first = std::max(column - reach - x0_, 0);
    const int end = std::min(column + reach + 1 - x0_, static_cast<int>(isNear_.size()));
    if (first < end) std::memset(isNear_.data() + first, 1, static_cast<std::size_t>(end - first));
  }
  /// Calls visit(x) from left to right.
  template <class Visit>
  void forEach(Visit visit) const
  {
    const std::uint8_t *const begin = isNear_.data(), *const end = begin + isNear_.size();
    for (const std::uint8_t* at = begin; at != end; ++at) {
      at = static_cast<const std::uint8_t*>(std::memchr(at, 1, static_cast<std::size_t>(end - at)));
      if (at == nullptr) return;
      visit(x0_ + static_cast<int>(at - begin));
    }
  }

 private:
  int x0_;
  std::vector<std::uint8_t> isNear_;
};

}  // namespace

void beginLayers(const Scene& scene, const FrameView& frame, int apron, SurfaceLayers& layers)
{
  layers.width = frame.width;
  layers.height = frame.height;
  layers.apron = outlineApron(scene) > 0 || haloApron(scene) > 0 ? apron : 0;
  layers.offsets = samplePositions(scene.samples);
  layers.toView.emplace(scene.camera, frame.width, frame.height);
  const std::size_t pixels = layers.indexOf(-layers.apron, layers.endY());
  const std::size_t room = pixels + SurfaceLayers::kSpare;
  layers.instance.resize(room);
  const bool isSingle = scene.samples == 1;
  // Until all of them are there, none counts: memory may run out.
  const bool wasSingle = layers.isSingle;
  layers.isSingle = false;
  if (isSingle && (!wasSingle || layers.sample.size() < room)) {
    layers.sample.assign(room, 0);
    layers.count.assign(room, 1);
    layers.shared.assign(room, 1);
    layers.covered.assign(room, 1);
  } else if (!isSingle) {
    for (Array<std::uint8_t>* bytes :
         {&layers.sample, &layers.count, &layers.shared, &layers.covered})
      bytes->resize(room);
    layers.other.resize(room);
  }
  layers.isSingle = isSingle;
  layers.depth.resize(room);
  layers.normal.resize(room);
  layers.plane.resize(room);
  layers.color.resize(room);
  layers.radiance.resize(frame.radiance.empty() ? 0 : pixels);
  layers.halo.clear();
  layers.haloOwner.clear();
  layers.hasIds = std::any_of(scene.instances.begin(), scene.instances.end(), hasIdBorders);
  layers.id.resize(layers.hasIds ? room : 0);
  layers.idSamples.resize(layers.hasIds ? room : 0);
}

void drawImageOutlines(const OutlinePass& pass)
{
  const SurfaceLayers& layers = pass.layers;
  const EdgeFinder finder(pass);
  thread_local LineRows memory;
  memory.begin(layers);
  LayerRows<EdgeRow>& edges = memory.edges;
  LayerRows<CreaseRow>&crossings = memory.crossings, &creases = memory.creases;
  StepGrid& steps = memory.steps;
  forEachBand(pass, [&](int first, int end) {
    NeighbourRows neighbours(layers, finder.bounds(), pass.scene.samples, pass.touched);
    for (int y = first; y < end; ++y)
      finder.find(y, neighbours.marksOf(y), edges[y], crossings[y], steps);
  });
  dropSpecks(layers, crossings, edges, steps);
  dropShortCreases(layers, edges, crossings);
  forEachBand(pass, [&](int first, int end) {
    for (int y = first; y < end; ++y)
      straightenEnds(steps, y, edges);
    const int from = first == pass.touched.y0 ? std::max(first - 1, crossings.first()) : first;
    for (int y = from; y < std::min(end, crossings.end() - 1); ++y)
      joinCrossings(pass, finder, crossings[y], crossings[y + 1], creases[y]);
  });

  int reach = 0;
  for (const Instance& instance : pass.scene.instances)
    if (hasImageOutline(instance)) reach = std::max(reach, reachOf(instance.style));
  forEachBand(pass, [&](int first, int end) {
    NearPixels near(std::max(pass.touched.x0, 0), std::min(pass.touched.x1, layers.width));
    for (int y = std::max(first, 0); y < std::min(end, layers.height); ++y) {
      near.begin();
      const int lastRow = std::min(y + reach, edges.end() - 1);
      for (int row = std::max(y - reach, edges.first()); row <= lastRow; ++row) {
        for (const EdgePoint& edge : edges[row].points)
          near.add(edge.column, reach);
        for (const CreaseSegment& crease : creases[row].segments)
          near.add(crease.column, reach);
      }
      LineMeasure measure(pass, {finder, edges, creases, steps}, y, reach);
      near.forEach([&](int x) {
        const float share = measure.shareAt(x), behind = measure.shareBehindAt(x);
        if (behind > 0.0f) paintLineBehind(pass, x, y, behind);
        if (share > 0.0f) paintLine(pass, x, y, share);
      });
    }
  });
}

}  // namespace limn
