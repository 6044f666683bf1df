// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vec2f, Vec3f and Vec4f and their functions, one value a lane, operation by operation as in Vec.h.
// Compiled once per instruction set by whoever includes it.
#include "Rendering/Base/Simd.h"
#include "Rendering/Base/Vec.h"

#if defined(LIMN_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_LANES_INL_H
#undef LIMN_LANES_INL_H
#else
#define LIMN_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct Lanes3 {
  V x, y, z;
};

struct Lanes2 {
  V x, y;
};
struct Lanes4 {
  V x, y, z, w;
};

HWY_INLINE V set(float value)
{
  return hn::Set(D(), value);
}
HWY_INLINE Lanes3 set(Vec3f v)
{
  return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE Lanes3 add(Lanes3 a, Lanes3 b)
{
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Lanes3 sub(Lanes3 a, Lanes3 b)
{
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Lanes3 mul(Lanes3 a, Lanes3 b)
{
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Lanes3 mul(Lanes3 a, V s)
{
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Lanes2 set(Vec2f v)
{
  return {set(v.x), set(v.y)};
}
HWY_INLINE Lanes2 add(Lanes2 a, Lanes2 b)
{
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)};
}
HWY_INLINE Lanes2 sub(Lanes2 a, Lanes2 b)
{
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y)};
}
HWY_INLINE Lanes2 mul(Lanes2 a, V s)
{
  return {hn::Mul(a.x, s), hn::Mul(a.y, s)};
}
HWY_INLINE Lanes2 choose(M mask, Lanes2 yes, Lanes2 no)
{
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y)};
}
HWY_INLINE Lanes4 set(Vec4f v)
{
  return {set(v.x), set(v.y), set(v.z), set(v.w)};
}
HWY_INLINE Lanes4 add(Lanes4 a, Lanes4 b)
{
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z), hn::Add(a.w, b.w)};
}
HWY_INLINE Lanes4 sub(Lanes4 a, Lanes4 b)
{
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z), hn::Sub(a.w, b.w)};
}
HWY_INLINE Lanes4 mul(Lanes4 a, V s)
{
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s), hn::Mul(a.w, s)};
}
HWY_INLINE Lanes4 choose(M mask, Lanes4 yes, Lanes4 no)
{
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z), hn::IfThenElse(mask, yes.w, no.w)};
}
HWY_INLINE Lanes3 neg(Lanes3 a)
{
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE Lanes3 choose(M mask, Lanes3 yes, Lanes3 no)
{
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE V dot(Lanes3 a, Lanes3 b)
{
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Lanes3 cross(Lanes3 a, Lanes3 b)
{
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE M isPositive(V x)
{
  return hn::Gt(x, hn::Zero(D()));
}
HWY_INLINE V positive(V x)
{
  return hn::IfThenElseZero(isPositive(x), x);
}
HWY_INLINE V reciprocalIfPositive(V x, V denominator)
{
  return hn::IfThenElseZero(isPositive(x), hn::Div(set(1.0f), denominator));
}
HWY_INLINE Lanes3 normalized(Lanes3 a)
{
  const V squared = dot(a, a);
  return mul(a, reciprocalIfPositive(squared, hn::Sqrt(squared)));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
