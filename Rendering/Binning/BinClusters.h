// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Binning/TileBins.h"
#include "Rendering/Vertex/PlacedScene.h"

namespace limn {

/// Drops clusters outside the view and lists the others in the tiles that their boxes touch.
/// Ensures: a cluster stands in each tile where one of its triangles covers a sample.
/// Errors: kTooManyPrimitives if the lists would exceed 2^32 - 1 entries.
Status binClusters(const PlacedScene& scene, int threads, TileBins& bins);

}  // namespace limn
