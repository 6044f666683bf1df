// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceShading.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Reference/ReferenceDataTone.h"
#include "Rendering/Reference/ReferenceHatching.h"
#include "Rendering/Reference/ReferenceTextures.h"
#include "Rendering/Reference/ReferenceTone.h"
#include "Rendering/Texture/SampleTexture.h"
#include "Rendering/SurfaceShader.h"

#include <algorithm>
#include <cmath>

namespace limn::reference {
namespace {

/// One evaluation of a light equation: where, which way the surface faces, and what it reflects.
struct Surface {
  Vec3f position;                    ///< view space
  Vec3f normal;                      ///< unit, view space
  Vec3f ambient, diffuse, specular;  ///< k_a, k_d, k_s
  float power;
};

/// What arrives at a point from one light.
struct Arrival {
  Vec3f toward;  ///< l
  float fall;    ///< attenuation by distance and cone
};

float positive(float x)
{
  return x > 0.0f ? x : 0.0f;
}

Vec3f scaled(Vec3f color, float s)
{
  return color * s;
}

Arrival arrive(const ViewLight& light, Vec3f position, bool fallsOff)
{
  if (!light.positional()) return {light.towardLight, 1.0f};
  const Vec3f way = light.position - position;
  const float squared = dot(way, way);
  const float distance = std::sqrt(squared);
  const float inverse = distance > 0.0f ? 1.0f / distance : 0.0f;
  const Vec3f toward = way * inverse;
  const Vec3f a = light.attenuation;
  const float denominator = (a.x + a.y * distance) + a.z * squared;
  float fall = !fallsOff ? 1.0f : denominator > 0.0f ? 1.0f / denominator : 0.0f;
  if (light.kind == LightKind::kSpot) {
    const float cosine = dot(toward, light.towardLight);
    fall = cosine >= light.coneCosine ? fall * power(cosine, light.exponent) : 0.0f;
    if (light.softScale > 0.0f)
      fall = fall * smoothStep((cosine - light.coneCosine) * light.softScale);
  }
  if (light.kind == LightKind::kRectangle) fall = fall * positive(dot(toward, light.towardLight));
  return {toward, fall};
}

Vec3f towardEye(const Camera& camera, Vec3f position)
{
  return camera.parallel ? Vec3f{0, 0, 1} : normalized(-position);
}

float blinnPhong(Vec3f l, Vec3f v, const Surface& s)
{
  return power(positive(dot(s.normal, normalized(l + v))), s.power);
}

float reflectedRay(Vec3f l, Vec3f v, const Surface& s)
{
  const float twice = 2.0f * dot(s.normal, l);
  const Vec3f r = s.normal * twice - l;
  return power(positive(dot(r, v)), s.power);
}

bool isLoneHeadlight(const std::vector<ViewLight>& lights)
{
  return lights.size() == 1 && lights[0].kind == LightKind::kHeadlight;
}

bool hasPositional(const std::vector<ViewLight>& lights)
{
  return std::any_of(lights.begin(), lights.end(),
                     [](const ViewLight& light) { return light.positional(); });
}

/// What all lights send to the eye by a surface of k_d = 1 and of k_s = 1.
struct LightSums {
  Vec3f diffuse, specular;
};

/// VTK's own shaders (vtkOpenGLPolyDataMapper): one lone headlight has a path of its own.
LightSums asVtkSums(const Style& style, const std::vector<ViewLight>& lights, const Surface& s)
{
  if (isLoneHeadlight(lights)) {
    const float df = positive(s.normal.z);
    const Vec3f light = lights[0].color;
    return {scaled(light, df), scaled(light, power(df, s.power))};
  }
  const Vec3f v = normalized(-s.position);
  Vec3f diffuse = {0, 0, 0}, specular = {0, 0, 0};
  for (const ViewLight& light : lights) {
    const Arrival at = arrive(light, s.position, style.fallOff);
    const float nl = dot(s.normal, at.toward);
    if (!(nl > 0.0f)) continue;
    diffuse = diffuse + scaled(light.color, at.fall * nl);
    specular = specular + scaled(light.color, at.fall * reflectedRay(at.toward, v, s));
  }
  return {diffuse, specular};
}

Vec3f asVtk(const Style& style, const std::vector<ViewLight>& lights, const Surface& s)
{
  const LightSums sums = asVtkSums(style, lights, s);
  return (s.ambient + sums.diffuse * s.diffuse) + sums.specular * s.specular;
}

constexpr float kInversePi = 0.318309886f;

/// Schlick 1994: f0 head-on, f90 at grazing angles.
Vec3f schlick(Vec3f f0, Vec3f f90, float cosine)
{
  const float a = positive(1.0f - cosine);
  const float squared = a * a;
  return f0 + (f90 - f0) * (squared * squared * a);
}

/// What a dielectric reflects head-on.
Vec3f reflectedHeadOn(Vec3f refractiveIndex)
{
  const Vec3f mu = refractiveIndex, one = {1, 1, 1};
  const Vec3f share = {(mu.x - one.x) / (mu.x + one.x), (mu.y - one.y) / (mu.y + one.y),
                       (mu.z - one.z) / (mu.z + one.z)};
  return share * share;
}

/// What Oren and Nayar's model has over Lambert's. Of the angles to the normal alpha is the larger
/// and beta the smaller one: sin(alpha) tan(beta) = sin(theta_l) sin(theta_v) / cos(beta).
float orenNayar(const Material& material, Vec3f l, Vec3f v, const Surface& s)
{
  const float squared = material.roughness * material.roughness;
  const float a = 1.0f - 0.5f * (squared / (squared + 0.33f));
  const float b = 0.45f * (squared / (squared + 0.09f));
  const float nl = dot(s.normal, l), nv = dot(s.normal, v);
  const float along = positive(dot(l, v) - nl * nv);
  return a + b * (along / (nl > nv ? nl : nv));
}

/// Velvet.
Surface withRim(const Material& material, Vec3f v, Surface s)
{
  if (material.rim == Vec3f{0, 0, 0}) return s;
  const float grazing = power(positive(1.0f - positive(dot(s.normal, v))), material.rimPower);
  s.ambient = s.ambient + scaled(material.rim, grazing);
  s.diffuse = s.diffuse + scaled(material.rim, grazing);
  return s;
}

LightSums chapterSums(const Scene& scene, const Instance& instance,
                      const std::vector<ViewLight>& lights, const Surface& s)
{
  const Style& style = instance.style;
  const Reflection reflection = style.reflection;
  const Vec3f v = towardEye(scene.camera, s.position);
  const Vec3f f0 = reflectedHeadOn(instance.material.refractiveIndex);
  Vec3f diffuse = {0, 0, 0}, specular = {0, 0, 0};
  for (const ViewLight& light : lights) {
    const Arrival at = arrive(light, s.position, style.fallOff);
    const Vec3f l = at.toward;
    const float nl = dot(s.normal, l);
    if (!(nl > 0.0f)) continue;
    const float matt =
        reflection == Reflection::kOrenNayar ? nl * orenNayar(instance.material, l, v, s) : nl;
    diffuse = diffuse + scaled(light.color, at.fall * matt);
    if (reflection == Reflection::kLambert || reflection == Reflection::kOrenNayar) continue;
    float highlight =
        reflection == Reflection::kPhong ? reflectedRay(l, v, s) : blinnPhong(l, v, s);
    if (reflection == Reflection::kIrradiance) highlight = highlight * nl;
    const Vec3f glossy = scaled(light.color, at.fall * highlight);
    specular = specular + (style.fresnel && style.toonBands < 2
                               ? glossy * schlick(f0, {1, 1, 1}, dot(l, normalized(l + v)))
                               : glossy);
  }
  return {diffuse, specular};
}

/// (12.1), (12.3) and what is like them.
Vec3f chapter(const Scene& scene, const Instance& instance, const std::vector<ViewLight>& lights,
              const Surface& bare)
{
  const Surface s = withRim(instance.material, towardEye(scene.camera, bare.position), bare);
  const LightSums sums = chapterSums(scene, instance, lights, s);
  const bool isIrradiance = instance.style.reflection == Reflection::kIrradiance;
  const Vec3f matt = isIrradiance ? s.diffuse * kInversePi : s.diffuse;
  return (s.ambient * scene.ambientLight + sums.diffuse * matt) + sums.specular * s.specular;
}

float atLeast(float low, float x)
{
  return x > low ? (x < 1.0f ? x : 1.0f) : low;
}

/// Trowbridge and Reitz 1975, Smith 1967, Schlick 1994, as put together by Walter et al. 2007 and,
/// for VTK, by vtkOpenGLPolyDataMapper.
Vec3f metallic(const Scene& scene, const Instance& instance, const std::vector<ViewLight>& lights,
               const Surface& s)
{
  constexpr float kLeast = 1e-5f;
  const Material& m = instance.material;
  const bool asVtk = instance.style.reflection == Reflection::kMetallicRoughnessAsVtk;
  const Vec3f v = asVtk ? normalized(-s.position) : towardEye(scene.camera, s.position);
  const float nv = atLeast(kLeast, dot(s.normal, v));
  const float alpha = m.roughness * m.roughness;
  const float alpha2 = alpha * alpha;
  const float shadow = asVtk ? alpha : alpha2;

  const float dielectric = 1.0f - m.metallic;
  const Vec3f f0 = reflectedHeadOn(m.refractiveIndex) * dielectric + s.diffuse * m.metallic;
  const float grazing = positive(dot(f0, Vec3f{16.5f, 16.5f, 16.5f}));
  const float bounded = grazing < 1.0f ? grazing : 1.0f;
  const Vec3f f90 = Vec3f{bounded, bounded, bounded} * dielectric + m.edgeTint * m.metallic;

  Vec3f sum = {0, 0, 0};
  for (const ViewLight& light : lights) {
    const Arrival at = arrive(light, s.position, instance.style.fallOff);
    // VTK's lone headlight is where the eye is, and beside a positional light all its lights have
    // places.
    const Vec3f l = asVtk && isLoneHeadlight(lights) ? v
                    : asVtk && hasPositional(lights) ? normalized(light.position - s.position)
                                                     : at.toward;
    const float cosine = dot(s.normal, l);
    if (!asVtk && !(cosine > 0.0f)) continue;
    const float nl = atLeast(kLeast, cosine);
    const Vec3f h = normalized(l + v);
    const float nh = atLeast(kLeast, dot(s.normal, h)), hl = atLeast(kLeast, dot(h, l));
    const float d = (nh * alpha2 - nh) * nh + 1.0f;
    const float facets = d > 0.0f ? alpha2 * kInversePi / (d * d) : 0.0f;
    const float toLight = nl * std::sqrt(shadow + nv * (nv - shadow * nv));
    const float toEye = nv * std::sqrt(shadow + nl * (nl - shadow * nl));
    const Vec3f f = schlick(f0, f90, hl);
    const Vec3f glossy = f * (facets * (0.5f / (toLight + toEye)));
    const Vec3f matt = (Vec3f{1, 1, 1} - f) * s.diffuse * (dielectric * kInversePi);
    sum = sum + scaled(light.color, at.fall * nl) * (matt + glossy);
  }
  if (!asVtk) return s.ambient * scene.ambientLight + sum;
  constexpr float kEncoding = 1.0f / 2.2f;
  return {power(sum.x, kEncoding), power(sum.y, kEncoding), power(sum.z, kEncoding)};
}

/// Where the normal is without bumps, a pixel to the right and a pixel above; null where nothing is
/// known of that.
using Neighbours = const Surface (*)[3];

/// f at the neighbours.
template <class Function>
float slopeAmong(Neighbours near, Function f)
{
  return near == nullptr ? 0.0f : slopeOf({f((*near)[0]), f((*near)[1]), f((*near)[2])});
}

bool isMetallic(Reflection reflection)
{
  return reflection == Reflection::kMetallicRoughness ||
         reflection == Reflection::kMetallicRoughnessAsVtk;
}

/// Facets as Blinn and Phong's model.
Surface withoutFacets(const Material& material, Surface s)
{
  const float alpha = material.roughness * material.roughness;
  const float alpha2 = alpha * alpha;
  const float dielectric = 1.0f - material.metallic;
  s.power = 2.0f / (alpha2 > 1e-4f ? alpha2 : 1e-4f) - 2.0f;
  s.specular =
      reflectedHeadOn(material.refractiveIndex) * dielectric + s.diffuse * material.metallic;
  s.diffuse = s.diffuse * dielectric;
  return s;
}

float strongest(Vec3f color)
{
  const float rg = color.x > color.y ? color.x : color.y;
  return rg > color.z ? rg : color.z;
}

/// A colour with its hue, as strong as `strength`.
Vec3f withStrength(Vec3f color, float strength)
{
  const float own = strongest(color);
  return own > 0.0f ? color * (strength / own) : Vec3f{0, 0, 0};
}

/// A reflection model in bands; see Style::toonBands.
Vec3f banded(const Scene& scene, const Instance& instance, const std::vector<ViewLight>& lights,
             const Surface& bare, Neighbours near)
{
  const Style& style = instance.style;
  const bool asVtk = style.reflection == Reflection::kAsVtk, facets = isMetallic(style.reflection);
  // Of a white surface that looks white.
  const float unit = facets || style.reflection == Reflection::kIrradiance ? kInversePi : 1.0f;
  const float exponent = facets ? withoutFacets(instance.material, bare).power : bare.power;
  const auto sumsAt = [&](Surface s) {
    s.power = exponent;
    return asVtk ? asVtkSums(style, lights, s) : chapterSums(scene, instance, lights, s);
  };
  const auto light = [&](const Surface& s) { return strongest(sumsAt(s).diffuse) * unit; };
  const auto highlight = [&](const Surface& s) { return strongest(sumsAt(s).specular) * unit; };
  const float strength = stepped(light(bare), slopeAmong(near, light), style.toonBands);
  const float glossy = onOff(highlight(bare), slopeAmong(near, highlight));

  const LightSums sums = sumsAt(bare);
  const Surface s = facets ? withoutFacets(instance.material, bare)
                    : asVtk
                        ? bare
                        : withRim(instance.material, towardEye(scene.camera, bare.position), bare);
  const Vec3f ambient = asVtk ? s.ambient : s.ambient * scene.ambientLight;
  return (ambient + withStrength(sums.diffuse, strength) * s.diffuse) +
         withStrength(sums.specular, glossy) * s.specular;
}

constexpr float kSqrtHalf = 0.707106781f;
constexpr Vec3f kUpperRight = {kSqrtHalf, kSqrtHalf, 0};

/// Hatching's share of ink in the mean.
float hatchDarkness(const Scene& scene, const Instance& instance,
                    const std::vector<ViewLight>& lights, const Surface& s)
{
  const float darkest = instance.style.hatching.darkest;
  if (instance.style.toneLight == ToneLight::kUpperRight)
    return darkest * (1.0f - (1.0f + dot(kUpperRight, s.normal)) * 0.5f);
  Vec3f sum = {0, 0, 0};
  for (const ViewLight& light : lights) {
    const Arrival at = arrive(light, s.position, instance.style.fallOff);
    const float nl = dot(s.normal, at.toward);
    if (nl > 0.0f) sum = sum + scaled(light.color, at.fall * nl);
  }
  const float t = strongest(s.ambient * scene.ambientLight + sum);
  return darkest * (1.0f - (t > 0.0f ? (t < 1.0f ? t : 1.0f) : 0.0f));
}
Vec3f hatchColor(const Hatching& hatching, const Surface& s, float ink)
{
  return (s.diffuse * hatching.paper) * (1.0f - ink) + hatching.ink * ink;
}

/// The tones of one instance.
class Toning {
 public:
  Toning(const Scene& scene, const Instance& instance, const std::vector<ViewLight>& lights)
      : scene_(scene),
        instance_(instance),
        camera_(scene.camera),
        style_(instance.style),
        lights_(lights),
        tonesData_(instance.tonesData())
  {
  }

