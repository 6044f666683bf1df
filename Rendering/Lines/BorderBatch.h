// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// A border counts for a pixel's distance from it as far as it lies along it by less than kSpan,
/// points the same way and is no other border's. At a corner no edge lies beside the pixel.
struct BorderRule {
  static constexpr float kSpan = 3.0f;
  static constexpr float kSameWay = 0.7f;
  static constexpr float kSameBorder = 1.0f;
  static constexpr float kBeside = 1.5f;
};

/// An edge near some pixels of a row.
struct BatchEdge {
  const EdgePoint* edge;
  std::int32_t rowsAway;  ///< not negative
};

/// Pixels of a row beside each other, one lane each, and what is asked of their borders: what
/// LineMeasure does pixel by pixel, operation by operation, as far as nothing is in the way.
struct alignas(64) BorderBatch {
  static constexpr int kPixels = 8;
  static constexpr std::int32_t kNoEdge = -1;

  // What is known of the pixels:
  std::int32_t reach[kPixels];  ///< of edges in rows and columns; -1: the pixel is left out
  std::int32_t instance[kPixels];
  float outside[kPixels];  ///< how far its centre may lie beyond an edge
  float width[kPixels];    ///< of the line
  float own[kPixels];      ///< the share of the pixel that may be covered

  // What findNearestEdges() finds:
  std::int32_t nearest[kPixels];    ///< the first of those as near as any; or kNoEdge
  std::int32_t haveParts[kPixels];  ///< not 0: some line near it is not drawn in full
  // What coverBorders() asks of pixels whose borders are to be covered, and finds:
  float normalX[kPixels], normalY[kPixels], footX[kPixels], footY[kPixels];  ///< of the nearest
  float share[kPixels];

  // Also known of the pixels:
  int x, y;                      ///< of the first
  std::vector<BatchEdge> edges;  ///< row by row, by columns; more than are near
};

/// Of each pixel the nearest edge of its instance.
void findNearestEdges(BorderBatch& batch);
/// How much of each pixel the lines cover, if its edge lies beside it and nothing parts it from
/// those around. The others' shares have no meaning.
void coverBorders(BorderBatch& batch);

}  // namespace limn
