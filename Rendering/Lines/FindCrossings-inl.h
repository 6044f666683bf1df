// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by FindCrossings.cpp.
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DD = hn::ScalableTag<double>;
using VD = hn::Vec<DD>;

/// The first of four control points' terms, and the other two: (a wa + b wb) + (c wc + d wd).
HWY_INLINE VD cubicAt(const double (&point)[4][3][CrossingBatch::kCapacity], int axis,
                      std::size_t i, const VD (&weight)[4])
{
  const auto term = [&](int k)
                        HWY_ATTR { return hn::Mul(hn::Load(DD(), point[k][axis] + i), weight[k]); };
  return hn::Add(hn::Add(term(0), term(1)), hn::Add(term(2), term(3)));
}

HWY_INLINE void weighCubic(VD t, VD s, VD (&weight)[4])
{
  const VD three = hn::Set(DD(), 3.0);
  weight[0] = hn::Mul(hn::Mul(s, s), s);
  weight[1] = hn::Mul(hn::Mul(hn::Mul(three, s), s), t);
  weight[2] = hn::Mul(hn::Mul(hn::Mul(three, s), t), t);
  weight[3] = hn::Mul(hn::Mul(t, t), t);
}

void findCrossingsKernel(Vec3d eye, bool isParallel, CrossingBatch& batch)
{
  const VD one = hn::Set(DD(), 1.0), half = hn::Set(DD(), 0.5), two = hn::Set(DD(), 2.0);
  const VD from[3] = {hn::Set(DD(), eye.x), hn::Set(DD(), eye.y), hn::Set(DD(), eye.z)};
  VD weight[4];
  for (std::size_t i = 0; i < batch.count; i += hn::Lanes(DD())) {
    VD low = hn::Zero(DD()), high = one;
    const auto startsFront = hn::Eq(hn::Load(DD(), batch.startsFront + i), one);
    for (int step = 0; step < kCrossingHalvings; ++step) {
      const VD t = hn::Mul(half, hn::Add(low, high)), s = hn::Sub(one, t);
      weighCubic(t, s, weight);
      const VD first = hn::Mul(s, s), middle = hn::Mul(hn::Mul(two, s), t), last = hn::Mul(t, t);
      VD product[3];
      for (int axis = 0; axis < 3; ++axis) {
        const auto term = [&](int k, VD by) HWY_ATTR {
          return hn::Mul(hn::Load(DD(), batch.normal[k][axis] + i), by);
        };
        const VD n = hn::Add(hn::Add(term(0, first), term(1, middle)), term(2, last));
        const VD view =
            isParallel ? from[axis] : hn::Sub(from[axis], cubicAt(batch.point, axis, i, weight));
        product[axis] = hn::Mul(n, view);
      }
      const VD slope = hn::Add(hn::Add(product[0], product[1]), product[2]);
      const auto isFront = hn::Ge(slope, hn::Zero(DD()));
      const auto isBefore = hn::Not(hn::Xor(isFront, startsFront));
      low = hn::IfThenElse(isBefore, t, low);
      high = hn::IfThenElse(isBefore, high, t);
    }
    weighCubic(low, hn::Sub(one, low), weight);
    for (int axis = 0; axis < 3; ++axis)
      hn::Store(cubicAt(batch.point, axis, i, weight), DD(), batch.found[axis] + i);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
