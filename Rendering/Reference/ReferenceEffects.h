// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/PostEffects.h"
#include "Rendering/Scene.h"

namespace limn::reference {

/// The chain of effects by the shortest obvious scalar code, pixel after pixel. The oracle for the
/// stages in Post/. Requires: what checkEffects() accepted.
void applyEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame);

}  // namespace limn::reference
