// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by BoundClusters.cpp. One cluster a lane, in double.
#include "Rendering/Base/Gather-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

// Rounding moves a vertex by less than this (ViewSpace.h: 1/32 pixel, and half a subpixel).
constexpr double kMarginPixels = 0.125;
// Of a sum of a row's terms in float, relative to the terms; by far.
constexpr double kRowRounding = 1e-6;
// Of a sample's depth, by the divide, the viewport, the depth plane and the sum over it: some units
// of 2^-24 each.
constexpr double kDepthRounding = 4e-6;
constexpr double kSmallestWhole =
    1e-20;  // far above kSmallestW, that a vertex needs clipping below

HWY_INLINE V set(double value)
{
  return hn::Set(D(), value);
}
HWY_INLINE V smaller(V a, V b)
{
  return hn::IfThenElse(hn::Lt(a, b), a, b);
}
HWY_INLINE V larger(V a, V b)
{
  return hn::IfThenElse(hn::Gt(a, b), a, b);
}

struct Interval {
  V low, high;
  V rounding;  ///< included in low and high
};

/// Boxes as middle and half of their sides.
struct Boxes {
  V middle[3], half[3];

  Boxes(const Cluster* clusters, const std::int32_t* index)
  {
    const hn::Rebind<float, D> df;
    for (int axis = 0; axis < 3; ++axis) {
      const V low = hn::PromoteTo(D(), gatherLanes(df, &clusters->low.x + axis, index));
      const V high = hn::PromoteTo(D(), gatherLanes(df, &clusters->high.x + axis, index));
      middle[axis] = hn::Mul(set(0.5), hn::Add(low, high));
      half[axis] = hn::Mul(set(0.5), hn::Sub(high, low));
    }
  }

  /// Range of one row of the matrix.
  HWY_INLINE Interval row(const Mat4d& m, int r) const
  {
    V centre = set(m.m[r][3]), radius = set(0), terms = hn::Abs(centre);
    for (int axis = 0; axis < 3; ++axis) {
      const V a = set(m.m[r][axis]);
      const V part = hn::Mul(a, middle[axis]), reach = hn::Abs(hn::Mul(a, half[axis]));
      centre = hn::Add(centre, part);
      radius = hn::Add(radius, reach);
      terms = hn::Add(terms, hn::Add(hn::Abs(part), reach));
    }
    const V rounding = hn::Mul(set(kRowRounding), terms);
    radius = hn::Add(radius, rounding);
    return {hn::Sub(centre, radius), hn::Add(centre, radius), rounding};
  }
};

/// First and one past the last pixel of ndc coordinates c/w on a viewport of some size, cut to it
/// and its apron; in front of the eye.
struct PixelRange {
  V first, end;
  M isWhole;  ///< not cut

  PixelRange(const Interval& c, V nearScale, V farScale, int size, int apron)
  {
    const V low = smaller(hn::Mul(c.low, nearScale), hn::Mul(c.low, farScale));
    const V high = larger(hn::Mul(c.high, nearScale), hn::Mul(c.high, farScale));
    const V half = set(0.5 * size);
    const auto pixel = [&](V ndc, double margin) HWY_ATTR {
      return hn::Floor(hn::Add(hn::Add(hn::Mul(ndc, half), half), set(margin)));
    };
    const V from = pixel(low, -kMarginPixels), to = hn::Add(pixel(high, kMarginPixels), set(1));
    const V least = set(-apron), most = set(size + apron);
    first = smaller(larger(from, least), most);
    end = smaller(larger(to, least), most);
    isWhole = hn::And(hn::Eq(first, from), hn::Eq(end, to));
  }
};

