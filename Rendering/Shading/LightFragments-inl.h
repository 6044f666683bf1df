// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by LightFragments.cpp.
#include "Rendering/Base/ColorBytes-inl.h"
#include "Rendering/Base/Simd.h"
#include "Rendering/Raster/EdgesOfRow-inl.h"
#include "Rendering/Shading/HatchEquations-inl.h"
#include "Rendering/Shading/LightEquations-inl.h"
#include "Rendering/Texture/Procedural-inl.h"
#include "Rendering/Texture/SampleTexture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

/// TextureMode, with k the weight of the texture's colour.
HWY_INLINE Lanes3 combine(TextureMode mode, Lanes3 color, Lanes4 texture, float k)
{
  const Lanes3 t = {texture.x, texture.y, texture.z};
  switch (mode) {
    case TextureMode::kModulate:
      return mul(color, t);
    case TextureMode::kReplace:
      return mul(t, set(k));
    case TextureMode::kDecal:
      return add(color, mul(sub(mul(t, set(k)), color), texture.w));
    default:
      return add(color, mul(t, set(k)));
  }
}

/// TextureJoin of the textures so far and the next.
HWY_INLINE Lanes4 joined(TextureJoin join, Lanes4 before, Lanes4 next)
{
  const Lanes3 c = {before.x, before.y, before.z}, t = {next.x, next.y, next.z};
  const V b = before.w, a = next.w;
  const auto make = [](Lanes3 color, V alpha) HWY_ATTR {
    return Lanes4{color.x, color.y, color.z, alpha};
  };
  const V half = set(0.5f);
  const V rest = hn::Sub(set(1.0f), a);
  switch (join) {
    case TextureJoin::kReplace:
      return make(add(mul(t, a), mul(c, rest)), hn::Add(a, hn::Mul(b, rest)));
    case TextureJoin::kModulate:
      return make(mul(c, t), hn::Mul(b, a));
    case TextureJoin::kAdd:
      return make(add(mul(t, a), mul(c, b)), hn::Add(b, a));
    case TextureJoin::kAddSigned:
      return make(sub(add(mul(t, a), mul(c, b)), Lanes3{half, half, half}),
                  hn::Sub(hn::Add(b, a), half));
    default:
      return make(sub(c, mul(t, a)), b);
  }
}

/// Where the weights of the corners are, by fragment: those at it, and a pixel to the right and
/// above. The latter are there if UvUse::footprint.
struct CornerWeights {
  const float *here[3], *right[3], *above[3];
};

/// What the fragments of a batch carry, a fragment a lane.
class BatchLanes {
 public:
  explicit BatchLanes(std::size_t first) : first_(first) {}
  HWY_INLINE V value(const float* v) const { return hn::Load(D(), v + first_); }

 private:
  std::size_t first_;
};

/// What one triangle of a batch carries, in all lanes.
class TriangleLanes {
 public:
  explicit TriangleLanes(std::size_t triangle) : triangle_(triangle) {}
  HWY_INLINE V value(const float* v) const { return set(v[triangle_]); }

 private:
  std::size_t triangle_;
};

/// A vector of fragments. `Lanes` says what of the batch is theirs.
template <class Lanes>
class FragmentLanes {
 public:
  FragmentLanes(const ShadingContext& context, const FragmentBatch& batch, Lanes lanes)
      : instance_(*context.placed->instance),
        transform_(context.placed->transform),
        batch_(batch),
        lanes_(lanes),
        side_(lanes.value(batch.side)),
        planeNormal_(set(Vec3f{0, 0, 0}))
  {
    const Style& style = instance_.style;
    if (style.frequency != ShadingFrequency::kFlat && style.normals != NormalSource::kVertex)
      planeNormal_ = facing(style.normals == NormalSource::kCell ? normal(0) : acrossEdges());
  }

  void setWeights(const CornerWeights& weights) { weights_ = weights; }
  /// The same where these are the weights.
  FragmentLanes movedTo(const float* const (&weight)[3]) const
  {
    FragmentLanes moved = *this;
    for (int k = 0; k < 3; ++k)
      moved.weights_.here[k] = weight[k];
    return moved;
  }
  const CornerWeights& weights() const { return weights_; }

  HWY_INLINE Lanes3 mix(Lanes3 a, Lanes3 b, Lanes3 c) const
  {
    return add(add(mul(a, weight(0)), mul(b, weight(1))), mul(c, weight(2)));
  }
  Lanes3 cornerPosition(int k) const
  {
    return transform_.hasLowParts ? value(batch_.viewCorner[k]) : viewPosition(corner(k));
  }
  Lanes3 pixelPosition() const
  {
    return transform_.hasLowParts ? mix(cornerPosition(0), cornerPosition(1), cornerPosition(2))
                                  : viewPosition(localPosition());
  }
  /// High parts alone.
  Lanes3 localPosition() const { return mix(corner(0), corner(1), corner(2)); }
  HWY_INLINE Lanes3 pixelNormal() const
  {
    return instance_.style.normals == NormalSource::kVertex
               ? facing(mix(normal(0), normal(1), normal(2)))
               : planeNormal_;
  }
  Lanes3 cornerNormal(int k) const
  {
    return instance_.style.normals == NormalSource::kVertex ? facing(normal(k)) : planeNormal_;
  }
  /// pixelNormal() with the bumps of textures.
  Lanes3 bentNormal() const
  {
    Lanes3 n = pixelNormal();
    for (const TextureLayer& layer : instance_.layers)
      if (layer.bendsNormals()) n = whereShown(layer, bent(layer, n), n);
    return n;
  }
  /// Of the first set, as the mesh has them.
  Lanes2 pixelUv() const
  {
    const auto corner = [&](int k) HWY_ATTR {
      const FragmentBatch::Pairs& uv = batch_.cornerUv[0][k];
      return mul(Lanes2{lanes_.value(uv.x), lanes_.value(uv.y)}, weight(k));
    };
    return add(add(corner(0), corner(1)), corner(2));
  }
  /// In the mesh's own space.
  Lanes3 hatchNormal() const
  {
    const Style& style = instance_.style;
    if (style.frequency == ShadingFrequency::kFlat) return normalized(value(batch_.faceNormal));
    if (style.normals == NormalSource::kCell) return normalized(normal(0));
    return normalized(style.normals == NormalSource::kVertex ? mix(normal(0), normal(1), normal(2))
                                                             : acrossEdges());
  }
  /// n of a level of Attributes::smoothNormals, from 0.
  HWY_INLINE Lanes3 smoothNormal(int level) const
  {
    const FragmentBatch::Vectors* const corner = batch_.smoothNormal[level];
    return facing(mix(value(corner[0]), value(corner[1]), value(corner[2])));
  }
  Lanes3 facePosition() const { return value(batch_.facePosition); }
  /// Of the triangle's plane, whatever the style.
  HWY_INLINE Lanes3 triangleNormal() const { return facing(acrossEdges()); }
  Lanes3 faceNormal() const { return facing(value(batch_.faceNormal)); }

