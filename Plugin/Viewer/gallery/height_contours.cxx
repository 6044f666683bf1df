// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause

// A surface shader: bands of height in two tones, lit by the property's own model, and contour
// lines of one width over them. Needs no OpenGL and no display.
// Usage: height_contours MESH FILE.png [WIDTH HEIGHT]
#include "vtkLimnActor.h"
#include "vtkLimnMeshReader.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"
#include "vtkLimnSurfaceShader.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdlib>

class HeightContours : public vtkLimnSurfaceShader
{
public:
  static HeightContours* New();
  vtkTypeMacro(HeightContours, vtkLimnSurfaceShader);

  vtkSetMacro(Interval, double);
  vtkSetMacro(LineWidth, double);     // in pixels
  vtkSetMacro(PictureHeight, double); // likewise

  void Shade(
    const Fragments& fragments, const Lighting& lighting, float* const color[3]) const override
  {
    // Every other band of height reflects less of red and more of blue; the property's model lights
    // both.
    float red[Capacity];
    float blue[Capacity];
    for (int i = 0; i < fragments.Count; ++i)
    {
      const bool isOdd = this->Band(fragments, i) % 2 != 0;
      red[i] = fragments.Diffuse.X[i] * (isOdd ? 0.55f : 1.0f);
      blue[i] = fragments.Diffuse.Z[i] * (isOdd ? 1.6f : 1.0f);
    }
    Fragments banded = fragments;
    banded.Diffuse.X = red;
    banded.Diffuse.Z = blue;
    lighting.Light(banded, color);

    double view[16];
    lighting.GetWorldToView(view);
    const double up[3] = { view[1], view[5], view[9] };
    for (int i = 0; i < fragments.Count; ++i)
    {
      const auto ink = static_cast<float>(this->Ink(fragments, i, up));
      for (int channel = 0; channel < 3; ++channel)
      {
        color[channel][i] = 0.05f * ink + color[channel][i] * (1 - ink);
      }
    }
  }

protected:
  double Interval = 1;
  double LineWidth = 1.5;
  double PictureHeight = 1;

private:
  int Band(const Fragments& fragments, int i) const
  {
    return static_cast<int>(std::floor(fragments.ModelPosition.Y[i] / this->Interval));
  }

  // How much of a pixel the nearest line covers.
  double Ink(const Fragments& fragments, int i, const double up[3]) const
  {
    const double bands = fragments.ModelPosition.Y[i] / this->Interval;
    const double height = std::fabs(bands - std::nearbyint(bands)) * this->Interval;
    // Along the surface the line is farther than it is high; a flat place has none.
    const double rise =
      fragments.Normal.X[i] * up[0] + fragments.Normal.Y[i] * up[1] + fragments.Normal.Z[i] * up[2];
    const double slope = std::sqrt(std::fmax(1 - rise * rise, 1e-6));
    // Pixels of a lens of 30 degrees, at this distance.
    const double pixel = -fragments.Position.Z[i] * 0.536 / this->PictureHeight;
    const double distance = height / (slope * pixel);
    return std::fmin(std::fmax(this->LineWidth / 2 + 0.5 - distance, 0.0), 1.0);
  }
};
vtkStandardNewMacro(HeightContours);

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
  vtkNew<HeightContours> contours;
  contours->SetInterval(0.25);
  vtkNew<vtkLimnProperty> property;
  property->SetShadingFrequencyToPhong();
  property->SetReflectionModelToBlinnPhong();
  property->SetColor(0.85, 0.75, 0.5);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.4);
  property->SetSpecularPower(40);
  property->SetAmbient(0.2);
  property->SetSurfaceShader(contours);
  vtkNew<vtkLimnActor> actor;
  actor->SetMapper(mapper);
  actor->SetProperty(property);

  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.94, 0.95, 0.97);
  renderer->SetAmbient(1, 1, 1);
  renderer->AddActor(actor);
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(-1, 2, 2);
  renderer->AddLight(lamp);
  renderer->GetActiveCamera()->SetPosition(1, 1.2, 3);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.3);

  const int width = argc == 5 ? std::atoi(argv[3]) : 800;
  const int height = argc == 5 ? std::atoi(argv[4]) : 600;
  contours->SetPictureHeight(height);
  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(width, height);
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
