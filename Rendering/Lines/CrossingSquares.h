// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <limits>

namespace limn {

/// Those on the sides of the square between the centres of four pixels; null where there is none.
struct SquareSides {
  const CreaseCrossing *below, *left, *right, *above;
};

/// Calls visit(column, sides) for the squares between two rows of pixels on whose sides crossings
/// lie, from left to right; the first pixels are of a column `firstColumn`.
template <class Visit>
void forEachSquare(const CreaseRow& row, const CreaseRow& above, int firstColumn,
                   const Visit& visit)
{
  constexpr int kNone = std::numeric_limits<int>::max();
  /// The crossings of one side, square after square.
  struct Side {
    const CreaseCrossing *at, *end;
    int shift;

    Side(const std::vector<CreaseCrossing>& all, int toSquare, int firstSquare)
        : at(all.data()), end(all.data() + all.size()), shift(toSquare)
    {
      if (at != end && at->column + shift < firstSquare) ++at;
    }
    int column() const { return at == end ? kNone : at->column + shift; }
    const CreaseCrossing* take(int column_) { return column() == column_ ? at++ : nullptr; }
  };
  Side below(row.toRight, 0, firstColumn), left(row.toAbove, 0, firstColumn),
      right(row.toAbove, -1, firstColumn), over(above.toRight, 0, firstColumn);
  for (;;) {
    int column = below.column();
    for (const Side* side : {&left, &right, &over})
      if (side->column() < column) column = side->column();
    if (column == kNone) return;
    const SquareSides sides = {below.take(column), left.take(column), right.take(column),
                               over.take(column)};
    visit(column, sides);
  }
}

}  // namespace limn
