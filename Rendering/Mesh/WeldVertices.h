// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

namespace limn {

/// For each vertex the one that stands for its place: the first of those that lie there. Vertices
/// are in one place if their coordinates are equal, 0 standing for those below 2^-46 of the
/// largest; or, for a tolerance above 0, if they lie within it of a vertex before them that stands
/// for its place. Vertices that are not finite stand for themselves. The same on any number of
/// threads.
std::vector<std::uint32_t> weldVertices(const MeshView& mesh, double tolerance, int threads);

}  // namespace limn
