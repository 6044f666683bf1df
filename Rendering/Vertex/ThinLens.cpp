// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ThinLens.h"

#include <cmath>

namespace limn {

bool hasLens(const Camera& camera)
{
  const auto& m = camera.viewToClip.m;
  return !camera.parallel && m[2][0] == 0 && m[2][1] == 0 && m[3][0] == 0 && m[3][1] == 0 &&
         m[3][2] < 0 && m[3][3] == 0 && m[2][3] != 0;
}

ThinLens thinLens(const DepthOfField& depthOfField, const Camera& camera, int height)
{
  // Depth is (1 + zClip / wClip) / 2 with zClip = m22 z + m23 and wClip = m32 z at z = -d.
  const auto& m = camera.viewToClip.m;
  const double perDepth = -2 * m[3][2] / m[2][3];
  const double atZero = (m[3][2] + m[2][2]) / m[2][3];
  // A length x at distance d covers x m11 / -m32 / d of half the height.
  const double pixels = std::fabs(m[1][1] / m[3][2]) * height / 2;
  const double radius = 0.5 * depthOfField.aperture * pixels;
  const double inverseFocus = 1.0 / depthOfField.focusDistance;
  return {static_cast<float>(-radius * perDepth),
          static_cast<float>(radius * (inverseFocus - atZero))};
}

}  // namespace limn
