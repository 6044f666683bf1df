// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// power() of Power.h, one value a lane. Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Power.h"

#if defined(LIMN_POWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_POWER_INL_H
#undef LIMN_POWER_INL_H
#else
#define LIMN_POWER_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE V log2Normal(V x)
{
  using namespace power_detail;
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, kSqrtHalfBits)));
  const V mantissa = hn::BitCast(D(), hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const V f = hn::Sub(mantissa, set(1.0f));
  const V s = hn::Div(f, hn::Add(f, set(2.0f)));
  const V s2 = hn::Mul(s, s);
  V series = set(kLog2Series[4]);
  for (int k = 3; k >= 0; --k)
    series = hn::Add(set(kLog2Series[k]), hn::Mul(s2, series));
  return hn::Add(hn::ConvertTo(D(), exponent), hn::Mul(s, series));
}

HWY_INLINE V exp2Clamped(V y)
{
  using namespace power_detail;
  const hn::RebindToSigned<D> di;
  const M inRange = hn::Ge(y, set(-126.0f));
  const V bounded =
      hn::IfThenElse(hn::Lt(y, set(127.0f)), hn::IfThenElseZero(inRange, y), set(127.0f));
  const auto whole = hn::NearestInt(bounded);
  const V f = hn::Sub(bounded, hn::ConvertTo(D(), whole));
  V series = set(kExp2Series[6]);
  for (int k = 5; k >= 0; --k)
    series = hn::Add(set(kExp2Series[k]), hn::Mul(f, series));
  const V scale = hn::BitCast(D(), hn::ShiftLeft<23>(hn::Add(whole, hn::Set(di, 127))));
  const V result = hn::Mul(hn::Add(set(1.0f), hn::Mul(f, series)), scale);
  return hn::IfThenElseZero(inRange, result);
}

/// power() of Base/Power.h.
HWY_INLINE V powerOf(V x, float p)
{
  if (p == 0.0f) return set(1.0f);
  const M normal = hn::Ge(x, set(power_detail::kSmallestNormal));
  const int squarings = squaringsFor(p);
  if (squarings >= 0) {
    V result = hn::IfThenElseZero(normal, x);
    for (int i = 0; i < squarings; ++i)
      result = hn::Mul(result, result);
    return result;
  }
  const V safe = hn::IfThenElse(normal, x, set(1.0f));
  return hn::IfThenElseZero(normal, exp2Clamped(hn::Mul(set(p), log2Normal(safe))));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
