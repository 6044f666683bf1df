// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Agreement/TextureLanes.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Testing/Agreement/TextureLanes.cpp"
#include <hwy/foreach_target.h>

#include "Testing/Agreement/TextureLanes-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(sampleKernel);
HWY_EXPORT(gradientKernel);
HWY_EXPORT(proceduralKernel);

std::vector<Vec4f> testing::sampledByLanes(const TextureImage& image, const TextureSampler& sampler,
                                           const std::vector<TexturePoint>& points)
{
  std::vector<Vec4f> results(points.size());
  HWY_DYNAMIC_DISPATCH(sampleKernel)(image, sampler, points, results);
  return results;
}

std::vector<Vec2f> testing::gradientsByLanes(const TextureImage& image,
                                             const TextureSampler& sampler,
                                             const std::vector<TexturePoint>& points)
{
  std::vector<Vec2f> results(points.size());
  HWY_DYNAMIC_DISPATCH(gradientKernel)(image, sampler, points, results);
  return results;
}

std::vector<Vec4f> testing::proceduralByLanes(const ProceduralTexture& texture,
                                              const std::vector<Vec3f>& points)
{
  std::vector<Vec4f> results(points.size());
  HWY_DYNAMIC_DISPATCH(proceduralKernel)(texture, points, results);
  return results;
}

}  // namespace limn
#endif  // HWY_ONCE
