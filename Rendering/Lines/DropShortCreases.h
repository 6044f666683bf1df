// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// Takes creases away that cross fewer than ImageOutline::kShortestCrease ways between pixels, one
/// after the other, and hang together with no border of ids, and of whose pixels none touches what
/// another instance shows, or nothing, or a pixel of `edges`. Both are all rows'.
void dropShortCreases(const SurfaceLayers& layers, const LayerRows<EdgeRow>& edges,
                      LayerRows<CreaseRow>& crossings);

}  // namespace limn
