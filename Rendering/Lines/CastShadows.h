// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"
#include "Rendering/Lines/ShadowCasters.h"
#include "Rendering/Mesh/RefineWorld.h"
#include "Rendering/Mesh/TriangleTree.h"
#include "Rendering/Vertex/LightRays.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <vector>

/// Borders of cast shadows as lines. They change with bodies and lights, not with the camera.
namespace limn {

/// What casters cast, exactly. In the order of casters, then of u; the same on any number of
/// threads.
std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const TriangleTree& tree,
                                      const LightRays& light, Span<const ShadowCaster> casters,
                                      Span<const double> creaseDegrees, int threads);

/// A shadow's border as lines.
struct ShadowLines {
  ContourLines lines;
  std::vector<Vec3d> litSide;  ///< by vertex of the chains: world, normal of what the segment is on
};

/// Chains of what a body casts, moved by `worldToModel`.
ShadowLines shadowBorder(const RefinedWorld& world, Span<const ShadowCaster> casters,
                         Span<const ShadowPiece> pieces, const LightRays& light, std::size_t body,
                         const Mat4d& worldToModel);

/// Sheets have the border on the side that the light meets: sets kConcealedLine where a camera sees
/// the other one. False, and nothing is set, if there is no such segment.
bool concealBehindSheets(const ShadowLines& shadow, const Camera& camera, const Mat4d& modelToWorld,
                         std::vector<std::uint8_t>& flags);

}  // namespace limn
