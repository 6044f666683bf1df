// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnProperty.h"

#include "Private/StyleMemory.h"
#include "vtkLimnSurfaceShader.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <map>
#include <string>

namespace
{
/// Of StrokeUnits.
const char* const UnitNames[] = { "Pixels", "Points", "Millimeters" };

void PrintVector(ostream& os, const char* name, const double vector[3])
{
  os << name << ": (" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")\n";
}

/// As its colours stand; nullptr for no image.
vtkSmartPointer<vtkTexture> TextureOf(vtkImageData* image)
{
  if (!image)
  {
    return nullptr;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  return texture;
}
}

vtkStandardNewMacro(vtkLimnProperty);
vtkCxxSetObjectMacro(vtkLimnProperty, LightmapTexture, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, BumpTexture, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, ToonRamp, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, MatCap, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, SurfaceShader, vtkLimnSurfaceShader);

//------------------------------------------------------------------------------
vtkLimnProperty::~vtkLimnProperty()
{
  this->SetIdArrayName(nullptr);
  this->SetLightmapTexture(nullptr);
  this->SetLightmapTCoords(nullptr);
  this->SetBumpTexture(nullptr);
  this->SetToonRamp(nullptr);
  this->SetMatCap(nullptr);
  this->SetSurfaceShader(nullptr);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetToonRampImage(vtkImageData* image)
{
  this->SetToonRamp(TextureOf(image).Get());
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetMatCapImage(vtkImageData* image)
{
  this->SetMatCap(TextureOf(image).Get());
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetGoochTo1998()
{
  this->SetToneToGooch();
  this->SetCoolColor(0.0, 0.0, 0.4);
  this->SetWarmColor(0.4, 0.4, 0.0);
  this->SetCoolSurface(0.2);
  this->SetWarmSurface(0.6);
  this->SetToneHighlightToAdded();
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetGoochToRTR4()
{
  this->SetToneToGooch();
  this->SetCoolColor(0.0, 0.0, 0.55);
  this->SetWarmColor(0.3, 0.3, 0.0);
  this->SetCoolSurface(0.25);
  this->SetWarmSurface(0.25);
  this->SetToneHighlightToWhite();
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetGoochToOrangeBook()
{
  this->SetToneToGooch();
  this->SetCoolColor(0.0, 0.0, 0.6);
  this->SetWarmColor(0.6, 0.6, 0.0);
  this->SetCoolSurface(0.45);
  this->SetWarmSurface(0.45);
  this->SetToneHighlightToReflected();
  this->SetDiffuseColor(0.75, 0.75, 0.75);
  this->SetDiffuse(1.0);
  this->SetSpecularColor(1.0, 1.0, 1.0);
  this->SetSpecular(1.0);
  this->SetSpecularPower(32.0);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLimnProperty::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->SurfaceShader ? std::max(time, this->SurfaceShader->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkLimnProperty::SetMetalToSteel()
{
  this->SetToneToMetal();
  this->SetCoolColor(1.0, 1.15, 1.4);
  this->SetWarmColor(2.0, 1.95, 1.8);
  this->SetCoolSurface(0.0);
  this->SetWarmSurface(0.0);
  this->SetToneHighlightToNone();
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetShadingFrequencyAsString()
{
  static const char* const names[] = { "AsVTK", "Flat", "Gouraud", "Phong" };
  return names[this->ShadingFrequency];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetReflectionModelAsString()
{
  static const char* const names[] = { "AsVTK", "None", "Lambert", "BlinnPhong", "Phong",
    "Irradiance", "OrenNayar", "MetallicRoughness", "Local1", "Local2", "Local3", "Local4",
    "Local5" };
  return names[this->ReflectionModel];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetFlatPointAsString()
{
  return this->FlatPoint == FLAT_AT_FIRST_VERTEX ? "FirstVertex" : "Centroid";
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetVertexNormalsAsString()
{
  static const char* const names[] = { "FromData", "Uniform", "ByArea", "ByAngle" };
  return names[this->VertexNormals];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneAsString()
{
  static const char* const names[] = { "None", "Gooch", "GoochChapter", "Toon", "Metal", "Ramp",
    "MatCap", "Hatching", "Exaggerated" };
  return names[this->Tone];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetHatchPlaceAsString()
{
  static const char* const names[] = { "Model", "Texture" };
  return names[this->HatchPlace];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneOverDataAsString()
{
  static const char* const names[] = { "Classic", "Undertone", "LegendSafe" };
  return names[this->ToneOverData];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneLightAsString()
{
  return this->ToneLight == TONE_LIGHT_UPPER_RIGHT ? "UpperRight" : "Scene";
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneHighlightAsString()
{
  static const char* const names[] = { "Added", "Reflected", "White", "None" };
  return names[this->ToneHighlight];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToonRampByAsString()
{
  static const char* const names[] = { "Depth", "Silhouette", "Highlight" };
  return names[this->ToonRampBy];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetOutlineAsString()
{
  static const char* const names[] = { "None", "Normal", "Hull", "Image" };
  return names[this->Outline];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetStrokeUnitAsString()
{
  return UnitNames[this->StrokeUnit];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetHatchUnitAsString()
{
  return UnitNames[this->HatchUnit];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetHaloUnitAsString()
{
  return UnitNames[this->HaloUnit];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetDepthUnsharpAsString()
{
  static const char* const names[] = { "Off", "Darken", "Both" };
  return names[this->DepthUnsharp];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetHiddenLinesAsString()
{
  static const char* const names[] = { "Off", "Dashed", "Thin" };
  return names[this->HiddenLines];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetLineLightsAsString()
{
  return this->LineLights == LINE_LIGHTS_ALL ? "All" : "First";
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetOutlineDetectorAsString()
{
  static const char* const names[] = { "Plane", "Sobel", "Laplacian" };
  return names[this->OutlineDetector];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetOutlineCreaseDetectorAsString()
{
  static const char* const names[] = { "Angle", "Sobel", "Laplacian" };
  return names[this->OutlineCreaseDetector];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetTextureRoleAsString()
{
  static const char* const names[] = { "Shaded", "Surface" };
  return names[this->TextureRole];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetTextureModeAsString()
{
  static const char* const names[] = { "Modulate", "Replace", "Decal", "Add" };
  return names[this->TextureMode];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetProceduralTextureAsString()
{
  static const char* const names[] = { "None", "Checker", "Wood", "Marble" };
  return names[this->ProceduralTexture];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetProceduralSpaceAsString()
{
  static const char* const names[] = { "Object", "Uv" };
  return names[this->ProceduralSpace];
}

//------------------------------------------------------------------------------
void vtkLimnProperty::CopyWithTextures(vtkProperty* property)
{
  // VTK 9.1 copies pointers to textures without counting them.
  std::map<std::string, vtkTexture*> textures;
  property->GetAllTextures().swap(textures);
  this->Superclass::DeepCopy(property);
  property->GetAllTextures().swap(textures);
  for (const auto& texture : property->GetAllTextures())
  {
    this->SetTexture(texture.first.c_str(), texture.second);
  }
}

//------------------------------------------------------------------------------
void vtkLimnProperty::CopyTone(vtkLimnProperty* other)
{
  this->SetTone(other->Tone);
  this->SetCoolColor(other->CoolColor);
  this->SetWarmColor(other->WarmColor);
  this->SetCoolSurface(other->CoolSurface);
  this->SetWarmSurface(other->WarmSurface);
  this->SetToneOverData(other->ToneOverData);
  this->SetUndertone(other->Undertone);
  this->SetLegendSafeRange(other->LegendSafeRange);
  this->SetToonBands(other->ToonBands);
  this->SetToneLight(other->ToneLight);
  this->SetToneHighlight(other->ToneHighlight);
  this->SetToonRamp(other->ToonRamp);
  this->SetToonRampBy(other->ToonRampBy);
  this->SetToonRampExponent(other->ToonRampExponent);
  this->SetToonRampRange(other->ToonRampRange);
  this->SetMatCap(other->MatCap);
  this->SetHatchDarkest(other->HatchDarkest);
  this->SetHatchSpacing(other->HatchSpacing);
  this->SetHatchUnit(other->HatchUnit);
  this->SetHatchPaper(other->HatchPaper);
  this->SetHatchInk(other->HatchInk);
  this->SetHatchPlace(other->HatchPlace);
  this->SetExaggerationContrast(other->ExaggerationContrast);
  this->SetExaggerationExponent(other->ExaggerationExponent);
  this->SetExaggerationBase(other->ExaggerationBase);
  this->SetExaggerationLevels(other->ExaggerationLevels);
  this->SetExaggerationScale(other->ExaggerationScale);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::CopyCues(vtkLimnProperty* other)
{
  this->SetEyeDomeLighting(other->EyeDomeLighting);
  this->SetEyeDomeStrength(other->EyeDomeStrength);
  this->SetEyeDomeRadius(other->EyeDomeRadius);
  this->SetDepthUnsharp(other->DepthUnsharp);
  this->SetDepthUnsharpStrength(other->DepthUnsharpStrength);
  this->SetDepthUnsharpRadius(other->DepthUnsharpRadius);
  this->SetHaloWidth(other->HaloWidth);
  this->SetHaloUnit(other->HaloUnit);
  this->SetHaloDepth(other->HaloDepth);
  this->SetHaloColor(other->HaloColor);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::DeepCopy(vtkProperty* property)
{
  if (property)
  {
    this->CopyWithTextures(property);
  }
  vtkLimnProperty* other = vtkLimnProperty::SafeDownCast(property);
  if (!other)
  {
    return;
  }
  // With what its style has replaced, so that the next one finds it; without, that of a style that
  // this one had.
  this->GetInformation()->CopyEntry(other->GetInformation(), limn::bridge::opacityBeforeStyles());
  this->SetShadingFrequency(other->ShadingFrequency);
  this->SetFlatPoint(other->FlatPoint);
  this->SetVertexNormals(other->VertexNormals);
  this->SetFeatureAngle(other->FeatureAngle);
  this->SetReflectionModel(other->ReflectionModel);
  this->SetFresnel(other->Fresnel);
  this->SetRefractiveIndex(other->RefractiveIndex);
  this->SetRimColor(other->RimColor);
  this->SetRimPower(other->RimPower);
  this->SetFallOff(other->FallOff);
  this->CopyTone(other);
  this->SetOutline(other->Outline);
  this->SetOutlineThreshold(other->OutlineThreshold);
  this->SetOutlineWidth(other->OutlineWidth);
  this->SetOutlineColor(other->OutlineColor);
  this->SetOutlineOpacity(other->OutlineOpacity);
  this->SetCreaseLines(other->CreaseLines);
  this->SetBorderLines(other->BorderLines);
  this->SetNonManifoldLines(other->NonManifoldLines);
  this->SetIdLines(other->IdLines);
  this->SetNormalLines(other->NormalLines);
  this->SetContourLines(other->ContourLines);
  this->SetSilhouetteLines(other->SilhouetteLines);
  this->SetRidgeLines(other->RidgeLines);
  this->SetValleyLines(other->ValleyLines);
  this->SetSuggestiveLines(other->SuggestiveLines);
  this->SetRidgeThreshold(other->RidgeThreshold);
  this->SetSuggestiveThreshold(other->SuggestiveThreshold);
  this->SetTerminatorLines(other->TerminatorLines);
  this->SetShadowLines(other->ShadowLines);
  this->SetIntersectionLines(other->IntersectionLines);
  this->SetLineLights(other->LineLights);
  this->SetHatchLines(other->HatchLines);
  this->SetHatchWidth(other->HatchWidth);
  this->SetIdArrayName(other->IdArrayName);
  this->SetCreaseAngle(other->CreaseAngle);
  this->SetShortestCrease(other->ShortestCrease);
  this->SetStrokeWidth(other->StrokeWidth);
  this->SetStrokeUnit(other->StrokeUnit);
  this->SetOuterWidthFactor(other->OuterWidthFactor);
  this->SetStrokeColor(other->StrokeColor);
  this->SetStrokeOpacity(other->StrokeOpacity);
  this->SetStrokeTaper(other->StrokeTaper);
  this->SetStrokeDash(other->StrokeDash);
  this->SetStrokeGap(other->StrokeGap);
  this->SetHiddenLines(other->HiddenLines);
  this->SetOutlineDetector(other->OutlineDetector);
  this->SetOutlineDepthTolerance(other->OutlineDepthTolerance);
  this->SetOutlineCreaseAngle(other->OutlineCreaseAngle);
  this->SetOutlineCreaseDetector(other->OutlineCreaseDetector);
  this->SetOutlineIds(other->OutlineIds);
  this->CopyCues(other);
  this->SetTextureRole(other->TextureRole);
  this->SetTextureMode(other->TextureMode);
  this->SetProceduralTexture(other->ProceduralTexture);
  this->SetProceduralSpace(other->ProceduralSpace);
  this->SetProceduralColorA(other->ProceduralColorA);
  this->SetProceduralColorB(other->ProceduralColorB);
  this->SetProceduralScale(other->ProceduralScale);
  this->SetProceduralTurbulence(other->ProceduralTurbulence);
  this->SetLightmapTexture(other->LightmapTexture);
  this->SetLightmapIntensity(other->LightmapIntensity);
  this->SetLightmapTCoords(other->LightmapTCoords);
  this->SetBumpTexture(other->BumpTexture);
  this->SetBumpScale(other->BumpScale);
  this->SetSurfaceShader(other->SurfaceShader);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::PrintTone(ostream& os, vtkIndent indent)
{
  os << indent << "Tone: " << this->GetToneAsString() << "\n";
  os << indent;
  PrintVector(os, "CoolColor", this->CoolColor);
  os << indent;
  PrintVector(os, "WarmColor", this->WarmColor);
  os << indent << "CoolSurface: " << this->CoolSurface << "\n";
  os << indent << "WarmSurface: " << this->WarmSurface << "\n";
  os << indent << "ToneOverData: " << this->GetToneOverDataAsString() << "\n";
  os << indent << "Undertone: " << this->Undertone << "\n";
  os << indent << "LegendSafeRange: " << this->LegendSafeRange << "\n";
  os << indent << "ToonBands: " << this->ToonBands << "\n";
  os << indent << "ToneLight: " << this->GetToneLightAsString() << "\n";
  os << indent << "ToneHighlight: " << this->GetToneHighlightAsString() << "\n";
  os << indent << "ToonRamp: " << this->ToonRamp << "\n";
  os << indent << "ToonRampBy: " << this->GetToonRampByAsString() << "\n";
  os << indent << "ToonRampExponent: " << this->ToonRampExponent << "\n";
  os << indent << "ToonRampRange: (" << this->ToonRampRange[0] << ", " << this->ToonRampRange[1]
     << ")\n";
  os << indent << "MatCap: " << this->MatCap << "\n";
  os << indent << "HatchDarkest: " << this->HatchDarkest << "\n";
  os << indent << "HatchSpacing: " << this->HatchSpacing << "\n";
  os << indent << "HatchUnit: " << this->GetHatchUnitAsString() << "\n";
  os << indent;
  PrintVector(os, "HatchPaper", this->HatchPaper);
  os << indent;
  PrintVector(os, "HatchInk", this->HatchInk);
  os << indent << "HatchPlace: " << this->GetHatchPlaceAsString() << "\n";
  os << indent << "ExaggerationContrast: " << this->ExaggerationContrast << "\n";
  os << indent << "ExaggerationExponent: " << this->ExaggerationExponent << "\n";
  os << indent << "ExaggerationBase: " << this->ExaggerationBase << "\n";
  os << indent << "ExaggerationLevels: " << this->ExaggerationLevels << "\n";
  os << indent << "ExaggerationScale: " << this->ExaggerationScale << "\n";
}

//------------------------------------------------------------------------------
void vtkLimnProperty::PrintCues(ostream& os, vtkIndent indent)
{
  os << indent << "EyeDomeLighting: " << (this->EyeDomeLighting ? "On" : "Off") << "\n";
  os << indent << "EyeDomeStrength: " << this->EyeDomeStrength << "\n";
  os << indent << "EyeDomeRadius: " << this->EyeDomeRadius << "\n";
  os << indent << "DepthUnsharp: " << this->GetDepthUnsharpAsString() << "\n";
  os << indent << "DepthUnsharpStrength: " << this->DepthUnsharpStrength << "\n";
  os << indent << "DepthUnsharpRadius: " << this->DepthUnsharpRadius << "\n";
  os << indent << "HaloWidth: " << this->HaloWidth << "\n";
  os << indent << "HaloUnit: " << this->GetHaloUnitAsString() << "\n";
  os << indent << "HaloDepth: " << this->HaloDepth << "\n";
  os << indent;
  PrintVector(os, "HaloColor", this->HaloColor);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadingFrequency: " << this->GetShadingFrequencyAsString() << "\n";
  os << indent << "FlatPoint: " << this->GetFlatPointAsString() << "\n";
  os << indent << "VertexNormals: " << this->GetVertexNormalsAsString() << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ReflectionModel: " << this->GetReflectionModelAsString() << "\n";
  os << indent << "Fresnel: " << (this->Fresnel ? "On" : "Off") << "\n";
  os << indent;
  PrintVector(os, "RefractiveIndex", this->RefractiveIndex);
  os << indent;
  PrintVector(os, "RimColor", this->RimColor);
  os << indent << "RimPower: " << this->RimPower << "\n";
  os << indent << "FallOff: " << (this->FallOff ? "On" : "Off") << "\n";
  this->PrintTone(os, indent);
  os << indent << "Outline: " << this->GetOutlineAsString() << "\n";
  os << indent << "OutlineThreshold: " << this->OutlineThreshold << "\n";
  os << indent << "OutlineWidth: " << this->OutlineWidth << "\n";
  os << indent;
  PrintVector(os, "OutlineColor", this->OutlineColor);
  os << indent << "OutlineOpacity: " << this->OutlineOpacity << "\n";
  os << indent << "CreaseLines: " << (this->CreaseLines ? "On" : "Off") << "\n";
  os << indent << "BorderLines: " << (this->BorderLines ? "On" : "Off") << "\n";
  os << indent << "NonManifoldLines: " << (this->NonManifoldLines ? "On" : "Off") << "\n";
  os << indent << "IdLines: " << (this->IdLines ? "On" : "Off") << "\n";
  os << indent << "NormalLines: " << (this->NormalLines ? "On" : "Off") << "\n";
  os << indent << "ContourLines: " << (this->ContourLines ? "On" : "Off") << "\n";
  os << indent << "SilhouetteLines: " << (this->SilhouetteLines ? "On" : "Off") << "\n";
  os << indent << "RidgeLines: " << (this->RidgeLines ? "On" : "Off") << "\n";
  os << indent << "ValleyLines: " << (this->ValleyLines ? "On" : "Off") << "\n";
  os << indent << "SuggestiveLines: " << (this->SuggestiveLines ? "On" : "Off") << "\n";
  os << indent << "RidgeThreshold: " << this->RidgeThreshold << "\n";
  os << indent << "SuggestiveThreshold: " << this->SuggestiveThreshold << "\n";
  os << indent << "TerminatorLines: " << (this->TerminatorLines ? "On" : "Off") << "\n";
  os << indent << "ShadowLines: " << (this->ShadowLines ? "On" : "Off") << "\n";
  os << indent << "IntersectionLines: " << (this->IntersectionLines ? "On" : "Off") << "\n";
  os << indent << "LineLights: " << this->GetLineLightsAsString() << "\n";
  os << indent << "HatchLines: " << (this->HatchLines ? "On" : "Off") << "\n";
  os << indent << "HatchWidth: " << this->HatchWidth << "\n";
  os << indent << "IdArrayName: " << (this->IdArrayName ? this->IdArrayName : "(none)") << "\n";
  os << indent << "CreaseAngle: " << this->CreaseAngle << "\n";
  os << indent << "ShortestCrease: " << this->ShortestCrease << "\n";
  os << indent << "StrokeWidth: " << this->StrokeWidth << "\n";
  os << indent << "StrokeUnit: " << this->GetStrokeUnitAsString() << "\n";
  os << indent << "OuterWidthFactor: " << this->OuterWidthFactor << "\n";
  os << indent;
  PrintVector(os, "StrokeColor", this->StrokeColor);
  os << indent << "StrokeOpacity: " << this->StrokeOpacity << "\n";
  os << indent << "StrokeTaper: " << this->StrokeTaper << "\n";
  os << indent << "StrokeDash: " << this->StrokeDash << "\n";
  os << indent << "StrokeGap: " << this->StrokeGap << "\n";
  os << indent << "HiddenLines: " << this->GetHiddenLinesAsString() << "\n";
  os << indent << "OutlineDetector: " << this->GetOutlineDetectorAsString() << "\n";
  os << indent << "OutlineDepthTolerance: " << this->OutlineDepthTolerance << "\n";
  os << indent << "OutlineCreaseAngle: " << this->OutlineCreaseAngle << "\n";
  os << indent << "OutlineCreaseDetector: " << this->GetOutlineCreaseDetectorAsString() << "\n";
  os << indent << "OutlineIds: " << (this->OutlineIds ? "On" : "Off") << "\n";
  this->PrintCues(os, indent);
  os << indent << "TextureRole: " << this->GetTextureRoleAsString() << "\n";
  os << indent << "TextureMode: " << this->GetTextureModeAsString() << "\n";
  os << indent << "ProceduralTexture: " << this->GetProceduralTextureAsString() << "\n";
  os << indent << "ProceduralSpace: " << this->GetProceduralSpaceAsString() << "\n";
  os << indent;
  PrintVector(os, "ProceduralColorA", this->ProceduralColorA);
  os << indent;
  PrintVector(os, "ProceduralColorB", this->ProceduralColorB);
  os << indent << "ProceduralScale: " << this->ProceduralScale << "\n";
  os << indent << "ProceduralTurbulence: " << this->ProceduralTurbulence << "\n";
  os << indent << "LightmapTexture: " << this->LightmapTexture << "\n";
  os << indent << "LightmapIntensity: " << this->LightmapIntensity << "\n";
  os << indent << "LightmapTCoords: " << (this->LightmapTCoords ? this->LightmapTCoords : "(none)")
     << "\n";
  os << indent << "BumpTexture: " << this->BumpTexture << "\n";
  os << indent << "BumpScale: " << this->BumpScale << "\n";
  os << indent << "SurfaceShader: ";
  if (this->SurfaceShader)
  {
    os << "\n";
    this->SurfaceShader->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}
