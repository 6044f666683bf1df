// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// SampleTexture.h, a point a lane; the steps are those of SampleTexture.cpp, which says why.
// Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Power-inl.h"
#include "Rendering/Texture/SampleTexture.h"

#include <limits>

#if defined(LIMN_SAMPLE_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_SAMPLE_TEXTURE_INL_H
#undef LIMN_SAMPLE_TEXTURE_INL_H
#else
#define LIMN_SAMPLE_TEXTURE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

namespace sample_texture {

using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;

HWY_INLINE V finiteOrZero(V x)
{
  return hn::IfThenElseZero(hn::Le(hn::Abs(x), set(std::numeric_limits<float>::max())), x);
}
HWY_INLINE Lanes2 finiteOrZero(Lanes2 v)
{
  return {finiteOrZero(v.x), finiteOrZero(v.y)};
}

HWY_INLINE V mix(V a, V b, V t)
{
  return hn::Add(a, hn::Mul(hn::Sub(b, a), t));
}
HWY_INLINE Lanes2 mix(Lanes2 a, Lanes2 b, V t)
{
  return {mix(a.x, b.x, t), mix(a.y, b.y, t)};
}
HWY_INLINE Lanes4 mix(Lanes4 a, Lanes4 b, V t)
{
  return {mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t), mix(a.w, b.w, t)};
}

struct Wrapped {
  V value, direction;
};

HWY_INLINE Wrapped wrapped(TextureWrap wrap, V coordinate)
{
  const V u = finiteOrZero(coordinate), one = set(1.0f), two = set(2.0f);
  switch (wrap) {
    case TextureWrap::kRepeat:
      return {hn::Sub(u, hn::Floor(u)), one};
    case TextureWrap::kMirror: {
      const V t = hn::Sub(u, hn::Mul(two, hn::Floor(hn::Mul(u, set(0.5f)))));
      const M turned = hn::Gt(t, one);
      return {hn::IfThenElse(turned, hn::Sub(two, t), t), hn::IfThenElse(turned, set(-1.0f), one)};
    }
    default: {
      const V low = set(-2.0f), high = set(3.0f);
      return {hn::IfThenElse(hn::Gt(u, low), hn::IfThenElse(hn::Lt(u, high), u, high), low), one};
    }
  }
}

struct WrappedUv {
  Wrapped u, v;
};

struct Level {
  V width, height;
  VI columns, rows, offset;
};

HWY_INLINE Level levelOf(const TextureImage& image, std::int32_t number)
{
  const DI di;
  const TextureImage::Levels& levels = image.levels();
  const std::int32_t columns = levels.width[number], rows = levels.height[number];
  return {set(static_cast<float>(columns)), set(static_cast<float>(rows)), hn::Set(di, columns),
          hn::Set(di, rows), hn::Set(di, levels.offset[number])};
}
/// Mostly all lanes are on one level, and its numbers need not be gathered.
HWY_INLINE Level levelOf(const TextureImage& image, VI number)
{
  const DI di;
  const TextureImage::Levels& levels = image.levels();
  const std::int32_t first = hn::GetLane(number);
  if (hn::AllTrue(di, hn::Eq(number, hn::Set(di, first)))) return levelOf(image, first);
  const VI columns = hn::GatherIndex(di, levels.width, number);
  const VI rows = hn::GatherIndex(di, levels.height, number);
  return {hn::ConvertTo(D(), columns), hn::ConvertTo(D(), rows), columns, rows,
          hn::GatherIndex(di, levels.offset, number)};
}

HWY_INLINE VI texelIndex(TextureWrap wrap, VI index, VI side)
{
  const DI di;
  const VI zero = hn::Zero(di), last = hn::Sub(side, hn::Set(di, 1));
  VI i = index;
  switch (wrap) {
    case TextureWrap::kRepeat:
      i = hn::Add(i, hn::IfThenElseZero(hn::Lt(i, zero), side));
      i = hn::Sub(i, hn::IfThenElseZero(hn::Gt(i, last), side));
      break;
    case TextureWrap::kMirror:
      i = hn::IfThenElse(hn::Lt(i, zero), hn::Not(i), i);
      i = hn::IfThenElse(hn::Gt(i, last), hn::Sub(hn::Add(last, side), i), i);
      break;
    case TextureWrap::kClamp:
      break;
    case TextureWrap::kBorder:
      return hn::IfThenElse(hn::Gt(i, last), hn::Set(di, -1), i);
  }
  return hn::Min(hn::Max(i, zero), last);
}

struct Between {
  VI first;
  V weight;
};

