// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EffectPass.h"

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/MapTones.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/MapTones-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(mapTonesKernel);

void mapTones(const EffectPass& pass)
{
  forEachRow(pass.threads, pass.frame.height, [&](int y) {
    HWY_DYNAMIC_DISPATCH(mapTonesKernel)
    (pass.effects, pass.planes.image, y, pass.frame.color + y * pass.frame.rowStride);
  });
}

}  // namespace limn
#endif  // HWY_ONCE
