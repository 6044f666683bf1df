// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Simd.h"

#include <cstdint>
#include <cstring>

#if defined(LIMN_MASK_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_MASK_BITS_INL_H
#undef LIMN_MASK_BITS_INL_H
#else
#define LIMN_MASK_BITS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

/// Lane i as bit i.
template <class D, class M>
HWY_INLINE std::uint64_t bitsOf(D d, M mask)
{
  std::uint8_t bytes[8] = {};
  hwy::HWY_NAMESPACE::StoreMaskBits(d, mask, bytes);
  std::uint64_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

template <class D>
HWY_INLINE auto maskOf(D d, std::uint64_t bits)
{
  std::uint8_t bytes[8];
  std::memcpy(bytes, &bits, sizeof bits);
  return hwy::HWY_NAMESPACE::LoadMaskBits(d, bytes);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
