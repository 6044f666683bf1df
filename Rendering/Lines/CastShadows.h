// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"
#include "Rendering/Mesh/TriangleTree.h"
#include "Rendering/Vertex/LightRays.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <vector>

/// Borders of cast shadows as lines. They change with bodies and lights, not with the camera.
namespace limn {

/// Of all edges of the world, exactly. A smooth surface shows none next to where it turns away from
/// the light, which facets would make there: of an edge whose faces' normals are within
/// `creaseDegrees`, by body, of each other there is none on triangles of its body that are within
/// that angle of one of its faces and within kShadowFacets of it, and none on such of its body that
/// show light the side to which the edge does not bulge.
/// In the order of edges, then of u; the same on any number of threads.
std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const TriangleTree& tree,
                                      const LightRays& light, Span<const double> creaseDegrees,
                                      int threads);

/// Chains of what a body's edges cast, moved by `worldToModel`.
ContourLines shadowBorder(const WorldMesh& world, Span<const ShadowPiece> pieces, std::size_t body,
                          const Mat4d& worldToModel);

}  // namespace limn
