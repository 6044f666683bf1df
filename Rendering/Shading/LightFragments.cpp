// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Base/Power.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/LightFragments.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Shading/LightFragments-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(lightFragmentsKernel);
HWY_EXPORT(quantizeFragmentsKernel);

void lightFragments(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(lightFragmentsKernel)(context, batch);
}

void quantizeFragments(const FragmentBatch& batch, Rgba8* colors)
{
  HWY_DYNAMIC_DISPATCH(quantizeFragmentsKernel)(batch, colors);
}

}  // namespace limn
#endif  // HWY_ONCE
