// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ChainEdges.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <vector>

namespace limn {

/// A shadow's border in the making.
struct BorderPieces {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> receiver;    ///< by point: the triangle that it lies on
  std::vector<double> reach;              ///< by point: its caster's gap
  std::vector<std::uint8_t> isOfContour;  ///< by point: whether that is of a contour
  std::vector<std::uint8_t> showsOut;  ///< by point: whether the receiver shows light its outside
  std::vector<LineLink> links;
};

/// Where light grazes, facets leave gaps of a few facets in what is one line on the smooth surface.
/// Joins ends that lie within a caster's gap of each other, the nearest first, unless a chain would
/// turn back; drops open chains that are shorter; and leads ends of what contours cast to where a
/// contour of `casters` turns back, or to the nearest contour, within twice as much: there such
/// lines end. Between flat faces gaps are 0: nothing of what they cast is moved.
void mendBorder(Span<const ShadowCaster> casters, BorderPieces& border);

}  // namespace limn
