// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"

#include <cstddef>

namespace limn::reference {

/// Draws the scene by the shortest obvious scalar code: every triangle against every pixel of its
/// box, then the light equations as the chapter prints them. The oracle for the pipeline.
/// Requires: a scene and frame that checkScene() accepted, with MeshView triangles.
/// Returns RenderStats::truncatedPixels.
std::size_t render(const Scene& scene, const FrameView& frame);

}  // namespace limn::reference
