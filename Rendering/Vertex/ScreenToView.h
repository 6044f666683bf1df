// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Scene.h"

#include <cmath>

namespace limn {

/// A point of the picture, back in view space.
struct ViewPoint {
  Vec3f position;
  float pixel;     ///< length that one pixel's height covers there
  float rounding;  ///< how far it may be off along the gaze, as the picture's depth is a float
};

/// The way from the window back to view space: right for perspective and parallel projection.
class ScreenToView {
 public:
  ScreenToView(const Camera& camera, int width, int height);

  /// At a place in pixels from the lower left corner, and a window depth.
  ViewPoint at(float x, float y, float depth) const
  {
    const auto row = [&](int r) {
      return (m_.m[r][0] * x + m_.m[r][1] * y) + (m_.m[r][2] * depth + m_.m[r][3]);
    };
    const float inverseW = 1.0f / row(3);
    const Vec3f position = {row(0) * inverseW, row(1) * inverseW, row(2) * inverseW};
    const float perDepth = (m_.m[2][2] - position.z * m_.m[3][2]) * inverseW;
    return {position, std::fabs(m_.m[1][1] * inverseW), std::fabs(perDepth) * kDepthRounding};
  }

  /// Depths near 1 are 2^-24 apart, and some such go astray until a sample has its depth.
  static constexpr float kDepthRounding = 1.0f / (1 << 21);
  /// From (x, y, depth, 1), before the division.
  const Mat4f& matrix() const { return m_; }

 private:
  Mat4f m_;
};

}  // namespace limn
