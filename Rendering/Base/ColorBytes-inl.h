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

/// 0 ... 1 to 0 ... 255, in the lowest byte; what the others hold is of no account, but the second
/// and third are 0. Clamps; a value that is not a number fails all comparisons and becomes 0.
HWY_INLINE Words lowByteOf(V value)
{
  const V bounded = hn::IfThenElse(hn::Lt(value, set(1.0f)), value, set(1.0f));
  const V proper = hn::IfThenElseZero(isPositive(value), bounded);
  // Floats from 2^23 on are whole numbers: the sum is rounded to the nearest, ties to even.
  const V whole = hn::Add(hn::Mul(proper, set(255.0f)), set(0x1p23f));
  return hn::BitCast(hn::RebindToUnsigned<D>(), whole);
}

/// lowByteOf() with nothing in the other bytes.
HWY_INLINE Words byteOf(V value)
{
  return hn::And(lowByteOf(value), hn::Set(hn::RebindToUnsigned<D>(), 0xFF));
}

/// Words whose lowest byte is red; alpha is 0.
HWY_INLINE Words bytesOf(Lanes3 color)
{
  return hn::Or(hn::Or(byteOf(color.x), hn::ShiftLeft<8>(lowByteOf(color.y))),
                hn::ShiftLeft<16>(lowByteOf(color.z)));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
