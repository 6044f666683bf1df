// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/BorderBatch.h"
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
  const LayerRows<EdgeRow>& edges;
  const LayerRows<CreaseRow>& creases;
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
  /// A row near the pixel that has items, and those from the first on that may be near, too.
  template <class Item>
  struct NearRow {
    int y;
    const Item *at, *end;

    NearRow(int row, const std::vector<Item>& items)
        : y(row), at(items.data()), end(items.data() + items.size())
    {
    }
    void moveTo(int column)
    {
      while (at != end && at->column < column)
        ++at;
    }
  };
  struct NearEdge {
    const EdgePoint* edge;
    PixelPlace place;
    Vec2f way;  ///< from the pixel's centre
  };
  struct Behind {
    PixelPlace place;
    bool endsHere;  ///< the surface that it shows
  };

  struct NearCrease {
    const CreaseSegment* segment;
    Vec2f way;  ///< likewise, to its nearest point
  };

  void moveTo(int x);
  Pixel pixelAt(int x, std::uint32_t instance) const;
  std::optional<Behind> placeBehind(int x) const;
  float linesShare(const Pixel& pixel, float border) const;
  float withoutHalo(float share, PixelPlace place) const;
  /// The edges that may bound the pixel's surface, row by row, by columns.
  void findEdges(const Pixel& pixel);
  /// Of near_, of those that are joined with the pixel.
  const NearEdge* nearestJoined(const Pixel& pixel) const;
  bool isBeyondEnd(const Pixel& pixel, const NearEdge& nearest, bool areAlone) const;
  bool isHiddenBeyond(const Pixel& pixel, const NearEdge& nearest) const;
  float capShare(const Pixel& pixel, const NearEdge& nearest) const;
  std::optional<NearCrease> nearestCrease(const Pixel& pixel, bool isJoined) const;
  bool areJoined(const Pixel& pixel, const CreaseSegment& segment) const;
  float borderShare(const Pixel& pixel);
  /// Measures the borders of pixels from x on, as far as that can be done of several at once.
  void measureBatch(int x);
  void addToBatch(int lane, std::size_t index);
  void gatherEdges();
  bool isBeside(int lane) const;
  float outsideOf(const Pixel& pixel, const NearEdge& edge) const;
  float creaseShare(const Pixel& pixel) const;

  BorderBatch batch_ = {};
  const Scene& scene_;
  const SurfaceLayers& layers_;
  const EdgeFinder& finder_;
  const StepGrid& steps_;
  int y_, reach_;
  int end_;  ///< pixels from here on may have no layers
  std::vector<NearRow<EdgePoint>> edgeRows_;
  std::vector<NearRow<CreaseSegment>> creaseRows_;
  std::vector<NearEdge> near_;
  std::size_t nearest_ = 0;  ///< of near_, the first whose line is nearest
  bool haveParts_ = false;   ///< some of near_ are of lines that have another surface's part, too
  int batchEnd_;             ///< the pixel after the batch's last
  bool isMeasured_[BorderBatch::kPixels];  ///< share is borderShare()
};

}  // namespace limn
