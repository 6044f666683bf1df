// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnRenderWindowInteractor.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

vtkStandardNewMacro(vtkLimnRenderWindowInteractor);

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::Initialize()
{
  if (!this->RenderWindow)
  {
    vtkErrorMacro("No render window: call SetRenderWindow() first.");
    return;
  }
  if (this->Initialized)
  {
    return;
  }
  this->Initialized = 1;
  const int* size = this->RenderWindow->GetSize();
  this->Size[0] = size[0];
  this->Size[1] = size[1];
  this->Enable();
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::StartEventLoop()
{
  // As a window on a screen when it is first shown.
  if (this->RenderWindow->GetNeverRendered())
  {
    this->Render();
  }
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindowInteractor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
