// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnPostEffects.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLimnPostEffects);

//------------------------------------------------------------------------------
const char* vtkLimnPostEffects::GetToneMappingAsString()
{
  static const char* const names[] = { "None", "Reinhard", "ReinhardExtended", "Aces" };
  return names[this->ToneMapping];
}

//------------------------------------------------------------------------------
void vtkLimnPostEffects::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneMapping: " << this->GetToneMappingAsString() << "\n";
  os << indent << "WhitePoint: " << this->WhitePoint << "\n";
  os << indent << "BloomStrength: " << this->BloomStrength << "\n";
  os << indent << "BloomThreshold: " << this->BloomThreshold << "\n";
  os << indent << "BloomLevels: " << this->BloomLevels << "\n";
  os << indent << "DepthOfField: " << (this->DepthOfField ? "On" : "Off") << "\n";
  os << indent << "MaximumBlurRadius: " << this->MaximumBlurRadius << "\n";
}
