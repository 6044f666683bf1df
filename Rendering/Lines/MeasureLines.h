// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <cstddef>
#include <vector>

namespace limn {

/// How many pixels away from an edge its line may still cover a part of a pixel.
int reachOf(const Style& style);

/// How much of a pixel lies in a line.
class LineMeasure {
 public:
  /// All of them by rows.
  LineMeasure(const OutlinePass& pass, const std::vector<EdgeRow>& edges,
              const std::vector<CreaseRow>& creases)
      : scene_(pass.scene), layers_(pass.layers), edges_(edges), creases_(creases)
  {
  }

  /// 0 to 1; at most the share of the pixel's samples that show its layer.
  float shareAt(int x, int y) const;

 private:
  struct Pixel;

  /// Calls visit(edge) for the edges that bound the pixel's surface, row by row, by columns.
  template <class Visit>
  void forEachEdge(const Pixel& pixel, Visit visit) const;
  bool areJoined(const Pixel& pixel, std::size_t index) const;
  float borderShare(const Pixel& pixel) const;
  float creaseShare(const Pixel& pixel) const;

  const Scene& scene_;
  const SurfaceLayers& layers_;
  const std::vector<EdgeRow>& edges_;
  const std::vector<CreaseRow>& creases_;
};

}  // namespace limn
