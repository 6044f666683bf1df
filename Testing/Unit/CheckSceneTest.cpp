// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each kind of input that cannot be drawn gets its error, a message that names it, and no picture.
#include "Testing/Unit/TestScene.h"

#include <cmath>
#include <limits>

namespace limn::testing {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A scene that can be drawn, until a test spoils it.
struct Input {
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  std::vector<Light> lights = {Light{}};
  std::vector<Instance> instances;
  Scene scene;
  Picture picture{16, 16};
  FrameView frame = picture.frame(Background::kBlend);

  Input()
  {
    mesh.cellNormals = {{0, 0, 1}};
    mesh.vertexColors.assign(4, {1, 2, 3, 4});
    mesh.cellColors = {{1, 2, 3, 4}};
    instances = {instanceOf(mesh)};
    lights[0].kind = LightKind::kSpot;
    Stage stage;
    scene = stage.scene();
    scene.lights = lights;
    scene.instances = instances;
  }
  Light& light() { return lights[0]; }
  Instance& instance() { return instances[0]; }
};

struct Mistake {
  const char* name;
  Error error;
  const char* word;  ///< that the message must hold
  void (*make)(Input&);
};

void PrintTo(const Mistake& mistake, std::ostream* stream)
{
  *stream << mistake.name;
}

/// Attribute arrays that are one too short: views on the mesh's own.
template <class T>
Span<const T> shortened(Span<const T> span)
{
  return {span.data(), span.size() - 1};
}

/// A picture of one white texel.
void giveRamp(Input& input)
{
  static const TextureImage* const kWhite = [] {
    static TextureImage image;
    static const std::uint8_t texel[] = {255};
    EXPECT_TRUE(
        image.build({1, 1, 1, TexelFormat::kUnorm8, texel, sizeof texel}, MipChain::kNone).ok());
    return &image;
  }();
  input.instance().style.tone = Tone::kRamp;
  input.instance().style.ramp.image = kWhite;
}

/// Of the sheet's four vertices, at two scales.
void giveSmoothNormals(Input& input)
{
  static const std::uint32_t kUpwards[8] = {};
  input.instance().style.tone = Tone::kExaggerated;
  input.instance().attributes.smoothNormals = {kUpwards, 8};
  input.instance().attributes.smoothLevels = 2;
}

/// The same, corner by corner.
void giveSmoothNormalsOfCorners(Input& input)
{
  static const std::uint32_t kOfCorners[6] = {0, 1, 2, 0, 2, 3};
  giveSmoothNormals(input);
  input.instance().attributes.smoothOfCorner = {kOfCorners, 6};
  input.instance().attributes.smoothCount = 4;
}

const Mistake kFrameMistakes[] = {
    {"WidthZero", Error::kInvalidImageSize, "0 x 16", [](Input& i) { i.frame.width = 0; }},
    {"HeightZero", Error::kInvalidImageSize, "16 x 0", [](Input& i) { i.frame.height = 0; }},
    {"WidthNegative", Error::kInvalidImageSize, "-3 x 16", [](Input& i) { i.frame.width = -3; }},
    {"WidthTooLarge", Error::kInvalidImageSize, "16385",
     [](Input& i) { i.frame.width = 16385, i.frame.rowStride = 16385; }},
    {"HeightTooLarge", Error::kInvalidImageSize, "16385", [](Input& i) { i.frame.height = 16385; }},
    {"RowStrideTooSmall", Error::kInvalidImageSize, "stride",
     [](Input& i) { i.frame.rowStride = 15; }},
    {"NoColorPlane", Error::kMissingData, "colour", [](Input& i) { i.frame.color = nullptr; }},
    {"NoDepthPlane", Error::kMissingData, "depth", [](Input& i) { i.frame.depth = nullptr; }},
    {"SamplesThree", Error::kInvalidSampleCount, "3", [](Input& i) { i.scene.samples = 3; }},
    {"SamplesZero", Error::kInvalidSampleCount, "0", [](Input& i) { i.scene.samples = 0; }},
    {"SamplesThirtyTwo", Error::kInvalidSampleCount, "32", [](Input& i) { i.scene.samples = 32; }},
    {"CoverageOfSixteenSamples", Error::kInvalidSampleCount, "coverage",
     [](Input& i) {
       static std::uint8_t coverage[1];
       i.scene.samples = 16, i.frame.coverage = coverage;
     }},
    {"SamplesNegative", Error::kInvalidSampleCount, "-1", [](Input& i) { i.scene.samples = -1; }},
};

const Mistake kSceneMistakes[] = {
    {"ViewMatrixNan", Error::kNotFinite, "camera",
     [](Input& i) { i.scene.camera.worldToView.m[1][3] = std::nan(""); }},
    {"ProjectionInfinite", Error::kNotFinite, "camera",
     [](Input& i) { i.scene.camera.viewToClip.m[0][0] = HUGE_VAL; }},
    {"AmbientLightNan", Error::kNotFinite, "ambient",
     [](Input& i) { i.scene.ambientLight.y = kNan; }},
    {"AmbientLightNegative", Error::kNotFinite, "ambient",
     [](Input& i) { i.scene.ambientLight.y = -1; }},
    {"LightColorNan", Error::kNotFinite, "Light 0", [](Input& i) { i.light().color.x = kNan; }},
    {"LightColorNegative", Error::kNotFinite, "Light 0", [](Input& i) { i.light().color.z = -1; }},
    {"LightPositionInfinite", Error::kNotFinite, "Light 0",
     [](Input& i) { i.light().position.x = HUGE_VAL; }},
    {"LightDirectionNan", Error::kNotFinite, "Light 0",
     [](Input& i) { i.light().direction.x = std::nan(""); }},
    {"LightDirectionZero", Error::kNotFinite, "direction",
     [](Input& i) {
       i.light().direction = {0, 0, 0};
     }},
    {"DirectionalLightsDirectionZero", Error::kNotFinite, "direction",
     [](Input& i) {
       i.light().kind = LightKind::kDirectional, i.light().direction = {0, 0, 0};
     }},
    {"AttenuationZero", Error::kNotFinite, "attenuation",
     [](Input& i) {
       i.light().attenuation = {0, 0, 0};
     }},
    {"PointLightsAttenuationZero", Error::kNotFinite, "attenuation",
     [](Input& i) {
       i.light().kind = LightKind::kPoint, i.light().attenuation = {0, 0, 0};
     }},
    {"AttenuationNegative", Error::kNotFinite, "attenuation",
     [](Input& i) { i.light().attenuation.y = -1; }},
    {"AttenuationNan", Error::kNotFinite, "Light 0",
     [](Input& i) { i.light().attenuation.y = kNan; }},
    {"Cone91", Error::kNotFinite, "cone", [](Input& i) { i.light().coneDegrees = 91; }},
    {"ConeNegative", Error::kNotFinite, "cone", [](Input& i) { i.light().coneDegrees = -1; }},
    {"ConeNan", Error::kNotFinite, "Light 0", [](Input& i) { i.light().coneDegrees = kNan; }},
    {"ExponentNegative", Error::kNotFinite, "exponent", [](Input& i) { i.light().exponent = -1; }},
    {"ExponentNan", Error::kNotFinite, "Light 0", [](Input& i) { i.light().exponent = kNan; }},
    {"SoftEdgeNegative", Error::kInvalidLight, "soft",
     [](Input& i) { i.light().softDegrees = -1; }},
    {"SoftEdgeNan", Error::kInvalidLight, "soft", [](Input& i) { i.light().softDegrees = kNan; }},
    {"SoftEdgeWiderThanTheCone", Error::kInvalidLight, "soft",
     [](Input& i) { i.light().coneDegrees = 20, i.light().softDegrees = 21; }},
    {"PowerOfAHeadlight", Error::kInvalidLight, "power",
     [](Input& i) { i.light().kind = LightKind::kHeadlight, i.light().unit = LightUnit::kPower; }},
    {"PowerOfADirectionalLight", Error::kInvalidLight, "power",
     [](Input& i) {
       i.light().kind = LightKind::kDirectional, i.light().unit = LightUnit::kPower;
     }},
    {"SphereOfNoRadius", Error::kInvalidLight, "radius",
     [](Input& i) { i.light().kind = LightKind::kSphere, i.light().radius = 0; }},
    {"SphereOfRadiusNan", Error::kInvalidLight, "radius",
     [](Input& i) { i.light().kind = LightKind::kSphere, i.light().radius = std::nan(""); }},
    {"SphereOfNoSamples", Error::kInvalidLight, "samples",
     [](Input& i) { i.light().kind = LightKind::kSphere, i.light().samples = 0; }},
    {"RectangleOfNoArea", Error::kInvalidLight, "area",
     [](Input& i) {
       i.light().kind = LightKind::kRectangle, i.light().halfSide[1] = {-2, 0, 0};
     }},
    {"RectangleOfInfiniteSides", Error::kInvalidLight, "area",
     [](Input& i) {
       i.light().kind = LightKind::kRectangle, i.light().halfSide[1] = {0, HUGE_VAL, 0};
     }},
    {"SamplesPastTheLimit", Error::kInvalidLight, "65537 lights",
     [](Input& i) { i.light().kind = LightKind::kSphere, i.light().samples = 65537; }},
};

const Mistake kInstanceMistakes[] = {
    {"ModelMatrixNan", Error::kNotFinite, "Instance 0",
     [](Input& i) { i.instance().modelToWorld.m[2][0] = std::nan(""); }},
    {"DiffuseNan", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.diffuse = kNan; }},
    {"AmbientNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.ambient = -0.1f; }},
    {"OpacityAboveOne", Error::kNotFinite, "opacity",
     [](Input& i) { i.instance().material.opacity = 1.5f; }},
    {"OpacityNegative", Error::kNotFinite, "opacity",
     [](Input& i) { i.instance().material.opacity = -0.1f; }},
    {"OpacityNan", Error::kNotFinite, "opacity",
     [](Input& i) { i.instance().material.opacity = kNan; }},
    {"SpecularInfinite", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.specular = kInfinity; }},
    {"PowerNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.specularPower = -1; }},
    {"AmbientColorNan", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.ambientColor.x = kNan; }},
    {"DiffuseColorNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.diffuseColor.y = -1; }},
    {"SpecularColorNan", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.specularColor.z = kNan; }},
    {"RoughnessNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.roughness = -0.1f; }},
    {"RoughnessAboveOne", Error::kNotFinite, "roughness",
     [](Input& i) { i.instance().material.roughness = 1.1f; }},
    {"MetallicNan", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.metallic = kNan; }},
    {"MetallicAboveOne", Error::kNotFinite, "metallic",
     [](Input& i) { i.instance().material.metallic = 1.1f; }},
    {"RefractiveIndexBelowOne", Error::kNotFinite, "refractive index",
     [](Input& i) { i.instance().material.refractiveIndex.y = 0.9f; }},
    {"RefractiveIndexNan", Error::kNotFinite, "refractive index",
     [](Input& i) { i.instance().material.refractiveIndex.z = kNan; }},
    {"EdgeTintNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.edgeTint.x = -0.5f; }},
    {"RimInfinite", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.rim.x = kInfinity; }},
    {"RimNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.rim.z = -1; }},
    {"RimPowerNegative", Error::kNotFinite, "material",
     [](Input& i) { i.instance().material.rimPower = -1; }},
    {"ToneCoolNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.toneCool.x = kNan; }},
    {"ToneWarmNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.toneWarm.x = kNan; }},
    {"CoolSurfaceNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.coolSurface = kNan; }},
    {"WarmSurfaceNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.warmSurface = kNan; }},
    {"UndertoneNan", Error::kNotFinite, "undertone",
     [](Input& i) { i.instance().style.undertone = kNan; }},
    {"UndertoneAboveOne", Error::kNotFinite, "undertone",
     [](Input& i) { i.instance().style.undertone = 1.01f; }},
    {"LegendSafeRangeNegative", Error::kNotFinite, "legend-safe",
     [](Input& i) { i.instance().style.legendSafeRange = -1; }},
    {"LegendSafeRangeInfinite", Error::kNotFinite, "legend-safe",
     [](Input& i) { i.instance().style.legendSafeRange = kInfinity; }},
    {"OutlineThresholdNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.outlineThreshold = kNan; }},
    {"OutlineColorNan", Error::kNotFinite, "style",
     [](Input& i) { i.instance().style.outlineColor.x = kNan; }},
    {"OutlineWidthInfinite", Error::kNotFinite, "outline",
     [](Input& i) { i.instance().style.outlineWidth = kInfinity; }},
    {"OutlineWidthNegative", Error::kNotFinite, "outline",
     [](Input& i) { i.instance().style.outlineWidth = -1; }},
    {"OutlineOpacityAboveOne", Error::kNotFinite, "outline",
     [](Input& i) { i.instance().style.outlineOpacity = 1.5f; }},
    {"OutlineOpacityNan", Error::kNotFinite, "outline",
     [](Input& i) { i.instance().style.outlineOpacity = kNan; }},
    {"ToonBandsNegative", Error::kNotFinite, "bands",
     [](Input& i) { i.instance().style.toonBands = -1; }},
    {"ToonBandsTooMany", Error::kNotFinite, "bands",
     [](Input& i) { i.instance().style.toonBands = 65; }},
    {"RampWithoutPicture", Error::kMissingData, "picture",
     [](Input& i) { i.instance().style.tone = Tone::kRamp; }},
    {"MatCapWithoutPicture", Error::kMissingData, "picture",
     [](Input& i) { i.instance().style.tone = Tone::kMatCap; }},
    {"HatchSpacingBelowOne", Error::kNotFinite, "hatching",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.spacing = 0.5f;
     }},
    {"HatchSpacingNan", Error::kNotFinite, "hatching",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.spacing = kNan;
     }},
    {"HatchDarkestAboveOne", Error::kNotFinite, "hatching",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.darkest = 1.5f;
     }},
    {"HatchInkNegative", Error::kNotFinite, "hatching",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.ink.y = -1;
     }},
    {"HatchPaperInfinite", Error::kNotFinite, "hatching",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.paper.z = kInfinity;
     }},
    {"HatchingWithoutTextureCoordinates", Error::kMissingData, "texture coordinates",
     [](Input& i) {
       i.instance().style.tone = Tone::kHatching;
       i.instance().style.hatching.place = HatchPlace::kTexture;
       i.instance().attributes.uv = {};
     }},
    {"ExaggerationContrastNegative", Error::kNotFinite, "exaggeration",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().style.exaggeration.contrast = -1;
     }},
    {"ExaggerationContrastInfinite", Error::kNotFinite, "exaggeration",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().style.exaggeration.contrast = kInfinity;
     }},
    {"ExaggerationExponentNan", Error::kNotFinite, "exaggeration",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().style.exaggeration.exponent = kNan;
     }},
    {"ExaggerationExponentTooLow", Error::kNotFinite, "exaggeration",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().style.exaggeration.exponent = -4.5f;
     }},
    {"ExaggerationBaseAboveOne", Error::kNotFinite, "exaggeration",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().style.exaggeration.base = 1.5f;
     }},
    {"ExaggerationWithoutNormals", Error::kMissingData, "exaggeration",
     [](Input& i) { i.instance().style.tone = Tone::kExaggerated; }},
    {"SmoothNormalsTooFew", Error::kSizeMismatch, "smooth normals",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().attributes.smoothNormals = shortened(i.instance().attributes.smoothNormals);
     }},
    {"SmoothNormalsOfCornersTooFew", Error::kSizeMismatch, "smooth normals of corners",
     [](Input& i) {
       static const std::uint32_t one[] = {0};
       giveSmoothNormals(i);
       i.instance().attributes.smoothOfCorner = {one, 1};
       i.instance().attributes.smoothCount = 4;
     }},
    {"SmoothNormalsFewerThanCornersHave", Error::kSizeMismatch,
     "its corners have 4 smooth normals of 2 levels, and there are 7 values",
     [](Input& i) {
       giveSmoothNormalsOfCorners(i);
       i.instance().attributes.smoothNormals = shortened(i.instance().attributes.smoothNormals);
     }},
    {"SmoothNormalsOfCornersWithoutTheirNumber", Error::kSizeMismatch, "smoothCount",
     [](Input& i) {
       giveSmoothNormalsOfCorners(i);
       i.instance().attributes.smoothCount = 0;
     }},
    {"SmoothNormalsWithoutLevels", Error::kNotFinite, "levels",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().attributes.smoothLevels = 0;
     }},
    {"SmoothNormalsOfTooManyLevels", Error::kNotFinite, "levels",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().attributes.smoothLevels = kMaxSmoothLevels + 1;
     }},
    {"SmoothRatioBelowOne", Error::kNotFinite, "ratio",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().attributes.smoothRatio = 0.5f;
     }},
    {"SmoothRatioNan", Error::kNotFinite, "ratio",
     [](Input& i) {
       giveSmoothNormals(i);
       i.instance().attributes.smoothRatio = kNan;
     }},
    {"RampExponentNegative", Error::kNotFinite, "ramp",
     [](Input& i) {
       giveRamp(i);
       i.instance().style.ramp.exponent = -1;
     }},
    {"RampRangeTurnedRound", Error::kNotFinite, "ramp",
     [](Input& i) {
       giveRamp(i);
       i.instance().style.ramp.nearest = 2;
       i.instance().style.ramp.farthest = 1;
     }},
    {"RampRangeNan", Error::kNotFinite, "ramp",
     [](Input& i) {
       giveRamp(i);
       i.instance().style.ramp.nearest = kNan;
     }},
    {"HullOfAnotherMesh", Error::kSizeMismatch, "buildHullEdges",
     [](Input& i) { i.instance().hull = &i.mesh.hull; }},
    {"HullColorNegative", Error::kNotFinite, "colour of its hull",
     [](Input& i) {
       EXPECT_TRUE(buildHullEdges(i.mesh.view(), 1, i.mesh.hull).ok());
       i.instance().hull = &i.mesh.hull, i.instance().style.outlineColor.y = -1;
     }},
    {"CellsTooShort", Error::kSizeMismatch, "cells",
     [](Input& i) { i.instance().attributes.cells = shortened(i.instance().attributes.cells); }},
    {"VertexNormalsTooShort", Error::kSizeMismatch, "vertex normals",
     [](Input& i) {
       i.instance().attributes.vertexNormals = shortened(i.instance().attributes.vertexNormals);
     }},
    {"NormalsOfCornersTooShort", Error::kSizeMismatch, "normals of corners",
     [](Input& i) {
       static const std::uint32_t one[] = {0};
       i.instance().attributes.normalOfCorner = {one, 1};
     }},
    {"VertexColorsTooShort", Error::kSizeMismatch, "vertex colours",
     [](Input& i) {
       i.instance().attributes.vertexColors = shortened(i.instance().attributes.vertexColors);
     }},
    {"CellNormalsTooShort", Error::kSizeMismatch, "cell normals",
     [](Input& i) { i.instance().attributes.cellCount = 2; }},
    {"CellColorsTooShort", Error::kSizeMismatch, "cell colours",
     [](Input& i) {
       i.instance().attributes.cells = {}, i.instance().attributes.cellNormals = {};
     }},
    {"FacePointsTooShort", Error::kSizeMismatch, "points of faces",
     [](Input& i) {
       i.instance().attributes.cells = {}, i.instance().attributes.cellNormals = {};
       i.instance().attributes.cellColors = {};
     }},
    {"FaceNormalsTooShort", Error::kSizeMismatch, "face normals",
     [](Input& i) {
       i.instance().attributes.cells = {}, i.instance().attributes.cellNormals = {};
       i.instance().attributes.cellColors = {}, i.instance().attributes.facePoints = {};
     }},
    {"NoVertexNormals", Error::kMissingData, "vertex normals",
     [](Input& i) { i.instance().attributes.vertexNormals = {}; }},
    {"NoCellNormals", Error::kMissingData, "cell normals",
     [](Input& i) {
       i.instance().style.normals = NormalSource::kCell, i.instance().attributes.cellNormals = {};
     }},
    {"NoFaceNormals", Error::kMissingData, "face",
     [](Input& i) {
       i.instance().style.frequency = ShadingFrequency::kFlat;
       i.instance().attributes.faceNormals = {};
     }},
    {"NoFacePoints", Error::kMissingData, "face",
     [](Input& i) {
       i.instance().style.frequency = ShadingFrequency::kFlat;
       i.instance().attributes.facePoints = {};
     }},
};

