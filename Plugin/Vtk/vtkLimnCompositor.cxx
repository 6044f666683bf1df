// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnCompositor.h"

#include "Private/DrawSurfaces.h"

#include "vtkMapper.h"
#include "vtkObjectFactory.h"

#include <dlfcn.h>

#include <string>

namespace
{
/// Loads a library of ours that lies beside this one. What went wrong, or "".
std::string LoadNeighbour(const char* name)
{
  Dl_info here;
  static const char anchor = 0;
  if (!dladdr(&anchor, &here) || !here.dli_fname)
  {
    return "the folder of Limn's own library is not known";
  }
  const std::string path = here.dli_fname;
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  // Its own dependencies stay loaded as long as this program runs, as if it had been linked.
  if (!dlopen((folder + name).c_str(), RTLD_NOW | RTLD_GLOBAL))
  {
    return dlerror();
  }
  return {};
}

vtkLimnCompositor* CreateRegistered()
{
  return static_cast<vtkLimnCompositor*>(vtkObjectFactory::CreateInstance("vtkLimnCompositor"));
}
}

//------------------------------------------------------------------------------
vtkLimnCompositor::vtkLimnCompositor() = default;

//------------------------------------------------------------------------------
vtkLimnCompositor::~vtkLimnCompositor() = default;

//------------------------------------------------------------------------------
vtkLimnCompositor* vtkLimnCompositor::New()
{
  if (vtkLimnCompositor* compositor = CreateRegistered())
  {
    return compositor;
  }
  static const std::string failure = LoadNeighbour("libvtkLimnOpenGL2.so");
  vtkLimnCompositor* compositor = failure.empty() ? CreateRegistered() : nullptr;
  static bool isReported = false;
  if (!compositor && !isReported)
  {
    isReported = true;
    vtkGenericWarningMacro(
      "Limn cannot draw into OpenGL windows: "
      << (failure.empty() ? "libvtkLimnOpenGL2.so brings no compositor" : failure)
      << ". Install Limn's OpenGL module beside its other libraries, or set LIMN_WINDOW=cpu.");
  }
  return compositor;
}

//------------------------------------------------------------------------------
void vtkLimnCompositor::RenderMapperWithBackend(
  vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  mapper->Render(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkLimnCompositor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkLimnCompositor::BlendWaitingLines(vtkRenderer* renderer)
{
  limn::bridge::blendWaitingLines(renderer);
}
