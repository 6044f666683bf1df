// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/CutPiece.h"
#include "Rendering/Vertex/LightRays.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <vector>

/// What shadowCasters(), shadowPieces() and intersections() find, by trying every triangle with
/// every other.
namespace limn::reference {

std::vector<ShadowCaster> shadowCasters(const WorldMesh& world, const WorldNormals& normals,
                                        const LightRays& light);

std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const LightRays& light,
                                      Span<const ShadowCaster> casters,
                                      Span<const double> creaseDegrees);

std::vector<CutPiece> intersections(const WorldMesh& world, Span<const std::uint8_t> isWanted);

}  // namespace limn::reference
