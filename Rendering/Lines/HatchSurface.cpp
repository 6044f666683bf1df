// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HatchSurface.h"

#include "Rendering/Mesh/VertexNormals.h"

#include <algorithm>

namespace limn {

Status cutAtCreases(const HatchSurface& whole, double creaseDegrees, int threads, CutMesh& cut)
{
  cut = {};
  const bool hasCreases = std::any_of(whole.kinds.begin(), whole.kinds.end(),
                                      [](std::uint8_t kind) { return (kind & kCreaseEdge) != 0; });
  if (!hasCreases) return {};
  const MeshView& mesh = whole.curved.mesh;
  SplitNormals split;
  if (Status status =
          splitVertexNormals(mesh, {}, NormalWeight::kAngle, creaseDegrees, threads, split);
      !status.ok())
    return status;
  const std::vector<std::uint32_t> vertexOf = verticesOfNormals(mesh, split);
  std::vector<std::uint32_t> sides(mesh.vertexCount(), 0);
  for (const std::uint32_t v : vertexOf)
    if (v < sides.size()) ++sides[v];

  cut.normals = std::move(split.normals);
  for (std::size_t i = 0; i < vertexOf.size(); ++i) {
    const std::uint32_t v = vertexOf[i] < sides.size() ? vertexOf[i] : 0;
    if (sides[v] == 1) cut.normals[i] = whole.curved.normals[v];
    if (mesh.positions.empty())
      cut.precisePositions.push_back(mesh.precisePositions[v]);
    else
      cut.positions.push_back(mesh.positions[v]);
  }
  cut.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  for (std::size_t t = 0; t < cut.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& v = cut.triangles[t].vertex[k];
      v = v < sides.size() ? split.ofCorner[3 * t + k] : kNoCorner;
    }
  cut.curvature = vertexCurvature(cut.surface().mesh, cut.normals, threads);
  return {};
}

}  // namespace limn
