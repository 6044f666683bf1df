// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnProperty.h"

#include "vtkObjectFactory.h"

namespace
{
void PrintVector(ostream& os, const char* name, const double vector[3])
{
  os << name << ": (" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")\n";
}
}

vtkStandardNewMacro(vtkLimnProperty);

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetShadingFrequencyAsString()
{
  static const char* const names[] = { "AsVTK", "Flat", "Gouraud", "Phong" };
  return names[this->ShadingFrequency];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetReflectionModelAsString()
{
  static const char* const names[] = { "AsVTK", "None", "Lambert", "BlinnPhong", "Phong" };
  return names[this->ReflectionModel];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetToneAsString()
{
  static const char* const names[] = { "None", "Gooch", "GoochChapter" };
  return names[this->Tone];
}

//------------------------------------------------------------------------------
const char* vtkLimnProperty::GetOutlineAsString()
{
  static const char* const names[] = { "None", "Normal" };
  return names[this->Outline];
}

//------------------------------------------------------------------------------
void vtkLimnProperty::DeepCopy(vtkProperty* property)
{
  this->Superclass::DeepCopy(property);
  vtkLimnProperty* other = vtkLimnProperty::SafeDownCast(property);
  if (!other)
  {
    return;
  }
  this->SetShadingFrequency(other->ShadingFrequency);
  this->SetReflectionModel(other->ReflectionModel);
  this->SetTone(other->Tone);
  this->SetCoolColor(other->CoolColor);
  this->SetWarmColor(other->WarmColor);
  this->SetCoolSurface(other->CoolSurface);
  this->SetWarmSurface(other->WarmSurface);
  this->SetOutline(other->Outline);
  this->SetOutlineThreshold(other->OutlineThreshold);
  this->SetOutlineColor(other->OutlineColor);
}

//------------------------------------------------------------------------------
void vtkLimnProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadingFrequency: " << this->GetShadingFrequencyAsString() << "\n";
  os << indent << "ReflectionModel: " << this->GetReflectionModelAsString() << "\n";
  os << indent << "Tone: " << this->GetToneAsString() << "\n";
  os << indent;
  PrintVector(os, "CoolColor", this->CoolColor);
  os << indent;
  PrintVector(os, "WarmColor", this->WarmColor);
  os << indent << "CoolSurface: " << this->CoolSurface << "\n";
  os << indent << "WarmSurface: " << this->WarmSurface << "\n";
  os << indent << "Outline: " << this->GetOutlineAsString() << "\n";
  os << indent << "OutlineThreshold: " << this->OutlineThreshold << "\n";
  os << indent;
  PrintVector(os, "OutlineColor", this->OutlineColor);
}
