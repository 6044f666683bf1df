// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// Takes steps away that are seen in fewer than ImageOutline::kSmallestStep pixels that touch each
/// other, by sides or by corners, and in none that touches what another instance shows, or nothing,
/// or a pixel that a crease crosses: there they are parts of its line. `edges` and `crossings` are
/// all rows'.
void dropSpecks(const SurfaceLayers& layers, const std::vector<CreaseRow>& crossings,
                std::vector<EdgeRow>& edges);

}  // namespace limn
