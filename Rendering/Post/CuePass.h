// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/FrameView.h"
#include "Rendering/Lines/HaloCut.h"

#include <cstddef>

namespace limn {

/// What the depth cues of a frame are drawn from.
struct CuePass {
  const Scene& scene;
  const FrameView& frame;
  SurfaceLayers& layers;
  PixelRectangle touched;  ///< all pixels that have layers lie in it
  int threads;
};

/// Distances along the gaze, with room at both ends of a row for kernels that read beyond them.
struct DistancePlane {
  /// Of pixels that show no surface.
  static constexpr float kFar = HaloBorder::kBehindAll;
  static constexpr int kVector = 16;

  int width = 0, height = 0, pad = 0;
  std::ptrdiff_t stride = 0;
  Array<float> values;

  void resize(int newWidth, int newHeight, int reach)
  {
    width = newWidth;
    height = newHeight;
    pad = (reach + 2 * kVector - 1) / kVector * kVector;
    stride = (newWidth + kVector - 1) / kVector * kVector + 2 * pad;
    values.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(newHeight));
  }
  float* row(int y) { return values.data() + y * stride + pad; }
  const float* row(int y) const { return values.data() + y * stride + pad; }
};

/// Floats for a row of pixels, in whole vectors.
inline std::size_t paddedWidth(int width)
{
  constexpr auto kVector = static_cast<std::size_t>(DistancePlane::kVector);
  return (static_cast<std::size_t>(width) + kVector - 1) / kVector * kVector;
}

}  // namespace limn
