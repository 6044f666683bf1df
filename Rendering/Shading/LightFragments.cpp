// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/LightFragments.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Shading/LightFragments-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(lightFragmentsKernel);
HWY_EXPORT(quantizeFragmentsKernel);
HWY_EXPORT(boundRadianceKernel);
HWY_EXPORT(shadeTrianglesKernel);

void lightFragments(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(lightFragmentsKernel)(context, batch);
}

void shadeTriangles(const ShadingContext& context, const TileRectangle& pixels,
                    const FragmentList& fragments, Span<const std::uint32_t> numbers,
                    const FragmentBatch& batch, TileColors& colors)
{
  HWY_DYNAMIC_DISPATCH(shadeTrianglesKernel)(context, pixels, fragments, numbers, batch, colors);
}

void quantizeFragments(const FragmentBatch& batch, Rgba8* colors)
{
  HWY_DYNAMIC_DISPATCH(quantizeFragmentsKernel)(batch, colors);
}

void boundRadiance(FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(boundRadianceKernel)(batch);
}

}  // namespace limn
#endif  // HWY_ONCE
