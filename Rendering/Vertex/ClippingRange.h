// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

namespace limn {

/// Distances along the gaze.
struct DepthRange {
  float nearest, farthest;  ///< 0 < nearest < farthest
};

/// What ToneRamp::nearest and farthest mean: they themselves, or the camera's clipping planes.
DepthRange depthRangeOf(const ToneRamp& ramp, const Camera& camera);

}  // namespace limn
