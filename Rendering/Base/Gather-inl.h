// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Simd.h"

#include <cstdint>
#include <cstring>

#if defined(LIMN_GATHER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_GATHER_INL_H
#undef LIMN_GATHER_INL_H
#else
#define LIMN_GATHER_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

/// from[indexOf(0)], from[indexOf(1)] ..., a lane each, where indexOf() reads memory: one load and
/// one insertion a lane are faster than what AVX2 has for that, 39 operations on Zen 2 and 3, and
/// slowed down by Intel's remedy against Downfall. Values of 32 bits; `indices` is all of them.
template <class D, class IndexOf, class Indices>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> gatherLanes(D d, const hwy::HWY_NAMESPACE::TFromD<D>* from,
                                                  IndexOf indexOf, Indices indices)
{
#if HWY_TARGET == HWY_AVX2
  (void)indices;
  const auto at = [&](std::size_t lane) HWY_ATTR {
    std::int32_t bits;
    std::memcpy(&bits, from + indexOf(lane), sizeof bits);
    return bits;
  };
  using Words = hwy::HWY_NAMESPACE::Vec<hwy::HWY_NAMESPACE::RebindToSigned<D>>;
  if constexpr (sizeof(Words) == 16)
    return hwy::HWY_NAMESPACE::BitCast(d, Words{_mm_setr_epi32(at(0), at(1), at(2), at(3))});
  else
    return hwy::HWY_NAMESPACE::BitCast(
        d, Words{_mm256_setr_epi32(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7))});
#else
  (void)indexOf;
  return hwy::HWY_NAMESPACE::GatherIndex(d, from, indices());
#endif
}

/// Likewise with a vector of indices in memory.
template <class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> gatherLanes(D d, const hwy::HWY_NAMESPACE::TFromD<D>* from,
                                                  const std::int32_t* index)
{
  const hwy::HWY_NAMESPACE::RebindToSigned<D> di;
  return gatherLanes(
      d, from, [&](std::size_t lane) { return index[lane]; },
      [&]() HWY_ATTR { return hwy::HWY_NAMESPACE::Load(di, index); });
}

/// Likewise of bytes, the three behind each of which have to be there too.
template <class DI>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<DI> gatherBytes(DI d, const std::uint8_t* from,
                                                   const std::int32_t* index)
{
  namespace hn = hwy::HWY_NAMESPACE;
#if HWY_TARGET == HWY_AVX2
  (void)d;
  const auto at = [&](std::size_t lane) HWY_ATTR { return std::int32_t{from[index[lane]]}; };
  return hn::Vec<DI>{_mm256_setr_epi32(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7))};
#else
  const auto words = reinterpret_cast<const std::int32_t*>(from);
  return hn::And(hn::GatherOffset(d, words, hn::Load(d, index)), hn::Set(d, 0xFF));
#endif
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
