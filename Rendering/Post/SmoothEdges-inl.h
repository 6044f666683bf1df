// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by SmoothEdges.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/MaskBits-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void lumaRowKernel(const Rgba8* colors, std::size_t width, float* out)
{
  const hn::RebindToUnsigned<D> du;
  constexpr std::size_t kBlock = 64;
  alignas(64) std::uint32_t words[kBlock] = {};
  for (std::size_t x0 = 0; x0 < width; x0 += kBlock) {
    const std::size_t count = std::min(kBlock, width - x0);
    std::memcpy(words, colors + x0, count * sizeof *words);
    for (std::size_t i = 0; i < count; i += hn::Lanes(du)) {
      const auto word = hn::Load(du, words + i);
      const auto channel = [&](hn::Vec<decltype(du)> bits) HWY_ATTR {
        const auto byte = hn::And(bits, hn::Set(du, 0xFFu));
        return hn::ConvertTo(D(), hn::BitCast(hn::RebindToSigned<D>(), byte));
      };
      const Lanes3 rgb = {channel(word), channel(hn::ShiftRight<8>(word)),
                          channel(hn::ShiftRight<16>(word))};
      hn::StoreU(hn::Mul(dot(rgb, set(kLumaShares)), set(1.0f / 255)), D(), out + x0 + i);
    }
  }
}

/// Lists the pixels of a row whose neighbours stand out from each other; returns how many.
std::size_t findEdgesKernel(const Fxaa& fxaa, const LumaRows& luma, std::size_t width,
                            std::uint16_t* found)
{
  const V relativeThreshold = set(fxaa.relativeContrastThreshold);
  const V hardThreshold = set(fxaa.hardContrastThreshold);
  std::size_t count = 0;
  for (std::size_t x = 0; x < width; x += hn::Lanes(D())) {
    V least = hn::LoadU(D(), luma.here + x), most = least;
    const auto include = [&](const float* at) HWY_ATTR {
      const V v = hn::LoadU(D(), at);
      least = hn::IfThenElse(hn::Lt(v, least), v, least);
      most = hn::IfThenElse(hn::Gt(v, most), v, most);
    };
    include(luma.below + x);
    include(luma.above + x);
    include(luma.here + x - 1);
    include(luma.here + x + 1);
    const V relative = hn::Mul(relativeThreshold, most);
    const V threshold = hn::IfThenElse(hn::Gt(relative, hardThreshold), relative, hardThreshold);
    const M isEdge = hn::Not(hn::Lt(hn::Sub(most, least), threshold));
    for (std::uint64_t bits = bitsOf(D(), isEdge); bits != 0; bits &= bits - 1) {
      const std::size_t edge = x + hwy::Num0BitsBelowLS1Bit_Nonzero64(bits);
      if (edge < width) found[count++] = static_cast<std::uint16_t>(edge);
    }
  }
  return count;
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
