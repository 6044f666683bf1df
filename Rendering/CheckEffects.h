// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/FrameView.h"
#include "Rendering/PostEffects.h"
#include "Rendering/Scene.h"

namespace limn {

/// All that applyEffects() requires of its arguments, found out before anything is changed.
Status checkEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame);

}  // namespace limn
