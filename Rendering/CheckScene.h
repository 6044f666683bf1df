// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Renderer.h"

namespace limn {

/// All that render() requires of its arguments, found out before anything is drawn.
Status checkScene(const Scene& scene, const FrameView& frame, Backend backend);

}  // namespace limn
