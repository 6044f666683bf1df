// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Vertex/LightRays.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <vector>

namespace limn {

/// What of the bodies that have edges may cast a shadow's border; see ShadowPiece.h. First edges,
/// in their order, then contours, in the order of triangles. The same on any number of threads.
std::vector<ShadowCaster> shadowCasters(const WorldMesh& world, const WorldNormals& normals,
                                        const LightRays& light, int threads);

}  // namespace limn
