// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Optimizations.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/PlaceHull.h"
#include "Rendering/Vertex/ViewSpace.h"
#include "Rendering/Vertex/Viewport.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace limn {

/// An instance with its way to the screen. Clusters are numbered through all instances of a frame.
struct PlacedInstance {
  const Instance* instance;  ///< of a hull the one that draws it
  InstanceTransform transform;
  std::uint32_t firstCluster;

  const ClusteredMesh& mesh() const { return *instance->clusters; }
};

/// A scene made ready for one viewport.
struct PlacedScene {
  const Scene* scene;
  Viewport viewport;
  std::vector<PlacedInstance> instances;  ///< in draw order
  std::vector<ViewLight> lights;
  std::vector<std::unique_ptr<const PlacedHull>> hulls;  ///< what their instances borrow
  std::uint32_t clusterCount;
  Optimizations optimizations;
  bool hasTranslucent = false;  ///< some instance is

  /// The instance to which a cluster of the frame belongs.
  std::uint32_t instanceOf(std::uint32_t cluster) const;
};

/// Requires: a scene that checkScene() accepted.
PlacedScene placeScene(const Scene& scene, const Viewport& viewport,
                       const Optimizations& optimizations = {}, int threads = 1);

}  // namespace limn
