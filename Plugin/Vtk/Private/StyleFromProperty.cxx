// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StyleFromProperty.h"

#include "CuesFromProperty.h"
#include "LoadedTextures.h"
#include "SurfaceShaderInternals.h"

#include "vtkLimnProperty.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace limn::bridge
{
namespace
{

Vec3f toVec3f(const double* v)
{
  return vec3Cast<float>(Vec3d{ v[0], v[1], v[2] });
}

int frequencyOf(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  return limn ? limn->GetShadingFrequency() : vtkLimnProperty::FREQUENCY_AS_VTK;
}

NormalChoice normalChoiceOf(vtkProperty* property)
{
  NormalChoice choice;
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (!limn)
  {
    return choice;
  }
  choice.featureDegrees = limn->GetFeatureAngle();
  switch (limn->GetVertexNormals())
  {
    case vtkLimnProperty::NORMALS_UNIFORM:
      choice.weight = NormalWeight::kUniform;
      break;
    case vtkLimnProperty::NORMALS_BY_ANGLE:
      choice.weight = NormalWeight::kAngle;
      break;
    default:
      choice.weight = NormalWeight::kArea;
  }
  choice.fromData =
    limn->GetVertexNormals() == vtkLimnProperty::NORMALS_FROM_DATA && choice.featureDegrees >= 180;
  return choice;
}

/// VTK lights every pixel; its interpolation chooses the normals. Normals of points win over those
/// of cells, and normals that the user wants computed over both.
NormalSource normalsAsVtk(vtkProperty* property, const SurfaceMesh& mesh)
{
  if (property->GetInterpolation() != VTK_FLAT &&
      (mesh.hasPointNormals() || !normalChoiceOf(property).fromData))
  {
    return NormalSource::kVertex;
  }
  return mesh.hasCellNormals() ? NormalSource::kCell : NormalSource::kTriangle;
}

ShadingFrequency toFrequency(int frequency)
{
  switch (frequency)
  {
    case vtkLimnProperty::FREQUENCY_FLAT:
      return ShadingFrequency::kFlat;
    case vtkLimnProperty::FREQUENCY_GOURAUD:
      return ShadingFrequency::kGouraud;
    default:
      return ShadingFrequency::kPhong;
  }
}

/// Of the local models; 0 for all others.
int localModelOf(vtkLimnProperty* property)
{
  const int model = property->GetReflectionModel();
  return model >= vtkLimnProperty::REFLECTION_LOCAL_1
           ? model - vtkLimnProperty::REFLECTION_LOCAL_1 + 1
           : 0;
}

Reflection toReflection(int model)
{
  switch (model)
  {
    case vtkLimnProperty::REFLECTION_NONE:
      return Reflection::kNone;
    case vtkLimnProperty::REFLECTION_LAMBERT:
    case vtkLimnProperty::REFLECTION_LOCAL_1:
    case vtkLimnProperty::REFLECTION_LOCAL_2:
    case vtkLimnProperty::REFLECTION_LOCAL_3:
      return Reflection::kLambert;
    case vtkLimnProperty::REFLECTION_BLINN_PHONG:
      return Reflection::kBlinnPhong;
    case vtkLimnProperty::REFLECTION_PHONG:
    case vtkLimnProperty::REFLECTION_LOCAL_4:
    case vtkLimnProperty::REFLECTION_LOCAL_5:
      return Reflection::kPhong;
    case vtkLimnProperty::REFLECTION_IRRADIANCE:
      return Reflection::kIrradiance;
    case vtkLimnProperty::REFLECTION_OREN_NAYAR:
      return Reflection::kOrenNayar;
    case vtkLimnProperty::REFLECTION_METALLIC_ROUGHNESS:
      return Reflection::kMetallicRoughness;
    default:
      return Reflection::kAsVtk;
  }
}

Tone toTone(int tone)
{
  switch (tone)
  {
    case vtkLimnProperty::TONE_GOOCH:
      return Tone::kGooch;
    case vtkLimnProperty::TONE_GOOCH_CHAPTER:
      return Tone::kGoochChapter;
    case vtkLimnProperty::TONE_METAL:
      return Tone::kMetal;
    case vtkLimnProperty::TONE_RAMP:
      return Tone::kRamp;
    case vtkLimnProperty::TONE_MAT_CAP:
      return Tone::kMatCap;
    case vtkLimnProperty::TONE_HATCHING:
      return Tone::kHatching;
    case vtkLimnProperty::TONE_EXAGGERATED:
      return Tone::kExaggerated;
    default:
      return Tone::kNone;
  }
}

ToneOverData toToneOverData(int tone)
{
  switch (tone)
  {
    case vtkLimnProperty::DATA_TONE_UNDERTONE:
      return ToneOverData::kUndertone;
    case vtkLimnProperty::DATA_TONE_LEGEND_SAFE:
      return ToneOverData::kLegendSafe;
    default:
      return ToneOverData::kClassic;
  }
}

ToneHighlight toHighlight(int highlight)
{
  switch (highlight)
  {
    case vtkLimnProperty::TONE_HIGHLIGHT_REFLECTED:
      return ToneHighlight::kReflected;
    case vtkLimnProperty::TONE_HIGHLIGHT_WHITE:
      return ToneHighlight::kWhite;
    case vtkLimnProperty::TONE_HIGHLIGHT_NONE:
      return ToneHighlight::kNone;
    default:
      return ToneHighlight::kAdded;
  }
}

RampDetail toDetail(int by)
{
  switch (by)
  {
    case vtkLimnProperty::TOON_RAMP_BY_SILHOUETTE:
      return RampDetail::kSilhouette;
    case vtkLimnProperty::TOON_RAMP_BY_HIGHLIGHT:
      return RampDetail::kHighlight;
    default:
      return RampDetail::kDepth;
  }
}

/// The picture of the tone that has one.
vtkTexture* rampTextureOf(vtkLimnProperty* property)
{
  switch (property->GetTone())
  {
    case vtkLimnProperty::TONE_RAMP:
      return property->GetToonRamp();
    case vtkLimnProperty::TONE_MAT_CAP:
      return property->GetMatCap();
    default:
      return nullptr;
  }
}

ToneRamp rampOf(vtkLimnProperty* property)
{
  ToneRamp ramp;
  ramp.detail = toDetail(property->GetToonRampBy());
  ramp.exponent = static_cast<float>(property->GetToonRampExponent());
  ramp.nearest = static_cast<float>(property->GetToonRampRange()[0]);
  ramp.farthest = static_cast<float>(property->GetToonRampRange()[1]);
  if (vtkTexture* const texture = rampTextureOf(property))
  {
    const LoadedTexture& loaded = loadedTextureOf(texture);
    ramp.image = loaded.image.empty() ? nullptr : &loaded.image;
  }
  return ramp;
}

/// Its spacing is in pixels where the property's unit is.
Hatching hatchingOf(vtkLimnProperty* property)
{
  Hatching hatching;
  hatching.paper = toVec3f(property->GetHatchPaper());
  hatching.ink = toVec3f(property->GetHatchInk());
  hatching.spacing = static_cast<float>(hatchSpacingOf(property, 72));
  hatching.darkest = static_cast<float>(property->GetHatchDarkest());
  hatching.place = property->GetHatchPlace() == vtkLimnProperty::HATCH_ON_TEXTURE
                     ? HatchPlace::kTexture
                     : HatchPlace::kModel;
  return hatching;
}

Exaggeration exaggerationOf(vtkLimnProperty* property)
{
  return { static_cast<float>(property->GetExaggerationContrast()),
    static_cast<float>(property->GetExaggerationExponent()),
    static_cast<float>(property->GetExaggerationBase()) };
}

void setTone(vtkLimnProperty* property, Style& style)
{
  style.tone = toTone(property->GetTone());
  style.toneCool = toVec3f(property->GetCoolColor());
  style.toneWarm = toVec3f(property->GetWarmColor());
  style.coolSurface = static_cast<float>(property->GetCoolSurface());
  style.warmSurface = static_cast<float>(property->GetWarmSurface());
  style.toneLight = property->GetToneLight() == vtkLimnProperty::TONE_LIGHT_UPPER_RIGHT
                      ? ToneLight::kUpperRight
                      : ToneLight::kFirst;
  style.toneHighlight = toHighlight(property->GetToneHighlight());
  style.toneOverData = toToneOverData(property->GetToneOverData());
  style.undertone = static_cast<float>(property->GetUndertone());
  style.legendSafeRange = static_cast<float>(property->GetLegendSafeRange());
  style.ramp = rampOf(property);
  style.hatching = hatchingOf(property);
  style.exaggeration = exaggerationOf(property);
  if (style.tone == Tone::kRamp || style.tone == Tone::kMatCap)
  {
    // That it could not be loaded has been said.
    style.tone = style.ramp.image ? style.tone : Tone::kNone;
    return;
  }
  constexpr int kToonBands = 3;
  const bool isToon = property->GetTone() == vtkLimnProperty::TONE_TOON;
  if (isToon || style.tone != Tone::kNone)
  {
    style.toonBands = property->GetToonBands();
    style.toonBands = isToon && style.toonBands < 2 ? kToonBands : style.toonBands;
  }
}

float outlineWidthOf(vtkLimnProperty* property)
{
  constexpr float kHullWidth = 1.5f;
  constexpr float kImageWidth = 2;
  const auto width = static_cast<float>(property->GetOutlineWidth());
  switch (width == 0 ? property->GetOutline() : vtkLimnProperty::OUTLINE_NONE)
  {
    case vtkLimnProperty::OUTLINE_HULL:
      return kHullWidth;
    case vtkLimnProperty::OUTLINE_IMAGE:
      return kImageWidth;
    default:
      return width;
  }
}

CreaseDetector creaseDetectorOf(vtkLimnProperty* property)
{
  switch (property->GetOutlineCreaseDetector())
  {
    case vtkLimnProperty::CREASES_BY_SOBEL:
      return CreaseDetector::kSobel;
    case vtkLimnProperty::CREASES_BY_LAPLACIAN:
      return CreaseDetector::kLaplacian;
    default:
      return CreaseDetector::kAngle;
  }
}

void setImageOutline(vtkLimnProperty* property, Style& style)
{
  ImageOutline& outline = style.imageOutline;
  switch (property->GetOutlineDetector())
  {
    case vtkLimnProperty::OUTLINE_BY_SOBEL:
      outline.detector = OutlineDetector::kSobel;
      break;
    case vtkLimnProperty::OUTLINE_BY_LAPLACIAN:
      outline.detector = OutlineDetector::kLaplacian;
      break;
    default:
      outline.detector = OutlineDetector::kPlane;
  }
  outline.depthTolerance = static_cast<float>(property->GetOutlineDepthTolerance());
  outline.creaseDegrees = static_cast<float>(property->GetOutlineCreaseAngle());
  outline.creases = creaseDetectorOf(property);
  outline.ids = property->GetOutlineIds();
}

void setIllustration(vtkLimnProperty* property, Style& style)
{
  style.reflection = toReflection(property->GetReflectionModel());
  const int local = localModelOf(property);
  style.fresnel = property->GetFresnel() && local == 0;
  style.fallOff = property->GetFallOff() && (local == 0 || local >= 3);
  setTone(property, style);
  style.outlineWidth = outlineWidthOf(property);
  style.outlineColor = toVec3f(property->GetOutlineColor());
  style.outlineOpacity = static_cast<float>(property->GetOutlineOpacity());
  if (property->GetOutline() == vtkLimnProperty::OUTLINE_NORMAL)
  {
    style.evenOutline = style.outlineWidth > 0;
    style.outlineThreshold =
      style.evenOutline ? 0.0f : static_cast<float>(property->GetOutlineThreshold());
  }
  if (property->GetOutline() == vtkLimnProperty::OUTLINE_IMAGE && checkOutlineWidth(property).ok())
  {
    setImageOutline(property, style);
  }
  if (const vtkLimnSurfaceShader* const shader = property->GetSurfaceShader())
  {
    style.surfaceShader = &shader->GetInternals();
  }
}

/// By ITU-R BT.709.
Vec3f greyOf(Vec3f color)
{
  const auto luminance = static_cast<float>(0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z);
  return { luminance, luminance, luminance };
}

void setLocalModel(int version, Material& material)
{
  material.specularColor = greyOf(material.specularColor);
  if (version < 5)
  {
    material.ambientColor = greyOf(material.ambientColor);
    material.diffuseColor = greyOf(material.diffuseColor);
  }
  if (version == 1)
  {
    material.diffuse = 0;
  }
}

void setReflection(vtkLimnProperty* property, Material& material)
{
  if (const int local = localModelOf(property))
  {
    setLocalModel(local, material);
    return;
  }
  material.rim = toVec3f(property->GetRimColor());
  material.rimPower = static_cast<float>(property->GetRimPower());
  const Reflection reflection = toReflection(property->GetReflectionModel());
  if (reflection != Reflection::kMetallicRoughness && reflection != Reflection::kAsVtk)
  {
    material.refractiveIndex = toVec3f(property->GetRefractiveIndex());
  }
}

} // namespace

Material materialOf(vtkProperty* property)
{
  Material material;
  material.ambientColor = toVec3f(property->GetAmbientColor());
  material.diffuseColor = toVec3f(property->GetDiffuseColor());
  material.specularColor = toVec3f(property->GetSpecularColor());
  material.ambient = static_cast<float>(property->GetAmbient());
  material.diffuse = static_cast<float>(property->GetDiffuse());
  material.specular = static_cast<float>(property->GetSpecular());
  material.specularPower = static_cast<float>(property->GetSpecularPower());
  material.roughness = static_cast<float>(property->GetRoughness());
  material.metallic = static_cast<float>(property->GetMetallic());
  material.edgeTint = toVec3f(property->GetEdgeTint());
  const double index = property->GetBaseIOR();
  material.refractiveIndex = toVec3f(std::array<double, 3>{ index, index, index }.data());
  if (vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property))
  {
    setReflection(limn, material);
  }
  return material;
}

