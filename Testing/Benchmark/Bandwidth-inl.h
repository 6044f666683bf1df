// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by Bandwidth.cxx.
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace bandwidth::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Requires: `words` starts at a multiple of 64 bytes, and `count` is a multiple of 256.
std::uint64_t ReadKernel(const std::uint64_t* words, std::size_t count)
{
  const hn::ScalableTag<std::uint64_t> d;
  const std::size_t lanes = hn::Lanes(d);
  // Four sums, so that no load waits for an addition.
  auto a = hn::Zero(d), b = a, c = a, e = a;
  for (std::size_t i = 0; i < count; i += 4 * lanes)
  {
    a = hn::Add(a, hn::Load(d, words + i));
    b = hn::Add(b, hn::Load(d, words + i + lanes));
    c = hn::Add(c, hn::Load(d, words + i + 2 * lanes));
    e = hn::Add(e, hn::Load(d, words + i + 3 * lanes));
  }
  return hn::GetLane(hn::SumOfLanes(d, hn::Add(hn::Add(a, b), hn::Add(c, e))));
}

/// Requires: as ReadKernel().
void WriteKernel(std::uint64_t* words, std::size_t count)
{
  const hn::ScalableTag<std::uint64_t> d;
  const auto value = hn::Set(d, 1);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
  {
    hn::Stream(value, d, words + i);
  }
}

} // namespace bandwidth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
