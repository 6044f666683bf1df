// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"
#include "Rendering/Mesh/CutPiece.h"
#include "Rendering/Mesh/TriangleTree.h"

#include <vector>

/// Lines where surfaces run into each other. They change with bodies, not with the camera.
namespace limn {

/// Of all triangles of which one's body is in `isWanted`, by body. In the order of the first
/// triangle, then of the second; the same on any number of threads.
std::vector<CutPiece> intersections(const WorldMesh& world, const TriangleTree& tree,
                                    Span<const std::uint8_t> isWanted, int threads);

/// Chains of the pieces that are a body's: each is its first triangle's body's, if that is wanted,
/// else its second one's. Moved by `worldToModel`. Cuts of closed surfaces are closed.
ContourLines intersectionLines(const WorldMesh& world, Span<const CutPiece> pieces,
                               Span<const std::uint8_t> isWanted, std::size_t body,
                               const Mat4d& worldToModel);

}  // namespace limn
