// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

namespace limn {

/// What a picture shows of an intensity: no more than 1, which is full.
inline float full(float intensity)
{
  return intensity < 1.0f ? intensity : 1.0f;
}
inline Vec3f full(Vec3f color)
{
  return {full(color.x), full(color.y), full(color.z)};
}

}  // namespace limn
