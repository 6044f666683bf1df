// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/RawMesh.h"

#include <cstddef>

namespace limn::meshio {

/// How many faces run along an edge in the direction of a face before them that does not itself
/// count: those that a half-edge mesh, filled in this order, has no room for.
std::size_t countNonManifoldFaces(const RawMesh& mesh);

}  // namespace limn::meshio
