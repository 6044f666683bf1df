// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sRGB, CIELAB and the tones over colours of data of Reference/ReferenceDataTone.cpp, one colour a
// lane, operation by operation. Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Power-inl.h"
#include "Rendering/Scene.h"

#if defined(LIMN_LAB_COLOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_LAB_COLOR_INL_H
#undef LIMN_LAB_COLOR_INL_H
#else
#define LIMN_LAB_COLOR_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE V bounded(V x)
{
  return hn::IfThenElseZero(isPositive(x), hn::IfThenElse(hn::Lt(x, set(1.0f)), x, set(1.0f)));
}
HWY_INLINE Lanes3 bounded(Lanes3 c)
{
  return {bounded(c.x), bounded(c.y), bounded(c.z)};
}

/// Linear from sRGB, IEC 61966-2-1.
HWY_INLINE V decoded(V c)
{
  const V curve = powerOf(hn::Div(hn::Add(c, set(0.055f)), set(1.055f)), 2.4f);
  return hn::IfThenElse(hn::Gt(c, set(0.04045f)), curve, hn::Div(c, set(12.92f)));
}
HWY_INLINE V encoded(V c)
{
  const V curve = hn::Sub(hn::Mul(set(1.055f), powerOf(c, 1.0f / 2.4f)), set(0.055f));
  return hn::IfThenElse(hn::Gt(c, set(0.0031308f)), curve, hn::Mul(set(12.92f), c));
}

/// A cube root with a straight foot, of CIELAB.
HWY_INLINE V labRoot(V t)
{
  const V foot = hn::Add(hn::Mul(set(7.78703704f), t), set(0.137931034f));
  return hn::IfThenElse(hn::Gt(t, set(0.00885645167f)), powerOf(t, 1.0f / 3.0f), foot);
}
HWY_INLINE V labCube(V f)
{
  const V foot = hn::Mul(hn::Sub(f, set(0.137931034f)), set(0.128418549f));
  return hn::IfThenElse(hn::Gt(f, set(0.206896552f)), hn::Mul(hn::Mul(f, f), f), foot);
}

/// k.x v.x + k.y v.y + k.z v.z
HWY_INLINE V weighed(Vec3f k, Lanes3 v)
{
  return dot(set(k), v);
}

/// f of CIELAB, a sum of channels each; see ReferenceDataTone.cpp.
HWY_NOINLINE Lanes3 labRootsOf(const Lanes3& rgb)
{
  const Lanes3 linear = {decoded(rgb.x), decoded(rgb.y), decoded(rgb.z)};
  return {labRoot(weighed({0.433949941f, 0.376209770f, 0.189840289f}, linear)),
          labRoot(weighed({0.212672874f, 0.715152135f, 0.0721749903f}, linear)),
          labRoot(weighed({0.0177565759f, 0.109467955f, 0.872775469f}, linear))};
}
/// Linear RGB of roots that are all moved by as much.
HWY_INLINE Lanes3 linearOfRoots(Lanes3 f, V by)
{
  const Lanes3 c = {labCube(hn::Add(f.x, by)), labCube(hn::Add(f.y, by)),
                    labCube(hn::Add(f.z, by))};
  return {weighed({3.07995511f, -1.53713900f, -0.542816110f}, c),
          weighed({-0.921258630f, 1.87601112f, 0.0452475100f}, c),
          weighed({0.0528874000f, -0.204025870f, 1.15113847f}, c)};
}

HWY_INLINE M isInGamut(Lanes3 linear)
{
  const auto fits = [](V v) HWY_ATTR {
    return hn::And(hn::Ge(v, set(-1e-5f)), hn::Le(v, set(1.0f + 1e-5f)));
  };
  return hn::And(hn::And(fits(linear.x), fits(linear.y)), fits(linear.z));
}

/// How much of `step` fits into sRGB: all, or a number of 1024ths.
HWY_INLINE V roomInGamut(Lanes3 roots, V step)
{
  const M fits = isInGamut(linearOfRoots(roots, step));
  if (hn::AllTrue(D(), fits)) return set(1.0f);
  V most = set(0.0f), half = set(0.5f);
  for (int i = 0; i < 10; ++i) {
    const V more = hn::Add(most, half);
    most = hn::IfThenElse(isInGamut(linearOfRoots(roots, hn::Mul(step, more))), more, most);
    half = hn::Mul(half, set(0.5f));
  }
  return hn::IfThenElse(fits, set(1.0f), most);
}

HWY_NOINLINE Lanes3 legendSafe(const Lanes3& color, float range, const V& cosine)
{
  const Lanes3 roots = labRootsOf(bounded(color));
  const V most = set(range * (1.0f / 116.0f));
  const V step = hn::IfThenElse(hn::Lt(cosine, set(0.0f)), hn::Neg(most), most);
  const V by = hn::Mul(hn::Mul(most, roomInGamut(roots, step)), cosine);
  const Lanes3 linear = bounded(linearOfRoots(roots, by));
  return {encoded(linear.x), encoded(linear.y), encoded(linear.z)};
}

HWY_NOINLINE Lanes3 undertone(const Style& style, const Lanes3& color, const V& cosine)
{
  const float coolGrey = 0.5f * style.coolSurface, warmGrey = 0.5f * style.warmSurface;
  const bool isExaggerated = style.tone == Tone::kExaggerated;
  const Lanes3 cool =
      set(isExaggerated ? Vec3f{0, 0, 0} : style.toneCool + Vec3f{coolGrey, coolGrey, coolGrey});
  const Lanes3 warm = set(isExaggerated ? Vec3f{0.5f, 0.5f, 0.5f}
                                        : style.toneWarm + Vec3f{warmGrey, warmGrey, warmGrey});
  const V facing = hn::Mul(hn::Add(set(1.0f), cosine), set(0.5f));
  const V averted = hn::Mul(hn::Sub(set(1.0f), cosine), set(0.5f));
  return add(mul(bounded(color), set(1.0f - style.undertone)),
             mul(add(mul(warm, facing), mul(cool, averted)), set(style.undertone)));
}

/// reference::dataTone().
HWY_INLINE Lanes3 dataTone(const Style& style, Lanes3 color, V cosine)
{
  return style.toneOverData == ToneOverData::kUndertone
             ? undertone(style, color, cosine)
             : legendSafe(color, style.legendSafeRange, cosine);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