  /// By c of Tone::kExaggerated.
  Vec3f exaggeratedColor(const Surface& s, float c) const
  {
    return tonesData_ ? dataTone(style_, s.diffuse, c + c - 1.0f) : s.diffuse * c;
  }

  Vec3f color(const Surface& s, Neighbours near) const
  {
    if (style_.tone == Tone::kExaggerated)
      return exaggeratedColor(s, 0.5f + 0.5f * dot(light(s), s.normal));
    if (style_.tone == Tone::kHatching)
      return hatchColor(style_.hatching, s, hatchDarkness(scene_, instance_, lights_, s));
    if (style_.tone == Tone::kMatCap)
      return s.diffuse * matCapColor(style_.ramp, s.normal, towardEye(camera_, s.position));
    if (style_.tone == Tone::kRamp) return s.diffuse * ramp(s);
    const float nl = dot(light(s), s.normal);
    float facing = (1.0f + nl) * 0.5f, averted = (1.0f - nl) * 0.5f, glossy = highlight(s);
    if (style_.toonBands >= 2) {
      const auto t = [&](const Surface& at) { return (1.0f + dot(light(at), at.normal)) * 0.5f; };
      const auto shine = [&](const Surface& at) { return highlight(at); };
      facing = stepped(facing, slopeAmong(near, t), style_.toonBands);
      averted = 1.0f - facing;
      glossy = onOff(glossy, slopeAmong(near, shine));
    }
    if (tonesData_) {
      const float d = style_.toonBands >= 2 ? facing - averted : nl;
      return dataTone(style_, s.diffuse, style_.tone == Tone::kGoochChapter ? -d : d);
    }
    const Vec3f cool = style_.toneCool + s.diffuse * style_.coolSurface;
    const Vec3f warm = style_.toneWarm + s.diffuse * style_.warmSurface;
    Vec3f tone = style_.tone == Tone::kGoochChapter ? cool * facing + warm * averted
                                                    : warm * facing + cool * averted;
    if (style_.tone == Tone::kMetal) tone = tone * metalGrey(s.normal, light(s));
    if (style_.toneHighlight == ToneHighlight::kNone) return tone;
    if (style_.toneHighlight == ToneHighlight::kWhite)
      return tone * (1.0f - glossy) + Vec3f{glossy, glossy, glossy};
    return tone + scaled(s.specular, glossy);
  }

