// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace limn {

/// What Instance::hull asks for in one view, as an ordinary mesh: a point of the screen moves
/// parallel to the picture, so a vertex that is moved there has a place in the model's space, and
/// all stages behind know nothing of hulls.
struct PlacedHull {
  std::vector<Vec3d> positions;
  std::vector<Triangle> triangles;  ///< in the mesh's order; then of borders
  std::vector<std::uint32_t> cells;
  ClusteredMesh clusters;
  Instance instance;  ///< borrows the above
};

struct HullView {
  int width, height;
  int threads;  ///< 0: all; of no account for the result
};

/// Requires: an instance with a hull that checkScene() accepted.
std::unique_ptr<const PlacedHull> placeHull(const Instance& instance, const Camera& camera,
                                            const HullView& view);

}  // namespace limn
