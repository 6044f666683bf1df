// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Base/Span.h"
#include "Rendering/Binning/TileBins.h"
#include "Rendering/Mesh/ClusteredMesh.h"
#include "Rendering/Vertex/Viewport.h"

namespace limn {

/// What bounds need of an instance. Depth is z/w = slope + rest/w, where the slope takes out of z
/// all that is proportional to w: in a perspective nearly all, so that the bound is tight.
struct BoundsTransform {
  Mat4d toClip;  ///< row 2 is the rest
  double slope;

  explicit BoundsTransform(const Mat4d& localToClip);
};

/// Finds where clusters may be on a viewport and its apron. Bounds hold for vertices that are
/// transformed in float, too.
void boundClusters(const BoundsTransform& transform, Span<const Cluster> clusters,
                   const Viewport& viewport, ClusterBounds* bounds);

}  // namespace limn
