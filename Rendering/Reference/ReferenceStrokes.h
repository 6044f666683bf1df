// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"

namespace limn::reference {

/// Instance::lines over a picture of all surfaces, by the shortest obvious scalar code: every line
/// against every pixel of its box. The oracle for Lines/DrawStrokes.
void drawStrokes(const Scene& scene, const FrameView& frame);

}  // namespace limn::reference
