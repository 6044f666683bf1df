// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Procedural.h, a point a lane; the steps are those of Procedural.cpp. Compiled once per
// instruction set by whoever includes it.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Texture/Procedural.h"

#if defined(LIMN_PROCEDURAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_PROCEDURAL_INL_H
#undef LIMN_PROCEDURAL_INL_H
#else
#define LIMN_PROCEDURAL_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

namespace procedural {

using namespace procedural_detail;

using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;

HWY_INLINE V mix(V a, V b, V t)
{
  return hn::Add(a, hn::Mul(hn::Sub(b, a), t));
}

HWY_INLINE V nearby(V q)
{
  return hn::IfThenElseZero(hn::Lt(hn::Abs(q), set(kFarthest)), q);
}

HWY_INLINE V faded(V t)
{
  const V inner = hn::Add(hn::Mul(t, hn::Sub(hn::Mul(t, set(6.0f)), set(15.0f))), set(10.0f));
  return hn::Mul(hn::Mul(hn::Mul(t, t), t), inner);
}

HWY_INLINE V alongGradient(VI hash, Lanes3 d)
{
  const DI di;
  const hn::RebindToUnsigned<D> du;
  const auto bits = hn::BitCast(du, hash);
  const auto mixed = hn::Mul(hn::Xor(bits, hn::ShiftRight<15>(bits)), hn::Set(du, kMultiplier));
  const VI edge = hn::BitCast(di, hn::ShiftRight<28>(mixed));
  const auto isBelow = [&](std::int32_t limit) HWY_ATTR {
    return hn::RebindMask(D(), hn::Lt(edge, hn::Set(di, limit)));
  };
  // 12 and 14.
  const M isTwelve = hn::RebindMask(D(), hn::Eq(hn::And(edge, hn::Set(di, 13)), hn::Set(di, 12)));
  const V u = hn::IfThenElse(isBelow(8), d.x, d.y);
  const V v = hn::IfThenElse(isBelow(4), d.y, hn::IfThenElse(isTwelve, d.x, d.z));
  const VI sign = hn::Set(di, static_cast<std::int32_t>(0x80000000u));
  const V uSign = hn::BitCast(D(), hn::ShiftLeft<31>(edge));
  const V vSign = hn::BitCast(D(), hn::And(hn::ShiftLeft<30>(edge), sign));
  return hn::Add(hn::Xor(u, uSign), hn::Xor(v, vSign));
}

struct Axis {
  VI hash0, hash1;
  V distance0, distance1;
  V weight;
};

HWY_INLINE Axis axis(V coordinate, std::uint32_t prime)
{
  const DI di;
  const VI step = hn::Set(di, static_cast<std::int32_t>(prime));
  const V at = nearby(coordinate);
  const V cell = hn::Floor(at);
  const V d = hn::Sub(at, cell);
  const VI hash = hn::Mul(hn::ConvertTo(di, cell), step);
  return {hash, hn::Add(hash, step), d, hn::Sub(d, set(1.0f)), faded(d)};
}

inline V gradientNoise(Lanes3 q)
{
  const Axis x = axis(q.x, kPrime[0]), y = axis(q.y, kPrime[1]), z = axis(q.z, kPrime[2]);
  const auto edge = [&](VI hash, V dy, V dz) HWY_ATTR {
    return mix(alongGradient(hn::Xor(x.hash0, hash), {x.distance0, dy, dz}),
               alongGradient(hn::Xor(x.hash1, hash), {x.distance1, dy, dz}), x.weight);
  };
  const auto face = [&](VI hash, V dz) HWY_ATTR {
    return mix(edge(hn::Xor(y.hash0, hash), y.distance0, dz),
               edge(hn::Xor(y.hash1, hash), y.distance1, dz), y.weight);
  };
  return mix(face(z.hash0, z.distance0), face(z.hash1, z.distance1), z.weight);
}

HWY_INLINE V sineOfTurns(V turns)
{
  const V half = hn::Sub(hn::Sub(turns, hn::Floor(turns)), set(0.5f));
  const V size = hn::Abs(half);
  const V folded = hn::IfThenElse(hn::Gt(size, set(0.25f)), hn::Sub(set(0.5f), size), size);
  const V x = hn::Mul(folded, set(kTwoPi));
  const V x2 = hn::Mul(x, x);
  V series = set(kSineSeries[5]);
  for (int k = 4; k >= 0; --k)
    series = hn::Add(set(kSineSeries[k]), hn::Mul(x2, series));
  const V sine = hn::Mul(x, series);
  return hn::IfThenElse(isPositive(half), hn::Neg(sine), sine);
}

HWY_INLINE V checker(Lanes3 q)
{
  const V shift = set(kShift);
  const auto cell = [&](V c) HWY_ATTR { return hn::Floor(hn::Add(c, shift)); };
  const V cells = hn::Add(hn::Add(cell(q.x), cell(q.y)), cell(q.z));
  return hn::Sub(cells, hn::Mul(set(2.0f), hn::Floor(hn::Mul(cells, set(0.5f)))));
}

HWY_INLINE V wood(Lanes3 q, float turbulence)
{
  const V one = set(1.0f), two = set(2.0f);
  V r = hn::Sqrt(hn::Add(hn::Mul(q.x, q.x), hn::Mul(q.y, q.y)));
  if (turbulence > 0.0f) r = hn::Add(r, hn::Mul(set(turbulence), gradientNoise(q)));
  const V ring = hn::Sub(r, hn::Floor(r));
  const V w = hn::Sub(one, hn::Abs(hn::Sub(hn::Mul(two, ring), one)));
  return hn::Mul(hn::Mul(w, w), hn::Sub(set(3.0f), hn::Mul(two, w)));
}

HWY_INLINE V marble(Lanes3 q, float turbulence)
{
  V turns = q.x;
  if (turbulence > 0.0f) {
    V sum = hn::Zero(D());
    float frequency = 1.0f, share = 1.0f;
    for (int k = 0; k < kOctaves; ++k) {
      sum = hn::Add(sum, hn::Mul(set(share), hn::Abs(gradientNoise(mul(q, set(frequency))))));
      frequency *= 2.0f;
      share *= 0.5f;
    }
    turns = hn::Add(turns, hn::Mul(set(turbulence), sum));
  }
  return hn::Add(set(0.5f), hn::Mul(set(0.5f), sineOfTurns(turns)));
}

}  // namespace procedural

/// proceduralColor() of Procedural.h.
inline Lanes4 proceduralColor(const ProceduralTexture& texture, Lanes3 point)
{
  using namespace procedural;
  const Lanes3 scaled = mul(point, set(texture.scale));
  const Lanes3 q = {nearby(scaled.x), nearby(scaled.y), nearby(scaled.z)};
  const Lanes4 a = set(texture.colorA), b = set(texture.colorB);
  if (texture.kind == ProceduralKind::kChecker) return choose(isPositive(checker(q)), b, a);
  const V t = texture.kind == ProceduralKind::kWood ? wood(q, texture.turbulence)
                                                    : marble(q, texture.turbulence);
  return add(a, mul(sub(b, a), t));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
