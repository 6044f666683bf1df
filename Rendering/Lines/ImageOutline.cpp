// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ImageOutline.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Lines/FindEdges.h"
#include "Rendering/Lines/MeasureLines.h"
#include "Rendering/Lines/PaintLayer.h"

#include <algorithm>
#include <vector>

namespace limn {
namespace {

constexpr int kRowsPerTask = 8;

/// Calls body(first row, row after the last), rows in any order, on several threads.
template <class Body>
void forEachBand(int threads, int height, const Body& body)
{
  parallelFor(threads, static_cast<std::size_t>((height + kRowsPerTask - 1) / kRowsPerTask),
              [&](std::size_t task) {
                const int first = static_cast<int>(task) * kRowsPerTask;
                body(first, std::min(first + kRowsPerTask, height));
              });
}

/// Which pixels of a row have edges near enough to be lines.
class NearPixels {
 public:
  explicit NearPixels(int width) : isNear_(static_cast<std::size_t>(width)) {}

  void begin() { std::fill(isNear_.begin(), isNear_.end(), std::uint8_t{0}); }
  void add(int column, int reach)
  {
    const auto first = static_cast<std::size_t>(std::max(column - reach, 0));
    const auto end = std::min(static_cast<std::size_t>(column + reach) + 1, isNear_.size());
    std::fill(isNear_.begin() + static_cast<std::ptrdiff_t>(first),
              isNear_.begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{1});
  }
  bool operator[](int x) const { return isNear_[static_cast<std::size_t>(x)] != 0; }

 private:
  std::vector<std::uint8_t> isNear_;
};

}  // namespace

void beginLayers(const FrameView& frame, int threads, SurfaceLayers& layers)
{
  layers.width = frame.width;
  layers.height = frame.height;
  const std::size_t pixels =
      static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
  layers.instance.resize(pixels);
  layers.surface.resize(pixels);
  layers.radiance.resize(frame.radiance.empty() ? 0 : pixels);
  layers.halo.clear();
  forEachBand(threads, frame.height, [&](int first, int end) {
    std::fill(layers.instance.data() + layers.indexOf(0, first),
              layers.instance.data() + layers.indexOf(0, end), kNobody);
  });
}

void drawImageOutlines(const OutlinePass& pass)
{
  const SurfaceLayers& layers = pass.layers;
  const EdgeFinder finder(pass);
  const auto rows = static_cast<std::size_t>(layers.height);
  std::vector<EdgeRow> edges(rows);
  std::vector<CreaseRow> crossings(rows), creases(rows);
  forEachBand(pass.threads, layers.height, [&](int first, int end) {
    for (int y = first; y < end; ++y)
      finder.find(y, edges[static_cast<std::size_t>(y)], crossings[static_cast<std::size_t>(y)]);
  });
  forEachBand(pass.threads, layers.height, [&](int first, int end) {
    for (int y = first; y < std::min(end, layers.height - 1); ++y)
      joinCrossings(pass.layers, crossings[static_cast<std::size_t>(y)],
                    crossings[static_cast<std::size_t>(y) + 1],
                    creases[static_cast<std::size_t>(y)]);
  });

  int reach = 0;
  for (const Instance& instance : pass.scene.instances)
    if (hasImageOutline(instance)) reach = std::max(reach, reachOf(instance.style));
  const LineMeasure measure(pass, edges, creases);
  forEachBand(pass.threads, layers.height, [&](int first, int end) {
    NearPixels near(layers.width);
    for (int y = first; y < end; ++y) {
      near.begin();
      for (int row = std::max(y - reach, 0); row <= std::min(y + reach, layers.height - 1); ++row) {
        for (const EdgePoint& edge : edges[static_cast<std::size_t>(row)].points)
          near.add(edge.column, reach);
        for (const CreaseSegment& crease : creases[static_cast<std::size_t>(row)].segments)
          near.add(crease.column, reach);
      }
      for (int x = 0; x < layers.width; ++x) {
        if (!near[x]) continue;
        float share = measure.shareAt(x, y);
        if (!layers.halo.empty()) share *= 1.0f - layers.halo[layers.indexOf(x, y)];
        if (share > 0.0f) paintLine(pass, x, y, share);
      }
    }
  });
}

}  // namespace limn