  /// l
  Vec3f light(const Surface& s) const
  {
    if (style_.toneLight == ToneLight::kUpperRight) return kUpperRight;
    return lights_.empty() ? Vec3f{0, 0, 1} : arrive(lights_[0], s.position, style_.fallOff).toward;
  }

 private:
  /// r.v
  float reflected(const Surface& s) const
  {
    const Vec3f l = light(s);
    const Vec3f r = s.normal * (2.0f * dot(s.normal, l)) - l;
    return dot(r, towardEye(camera_, s.position));
  }
  float highlight(const Surface& s) const
  {
    switch (style_.toneHighlight) {
      case ToneHighlight::kNone:
        return 0.0f;
      case ToneHighlight::kWhite: {
        const float x = 100.0f * reflected(s) - 97.0f;
        return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
      }
      default: {
        const Vec3f l = light(s), v = towardEye(camera_, s.position);
        if (!(dot(l, s.normal) > 0.0f)) return 0.0f;
        return style_.toneHighlight == ToneHighlight::kReflected ? reflectedRay(l, v, s)
                                                                 : blinnPhong(l, v, s);
      }
    }
  }
  Vec3f ramp(const Surface& s) const
  {
    const float nv = dot(s.normal, towardEye(camera_, s.position));
    const float detail = rampDetail(style_.ramp, camera_, {-s.position.z, nv, reflected(s)});
    const float nl = dot(light(s), s.normal);
    return rampColor(style_.ramp, nl > 0.0f ? nl : 0.0f, detail);
  }