/// A scene with a line that a test spoils.
LineSet lineOf(Input& input)
{
  static const std::uint32_t vertex[] = {0, 1}, first[] = {0, 2};
  return {input.mesh.view(), {vertex, 2}, {first, 2}, {}, {}, {}};
}

template <class Spoil>
void spoilLine(Input& input, const Spoil& spoil)
{
  static LineSet lines;
  lines = lineOf(input);
  spoil(lines);
  input.instance().lines = {&lines, 1};
}

const Mistake kLineMistakes[] = {
    {"LineColorNan", Error::kNotFinite, "lines 0",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.color.y = kNan; }); }},
    {"LineOpacityAboveOne", Error::kNotFinite, "opacity",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.opacity = 1.1f; }); }},
    {"LineWidthZero", Error::kNotFinite, "width",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.width = 0; }); }},
    {"LineWidthInfinite", Error::kNotFinite, "style",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.width = kInfinity; }); }},
    {"LineWidthTooLarge", Error::kNotFinite, "width",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.width = 257; }); }},
    {"LineTaperNegative", Error::kNotFinite, "style",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.taper = -1; }); }},
    {"LineOuterFactorNan", Error::kNotFinite, "style",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.outerFactor = kNan; }); }},
    {"LineDashesWithoutGaps", Error::kNotFinite, "gaps",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.dash = 3; }); }},
    {"LineDashesTooShort", Error::kNotFinite, "half a pixel",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.style.dash = l.style.gap = 1e-4f; }); }},
    {"LineOfNoPoint", Error::kIndexOutOfRange, "point",
     [](Input& i) { spoilLine(i, [](LineSet& l) { l.points.positions = {}; }); }},
    {"LineChainsOutOfOrder", Error::kIndexOutOfRange, "order",
     [](Input& i) {
       static const std::uint32_t first[] = {2, 0};
       spoilLine(i, [](LineSet& l) { l.first = {first, 2}; });
     }},
    {"LineChainsTooLong", Error::kIndexOutOfRange, "order",
     [](Input& i) {
       static const std::uint32_t first[] = {0, 3};
       spoilLine(i, [](LineSet& l) { l.first = {first, 2}; });
     }},
    {"LineFlagsTooShort", Error::kSizeMismatch, "flags",
     [](Input& i) {
       static const std::uint8_t flags[] = {0};
       spoilLine(i, [](LineSet& l) { l.flags = {flags, 1}; });
     }},
    {"LineSlackTooShort", Error::kSizeMismatch, "slack",
     [](Input& i) {
       static const float slack[] = {0};
       spoilLine(i, [](LineSet& l) { l.slack = {slack, 1}; });
     }},
    {"LineShareTooShort", Error::kSizeMismatch, "shares",
     [](Input& i) {
       static const float share[] = {0};
       spoilLine(i, [](LineSet& l) { l.share = {share, 1}; });
     }},
    {"LineShareNan", Error::kNotFinite, "share",
     [](Input& i) {
       static const float share[] = {0, kNan, 0, 0};
       spoilLine(i, [](LineSet& l) { l.share = {share, 4}; });
     }},
    {"LineShareAboveOne", Error::kNotFinite, "share",
     [](Input& i) {
       static const float share[] = {0, 1, 1.5f, 0};
       spoilLine(i, [](LineSet& l) { l.share = {share, 4}; });
     }},
    {"LineSlackNan", Error::kNotFinite, "slack",
     [](Input& i) {
       static const float slack[] = {0, kNan, 0, 0};
       spoilLine(i, [](LineSet& l) { l.slack = {slack, 4}; });
     }},
};

