// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause

// The scene of intersecting_actors.cxx in a window that needs no OpenGL and no display.
// Usage: without_opengl FILE.png
#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(96);
  sphere->SetPhiResolution(64);
  vtkNew<vtkLimnPolyDataMapper> sphereMapper;
  sphereMapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkLimnProperty> illustrated;
  illustrated->SetShadingFrequencyToPhong();
  illustrated->SetToneToGooch();
  illustrated->SetOutlineToNormal();
  illustrated->SetColor(0.8, 0.8, 0.8);
  vtkNew<vtkLimnActor> sphereActor;
  sphereActor->SetMapper(sphereMapper);
  sphereActor->SetProperty(illustrated);

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(64);
  cone->SetHeight(1.6);
  cone->SetRadius(0.4);
  vtkNew<vtkLimnPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkLimnActor> coneActor;
  coneActor->SetMapper(coneMapper);
  coneActor->GetProperty()->SetColor(0.85, 0.35, 0.2);

  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.94, 0.95, 0.97);
  renderer->AddActor(sphereActor);
  renderer->AddActor(coneActor);
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(-1, 2, 1);
  renderer->AddLight(lamp);
  renderer->GetActiveCamera()->SetPosition(1, 0.8, 2);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.6);

  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(800, 600);
  window->SetMultiSamples(4);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
