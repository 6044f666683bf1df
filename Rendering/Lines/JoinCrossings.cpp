// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/JoinCrossings.h"

#include <algorithm>

namespace limn {
namespace {

const CreaseCrossing* crossingAt(const std::vector<CreaseCrossing>& crossings, int column)
{
  const auto found =
      std::lower_bound(crossings.begin(), crossings.end(), column,
                       [](const CreaseCrossing& one, int x) { return one.column < x; });
  return found != crossings.end() && found->column == column ? &*found : nullptr;
}

}  // namespace

void joinCrossings(const SurfaceLayers& layers, const CreaseRow& row, const CreaseRow& above,
                   CreaseRow& result)
{
  if (row.toRight.empty() && above.toRight.empty() && row.toAbove.empty()) return;
  std::vector<int> columns;
  for (const auto* crossings : {&row.toRight, &above.toRight, &row.toAbove})
    for (const CreaseCrossing& crossing : *crossings)
      columns.push_back(crossing.column);
  for (const CreaseCrossing& crossing : row.toAbove)
    if (crossing.column > 0) columns.push_back(crossing.column - 1);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  for (const int x : columns) {
    const CreaseCrossing* const sides[] = {crossingAt(row.toRight, x), crossingAt(row.toAbove, x),
                                           crossingAt(row.toAbove, x + 1),
                                           crossingAt(above.toRight, x)};
    const CreaseCrossing* met[4];
    int count = 0;
    for (const CreaseCrossing* side : sides)
      if (side != nullptr &&
          (count == 0 || layers.instance[side->index] == layers.instance[met[0]->index]))
        met[count++] = side;
    if (count == 0) continue;
    const std::uint32_t index = met[0]->index;
    const PixelPlace beside = {met[0]->column, static_cast<int>(index) / layers.width};
    const PixelPlace beyond = met[0]->neighbour;
    if (count <= 2) {
      result.segments.push_back({met[0]->place, met[count - 1]->place, x, index, beside, beyond});
      continue;
    }
    Vec2f middle = {0.0f, 0.0f};
    for (int i = 0; i < count; ++i)
      middle = middle + met[i]->place;
    middle = middle * (1.0f / static_cast<float>(count));
    for (int i = 0; i < count; ++i)
      result.segments.push_back({middle, met[i]->place, x, index, beside, beyond});
  }
}

}  // namespace limn
