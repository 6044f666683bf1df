// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchField.h"
#include "Rendering/Lines/HatchStrokes.h"

namespace limn {

/// Streamlines of both families of a field, over the triangles, until they meet a border, a crease,
/// another of their family that is too near, or a cut where families swap (Jobard and Lefer 1997).
/// In six rounds, each with half the distance of the one before; ranks are random within a round.
/// On framed flat regions straight lines instead: see hatchFlats(). The same on any number of
/// threads.
HatchStrokes traceHatching(const HatchSurface& surface, const HatchField& field, int threads);

}  // namespace limn
