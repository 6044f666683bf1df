// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/DropShortCreases.h"

#include "Rendering/Base/Components.h"
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
bool isAtLine(const SurfaceLayers& layers, const LayerRows<EdgeRow>& edges, PixelPlace pixel)
{
  const auto [x, y] = pixel;
  if (layers.isAtEnd(x, y)) return true;
  const std::uint32_t instance = layers.instance[layers.indexOf(x, y)];
  for (int row = y - 1; row <= y + 1; ++row) {
    for (int column = x - 1; column <= x + 1; ++column)
      if (layers.instance[layers.indexOf(column, row)] != instance) return true;
    if (hasEdgeBeside(edges[row].points, x)) return true;
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

/// The squares between two rows.
struct SquareRow {
  const CreaseRow &row, &above;
  std::size_t number;
  int firstColumn;
};

/// Those of one surface on the sides of a square.
void joinSquares(const SquareRow& squares, const Numbers& numbers, Components& components)
{
  const std::size_t row = squares.number;
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
  forEachSquare(squares.row, squares.above, squares.firstColumn, visit);
}

}  // namespace

void dropShortCreases(const SurfaceLayers& layers, const LayerRows<EdgeRow>& edges,
                      LayerRows<CreaseRow>& crossings)
{
  std::vector<CreaseRow>& rows = crossings.all();
  const Numbers numbers(rows);
  if (numbers.count() == 0) return;
  Components components(numbers.count());
  for (std::size_t row = 0; row + 1 < rows.size(); ++row)
    if (!numbers.isEmpty(row) || !numbers.isEmpty(row + 1))
      joinSquares({rows[row], rows[row + 1], row, -layers.apron}, numbers, components);
  std::size_t number = 0;
  for (const CreaseRow& row : rows)
    for (const std::vector<CreaseCrossing>* some : {&row.toRight, &row.toAbove})
      for (const CreaseCrossing& crossing : *some) {
        const PixelPlace pixel = layers.pixelOf(crossing.index);
        if (components.sizeAt(number) < ImageOutline::kShortestCrease &&
            (!crossing.isBent || isAtLine(layers, edges, pixel) ||
             isAtLine(layers, edges, crossing.neighbour)))
          components.grow(number, ImageOutline::kShortestCrease);
        ++number;
      }
  number = 0;
  for (CreaseRow& row : rows)
    for (std::vector<CreaseCrossing>* some : {&row.toRight, &row.toAbove}) {
      const auto isShort = [&](const CreaseCrossing&) {
        return components.sizeAt(number++) < ImageOutline::kShortestCrease;
      };
      some->erase(std::remove_if(some->begin(), some->end(), isShort), some->end());
    }
}

}  // namespace limn
