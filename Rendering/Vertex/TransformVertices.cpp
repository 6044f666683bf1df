// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/TransformVertices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Vertex/TransformVertices.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Vertex/TransformVertices-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(transformVerticesKernel);

LocalPosition PlacedCluster::position(std::uint32_t vertex) const
{
  const ClusteredMesh& m = mesh();
  const std::size_t i = cluster->firstVertex + vertex;
  const Vec3f high = {m.x[i], m.y[i], m.z[i]};
  return {high, m.hasLowParts() ? Vec3f{m.xLow[i], m.yLow[i], m.zLow[i]} : Vec3f{0, 0, 0}};
}

void transformVertices(const PlacedCluster& cluster, ScreenVertices& screen)
{
  HWY_DYNAMIC_DISPATCH(transformVerticesKernel)(cluster, screen);
}

ClippedTriangle clipClusterTriangle(const PlacedCluster& cluster, std::uint32_t triangle)
{
  const InstanceTransform& transform = cluster.placed->transform;
  ClipPoint clip[3];
  ScreenVertex corner[3];
  for (int k = 0; k < 3; ++k) {
    clip[k] = clipPoint(transform, cluster.position(cluster.corner(triangle, k)));
    corner[k] = screenVertex(transform, clip[k]);
  }
  return clipTriangle(transform, clip, corner);
}

}  // namespace limn
#endif  // HWY_ONCE
