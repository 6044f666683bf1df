// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LinePainter_h
#define LinePainter_h

#include "vtkLimnCompositor.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Blends single pixels of lines into one window, a point each.
class LinePainter
{
public:
  explicit LinePainter(vtkOpenGLRenderWindow* window) : Window(window) {}
  LinePainter(const LinePainter&) = delete;
  void operator=(const LinePainter&) = delete;
  ~LinePainter();

  /// Into the current viewport. Requires: the window's context is current, the lines are as large
  /// as the viewport.
  void Blend(const vtkLimnCompositor::LineLayer& lines);
  /// The context is lost, and all that was in it.
  void Forget();

private:
  using Pixel = vtkLimnCompositor::LinePixel;
  void Upload(vtkShaderProgram* program);
  void SetState();
  vtkShaderProgram* ReadyProgram(const vtkLimnCompositor::LineLayer& lines);

  vtkOpenGLRenderWindow* Window;
  unsigned int VertexArray = 0;
  unsigned int Buffer = 0;
  std::vector<Pixel> Pixels; ///< those that write their depth first
};

#endif
