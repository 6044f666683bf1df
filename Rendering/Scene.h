// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Base/Span.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/DepthCues.h"
#include "Rendering/ImageSpace.h"
#include "Rendering/Lines/LineSet.h"
#include "Rendering/Mesh/ClusteredMesh.h"
#include "Rendering/Mesh/HullEdges.h"
#include "Rendering/Mesh/MeshView.h"
#include "Rendering/Mesh/SmoothNormals.h"
#include "Rendering/Texture/TextureLayer.h"
#include "Rendering/ToneStyle.h"

#include <cstdint>

/// What a frame shows, as plain data. Nothing here owns memory: the host keeps the arrays alive for
/// the time of one render() call.
///
/// Notation of the shading terms: n normal, l towards the light, v towards the eye, h halfway
/// between l and v, all unit vectors; "(12.x)" are equations of the chapter on light and shading.
namespace limn {

struct Rgba8 {
  std::uint8_t r, g, b, a;
};

struct Camera {
  Mat4d worldToView;  ///< eye at the origin, looking along -z, y up; a rigid motion
  Mat4d viewToClip;   ///< OpenGL's clip space: -w <= x, y, z <= w is visible
  bool parallel;      ///< parallel projection: v is (0, 0, 1) everywhere
};

enum class LightKind : std::uint8_t {
  kHeadlight,    ///< directional, along the gaze; placed by the camera
  kDirectional,  ///< parallel rays; intensity does not fall off
  kPoint,        ///< from `position` in all directions
  kSpot,         ///< from `position`, inside a cone around `direction`
  /// From `samples` points of the parallelogram about `position`, to the side of
  /// halfSide[0] x halfSide[1] only: each sends the cosine to that direction, as a glowing surface
  /// does that is matt. `color` is for the direction straight ahead.
  kRectangle,
  kSphere,  ///< from `samples` points of the ball about `position`, in all directions
};

enum class LightUnit : std::uint8_t {
  kIntensity,  ///< I, for a directional light the irradiance
  /// P, sent out in all, not of headlight and directional: I = P / 4 pi (Fundamentals of Computer
  /// Graphics, 5.1), of a rectangle P / pi straight ahead. A spot is a point light in a screen:
  /// what its cone does not let pass is lost. Falls off by 1 / r^2, whatever `attenuation` says.
  kPower,
};

/// Most lights of a scene, each sample of a rectangle or sphere counted as one.
inline constexpr std::size_t kMaxLights = 65536;

struct Light {
  LightKind kind = LightKind::kHeadlight;
  Vec3d position = {0, 0, 1};    ///< world
  Vec3d direction = {0, 0, -1};  ///< world, the way the light travels; any length but zero
  Vec3f color = {1, 1, 1};       ///< by `unit`, per channel, >= 0, may exceed 1
  LightUnit unit = LightUnit::kIntensity;
  /// All but headlight and directional: colour times 1 / (a + b r + c r^2). (0, 0, 1) is the
  /// chapter's I_p / r^2, and (1, 0, 0), VTK's default, no fall-off.
  Vec3f attenuation = {0, 0, 1};
  float coneDegrees = 30;  ///< spot: half angle of the cone, 0 to 90
  float exponent = 1;      ///< spot: colour times cos(angle to the axis)^exponent
  /// Spot: width of the band inside the cone in which the light fades, 0 to coneDegrees: colour
  /// times t^2 (3 - 2 t), where t goes from 0 to 1 with the cosine. 0: a hard edge.
  float softDegrees = 0;
  /// Rectangle: from `position` to the middle of two of its sides; world, not parallel.
  Vec3d halfSide[2] = {{1, 0, 0}, {0, 1, 0}};
  double radius = 1;  ///< sphere: > 0; world
  int samples = 16;   ///< rectangle and sphere: lights that share the colour, > 0
};

class SurfaceShader;  // Rendering/SurfaceShader.h

/// How often a light equation is evaluated.
enum class ShadingFrequency : std::uint8_t {
  kFlat,     ///< once per face, at Attributes::facePoints with the face normal
  kGouraud,  ///< once per vertex; colours are interpolated with (12.4)
  kPhong,    ///< once per pixel; normals are interpolated with (12.4) and renormalised
};

enum class NormalSource : std::uint8_t {
  kTriangle,  ///< of the triangle's plane
  kCell,      ///< Attributes::cellNormals
  kVertex,    ///< Attributes::vertexNormals
};

enum class Reflection : std::uint8_t {
  /// As VTK's OpenGL shaders: k_a + sum of k_d max(0, n.l) I + highlight, where the highlight is
  /// k_s max(0, n.z)^p for a single headlight and the reflected-ray form for all else.
  kAsVtk,
  kNone,        ///< unlit: k_a + k_d
  kLambert,     ///< (12.1): k_a I_a + sum k_d I max(0, n.l)
  kBlinnPhong,  ///< (12.3): (12.1) + sum k_s I max(0, n.h)^p
  kPhong,       ///< (12.1) + sum k_s I max(0, r.v)^p, r the reflected ray
  /// (k_d / pi + k_s max(0, n.h)^p) E, E = I max(0, n.l): the highlight has the cosine, too, and
  /// k_d is the share of light sent back (Fundamentals of Computer Graphics, 5.2).
  kIrradiance,
  /// (12.1) with each light times A + B max(0, cos(phi_l - phi_v)) sin(alpha) tan(beta), the
  /// qualitative model of Oren and Nayar 1994; Material::roughness is their sigma. Flatter than
  /// Lambert's: the moon.
  kOrenNayar,
  /// Facets by Trowbridge and Reitz (GGX), Smith's shadowing, Schlick's Fresnel term, over k_d / pi
  /// for what is not a metal. Material::roughness squared is GGX's alpha. As in kIrradiance a white
  /// matt surface needs I = pi to look white.
  kMetallicRoughness,
  /// The same as VTK's OpenGL shaders have it (interpolation PBR, no environment): other shadowing,
  /// no ambient term, the sum to the power of 1/2.2.
  kMetallicRoughnessAsVtk,
};

/// How a tone treats colours that come from data, by Attributes or by a texture of
/// TextureLayer::isData. Their bytes are sRGB, as the user's legend shows them. k_d, bounded to 0
/// ... 1, is that colour; d is l.n, or 2 t - 1 with Style::toonBands, turned round by
/// Tone::kGoochChapter. All but kClassic add no highlight, which no legend has, and leave out the
/// stripes of kMetal; kRamp, kMatCap and kHatching are classic. Of kExaggerated d is 2 c - 1.
enum class ToneOverData : std::uint8_t {
  kClassic,  ///< as a tone treats any k_d
  /// (1 - sigma) k_d + sigma t, where t is the tone of a grey surface, k_d = 1/2.
  kUndertone,
  /// CIELAB's L* + w d, with a* and b* kept. Where w times 1 or -1 would leave the colours that a
  /// screen has, w is less for that side, by steps of w / 1024: none is left at the edge of these,
  /// as for pure red, green and blue.
  kLegendSafe,
};

struct Material {
  Vec3f ambientColor = {1, 1, 1}, diffuseColor = {1, 1, 1}, specularColor = {1, 1, 1};
  float ambient = 0, diffuse = 1, specular = 0;  ///< k_a, k_d, k_s are colour times coefficient
  float specularPower = 1;                       ///< p >= 0
  float roughness = 0.5f;                        ///< 0 to 1; see Reflection
  float metallic = 0;                            ///< 0 to 1
  /// By channel, at least 1; for Style::fresnel and for what is not a metal.
  Vec3f refractiveIndex = {1.5f, 1.5f, 1.5f};
  Vec3f edgeTint = {1, 1, 1};  ///< metals: what they reflect at grazing angles, 0 to 1
  /// Velvet: k_a and k_d grow by rim (1 - max(0, n.v))^rimPower towards the outline, for all but
  /// kAsVtk, kNone and the metallic models.
  Vec3f rim = {0, 0, 0};
  float rimPower = 3;  ///< >= 0
  /// Share of what is seen that is the surface's, 0 to 1; the rest is what lies behind it. Below 1
  /// the instance is translucent.
  float opacity = 1;
};

struct Style {
  ShadingFrequency frequency = ShadingFrequency::kPhong;
  NormalSource normals = NormalSource::kVertex;  ///< for kPhong and kGouraud
  Reflection reflection = Reflection::kAsVtk;
  /// Multiplies k_s by Schlick's F = F_0 + (1 - F_0) (1 - h.l)^5, F_0 = ((mu - 1) / (mu + 1))^2
  /// with the index of refraction mu, for kBlinnPhong, kPhong and kIrradiance.
  bool fresnel = false;
  bool fallOff = true;  ///< false: lights reach this instance whatever the distance
  /// A tone replaces the diffuse term: l is that of toneLight. k_cool = toneCool + coolSurface k_d
  /// and k_warm = toneWarm + warmSurface k_d (Gooch 1998, equation 3).
  Tone tone = Tone::kNone;
  ToneLight toneLight = ToneLight::kFirst;
  ToneHighlight toneHighlight = ToneHighlight::kAdded;
  Vec3f toneCool = {0, 0, 0.4f}, toneWarm = {0.4f, 0.4f, 0};
  float coolSurface = 0.2f, warmSurface = 0.6f;
  ToneRamp ramp;
  Hatching hatching;
  Exaggeration exaggeration;
  /// 2 to kMaxToonBands: light, summed over all lights, in so many even steps; 0 or 1: smooth. A
  /// value t becomes k / (N - 1) from t = k / N on, and a highlight is all or nothing, from 1/2 on.
  /// Edges are antialiased over a pixel by the change of t to the right and above in the triangle's
  /// plane, without bumps.
  ///
  /// Tones: t = (1 + l.n) / 2, or c of kExaggerated. Not for kRamp, whose picture has its own
  /// steps, kMatCap and kHatching. Reflection models: the light sent back by a matt surface of k_d
  /// = 1, a colour, keeps its hue; t is its strongest channel. The unlit have none. No Fresnel
  /// term; facets (the metallic models) are drawn as Blinn and Phong's with p = 2 / alpha^2 - 2,
  /// k_d without the metal's share, and F_0 for k_s. Sums of irradiance are divided by pi, as a
  /// white surface needs I = pi there. Frequencies: kFlat gives each face one step. With kGouraud
  /// vertices are stepped and colours interpolated, so that a step is as wide as a triangle. There,
  /// and where a surface shader asks for light, edges are hard.
  int toonBands = 0;
  ToneOverData toneOverData = ToneOverData::kClassic;  ///< where there are colours of data
  float undertone = 0.25f;                             ///< sigma, 0 to 1
  float legendSafeRange = 12;                          ///< w, 0 to 100
  /// Pixels with |n.v| below this get outlineColor (figure 12.15); 0 draws no outline.
  float outlineThreshold = 0;
  /// In its place, pixels up to outlineWidth from where g = n.v is 0. A smooth surface of the
  /// curvature c towards the eye has g^2 = 2 c d at d pixels from its border, and a triangle of it,
  /// whose plane is tilted to f = |n.v|, f |grad g| = c: the line covers clamp(outlineWidth + 1/2 -
  /// g^2 / (2 f |grad g|)) of a pixel, grad by the pixels to the right and above in the plane.
  bool evenOutline = false;
  float outlineWidth = 2;  ///< pixels, >= 0; of all outlines but that by a threshold
  Vec3f outlineColor = {0, 0, 0};
  float outlineOpacity = 1;   ///< 0 to 1; the rest is the surface's colour
  ImageOutline imageOutline;  ///< with the width, colour and opacity above
  DepthCues cues;
  /// Gives colours in the place of the light equation, pixel by pixel; may call it. Not owned.
  const SurfaceShader* surfaceShader = nullptr;
  /// The instance is translucent, whatever its opacity, which the alpha of Attributes' colours
  /// multiplies. Textures of kShaded and kSurface do, too, but for TextureMode::kReplace, which
  /// puts the texture's alpha in place of the colours', and kDecal, which leaves that as it is.
  bool readsAlpha = false;