  Lanes3 pixelColor() const
  {
    return vertexColored() ? mix(color(0), color(1), color(2)) : color(0);
  }
  Lanes3 cornerColor(int k) const { return color(vertexColored() ? k : 0); }
  bool colored() const { return vertexColored() || !instance_.attributes.cellColors.empty(); }
  bool vertexColored() const { return !instance_.attributes.vertexColors.empty(); }

  /// Style::readsAlpha says how; not yet times the opacity.
  V alpha() const
  {
    V alpha = set(1.0f);
    if (colored()) {
      const auto corner = [&](int k) HWY_ATTR { return lanes_.value(batch_.cornerAlpha[k]); };
      const auto part = [&](int k) HWY_ATTR { return hn::Mul(corner(k), weight(k)); };
      alpha = hn::Div(vertexColored() ? hn::Add(hn::Add(part(0), part(1)), part(2)) : corner(0),
                      set(255.0f));
    }
    for (const TextureLayer& layer : instance_.layers) {
      if (layer.join != TextureJoin::kNone || !layer.setsAlpha()) continue;
      const V texture = sampleJoined(layer).w;
      const V next = layer.mode == TextureMode::kReplace ? texture : hn::Mul(alpha, texture);
      alpha = layer.onBackFaces ? next : hn::IfThenElse(isPositive(side_), next, alpha);
    }
    return alpha;
  }

  /// The texture's colour.
  Lanes4 sample(const TextureLayer& layer) const
  {
    if (layer.image != nullptr) {
      const TexturePoint at = texturePoint(layer);
      return sampleTexture(*layer.image, layer.sampler, at.uv, at.ddx, at.ddy);
    }
    if (!layer.readsUv()) return proceduralColor(*layer.procedural, modelPosition());
    const Lanes2 uv = texturePoint(layer).uv;
    return proceduralColor(*layer.procedural, {uv.x, uv.y, set(0.0f)});
  }
  /// The colour of a texture and of those that are joined with it.
  Lanes4 sampleJoined(const TextureLayer& first) const
  {
    Lanes4 color = sample(first);
    for (const TextureLayer* next = &first + 1;
         next != instance_.layers.end() && next->join != TextureJoin::kNone; ++next)
      color = joined(next->join, color, sample(*next));
    return color;
  }
  /// `yes` but for fragments seen from inside, if the texture is not for these.
  HWY_INLINE Lanes3 whereShown(const TextureLayer& layer, Lanes3 yes, Lanes3 no) const
  {
    return layer.onBackFaces ? yes : choose(isPositive(side_), yes, no);
  }
  /// k_a and k_d under the textures of kSurface.
  void dress(Surface& s) const
  {
    for (const TextureLayer& layer : instance_.layers) {
      if (layer.role != TextureRole::kSurface || layer.join != TextureJoin::kNone) continue;
      const Lanes4 texture = sampleJoined(layer);
      const Material& m = instance_.material;
      s.ambient = whereShown(layer, combine(layer.mode, s.ambient, texture, m.ambient), s.ambient);
      s.diffuse = whereShown(layer, combine(layer.mode, s.diffuse, texture, m.diffuse), s.diffuse);
    }
  }

  /// k_d without textures.
  HWY_INLINE Lanes3 diffuse() const
  {
    const Material& m = instance_.material;
    const Lanes3 data = colored() ? pixelColor() : set(Vec3f{0, 0, 0});
    return mul(reflectance(m.diffuseColor, colored() ? &data : nullptr), set(m.diffuse));
  }
  Surface surface(Lanes3 position, Lanes3 normal, const Lanes3* data) const
  {
    const Material& m = instance_.material;
    return {position,
            normal,
            mul(reflectance(m.ambientColor, data), set(m.ambient)),
            mul(reflectance(m.diffuseColor, data), set(m.diffuse)),
            mul(set(m.specularColor), set(m.specular)),
            m.specularPower};
  }

 private:
  /// The data's colour, if any, in place of the material's own.
  static HWY_INLINE Lanes3 reflectance(Vec3f own, const Lanes3* data)
  {
    const V full = set(255.0f);
    return data == nullptr
               ? set(own)
               : Lanes3{hn::Div(data->x, full), hn::Div(data->y, full), hn::Div(data->z, full)};
  }
  HWY_INLINE Lanes3 value(const FragmentBatch::Vectors& v) const
  {
    return {lanes_.value(v.x), lanes_.value(v.y), lanes_.value(v.z)};
  }
  HWY_INLINE V weight(int k) const { return hn::Load(D(), weights_.here[k]); }
  HWY_INLINE Lanes3 corner(int k) const { return value(batch_.corner[k]); }
  HWY_INLINE Lanes3 normal(int k) const { return value(batch_.cornerNormal[k]); }
  HWY_INLINE Lanes3 color(int k) const { return value(batch_.cornerColor[k]); }
  /// From corner 0 to corner k.
  HWY_INLINE Lanes3 edge(int k) const
  {
    return transform_.hasLowParts ? value(batch_.edge[k - 1]) : sub(corner(k), corner(0));
  }
  Lanes3 acrossEdges() const
  {
    const V scale = set(transform_.edgeScale);
    return cross(mul(edge(1), scale), mul(edge(2), scale));
  }

