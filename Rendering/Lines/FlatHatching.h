// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchField.h"
#include "Rendering/Lines/HatchStrokes.h"

namespace limn {

/// Appends the strokes of framed flat regions: straight, parallel to FlatRegion::along, or across
/// it, spacing apart, from one side of the region to the other. Of those on every 2^k-th line, and
/// no rarer, the rank is sqrt(1/2) / 2^k: so all strokes that are drawn in one light are equally
/// far apart, by that power of two times the spacing that is nearest to what the light takes, by
/// its ratio. The same on any number of threads.
void hatchFlats(const HatchSurface& surface, const FlatRegions& flats, int threads,
                HatchStrokes& strokes);

}  // namespace limn
