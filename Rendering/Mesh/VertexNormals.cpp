// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/VertexNormals.h"

namespace limn {

std::vector<Vec3f> areaWeightedNormals(const MeshView& mesh)
{
  const std::size_t count = mesh.vertexCount();
  std::vector<Vec3d> sums(count, Vec3d{0, 0, 0});
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = triangle.vertex;
    if (a >= count || b >= count || c >= count) continue;
    const Vec3d p = mesh.position(a);
    const Vec3d twiceArea = cross(mesh.position(b) - p, mesh.position(c) - p);
    if (!isFinite(twiceArea)) continue;
    for (const std::uint32_t v : triangle.vertex)
      sums[v] = sums[v] + twiceArea;
  }
  std::vector<Vec3f> normals(count);
  for (std::size_t v = 0; v < count; ++v)
    normals[v] = vec3Cast<float>(normalized(sums[v]));
  return normals;
}

}  // namespace limn
