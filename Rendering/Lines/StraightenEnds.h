// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FindEdges.h"

#include <vector>

namespace limn {

/// Where a border comes to what hides it, or to the end of the layers, its normal is told by pixels
/// of which nobody knows what they would show. Such edges of row y go straight on from those before
/// them. Changes nothing that it reads of other rows: several may be worked on at once.
void straightenEnds(const StepGrid& steps, int y, LayerRows<EdgeRow>& edges);

}  // namespace limn
