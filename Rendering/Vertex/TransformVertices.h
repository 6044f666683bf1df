// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Vertex/ClipTriangle.h"
#include "Rendering/Vertex/PlacedScene.h"

#include <cstdint>

namespace limn {

/// A cluster on its way to the screen.
struct PlacedCluster {
  const PlacedInstance* placed;
  const Cluster* cluster;

  const ClusteredMesh& mesh() const { return placed->mesh(); }
  /// Vertex number within the cluster.
  std::uint32_t corner(std::uint32_t triangle, int k) const
  {
    return mesh().corner[k][cluster->firstTriangle + triangle];
  }
  std::uint32_t meshTriangle(std::uint32_t triangle) const
  {
    return mesh().triangle[cluster->firstTriangle + triangle];
  }
  LocalPosition position(std::uint32_t vertex) const;
};

/// The vertices of one cluster on the screen, as arrays; meaning as in ScreenVertex. Elements from
/// the cluster's vertexCount on hold anything.
struct alignas(64) ScreenVertices {
  std::int32_t x[kMaxClusterVertices], y[kMaxClusterVertices];
  float depth[kMaxClusterVertices], inverseW[kMaxClusterVertices];
  std::int32_t needsClip[kMaxClusterVertices];  ///< 0 or -1

  ScreenVertex vertex(std::uint32_t i) const
  {
    return {x[i], y[i], depth[i], inverseW[i], needsClip[i] != 0};
  }
};

/// screenVertex() of every vertex of a cluster, bit for bit.
void transformVertices(const PlacedCluster& cluster, ScreenVertices& screen);

/// clipTriangle() of a triangle of the cluster that has a corner with needsClip.
ClippedTriangle clipClusterTriangle(const PlacedCluster& cluster, std::uint32_t triangle);

}  // namespace limn
