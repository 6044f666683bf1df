// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The light equations of Reference/ReferenceShading.cpp, one fragment a lane, operation by
// operation. Compiled once per instruction set by LightFragments.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Power-inl.h"
#include "Rendering/Shading/LabColor-inl.h"
#include "Rendering/Shading/ToneEquations-inl.h"

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

HWY_INLINE Arrival arrive(const ViewLight& light, Lanes3 position, bool fallsOff)
{
  if (!light.positional()) return {set(light.towardLight), set(1.0f)};
  const Lanes3 way = sub(set(light.position), position);
  const V squared = dot(way, way);
  const V distance = hn::Sqrt(squared);
  const Lanes3 toward = mul(way, reciprocalIfPositive(distance, distance));
  const V denominator =
      hn::Add(hn::Add(set(light.attenuation.x), hn::Mul(set(light.attenuation.y), distance)),
              hn::Mul(set(light.attenuation.z), squared));
  V fall = fallsOff ? reciprocalIfPositive(denominator, denominator) : set(1.0f);
  if (light.kind == LightKind::kSpot) {
    const V cosine = dot(toward, set(light.towardLight));
    fall = hn::IfThenElseZero(hn::Ge(cosine, set(light.coneCosine)),
                              hn::Mul(fall, powerOf(cosine, light.exponent)));
    if (light.softScale > 0.0f)
      fall = hn::Mul(
          fall, smoothStep(hn::Mul(hn::Sub(cosine, set(light.coneCosine)), set(light.softScale))));
  }
  if (light.kind == LightKind::kRectangle)
    fall = hn::Mul(fall, positive(dot(toward, set(light.towardLight))));
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

constexpr float kInversePi = 0.318309886f;

/// Schlick 1994: f0 head-on, f90 at grazing angles.
HWY_INLINE Lanes3 schlick(Lanes3 f0, Lanes3 f90, V cosine)
{
  const V a = positive(hn::Sub(set(1.0f), cosine));
  const V squared = hn::Mul(a, a);
  return add(f0, mul(sub(f90, f0), hn::Mul(hn::Mul(squared, squared), a)));
}

/// What a dielectric reflects head-on.
inline Vec3f reflectedHeadOn(Vec3f refractiveIndex)
{
  const Vec3f mu = refractiveIndex, one = {1, 1, 1};
  const Vec3f share = {(mu.x - one.x) / (mu.x + one.x), (mu.y - one.y) / (mu.y + one.y),
                       (mu.z - one.z) / (mu.z + one.z)};
  return share * share;
}

/// From `low` to 1.
HWY_INLINE V atLeast(float low, V x)
{
  const V bounded = hn::IfThenElse(hn::Lt(x, set(1.0f)), x, set(1.0f));
  return hn::IfThenElse(hn::Gt(x, set(low)), bounded, set(low));
}

HWY_INLINE V strongest(Lanes3 color)
{
  const V rg = hn::IfThenElse(hn::Gt(color.x, color.y), color.x, color.y);
  return hn::IfThenElse(hn::Gt(rg, color.z), rg, color.z);
}
/// A colour with its hue, as strong as `strength`.
HWY_INLINE Lanes3 withStrength(Lanes3 color, V strength)
{
  const V own = strongest(color);
  return choose(isPositive(own), mul(color, hn::Div(strength, own)), set(Vec3f{0, 0, 0}));
}

/// All the context of a batch that does not change from lane to lane.
class Lighting {
 public:
  /// Surfaces where the normal is without bumps, a pixel to the right and a pixel above.
  struct Place {
    Lanes3 position, normal;
  };
  using Neighbours = Place[3];

  explicit Lighting(const ShadingContext& context)
      : camera_(context.scene->scene->camera),
        lights_(context.scene->lights),
        ambientLight_(context.scene->scene->ambientLight),
        material_(context.placed->instance->material),
        style_(context.placed->instance->style),
        ramp_(style_.ramp, camera_),
        isLoneHeadlight_(style_.tone == Tone::kNone && style_.reflection == Reflection::kAsVtk &&
                         style_.toonBands < 2 && hasLoneHeadlight()),
        isMatt_(isLoneHeadlight_ && isMatt(material_, lights_[0])),
        isSpecial_(isSpecial(material_, style_)),
        tonesData_(context.placed->instance->tonesData()),
        hasToneHighlight_(!tonesData_ && hasToneHighlight(material_, style_))
  {
    if (style_.isExaggerated()) shareDetail(context.placed->instance->attributes);
  }

  /// Whether light() reads Surface::position.
  bool readsPosition() const
  {
    switch (style_.tone) {
      case Tone::kNone:
        return style_.reflection != Reflection::kNone && !isLoneHeadlight_;
      case Tone::kGooch:
      case Tone::kGoochChapter:
      case Tone::kMetal:
        return hasToneHighlight_ || style_.toneLight != ToneLight::kUpperRight;
      default:
        return true;
    }
  }

  HWY_INLINE Lanes3 towardEye(Lanes3 position) const
  {
    return camera_.parallel ? set(Vec3f{0, 0, 1}) : normalized(neg(position));
  }

  HWY_INLINE Lanes3 light(const Surface& s) const
  {
    if (isLoneHeadlight_) return loneHeadlight(s);
    if (isSpecial_) return special(s);
    if (style_.tone != Tone::kNone) return toned(s);
    if (style_.reflection == Reflection::kNone) return add(s.ambient, s.diffuse);
    return style_.reflection == Reflection::kAsVtk ? asVtk(s) : chapter(s, chapterSums(s));
  }
  /// Hatching's share of ink in the mean.
  HWY_NOINLINE V hatchDarkness(const Surface& s) const
  {
    const V one = set(1.0f), darkest = set(style_.hatching.darkest);
    if (style_.toneLight == ToneLight::kUpperRight) {
      const V facing = hn::Mul(hn::Add(one, dot(toneLight(s), s.normal)), set(0.5f));
      return hn::Mul(darkest, hn::Sub(one, facing));
    }
    const auto none = [](Lanes3, V, Lanes3, V) HWY_ATTR { return set(Vec3f{0, 0, 0}); };
    const Lanes3 sent = sum(
                            s, [](Lanes3, V nl) HWY_ATTR { return nl; }, none)
                            .diffuse;
    const V t = bounded(strongest(add(mul(s.ambient, set(ambientLight_)), sent)), 0.0f, 1.0f);
    return hn::Mul(darkest, hn::Sub(one, t));
  }
  HWY_INLINE Lanes3 hatchColor(const Surface& s, V ink) const
  {
    const Hatching& hatching = style_.hatching;
    return add(mul(mul(s.diffuse, set(hatching.paper)), hn::Sub(set(1.0f), ink)),
               mul(set(hatching.ink), ink));
  }
  /// l of tones.
  HWY_INLINE Lanes3 toneLight(Lanes3 position) const
  {
    constexpr float kSqrtHalf = 0.707106781f;
    if (style_.toneLight == ToneLight::kUpperRight) return set(Vec3f{kSqrtHalf, kSqrtHalf, 0});
    return lights_.empty() ? set(Vec3f{0, 0, 1})
                           : arrive(lights_[0], position, style_.fallOff).toward;
  }
  /// L of Exaggeration, and how much of c is by c_i.
  int detailLevels() const { return detailLevels_; }
  float detailShare(int i) const { return detailShare_[i]; }
  /// By c of Exaggeration.
  HWY_INLINE Lanes3 exaggeratedColor(const Surface& s, V c) const
  {
    return tonesData_ ? dataTone(style_, s.diffuse, hn::Sub(hn::Add(c, c), set(1.0f)))
                      : mul(s.diffuse, c);
  }
  /// Whether bandedTone() is all that light() gives, by normals alone.
  bool isBandedTone() const
  {
    return style_.toonBands >= 2 && style_.toneLight == ToneLight::kUpperRight &&
           (style_.tone == Tone::kGooch || style_.tone == Tone::kGoochChapter) && !tonesData_ &&
           !hasToneHighlight_;
  }
  /// light() of k_d with these normals where it is, a pixel to the right and above.
  HWY_INLINE Lanes3 bandedTone(Lanes3 diffuse, Lanes3 normal, Lanes3 right, Lanes3 above) const
  {
    const Lanes3 l = toneLight(set(Vec3f{0, 0, 0}));
    const auto facingOf = [&](Lanes3 n) HWY_ATTR {
      return hn::Mul(hn::Add(set(1.0f), dot(l, n)), set(0.5f));
    };
    const V here = facingOf(normal);
    const V slope = slopeOf({here, facingOf(right), facingOf(above)});
    const V facing = stepped(here, slope, style_.toonBands);
    return coolToWarm(diffuse, facing, hn::Sub(set(1.0f), facing));
  }
  /// Whether light() is to be told about neighbours.
  bool readsNeighbours() const { return style_.toonBands >= 2; }
  /// light() with the edges of bands antialiased.
  HWY_NOINLINE Lanes3 light(const Surface& s, const Neighbours& near) const
  {
    if (style_.tone != Tone::kNone) return toned(s, &near);
    return isSpecial_ ? banded(s, &near) : light(s);
  }

 private:
  void shareDetail(const Attributes& attributes)
  {
    const float p = style_.exaggeration.exponent, ratio = attributes.smoothRatio;
    const float step = p < 0.0f ? 1.0f / power(ratio, -p) : power(ratio, p);
    float sum = 0.0f, next = 1.0f;
    detailLevels_ = attributes.smoothLevels;
    for (int i = 0; i < detailLevels_; ++i) {
      detailShare_[i] = next;
      sum = sum + next;
      next = next * step;
    }
    for (int i = 0; i < detailLevels_; ++i)
      detailShare_[i] = detailShare_[i] / sum * (1.0f - style_.exaggeration.base);
  }
  /// Whether the highlight of a lone headlight adds 0, not 0 times infinity.
  static bool isMatt(const Material& material, const ViewLight& light)
  {
    constexpr float kMostColor = 1e30f;
    return isMatt(material) && mostOf(light.color) <= kMostColor;
  }
  static bool isMatt(const Material& material)
  {
    constexpr float kMostPower = 1e6f;
    return (material.specular == 0.0f || mostOf(material.specularColor) == 0.0f) &&
           material.specularPower <= kMostPower;
  }
  static float mostOf(Vec3f v) { return std::max({v.x, v.y, v.z}); }
  /// Whether a tone's highlight adds more than 0.
  static bool hasToneHighlight(const Material& material, const Style& style)
  {
    return style.toneHighlight == ToneHighlight::kWhite ||
           (style.toneHighlight != ToneHighlight::kNone && !isMatt(material));
  }
  /// Whether more than the chapter's own models is asked for.
  static bool isSpecial(const Material& material, const Style& style)
  {
    if (style.tone != Tone::kNone) return false;
    if (style.toonBands >= 2) return style.reflection != Reflection::kNone;
    switch (style.reflection) {
      case Reflection::kNone:
      case Reflection::kAsVtk:
        return false;
      case Reflection::kLambert:
        return hasRim(material);
      case Reflection::kBlinnPhong:
      case Reflection::kPhong:
        return hasRim(material) || style.fresnel;
      default:
        return true;
    }
  }
  bool hasFresnel() const
  {
    return style_.fresnel && style_.toonBands < 2 && style_.reflection != Reflection::kLambert;
  }
  bool isMetallic() const
  {
    return style_.reflection == Reflection::kMetallicRoughness ||
           style_.reflection == Reflection::kMetallicRoughnessAsVtk;
  }
  static bool hasRim(const Material& material) { return !(material.rim == Vec3f{0, 0, 0}); }
  bool hasLoneHeadlight() const
  {
    return lights_.size() == 1 && lights_[0].kind == LightKind::kHeadlight;
  }
  HWY_INLINE Lanes3 loneHeadlight(const Surface& s) const
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
  /// By matt(l, n.l) and glossy(l, n.l), which give a factor of the light and one by channel.
  template <class Matt, class Glossy>
  HWY_INLINE Reflected sum(const Surface& s, Matt matt, Glossy glossy) const
  {
    Reflected sums = {set(Vec3f{0, 0, 0}), set(Vec3f{0, 0, 0})};
    for (const ViewLight& light : lights_) {
      const Arrival at = arrive(light, s.position, style_.fallOff);
      const V nl = dot(s.normal, at.toward);
      const M lit = isPositive(nl);
      const Lanes3 color = set(light.color);
      sums.diffuse = choose(
          lit, add(sums.diffuse, mul(color, hn::Mul(at.fall, matt(at.toward, nl)))), sums.diffuse);
      sums.specular =
          choose(lit, add(sums.specular, glossy(color, at.fall, at.toward, nl)), sums.specular);
    }
    return sums;
  }
  /// With Lambert's matt reflection.
  template <class Highlight>
  HWY_INLINE Reflected sum(const Surface& s, Highlight highlight) const
  {
    return sum(
        s, [](Lanes3, V nl) HWY_ATTR { return nl; },
        [&](Lanes3 color, V fall, Lanes3 l, V nl)
            HWY_ATTR { return mul(color, hn::Mul(fall, highlight(l, nl))); });
  }
  /// The same, the highlight times Fresnel's term.
  template <class Highlight>
  HWY_INLINE Reflected sumWithFresnel(const Surface& s, Lanes3 v, Highlight highlight) const
  {
    const Lanes3 f0 = set(reflectedHeadOn(material_.refractiveIndex));
    return sum(
        s, [](Lanes3, V nl) HWY_ATTR { return nl; },
        [&](Lanes3 color, V fall, Lanes3 l, V nl) HWY_ATTR {
          return mul(mul(color, hn::Mul(fall, highlight(l, nl))),
                     schlick(f0, set(Vec3f{1, 1, 1}), dot(l, normalized(add(l, v)))));
        });
  }

  HWY_INLINE Reflected asVtkSums(const Surface& s) const
  {
    const Lanes3 v = normalized(neg(s.position));
    return sum(s, [&](Lanes3 l, V) HWY_ATTR { return reflectedRay(l, v, s); });
  }
  Lanes3 asVtk(const Surface& s) const
  {
    const Reflected sums = asVtkSums(s);
    return add(add(s.ambient, mul(sums.diffuse, s.diffuse)), mul(sums.specular, s.specular));
  }

  /// What Oren and Nayar's model has over Lambert's; see ReferenceShading.cpp.
  HWY_NOINLINE Reflected orenNayarSums(const Surface& s) const
  {
    const float squared = material_.roughness * material_.roughness;
    const V a = set(1.0f - 0.5f * (squared / (squared + 0.33f)));
    const V b = set(0.45f * (squared / (squared + 0.09f)));
    const Lanes3 v = towardEye(s.position);
    const V nv = dot(s.normal, v);
    const auto matt = [&](Lanes3 l, V nl) HWY_ATTR {
      const V along = positive(hn::Sub(dot(l, v), hn::Mul(nl, nv)));
      const V larger = hn::IfThenElse(hn::Gt(nl, nv), nl, nv);
      return hn::Mul(nl, hn::Add(a, hn::Mul(b, hn::Div(along, larger))));
    };
    const auto none = [](Lanes3, V, Lanes3, V) HWY_ATTR { return set(Vec3f{0, 0, 0}); };
    return sum(s, matt, none);
  }
  HWY_NOINLINE Reflected irradianceSums(const Surface& s) const
  {
    const Lanes3 v = towardEye(s.position);
    const auto highlight = [&](Lanes3 l, V nl)
                               HWY_ATTR { return hn::Mul(blinnPhong(l, v, s), nl); };
    return hasFresnel() ? sumWithFresnel(s, v, highlight) : sum(s, highlight);
  }
  HWY_NOINLINE Reflected fresnelSums(const Surface& s) const
  {
    const Lanes3 v = towardEye(s.position);
    if (style_.reflection == Reflection::kPhong)
      return sumWithFresnel(s, v, [&](Lanes3 l, V) HWY_ATTR { return reflectedRay(l, v, s); });
    return sumWithFresnel(s, v, [&](Lanes3 l, V) HWY_ATTR { return blinnPhong(l, v, s); });
  }
  Reflected chapterSums(const Surface& s) const
  {
    // Not the sum's own zeros: an infinite light times 0 is not a number.
    if (style_.reflection == Reflection::kLambert)
      return {sum(s, [&](Lanes3, V) HWY_ATTR { return set(0.0f); }).diffuse, set(Vec3f{0, 0, 0})};
    const Lanes3 v = towardEye(s.position);
    if (style_.reflection == Reflection::kPhong)
      return sum(s, [&](Lanes3 l, V) HWY_ATTR { return reflectedRay(l, v, s); });
    return sum(s, [&](Lanes3 l, V) HWY_ATTR { return blinnPhong(l, v, s); });
  }
  HWY_INLINE Lanes3 chapter(const Surface& s, const Reflected& sums) const
  {
    return add(add(mul(s.ambient, set(ambientLight_)), mul(sums.diffuse, s.diffuse)),
               mul(sums.specular, s.specular));
  }

  /// Apart from light(), whose code for the models above stays short.
  HWY_NOINLINE Lanes3 special(const Surface& bare) const
  {
    if (style_.toonBands >= 2) return banded(bare, nullptr);
    if (isMetallic()) return metallic(bare);
    const Surface s = prepared(bare);
    return chapter(s, specialSums(s));
  }
  Surface withRim(Surface s) const
  {
    if (!hasRim(material_)) return s;
    const V facing = positive(dot(s.normal, towardEye(s.position)));
    const V grazing = powerOf(positive(hn::Sub(set(1.0f), facing)), material_.rimPower);
    s.ambient = add(s.ambient, mul(set(material_.rim), grazing));
    s.diffuse = add(s.diffuse, mul(set(material_.rim), grazing));
    return s;
  }
  /// With velvet's rim, and with reflectance in place of k_d where the model asks for it.
  Surface prepared(const Surface& bare) const
  {
    Surface s = withRim(bare);
    if (style_.reflection == Reflection::kIrradiance) s.diffuse = mul(s.diffuse, set(kInversePi));
    return s;
  }
  Reflected specialSums(const Surface& s) const
  {
    switch (style_.reflection) {
      case Reflection::kIrradiance:
        return irradianceSums(s);
      case Reflection::kOrenNayar:
        return orenNayarSums(s);
      default:
        return hasFresnel() ? fresnelSums(s) : chapterSums(s);
    }
  }

  Lanes3 metallic(const Surface& s) const
  {
    constexpr float kLeast = 1e-5f;
    const Material& m = material_;
    const bool asVtk = style_.reflection == Reflection::kMetallicRoughnessAsVtk;
    const bool isAtEye = asVtk && hasLoneHeadlight();
    const bool havePlaces =
        asVtk && std::any_of(lights_.begin(), lights_.end(),
                             [](const ViewLight& one) { return one.positional(); });
    const Lanes3 v = asVtk ? normalized(neg(s.position)) : towardEye(s.position);
    const V nv = atLeast(kLeast, dot(s.normal, v));
    const float alpha = m.roughness * m.roughness;
    const float alpha2 = alpha * alpha;
    const V shadow = set(asVtk ? alpha : alpha2);

    const float dielectric = 1.0f - m.metallic;
    const Lanes3 f0 =
        add(set(reflectedHeadOn(m.refractiveIndex) * dielectric), mul(s.diffuse, set(m.metallic)));
    const V grazing = positive(dot(f0, set(Vec3f{16.5f, 16.5f, 16.5f})));
    const V bounded =
        hn::Mul(hn::IfThenElse(hn::Lt(grazing, set(1.0f)), grazing, set(1.0f)), set(dielectric));
    const Lanes3 f90 = add({bounded, bounded, bounded}, set(m.edgeTint * m.metallic));

    Lanes3 result = set(Vec3f{0, 0, 0});
    for (const ViewLight& light : lights_) {
      const Arrival at = arrive(light, s.position, style_.fallOff);
      const Lanes3 l = isAtEye      ? v
                       : havePlaces ? normalized(sub(set(light.position), s.position))
                                    : at.toward;
      const V cosine = dot(s.normal, l);
      const V nl = atLeast(kLeast, cosine);
      const Lanes3 h = normalized(add(l, v));
      const V nh = atLeast(kLeast, dot(s.normal, h)), hl = atLeast(kLeast, dot(h, l));
      const V d = hn::Add(hn::Mul(hn::Sub(hn::Mul(nh, set(alpha2)), nh), nh), set(1.0f));
      const V facets =
          hn::IfThenElseZero(isPositive(d), hn::Div(set(alpha2 * kInversePi), hn::Mul(d, d)));
      const auto shadowing = [&](V a, V b) HWY_ATTR {
        return hn::Mul(a, hn::Sqrt(hn::Add(shadow, hn::Mul(b, hn::Sub(b, hn::Mul(shadow, b))))));
      };
      const V both = hn::Add(shadowing(nl, nv), shadowing(nv, nl));
      const Lanes3 f = schlick(f0, f90, hl);
      const Lanes3 glossy = mul(f, hn::Mul(facets, hn::Div(set(0.5f), both)));
      const Lanes3 matt =
          mul(mul(sub(set(Vec3f{1, 1, 1}), f), s.diffuse), set(dielectric * kInversePi));
      const Lanes3 more =
          add(result, mul(mul(set(light.color), hn::Mul(at.fall, nl)), add(matt, glossy)));
      result = asVtk ? more : choose(isPositive(cosine), more, result);
    }
    if (!asVtk) return add(mul(s.ambient, set(ambientLight_)), result);
    constexpr float kEncoding = 1.0f / 2.2f;
    return {powerOf(result.x, kEncoding), powerOf(result.y, kEncoding),
            powerOf(result.z, kEncoding)};
  }

  /// Facets as Blinn and Phong's model.
  Surface withoutFacets(Surface s) const
  {
    const Material& m = material_;
    const float alpha = m.roughness * m.roughness;
    const float alpha2 = alpha * alpha;
    const float dielectric = 1.0f - m.metallic;
    s.power = 2.0f / (alpha2 > 1e-4f ? alpha2 : 1e-4f) - 2.0f;
    s.specular =
        add(set(reflectedHeadOn(m.refractiveIndex) * dielectric), mul(s.diffuse, set(m.metallic)));
    s.diffuse = mul(s.diffuse, set(dielectric));
    return s;
  }
  Reflected bandedSums(const Surface& s) const
  {
    if (style_.reflection != Reflection::kAsVtk) return specialSums(s);
    if (!hasLoneHeadlight()) return asVtkSums(s);
    const V df = positive(s.normal.z);
    const Lanes3 color = set(lights_[0].color);
    return {mul(color, df), mul(color, powerOf(df, s.power))};
  }
  static HWY_INLINE Surface movedTo(const Place& place, Surface s)
  {
    s.position = place.position;
    s.normal = place.normal;
    return s;
  }
  /// A reflection model in bands; see ReferenceShading.cpp.
  HWY_NOINLINE Lanes3 banded(const Surface& bare, const Neighbours* near) const
  {
    const bool asVtk = style_.reflection == Reflection::kAsVtk, facets = isMetallic();
    const V unit = set(facets || style_.reflection == Reflection::kIrradiance ? kInversePi : 1.0f);
    const Surface s = facets ? withoutFacets(bare) : asVtk ? bare : withRim(bare);
    V matt[4], glossy[4];
    const auto measure = [&](int i, const Surface& at) HWY_ATTR {
      Surface point = at;
      point.power = s.power;
      const Reflected sums = bandedSums(point);
      matt[i] = hn::Mul(strongest(sums.diffuse), unit);
      glossy[i] = hn::Mul(strongest(sums.specular), unit);
      return sums;
    };
    const Reflected sums = measure(0, s);
    V mattSlope = set(0.0f), glossySlope = mattSlope;
    if (near != nullptr) {
      for (int i = 0; i < 3; ++i)
        measure(i + 1, movedTo((*near)[i], bare));
      mattSlope = slopeOf({matt[1], matt[2], matt[3]});
      glossySlope = slopeOf({glossy[1], glossy[2], glossy[3]});
    }
    const V strength = stepped(matt[0], mattSlope, style_.toonBands);
    const V shine = onOff(glossy[0], glossySlope);
    const Lanes3 ambient = asVtk ? s.ambient : mul(s.ambient, set(ambientLight_));
    return add(add(ambient, mul(withStrength(sums.diffuse, strength), s.diffuse)),
               mul(withStrength(sums.specular, shine), s.specular));
  }

  HWY_INLINE Lanes3 toneLight(const Surface& s) const { return toneLight(s.position); }
  /// r.v
  HWY_INLINE V reflected(const Surface& s, Lanes3 l) const
  {
    const V twice = hn::Mul(set(2.0f), dot(s.normal, l));
    return dot(sub(mul(s.normal, twice), l), towardEye(s.position));
  }
  HWY_INLINE V toneHighlight(const Surface& s, Lanes3 l) const
  {
    if (style_.toneHighlight == ToneHighlight::kWhite)
      return bounded(hn::Sub(hn::Mul(set(100.0f), reflected(s, l)), set(97.0f)), 0.0f, 1.0f);
    const Lanes3 v = towardEye(s.position);
    const V highlight = style_.toneHighlight == ToneHighlight::kReflected ? reflectedRay(l, v, s)
                                                                          : blinnPhong(l, v, s);
    return hn::IfThenElseZero(isPositive(dot(l, s.normal)), highlight);
  }
  /// The tone by what faces the light and what does not.
  HWY_INLINE Lanes3 coolToWarm(Lanes3 diffuse, V facing, V averted) const
  {
    const Lanes3 cool = add(set(style_.toneCool), mul(diffuse, set(style_.coolSurface)));
    const Lanes3 warm = add(set(style_.toneWarm), mul(diffuse, set(style_.warmSurface)));
    return style_.tone == Tone::kGoochChapter ? add(mul(cool, facing), mul(warm, averted))
                                              : add(mul(warm, facing), mul(cool, averted));
  }
  HWY_NOINLINE Lanes3 toned(const Surface& s, const Neighbours* near = nullptr) const
  {
    if (style_.tone == Tone::kHatching) return hatchColor(s, hatchDarkness(s));
    if (style_.tone == Tone::kRamp || style_.tone == Tone::kMatCap) return painted(s);
    const Lanes3 l = toneLight(s);
    if (style_.tone == Tone::kExaggerated)
      return exaggeratedColor(s, hn::Add(set(0.5f), hn::Mul(set(0.5f), dot(l, s.normal))));
    const V nl = dot(l, s.normal);
    V facing = hn::Mul(hn::Add(set(1.0f), nl), set(0.5f));
    V averted = hn::Mul(hn::Sub(set(1.0f), nl), set(0.5f));
    V highlight = hasToneHighlight_ ? toneHighlight(s, l) : set(0.0f);
    if (style_.toonBands >= 2) stepTone(s, near, facing, averted, highlight);
    if (tonesData_) {
      const V d = style_.toonBands >= 2 ? hn::Sub(facing, averted) : nl;
      return dataTone(style_, s.diffuse, style_.tone == Tone::kGoochChapter ? hn::Neg(d) : d);
    }
    Lanes3 tone = coolToWarm(s.diffuse, facing, averted);
    if (style_.tone == Tone::kMetal) tone = mul(tone, metalGrey(s.normal, l));
    if (!hasToneHighlight_) return tone;
    if (style_.toneHighlight == ToneHighlight::kWhite)
      return add(mul(tone, hn::Sub(set(1.0f), highlight)), {highlight, highlight, highlight});
    return add(tone, mul(s.specular, highlight));
  }
  HWY_NOINLINE void stepTone(const Surface& s, const Neighbours* near, V& facing, V& averted,
                             V& highlight) const
  {
    V slope = set(0.0f), shineSlope = slope;
    if (near != nullptr) {
      V t[3], shine[3];
      for (int i = 0; i < 3; ++i) {
        const Place& at = (*near)[i];
        const Lanes3 l = toneLight(at.position);
        t[i] = hn::Mul(hn::Add(set(1.0f), dot(l, at.normal)), set(0.5f));
        if (hasToneHighlight_) shine[i] = toneHighlight(movedTo(at, s), l);
      }
      slope = slopeOf({t[0], t[1], t[2]});
      if (hasToneHighlight_) shineSlope = slopeOf({shine[0], shine[1], shine[2]});
    }
    facing = stepped(facing, slope, style_.toonBands);
    averted = hn::Sub(set(1.0f), facing);
    if (hasToneHighlight_) highlight = onOff(highlight, shineSlope);
  }
  /// By a picture.
  HWY_NOINLINE Lanes3 painted(const Surface& s) const
  {
    const Lanes3 v = towardEye(s.position);
    if (style_.tone == Tone::kMatCap) return mul(s.diffuse, ramp_.matCap(s.normal, v));
    const Lanes3 l = toneLight(s);
    const V detail = ramp_.detail(hn::Neg(s.position.z), dot(s.normal, v), reflected(s, l));
    return mul(s.diffuse, ramp_.colorAt(positive(dot(l, s.normal)), detail));
  }

  const Camera& camera_;
  const std::vector<ViewLight>& lights_;
  Vec3f ambientLight_;
  const Material& material_;
  const Style& style_;
  Ramp ramp_;
  bool isLoneHeadlight_, isMatt_, isSpecial_, tonesData_, hasToneHighlight_;
  int detailLevels_ = 0;
  float detailShare_[kMaxSmoothLevels];
};

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
