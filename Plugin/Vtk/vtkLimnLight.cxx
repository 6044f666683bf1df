// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnLight.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkLimnLight);

//------------------------------------------------------------------------------
void vtkLimnLight::SetShape(int shape)
{
  shape = std::clamp<int>(shape, SHAPE_POINT, SHAPE_SPHERE);
  if (shape != SHAPE_POINT)
  {
    this->PositionalOn();
  }
  if (this->Shape != shape)
  {
    this->Shape = shape;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkLimnLight::GetShapeAsString()
{
  static const char* const names[] = { "Point", "Rectangle", "Sphere" };
  return names[this->Shape];
}

//------------------------------------------------------------------------------
const char* vtkLimnLight::GetUnitAsString()
{
  return this->Unit == UNIT_POWER ? "Power" : "Intensity";
}

//------------------------------------------------------------------------------
void vtkLimnLight::CopyOwnSettings(vtkLight* light)
{
  vtkLimnLight* const other = vtkLimnLight::SafeDownCast(light);
  if (!other)
  {
    return;
  }
  this->SetShape(other->Shape);
  this->SetWidth(other->Width);
  this->SetHeight(other->Height);
  this->SetViewUp(other->ViewUp);
  this->SetRadius(other->Radius);
  this->SetSamples(other->Samples);
  this->SetSoftEdgeAngle(other->SoftEdgeAngle);
  this->SetUnit(other->Unit);
}

//------------------------------------------------------------------------------
void vtkLimnLight::DeepCopy(vtkLight* light)
{
  this->Superclass::DeepCopy(light);
  this->CopyOwnSettings(light);
}

//------------------------------------------------------------------------------
vtkLight* vtkLimnLight::ShallowClone()
{
  vtkLimnLight* const clone = vtkLimnLight::New();
  clone->vtkLight::DeepCopy(this);
  clone->SetTransformMatrix(this->TransformMatrix);
  clone->CopyOwnSettings(this);
  return clone;
}

//------------------------------------------------------------------------------
void vtkLimnLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->GetShapeAsString() << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "ViewUp: (" << this->ViewUp[0] << ", " << this->ViewUp[1] << ", "
     << this->ViewUp[2] << ")\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
  os << indent << "SoftEdgeAngle: " << this->SoftEdgeAngle << "\n";
  os << indent << "Unit: " << this->GetUnitAsString() << "\n";
}
