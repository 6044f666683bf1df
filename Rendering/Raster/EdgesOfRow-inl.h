// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by those who include it.
#if defined(LIMN_EDGES_OF_ROW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_EDGES_OF_ROW_INL
#undef LIMN_EDGES_OF_ROW_INL
#else
#define LIMN_EDGES_OF_ROW_INL
#endif

#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Edge values at neighbouring pixels of a row, in float: `first` and what `perColumn` adds to it,
/// one by one, both exact.
template <class DF>
HWY_INLINE hn::Vec<DF> edgesOfRow(DF df, double first, const double* perColumn)
{
  const hn::CappedTag<double, hn::MaxLanes(DF())> d;
  const auto at = [&](std::size_t column) HWY_ATTR {
    return hn::Add(hn::Set(d, first), hn::Load(d, perColumn + column));
  };
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(d) < hn::MaxLanes(df)) {
    const hn::Half<DF> half;
    return hn::Combine(df, hn::DemoteTo(half, at(hn::Lanes(d))), hn::DemoteTo(half, at(0)));
  } else
#endif
    return hn::DemoteTo(df, at(0));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