HWY_INLINE Between between(TextureFilter filter, V u, V side)
{
  const DI di;
  if (filter == TextureFilter::kNearest)
    return {hn::ConvertTo(di, hn::Floor(hn::Mul(u, side))), set(0.0f)};
  const V x = hn::Sub(hn::Mul(u, side), set(0.5f));
  const V first = hn::Floor(x);
  return {hn::ConvertTo(di, first), hn::Sub(x, first)};
}

/// Texels of one format. An index below 0 is on the border.
template <TexelFormat kFormat>
class Texels {
 public:
  Texels(const TextureImage& image, const TextureSampler& sampler)
      : words_(image.words()),
        hasBorder_(sampler.wrapU == TextureWrap::kBorder || sampler.wrapV == TextureWrap::kBorder),
        border_(sampler.borderColor * image.one())
  {
  }

  HWY_INLINE Lanes4 color(VI row, VI x) const
  {
    const VI at = hn::Add(row, x);
    if (!hasBorder_) return gathered(at);
    const auto outside = isOutside(row, x);
    return choose(hn::RebindMask(D(), outside), set(border_),
                  gathered(hn::IfThenZeroElse(outside, at)));
  }
  /// The red channel of color().
  HWY_INLINE V height(VI row, VI x) const
  {
    const VI at = hn::Add(row, x);
    if (!hasBorder_) return gatheredRed(at);
    const auto outside = isOutside(row, x);
    return hn::IfThenElse(hn::RebindMask(D(), outside), set(border_.x),
                          gatheredRed(hn::IfThenZeroElse(outside, at)));
  }
  /// Number of the texel before a row's first, or below 0 on the border.
  HWY_INLINE VI row(const Level& level, VI y) const
  {
    const DI di;
    const VI first = hn::Add(level.offset, hn::Mul(y, level.columns));
    return hasBorder_ ? hn::IfThenElse(hn::Lt(y, hn::Zero(di)), y, first) : first;
  }

 private:
  static HWY_INLINE auto isOutside(VI row, VI x)
  {
    const DI di;
    return hn::Lt(hn::Or(row, x), hn::Zero(di));
  }
  HWY_INLINE VI word(VI index, std::size_t part) const
  {
    return hn::GatherIndex(DI(), reinterpret_cast<const std::int32_t*>(words_ + part), index);
  }
  template <int kShift, int kBits>
  static HWY_INLINE V part(VI word)
  {
    const hn::RebindToUnsigned<D> du;
    const auto bits = hn::ShiftRight<kShift>(hn::BitCast(du, word));
    const auto kept = kShift + kBits == 32 ? bits : hn::And(bits, hn::Set(du, (1u << kBits) - 1));
    return hn::ConvertTo(D(), hn::BitCast(DI(), kept));
  }
  HWY_INLINE Lanes4 gathered(VI at) const
  {
    if constexpr (kFormat == TexelFormat::kUnorm8) {
      const VI rgba = word(at, 0);
      return {part<0, 8>(rgba), part<8, 8>(rgba), part<16, 8>(rgba), part<24, 8>(rgba)};
    } else if constexpr (kFormat == TexelFormat::kUnorm16) {
      const VI twice = hn::ShiftLeft<1>(at);
      const VI rg = word(twice, 0), ba = word(twice, 1);
      return {part<0, 16>(rg), part<16, 16>(rg), part<0, 16>(ba), part<16, 16>(ba)};
    } else {
      const VI fourfold = hn::ShiftLeft<2>(at);
      const auto channel = [&](std::size_t c)
                               HWY_ATTR { return hn::BitCast(D(), word(fourfold, c)); };
      return {channel(0), channel(1), channel(2), channel(3)};
    }
  }
  HWY_INLINE V gatheredRed(VI at) const
  {
    if constexpr (kFormat == TexelFormat::kUnorm8)
      return part<0, 8>(word(at, 0));
    else if constexpr (kFormat == TexelFormat::kUnorm16)
      return part<0, 16>(word(hn::ShiftLeft<1>(at), 0));
    else
      return hn::BitCast(D(), word(hn::ShiftLeft<2>(at), 0));
  }

  const std::uint32_t* words_;
  bool hasBorder_;
  Vec4f border_;
};

template <TexelFormat kFormat>
class ColorOfLevel {
 public:
  ColorOfLevel(const TextureImage& image, const TextureSampler& sampler)
      : sampler_(sampler), texels_(image, sampler)
  {
  }
  static HWY_INLINE Lanes4 zero() { return set(Vec4f{0, 0, 0, 0}); }

