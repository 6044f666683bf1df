// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A parametric torus of SIDE x SIDE points, turned before the camera: Limn's window without OpenGL
// and VTK's own mapper in an OpenGL window, in turn, one sample a pixel, until the picture lies in
// memory. Prints first and median frame times.
//
//   limn_large_mesh [SIDE [WIDTH HEIGHT]]        default 3000 1280 720

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

struct Candidate
{
  std::string Name;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
  std::vector<double> Milliseconds;

  void Draw()
  {
    const auto start = Clock::now();
    this->Window->Render();
    const int* size = this->Window->GetSize();
    this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, this->Pixels);
    this->Milliseconds.push_back(
      std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }

  double Median() const
  {
    std::vector<double> later(this->Milliseconds.begin() + 2, this->Milliseconds.end());
    std::nth_element(later.begin(), later.begin() + later.size() / 2, later.end());
    return later[later.size() / 2];
  }
};

void Open(Candidate& candidate, vtkActor* actor, vtkPolyDataMapper* mapper, vtkPolyData* data,
  const int size[2])
{
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  candidate.Renderer->AddActor(actor);
  candidate.Window->SetMultiSamples(0);
  candidate.Window->SetOffScreenRendering(1);
  candidate.Window->SetSize(size[0], size[1]);
  candidate.Window->AddRenderer(candidate.Renderer);
}

/// Pixels in which a channel differs by more than two levels.
std::size_t Differing(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  std::size_t count = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (std::abs(a->GetTypedComponent(i, c) - b->GetTypedComponent(i, c)) > 2)
      {
        ++count;
        break;
      }
    }
  }
  return count;
}
}

int main(int argc, char* argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 3000;
  const int size[2] = { argc > 3 ? std::atoi(argv[2]) : 1280, argc > 3 ? std::atoi(argv[3]) : 720 };
  constexpr int frames = 12;

  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(side);
  source->SetVResolution(side);
  source->SetScalarModeToNone();
  source->GenerateTextureCoordinatesOff();
  source->Update();
  vtkPolyData* data = source->GetOutput();

  Candidate limn{ "Limn, no OpenGL", vtkSmartPointer<vtkLimnRenderWindow>::New(),
    vtkSmartPointer<vtkLimnRenderer>::New(), {}, {} };
  vtkNew<vtkLimnActor> limnActor;
  vtkNew<vtkLimnPolyDataMapper> limnMapper;
  Open(limn, limnActor, limnMapper, data, size);

  Candidate peer{ "VTK's own mapper", vtkSmartPointer<vtkRenderWindow>::New(),
    vtkSmartPointer<vtkOpenGLRenderer>::New(), {}, {} };
  vtkNew<vtkOpenGLActor> peerActor;
  vtkNew<vtkOpenGLPolyDataMapper> peerMapper;
  Open(peer, peerActor, peerMapper, data, size);

  for (Candidate* candidate : { &limn, &peer })
  {
    candidate->Renderer->ResetCamera();
    candidate->Renderer->GetActiveCamera()->Elevation(-50);
    candidate->Renderer->ResetCameraClippingRange();
  }
  std::size_t differing = 0;
  for (int frame = 0; frame < frames; ++frame)
  {
    for (Candidate* candidate : { &limn, &peer })
    {
      candidate->Renderer->GetActiveCamera()->Azimuth(3);
      candidate->Draw();
    }
    differing = std::max(differing, Differing(limn.Pixels, peer.Pixels));
  }

  std::printf("%lld triangles at %d x %d, %d frames\n",
    static_cast<long long>(data->GetNumberOfCells()), size[0], size[1], frames);
  for (const Candidate* candidate : { &limn, &peer })
  {
    std::printf("%-18s first %8.1f ms   median %8.1f ms\n", candidate->Name.c_str(),
      candidate->Milliseconds.front(), candidate->Median());
  }
  std::printf("ratio %.1f, first frames %.1f; at most %zu pixels differ by more than 2 levels\n",
    peer.Median() / limn.Median(), peer.Milliseconds.front() / limn.Milliseconds.front(),
    differing);
  return EXIT_SUCCESS;
}
