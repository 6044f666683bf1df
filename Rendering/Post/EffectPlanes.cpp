// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EffectPass.h"

namespace limn {

RadianceView EffectPlanes::radianceOf(const FrameView& frame, int threads)
{
  const auto plane =
      static_cast<std::size_t>(frame.rowStride) * static_cast<std::size_t>(frame.height);
  radiance_.resize(3 * plane);
  const RadianceView view = {radiance_.data(), radiance_.data() + plane,
                             radiance_.data() + 2 * plane};
  forEachRow(threads, frame.height, [&](int y) {
    const std::ptrdiff_t first = y * frame.rowStride;
    for (std::ptrdiff_t i = first; i < first + frame.width; ++i) {
      view.r[i] = static_cast<float>(frame.color[i].r) / 255.0f;
      view.g[i] = static_cast<float>(frame.color[i].g) / 255.0f;
      view.b[i] = static_cast<float>(frame.color[i].b) / 255.0f;
    }
  });
  return view;
}

std::size_t EffectPlanes::bytes() const
{
  const auto bytesOf = [](const ColorPlanes& planes) {
    return planes[0].bytes() + planes[1].bytes() + planes[2].bytes();
  };
  std::size_t sum = radiance_.capacity() * sizeof(float) + jagged.capacity() * sizeof(Rgba8) +
                    largestRadius.capacity() * sizeof(float);
  sum += bytesOf(image) + bytesOf(blurred);
  for (const ColorPlanes& level : pyramid)
    sum += bytesOf(level);
  for (const PaddedPlane* plane : {&alpha, &blurredAlpha, &depth, &radius, &share, &blank, &luma})
    sum += plane->bytes();
  return sum;
}

void exposeRadiance(const EffectPass& pass)
{
  const FrameView& frame = pass.frame;
  const float exposure = pass.effects.exposure;
  const float* const from[3] = {frame.radiance.r, frame.radiance.g, frame.radiance.b};
  for (PaddedPlane& plane : pass.planes.image)
    plane.resize(frame.width, frame.height);
  forEachRow(pass.threads, frame.height, [&](int y) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      PaddedPlane& plane = pass.planes.image[channel];
      const float* const in = from[channel] + y * frame.rowStride;
      float* const out = plane.row(y);
      for (int x = 0; x < frame.width; ++x) {
        const float exposed = in[x] * exposure;
        out[x] = exposed < kMaxRadiance ? exposed : kMaxRadiance;
      }
      plane.padRow(y, 0, 0);
    }
  });
}

}  // namespace limn