class Mistakes : public ::testing::TestWithParam<std::tuple<Mistake, Backend>> {};

TEST_P(Mistakes, AreToldAndNothingIsDrawn)
{
  const auto& [mistake, backend] = GetParam();
  Input input;
  const Picture before = input.picture;
  mistake.make(input);
  const Status status = render(input.scene, input.frame, {backend, 1});
  EXPECT_EQ(status.error, mistake.error);
  EXPECT_NE(status.message.find(mistake.word), std::string::npos) << status.message;
  EXPECT_EQ(input.picture.differingPixels(before), 0u);
}

std::string nameOf(const ::testing::TestParamInfo<std::tuple<Mistake, Backend>>& test)
{
  const auto& [mistake, backend] = test.param;
  return std::string(mistake.name) + (backend == Backend::kPipeline ? "Pipeline" : "Reference");
}
INSTANTIATE_TEST_SUITE_P(Frame, Mistakes,
                         ::testing::Combine(::testing::ValuesIn(kFrameMistakes), bothBackends()),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Scene, Mistakes,
                         ::testing::Combine(::testing::ValuesIn(kSceneMistakes), bothBackends()),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Lines, Mistakes,
                         ::testing::Combine(::testing::ValuesIn(kLineMistakes), bothBackends()),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Instance, Mistakes,
                         ::testing::Combine(::testing::ValuesIn(kInstanceMistakes), bothBackends()),
                         nameOf);