  HWY_INLINE Lanes2 cornerUv(const TextureLayer& layer, int k) const
  {
    const FragmentBatch::Pairs& uv = batch_.cornerUv[layer.uvSet][k];
    return {lanes_.value(uv.x), lanes_.value(uv.y)};
  }
  struct TexturePoint {
    Lanes2 uv, ddx, ddy;
  };
  TexturePoint texturePoint(const TextureLayer& layer) const
  {
    const Lanes2 corner[3] = {cornerUv(layer, 0), cornerUv(layer, 1), cornerUv(layer, 2)};
    const auto uvAt = [&](const float* const(&weight)[3]) HWY_ATTR {
      const Lanes2 a = mul(corner[0], hn::Load(D(), weight[0]));
      const Lanes2 b = mul(corner[1], hn::Load(D(), weight[1]));
      const Lanes2 uv = add(add(a, b), mul(corner[2], hn::Load(D(), weight[2])));
      const auto row = [&](const float* m) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(set(m[0]), uv.x), hn::Mul(set(m[1]), uv.y)), set(m[2]));
      };
      return Lanes2{row(layer.uvTransform), row(layer.uvTransform + 3)};
    };
    const Lanes2 uv = uvAt(weights_.here), still = set(Vec2f{0, 0});
    if (!layer.readsFootprint()) return {uv, still, still};
    return {uv, sub(uvAt(weights_.right), uv), sub(uvAt(weights_.above), uv)};
  }
  Lanes3 modelPosition() const
  {
    return add(mix(corner(0), corner(1), corner(2)),
               set(vec3Cast<float>(instance_.clusters->origin)));
  }
  /// The normal under a texture of kNormal or kBump; see ReferenceShading.cpp.
  Lanes3 bent(const TextureLayer& layer, Lanes3 n) const
  {
    const Lanes2 uv0 = cornerUv(layer, 0);
    const Lanes2 d1 = sub(cornerUv(layer, 1), uv0), d2 = sub(cornerUv(layer, 2), uv0);
    const V area = hn::Sub(hn::Mul(d1.x, d2.y), hn::Mul(d2.x, d1.y));
    const V turn = hn::IfThenElse(isPositive(area), set(1.0f),
                                  hn::IfThenElseZero(hn::Lt(area, set(0.0f)), set(-1.0f)));
    const Lanes3 e1 = edge(1), e2 = edge(2);
    const Lanes3 u = toView(mul(sub(mul(e1, d2.y), mul(e2, d1.y)), turn));
    const Lanes3 v = toView(mul(sub(mul(e2, d1.x), mul(e1, d2.x)), turn));
    const V amount = hn::Mul(side_, set(layer.amount));
    const TexturePoint at = texturePoint(layer);
    if (layer.role == TextureRole::kBump) {
      const Lanes2 b =
          mul(heightGradient(*layer.image, layer.sampler, at.uv, at.ddx, at.ddy), amount);
      return normalized(sub(sub(n, mul(u, b.x)), mul(v, b.y)));
    }
    const Lanes4 t = sampleTexture(*layer.image, layer.sampler, at.uv, at.ddx, at.ddy);
    const auto component = [](V value)
                               HWY_ATTR { return hn::Sub(hn::Mul(set(2.0f), value), set(1.0f)); };
    const V x = hn::Mul(component(t.x), amount), y = hn::Mul(component(t.y), amount);
    return normalized(add(add(mul(n, component(t.z)), mul(u, x)), mul(v, y)));
  }
  HWY_INLINE Lanes3 toView(Lanes3 direction) const
  {
    const auto row = [&](int r) HWY_ATTR {
      const float* m = transform_.toViewFloat.m[r];
      return hn::Add(hn::Add(hn::Mul(set(m[0]), direction.x), hn::Mul(set(m[1]), direction.y)),
                     hn::Mul(set(m[2]), direction.z));
    };
    return normalized({row(0), row(1), row(2)});
  }

  HWY_INLINE Lanes3 viewPosition(Lanes3 p) const
  {
    const auto row = [&](int r) HWY_ATTR {
      const float* m = transform_.toViewFloat.m[r];
      return hn::Add(hn::Add(hn::Mul(set(m[0]), p.x), hn::Mul(set(m[1]), p.y)),
                     hn::Add(hn::Mul(set(m[2]), p.z), set(m[3])));
    };
    return {row(0), row(1), row(2)};
  }
  HWY_INLINE Lanes3 facing(Lanes3 normal) const
  {
    const auto row = [&](int r) HWY_ATTR {
      const float* m = transform_.normalToView.m[r];
      return hn::Add(hn::Add(hn::Mul(set(m[0]), normal.x), hn::Mul(set(m[1]), normal.y)),
                     hn::Mul(set(m[2]), normal.z));
    };
    return mul(normalized({row(0), row(1), row(2)}), side_);
  }

  const Instance& instance_;
  const InstanceTransform& transform_;
  const FragmentBatch& batch_;
  Lanes lanes_;
  V side_;
  Lanes3 planeNormal_;  ///< not for vertex normals nor flat frequency
  CornerWeights weights_ = {};
};

/// The light equation over fragments of one instance.
template <class Lanes>
class Shader {
 public:
  /// `lighting` of the same context must outlive it.
  Shader(const Lighting& lighting, const ShadingContext& context, const FragmentBatch& batch,
         Lanes lanes)
      : lighting_(lighting),
        style_(context.placed->instance->style),
        layers_(context.placed->instance->layers),
        isPlain_(layers_.empty() && !lighting.readsNeighbours() && !style_.isPerPixel()),
        isOutlined_(style_.outlineThreshold > 0.0f || style_.evenOutline),
        isBandedTone_(layers_.empty() && style_.frequency == ShadingFrequency::kPhong &&
                      lighting.isBandedTone()),
        lanes_(context, batch, lanes)
  {
  }

  /// Once per object, as all of its fragments have the same corners.
  void lightCorners()
  {
    for (int k = 0; k < 3; ++k)
      lit_[k] = light(lanes_.cornerPosition(k), lanes_.cornerNormal(k),
                      lanes_.colored() ? lanes_.cornerColor(k) : none());
  }
  bool needsCorners() const
  {
    return style_.frequency == ShadingFrequency::kGouraud && !style_.isPerPixel();
  }
  /// Whether all fragments with the same corners have the same colour.
  bool isConstant() const
  {
    return style_.frequency == ShadingFrequency::kFlat && !lanes_.vertexColored() && !isOutlined_ &&
           layers_.empty() && !style_.isPerPixel();
  }

