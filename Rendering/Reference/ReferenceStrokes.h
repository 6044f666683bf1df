// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Reference/ReferenceOutline.h"

#include <functional>
#include <vector>

namespace limn::reference {

/// Translucent surfaces over the picture.
struct StrokeVeil {
  std::function<void()> lay;
  std::vector<float> nearest;  ///< depth of a pixel's nearest, row by row; -1: it has none
};

/// Instance::lines over a picture of all surfaces, by the shortest obvious scalar code: every line
/// against every pixel of its box. The oracle for Lines/DrawStrokes. `layers` are those of all
/// pixels, whose halos cut what lies behind them, or empty. `veil` may be null: it is laid over the
/// lines of opaque instances, but where these are nearer than all of it, and lines of translucent
/// instances over that.
void drawStrokes(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers,
                 const StrokeVeil* veil);

}  // namespace limn::reference
