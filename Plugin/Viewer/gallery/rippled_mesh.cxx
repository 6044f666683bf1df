// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause

// A vertex shader: a wave that runs up a mesh and moves it aside. Bounds, camera and normals
// follow. Needs no OpenGL and no display. Usage: rippled_mesh MESH FILE.png [WIDTH HEIGHT]
#include "vtkLimnActor.h"
#include "vtkLimnMeshReader.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"
#include "vtkLimnVertexShader.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdlib>

class Ripple : public vtkLimnVertexShader
{
public:
  static Ripple* New();
  vtkTypeMacro(Ripple, vtkLimnVertexShader);

  vtkSetMacro(Height, double);
  vtkSetMacro(Length, double);

  void Move(const Vertices& vertices) const override
  {
    for (int i = 0; i < vertices.Count; ++i)
    {
      vertices.Position[0][i] += this->Height * Wave(2 * vertices.Position[1][i] / this->Length);
    }
  }

protected:
  double Height = 0;
  double Length = 1;

private:
  // Parabolas instead of a sine, with the period 2: the last digits of the C library's sine differ
  // between machines.
  static double Wave(double phase)
  {
    const double t = phase - 2 * std::nearbyint(phase / 2);
    return 4 * t * (1 - std::fabs(t));
  }
};
vtkStandardNewMacro(Ripple);

int main(int argc, char* argv[])
{
  if (argc != 3 && argc != 5)
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkLimnMeshReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<Ripple> ripple;
  ripple->SetHeight(0.25);
  ripple->SetLength(1.6);
  mapper->SetVertexShader(ripple);
  vtkNew<vtkLimnProperty> property;
  property->SetShadingFrequencyToPhong();
  property->SetToneToGooch();
  property->SetColor(0.8, 0.8, 0.8);
  vtkNew<vtkLimnActor> actor;
  actor->SetMapper(mapper);
  actor->SetProperty(property);

  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.94, 0.95, 0.97);
  renderer->AddActor(actor);
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(-1, 2, 2);
  renderer->AddLight(lamp);
  renderer->GetActiveCamera()->SetPosition(1, 1.2, 3);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.3);

  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(argc == 5 ? std::atoi(argv[3]) : 800, argc == 5 ? std::atoi(argv[4]) : 600);
  window->SetMultiSamples(4);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
