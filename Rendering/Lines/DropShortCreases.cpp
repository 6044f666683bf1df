// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/DropShortCreases.h"

#include "Rendering/Lines/Components.h"
#include "Rendering/Lines/CrossingSquares.h"

#include <algorithm>
#include <cstddef>

namespace limn {
namespace {

bool hasEdgeBeside(const std::vector<EdgePoint>& row, int x)
{
  const auto first =
      std::lower_bound(row.begin(), row.end(), x - 1,
                       [](const EdgePoint& edge, int column) { return edge.column < column; });
  return first != row.end() && first->column <= x + 1;
}

/// Whether there is an edge in a pixel or one that touches it, or one of these shows something
/// else.
bool isAtLine(const SurfaceLayers& layers, const std::vector<EdgeRow>& edges, PixelPlace pixel)
{
  const auto [x, y] = pixel;
  if (x == 0 || y == 0 || x + 1 == layers.width || y + 1 == layers.height) return true;
  const std::uint32_t instance = layers.instance[layers.indexOf(x, y)];
  for (int row = y - 1; row <= y + 1; ++row) {
    for (int column = x - 1; column <= x + 1; ++column)
      if (layers.instance[layers.indexOf(column, row)] != instance) return true;
    if (hasEdgeBeside(edges[static_cast<std::size_t>(row)].points, x)) return true;
  }
  return false;
}

/// Numbers of crossings: of a row those to the right come before those to above.
class Numbers {
 public:
  explicit Numbers(const std::vector<CreaseRow>& crossings) : crossings_(crossings)
  {
    first_.reserve(crossings.size() + 1);
    std::size_t count = 0;
    for (const CreaseRow& row : crossings) {
      first_.push_back(count);
      count += row.toRight.size() + row.toAbove.size();
    }
    first_.push_back(count);
  }
  std::size_t count() const { return first_.back(); }
  bool isEmpty(std::size_t row) const { return first_[row] == first_[row + 1]; }
  std::size_t ofRight(std::size_t row, const CreaseCrossing& crossing) const
  {
    return first_[row] + static_cast<std::size_t>(&crossing - crossings_[row].toRight.data());
  }
  std::size_t ofAbove(std::size_t row, const CreaseCrossing& crossing) const
  {
    return first_[row] + crossings_[row].toRight.size() +
           static_cast<std::size_t>(&crossing - crossings_[row].toAbove.data());
  }

 private:
  const std::vector<CreaseRow>& crossings_;
  std::vector<std::size_t> first_;
};

/// Those of one surface on the sides of a square.
void joinSquares(const std::vector<CreaseRow>& crossings, const Numbers& numbers, std::size_t row,
                 Components& components)
{
  const auto visit = [&](int, const SquareSides& sides) {
    struct Met {
      const CreaseCrossing* crossing;
      std::size_t number;
    };
    Met met[4];
    std::size_t count = 0;
    const auto take = [&](const CreaseCrossing* crossing, std::size_t number) {
      for (std::size_t i = 0; i < count; ++i)
        if (met[i].crossing->instance == crossing->instance) components.join(met[i].number, number);
      met[count++] = {crossing, number};
    };
    if (sides.below != nullptr) take(sides.below, numbers.ofRight(row, *sides.below));
    if (sides.left != nullptr) take(sides.left, numbers.ofAbove(row, *sides.left));
    if (sides.right != nullptr) take(sides.right, numbers.ofAbove(row, *sides.right));
    if (sides.above != nullptr) take(sides.above, numbers.ofRight(row + 1, *sides.above));
  };
  forEachSquare(crossings[row], crossings[row + 1], visit);
}

}  // namespace

void dropShortCreases(const SurfaceLayers& layers, const std::vector<EdgeRow>& edges,
                      std::vector<CreaseRow>& crossings)
{
  const Numbers numbers(crossings);
  if (numbers.count() == 0) return;
  Components components(numbers.count());
  for (std::size_t row = 0; row + 1 < crossings.size(); ++row)
    if (!numbers.isEmpty(row) || !numbers.isEmpty(row + 1))
      joinSquares(crossings, numbers, row, components);
  std::size_t number = 0;
  for (const CreaseRow& row : crossings)
    for (const std::vector<CreaseCrossing>* some : {&row.toRight, &row.toAbove})
      for (const CreaseCrossing& crossing : *some) {
        const PixelPlace pixel = {crossing.column, static_cast<int>(crossing.index) / layers.width};
        if (components.sizeAt(number) < ImageOutline::kShortestCrease &&
            (!crossing.isBent || isAtLine(layers, edges, pixel) ||
             isAtLine(layers, edges, crossing.neighbour)))
          components.grow(number, ImageOutline::kShortestCrease);
        ++number;
      }
  number = 0;
  for (CreaseRow& row : crossings)
    for (std::vector<CreaseCrossing>* some : {&row.toRight, &row.toAbove}) {
      const auto isShort = [&](const CreaseCrossing&) {
        return components.sizeAt(number++) < ImageOutline::kShortestCrease;
      };
      some->erase(std::remove_if(some->begin(), some->end(), isShort), some->end());
    }
}

}  // namespace limn
