// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Reference/ReferenceOutline.h"

#include <functional>
#include <vector>

namespace limn::reference {

/// Instance::lines over a picture of all surfaces, by the shortest obvious scalar code: every line
/// against every pixel of its box. The oracle for Lines/DrawStrokes. `layers` are those of all
/// pixels, whose halos cut what lies behind them, or empty. If `layVeil` is set, it is called when
/// the lines of all opaque instances are drawn, and before those of translucent ones.
void drawStrokes(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers,
                 const std::function<void()>& layVeil);

}  // namespace limn::reference
