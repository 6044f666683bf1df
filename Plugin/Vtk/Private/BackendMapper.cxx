// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackendMapper.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"

#include "vtkMapper.h"
#include "vtkRenderer.h"

#include <cstring>
#include <set>
#include <string>

namespace limn::bridge
{
namespace
{

// Never deleted: it outlives every window that a program may leave open until it ends.
vtkLimnCompositor* theCompositor = nullptr;

/// Whether only OpenGL's mapper draws it; VTK's mappers of glyphs and splats are abstract in all
/// but name.
bool belongsToOpenGL(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLPolyDataMapper") || mapper->IsA("vtkGlyph3DMapper") ||
         mapper->IsA("vtkPointGaussianMapper") ||
         std::string(mapper->GetClassName()).rfind("vtkOpenGL", 0) == 0;
}

std::string adviceFor(vtkMapper* mapper)
{
  const bool hasCounterpart = std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0;
  return hasCounterpart ? "Use vtkLimnPolyDataMapper here; with LIMN_WINDOW=cpu "
                          "vtkPolyDataMapper::New() makes one."
                        : "Use an OpenGL window (LIMN_WINDOW=gl) for it.";
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
  if (vtkLimnPolyDataMapper::SafeDownCast(mapper))
  {
    mapper->Render(renderer, actor);
    return;
  }
  const bool isInLimnWindow =
    vtkLimnRenderWindow::SafeDownCast(renderer->GetRenderWindow()) != nullptr;
  if (isInLimnWindow && belongsToOpenGL(mapper))
  {
    static std::set<std::string> reported;
    if (reported.insert(mapper->GetClassName()).second)
    {
      vtkErrorWithObjectMacro(actor,
        "A " << mapper->GetClassName() << " draws in OpenGL windows only. " << adviceFor(mapper));
    }
    return;
  }
  if (isInLimnWindow || !compositor())
  {
    mapper->Render(renderer, actor);
    return;
  }
  compositor()->RenderMapperWithBackend(renderer, actor, mapper);
}

} // namespace limn::bridge
