// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/PlaceFragments.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Shading/PlaceFragments-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(gatherFragmentsKernel);
HWY_EXPORT(placeFragmentsKernel);
HWY_EXPORT(collectVisibleKernel);

bool isGatherable(const ClusteredMesh& mesh)
{
  constexpr std::size_t kReach = std::numeric_limits<std::int32_t>::max();
  return mesh.vertexCount < kReach && mesh.triangleCount < kReach &&
         mesh.meshVertexCount < kReach / 3 && mesh.meshTriangleCount < kReach / 3;
}

void gatherFragments(const TileClusters& clusters, const PlacedInstance& placed,
                     FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(gatherFragmentsKernel)(clusters, placed, batch);
}

void placeFragments(const InstanceTransform& transform, const TileRectangle& pixels,
                    FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(placeFragmentsKernel)(transform, pixels, batch);
}

void FragmentList::reserve(int samples)
{
  const std::size_t most =
      static_cast<std::size_t>(kTilePixels) * static_cast<std::size_t>(samples);
  const std::size_t room = most + HWY_MAX_BYTES / sizeof(std::uint32_t);
  if (owner.size() >= room) return;
  owner.resize(room);
  pixel.resize(room);
  coverage.resize(room);
}

void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      FragmentList& fragments)
{
  fragments.reserve(samples);
  if (samples == 1) {
    HWY_DYNAMIC_DISPATCH(collectVisibleKernel)(tile, pixels, fragments);
    return;
  }
  std::size_t count = 0;
  for (int y = 0; y < pixels.y1 - pixels.y0; ++y)
    for (int x = 0; x < pixels.x1 - pixels.x0; ++x) {
      const int pixel = y * kTileSide + x;
      const std::size_t first = count;
      for (int s = 0; s < samples; ++s) {
        const std::uint32_t owner = tile.owner[s][pixel];
        if (owner == kNobody) continue;
        const auto bit = static_cast<std::uint8_t>(1u << s);
        std::size_t f = first;
        while (f < count && fragments.owner[f] != owner)
          ++f;
        if (f == count) {
          fragments.owner[count] = owner;
          fragments.pixel[count] = static_cast<std::uint32_t>(pixel);
          fragments.coverage[count++] = bit;
        } else {
          fragments.coverage[f] = static_cast<std::uint8_t>(fragments.coverage[f] | bit);
        }
      }
    }
  fragments.count = count;
}

}  // namespace limn
#endif  // HWY_ONCE
