// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light equations of Reference/ReferenceShading.cpp, one fragment a lane, operation by
// operation. Compiled once per instruction set by LightFragments.cpp.
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct Lanes3 {
  V x, y, z;
};

HWY_INLINE V set(float value)
{
  return hn::Set(D(), value);
}
HWY_INLINE Lanes3 set(Vec3f v)
{
  return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE Lanes3 load(const FragmentBatch::Vectors& v, std::size_t i)
{
  return {hn::Load(D(), v.x + i), hn::Load(D(), v.y + i), hn::Load(D(), v.z + i)};
}
HWY_INLINE void store(Lanes3 v, FragmentBatch::Vectors& to, std::size_t i)
{
  hn::Store(v.x, D(), to.x + i);
  hn::Store(v.y, D(), to.y + i);
  hn::Store(v.z, D(), to.z + i);
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

HWY_INLINE V log2Normal(V x)
{
  using namespace power_detail;
  const hn::RebindToSigned<D> di;
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, kSqrtHalfBits)));
  const V mantissa = hn::BitCast(D(), hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const V f = hn::Sub(mantissa, set(1.0f));
  const V s = hn::Div(f, hn::Add(f, set(2.0f)));
  const V s2 = hn::Mul(s, s);
  V series = set(kLog2Series[4]);
  for (int k = 3; k >= 0; --k)
    series = hn::Add(set(kLog2Series[k]), hn::Mul(s2, series));
  return hn::Add(hn::ConvertTo(D(), exponent), hn::Mul(s, series));
}

HWY_INLINE V exp2Clamped(V y)
{
  using namespace power_detail;
  const hn::RebindToSigned<D> di;
  const M inRange = hn::Ge(y, set(-126.0f));
  const V bounded =
      hn::IfThenElse(hn::Lt(y, set(127.0f)), hn::IfThenElseZero(inRange, y), set(127.0f));
  const auto whole = hn::NearestInt(bounded);
  const V f = hn::Sub(bounded, hn::ConvertTo(D(), whole));
  V series = set(kExp2Series[6]);
  for (int k = 5; k >= 0; --k)
    series = hn::Add(set(kExp2Series[k]), hn::Mul(f, series));
  const V scale = hn::BitCast(D(), hn::ShiftLeft<23>(hn::Add(whole, hn::Set(di, 127))));
  const V result = hn::Mul(hn::Add(set(1.0f), hn::Mul(f, series)), scale);
  return hn::IfThenElseZero(inRange, result);
}

/// power() of Base/Power.h.
HWY_INLINE V powerOf(V x, float p)
{
  if (p == 0.0f) return set(1.0f);
  const M normal = hn::Ge(x, set(power_detail::kSmallestNormal));
  const V safe = hn::IfThenElse(normal, x, set(1.0f));
  return hn::IfThenElseZero(normal, exp2Clamped(hn::Mul(set(p), log2Normal(safe))));
}

struct Surface {
  Lanes3 position, normal;
  Lanes3 ambient, diffuse, specular;
  float power;
};

struct Arrival {
  Lanes3 toward;
  V fall;
};

HWY_INLINE Arrival arrive(const ViewLight& light, Lanes3 position)
{
  if (!light.positional()) return {set(light.towardLight), set(1.0f)};
  const Lanes3 way = sub(set(light.position), position);
  const V squared = dot(way, way);
  const V distance = hn::Sqrt(squared);
  const Lanes3 toward = mul(way, reciprocalIfPositive(distance, distance));
  const V denominator =
      hn::Add(hn::Add(set(light.attenuation.x), hn::Mul(set(light.attenuation.y), distance)),
              hn::Mul(set(light.attenuation.z), squared));
  V fall = reciprocalIfPositive(denominator, denominator);
  if (light.kind == LightKind::kSpot) {
    const V cosine = dot(toward, set(light.towardLight));
    fall = hn::IfThenElseZero(hn::Ge(cosine, set(light.coneCosine)),
                              hn::Mul(fall, powerOf(cosine, light.exponent)));
  }
  return {toward, fall};
}

HWY_INLINE V blinnPhong(Lanes3 l, Lanes3 v, const Surface& s)
{
  return powerOf(positive(dot(s.normal, normalized(add(l, v)))), s.power);
}
HWY_INLINE V reflectedRay(Lanes3 l, Lanes3 v, const Surface& s)
{
  const V twice = hn::Mul(set(2.0f), dot(s.normal, l));
  const Lanes3 r = sub(mul(s.normal, twice), l);
  return powerOf(positive(dot(r, v)), s.power);
}

/// All the context of a batch that does not change from lane to lane.
class Lighting {
 public:
  explicit Lighting(const ShadingContext& context)
      : camera_(context.scene->scene->camera),
        lights_(context.scene->lights),
        ambientLight_(context.scene->scene->ambientLight),
        style_(context.placed->instance->style),
        isLoneHeadlight_(style_.tone == Tone::kNone && style_.reflection == Reflection::kAsVtk &&
                         lights_.size() == 1 && lights_[0].kind == LightKind::kHeadlight),
        isMatt_(isLoneHeadlight_ && isMatt(context.placed->instance->material, lights_[0]))
  {
  }