  /// Material::opacity times what Style::readsAlpha asks for; 0 to 1.
  HWY_INLINE V alphaAt(const CornerWeights& weights, float opacity)
  {
    V alpha = set(opacity);
    if (style_.readsAlpha) {
      lanes_.setWeights(weights);
      alpha = hn::Mul(alpha, lanes_.alpha());
    }
    const V one = set(1.0f), bounded = hn::IfThenElse(hn::Lt(alpha, one), alpha, one);
    return hn::IfThenElseZero(isPositive(alpha), bounded);
  }

  /// Requires: lightCorners() if needsCorners().
  HWY_INLINE Lanes3 colorAt(const CornerWeights& weights)
  {
    lanes_.setWeights(weights);
    return outlined(isPlain_ ? shade() : shadeSpecial());
  }

  /// For surface shaders: what is lit at each fragment, whatever the frequency.
  Surface surfaceAt(const CornerWeights& weights)
  {
    lanes_.setWeights(weights);
    const Lanes3 data = lanes_.colored() ? lanes_.pixelColor() : none();
    Surface surface = lanes_.surface(
        lanes_.pixelPosition(),
        style_.frequency == ShadingFrequency::kFlat ? lanes_.faceNormal() : lanes_.bentNormal(),
        lanes_.colored() ? &data : nullptr);
    lanes_.dress(surface);
    return surface;
  }
  /// And what becomes of the shader's colour there.
  Lanes3 finishAt(const CornerWeights& weights, Lanes3 diffuse, Lanes3 color)
  {
    lanes_.setWeights(weights);
    return outlined(finish(diffuse, color));
  }
  const FragmentLanes<Lanes>& lanes() const { return lanes_; }

