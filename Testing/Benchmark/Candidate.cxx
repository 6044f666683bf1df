// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Candidate.h"

#include "Stopwatch.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include <vtkCamera.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cstdlib>

namespace
{
template <class Base, class Class>
vtkSmartPointer<Base> Make()
{
  return vtkSmartPointer<Class>::New();
}

/// If the actor is Limn's: with all that has a cost of its own at once.
void Illustrate(vtkActor* actor)
{
  auto* const property = vtkLimnProperty::SafeDownCast(actor->GetProperty());
  if (!property)
  {
    return;
  }
  property->SetGoochTo1998();
  property->SetToneLightToUpperRight();
  property->SetToonBands(4);
  property->SetOutlineToImage();
  property->CreaseLinesOn();
  property->BorderLinesOn();
  property->ContourLinesOn();
  property->SilhouetteLinesOn();
  property->RidgeLinesOn();
  property->ValleyLinesOn();
  property->SuggestiveLinesOn();
  property->SetOuterWidthFactor(2);
}
}

const std::array<Way, 3>& Ways()
{
  static const std::array<Way, 3> ways = { {
    { "limn", Make<vtkRenderWindow, vtkLimnRenderWindow>, Make<vtkRenderer, vtkLimnRenderer>,
      Make<vtkActor, vtkLimnActor>, Make<vtkPolyDataMapper, vtkLimnPolyDataMapper> },
    { "limn-in-gl", Make<vtkRenderWindow, vtkRenderWindow>, Make<vtkRenderer, vtkOpenGLRenderer>,
      Make<vtkActor, vtkLimnActor>, Make<vtkPolyDataMapper, vtkLimnPolyDataMapper> },
    { "vtk-gl", Make<vtkRenderWindow, vtkRenderWindow>, Make<vtkRenderer, vtkOpenGLRenderer>,
      Make<vtkActor, vtkOpenGLActor>, Make<vtkPolyDataMapper, vtkOpenGLPolyDataMapper> },
  } };
  return ways;
}

Candidate::Candidate(const Way& way, const Scene& scene) : Name(way.Name)
{
  this->Window = way.MakeWindow();
  this->Renderer = way.MakeRenderer();
  this->Window->SetMultiSamples(scene.Samples);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetSize(scene.Width, scene.Height);
  this->Window->AddRenderer(this->Renderer);
  vtkSmartPointer<vtkTexture> texture;
  if (scene.Texture)
  {
    texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(scene.Texture);
    texture->InterpolateOn();
    texture->MipmapOn();
  }
  for (const Part& part : scene.Parts)
  {
    vtkSmartPointer<vtkPolyDataMapper> mapper = way.MakeMapper();
    mapper->SetInputData(part.Data);
    mapper->ScalarVisibilityOff();
    vtkSmartPointer<vtkActor> actor = way.MakeActor();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(scene.Opacity);
    actor->SetTexture(texture);
    if (scene.Illustrated)
    {
      Illustrate(actor);
    }
    actor->SetPosition(part.Position[0], part.Position[1], part.Position[2]);
    this->Renderer->AddActor(actor);
  }
  if (scene.IsTranslucent())
  {
    // All layers, and none approximated.
    this->Renderer->UseDepthPeelingOn();
    this->Renderer->SetMaximumNumberOfPeels(1000);
    this->Renderer->SetOcclusionRatio(0);
  }
  this->Renderer->ResetCamera();
  this->Renderer->GetActiveCamera()->Elevation(scene.Elevation);
  this->Renderer->GetActiveCamera()->Zoom(scene.Zoom);
  this->Renderer->ResetCameraClippingRange();
}

void Candidate::Turn()
{
  constexpr double kDegrees = 3;
  this->Renderer->GetActiveCamera()->Azimuth(kDegrees);
  this->Renderer->ResetCameraClippingRange();
}

double Candidate::Draw()
{
  const Stopwatch time;
  this->Window->Render();
  const int* size = this->Window->GetSize();
  this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, this->Pixels);
  return time.Milliseconds();
}

int Candidate::SamplesPerPixel()
{
  if (auto* limn = vtkLimnRenderWindow::SafeDownCast(this->Window))
  {
    return limn->GetSamplesPerPixel();
  }
  auto* openGL = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  return std::max(openGL->GetRenderFramebuffer()->GetMultiSamples(), 1);
}

std::size_t CountDiffering(const unsigned char* a, const unsigned char* b, std::size_t pixels)
{
  constexpr int kLevels = 2;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    bool differs = false;
    for (std::size_t c = 0; c < 3; ++c)
    {
      differs |= std::abs(a[4 * i + c] - b[4 * i + c]) > kLevels;
    }
    count += differs;
  }
  return count;
}
