// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program of somebody who never heard of Limn: a cone, drawn twice, written to a
// PNG file. Prints the classes it got and whether a library of OpenGL or X is in the process.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <fstream>
#include <iostream>
#include <string>

static bool UsesGraphicsLibraries()
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    for (const char* library : { "libGL", "libOpenGL", "libX11", "libEGL" })
    {
      if (line.find(library) != std::string::npos)
      {
        return true;
      }
    }
  }
  return false;
}

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
  vtkNew<vtkActor> coneActor;
  coneActor->SetMapper(coneMapper);
  coneActor->GetProperty()->SetColor(0.9, 0.6, 0.2);
  coneActor->RotateZ(30.0);
  coneActor->RotateY(35.0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(coneActor);
  renderer->SetBackground(0.1, 0.2, 0.4);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(std::stoi(argv[1]));
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  window->Render();
  renderer->GetActiveCamera()->Azimuth(20.0);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();

  std::cout << "mapper=" << coneMapper->GetClassName() << "\n"
            << "actor=" << coneActor->GetClassName() << "\n"
            << "property=" << coneActor->GetProperty()->GetClassName() << "\n"
            << "window=" << window->GetClassName() << "\n"
            << "graphics libraries=" << (UsesGraphicsLibraries() ? "yes" : "no") << "\n";
  return 0;
}
