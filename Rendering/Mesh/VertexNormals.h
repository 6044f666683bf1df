// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"

#include <vector>

namespace limn {

/// Unit normal per vertex: the sum of (p1-p0) x (p2-p0) over the triangles around it, so each
/// counts by its area (Gouraud 1971 with Max's area weights). Sums run in double in the order of
/// the triangles: the same bits every time. Vertices without a proper triangle get the zero vector.
/// Triangles with a vertex out of range or not finite are left out.
std::vector<Vec3f> areaWeightedNormals(const MeshView& mesh);

}  // namespace limn
