// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenWindow.h"

#include "UserError.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnEngine.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include <dlfcn.h>

#include <cstdlib>

namespace limn::viewer
{
namespace
{

bool isDisplayOpen()
{
  // VTK's own window aborts the program where there is no display.
  void* const library = dlopen("libX11.so.6", RTLD_LAZY);
  if (!library)
  {
    return false;
  }
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(dlsym(library, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(dlsym(library, "XCloseDisplay"));
  void* const display = open && close ? open(nullptr) : nullptr;
  if (!display)
  {
    return false;
  }
  close(display);
  return true;
}

OpenedWindow makeGlWindow()
{
  if (!isDisplayOpen())
  {
    throw UserError("an OpenGL window needs an X display, and none can be opened; set DISPLAY, or "
                    "draw with limn render --window=cpu");
  }
  const auto compositor = vtk::TakeSmartPointer(vtkLimnCompositor::New());
  if (!compositor)
  {
    throw UserError("Limn's OpenGL module cannot be loaded; reinstall Limn with it, or draw with "
                    "limn render --window=cpu");
  }
  return { vtkSmartPointer<vtkRenderWindow>::New(), vtkSmartPointer<vtkRenderer>::New() };
}

OpenedWindow makeCpuWindow()
{
  return { vtkSmartPointer<vtkLimnRenderWindow>::New(), vtkSmartPointer<vtkLimnRenderer>::New() };
}

} // namespace

void preferWindow(Window kind)
{
  // The environment is for programs that do not say themselves which window they want.
  setenv("LIMN_WINDOW", kind == Window::Gl ? "gl" : "cpu", 1);
}

OpenedWindow openWindow(Window kind, const SceneSettings& scene)
{
  if (scene.threads > 0)
  {
    vtkLimnEngine::SetNumberOfThreads(scene.threads);
  }
  OpenedWindow opened = kind == Window::Gl ? makeGlWindow() : makeCpuWindow();
  opened.window->SetSize(scene.resolution[0], scene.resolution[1]);
  opened.window->SetMultiSamples(scene.samples);
  if (scene.pixelsPerInch)
  {
    opened.window->SetDPI(static_cast<int>(*scene.pixelsPerInch));
  }
  opened.window->AddRenderer(opened.renderer);
  return opened;
}

} // namespace limn::viewer
