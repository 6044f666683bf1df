// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/ClusteredMesh.h"
#include "Rendering/Mesh/MeshView.h"
#include "Rendering/Mesh/SortTriangles.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

inline constexpr std::size_t kUnitsOfRun = 1 << 11;  ///< of the curve, cut into clusters at once

/// One run of sorted triangles, and its clusters, of which vertices count from the run's start.
struct ClusterRun {
  Span<const TriangleGroup> groups;  ///< at most kUnitsOfRun units
  std::size_t firstTriangle = 0;     ///< of the clusters
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> vertex;  ///< of the mesh
};

/// Cuts the run into clusters that are about as wide as they are high. Fills `run`, and the
/// triangles and corners of `clusters` from run.firstTriangle on.
void cutRun(const MeshView& mesh, ClusterRun& run, ClusteredMesh& clusters);

}  // namespace limn
