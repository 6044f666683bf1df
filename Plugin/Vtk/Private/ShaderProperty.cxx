// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShaderProperty.h"

#include "vtkLimnShaderProperty.h"

#include "vtkObjectFactory.h"

namespace limn::bridge
{

vtkSmartPointer<vtkShaderProperty> makeShaderProperty()
{
  vtkObject* const made = vtkObjectFactory::CreateInstance("vtkShaderProperty");
  vtkShaderProperty* const property =
    made ? static_cast<vtkShaderProperty*>(made) : vtkLimnShaderProperty::New();
  return vtkSmartPointer<vtkShaderProperty>::Take(property);
}

} // namespace limn::bridge