 private:
  static HWY_INLINE Lanes3 none() { return set(Vec3f{0, 0, 0}); }
  HWY_INLINE Lanes3 light(Lanes3 position, Lanes3 normal, Lanes3 color) const
  {
    return lighting_.light(lanes_.surface(position, normal, lanes_.colored() ? &color : nullptr));
  }
  HWY_INLINE Lanes3 shade() const
  {
    if (style_.frequency == ShadingFrequency::kGouraud)
      return lanes_.mix(lit_[0], lit_[1], lit_[2]);
    const Lanes3 color = lanes_.colored() ? lanes_.pixelColor() : none();
    if (style_.frequency == ShadingFrequency::kFlat)
      return light(lanes_.facePosition(), lanes_.faceNormal(), color);
    return light(lighting_.readsPosition() ? lanes_.pixelPosition() : none(), lanes_.pixelNormal(),
                 color);
  }
  /// With textures, or with bands of tone.
  Lanes3 shadeSpecial() const
  {
    if (isBandedTone_) return bandedTone();
    const Lanes3 data = lanes_.colored() ? lanes_.pixelColor() : none();
    const Lanes3* const own = lanes_.colored() ? &data : nullptr;
    const bool gouraud = style_.frequency == ShadingFrequency::kGouraud;
    if (gouraud && !style_.isPerPixel())
      return finish(lanes_.surface(none(), none(), own).diffuse, shade());
    Surface surface =
        style_.frequency == ShadingFrequency::kFlat
            ? lanes_.surface(lanes_.facePosition(), lanes_.faceNormal(), own)
            : lanes_.surface(lighting_.readsPosition() ? lanes_.pixelPosition() : none(),
                             lanes_.bentNormal(), own);
    if (!gouraud) lanes_.dress(surface);
    if (style_.isHatched()) return finish(surface.diffuse, hatched(surface));
    if (style_.isExaggerated()) return finish(surface.diffuse, exaggerated(surface));
    return finish(surface.diffuse,
                  lighting_.readsNeighbours() && style_.frequency == ShadingFrequency::kPhong
                      ? lightInBands(surface)
                      : lighting_.light(surface));
  }
  /// Apart from lightInBands(), as it needs so much less.
  HWY_NOINLINE Lanes3 bandedTone() const
  {
    const CornerWeights& weights = lanes_.weights();
    return lighting_.bandedTone(lanes_.diffuse(), lanes_.pixelNormal(),
                                lanes_.movedTo(weights.right).pixelNormal(),
                                lanes_.movedTo(weights.above).pixelNormal());
  }
  HWY_NOINLINE Lanes3 lightInBands(const Surface& surface) const
  {
    const CornerWeights& weights = lanes_.weights();
    const FragmentLanes<Lanes> right = lanes_.movedTo(weights.right);
    const FragmentLanes<Lanes> above = lanes_.movedTo(weights.above);
    const auto at = [&](const FragmentLanes<Lanes>& lanes) HWY_ATTR {
      return Lighting::Place{lighting_.readsPosition() ? lanes.pixelPosition() : none(),
                             lanes.pixelNormal()};
    };
    // With textures the surface's own normal may have bumps.
    const Lighting::Place near[3] = {
        layers_.empty() ? Lighting::Place{surface.position, surface.normal} : at(lanes_), at(right),
        at(above)};
    return lighting_.light(surface, near);
  }
  HWY_NOINLINE Lanes3 hatched(const Surface& surface) const
  {
    const Hatching& hatching = style_.hatching;
    const FragmentLanes<Lanes> right = lanes_.movedTo(lanes_.weights().right);
    const FragmentLanes<Lanes> above = lanes_.movedTo(lanes_.weights().above);
    const HatchPen pen(lighting_.hatchDarkness(surface), hatching.spacing);
    if (hatching.place == HatchPlace::kTexture)
      return lighting_.hatchColor(
          surface, hatchByTexture(pen, {lanes_.pixelUv(), right.pixelUv(), above.pixelUv()}));
    const HatchPositions positions = {lanes_.localPosition(), right.localPosition(),
                                      above.localPosition()};
    return lighting_.hatchColor(surface, hatchInModel(pen, positions, lanes_.hatchNormal()));
  }
  HWY_NOINLINE Lanes3 exaggerated(const Surface& surface) const
  {
    V c = exaggeratedTone(lanes_, surface.position, surface.normal);
    if (style_.toonBands >= 2) {
      const auto bare = [&](const FragmentLanes<Lanes>& lanes) HWY_ATTR {
        return style_.frequency == ShadingFrequency::kFlat
                   ? exaggeratedTone(lanes, lanes.facePosition(), lanes.faceNormal())
                   : exaggeratedTone(lanes, lanes.pixelPosition(), lanes.pixelNormal());
      };
      const V slope = slopeOf({bare(lanes_), bare(lanes_.movedTo(lanes_.weights().right)),
                               bare(lanes_.movedTo(lanes_.weights().above))});
      c = stepped(c, slope, style_.toonBands);
    }
    return lighting_.exaggeratedColor(surface, c);
  }
  /// c of Exaggeration.
  V exaggeratedTone(const FragmentLanes<Lanes>& lanes, Lanes3 position, Lanes3 normal) const
  {
    const Exaggeration& exaggeration = style_.exaggeration;
    const V half = set(0.5f), contrast = set(exaggeration.contrast);
    const Lanes3 l = lighting_.toneLight(position);
    Lanes3 finer = normal;
    V c = set(0.0f), nl = c;
    for (int level = 0; level < lighting_.detailLevels(); ++level) {
      const Lanes3 n = lanes.smoothNormal(level);
      nl = dot(n, l);
      const Lanes3 across = sub(l, mul(n, nl));
      const V length = hn::Sqrt(dot(across, across)), least = set(kLeastGrazing);
      const V divisor = hn::IfThenElse(hn::Gt(length, least), length, least);
      const Lanes3 grazing = mul(across, hn::Div(set(1.0f), divisor));
      const V detail = bounded(hn::Mul(contrast, dot(finer, grazing)), -1.0f, 1.0f);
      c = hn::Add(c,
                  hn::Mul(set(lighting_.detailShare(level)), hn::Add(half, hn::Mul(half, detail))));
      finer = n;
    }
    return hn::Add(c, hn::Mul(set(exaggeration.base), hn::Add(half, hn::Mul(half, nl))));
  }
  /// What textures do after the light equation.
  Lanes3 finish(Lanes3 diffuse, Lanes3 color) const
  {
    const bool isLit = style_.tone == Tone::kNone && style_.reflection != Reflection::kNone;
    for (const TextureLayer& layer : layers_) {
      if (layer.join != TextureJoin::kNone) continue;
      const bool isShaded =
          layer.role == TextureRole::kShaded ||
          (layer.role == TextureRole::kSurface && style_.frequency == ShadingFrequency::kGouraud &&
           style_.surfaceShader == nullptr);
      if (isShaded) {
        const Lanes4 t = lanes_.sampleJoined(layer);
        color = lanes_.whereShown(layer, combine(layer.mode, color, t, 1.0f), color);
      } else if (layer.role == TextureRole::kLight && isLit) {
        const Lanes4 t = lanes_.sampleJoined(layer);
        const Lanes3 more = mul(mul(diffuse, set(layer.amount)), Lanes3{t.x, t.y, t.z});
        color = lanes_.whereShown(layer, add(color, more), color);
      }
    }
    return color;
  }
  HWY_INLINE Lanes3 outlined(Lanes3 color) const
  {
    if (!isOutlined_) return color;
    if (style_.evenOutline || style_.outlineOpacity < 1.0f) return blendedOutline(color);
    return choose(onOutline(), set(style_.outlineColor), color);
  }
  HWY_NOINLINE Lanes3 blendedOutline(Lanes3 color) const
  {
    V line = hn::IfThenElseZero(onOutline(), set(1.0f));
    if (style_.evenOutline) {
      const FragmentLanes<Lanes> right = lanes_.movedTo(lanes_.weights().right);
      const FragmentLanes<Lanes> above = lanes_.movedTo(lanes_.weights().above);
      const Lanes3 p = lanes_.pixelPosition();
      const Lanes3 across = cross(sub(right.pixelPosition(), p), sub(above.pixelPosition(), p));
      const V tilt = hn::Abs(dot(normalized(across), lighting_.towardEye(p)));
      line = evenLine({facingEye(lanes_), facingEye(right), facingEye(above)}, tilt,
                      style_.outlineWidth);
    }
    line = hn::Mul(line, set(style_.outlineOpacity));
    const V one = set(1.0f);
    const Lanes3 outline = set(style_.outlineColor);
    const Lanes3 mixed = add(mul(outline, line), mul(color, hn::Sub(one, line)));
    return choose(hn::Ge(line, one), outline, choose(isPositive(line), mixed, color));
  }
  /// n.v
  V facingEye(const FragmentLanes<Lanes>& lanes) const
  {
    const Lanes3 n =
        style_.frequency == ShadingFrequency::kFlat ? lanes.faceNormal() : lanes.pixelNormal();
    return dot(n, lighting_.towardEye(lanes.pixelPosition()));
  }
  /// Pixels with |n.v| below the threshold, figure 12.15.
  M onOutline() const { return hn::Lt(hn::Abs(facingEye(lanes_)), set(style_.outlineThreshold)); }

  const Lighting& lighting_;
  const Style& style_;
  Span<const TextureLayer> layers_;
  bool isPlain_, isOutlined_, isBandedTone_;
  FragmentLanes<Lanes> lanes_;
  // Not left to a default constructor, which GCC compiles without the target's instructions.
  Lanes3 lit_[3] = {none(), none(), none()};
};

/// Of the fragments from `first` on.
CornerWeights weightsOf(const FragmentBatch& batch, std::size_t first)
{
  CornerWeights weights;
  for (int k = 0; k < 3; ++k) {
    weights.here[k] = batch.weight[k] + first;
    weights.right[k] = batch.rightWeight[k] + first;
    weights.above[k] = batch.aboveWeight[k] + first;
  }
  return weights;
}

void lightFragmentsKernel(const ShadingContext& context, FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  const Lighting lighting(context);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    Shader<BatchLanes> shader(lighting, context, batch, BatchLanes(i));
    if (shader.needsCorners()) shader.lightCorners();
    store(shader.colorAt(weightsOf(batch, i)), batch.color, i);
  }
}

void fadeFragmentsKernel(const ShadingContext& context, FragmentBatch& batch)
{
  const float opacity = context.placed->instance->material.opacity;
  const auto count = static_cast<std::size_t>(batch.count);
  const Lighting lighting(context);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    Shader<BatchLanes> shader(lighting, context, batch, BatchLanes(i));
    hn::Store(shader.alphaAt(weightsOf(batch, i), opacity), D(), batch.alpha + i);
  }
}

