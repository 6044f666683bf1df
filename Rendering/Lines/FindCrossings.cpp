// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FindCrossings.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Lines/FindCrossings.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Lines/FindCrossings-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(findCrossingsKernel);

void findCrossings(Vec3d eye, bool isParallel, CrossingBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(findCrossingsKernel)(eye, isParallel, batch);
}

}  // namespace limn
#endif  // HWY_ONCE
