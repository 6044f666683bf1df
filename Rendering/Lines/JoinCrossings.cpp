// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/JoinCrossings.h"

#include "Rendering/Lines/CrossingSquares.h"

namespace limn {
namespace {

/// From the sides of a square into it: below, left, right, above.
constexpr PixelPlace kInwards[] = {{0, 1}, {1, 0}, {-1, 0}, {0, -1}};

/// Crossings of one square and of the same instance.
void joinAlike(const OutlinePass& pass, const CreaseCrossing* const* met, int count, int column,
               std::vector<CreaseSegment>& segments)
{
  const CreaseCrossing& first = *met[0];
  const PixelPlace beside = pass.layers.pixelOf(first.index);
  const auto add = [&](Vec2f from, Vec2f to) {
    segments.push_back({from, to, column, first.instance, beside, first.neighbour});
  };
  if (count <= 2) {
    add(first.place, met[count - 1]->place);
    return;
  }
  Vec2f middle = {0.0f, 0.0f};
  for (int i = 0; i < count; ++i)
    middle = middle + met[i]->place;
  middle = middle * (1.0f / static_cast<float>(count));
  for (int i = 0; i < count; ++i)
    add(middle, met[i]->place);
}

}  // namespace

void joinCrossings(const OutlinePass& pass, const EdgeFinder& finder, const CreaseRow& row,
                   const CreaseRow& above, CreaseRow& result)
{
  forEachSquare(row, above, -pass.layers.apron, [&](int column, const SquareSides& sides) {
    const CreaseCrossing* rest[] = {sides.below, sides.left, sides.right, sides.above};
    for (int i = 0; i < 4; ++i) {
      if (rest[i] == nullptr) continue;
      const CreaseCrossing* met[4];
      int count = 0;
      for (int k = i; k < 4; ++k) {
        if (rest[k] == nullptr || !(k == i || rest[k]->instance == rest[i]->instance)) continue;
        met[count++] = rest[k];
        if (k > i) rest[k] = nullptr;
      }
      joinAlike(pass, met, count, column, result.segments);
      if (count > 1) continue;
      CreaseSegment& only = result.segments.back();
      only.to = finder.endBehind(*met[0], kInwards[i]);
    }
  });
}

}  // namespace limn
