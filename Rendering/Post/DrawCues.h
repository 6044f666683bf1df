// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Post/CuePass.h"

namespace limn {

/// Draws the cues of Rendering/DepthCues.h over the finished picture, and into the colours of the
/// layers. Gives the bytes of Reference/ReferenceCues, with any number of threads.
void drawCues(const CuePass& pass);

}  // namespace limn
