// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by EyeDome.cpp.
#include "Rendering/Base/Power-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The sum of a ring's responses, each at most `most`.
HWY_INLINE V ringSum(const EyeDomeTaps::Ring& ring, const EyeDomeRow& row, int x, V own, V most)
{
  const DistancePlane& distances = row.distances;
  V sum = hn::Zero(D());
  for (const EyeDomeTaps::Tap& tap : ring) {
    const int y = row.y + tap.dy;
    if (y < 0 || y >= distances.height) continue;
    const V other = hn::LoadU(D(), distances.row(y) + x + tap.dx);
    const V response = hn::Mul(positive(hn::Sub(own, other)), set(tap.perLength));
    sum = hn::Add(sum, hn::IfThenElse(hn::Lt(most, response), most, response));
  }
  return sum;
}

void eyeDomeKernel(const EyeDomeTaps& taps, const EyeDomeRow& row)
{
  const auto lanes = static_cast<int>(hn::Lanes(D()));
  for (int x = 0; x < row.distances.width; x += lanes) {
    const V strength = hn::LoadU(D(), row.strength + x);
    const M isAsked = isPositive(strength);
    if (hn::AllFalse(D(), isAsked)) continue;
    const V own = hn::LoadU(D(), row.distances.row(row.y) + x);
    const V pixel = hn::LoadU(D(), row.pixel + x);
    const V most = hn::Mul(set(kEyeDomeSlope), pixel);
    const V fine = ringSum(taps.fine(), row, x, own, most);
    const V coarse = hn::Add(hn::Add(ringSum(taps.coarse(0), row, x, own, most),
                                     ringSum(taps.coarse(1), row, x, own, most)),
                             ringSum(taps.coarse(2), row, x, own, most));
    const V mean =
        hn::Mul(hn::Add(hn::Div(fine, set(8.0f)), hn::Div(coarse, set(24.0f))), set(0.5f));
    const V exponent = hn::Mul(hn::Neg(strength), hn::Div(mean, pixel));
    const V factor = exp2Clamped(hn::Mul(exponent, set(1.44269504f)));
    hn::StoreU(hn::IfThenElse(isAsked, factor, hn::LoadU(D(), row.factor + x)), D(),
               row.factor + x);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
