// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TransformVertices.cpp.
#include "Rendering/Base/Simd.h"
#include "Rendering/Vertex/ScreenLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sums up the vertices' boxes and flags. Lanes behind the last vertex count as the first vertex.
void boundVertices(std::size_t count, ScreenVertices& screen)
{
  const hn::ScalableTag<std::int32_t> d;
  using V = hn::Vec<decltype(d)>;
  const auto smaller = [](V a, V b) HWY_ATTR { return hn::IfThenElse(hn::Lt(a, b), a, b); };
  const auto larger = [](V a, V b) HWY_ATTR { return hn::IfThenElse(hn::Gt(a, b), a, b); };
  const V firstX = hn::Set(d, screen.x[0]), firstY = hn::Set(d, screen.y[0]);
  V minX = firstX, maxX = firstX, minY = firstY, maxY = firstY, clip = hn::Zero(d);
  const V end = hn::Set(d, static_cast<std::int32_t>(count));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto real = hn::Lt(hn::Iota(d, static_cast<std::int32_t>(i)), end);
    const V x = hn::IfThenElse(real, hn::Load(d, screen.x + i), firstX);
    const V y = hn::IfThenElse(real, hn::Load(d, screen.y + i), firstY);
    minX = smaller(minX, x);
    maxX = larger(maxX, x);
    minY = smaller(minY, y);
    maxY = larger(maxY, y);
    clip = hn::Or(clip, hn::IfThenElseZero(real, hn::Load(d, screen.needsClip + i)));
  }
  screen.minX = hn::GetLane(hn::MinOfLanes(d, minX));
  screen.maxX = hn::GetLane(hn::MaxOfLanes(d, maxX));
  screen.minY = hn::GetLane(hn::MinOfLanes(d, minY));
  screen.maxY = hn::GetLane(hn::MaxOfLanes(d, maxY));
  screen.anyNeedsClip = !hn::AllTrue(d, hn::Eq(clip, hn::Zero(d)));
}

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
  boundVertices(cluster.cluster->vertexCount, screen);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