  /// Whether light() reads Surface::position.
  bool readsPosition() const
  {
    return style_.tone != Tone::kNone ||
           (style_.reflection != Reflection::kNone && !isLoneHeadlight_);
  }

  HWY_INLINE Lanes3 towardEye(Lanes3 position) const
  {
    return camera_.parallel ? set(Vec3f{0, 0, 1}) : normalized(neg(position));
  }

  Lanes3 light(const Surface& s) const
  {
    if (style_.tone != Tone::kNone) return toned(s);
    if (style_.reflection == Reflection::kNone) return add(s.ambient, s.diffuse);
    if (style_.reflection != Reflection::kAsVtk) return chapter(s);
    return isLoneHeadlight_ ? loneHeadlight(s) : asVtk(s);
  }

 private:
  /// Whether the highlight of a lone headlight adds 0, not 0 times infinity.
  static bool isMatt(const Material& material, const ViewLight& light)
  {
    constexpr float kMostPower = 1e6f, kMostColor = 1e30f;
    const auto most = [](Vec3f v) { return std::max({v.x, v.y, v.z}); };
    return (material.specular == 0.0f || most(material.specularColor) == 0.0f) &&
           material.specularPower <= kMostPower && most(light.color) <= kMostColor;
  }
  Lanes3 loneHeadlight(const Surface& s) const
  {
    const V df = positive(s.normal.z);
    const Lanes3 color = set(lights_[0].color);
    const Lanes3 matt = add(s.ambient, mul(s.diffuse, mul(color, df)));
    if (isMatt_) return matt;
    return add(matt, mul(s.specular, mul(color, powerOf(df, s.power))));
  }

  /// What all lights send towards the eye, by way of matt and of glossy reflection.
  struct Reflected {
    Lanes3 diffuse, specular;
  };
  template <class Highlight>
  HWY_INLINE Reflected sum(const Surface& s, Highlight highlight) const
  {
    Reflected sums = {set(Vec3f{0, 0, 0}), set(Vec3f{0, 0, 0})};
    for (const ViewLight& light : lights_) {
      const Arrival at = arrive(light, s.position);
      const V nl = dot(s.normal, at.toward);
      const M lit = isPositive(nl);
      const Lanes3 color = set(light.color);
      sums.diffuse = choose(lit, add(sums.diffuse, mul(color, hn::Mul(at.fall, nl))), sums.diffuse);
      sums.specular =
          choose(lit, add(sums.specular, mul(color, hn::Mul(at.fall, highlight(at.toward)))),
                 sums.specular);
    }
    return sums;
  }

  Lanes3 asVtk(const Surface& s) const
  {
    const Lanes3 v = normalized(neg(s.position));
    const Reflected sums = sum(s, [&](Lanes3 l) HWY_ATTR { return reflectedRay(l, v, s); });
    return add(add(s.ambient, mul(sums.diffuse, s.diffuse)), mul(sums.specular, s.specular));
  }

  Reflected chapterSums(const Surface& s) const
  {
    const Lanes3 v = towardEye(s.position);
    switch (style_.reflection) {
      case Reflection::kBlinnPhong:
        return sum(s, [&](Lanes3 l) HWY_ATTR { return blinnPhong(l, v, s); });
      case Reflection::kPhong:
        return sum(s, [&](Lanes3 l) HWY_ATTR { return reflectedRay(l, v, s); });
      default:
        // Not the sum's own zeros: an infinite light times 0 is not a number.
        return {sum(s, [&](Lanes3) HWY_ATTR { return set(0.0f); }).diffuse, set(Vec3f{0, 0, 0})};
    }
  }
  Lanes3 chapter(const Surface& s) const
  {
    const Reflected sums = chapterSums(s);
    return add(add(mul(s.ambient, set(ambientLight_)), mul(sums.diffuse, s.diffuse)),
               mul(sums.specular, s.specular));
  }

  Lanes3 toned(const Surface& s) const
  {
    const Lanes3 l = lights_.empty() ? set(Vec3f{0, 0, 1}) : arrive(lights_[0], s.position).toward;
    const V nl = dot(l, s.normal);
    const V facing = hn::Mul(hn::Add(set(1.0f), nl), set(0.5f));
    const V averted = hn::Mul(hn::Sub(set(1.0f), nl), set(0.5f));
    const Lanes3 cool = add(set(style_.toneCool), mul(s.diffuse, set(style_.coolSurface)));
    const Lanes3 warm = add(set(style_.toneWarm), mul(s.diffuse, set(style_.warmSurface)));
    const Lanes3 tone = style_.tone == Tone::kGoochChapter
                            ? add(mul(cool, facing), mul(warm, averted))
                            : add(mul(warm, facing), mul(cool, averted));
    const Lanes3 v = towardEye(s.position);
    return add(tone, mul(s.specular, hn::IfThenElseZero(isPositive(nl), blinnPhong(l, v, s))));
  }

  const Camera& camera_;
  const std::vector<ViewLight>& lights_;
  Vec3f ambientLight_;
  const Style& style_;
  bool isLoneHeadlight_, isMatt_;
};

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
