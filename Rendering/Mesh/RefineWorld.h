// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/WorldMesh.h"

#include <vector>

namespace limn {

/// A WorldMesh whose smooth bodies are cut into finer facets, for light that grazes them: at a few
/// degrees flat facets tell no longer what the surface does. A triangle becomes k x k facets of the
/// curved patch that its normals tell of (Vlachos et al. 2001), with their normals. Where the faces
/// at an edge have other normals at one of its ends, it is straight there, so that patches meet.
struct RefinedWorld {
  WorldMesh mesh;
  WorldNormals normals;
  /// By point: where it is in the triangles as they are drawn.
  std::vector<Vec3d> flat;
  /// By body: k.
  std::vector<std::uint32_t> fineness;
};

/// Facets about which normals turn by this much, in the mean over a body's edges along which they
/// do, are fine enough.
inline constexpr double kFineTurn = 0.03;
inline constexpr std::uint32_t kMostFineness = 8;
/// No refinement makes more triangles than this in all.
inline constexpr std::size_t kMostRefined = 64000;

/// `normals` of all bodies.
RefinedWorld refineWorld(WorldMesh world, WorldNormals normals);

}  // namespace limn
