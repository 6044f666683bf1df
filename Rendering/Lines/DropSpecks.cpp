// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/DropSpecks.h"

#include "Rendering/Base/Components.h"

#include <algorithm>
#include <cstdint>

namespace limn {
namespace {

/// Joins a row's edges to each other and to those of the row below, which come before them; not
/// those of what pixels do not show, which are at borders.
void joinRow(const SurfaceLayers& layers, const std::vector<EdgePoint>& row, std::size_t first,
             const std::vector<EdgePoint>& below, Components& components)
{
  const auto areAlike = [&](const EdgePoint& a, const EdgePoint& b) {
    return a.instance == b.instance && layers.instance[a.index] == a.instance &&
           layers.instance[b.index] == b.instance;
  };
  const std::size_t firstBelow = first - below.size();
  std::size_t b = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (std::size_t k = i; k > 0 && row[k - 1].column >= row[i].column - 1; --k)
      if (areAlike(row[k - 1], row[i])) components.join(first + k - 1, first + i);
    while (b < below.size() && below[b].column < row[i].column - 1)
      ++b;
    for (std::size_t k = b; k < below.size() && below[k].column <= row[i].column + 1; ++k)
      if (areAlike(below[k], row[i])) components.join(firstBelow + k, first + i);
  }
}

/// Whether a pixel next to it shows another instance, or nothing.
bool isAtBorder(const SurfaceLayers& layers, const EdgePoint& edge)
{
  const auto [x, y] = layers.pixelOf(edge.index);
  if (layers.isAtEnd(x, y)) return true;
  for (int row = y - 1; row <= y + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column)
      if (layers.instance[layers.indexOf(column, row)] != layers.instance[edge.index]) return true;
  return false;
}

/// Whether a crease crosses the way from one of its neighbours, or itself, to the right or upwards.
bool isAtCrease(const SurfaceLayers& layers, const LayerRows<CreaseRow>& crossings,
                const EdgePoint& edge)
{
  const std::uint32_t instance = layers.instance[edge.index];
  const auto hasNear = [&](const std::vector<CreaseCrossing>& row) {
    const auto first = std::lower_bound(
        row.begin(), row.end(), edge.column - 1,
        [](const CreaseCrossing& crossing, int column) { return crossing.column < column; });
    for (auto at = first; at != row.end() && at->column <= edge.column + 1; ++at)
      if (!at->isStep && layers.instance[at->index] == instance) return true;
    return false;
  };
  const int y = layers.pixelOf(edge.index).y, last = std::min(y + 1, crossings.end() - 1);
  for (int row = std::max(y - 1, crossings.first()); row <= last; ++row) {
    const CreaseRow& creases = crossings[row];
    if (hasNear(creases.toRight) || hasNear(creases.toAbove)) return true;
  }
  return false;
}

}  // namespace

void dropSpecks(const SurfaceLayers& layers, LayerRows<CreaseRow>& crossings,
                LayerRows<EdgeRow>& edges, StepGrid& steps)
{
  std::size_t count = 0;
  for (const EdgeRow& row : edges.all())
    count += row.points.size();
  Components components(count);
  std::size_t first = 0;
  std::vector<EdgePoint> none;
  for (int y = edges.first(); y < edges.end(); ++y) {
    const std::vector<EdgePoint>& row = edges[y].points;
    if (row.empty()) continue;
    joinRow(layers, row, first, y > edges.first() ? edges[y - 1].points : none, components);
    for (std::size_t i = 0; i < row.size(); ++i)
      if (isAtBorder(layers, row[i])) components.grow(first + i, ImageOutline::kSmallestStep);
    first += row.size();
  }
  std::size_t number = 0;
  for (const EdgeRow& row : edges.all())
    for (const EdgePoint& edge : row.points) {
      if (components.sizeAt(number) < ImageOutline::kSmallestStep && !edge.isBent &&
          isAtCrease(layers, crossings, edge))
        components.grow(number, ImageOutline::kSmallestStep);
      ++number;
    }
  number = 0;
  for (EdgeRow& row : edges.all()) {
    const auto isSpeck = [&](const EdgePoint& edge) {
      const bool result = components.sizeAt(number++) < ImageOutline::kSmallestStep;
      if (result) steps.unite(edge.index);
      return result;
    };
    row.points.erase(std::remove_if(row.points.begin(), row.points.end(), isSpeck),
                     row.points.end());
  }
  const auto isNone = [&](const CreaseCrossing& crossing) {
    return crossing.isStep && !steps.isUnited(crossing.index) &&
           !steps.isUnited(layers.indexOf(crossing.neighbour.x, crossing.neighbour.y));
  };
  for (CreaseRow& row : crossings.all())
    for (std::vector<CreaseCrossing>* some : {&row.toRight, &row.toAbove})
      some->erase(std::remove_if(some->begin(), some->end(), isNone), some->end());
}

}  // namespace limn
