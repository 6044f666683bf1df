// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours as bytes, a colour a lane. Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Lanes-inl.h"

#if defined(LIMN_COLOR_BYTES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_COLOR_BYTES_INL_H
#undef LIMN_COLOR_BYTES_INL_H
#else
#define LIMN_COLOR_BYTES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::Vec<hn::RebindToUnsigned<D>>;

/// 0 ... 1 to 0 ... 255, in the lowest byte. Clamps; a value that is not a number fails all
/// comparisons and becomes 0.
HWY_INLINE Words byteOf(V value)
{
  const V bounded = hn::IfThenElse(hn::Lt(value, set(1.0f)), positive(value), set(1.0f));
  const V proper = hn::IfThenElseZero(isPositive(value), bounded);
  return hn::BitCast(hn::RebindToUnsigned<D>(), hn::NearestInt(hn::Mul(proper, set(255.0f))));
}

/// Words whose lowest byte is red; alpha is 0.
HWY_INLINE Words bytesOf(Lanes3 color)
{
  return hn::Or(hn::Or(byteOf(color.x), hn::ShiftLeft<8>(byteOf(color.y))),
                hn::ShiftLeft<16>(byteOf(color.z)));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
