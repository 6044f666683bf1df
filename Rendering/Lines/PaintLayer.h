// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ImageOutline.h"

namespace limn {

/// Gives a share of a pixel, which is its layer's, the colour of the layer's line: as if that share
/// of the pixel's samples had it. Requires: 0 < share <= count of the layer / samples.
void paintLine(const OutlinePass& pass, int x, int y, float share);

}  // namespace limn
