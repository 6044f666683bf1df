// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnVertexShader.h"

//------------------------------------------------------------------------------
void vtkLimnVertexShader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MovesNormals: " << (this->MovesNormals() ? "yes" : "no") << "\n";
}
