// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/PlacedScene.h"

#include "Rendering/Vertex/PlaceLights.h"

#include <algorithm>

namespace limn {

std::uint32_t PlacedScene::instanceOf(std::uint32_t cluster) const
{
  const auto next = std::upper_bound(
      instances.begin(), instances.end(), cluster,
      [](std::uint32_t c, const PlacedInstance& placed) { return c < placed.firstCluster; });
  return static_cast<std::uint32_t>(next - instances.begin() - 1);
}

PlacedScene placeScene(const Scene& scene, const Viewport& viewport,
                       const Optimizations& optimizations, int threads)
{
  PlacedScene placed = {&scene, viewport, {},           placeLights(scene.lights, scene.camera),
                        {},     0,        optimizations};
  const int width = viewport.width, height = viewport.height;
  placed.instances.reserve(scene.instances.size());
  for (const Instance& given : scene.instances) {
    if (given.hull != nullptr)
      placed.hulls.push_back(placeHull(given, scene.camera, {width, height, threads}));
    const Instance& instance = given.hull != nullptr ? placed.hulls.back()->instance : given;
    const ClusteredMesh& mesh = *instance.clusters;
    const LocalFrame frame = {mesh.origin, mesh.low, mesh.high, mesh.hasLowParts()};
    placed.instances.push_back(
        {&instance,
         makeInstanceTransform(scene.camera, instance.modelToWorld, frame, width, height),
         placed.clusterCount});
    placed.hasTranslucent = placed.hasTranslucent || instance.isTranslucent();
    placed.clusterCount += static_cast<std::uint32_t>(mesh.clusters.size());
  }
  return placed;
}

}  // namespace limn
