// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// Takes steps away that are seen in fewer than ImageOutline::kSmallestStep pixels that touch each
/// other, by sides or by corners, and in none that touches what another instance shows, or nothing.
/// `edges` are all rows'.
void dropSpecks(const SurfaceLayers& layers, std::vector<EdgeRow>& edges);

}  // namespace limn
