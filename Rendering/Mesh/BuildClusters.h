// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Mesh/ClusteredMesh.h"
#include "Rendering/Mesh/MeshView.h"

namespace limn {

/// Sorts the triangles along a Morton curve, and cuts runs of it into compact parts.
/// Ensures: every drawable triangle of `mesh` stands in exactly one cluster; degenerate triangles
/// are kept (they cover nothing); the others are counted. The result depends on `mesh` only, not on
/// `threads` (0: all).
/// Errors: kTooManyPrimitives from 2^32 - 1 vertices or triangles on.
Status buildClusters(const MeshView& mesh, int threads, ClusteredMesh& clusters);

}  // namespace limn