/// Words that are an Rgba8 each; the lowest byte comes first.
HWY_INLINE Words quantized(Lanes3 color)
{
  return hn::Or(bytesOf(color), hn::Set(hn::RebindToUnsigned<D>(), 0xFF000000u));
}

/// As RadianceView holds it.
HWY_INLINE Lanes3 radianceOf(Lanes3 color)
{
  const auto bounded = [](V value) HWY_ATTR {
    const V most = set(kMaxRadiance);
    return hn::IfThenElseZero(isPositive(value), hn::IfThenElse(hn::Lt(value, most), value, most));
  };
  return {bounded(color.x), bounded(color.y), bounded(color.z)};
}

void boundRadianceKernel(FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D()))
    store(radianceOf(load(batch.color, i)), batch.color, i);
}

void quantizeFragmentsKernel(const FragmentBatch& batch, Rgba8* colors)
{
  const hn::RebindToUnsigned<D> du;
  const auto count = static_cast<std::size_t>(batch.count);
  alignas(64) std::uint32_t words[FragmentBatch::kCapacity];
  for (std::size_t i = 0; i < count; i += hn::Lanes(du))
    hn::Store(quantized(load(batch.color, i)), du, words + i);
  std::memcpy(colors, words, count * sizeof *colors);
}

/// Fragments of one triangle, shaded together.
struct TriangleFragments {
  static constexpr std::size_t kCapacity = 256;
  static constexpr std::size_t kRoom = kCapacity + HWY_MAX_BYTES / sizeof(float);

  alignas(64) std::int32_t pixel[kRoom];
  alignas(64) float weight[3][kRoom];
  alignas(64) float rightWeight[3][kRoom];
  alignas(64) float aboveWeight[3][kRoom];
  alignas(64) std::uint32_t color[kRoom];
  alignas(64) float radiance[3][kRoom];  ///< only where asked for
  std::size_t count;                     ///< last, so that the arrays leave no gaps

  CornerWeights weightsAt(std::size_t i) const
  {
    return {{weight[0] + i, weight[1] + i, weight[2] + i},
            {rightWeight[0] + i, rightWeight[1] + i, rightWeight[2] + i},
            {aboveWeight[0] + i, aboveWeight[1] + i, aboveWeight[2] + i}};
  }
  /// Takes runs until full; returns the first that has no room, or FragmentRun::kNone.
  std::uint16_t take(const FragmentList& fragments, std::uint16_t run)
  {
    count = 0;
    for (; run != FragmentRun::kNone; run = fragments.run[run].next) {
      const std::size_t length = fragments.run[run].length;
      if (count + length > kCapacity) break;
      count += length;
    }
    return run;
  }
  HWY_INLINE void storeRadiance(Lanes3 value, std::size_t i)
  {
    hn::Store(value.x, D(), radiance[0] + i);
    hn::Store(value.y, D(), radiance[1] + i);
    hn::Store(value.z, D(), radiance[2] + i);
  }
  /// Names the pixels of the runs from `run` to before `end`, up to a whole vector.
  void namePixels(const FragmentList& fragments, std::uint16_t run, std::uint16_t end)
  {
    const hn::ScalableTag<std::int32_t> d;
    std::size_t at = 0;
    for (; run != end; run = fragments.run[run].next) {
      const FragmentRun& named = fragments.run[run];
      for (std::size_t i = 0; i < named.length; i += hn::Lanes(d))
        hn::StoreU(hn::Iota(d, static_cast<std::int32_t>(named.pixel + i)), d, pixel + at + i);
      at += named.length;
    }
    hn::StoreU(hn::Set(d, pixel[0]), d, pixel + at);
  }
  /// Gives the runs from `run` to before `end` their colours.
  void give(const FragmentList& fragments, std::uint16_t run, std::uint16_t end,
            Rgba8* pixels) const
  {
    giveArray(fragments, run, end, color, pixels);
  }
  void giveRadiance(const FragmentList& fragments, std::uint16_t run, std::uint16_t end,
                    RadianceArrays& pixels) const
  {
    giveArray(fragments, run, end, radiance[0], pixels.r.data());
    giveArray(fragments, run, end, radiance[1], pixels.g.data());
    giveArray(fragments, run, end, radiance[2], pixels.b.data());
  }
  /// Likewise, in the place of the radiance.
  void giveNormals(const FragmentList& fragments, std::uint16_t run, std::uint16_t end,
                   VectorArrays& pixels) const
  {
    giveArray(fragments, run, end, radiance[0], pixels.x.data());
    giveArray(fragments, run, end, radiance[1], pixels.y.data());
    giveArray(fragments, run, end, radiance[2], pixels.z.data());
  }

 private:
  template <class From, class To>
  static void giveArray(const FragmentList& fragments, std::uint16_t run, std::uint16_t end,
                        const From* from, To* pixels)
  {
    static_assert(sizeof(From) == sizeof(To), "what is copied is of one kind");
    for (; run != end; run = fragments.run[run].next) {
      std::memcpy(pixels + fragments.run[run].pixel, from,
                  fragments.run[run].length * sizeof *from);
      from += fragments.run[run].length;
    }
  }
};

