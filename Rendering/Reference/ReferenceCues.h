// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Reference/ReferenceOutline.h"

#include <vector>

namespace limn::reference {

/// Whether depth cues change anything in a frame with the instance.
bool hasCues(const Instance& instance);

/// Draws the cues of Rendering/DepthCues.h, pixel after pixel. `layers` are those of all pixels,
/// row by row; their colours change with the frame's, and they learn of the halos over them.
void drawCues(const Scene& scene, const FrameView& frame, std::vector<Layer>& layers);

}  // namespace limn::reference
