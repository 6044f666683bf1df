// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A VTK example with Limn's class names, against the installed modules: writes cone.png.
#include <vtkConeSource.h>
#include <vtkLimnActor.h>
#include <vtkLimnPolyDataMapper.h>
#include <vtkLimnRenderWindow.h>
#include <vtkLimnRenderer.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>
#include <vtkImageData.h>

int main()
{
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkLimnActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkLimnRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkLimnRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(200, 200);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName("cone.png");
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  return picture->GetOutput()->GetScalarComponentAsDouble(100, 100, 0, 0) > 50 ? 0 : 1;
}
