// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"

#include <vector>

namespace limn::reference {

/// An instance that is drawn in place of another one, with what it borrows.
struct Hull {
  std::vector<Vec3d> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> cells;
  Instance instance;
};

/// The hull that Instance::hull asks for. The result must stay where it is.
void makeHull(const Scene& scene, const Instance& instance, const FrameView& frame, Hull& hull);

}  // namespace limn::reference
