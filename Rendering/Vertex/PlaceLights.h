// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Vertex/ViewSpace.h"

#include <vector>

namespace limn {

/// The lights in view space, in their order. Any area or volume light is a sum of point lights (the
/// chapter, 12.2): a rectangle or sphere becomes its samples, the first of them at its centre, each
/// with an equal share of the colour. The samples of a rectangle are those of the additive sequence
/// R2, of a sphere those of R3 that lie in the ball (Roberts, "The unreasonable effectiveness of
/// quasirandom sequences", 2018), in integer arithmetic: the same on every machine.
/// Requires: lights that checkScene() accepted.
std::vector<ViewLight> placeLights(Span<const Light> lights, const Camera& camera);

}  // namespace limn
