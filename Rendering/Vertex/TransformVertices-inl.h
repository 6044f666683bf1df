// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TransformVertices.cpp.
#include "Rendering/Base/Simd.h"
#include "Rendering/Vertex/ScreenLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void transformInFloat(const PlacedCluster& cluster, ScreenVertices& screen)
{
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const ClusteredMesh& mesh = cluster.mesh();
  const InstanceTransform& transform = cluster.placed->transform;
  const std::size_t first = cluster.cluster->firstVertex;
  for (std::size_t i = 0; i < cluster.cluster->vertexCount; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, mesh.x.data() + first + i);
    const auto y = hn::LoadU(d, mesh.y.data() + first + i);
    const auto z = hn::LoadU(d, mesh.z.data() + first + i);
    const auto lanes = screenLanes(d, transform, clipLanes(d, transform.toClipFloat, x, y, z));
    hn::Store(hn::NearestInt(lanes.x), di, screen.x + i);
    hn::Store(hn::NearestInt(lanes.y), di, screen.y + i);
    hn::Store(lanes.depth, d, screen.depth + i);
    hn::Store(lanes.inverseW, d, screen.inverseW + i);
    hn::Store(hn::BitCast(di, hn::VecFromMask(d, lanes.needsClip)), di, screen.needsClip + i);
  }
}

void transformInDouble(const PlacedCluster& cluster, ScreenVertices& screen)
{
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const ClusteredMesh& mesh = cluster.mesh();
  const InstanceTransform& transform = cluster.placed->transform;
  const std::size_t first = cluster.cluster->firstVertex;
  const auto load = [&](const Array<float>& high, const Array<float>& low, std::size_t i) HWY_ATTR {
    const auto h = hn::PromoteTo(d, hn::LoadU(df, high.data() + first + i));
    // Adding +0 makes -0 into +0, as the scalar code does.
    const auto l =
        low.empty() ? hn::Zero(d) : hn::PromoteTo(d, hn::LoadU(df, low.data() + first + i));
    return hn::Add(h, l);
  };
  for (std::size_t i = 0; i < cluster.cluster->vertexCount; i += hn::Lanes(d)) {
    const auto lanes =
        screenLanes(d, transform,
                    clipLanes(d, transform.toClip, load(mesh.x, mesh.xLow, i),
                              load(mesh.y, mesh.yLow, i), load(mesh.z, mesh.zLow, i)));
    hn::Store(hn::DemoteTo(di, hn::Round(lanes.x)), di, screen.x + i);
    hn::Store(hn::DemoteTo(di, hn::Round(lanes.y)), di, screen.y + i);
    hn::Store(hn::DemoteTo(df, lanes.depth), df, screen.depth + i);
    hn::Store(hn::DemoteTo(df, lanes.inverseW), df, screen.inverseW + i);
    const auto flag = hn::IfThenElseZero(lanes.needsClip, hn::Set(d, -1.0));
    hn::Store(hn::DemoteTo(di, flag), di, screen.needsClip + i);
  }
}

void transformVerticesKernel(const PlacedCluster& cluster, ScreenVertices& screen)
{
  if (cluster.placed->transform.precise)
    transformInDouble(cluster, screen);
  else
    transformInFloat(cluster, screen);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
