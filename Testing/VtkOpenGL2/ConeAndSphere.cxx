// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's cone example with an actor that is OpenGL's by name. It is built twice: as it stands, and
// with nothing changed but names of classes, which makes the cone Limn's.
#include "vtkActor.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " MULTISAMPLES OUT.png\n";
    return 2;
  }
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(3.0);
  cone->SetRadius(1.0);
  cone->SetResolution(40);
  vtkNew<vtkPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkProperty> coneProperty;
  coneProperty->SetColor(0.9, 0.6, 0.2);
  vtkNew<vtkActor> coneActor;
  coneActor->SetMapper(coneMapper);
  coneActor->SetProperty(coneProperty);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-0.6, 0.3, 0.0);
  sphere->SetRadius(0.9);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkOpenGLPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkOpenGLActor> sphereActor;
  sphereActor->SetMapper(sphereMapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(coneActor);
  renderer->AddActor(sphereActor);
  renderer->SetBackground(0.1, 0.2, 0.4);

  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(std::stoi(argv[1]));
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  std::cout << "mapper=" << coneMapper->GetClassName() << "\n";
  return 0;
}