double pixelsPerUnit(int unit, double pixelsPerInch)
{
  switch (unit)
  {
    case vtkLimnProperty::STROKE_POINTS:
      return pixelsPerInch / 72;
    case vtkLimnProperty::STROKE_MILLIMETERS:
      return pixelsPerInch / 25.4;
    default:
      return 1;
  }
}

double hatchSpacingOf(vtkLimnProperty* property, double pixelsPerInch)
{
  const double pixels =
    property->GetHatchSpacing() * pixelsPerUnit(property->GetHatchUnit(), pixelsPerInch);
  return std::min(std::max(pixels, 1.0), static_cast<double>(kMaxHatchSpacing));
}

Style styleOf(vtkProperty* property, const SurfaceMesh& mesh)
{
  Style style;
  const int frequency = frequencyOf(property);
  style.frequency = toFrequency(frequency);
  style.normals = frequency == vtkLimnProperty::FREQUENCY_AS_VTK ? normalsAsVtk(property, mesh)
                                                                 : NormalSource::kVertex;
  if (vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property))
  {
    setIllustration(limn, style);
  }
  if (style.reflection == Reflection::kAsVtk && property->GetInterpolation() == VTK_PBR)
  {
    style.reflection = Reflection::kMetallicRoughnessAsVtk;
  }
  if (!property->GetLighting())
  {
    style.reflection = Reflection::kNone;
  }
  return style;
}

