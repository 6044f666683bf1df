// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

namespace limn {

/// Joins the crossings on the sides of the squares between the centres of two rows' pixels,
/// those of the same instance. Creases that come to what hides them go on behind it.
void joinCrossings(const OutlinePass& pass, const EdgeFinder& finder, const CreaseRow& row,
                   const CreaseRow& above, CreaseRow& result);

}  // namespace limn
