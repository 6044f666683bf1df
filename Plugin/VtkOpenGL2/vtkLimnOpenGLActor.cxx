// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnOpenGLActor.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"

#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkLimnOpenGLActor);

//------------------------------------------------------------------------------
void vtkLimnOpenGLActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  const bool isInOpenGLWindow = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!isInOpenGLWindow || !this->Compositor || vtkLimnPolyDataMapper::SafeDownCast(mapper))
  {
    mapper->Render(renderer, this);
  }
  else
  {
    this->Compositor->RenderMapperWithBackend(renderer, this, mapper);
  }
  this->EstimatedRenderTime += mapper->GetTimeToDraw();
}

//------------------------------------------------------------------------------
int vtkLimnOpenGLActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  vtkLimnCompositor::BlendWaitingLines(static_cast<vtkRenderer*>(viewport));
  return this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
}

//------------------------------------------------------------------------------
int vtkLimnOpenGLActor::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkLimnCompositor::BlendWaitingLines(static_cast<vtkRenderer*>(viewport));
  return this->Superclass::RenderVolumetricGeometry(viewport);
}

//------------------------------------------------------------------------------
void vtkLimnOpenGLActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Compositor: " << this->Compositor << "\n";
}
