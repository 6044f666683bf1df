// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClearViewport_h
#define ClearViewport_h

#include "WindowFrame.h"

class vtkRenderer;

namespace limn::bridge
{

/// The pixels of a renderer's viewport in its Limn window, clipped to the window.
vtkLimnRenderWindow::vtkFrame::Region viewportOf(
  vtkRenderer* renderer, const vtkLimnRenderWindow::vtkFrame& frame);

/// Fills the viewport with the renderer's background, one colour or a gradient, unless it preserves
/// the colours below, and with the farthest depth, unless it preserves that.
void clearViewport(vtkRenderer* renderer, vtkLimnRenderWindow::vtkFrame& frame);

} // namespace limn::bridge

#endif
