// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/BorderBatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Lines/BorderBatch.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Lines/BorderBatch-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(findNearestEdgesKernel);
HWY_EXPORT(coverBordersKernel);

void findNearestEdges(BorderBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(findNearestEdgesKernel)(batch);
}

void coverBorders(BorderBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(coverBordersKernel)(batch);
}

}  // namespace limn
#endif  // HWY_ONCE