  const Scene& scene_;
  const Instance& instance_;
  const Camera& camera_;
  const Style& style_;
  const std::vector<ViewLight>& lights_;
  bool tonesData_;
};

Vec3f lightSurface(const Scene& scene, const Instance& instance,
                   const std::vector<ViewLight>& lights, const Surface& s,
                   Neighbours near = nullptr)
{
  const Style& style = instance.style;
  if (style.tone != Tone::kNone) return Toning(scene, instance, lights).color(s, near);
  if (style.reflection == Reflection::kNone) return s.ambient + s.diffuse;
  if (style.toonBands >= 2) return banded(scene, instance, lights, s, near);
  switch (style.reflection) {
    case Reflection::kAsVtk:
      return asVtk(style, lights, s);
    case Reflection::kMetallicRoughness:
    case Reflection::kMetallicRoughnessAsVtk:
      return metallic(scene, instance, lights, s);
    default:
      return chapter(scene, instance, lights, s);
  }
}

Vec2f mix(const float (&weight)[3], Vec2f a, Vec2f b, Vec2f c)
{
  return (a * weight[0] + b * weight[1]) + c * weight[2];
}

Vec3f mix(const SurfacePoint& point, Vec3f a, Vec3f b, Vec3f c)
{
  return (a * point.weight[0] + b * point.weight[1]) + c * point.weight[2];
}

Vec3f bytes(Rgba8 c)
{
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

/// One triangle of an instance, with access to all that is attached to it.
class Face {
 public:
  Face(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
       Vec3d meshOrigin, const SurfacePoint& point)
      : scene_(scene),
        instance_(instance),
        transform_(transform),
        point_(point),
        origin_(meshOrigin),
        triangle_(instance.mesh.triangles[point.triangle]),
        cell_(instance.attributes.cells.empty() ? point.triangle
                                                : instance.attributes.cells[point.triangle])
  {
  }

  LocalPosition corner(int i) const
  {
    return toLocal(instance_.mesh.position(triangle_.vertex[i]), origin_);
  }
  Vec3f cornerPosition(int i) const { return viewPosition(transform_, corner(i)); }
  Vec3f vertexNormal(int i) const
  {
    const Attributes& data = instance_.attributes;
    return data.vertexNormals[data.normalOfCorner.empty()
                                  ? triangle_.vertex[i]
                                  : data.normalOfCorner[std::size_t{3} * point_.triangle +
                                                        static_cast<std::size_t>(i)]];
  }
  Vec3f facing(Vec3f localNormal) const
  {
    const Vec3f n = normalized(transformDirection(transform_.normalToView, localNormal));
    return point_.backFacing ? -n : n;
  }

  /// pixelNormal() with the bumps of textures.
  Vec3f bentNormal() const
  {
    Vec3f n = pixelNormal();
    for (const TextureLayer& layer : instance_.layers)
      if (layer.bendsNormals() && shows(layer)) n = bent(layer, n);
    return n;
  }
  bool shows(const TextureLayer& layer) const { return layer.onBackFaces || !point_.backFacing; }
  /// The texture's colour here.
  Vec4f sample(const TextureLayer& layer) const { return sampleLayer(layer, texturePoint(layer)); }
  /// The colour of a texture and of those that are joined with it.
  Vec4f sampleJoined(const TextureLayer& first) const
  {
    Vec4f color = sample(first);
    for (const TextureLayer* next = &first + 1;
         next != instance_.layers.end() && next->join != TextureJoin::kNone; ++next)
      color = joined(next->join, color, sample(*next));
    return color;
  }
  /// k_a and k_d under the textures of kSurface.
  void dress(Surface& s) const
  {
    for (const TextureLayer& layer : instance_.layers) {
      if (layer.role != TextureRole::kSurface || layer.join != TextureJoin::kNone || !shows(layer))
        continue;
      const Vec4f texture = sampleJoined(layer);
      s.ambient = combine(layer.mode, s.ambient, texture, instance_.material.ambient);
      s.diffuse = combine(layer.mode, s.diffuse, texture, instance_.material.diffuse);
    }
  }

  Vec3f planeAcross() const
  {
    return triangleNormal(corner(0), corner(1), corner(2), transform_.edgeScale);
  }
  Vec3f planeNormal() const { return facing(planeAcross()); }
  /// The mixed normal of the pixel, from the style's source.
  Vec3f pixelNormal() const
  {
    switch (instance_.style.normals) {
      case NormalSource::kVertex:
        return facing(mix(point_, vertexNormal(0), vertexNormal(1), vertexNormal(2)));
      case NormalSource::kCell:
        return facing(instance_.attributes.cellNormals[cell_]);
      default:
        return planeNormal();
    }
  }
  /// Normal of one corner, for Gouraud's vertex colours.
  Vec3f cornerNormal(int i) const
  {
    return instance_.style.normals == NormalSource::kVertex ? facing(vertexNormal(i))
                                                            : pixelNormal();
  }
  /// Mixed before the transform or, where a float would not hold a local position, after it.
  Vec3f pixelPosition() const
  {
    return transform_.hasLowParts
               ? mix(point_, cornerPosition(0), cornerPosition(1), cornerPosition(2))
               : viewPosition(
                     transform_,
                     {mix(point_, corner(0).high, corner(1).high, corner(2).high), {0, 0, 0}});
  }
  Vec3f modelPosition() const
  {
    const Vec3f local = mix(point_, corner(0).high, corner(1).high, corner(2).high);
    return origin_ == Vec3d{0, 0, 0} ? local : vec3Cast<float>(origin_ + vec3Cast<double>(local));
  }
  /// Of the first set.
  Vec2f uv() const
  {
    const Span<const Vec2f> uv = instance_.attributes.uv;
    return mix(point_.weight, uv[triangle_.vertex[0]], uv[triangle_.vertex[1]],
               uv[triangle_.vertex[2]]);
  }
  /// As hatching has it: without the mesh's origin, high parts alone.
  Vec3f hatchPosition() const
  {
    return mix(point_, corner(0).high, corner(1).high, corner(2).high);
  }
  /// n_1 to n_L of Exaggeration.
  std::vector<Vec3f> smoothNormals() const
  {
    const Attributes& data = instance_.attributes;
    const auto levels = static_cast<std::size_t>(data.smoothLevels);
    std::vector<Vec3f> normals;
    for (std::size_t i = 0; i < levels; ++i) {
      const auto corner = [&](int k) {
        const std::size_t number = data.smoothOfCorner.empty()
                                       ? triangle_.vertex[k]
                                       : data.smoothOfCorner[std::size_t{3} * point_.triangle +
                                                             static_cast<std::size_t>(k)];
        return unpackedNormal(data.smoothNormals[number * levels + i]);
      };
      normals.push_back(facing(mix(point_, corner(0), corner(1), corner(2))));
    }
    return normals;
  }
  /// In the mesh's own space.
  Vec3f hatchNormal() const
  {
    const Style& style = instance_.style;
    const Attributes& data = instance_.attributes;
    if (style.frequency == ShadingFrequency::kFlat) return normalized(data.faceNormals[cell_]);
    if (style.normals == NormalSource::kCell) return normalized(data.cellNormals[cell_]);
    if (style.normals == NormalSource::kVertex)
      return normalized(mix(point_, vertexNormal(0), vertexNormal(1), vertexNormal(2)));
    return normalized(planeAcross());
  }
  std::uint32_t cell() const { return cell_; }
  Vec3f facePosition() const
  {
    return viewPosition(transform_, toLocal(instance_.attributes.facePoints[cell_], origin_));
  }
  Vec3f faceNormal() const { return facing(instance_.attributes.faceNormals[cell_]); }
  /// n.v of outlines.
  float facingEye() const
  {
    const bool flat = instance_.style.frequency == ShadingFrequency::kFlat;
    return dot(flat ? faceNormal() : pixelNormal(), towardEye(scene_.camera, pixelPosition()));
  }

  /// Reflectances with the data's colour, if there is one, in place of the material's.
  Surface surface(Vec3f position, Vec3f normal, const Vec3f* dataBytes) const
  {
    const Material& m = instance_.material;
    const auto color = [&](Vec3f own) {
      return dataBytes == nullptr
                 ? own
                 : Vec3f{dataBytes->x / 255.0f, dataBytes->y / 255.0f, dataBytes->z / 255.0f};
    };
    return {position,
            normal,
            scaled(color(m.ambientColor), m.ambient),
            scaled(color(m.diffuseColor), m.diffuse),
            scaled(m.specularColor, m.specular),
            m.specularPower};
  }

  bool hasVertexColors() const { return !instance_.attributes.vertexColors.empty(); }
  bool hasCellColors() const { return !instance_.attributes.cellColors.empty(); }
  Vec3f cornerColor(int i) const
  {
    return hasVertexColors() ? bytes(instance_.attributes.vertexColors[triangle_.vertex[i]])
                             : bytes(instance_.attributes.cellColors[cell_]);
  }
  /// Of data and textures, as Style::readsAlpha says.
  float alpha() const
  {
    float alpha = 1.0f;
    if (hasVertexColors())
      alpha = ((cornerAlpha(0) * point_.weight[0] + cornerAlpha(1) * point_.weight[1]) +
               cornerAlpha(2) * point_.weight[2]) /
              255.0f;
    else if (hasCellColors())
      alpha = static_cast<float>(instance_.attributes.cellColors[cell_].a) / 255.0f;
    for (const TextureLayer& layer : instance_.layers) {
      if (layer.join != TextureJoin::kNone || !layer.setsAlpha() || !shows(layer)) continue;
      const float texture = sampleJoined(layer).w;
      alpha = layer.mode == TextureMode::kReplace ? texture : alpha * texture;
    }
    return alpha;
  }
  Vec3f pixelColor() const
  {
    return hasVertexColors() ? mix(point_, cornerColor(0), cornerColor(1), cornerColor(2))
                             : cornerColor(0);
  }

  Vec3f light(Vec3f position, Vec3f normal, Vec3f color, const std::vector<ViewLight>& lights) const
  {
    return lightSurface(scene_, instance_, lights, bareSurface(position, normal, color));
  }
  Surface bareSurface(Vec3f position, Vec3f normal, Vec3f color) const
  {
    const bool colored = hasVertexColors() || hasCellColors();
    return surface(position, normal, colored ? &color : nullptr);
  }

 private:
  float cornerAlpha(int i) const
  {
    return static_cast<float>(instance_.attributes.vertexColors[triangle_.vertex[i]].a);
  }
  Span<const Vec2f> uvOf(const TextureLayer& layer) const
  {
    return layer.uvSet == 0 ? instance_.attributes.uv : instance_.attributes.uv2;
  }
  Vec2f cornerUv(const TextureLayer& layer, int i) const
  {
    return uvOf(layer)[triangle_.vertex[i]];
  }
  TexturePoint texturePoint(const TextureLayer& layer) const
  {
    const Vec3f local = mix(point_, corner(0).high, corner(1).high, corner(2).high);
    TexturePoint result = {{0, 0}, {0, 0}, {0, 0}, local + vec3Cast<float>(origin_)};
    if (!layer.readsUv()) return result;
    const auto uvAt = [&](const float(&weight)[3]) {
      const Vec2f uv = mix(weight, cornerUv(layer, 0), cornerUv(layer, 1), cornerUv(layer, 2));
      const float* const m = layer.uvTransform;
      return Vec2f{(m[0] * uv.x + m[1] * uv.y) + m[2], (m[3] * uv.x + m[4] * uv.y) + m[5]};
    };
    result.uv = uvAt(point_.weight);
    result.ddx = uvAt(point_.rightWeight) - result.uv;
    result.ddy = uvAt(point_.aboveWeight) - result.uv;
    return result;
  }
  Vec3f bent(const TextureLayer& layer, Vec3f n) const
  {
    const Vec2f uv[3] = {cornerUv(layer, 0), cornerUv(layer, 1), cornerUv(layer, 2)};
    const TangentFrame frame =
        tangentFrame(edge(corner(0), corner(1)), edge(corner(0), corner(2)), uv);
    const auto toView = [&](Vec3f d) {
      return normalized(transformDirection(transform_.toViewFloat, d));
    };
    const Vec3f u = toView(frame.u), v = toView(frame.v);
    // From inside the normal is turned round, and so are its changes.
    const float side = point_.backFacing ? -layer.amount : layer.amount;
    const TexturePoint at = texturePoint(layer);
    if (layer.role == TextureRole::kBump) {
      const Vec2f b = heightGradient(*layer.image, layer.sampler, at.uv, at.ddx, at.ddy) * side;
      return normalized((n - u * b.x) - v * b.y);
    }
    const Vec4f t = sampleTexture(*layer.image, layer.sampler, at.uv, at.ddx, at.ddy);
    const float x = (2.0f * t.x - 1.0f) * side, y = (2.0f * t.y - 1.0f) * side;
    return normalized((n * (2.0f * t.z - 1.0f) + u * x) + v * y);
  }

  const Scene& scene_;
  const Instance& instance_;
  const InstanceTransform& transform_;
  const SurfacePoint& point_;
  Vec3d origin_;
  Triangle triangle_;
  std::uint32_t cell_;
};

/// What textures do after the light equation.
Vec3f finish(const Face& face, const Instance& instance, Vec3f diffuse, Vec3f color)
{
  const Style& style = instance.style;
  const bool isLit = style.tone == Tone::kNone && style.reflection != Reflection::kNone;
  for (const TextureLayer& layer : instance.layers) {
    if (layer.join != TextureJoin::kNone || !face.shows(layer)) continue;
    const bool isShaded =
        layer.role == TextureRole::kShaded ||
        (layer.role == TextureRole::kSurface && style.frequency == ShadingFrequency::kGouraud &&
         style.surfaceShader == nullptr);
    if (isShaded) {
      color = combine(layer.mode, color, face.sampleJoined(layer), 1.0f);
    } else if (layer.role == TextureRole::kLight && isLit) {
      const Vec4f t = face.sampleJoined(layer);
      color = color + (diffuse * layer.amount) * Vec3f{t.x, t.y, t.z};
    }
  }
  return color;
}

class PointLighting final : public SurfaceLighting {
 public:
  PointLighting(const Scene& of, const Instance& on, const std::vector<ViewLight>& by)
      : SurfaceLighting(of, on, by), lights_(by)
  {
  }

  void light(const SurfaceFragments& fragments, FragmentVectors& colors) const override
  {
    for (int i = 0; i < fragments.count; ++i)
      colors.set(i, lightSurface(scene, instance, lights_,
                                 {fragments.position[i], fragments.normal[i], fragments.ambient[i],
                                  fragments.diffuse[i], fragments.specular[i],
                                  instance.material.specularPower}));
  }
  void arrive(std::size_t number, const SurfaceFragments& fragments, FragmentVectors& towards,
              float* falls) const override
  {
    for (int i = 0; i < fragments.count; ++i) {
      const Arrival at =
          reference::arrive(lights_[number], fragments.position[i], instance.style.fallOff);
      towards.set(i, at.toward);
      falls[i] = at.fall;
    }
  }

 private:
  const std::vector<ViewLight>& lights_;
};

/// The one vector of a fragment alone.
FragmentVectors lone(Vec3f value)
{
  FragmentVectors vectors = {};
  vectors.set(0, value);
  return vectors;
}

Vec3f runSurfaceShader(const Face& face, const SurfacePoint& point, const Surface& s,
                       const PointLighting& lighting)
{
  const FragmentVectors position = lone(s.position), model = lone(face.modelPosition()),
                        normal = lone(s.normal), ambient = lone(s.ambient),
                        diffuse = lone(s.diffuse), specular = lone(s.specular);
  const std::int32_t x = point.pixelX, y = point.pixelY;
  const std::uint32_t cell = face.cell();
  const bool hasUv = !lighting.instance.attributes.uv.empty();
  const Vec2f uv = hasUv ? face.uv() : Vec2f{0, 0};
  const SurfaceFragments fragments = {1,
                                      position,
                                      model,
                                      normal,
                                      ambient,
                                      diffuse,
                                      specular,
                                      hasUv ? &uv.x : nullptr,
                                      hasUv ? &uv.y : nullptr,
                                      &x,
                                      &y,
                                      &cell};
  FragmentVectors colors;
  lighting.instance.style.surfaceShader->shade(fragments, lighting, colors);
  return colors[0];
}

/// Another point of the triangle's plane.
SurfacePoint movedTo(SurfacePoint point, const float (&weight)[3])
{
  std::copy(weight, weight + 3, point.weight);
  return point;
}

Vec3f hatched(const Scene& scene, const Instance& instance, const std::vector<ViewLight>& lights,
              const Surface& s, const Face& face, const Face& right, const Face& above)
{
  const Hatching& hatching = instance.style.hatching;
  const HatchTone tone = {hatchDarkness(scene, instance, lights, s), hatching.spacing};
  const float ink =
      hatching.place == HatchPlace::kTexture
          ? hatchByTexture({face.uv(), right.uv(), above.uv()}, tone)
          : hatchInModel({face.hatchPosition(), right.hatchPosition(), above.hatchPosition()},
                         face.hatchNormal(), tone);
  return hatchColor(hatching, s, ink);
}

Vec3f exaggeratedSurface(const Scene& scene, const Instance& instance,
                         const std::vector<ViewLight>& lights, const Surface& s,
                         const Face (&faces)[3])
{
  const Style& style = instance.style;
  const bool flat = style.frequency == ShadingFrequency::kFlat;
  const Toning toning(scene, instance, lights);
  const auto at = [&](const Face& face, Surface surface) {
    const std::vector<Vec3f> smooth = face.smoothNormals();
    return exaggerated(style.exaggeration, {toning.light(surface), surface.normal, smooth,
                                            instance.attributes.smoothRatio});
  };
  float c = at(faces[0], s);
  if (style.toonBands >= 2) {
    const auto bare = [&](const Face& face) {
      return flat ? at(face, face.bareSurface(face.facePosition(), face.faceNormal(), {}))
                  : at(face, face.bareSurface(face.pixelPosition(), face.pixelNormal(), {}));
    };
    c = stepped(c, slopeOf({bare(faces[0]), bare(faces[1]), bare(faces[2])}), style.toonBands);
  }
  return toning.exaggeratedColor(s, c);
}

/// Without the outline.
Vec3f surfaceColor(const Scene& scene, const Instance& instance,
                   const std::vector<ViewLight>& lights, const SurfacePoint& point,
                   const Face& face, const Face& right, const Face& above)
{
  const Style& style = instance.style;
  const bool colored = face.hasVertexColors() || face.hasCellColors();
  const bool flat = style.frequency == ShadingFrequency::kFlat;
  const Vec3f dataColor = colored ? face.pixelColor() : Vec3f{};
  if (style.surfaceShader != nullptr) {
    Surface surface = face.bareSurface(face.pixelPosition(),
                                       flat ? face.faceNormal() : face.bentNormal(), dataColor);
    face.dress(surface);
    const Vec3f color = runSurfaceShader(face, point, surface, {scene, instance, lights});
    return finish(face, instance, surface.diffuse, color);
  }
  const bool gouraud = style.frequency == ShadingFrequency::kGouraud;
  if (gouraud && !style.isPerPixel()) {
    Vec3f color[3];
    for (int i = 0; i < 3; ++i)
      color[i] = face.light(face.cornerPosition(i), face.cornerNormal(i),
                            colored ? face.cornerColor(i) : Vec3f{}, lights);
    const Surface surface = face.bareSurface({}, {}, dataColor);
    return finish(face, instance, surface.diffuse, mix(point, color[0], color[1], color[2]));
  }
  Surface surface = flat ? face.bareSurface(face.facePosition(), face.faceNormal(), dataColor)
                         : face.bareSurface(face.pixelPosition(), face.bentNormal(), dataColor);
  // finish() lays the textures of Gouraud's frequency over.
  if (!gouraud) face.dress(surface);
  if (style.isHatched())
    return finish(face, instance, surface.diffuse,
                  hatched(scene, instance, lights, surface, face, right, above));
  if (style.isExaggerated())
    return finish(face, instance, surface.diffuse,
                  exaggeratedSurface(scene, instance, lights, surface, {face, right, above}));
  if (flat || style.toonBands < 2)
    return finish(face, instance, surface.diffuse, lightSurface(scene, instance, lights, surface));
  const Surface near[3] = {face.bareSurface(face.pixelPosition(), face.pixelNormal(), dataColor),
                           face.bareSurface(right.pixelPosition(), right.pixelNormal(), dataColor),
                           face.bareSurface(above.pixelPosition(), above.pixelNormal(), dataColor)};
  return finish(face, instance, surface.diffuse,
                lightSurface(scene, instance, lights, surface, &near));
}

}  // namespace

float alphaAt(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
              Vec3d meshOrigin, const SurfacePoint& point)
{
  float alpha = instance.material.opacity;
  if (instance.style.readsAlpha)
    alpha = alpha * Face(scene, instance, transform, meshOrigin, point).alpha();
  return alpha > 0.0f ? (alpha < 1.0f ? alpha : 1.0f) : 0.0f;
}

Vec3f planeNormalAt(const Scene& scene, const Instance& instance,
                    const InstanceTransform& transform, Vec3d meshOrigin, const SurfacePoint& point)
{
  return Face(scene, instance, transform, meshOrigin, point).planeNormal();
}

Vec3f normalAt(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
               Vec3d meshOrigin, const SurfacePoint& point)
{
  const Face face(scene, instance, transform, meshOrigin, point);
  return instance.style.frequency == ShadingFrequency::kFlat ? face.faceNormal()
                                                             : face.pixelNormal();
}

Vec3f shade(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
            Vec3d meshOrigin, const std::vector<ViewLight>& lights, const SurfacePoint& point)
{
  const Style& style = instance.style;
  const SurfacePoint rightPoint = movedTo(point, point.rightWeight);
  const SurfacePoint abovePoint = movedTo(point, point.aboveWeight);
  const Face face(scene, instance, transform, meshOrigin, point);
  const Face right(scene, instance, transform, meshOrigin, rightPoint);
  const Face above(scene, instance, transform, meshOrigin, abovePoint);

  float line = 0.0f;
  if (style.evenOutline) {
    const Vec3f p = face.pixelPosition();
    const Vec3f across = cross(right.pixelPosition() - p, above.pixelPosition() - p);
    const float tilt = std::fabs(dot(normalized(across), towardEye(scene.camera, p)));
    line = evenLine({face.facingEye(), right.facingEye(), above.facingEye()}, tilt,
                    style.outlineWidth);
  }
  if (!style.evenOutline && std::fabs(face.facingEye()) < style.outlineThreshold) line = 1.0f;
  line = line * style.outlineOpacity;
  if (line >= 1.0f) return style.outlineColor;
  const Vec3f color = surfaceColor(scene, instance, lights, point, face, right, above);
  return line > 0.0f ? style.outlineColor * line + color * (1.0f - line) : color;
}

}  // namespace limn::reference
