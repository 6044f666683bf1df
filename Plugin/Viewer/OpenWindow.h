// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_OpenWindow_h
#define limn_viewer_OpenWindow_h

#include "RenderSettings.h" // for SceneSettings, Window

#include <vtkRenderWindow.h> // for OpenedWindow
#include <vtkRenderer.h>     // for OpenedWindow
#include <vtkSmartPointer.h> // for OpenedWindow

namespace limn::viewer
{

struct OpenedWindow
{
  vtkSmartPointer<vtkRenderWindow> window;
  vtkSmartPointer<vtkRenderer> renderer; ///< its only one, empty
};

/// Makes Limn's object factory serve this kind of window, whatever the environment says. Call
/// before anything is read or made: the factory asks once.
void preferWindow(Window kind);

/// Makes a window of the scene's resolution and samples, drawn by the scene's number of threads;
/// nothing is shown before its first Render(). The OpenGL module and with it OpenGL are loaded for
/// Window::Gl only. Throws UserError if they cannot be, or if there is no display.
OpenedWindow openWindow(Window kind, const SceneSettings& scene);

} // namespace limn::viewer

#endif
