// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EffectPass.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/AddBloom.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/AddBloom-inl.h"

#if HWY_ONCE
namespace limn {
namespace {

HWY_EXPORT(brightPartKernel);
HWY_EXPORT(reduceRowKernel);
HWY_EXPORT(blendRowsKernel);
HWY_EXPORT(expandRowKernel);

/// A row to work in, zero beyond its ends. Each thread keeps its own.
float* scratchRow(int width)
{
  thread_local PaddedPlane plane;
  plane.resize(width, 1);
  plane.padRow(0, 0, 0);
  return plane.row(0);
}

/// Light comes from inside the picture only.
const float* rowOrBlank(const PaddedPlane& plane, int y, const EffectPlanes& planes)
{
  return y < 0 || y >= plane.height() ? planes.blank.row(0) : plane.row(y);
}

void makeBright(const EffectPass& pass, ColorPlanes& bright)
{
  forEachRow(pass.threads, pass.frame.height, [&](int y) {
    HWY_DYNAMIC_DISPATCH(brightPartKernel)
    (pass.planes.image, pass.effects.bloom.threshold, y, bright);
    for (PaddedPlane& plane : bright)
      plane.padRow(y, 0, 0);
  });
}

void reduce(const EffectPass& pass, const PaddedPlane& fine, PaddedPlane& coarse)
{
  forEachRow(pass.threads, coarse.height(), [&](int y) {
    const float* rows[5];
    for (int k = 0; k < 5; ++k)
      rows[k] = rowOrBlank(fine, 2 * y + k - 2, pass.planes);
    HWY_DYNAMIC_DISPATCH(reduceRowKernel)
    (rows, fine.width(), scratchRow(fine.width()), coarse.row(y));
    coarse.padRow(y, 0, 0);
  });
}

/// Adds `scale` times the coarse level to the fine one.
void expand(const EffectPass& pass, const PaddedPlane& coarse, float scale, PaddedPlane& fine)
{
  forEachRow(pass.threads, fine.height(), [&](int y) {
    const float* rows[3];
    for (int k = 0; k < 3; ++k)
      rows[k] = rowOrBlank(coarse, y / 2 + k - 1, pass.planes);
    float* const blended = scratchRow(coarse.width());
    HWY_DYNAMIC_DISPATCH(blendRowsKernel)(rows, coarse.width(), y % 2 == 0, blended);
    HWY_DYNAMIC_DISPATCH(expandRowKernel)(blended, scale, fine.width(), fine.row(y));
    fine.padRow(y, 0, 0);
  });
}

void resizePyramid(const FrameView& frame, int levels, EffectPlanes& planes)
{
  planes.pyramid.resize(static_cast<std::size_t>(levels) + 1);
  int width = frame.width, height = frame.height;
  for (ColorPlanes& level : planes.pyramid) {
    for (PaddedPlane& plane : level)
      plane.resize(width, height);
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  planes.blank.resize(frame.width, 1);
  std::fill_n(planes.blank.row(0), frame.width, 0.0f);
  planes.blank.padRow(0, 0, 0);
}

}  // namespace

void addBloom(const EffectPass& pass)
{
  const Bloom& bloom = pass.effects.bloom;
  resizePyramid(pass.frame, bloom.levels, pass.planes);
  auto& pyramid = pass.planes.pyramid;
  makeBright(pass, pyramid[0]);
  const auto coarsest = static_cast<std::size_t>(bloom.levels);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t level = 1; level <= coarsest; ++level)
      reduce(pass, pyramid[level - 1][channel], pyramid[level][channel]);
    for (std::size_t level = coarsest; level > 1; --level)
      expand(pass, pyramid[level][channel], 1, pyramid[level - 1][channel]);
    expand(pass, pyramid[1][channel], bloom.strength / static_cast<float>(bloom.levels),
           pass.planes.image[channel]);
  }
}

}  // namespace limn
#endif  // HWY_ONCE
