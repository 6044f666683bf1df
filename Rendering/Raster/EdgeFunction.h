// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Vertex/ScreenVertex.h"

#include <cstdint>
#include <utility>

namespace limn {

/// Twice the signed area of (a, b, p), as a function of p: a x + b y + c, exact.
struct EdgeFunction {
  std::int64_t a, b, c;
  /// 0 if samples on the edge belong to the triangle (left and top edges), else 1.
  std::int64_t smallestInside;

  std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
};

inline EdgeFunction edgeFunction(const ScreenVertex& from, const ScreenVertex& to)
{
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  // Corners run counter-clockwise and y points up: left edges go down, top edges go left.
  const bool topLeft = dy < 0 || (dy == 0 && dx < 0);
  return {-dy, dx, dy * from.x - dx * from.y, topLeft ? 0 : 1};
}

/// A triangle with its corners counter-clockwise. Edge i lies opposite to corner i.
struct OrientedTriangle {
  ScreenVertex corner[3];
  EdgeFunction edge[3];
  std::int64_t area;  ///< twice, > 0
  bool clockwise;     ///< as it came: corners 1 and 2 are swapped

  bool covers(std::int64_t x, std::int64_t y) const
  {
    for (const EdgeFunction& e : edge)
      if (e.at(x, y) < e.smallestInside) return false;
    return true;
  }
};

/// False for a triangle without area.
inline bool orient(const ScreenVertex& v0, const ScreenVertex& v1, const ScreenVertex& v2,
                   OrientedTriangle& triangle)
{
  const std::int64_t area = edgeFunction(v0, v1).at(v2.x, v2.y);
  if (area == 0) return false;
  triangle.clockwise = area < 0;
  triangle.area = area < 0 ? -area : area;
  triangle.corner[0] = v0;
  triangle.corner[1] = triangle.clockwise ? v2 : v1;
  triangle.corner[2] = triangle.clockwise ? v1 : v2;
  for (int i = 0; i < 3; ++i)
    triangle.edge[i] = edgeFunction(triangle.corner[(i + 1) % 3], triangle.corner[(i + 2) % 3]);
  return true;
}

}  // namespace limn
