// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/PlaceFragments.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "Rendering/Shading/PlaceFragments-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(gatherFragmentsKernel);
HWY_EXPORT(placeFragmentsKernel);

bool isGatherable(const PlacedInstance& placed)
{
  const ClusteredMesh& mesh = placed.mesh();
  constexpr std::size_t kReach = std::numeric_limits<std::int32_t>::max();
  return mesh.vertexCount < kReach && mesh.triangleCount < kReach &&
         mesh.meshVertexCount < kReach / 3 && mesh.meshTriangleCount < kReach / 3 &&
         placed.instance->attributes.vertexNormals.size() < kReach / 3 &&
         placed.instance->attributes.smoothNormals.size() < kReach;
}

void gatherFragments(const TileClusters& clusters, const PlacedInstance& placed,
                     FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(gatherFragmentsKernel)(clusters, placed, batch);
}

void placeFragments(const InstanceTransform& transform, const TileRectangle& pixels, bool footprint,
                    FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(placeFragmentsKernel)(transform, pixels, footprint, batch);
}

}  // namespace limn
#endif  // HWY_ONCE
