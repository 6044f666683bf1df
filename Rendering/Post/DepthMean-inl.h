// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by DepthMean.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void weightedSumKernel(const WeightedSum& sum, std::size_t count, float* out)
{
  for (std::size_t x = 0; x < count; x += hn::Lanes(D())) {
    V total = hn::Zero(D());
    for (int k = sum.first; k <= sum.last; ++k)
      total =
          hn::Add(total, hn::Mul(set(sum.weights[k]), hn::LoadU(D(), sum.in + x + k * sum.step)));
    hn::StoreU(total, D(), out + x);
  }
}

void betweenRowsKernel(const float* below, const float* above, float t, std::size_t count,
                       float* out)
{
  for (std::size_t x = 0; x < count; x += hn::Lanes(D())) {
    const V low = hn::LoadU(D(), below + x), high = hn::LoadU(D(), above + x);
    hn::StoreU(hn::Add(low, hn::Mul(hn::Sub(high, low), set(t))), D(), out + x);
  }
}

/// Between the values of the blocks whose centres lie on both sides; `line` starts with a block
/// before the first.
HWY_INLINE V betweenBlocks(const float* line, hn::Vec<hn::RebindToSigned<D>> left, V s)
{
  const V first = hn::GatherIndex(D(), line, left);
  const V second = hn::GatherIndex(D(), line + 1, left);
  return hn::Add(first, hn::Mul(hn::Sub(second, first), s));
}

void unsharpKernel(const UnsharpLines& lines, const UnsharpRow& row)
{
  const hn::RebindToSigned<D> di;
  for (int x = 0; x < lines.width; x += static_cast<int>(hn::Lanes(D()))) {
    const V darken = hn::LoadU(D(), row.darken + x);
    const M isAsked = isPositive(darken);
    if (hn::AllFalse(D(), isAsked)) continue;
    const V column = hn::ConvertTo(D(), hn::Iota(di, x));
    const V u = hn::Sub(hn::Div(hn::Add(column, set(0.5f)), set(lines.side)), set(0.5f));
    const V left = hn::Floor(u);
    const V s = hn::Sub(u, left);
    // What lies beyond the picture's end in a vector has no block.
    const V last = set(lines.lastBlock);
    const auto block =
        hn::Add(hn::ConvertTo(di, hn::IfThenElse(hn::Lt(last, left), last, left)), hn::Set(di, 1));
    const V mean =
        hn::Div(betweenBlocks(lines.distance, block, s), betweenBlocks(lines.weight, block, s));
    const V difference = hn::Sub(mean, hn::LoadU(D(), row.distance + x));
    const V g = hn::Div(difference, hn::Mul(set(lines.sigma), hn::LoadU(D(), row.pixel + x)));
    const V share = hn::Div(g, hn::Add(set(1.0f), hn::Abs(g)));
    const V strength = hn::IfThenElse(isPositive(share), hn::LoadU(D(), row.lighten + x), darken);
    hn::StoreU(hn::IfThenElse(isAsked, hn::Mul(strength, share), hn::LoadU(D(), row.light + x)),
               D(), row.light + x);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