/// The weights of a triangle's corners as weigh() has them, at pixel centres of a tile.
class TriangleWeights {
 public:
  TriangleWeights(const FragmentBatch& batch, std::size_t triangle, const TileRectangle& pixels)
  {
    std::int64_t x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = batch.screenX[k][triangle];
      y[k] = batch.screenY[k][triangle];
      inverseW_[k] = batch.inverseW[k][triangle];
    }
    const auto edge = [&](int a, int b, std::int64_t px, std::int64_t py) {
      return (x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]);
    };
    const std::int64_t sign = edge(0, 1, x[2], y[2]) < 0 ? -1 : 1;
    const std::int64_t px = std::int64_t{pixels.x0} * kSubpixels + kPixelCentre.x;
    const std::int64_t py = std::int64_t{pixels.y0} * kSubpixels + kPixelCentre.y;
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      first_[k] = static_cast<double>(sign * edge(a, b, px, py));
      perColumn_[k] = static_cast<double>(sign * (y[a] - y[b]) * kSubpixels);
      perRow_[k] = static_cast<double>(sign * (x[b] - x[a]) * kSubpixels);
    }
  }

  /// At points of the tile in subpixels.
  void weighPoints(const std::int32_t* x, const std::int32_t* y, std::size_t count,
                   float (&weight)[3][TriangleFragments::kRoom]) const
  {
    const hn::ScalableTag<double> d;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    const double perSubpixel = 1.0 / kSubpixels;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      // In pixels from the first one's centre: all steps are exact.
      const auto pixels = [&](const std::int32_t* from, std::int32_t centre) HWY_ATTR {
        const auto way = hn::Sub(hn::Load(di, from + i), hn::Set(di, centre));
        return hn::Mul(hn::PromoteTo(d, way), hn::Set(d, perSubpixel));
      };
      const auto column = pixels(x, kPixelCentre.x), row = pixels(y, kPixelCentre.y);
      const auto share = [&](int k) HWY_ATTR {
        const auto edge =
            hn::Add(hn::Set(d, first_[k]), hn::Add(hn::Mul(column, hn::Set(d, perColumn_[k])),
                                                   hn::Mul(row, hn::Set(d, perRow_[k]))));
        return hn::Mul(hn::DemoteTo(df, edge), hn::Set(df, inverseW_[k]));
      };
      storeWeights(share(0), share(1), share(2), weight, i, df);
    }
  }

  /// At the pixels that take() took from the runs from `run` to before `end`.
  void weigh(const FragmentList& list, std::uint16_t run, std::uint16_t end, bool footprint,
             TriangleFragments& fragments) const
  {
    weighRuns(list, run, end, 0, 0, fragments.weight);
    if (!footprint) return;
    weighRuns(list, run, end, 1, 0, fragments.rightWeight);
    weighRuns(list, run, end, 0, 1, fragments.aboveWeight);
  }

 private:
  /// Edge values stay below 2^50, so every step in double is exact.
  void weighRuns(const FragmentList& list, std::uint16_t run, std::uint16_t end, int right, int up,
                 float (&weight)[3][TriangleFragments::kRoom]) const
  {
    const D df;
    alignas(64) double columns[3][hn::MaxLanes(D())];
    for (int k = 0; k < 3; ++k)
      for (std::size_t lane = 0; lane < hn::Lanes(df); ++lane)
        columns[k][lane] = static_cast<double>(lane) * perColumn_[k];
    const auto lanes = static_cast<double>(hn::Lanes(df));
    const double perVector[3] = {lanes * perColumn_[0], lanes * perColumn_[1],
                                 lanes * perColumn_[2]};
    const auto w0 = hn::Set(df, inverseW_[0]), w1 = hn::Set(df, inverseW_[1]),
               w2 = hn::Set(df, inverseW_[2]);
    std::size_t at = 0;
    for (; run != end; run = list.run[run].next) {
      const auto pixel = static_cast<int>(list.run[run].pixel);
      const std::size_t length = list.run[run].length;
      const double column = pixel % kTileSide + right, row = pixel / kTileSide + up;
      double edge[3];
      for (int k = 0; k < 3; ++k)
        edge[k] = first_[k] + (column * perColumn_[k] + row * perRow_[k]);
      for (std::size_t i = at; i < at + length; i += hn::Lanes(df)) {
        const auto s0 = hn::Mul(edgesOfRow(df, edge[0], columns[0]), w0);
        const auto s1 = hn::Mul(edgesOfRow(df, edge[1], columns[1]), w1);
        const auto s2 = hn::Mul(edgesOfRow(df, edge[2], columns[2]), w2);
        storeWeights(s0, s1, s2, weight, i, df);
        for (int k = 0; k < 3; ++k)
          edge[k] += perVector[k];
      }
      at += length;
    }
    // Up to a whole vector.
    for (int k = 0; k < 3; ++k)
      hn::StoreU(hn::Set(df, weight[k][0]), df, weight[k] + at);
  }

  template <class V, class DF>
  HWY_INLINE static void storeWeights(V s0, V s1, V s2,
                                      float (&weight)[3][TriangleFragments::kRoom], std::size_t i,
                                      DF df)
  {
    const auto inverse = hn::Div(hn::Set(df, 1.0f), hn::Add(hn::Add(s0, s1), s2));
    hn::StoreU(hn::Mul(s0, inverse), df, weight[0] + i);
    hn::StoreU(hn::Mul(s1, inverse), df, weight[1] + i);
    hn::StoreU(hn::Mul(s2, inverse), df, weight[2] + i);
  }

  double first_[3], perColumn_[3], perRow_[3];
  float inverseW_[3];
};

/// Fragments of one triangle. Without radiance, one evaluation serves all where it can.
template <bool kHasRadiance>
void shadeFragments(Shader<TriangleLanes>& shader, TriangleFragments& fragments)
{
  const hn::RebindToUnsigned<D> du;
  const auto colorAt = [&](std::size_t i) HWY_ATTR {
    const Lanes3 color = shader.colorAt(fragments.weightsAt(i));
    if constexpr (kHasRadiance) fragments.storeRadiance(radianceOf(color), i);
    return quantized(color);
  };
  const bool isConstant = !kHasRadiance && shader.isConstant();
  const auto constant = isConstant ? colorAt(0) : hn::Zero(du);
  for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(du))
    hn::Store(isConstant ? constant : colorAt(i), du, fragments.color + i);
}

void shadeTrianglesKernel(const ShadingContext& context, const TileRectangle& pixels,
                          const FragmentList& list, Span<const std::uint32_t> numbers,
                          const FragmentBatch& batch, TileColors& colors)
{
  const bool footprint = UvUse(*context.placed->instance).footprint;
  TriangleFragments fragments;
  const Lighting lighting(context);
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (batch.needsClip[t] != 0) continue;
    const TriangleWeights weights(batch, t, pixels);
    Shader<TriangleLanes> shader(lighting, context, batch, TriangleLanes(t));
    if (shader.needsCorners()) shader.lightCorners();
    std::uint16_t run = list.firstRun[numbers[t]];
    while (run != FragmentRun::kNone) {
      const std::uint16_t first = run;
      run = fragments.take(list, run);
      weights.weigh(list, first, run, footprint, fragments);
      if (colors.hasRadiance)
        shadeFragments<true>(shader, fragments);
      else
        shadeFragments<false>(shader, fragments);
      fragments.give(list, first, run, colors.pixel);
      if (colors.hasRadiance) fragments.giveRadiance(list, first, run, colors.pixelRadiance);
    }
  }
}

