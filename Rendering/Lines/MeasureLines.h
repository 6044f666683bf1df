// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace limn {

/// How many pixels away from an edge its line may still cover a part of a pixel.
int reachOf(const Style& style);

/// Of all rows.
struct FoundLines {
  const EdgeFinder& finder;
  const std::vector<EdgeRow>& edges;
  const std::vector<CreaseRow>& creases;
  const StepGrid& steps;
};

/// How much of the pixels of a row lies in lines.
class LineMeasure {
 public:
  /// `reach` is the largest of any instance's style.
  LineMeasure(const OutlinePass& pass, const FoundLines& lines, int y, int reach);

  /// Of the pixel (x, y): 0 to 1; at most the share of its samples that show its layer. Requires:
  /// x is not below that of the last call.
  float shareAt(int x);
  /// Likewise, of what its layer does not show: lines of a surface that goes on beside the layer's
  /// border, as it is known from a pixel next to this one.
  float shareBehindAt(int x);

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
    PixelPlace place;
    Vec2f way;  ///< from the pixel's centre
  };

  struct NearCrease {
    const CreaseSegment* segment;
    Vec2f way;  ///< likewise, to its nearest point
  };

  void moveTo(int x);
  Pixel pixelAt(int x, std::uint32_t instance) const;
  std::optional<PixelPlace> placeBehind(int x) const;
  float linesShare(const Pixel& pixel);
  float withoutHalo(float share, PixelPlace place) const;
  /// The edges that may bound the pixel's surface, row by row, by columns.
  void findEdges(const Pixel& pixel);
  /// Of near_; if `isJoined` of those that are joined with the pixel.
  const NearEdge* nearestOf(const Pixel& pixel, bool isJoined) const;
  std::optional<NearCrease> nearestCrease(const Pixel& pixel, bool isJoined) const;
  bool areJoined(const Pixel& pixel, const CreaseSegment& segment) const;
  float borderShare(const Pixel& pixel);
  float creaseShare(const Pixel& pixel) const;

  const Scene& scene_;
  const SurfaceLayers& layers_;
  const EdgeFinder& finder_;
  const StepGrid& steps_;
  int y_, reach_;
  std::vector<NearRow> rows_;
  std::vector<NearEdge> near_;
};

}  // namespace limn
