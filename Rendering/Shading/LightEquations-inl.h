// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light equations of Reference/ReferenceShading.cpp, one fragment a lane, operation by
// operation. Compiled once per instruction set by LightFragments.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Power-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
