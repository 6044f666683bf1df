// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

namespace limn::reference {

/// CIELAB's L*, a*, b* of the white point D65, from an sRGB colour of 0 to 1.
Vec3f labOf(Vec3f rgb);

/// The most of `step` (1, or a multiple of 1/1024) by which the colour's L* may go with a* and b*
/// kept without leaving sRGB. Requires: |step| <= 100.
float roomInGamut(Vec3f rgb, float step);

/// The colour of data under a tone, as Style::toneOverData says; not for kClassic. `cosine` is l.n,
/// or less or more where the tone has turned it or cut it into bands.
Vec3f dataTone(const Style& style, Vec3f color, float cosine);

}  // namespace limn::reference
