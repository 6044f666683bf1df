// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"

#include <algorithm>

namespace limn {

/// A position relative to its mesh's origin, as high + low. `low` is what a float could not hold:
/// zero for meshes given in float, and together about 48 bits for meshes given in double.
struct LocalPosition {
  Vec3f high, low;
};

/// high + low, without rounding.
inline Vec3d exact(LocalPosition p)
{
  return vec3Cast<double>(p.high) + vec3Cast<double>(p.low);
}

/// From a to b, rounded once.
inline Vec3f edge(LocalPosition a, LocalPosition b)
{
  return vec3Cast<float>(exact(b) - exact(a));
}

/// The normal of triangle a, b, c: counter-clockwise seen from outside, as long as twice the area
/// of the triangle times `scale`. The edges are rounded to float, not the corners, so that a small
/// triangle far out keeps its normal.
inline Vec3f triangleNormal(LocalPosition a, LocalPosition b, LocalPosition c, float scale)
{
  return cross(edge(a, b) * scale, edge(a, c) * scale);
}

/// An axis-aligned box; empty while low.x > high.x.
struct Box {
  Vec3d low = {1, 1, 1}, high = {-1, -1, -1};

  bool empty() const { return low.x > high.x; }
  void add(Vec3d p)
  {
    if (empty()) {
      low = high = p;
      return;
    }
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// Box of the finite vertices among some.
struct FiniteBox : Box {
  bool holdsAll = true;  ///< whether there are no others
};

/// Box of the finite vertices of all triangles whose vertices are there: a point that no face uses
/// must not show. On at most `threads` threads (0: all).
FiniteBox finiteBox(const MeshView& mesh, int threads = 1);

/// The same of some vertices, named once or more often. Requires: all are there.
FiniteBox finiteBox(const MeshView& mesh, Span<const std::uint32_t> vertices, int threads);

/// The same of all vertices, used or not, which takes less time.
FiniteBox finiteBoxOfAll(const MeshView& mesh, int threads);

/// The origin of a mesh's local coordinates: zero, unless the box lies so far out that a float
/// would lose bits of its features; then the box's centre.
Vec3d localOrigin(const Box& box);

/// Requires: `p` finite. The result's `high` is infinite if p lies beyond a float's range.
inline LocalPosition toLocal(Vec3d p, Vec3d origin)
{
  const Vec3d local = p - origin;
  const Vec3f high = vec3Cast<float>(local);
  return {high, vec3Cast<float>(local - vec3Cast<double>(high))};
}

}  // namespace limn
