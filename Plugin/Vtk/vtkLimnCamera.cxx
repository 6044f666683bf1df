// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnCamera.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkLimnCamera);

//------------------------------------------------------------------------------
void vtkLimnCamera::Render(vtkRenderer* renderer)
{
  this->Stereo = renderer->GetRenderWindow()->GetStereoRender();
}

//------------------------------------------------------------------------------
void vtkLimnCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
