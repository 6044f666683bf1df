// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/PostEffects.h"
#include "Rendering/Scene.h"

namespace limn {

/// Radius of the disc that a point becomes: |slope z + offset| pixels at window depth z. It is
/// linear in the depth as 1/d, d the distance from the eye along the gaze, is:
/// aperture |d - focus| / d = aperture focus |1/focus - 1/d|.
struct ThinLens {
  float slope, offset;
};

/// Whether the camera has an eye point from which depth grows along the gaze alone, as a lens
/// needs.
bool hasLens(const Camera& camera);

/// Requires: hasLens(camera).
ThinLens thinLens(const DepthOfField& depthOfField, const Camera& camera, int height);

}  // namespace limn
