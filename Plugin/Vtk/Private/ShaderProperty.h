// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShaderProperty_h
#define ShaderProperty_h

#include "vtkSmartPointer.h"

class vtkShaderProperty;

namespace limn::bridge
{

/// As vtkShaderProperty::New(), which fails in programs where no backend makes one: there a
/// vtkLimnShaderProperty.
vtkSmartPointer<vtkShaderProperty> makeShaderProperty();

} // namespace limn::bridge

#endif
