// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Include inside a file that is compiled once per instruction set.
#include "Rendering/Base/Simd.h"

#include <cstdint>
#include <cstring>

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