void boundClustersKernel(const BoundsTransform& transform, Span<const Cluster> clusters,
                         const Viewport& viewport, ClusterBounds* bounds)
{
  const auto [width, height, apron] = viewport;
  const hn::Rebind<std::int32_t, D> di;
  const hn::Rebind<float, D> df;
  constexpr std::size_t kMaxLanes = HWY_MAX_BYTES / sizeof(double);
  static_assert(sizeof(Cluster) % sizeof(float) == 0, "a stride of floats");
  constexpr auto kStride = static_cast<std::int32_t>(sizeof(Cluster) / sizeof(float));
  for (std::size_t i = 0; i < clusters.size(); i += hn::Lanes(D())) {
    const std::size_t count = std::min(hn::Lanes(D()), clusters.size() - i);
    // Lanes behind the last cluster stand for the last one again.
    alignas(64) std::int32_t index[kMaxLanes];
    for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
      index[lane] = static_cast<std::int32_t>(std::min(lane, count - 1)) * kStride;
    const Boxes boxes(&clusters[i], index);
    const Interval w = boxes.row(transform.toClip, 3), rest = boxes.row(transform.toClip, 2);

    const M inFront = hn::Gt(w.low, set(0));
    const V nearScale = hn::Div(set(1), hn::IfThenElse(inFront, w.low, set(1)));
    const V farScale = hn::Div(set(1), hn::IfThenElse(inFront, w.high, set(1)));
    const V slope = set(transform.slope);
    const V low =
        hn::Add(slope, smaller(hn::Mul(rest.low, nearScale), hn::Mul(rest.low, farScale)));
    const V high =
        hn::Add(slope, larger(hn::Mul(rest.high, nearScale), hn::Mul(rest.high, farScale)));
    // z is summed up in float from all its terms, not only from the rest.
    const V sums = hn::Add(hn::Mul(hn::Add(set(1), hn::Abs(slope)), w.rounding), rest.rounding);
    const V planes =
        hn::Mul(set(kDepthRounding), hn::Add(set(1), larger(hn::Abs(low), hn::Abs(high))));
    const V rounding = hn::Add(hn::Mul(sums, nearScale), planes);
    const M beyond =
        hn::Or(hn::Lt(hn::Add(high, rounding), set(-1)), hn::Gt(hn::Sub(low, rounding), set(1)));
    const M nowhere = hn::Or(hn::And(inFront, beyond), hn::Lt(w.high, set(0)));
    const V nearest = hn::Sub(hn::Add(hn::Mul(low, set(0.5)), set(0.5)), rounding);

    const PixelRange x(boxes.row(transform.toClip, 0), nearScale, farScale, width, apron);
    const PixelRange y(boxes.row(transform.toClip, 1), nearScale, farScale, height, apron);
    const auto pixels = [&](V inView, double whole) HWY_ATTR {
      return hn::DemoteTo(di,
                          hn::IfThenZeroElse(nowhere, hn::IfThenElse(inFront, inView, set(whole))));
    };
    alignas(64) std::int32_t x0[kMaxLanes], y0[kMaxLanes], x1[kMaxLanes], y1[kMaxLanes];
    alignas(64) float depth[kMaxLanes];
    alignas(64) std::int32_t whole[kMaxLanes];
    const M isWhole =
        hn::And(hn::And(inFront, hn::Gt(hn::Sub(low, rounding), set(-1))),
                hn::And(hn::And(x.isWhole, y.isWhole), hn::Gt(w.low, set(kSmallestWhole))));
    hn::Store(hn::DemoteTo(di, hn::IfThenElseZero(isWhole, set(1))), di, whole);
    hn::Store(pixels(x.first, -apron), di, x0);
    hn::Store(pixels(y.first, -apron), di, y0);
    hn::Store(pixels(x.end, width + apron), di, x1);
    hn::Store(pixels(y.end, height + apron), di, y1);
    hn::Store(hn::DemoteTo(df, hn::IfThenElseZero(inFront, nearest)), df, depth);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const bool empty = x0[lane] >= x1[lane] || y0[lane] >= y1[lane];
      bounds[i + lane] = {static_cast<std::int16_t>(x0[lane]),
                          static_cast<std::int16_t>(y0[lane]),
                          static_cast<std::int16_t>(empty ? x0[lane] : x1[lane]),
                          static_cast<std::int16_t>(y1[lane]),
                          depth[lane],
                          whole[lane] != 0,
                          clusters[i + lane].vertexCount,
                          clusters[i + lane].triangleCount,
                          clusters[i + lane].firstVertex,
                          clusters[i + lane].firstTriangle};
    }
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
