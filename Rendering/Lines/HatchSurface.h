// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceCurves.h"
#include "Rendering/Mesh/EdgeTable.h"

namespace limn {

/// What strokes are drawn on.
struct HatchSurface {
  CurvedSurface curved;            ///< apart along its creases: see cutAtCreases()
  const EdgeTable& table;          ///< of the same triangles, as they were in one piece
  Span<const std::uint8_t> kinds;  ///< edgeKinds(): kCreaseEdge where strokes end
};

/// A mesh with one vertex for each side of a crease, so that what is known by vertex, and smoothed
/// from vertex to vertex, stays on its own side. Empty where there is nothing to cut.
struct CutMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3d> precisePositions;
  std::vector<Triangle> triangles;  ///< in the order of the whole mesh
  std::vector<Vec3f> normals;
  Array<VertexCurvature> curvature;

  /// Borrows this.
  CurvedSurface surface() const
  {
    return {{positions, precisePositions, triangles}, normals, curvature};
  }
};

/// Cuts a surface along edges that are kCreaseEdge, more than `creaseDegrees` sharp. Vertices in
/// one piece keep their normal, the others get means by angle of the triangles of each side.
/// Errors: those of splitVertexNormals().
Status cutAtCreases(const HatchSurface& whole, double creaseDegrees, int threads, CutMesh& cut);

}  // namespace limn
