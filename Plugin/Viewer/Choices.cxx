// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Choices.h"

namespace limn::viewer
{

const Choices<Shading>& shadings()
{
  static const Choices<Shading> choices = { { "flat", Shading::Flat },
    { "gouraud", Shading::Gouraud }, { "phong", Shading::Phong } };
  return choices;
}

const Choices<FlatPoint>& flatPoints()
{
  static const Choices<FlatPoint> choices = { { "centroid", FlatPoint::Centroid },
    { "first-vertex", FlatPoint::FirstVertex } };
  return choices;
}

const Choices<Normals>& normalSources()
{
  static const Choices<Normals> choices = { { "data", Normals::Data },
    { "uniform", Normals::Uniform }, { "area", Normals::Area }, { "angle", Normals::Angle } };
  return choices;
}

const Choices<Reflection>& reflections()
{
  static const Choices<Reflection> choices = { { "none", Reflection::None },
    { "lambert", Reflection::Lambert }, { "phong", Reflection::Phong },
    { "blinn-phong", Reflection::BlinnPhong }, { "irradiance", Reflection::Irradiance },
    { "oren-nayar", Reflection::OrenNayar }, { "metallic", Reflection::Metallic } };
  return choices;
}

const Choices<Tone>& tones()
{
  static const Choices<Tone> choices = { { "none", Tone::None }, { "gooch", Tone::Gooch },
    { "gooch-chapter", Tone::GoochChapter }, { "gooch-rtr4", Tone::GoochRtr4 },
    { "gooch-orange-book", Tone::GoochOrangeBook }, { "metal", Tone::Metal },
    { "toon", Tone::Toon }, { "hatching", Tone::Hatching }, { "exaggerated", Tone::Exaggerated } };
  return choices;
}

const Choices<ToneLight>& toneLights()
{
  static const Choices<ToneLight> choices = { { "scene", ToneLight::Scene },
    { "upper-right", ToneLight::UpperRight } };
  return choices;
}

const Choices<HatchPlace>& hatchPlaces()
{
  static const Choices<HatchPlace> choices = { { "model", HatchPlace::Model },
    { "texture", HatchPlace::Texture } };
  return choices;
}

const Choices<RampBy>& rampDetails()
{
  static const Choices<RampBy> choices = { { "depth", RampBy::Depth },
    { "silhouette", RampBy::Silhouette }, { "highlight", RampBy::Highlight } };
  return choices;
}

const Choices<ToneOverData>& tonesOverData()
{
  static const Choices<ToneOverData> choices = { { "classic", ToneOverData::Classic },
    { "undertone", ToneOverData::Undertone }, { "legend-safe", ToneOverData::LegendSafe } };
  return choices;
}

const Choices<Outline>& outlines()
{
  static const Choices<Outline> choices = { { "none", Outline::None },
    { "normal", Outline::Normal }, { "hull", Outline::Hull }, { "image", Outline::Image } };
  return choices;
}

const Choices<std::string>& styles()
{
  static const Choices<std::string> choices = { { "plain", "plain" }, { "technical", "technical" },
    { "gooch", "gooch" }, { "toon", "toon" }, { "blueprint", "blueprint" }, { "pencil", "pencil" },
    { "ink", "ink" }, { "anatomy", "anatomy" }, { "metal", "metal" }, { "xray", "xray" },
    { "print", "print" } };
  return choices;
}

const Choices<LineKind>& lineKinds()
{
  static const Choices<LineKind> choices = { { "crease", LineKind::Crease },
    { "border", LineKind::Border }, { "non-manifold", LineKind::NonManifold },
    { "ids", LineKind::Ids }, { "normals", LineKind::Normals }, { "contour", LineKind::Contour },
    { "silhouette", LineKind::Silhouette }, { "ridge", LineKind::Ridge },
    { "valley", LineKind::Valley }, { "suggestive", LineKind::Suggestive },
    { "hatch", LineKind::Hatch }, { "terminator", LineKind::Terminator },
    { "shadow", LineKind::Shadow }, { "intersections", LineKind::Intersections } };
  return choices;
}

const Choices<LineLights>& lineLights()
{
  static const Choices<LineLights> choices = { { "first", LineLights::First },
    { "all", LineLights::All } };
  return choices;
}

const Choices<HiddenLines>& hiddenLines()
{
  static const Choices<HiddenLines> choices = { { "off", HiddenLines::Off },
    { "dashed", HiddenLines::Dashed }, { "thin", HiddenLines::Thin } };
  return choices;
}

const Choices<Detector>& detectors()
{
  static const Choices<Detector> choices = { { "plane", Detector::Plane },
    { "sobel", Detector::Sobel }, { "laplacian", Detector::Laplacian } };
  return choices;
}

const Choices<CreaseDetector>& creaseDetectors()
{
  static const Choices<CreaseDetector> choices = { { "angle", CreaseDetector::Angle },
    { "sobel", CreaseDetector::Sobel }, { "laplacian", CreaseDetector::Laplacian } };
  return choices;
}

const Choices<TextureFilter>& textureFilters()
{
  static const Choices<TextureFilter> choices = { { "nearest", TextureFilter::Nearest },
    { "bilinear", TextureFilter::Bilinear }, { "trilinear", TextureFilter::Trilinear } };
  return choices;
}

const Choices<TextureWrap>& textureWraps()
{
  static const Choices<TextureWrap> choices = { { "repeat", TextureWrap::Repeat },
    { "mirror", TextureWrap::Mirror }, { "clamp", TextureWrap::Clamp },
    { "border", TextureWrap::Border } };
  return choices;
}

const Choices<TextureRole>& textureRoles()
{
  static const Choices<TextureRole> choices = { { "surface", TextureRole::Surface },
    { "shaded", TextureRole::Shaded } };
  return choices;
}

const Choices<TextureMode>& textureModes()
{
  static const Choices<TextureMode> choices = { { "modulate", TextureMode::Modulate },
    { "replace", TextureMode::Replace }, { "decal", TextureMode::Decal },
    { "add", TextureMode::Add } };
  return choices;
}

const Choices<Procedural>& procedurals()
{
  static const Choices<Procedural> choices = { { "none", Procedural::None },
    { "checker", Procedural::Checker }, { "wood", Procedural::Wood },
    { "marble", Procedural::Marble } };
  return choices;
}

const Choices<int>& sampleCounts()
{
  static const Choices<int> choices = { { "1", 1 }, { "2", 2 }, { "4", 4 }, { "8", 8 },
    { "16", 16 } };
  return choices;
}

} // namespace limn::viewer