  HWY_NOINLINE Lanes4 operator()(const WrappedUv& at, const Level& level) const
  {
    const VI one = hn::Set(DI(), 1);
    const Between x = between(sampler_.filter, at.u.value, level.width);
    const Between y = between(sampler_.filter, at.v.value, level.height);
    const VI x0 = texelIndex(sampler_.wrapU, x.first, level.columns);
    const VI row0 = texels_.row(level, texelIndex(sampler_.wrapV, y.first, level.rows));
    if (sampler_.filter == TextureFilter::kNearest) return texels_.color(row0, x0);
    const VI x1 = texelIndex(sampler_.wrapU, hn::Add(x.first, one), level.columns);
    const VI row1 =
        texels_.row(level, texelIndex(sampler_.wrapV, hn::Add(y.first, one), level.rows));
    const Lanes4 lower = mix(texels_.color(row0, x0), texels_.color(row0, x1), x.weight);
    const Lanes4 upper = mix(texels_.color(row1, x0), texels_.color(row1, x1), x.weight);
    return mix(lower, upper, y.weight);
  }

 private:
  const TextureSampler& sampler_;
  Texels<kFormat> texels_;
};

template <TexelFormat kFormat>
class GradientOfLevel {
 public:
  GradientOfLevel(const TextureImage& image, const TextureSampler& sampler)
      : sampler_(sampler), texels_(image, sampler)
  {
  }
  static HWY_INLINE Lanes2 zero() { return set(Vec2f{0, 0}); }

  HWY_NOINLINE Lanes2 operator()(const WrappedUv& at, const Level& level) const
  {
    const Between bx = between(sampler_.filter, at.u.value, level.width);
    const Between by = between(sampler_.filter, at.v.value, level.height);
    const auto column = [&](std::int32_t i) HWY_ATTR {
      return texelIndex(sampler_.wrapU, hn::Add(bx.first, hn::Set(DI(), i)), level.columns);
    };
    const auto row = [&](std::int32_t j) HWY_ATTR {
      const VI y = texelIndex(sampler_.wrapV, hn::Add(by.first, hn::Set(DI(), j)), level.rows);
      return texels_.row(level, y);
    };
    const VI before = column(-1), x0 = column(0), x1 = column(1);
    const VI below = row(-1), y0 = row(0), y1 = row(1);
    const auto difference = [&](VI rowTo, VI to, VI rowFrom, VI from) HWY_ATTR {
      return hn::Sub(texels_.height(rowTo, to), texels_.height(rowFrom, from));
    };
    V across = difference(y0, x1, y0, before), up = difference(y1, x0, below, x0);
    if (sampler_.filter != TextureFilter::kNearest) {
      const VI after = column(2), above = row(2);
      across = mix(mix(across, difference(y0, after, y0, x0), bx.weight),
                   mix(difference(y1, x1, y1, before), difference(y1, after, y1, x0), bx.weight),
                   by.weight);
      up = mix(mix(up, difference(y1, x1, below, x1), bx.weight),
               mix(difference(above, x0, y0, x0), difference(above, x1, y0, x1), bx.weight),
               by.weight);
    }
    const V half = set(0.5f);
    return {hn::Mul(across, hn::Mul(hn::Mul(half, level.width), at.u.direction)),
            hn::Mul(up, hn::Mul(hn::Mul(half, level.height), at.v.direction))};
  }

 private:
  const TextureSampler& sampler_;
  Texels<kFormat> texels_;
};

struct Footprint {
  V level, probes;
  Lanes2 axis;
  bool isMagnified;
};

HWY_INLINE Footprint footprint(const TextureImage& image, const TextureSampler& sampler, Lanes2 ddx,
                               Lanes2 ddy)
{
  const V width = set(static_cast<float>(image.width()));
  const V height = set(static_cast<float>(image.height()));
  const V one = set(1.0f);
  const auto squaredLength = [&](Lanes2 d) HWY_ATTR {
    const V x = hn::Mul(d.x, width), y = hn::Mul(d.y, height);
    return hn::Add(hn::Mul(x, x), hn::Mul(y, y));
  };
  const V x2 = squaredLength(ddx), y2 = squaredLength(ddy);
  const M isWide = hn::Gt(x2, y2);
  const V longer2 = hn::IfThenElse(isWide, x2, y2);
  if (hn::AllTrue(D(), hn::Le(longer2, one))) return {hn::Zero(D()), one, ddx, true};
  V probes = one, squared = longer2;
  if (sampler.maxAnisotropy > 1) {
    const V most = set(static_cast<float>(sampler.maxAnisotropy));
    const V shorter = hn::Sqrt(hn::IfThenElse(isWide, y2, x2));
    const V ratio = hn::Div(hn::Sqrt(longer2), hn::IfThenElse(hn::Gt(shorter, one), shorter, one));
    const V wanted = hn::IfThenElse(hn::Lt(ratio, most), hn::Ceil(ratio), most);
    probes = hn::IfThenElse(hn::Gt(wanted, one), wanted, one);
    squared = hn::Div(longer2, hn::Mul(probes, probes));
  }
  const Lanes2 axis = choose(isWide, ddx, ddy);
  const M isMinified = hn::Gt(squared, one);
  if (hn::AllFalse(D(), isMinified)) return {hn::Zero(D()), probes, axis, false};
  const V coarsest = set(static_cast<float>(1 << 2 * (image.levelCount() - 1)));
  const V bounded =
      hn::IfThenElse(isMinified, hn::IfThenElse(hn::Lt(squared, coarsest), squared, coarsest), one);
  return {hn::Mul(set(0.5f), log2Normal(bounded)), probes, axis, false};
}