Status checkOutlineWidth(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (!limn || limn->GetOutline() != vtkLimnProperty::OUTLINE_IMAGE ||
      outlineWidthOf(limn) <= kMaxImageOutlineWidth)
  {
    return {};
  }
  std::ostringstream text;
  text << "OutlineWidth of its vtkLimnProperty is " << limn->GetOutlineWidth()
       << " pixels; it has to be from 0 to " << kMaxImageOutlineWidth << ".";
  return { Error::kNotFinite, text.str() };
}

bool hasHull(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  return limn && limn->GetOutline() == vtkLimnProperty::OUTLINE_HULL &&
         limn->GetOutlineOpacity() > 0;
}

Style hullStyleOf(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  Style style;
  style.outlineColor = toVec3f(limn->GetOutlineColor());
  style.outlineWidth = outlineWidthOf(limn);
  style.outlineOpacity = static_cast<float>(limn->GetOutlineOpacity());
  return style;
}

bool readsPointNormals(vtkProperty* property)
{
  const int frequency = frequencyOf(property);
  const bool isFlat = frequency == vtkLimnProperty::FREQUENCY_AS_VTK
                        ? property->GetInterpolation() == VTK_FLAT
                        : frequency == vtkLimnProperty::FREQUENCY_FLAT;
  return !isFlat && normalChoiceOf(property).fromData;
}

