// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// Takes steps away that are seen in fewer than ImageOutline::kSmallestStep pixels that touch each
/// other, by sides or by corners, and in none that touches what another instance shows, or nothing.
/// Nor do they part pixels any more; and `crossings` that were steps are creases there, and nowhere
/// else. But where normals do not differ as at creases, and a crease crosses the pixel or one that
/// touches it, they are parts of its line and stay. `edges` and `crossings` are all rows'.
void dropSpecks(const SurfaceLayers& layers, LayerRows<CreaseRow>& crossings,
                LayerRows<EdgeRow>& edges, StepGrid& steps);

}  // namespace limn
