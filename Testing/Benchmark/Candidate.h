// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Candidate_h
#define Candidate_h

#include "Scenes.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkActor;
class vtkPolyDataMapper;

/// One way of drawing the scenes.
struct Way
{
  std::string Name;
  vtkSmartPointer<vtkRenderWindow> (*MakeWindow)();
  vtkSmartPointer<vtkRenderer> (*MakeRenderer)();
  vtkSmartPointer<vtkActor> (*MakeActor)();
  vtkSmartPointer<vtkPolyDataMapper> (*MakeMapper)();
};

/// Limn's window without OpenGL, Limn in an OpenGL window, VTK's own mapper in an OpenGL window.
const std::array<Way, 3>& Ways();

/// A scene in a window of one kind.
class Candidate
{
public:
  Candidate(const Way& way, const Scene& scene);

  /// Moves the camera on, round the scene.
  void Turn();
  /// Returns milliseconds until the picture lies in memory.
  double Draw();

  /// In use, after a frame; 1 without multisampling.
  int SamplesPerPixel();

  std::string Name;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
};

/// Pixels in which a channel differs by more than two levels. Both are RGBA.
std::size_t CountDiffering(const unsigned char* a, const unsigned char* b, std::size_t pixels);

#endif
