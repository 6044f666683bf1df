// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnProperty.h"

#include "vtkLimnSurfaceShader.h"

#include "vtkObjectFactory.h"
#include "vtkTexture.h"

#include <algorithm>
#include <map>
#include <string>

namespace
{
void PrintVector(ostream& os, const char* name, const double vector[3])
{
  os << name << ": (" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")\n";
}
}

vtkStandardNewMacro(vtkLimnProperty);
vtkCxxSetObjectMacro(vtkLimnProperty, LightmapTexture, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, BumpTexture, vtkTexture);
vtkCxxSetObjectMacro(vtkLimnProperty, SurfaceShader, vtkLimnSurfaceShader);

//------------------------------------------------------------------------------
vtkLimnProperty::~vtkLimnProperty()
{
  this->SetLightmapTexture(nullptr);
  this->SetLightmapTCoords(nullptr);
  this->SetBumpTexture(nullptr);
  this->SetSurfaceShader(nullptr);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLimnProperty::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->SurfaceShader ? std::max(time, this->SurfaceShader->GetMTime()) : time;
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
  static const char* const names[] = { "None", "Gooch", "GoochChapter" };
  return names[this->Tone];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneOverDataAsString()
{
  static const char* const names[] = { "Classic", "Undertone", "LegendSafe" };
  return names[this->ToneOverData];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetOutlineAsString()
{
  static const char* const names[] = { "None", "Normal" };
  return names[this->Outline];
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
  this->SetTone(other->Tone);
  this->SetCoolColor(other->CoolColor);
  this->SetWarmColor(other->WarmColor);
  this->SetCoolSurface(other->CoolSurface);
  this->SetWarmSurface(other->WarmSurface);
  this->SetToneOverData(other->ToneOverData);
  this->SetUndertone(other->Undertone);
  this->SetLegendSafeRange(other->LegendSafeRange);
  this->SetOutline(other->Outline);
  this->SetOutlineThreshold(other->OutlineThreshold);
  this->SetOutlineWidth(other->OutlineWidth);
  this->SetOutlineColor(other->OutlineColor);
  this->SetOutlineOpacity(other->OutlineOpacity);
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
  os << indent << "Outline: " << this->GetOutlineAsString() << "\n";
  os << indent << "OutlineThreshold: " << this->OutlineThreshold << "\n";
  os << indent << "OutlineWidth: " << this->OutlineWidth << "\n";
  os << indent;
  PrintVector(os, "OutlineColor", this->OutlineColor);
  os << indent << "OutlineOpacity: " << this->OutlineOpacity << "\n";
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
