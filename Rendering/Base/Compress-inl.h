// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/CompressTable.h"
#include "Rendering/Base/MaskBits-inl.h"
#include "Rendering/Base/Simd.h"

#if defined(LIMN_COMPRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_COMPRESS_INL_H
#undef LIMN_COMPRESS_INL_H
#else
#define LIMN_COMPRESS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

/// Writes the chosen lanes of 32 bits, in their order, to where there is room for a whole vector;
/// returns how many. Bit i chooses lane i; others are 0.
template <class D, class V>
HWY_INLINE std::size_t compressStoreBits(D d, V v, std::uint64_t bits,
                                         hwy::HWY_NAMESPACE::TFromD<D>* to)
{
  namespace hn = hwy::HWY_NAMESPACE;
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_SCALAR
  return hn::CompressStore(v, maskOf(d, bits), d, to);
#else
  // Highway 1.0.3 has its table in a local variable, which GCC copies to the stack at each call.
  static_assert(HWY_MAX_BYTES / sizeof(hn::TFromD<D>) <= 8, "a row of the table for each mask");
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::uint8_t, D> d8;
  const auto lanes = hn::PromoteTo(di, hn::LoadU(d8, kLanesOfMask[bits].data()));
  hn::StoreU(hn::TableLookupLanes(v, hn::IndicesFromVec(d, lanes)), d, to);
  return hwy::PopCount(bits);
#endif
}

/// Likewise by a mask.
template <class D, class V, class M>
HWY_INLINE std::size_t compressStore(D d, V v, M chosen, hwy::HWY_NAMESPACE::TFromD<D>* to)
{
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_SCALAR
  return hwy::HWY_NAMESPACE::CompressStore(v, chosen, d, to);
#else
  return compressStoreBits(d, v, bitsOf(d, chosen), to);
#endif
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
