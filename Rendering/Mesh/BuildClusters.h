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

/// Moves clusters along with their mesh's vertices, for a fraction of what buildClusters() costs:
/// positions and boxes are those that it would make, which triangles are together stays. False, and
/// the clusters are of no more use, where they have to be built instead: a vertex is not finite, or
/// was not before, or the clusters have come apart, which would make drawing slow.
/// Requires: but for the positions `mesh` is what the clusters were built of.
bool refitClusters(const MeshView& mesh, int threads, ClusteredMesh& clusters);

/// Whether all vertices are, to the bit, where they were when the clusters were built or moved;
/// false, too, where the clusters do not tell: positions of doubles or far from zero, or vertices
/// that are not finite. Takes a fraction of the time of refitClusters().
/// Requires: but for the positions `mesh` is what the clusters were built of.
bool areInPlace(const MeshView& mesh, int threads, const ClusteredMesh& clusters);

/// Whether the clusters were built of triangles that lie across each other or in many layers, as
/// those of random vertices: when these are put in order, clusters that move along stay as bad.
bool areInDisorder(const ClusteredMesh& clusters);

}  // namespace limn