/// FrameView::normal.
template <class Lanes>
HWY_INLINE Lanes3 normalAt(const Instance& instance, FragmentLanes<Lanes>& lanes,
                           const CornerWeights& weights)
{
  lanes.setWeights(weights);
  return instance.style.frequency == ShadingFrequency::kFlat ? lanes.faceNormal()
                                                             : lanes.pixelNormal();
}

void findNormalsKernel(const ShadingContext& context, FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    FragmentLanes<BatchLanes> lanes(context, batch, BatchLanes(i));
    store(normalAt(*context.placed->instance, lanes, weightsOf(batch, i)), batch.color, i);
  }
}

void findPlanesKernel(const ShadingContext& context, FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const FragmentLanes<BatchLanes> lanes(context, batch, BatchLanes(i));
    store(lanes.triangleNormal(), batch.color, i);
  }
}

void findRunNormalsKernel(const ShadingContext& context, const TileRectangle& pixels,
                          const FragmentList& list, Span<const std::uint32_t> numbers,
                          const FragmentBatch& batch, TileColors& colors)
{
  TriangleFragments fragments;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (batch.needsClip[t] != 0) continue;
    const TriangleWeights weights(batch, t, pixels);
    FragmentLanes<TriangleLanes> lanes(context, batch, TriangleLanes(t));
    std::uint16_t run = list.firstRun[numbers[t]];
    while (run != FragmentRun::kNone) {
      const std::uint16_t first = run;
      run = fragments.take(list, run);
      weights.weigh(list, first, run, false, fragments);
      for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(D()))
        fragments.storeRadiance(normalAt(*context.placed->instance, lanes, fragments.weightsAt(i)),
                                i);
      fragments.giveNormals(list, first, run, colors.pixelNormal);
      if (!colors.hasPlanes) continue;
      const Lanes3 plane = lanes.triangleNormal();
      for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(D()))
        fragments.storeRadiance(plane, i);
      fragments.giveNormals(list, first, run, colors.pixelPlane);
    }
  }
}

/// Some fragments of a translucent triangle, shaded together.
struct RunPart {
  static constexpr std::size_t kCapacity = TriangleFragments::kCapacity;
  static constexpr std::size_t kRoom = TriangleFragments::kRoom;

  alignas(64) std::int32_t x[kRoom], y[kRoom];  ///< where, in subpixels of the tile
  alignas(64) std::int32_t rightX[kRoom], aboveY[kRoom];
  alignas(64) float weight[3][kRoom];
  alignas(64) float rightWeight[3][kRoom];
  alignas(64) float aboveWeight[3][kRoom];
  std::size_t count;

  void take(const TranslucentFragments& fragments, std::uint32_t first, std::uint32_t end,
            int samples, const ShadingOffsets& offsets)
  {
    count = std::min<std::size_t>(end - first, kCapacity);
    for (std::size_t i = 0; i < count; ++i) {
      const auto pixel = static_cast<std::int32_t>(fragments.pixels()[first + i]);
      const SampleOffset offset =
          samples == 1 ? kPixelCentre : offsets[fragments.coverage()[first + i]];
      x[i] = pixel % kTileSide * kSubpixels + offset.x;
      y[i] = pixel / kTileSide * kSubpixels + offset.y;
    }
    // Up to a whole vector.
    for (std::size_t i = count; i < count + hn::Lanes(D()) && i < kRoom; ++i) {
      x[i] = x[0];
      y[i] = y[0];
    }
  }
  void weigh(const TriangleWeights& weights, bool footprint)
  {
    weights.weighPoints(x, y, count, weight);
    if (!footprint) return;
    for (std::size_t i = 0; i < count + hn::Lanes(D()) && i < kRoom; ++i) {
      rightX[i] = x[i] + kSubpixels;
      aboveY[i] = y[i] + kSubpixels;
    }
    weights.weighPoints(rightX, y, count, rightWeight);
    weights.weighPoints(x, aboveY, count, aboveWeight);
  }
  CornerWeights weightsAt(std::size_t i) const
  {
    return {{weight[0] + i, weight[1] + i, weight[2] + i},
            {rightWeight[0] + i, rightWeight[1] + i, rightWeight[2] + i},
            {aboveWeight[0] + i, aboveWeight[1] + i, aboveWeight[2] + i}};
  }
};

void shadeRunsKernel(const ShadingContext& context, const TileRectangle& pixels, int samples,
                     Span<const std::uint32_t> numbers, const FragmentBatch& batch,
                     TranslucentFragments& fragments)
{
  const Instance& instance = *context.placed->instance;
  const bool footprint = UvUse(instance).footprint;
  const ShadingOffsets offsets(samples);
  const Lighting lighting(context);
  RunPart part;
  alignas(64) float colors[4 * RunPart::kRoom];
  static_assert(sizeof(Vec4f) == 4 * sizeof(float), "colours are copied as floats");
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (batch.needsClip[t] != 0) continue;
    const TriangleWeights weights(batch, t, pixels);
    Shader<TriangleLanes> shader(lighting, context, batch, TriangleLanes(t));
    if (shader.needsCorners()) shader.lightCorners();
    const TranslucentFragments::Run run = fragments.runs()[numbers[t]];
    for (std::uint32_t first = run.first; first < run.end;
         first += static_cast<std::uint32_t>(part.count)) {
      part.take(fragments, first, run.end, samples, offsets);
      part.weigh(weights, footprint);
      for (std::size_t i = 0; i < part.count; i += hn::Lanes(D())) {
        const Lanes3 color = radianceOf(shader.colorAt(part.weightsAt(i)));
        const V alpha = shader.alphaAt(part.weightsAt(i), instance.material.opacity);
        hn::StoreInterleaved4(color.x, color.y, color.z, alpha, D(), colors + 4 * i);
      }
      std::memcpy(fragments.colors() + first, colors, part.count * sizeof(Vec4f));
    }
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