  /// Whether it reads what lies a pixel to the right and above.
  bool readsFootprint() const { return evenOutline || toonBands >= 2 || isHatched(); }
  bool isHatched() const { return tone == Tone::kHatching && surfaceShader == nullptr; }
  bool isExaggerated() const { return tone == Tone::kExaggerated && surfaceShader == nullptr; }
  /// Whether kGouraud, too, is lit by each pixel.
  bool isPerPixel() const { return isHatched() || isExaggerated(); }
};

/// Values on a mesh. Sizes: one per vertex or one per cell of the MeshView, or empty.
struct Attributes {
  Span<const Vec3f> vertexNormals;  ///< need not be unit; with normalOfCorner: any number
  Span<const Vec3f> cellNormals;
  /// Replace the material's diffuse and ambient *colours*; vertex colours win over cell colours.
  /// Alpha is read where Style::readsAlpha asks for it.
  Span<const Rgba8> vertexColors;
  Span<const Rgba8> cellColors;
  /// Where flat shading lights a face, per cell: FaceGeometry::centroid, or firstCorners().
  Span<const Vec3d> facePoints;
  Span<const Vec3f> faceNormals;    ///< FaceGeometry, per cell
  Span<const std::uint32_t> cells;  ///< cell of each triangle; empty: triangle t is cell t
  std::size_t cellCount = 0;        ///< with `cells`: required to be above every one of them
  /// Texture coordinates, per vertex; one that is not finite counts as 0.
  Span<const Vec2f> uv = {}, uv2 = {};
  /// Three a triangle: which of vertexNormals its corners have, so that a vertex may have several;
  /// see splitVertexNormals(). Required to be numbers of such that are there. Empty: that of the
  /// vertex.
  Span<const std::uint32_t> normalOfCorner = {};
  /// For Tone::kExaggerated: SmoothNormals, smoothLevels of them a vertex or, with smoothOfCorner,
  /// any number of times so many.
  Span<const std::uint32_t> smoothNormals = {};
  /// Three a triangle: which of smoothNormals its corners have, so that a vertex may have several.
  /// Required to be numbers of such that are there. Empty: those of the vertex.
  Span<const std::uint32_t> smoothOfCorner = {};
  std::size_t smoothCount = 0;  ///< with `smoothOfCorner`: required to be above every one of them
  int smoothLevels = 0;         ///< 1 to kMaxSmoothLevels, if there are any
  float smoothRatio = 1;        ///< from a level's sigma to the next, 1 to kMaxSmoothRatio
  /// For ImageOutline::ids, per cell: what it is a part of. Empty: all of them are of one.
  Span<const std::uint32_t> cellIds = {};
};

/// Longest move of a hull's vertex, in widths: corners of the outline sharper than 29 degrees get
/// narrower towards their point.
inline constexpr double kHullMiter = 4;
/// Window depth that a hull lies behind its mesh; some times what rounding can make of a depth.
inline constexpr double kHullDepth = 0x1p-18;

/// One mesh in the world. Draw order is the order in Scene::instances, then of the triangles.
///
/// Translucent instances are drawn after the opaque ones, exactly and in any order of submission:
/// in each sample every triangle that is not behind the opaque surfaces gives one fragment of
/// colour c and alpha a, both clamped to 0 ... 1, shaded once a pixel as opaque ones are. From the
/// farthest to the nearest (of equal depths the later in draw order is nearer) each makes C into c
/// a + C (1 - a) and A into a + A (1 - a), in float; C and A start as the bytes that the sample
/// would have without it, divided by 255, and end up rounded to bytes. Radiance, which has no upper
/// bound of 1, goes the same way from the sample's radiance. They write neither depth nor names.
/// How many fragments are kept is bounded: see kMaxTranslucentSamples.
struct Instance {
  const ClusteredMesh* clusters = nullptr;  ///< read by the pipeline
  MeshView mesh;                            ///< read by the reference renderer
  Attributes attributes;
  Mat4d modelToWorld = Mat4d::identity();
  Material material;
  Style style;
  Span<const TextureLayer> layers;                     ///< applied in this order
  bool cullBackFaces = false, cullFrontFaces = false;  ///< front: counter-clockwise on the screen
  std::uint32_t id = 0;  ///< written to FrameView::instance where this instance is seen
  /// Not null: in place of the mesh its inverted hull is drawn, the outline of the solid that the
  /// mesh bounds, in Style::outlineColor without light. The solid is an instance of its own, before
  /// or after. Made for `mesh`, which the pipeline reads here too, in place of `clusters`.
  ///
  /// An edge of two triangles that is convex lies on the outline if one of them shows its front and
  /// the other its back. Each end of it moves on the screen so far that all edges of the outline
  /// there move outward by outlineWidth: by its miter, along their bisector, but no farther than
  /// kHullMiter widths. Distances and angles are of pixels, whatever the camera does. The triangles
  /// at these vertices that show their backs, and no others, are drawn where their vertices come to
  /// lie. Depths stay, but for kHullDepth, and where the plane of one of these triangles is deeper
  /// at the new place: then that depth, up to what the triangle's own corners differ by. So the
  /// mesh hides its hull wherever it is. What shows has the names of the instance and of the cells.
  ///
  /// Borders always lie on the outline. Their ends move likewise, those of triangles that show
  /// their fronts, of those that show their backs, and of the edges above each by themselves; what
  /// lies between a border and its new place is drawn, between it and its triangle where that has
  /// moved, and at a vertex between its new places.
  const HullEdges* hull = nullptr;
  /// Drawn over the finished surfaces of all instances, in the order of instances, then sets. They
  /// write no names; their depth where they cover half of a pixel and are nearer than what is
  /// there.
  Span<const LineSet> lines = {};

  /// Whether a tone finds colours of data that it does not treat classically.
  bool tonesData() const
  {
    if (style.toneOverData == ToneOverData::kClassic) return false;
    for (const TextureLayer& layer : layers)
      if (layer.isData) return true;
    return !(attributes.vertexColors.empty() && attributes.cellColors.empty());
  }
  bool isTranslucent() const
  {
    return hull != nullptr ? style.outlineOpacity < 1 : material.opacity < 1 || style.readsAlpha;
  }
};

/// How the samples of a pixel become one colour.
enum class Resolve : std::uint8_t {
  kGamma22,  ///< (mean of c^2.2)^(1/2.2), as VTK's windows resolve
  kLinear,   ///< mean of the bytes, rounded to nearest
};

struct Scene {
  Camera camera;
  Vec3f ambientLight = {0, 0, 0};  ///< I_a; not used by Reflection::kAsVtk and kNone
  Span<const Light> lights;
  Span<const Instance> instances;
  int samples = 1;  ///< per pixel: 1, 2, 4, 8 or 16, at Direct3D's standard positions
  Resolve resolve = Resolve::kGamma22;
};

}  // namespace limn