class CheckScene : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(CheckScene);

TEST_P(CheckScene, TheUnspoiltInputIsDrawn)
{
  Input input;
  const Status status = render(input.scene, input.frame, {GetParam(), 1});
  EXPECT_TRUE(status.ok());
  EXPECT_TRUE(status.message.empty());
  EXPECT_TRUE(covered(input.picture, 8, 8));
}

TEST_P(CheckScene, NamesTheLightAndTheInstanceThatIsWrong)
{
  Input input;
  input.lights.resize(3);
  input.lights[2].color.x = kNan;
  input.scene.lights = input.lights;
  EXPECT_NE(render(input.scene, input.frame, {GetParam(), 1}).message.find("Light 2"),
            std::string::npos);
  input.lights[2].color.x = 1;
  input.instances.push_back(input.instances[0]);
  input.instances[1].material.diffuse = kNan;
  input.scene.instances = input.instances;
  EXPECT_NE(render(input.scene, input.frame, {GetParam(), 1}).message.find("Instance 1"),
            std::string::npos);
}

TEST(CheckSceneOfPipeline, ClustersAreNeeded)
{
  Input input;
  input.instance().clusters = nullptr;
  const Status status = render(input.scene, input.frame, {Backend::kPipeline, 1});
  EXPECT_EQ(status.error, Error::kMissingData);
  EXPECT_NE(status.message.find("buildClusters"), std::string::npos);
}

TEST(CheckSceneOfReference, TheMeshIsNeeded)
{
  Input input;
  input.instance().mesh = {};
  const Status status = render(input.scene, input.frame, {Backend::kReference, 1});
  EXPECT_EQ(status.error, Error::kMissingData);
  EXPECT_NE(status.message.find("triangles"), std::string::npos);
}

TEST_P(CheckScene, BrokenTrianglesAreLeftOutAndTheRestIsDrawn)
{
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage;
  stage.instances = {painted(mesh, {1, 1, 1})};
  const Picture whole = draw(stage);
  mesh.positions.push_back({kNan, 0, 1});
  mesh.positions.push_back({0, kInfinity, 1});
  mesh.vertexNormals.resize(6);
  mesh.triangles.push_back({{0, 1, 4}});
  mesh.triangles.push_back({{0, 1, 5}});
  mesh.triangles.push_back({{0, 1, 6}});
  mesh.triangles.push_back({{0, 1, 0xFFFFFFFFu}});
  mesh.cells.resize(6, 0);
  finish(mesh);
  stage.instances = {painted(mesh, {1, 1, 1})};
  EXPECT_EQ(draw(stage).differingPixels(whole), 0u);
}

}  // namespace
}  // namespace limn::testing