HWY_INLINE WrappedUv wrapped(const TextureSampler& sampler, Lanes2 uv)
{
  return {wrapped(sampler.wrapU, uv.x), wrapped(sampler.wrapV, uv.y)};
}

template <class AtLevel>
HWY_INLINE auto trilinear(const TextureImage& image, const TextureSampler& sampler, Lanes2 uv,
                          V level, const AtLevel& atLevel)
{
  const DI di;
  const WrappedUv at = wrapped(sampler, uv);
  const VI finer = hn::ConvertTo(di, level);
  const V weight = hn::Sub(level, hn::ConvertTo(D(), finer));
  const auto fine = atLevel(at, levelOf(image, finer));
  const M isBlend = hn::Ne(weight, hn::Zero(D()));
  if (hn::AllFalse(D(), isBlend)) return fine;
  const VI coarser = hn::Min(hn::Add(finer, hn::Set(di, 1)), hn::Set(di, image.levelCount() - 1));
  return choose(isBlend, mix(fine, atLevel(at, levelOf(image, coarser)), weight), fine);
}

template <class AtLevel>
HWY_INLINE auto filtered(const TextureImage& image, const TextureSampler& sampler, Lanes2 uv,
                         Lanes2 ddx, Lanes2 ddy)
{
  const AtLevel atLevel(image, sampler);
  const V unit = set(image.unit()), one = set(1.0f);
  if (sampler.filter != TextureFilter::kTrilinear)
    return mul(atLevel(wrapped(sampler, uv), levelOf(image, 0)), unit);
  const Footprint print = footprint(image, sampler, finiteOrZero(ddx), finiteOrZero(ddy));
  if (sampler.maxAnisotropy == 1)
    return mul(trilinear(image, sampler, uv, print.level, atLevel), unit);
  // Nothing is minified: one probe in the middle of the footprint, at level 0.
  if (print.isMagnified)
    return mul(add(AtLevel::zero(), atLevel(wrapped(sampler, uv), levelOf(image, 0))), unit);
  auto sum = AtLevel::zero();
  const V step = hn::Div(one, hn::Add(print.probes, one));
  V i = one;
  for (M left = hn::Le(i, print.probes); !hn::AllFalse(D(), left); left = hn::Le(i, print.probes)) {
    const V along = hn::Sub(hn::Mul(i, step), set(0.5f));
    const auto probe =
        trilinear(image, sampler, add(uv, mul(print.axis, along)), print.level, atLevel);
    sum = choose(left, add(sum, probe), sum);
    i = hn::Add(i, one);
  }
  return mul(mul(sum, hn::Div(one, print.probes)), unit);
}

}  // namespace sample_texture

/// sampleTexture() of SampleTexture.h. All lanes are read: what is in unused ones does not matter.
inline Lanes4 sampleTexture(const TextureImage& image, const TextureSampler& sampler, Lanes2 uv,
                            Lanes2 ddx, Lanes2 ddy)
{
  using namespace sample_texture;
  switch (image.format()) {
    case TexelFormat::kUnorm8:
      return filtered<ColorOfLevel<TexelFormat::kUnorm8>>(image, sampler, uv, ddx, ddy);
    case TexelFormat::kUnorm16:
      return filtered<ColorOfLevel<TexelFormat::kUnorm16>>(image, sampler, uv, ddx, ddy);
    default:
      return filtered<ColorOfLevel<TexelFormat::kFloat32>>(image, sampler, uv, ddx, ddy);
  }
}

/// heightGradient() of SampleTexture.h.
inline Lanes2 heightGradient(const TextureImage& image, const TextureSampler& sampler, Lanes2 uv,
                             Lanes2 ddx, Lanes2 ddy)
{
  using namespace sample_texture;
  switch (image.format()) {
    case TexelFormat::kUnorm8:
      return filtered<GradientOfLevel<TexelFormat::kUnorm8>>(image, sampler, uv, ddx, ddy);
    case TexelFormat::kUnorm16:
      return filtered<GradientOfLevel<TexelFormat::kUnorm16>>(image, sampler, uv, ddx, ddy);
    default:
      return filtered<GradientOfLevel<TexelFormat::kFloat32>>(image, sampler, uv, ddx, ddy);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
