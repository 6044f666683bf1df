// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// clipPoint() and screenVertex() of ViewSpace.h, one vertex a lane. Included once per instruction
// set.
#include "Rendering/Base/Simd.h"

#if defined(LIMN_SCREEN_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_SCREEN_LANES
#undef LIMN_SCREEN_LANES
#else
#define LIMN_SCREEN_LANES
#endif

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

/// Viewport coordinates before rounding.
template <class D, class V = hn::Vec<D>>
struct ViewportLanes {
  V x, y, depth, inverseW;
};

template <class D>
HWY_INLINE ViewportLanes<D> viewportLanes(D d, const InstanceTransform& transform,
                                          ClipLanes<D> clip)
{
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  const V half = hn::Set(d, T(0.5));
  const V sx = hn::Set(d, static_cast<T>(transform.subpixelsX));
  const V sy = hn::Set(d, static_cast<T>(transform.subpixelsY));
  const V inverseW = hn::Div(hn::Set(d, T(1)), clip.w);
  return {hn::Add(hn::Mul(hn::Mul(clip.x, inverseW), sx), sx),
          hn::Add(hn::Mul(hn::Mul(clip.y, inverseW), sy), sy),
          hn::Add(hn::Mul(hn::Mul(clip.z, inverseW), half), half), inverseW};
}

/// Likewise; lanes that need clipping are zero.
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
  const V zero = hn::Zero(d), guard = hn::Set(d, static_cast<T>(kGuardSubpixels));
  const ViewportLanes<D> at = viewportLanes(d, transform, clip);
  const auto inFront = hn::And(hn::Ge(hn::Add(clip.z, clip.w), zero),
                               hn::Ge(clip.w, hn::Set(d, static_cast<T>(kSmallestW))));
  const auto inGuard = hn::And(hn::Le(hn::Abs(at.x), guard), hn::Le(hn::Abs(at.y), guard));
  const auto drawable = hn::And(inFront, inGuard);
  return {hn::IfThenElseZero(drawable, at.x), hn::IfThenElseZero(drawable, at.y),
          hn::IfThenElseZero(drawable, at.depth), hn::IfThenElseZero(drawable, at.inverseW),
          hn::Not(drawable)};
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // LIMN_SCREEN_LANES
