// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TransformVertices.cpp.
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Four sums of a matrix and homogeneous points, one point a lane.
template <class D, class V = hn::Vec<D>>
struct ClipLanes {
  V x, y, z, w;
};

template <class D, class T, class V>
HWY_INLINE ClipLanes<D> clipLanes(D d, const Mat4<T>& m, V x, V y, V z)
{
  const auto row = [&](int r) HWY_ATTR {
    const V left = hn::Add(hn::Mul(hn::Set(d, m.m[r][0]), x), hn::Mul(hn::Set(d, m.m[r][1]), y));
    const V right = hn::Add(hn::Mul(hn::Set(d, m.m[r][2]), z), hn::Set(d, m.m[r][3]));
    return hn::Add(left, right);
  };
  return {row(0), row(1), row(2), row(3)};
}

/// Viewport coordinates before rounding; lanes that need clipping are zero.
template <class D, class V = hn::Vec<D>>
struct ScreenLanes {
  V x, y, depth, inverseW;
  hn::Mask<D> needsClip;
};

template <class D>
HWY_INLINE ScreenLanes<D> screenLanes(D d, const InstanceTransform& transform, ClipLanes<D> clip)
{
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  const V zero = hn::Zero(d), half = hn::Set(d, T(0.5));
  const V guard = hn::Set(d, static_cast<T>(kGuardSubpixels));
  const V sx = hn::Set(d, static_cast<T>(transform.subpixelsX));
  const V sy = hn::Set(d, static_cast<T>(transform.subpixelsY));
  const V inverseW = hn::Div(hn::Set(d, T(1)), clip.w);
  const V x = hn::Add(hn::Mul(hn::Mul(clip.x, inverseW), sx), sx);
  const V y = hn::Add(hn::Mul(hn::Mul(clip.y, inverseW), sy), sy);
  const auto inFront = hn::And(hn::Ge(hn::Add(clip.z, clip.w), zero),
                               hn::Ge(clip.w, hn::Set(d, static_cast<T>(kSmallestW))));
  const auto inGuard = hn::And(hn::Le(hn::Abs(x), guard), hn::Le(hn::Abs(y), guard));
  const auto drawable = hn::And(inFront, inGuard);
  const V depth = hn::Add(hn::Mul(hn::Mul(clip.z, inverseW), half), half);
  return {hn::IfThenElseZero(drawable, x), hn::IfThenElseZero(drawable, y),
          hn::IfThenElseZero(drawable, depth), hn::IfThenElseZero(drawable, inverseW),
          hn::Not(drawable)};
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
  const auto load = [&](const std::vector<float>& high, const std::vector<float>& low,
                        std::size_t i) HWY_ATTR {
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
