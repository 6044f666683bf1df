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

/// Triples of floats, of `count` that lie at `from`: component c of those that `index` names, a
/// lane each, is put to to[c].
template <class D>
HWY_INLINE void gatherTriples(D d, const float* from, std::size_t count, const std::int32_t* index,
                              float* const (&to)[3])
{
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::RebindToSigned<D> di;
#if HWY_TARGET == HWY_AVX2
  // Whole triples are fewer loads and insertions, but read the float behind each.
  const auto last = hn::Set(di, static_cast<std::int32_t>(count - 1));
  if (HWY_LIKELY(hn::AllFalse(di, hn::Eq(hn::Load(di, index), last)))) {
    const auto both = [&](std::size_t lane) HWY_ATTR {
      const __m128 low = _mm_loadu_ps(from + std::ptrdiff_t{3} * index[lane]);
      return _mm256_insertf128_ps(_mm256_castps128_ps256(low),
                                  _mm_loadu_ps(from + std::ptrdiff_t{3} * index[lane + 4]), 1);
    };
    const __m256 a = both(0), b = both(1), c = both(2), e = both(3);
    const __m256 xy0 = _mm256_unpacklo_ps(a, b), xy1 = _mm256_unpacklo_ps(c, e);
    const __m256 z0 = _mm256_unpackhi_ps(a, b), z1 = _mm256_unpackhi_ps(c, e);
    constexpr int kLow = _MM_SHUFFLE(1, 0, 1, 0), kHigh = _MM_SHUFFLE(3, 2, 3, 2);
    _mm256_store_ps(to[0], _mm256_shuffle_ps(xy0, xy1, kLow));
    _mm256_store_ps(to[1], _mm256_shuffle_ps(xy0, xy1, kHigh));
    _mm256_store_ps(to[2], _mm256_shuffle_ps(z0, z1, kLow));
    return;
  }
#endif
  (void)count;
  for (int c = 0; c < 3; ++c) {
    const auto placeOf = [&](std::size_t lane) { return std::ptrdiff_t{3} * index[lane] + c; };
    const auto places = [&]() HWY_ATTR {
      const auto at = hn::Load(di, index);
      return hn::Add(hn::Add(at, hn::Add(at, at)), hn::Set(di, c));
    };
    hn::Store(gatherLanes(d, from, placeOf, places), d, to[c]);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
