// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackendMapper.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"

#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <string>

namespace limn::bridge
{
namespace
{

// Never deleted: it outlives every window that a program may leave open until it ends.
vtkLimnCompositor* theCompositor = nullptr;

bool belongsToOpenGL(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLPolyDataMapper") ||
         std::string(mapper->GetClassName()).rfind("vtkOpenGL", 0) == 0;
}

} // namespace

vtkLimnCompositor* compositor()
{
  static const bool isMade = (theCompositor = vtkLimnCompositor::New()) != nullptr;
  return isMade ? theCompositor : nullptr;
}

void releaseBackend(vtkWindow* window)
{
  if (theCompositor)
  {
    theCompositor->ReleaseGraphicsResources(window);
  }
}

void renderMapper(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  const bool isInLimnWindow =
    vtkLimnRenderWindow::SafeDownCast(renderer->GetRenderWindow()) != nullptr;
  if (isInLimnWindow && belongsToOpenGL(mapper))
  {
    vtkErrorWithObjectMacro(actor,
      "A "
        << mapper->GetClassName()
        << " draws in OpenGL windows only; use vtkLimnPolyDataMapper here, or set LIMN_WINDOW=cpu, "
           "so that vtkPolyDataMapper::New() makes one.");
    return;
  }
  if (isInLimnWindow || vtkLimnPolyDataMapper::SafeDownCast(mapper) || !compositor())
  {
    mapper->Render(renderer, actor);
    return;
  }
  compositor()->RenderMapperWithBackend(renderer, actor, mapper);
}

} // namespace limn::bridge