SurfaceNeeds needsOf(vtkProperty* property)
{
  const int frequency = frequencyOf(property);
  SurfaceNeeds needs;
  needs.hull = hasHull(property);
  needs.normals = normalChoiceOf(property);
  needs.vertexNormals = frequency == vtkLimnProperty::FREQUENCY_GOURAUD ||
                        frequency == vtkLimnProperty::FREQUENCY_PHONG;
  if (frequency == vtkLimnProperty::FREQUENCY_AS_VTK)
  {
    needs.vertexNormals = property->GetInterpolation() != VTK_FLAT && !needs.normals.fromData;
  }
  if (frequency == vtkLimnProperty::FREQUENCY_FLAT)
  {
    needs.faceGeometry = true;
    needs.firstCorners = vtkLimnProperty::SafeDownCast(property)->GetFlatPoint() ==
                         vtkLimnProperty::FLAT_AT_FIRST_VERTEX;
  }
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (limn && limn->GetTone() == vtkLimnProperty::TONE_EXAGGERATED && !limn->GetSurfaceShader())
  {
    needs.smoothNormals = true;
    const double feature = limn->GetFeatureAngle();
    needs.smoothScales = { limn->GetExaggerationLevels(),
      static_cast<float>(limn->GetExaggerationScale()),
      feature < 180 ? feature : limn->GetCreaseAngle() };
  }
  return needs;
}

} // namespace limn::bridge
