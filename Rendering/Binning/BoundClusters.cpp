// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Binning/BoundClusters.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Binning/BoundClusters.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Binning/BoundClusters-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(boundClustersKernel);

BoundsTransform::BoundsTransform(const Mat4d& localToClip) : toClip(localToClip), slope(0)
{
  const double* z = localToClip.m[2];
  const double* w = localToClip.m[3];
  const double square = (w[0] * w[0] + w[1] * w[1]) + w[2] * w[2];
  if (!(square > 0)) return;
  slope = ((z[0] * w[0] + z[1] * w[1]) + z[2] * w[2]) / square;
  for (int column = 0; column < 4; ++column)
    toClip.m[2][column] = z[column] - slope * w[column];
}

void boundClusters(const BoundsTransform& transform, Span<const Cluster> clusters,
                   const Viewport& viewport, ClusterBounds* bounds)
{
  HWY_DYNAMIC_DISPATCH(boundClustersKernel)(transform, clusters, viewport, bounds);
}

}  // namespace limn
#endif  // HWY_ONCE
