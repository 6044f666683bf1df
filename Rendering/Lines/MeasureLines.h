// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// How many pixels away from an edge its line may still cover a part of a pixel.
int reachOf(const Style& style);

/// How much of the pixels of a row lies in lines.
class LineMeasure {
 public:
  /// `edges` and `creases` are all rows'; `reach` is the largest of any instance's style.
  LineMeasure(const OutlinePass& pass, const std::vector<EdgeRow>& edges,
              const std::vector<CreaseRow>& creases, int y, int reach);

  /// Of the pixel (x, y): 0 to 1; at most the share of its samples that show its layer. Requires:
  /// x is not below that of the last call.
  float shareAt(int x);

 private:
  struct Pixel;
  /// Rows near the pixel, and their first items that may be near, too.
  struct NearRow {
    int y;
    const EdgePoint *edge, *lastEdge;
    const CreaseSegment *segment, *lastSegment;
  };
  struct NearEdge {
    const EdgePoint* edge;
    Vec2f way;  ///< from the pixel's centre
  };

  void moveTo(int x);
  /// The edges that bound the pixel's surface, row by row, by columns.
  void findEdges(const Pixel& pixel);
  bool areJoined(const Pixel& pixel, const SurfacePatch& there, float tolerance) const;
  bool areJoined(const Pixel& pixel, const CreaseSegment& segment) const;
  float borderShare(const Pixel& pixel);
  float creaseShare(const Pixel& pixel) const;

  const Scene& scene_;
  const SurfaceLayers& layers_;
  int y_, reach_;
  std::vector<NearRow> rows_;
  std::vector<NearEdge> near_;
};

}  // namespace limn
