// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackendMapper.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"

#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <set>
#include <string>

namespace limn::bridge
{
namespace
{

// Never deleted: it outlives every window that a program may leave open until it ends.
vtkLimnCompositor* theCompositor = nullptr;

/// Whether only OpenGL's mapper draws it; VTK's glyph mapper is abstract in all but name.
bool belongsToOpenGL(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLPolyDataMapper") || mapper->IsA("vtkGlyph3DMapper") ||
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
    static std::set<std::string> reported;
    if (reported.insert(mapper->GetClassName()).second)
    {
      vtkErrorWithObjectMacro(
        actor, "A " << mapper->GetClassName()
                    << " draws in OpenGL windows only; use vtkLimnPolyDataMapper here, or set "
                       "LIMN_WINDOW=cpu, so that vtkPolyDataMapper::New() makes one.");
    }
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
