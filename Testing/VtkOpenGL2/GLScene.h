// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Picture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

/// What a window shows, be it Limn's or OpenGL's.
inline Picture ReadPicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  Picture picture;
  picture.Width = size[0];
  picture.Height = size[1];
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, bytes);
  picture.Bytes.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  return picture;
}

/// An off-screen OpenGL window with one renderer that has a fixed camera and background.
class GLScene
{
public:
  explicit GLScene(int multiSamples, int width = 200, int height = 160)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(multiSamples);
    this->Window->SetSize(width, height);
    this->Renderer->SetBackground(0.1, 0.2, 0.3);
    this->Window->AddRenderer(this->Renderer);
    SetUpCamera(this->Renderer);
  }

  /// Looks along -z at the origin; two units fill the window's height. Parallel, so that geometry
  /// can be placed on exact pixels.
  static void SetUpCamera(vtkRenderer* renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(1.0, 9.0);
  }

  Picture Render()
  {
    this->Window->Render();
    return this->Read();
  }

  Picture Read() { return ReadPicture(this->Window); }

  std::vector<float> ReadDepth()
  {
    const int* size = this->Window->GetSize();
    vtkNew<vtkFloatArray> depth;
    this->Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth);
    return { depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues() };
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// VTK's own OpenGL actor, whatever the object factory would make.
inline vtkSmartPointer<vtkActor> MakeGLActor(vtkAlgorithmOutput* source)
{
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  vtkNew<vtkOpenGLProperty> property;
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkOpenGLActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}
