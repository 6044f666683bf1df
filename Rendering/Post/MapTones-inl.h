// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by MapTones.cpp.
#include "Rendering/Base/ColorBytes-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE Lanes3 divided(Lanes3 color, V by)
{
  return {hn::Div(color.x, by), hn::Div(color.y, by), hn::Div(color.z, by)};
}

HWY_INLINE V academyCurve(V c)
{
  const V above = hn::Mul(c, hn::Add(hn::Mul(set(2.51f), c), set(0.03f)));
  const V below = hn::Add(hn::Mul(c, hn::Add(hn::Mul(set(2.43f), c), set(0.59f))), set(0.14f));
  return hn::Div(above, below);
}

HWY_INLINE Lanes3 toneMapped(const PostEffects& effects, Lanes3 color)
{
  const V luminance = dot(color, set(kLuminance));
  const V below = hn::Add(set(1.0f), luminance);
  switch (effects.toneMapping) {
    case ToneMapping::kReinhard:
      return divided(color, below);
    case ToneMapping::kReinhardExtended: {
      const V white = set(effects.whitePoint * effects.whitePoint);
      return divided(mul(color, hn::Add(set(1.0f), hn::Div(luminance, white))), below);
    }
    case ToneMapping::kAces:
      return {academyCurve(color.x), academyCurve(color.y), academyCurve(color.z)};
    default:
      return color;
  }
}

void mapTonesKernel(const PostEffects& effects, const ColorPlanes& image, int y, Rgba8* colors)
{
  const hn::RebindToUnsigned<D> du;
  constexpr int kBlock = kTileSide;
  alignas(64) std::uint32_t words[kBlock];
  const int width = image[0].width();
  for (int x0 = 0; x0 < width; x0 += kBlock) {
    const auto count = static_cast<std::size_t>(std::min(kBlock, width - x0));
    std::memcpy(words, colors + x0, count * sizeof *words);
    for (std::size_t i = 0; i < count; i += hn::Lanes(du)) {
      const auto at = [&](std::size_t channel)
                          HWY_ATTR { return hn::LoadU(D(), image[channel].row(y) + x0 + i); };
      const auto alpha = hn::And(hn::Load(du, words + i), hn::Set(du, 0xFF000000u));
      hn::Store(hn::Or(alpha, bytesOf(toneMapped(effects, {at(0), at(1), at(2)}))), du, words + i);
    }
    std::memcpy(colors + x0, words, count * sizeof *words);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
