// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of Limn's window without OpenGL, of Limn composited into an OpenGL window, and of
// VTK's own mapper in an OpenGL window, until the picture lies in memory. See limn_benchmark
// --help.
#include "Scenes.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double MedianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// One way of drawing the scenes.
struct Way
{
  std::string Name;
  vtkSmartPointer<vtkRenderWindow> (*MakeWindow)();
  vtkSmartPointer<vtkRenderer> (*MakeRenderer)();
  vtkSmartPointer<vtkActor> (*MakeActor)();
  vtkSmartPointer<vtkPolyDataMapper> (*MakeMapper)();
};

template <class Base, class Class>
vtkSmartPointer<Base> Make()
{
  return vtkSmartPointer<Class>::New();
}

const Way Ways[] = {
  { "limn", Make<vtkRenderWindow, vtkLimnRenderWindow>, Make<vtkRenderer, vtkLimnRenderer>,
    Make<vtkActor, vtkLimnActor>, Make<vtkPolyDataMapper, vtkLimnPolyDataMapper> },
  { "limn-in-gl", Make<vtkRenderWindow, vtkRenderWindow>, Make<vtkRenderer, vtkOpenGLRenderer>,
    Make<vtkActor, vtkLimnActor>, Make<vtkPolyDataMapper, vtkLimnPolyDataMapper> },
  { "vtk-gl", Make<vtkRenderWindow, vtkRenderWindow>, Make<vtkRenderer, vtkOpenGLRenderer>,
    Make<vtkActor, vtkOpenGLActor>, Make<vtkPolyDataMapper, vtkOpenGLPolyDataMapper> },
};

/// A scene in a window of one kind, seen from a camera that goes round it.
class Candidate
{
public:
  Candidate(const Way& way, const Scene& scene) : Name(way.Name)
  {
    this->Window = way.MakeWindow();
    this->Renderer = way.MakeRenderer();
    this->Window->SetMultiSamples(scene.Samples);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(scene.Width, scene.Height);
    this->Window->AddRenderer(this->Renderer);
    for (const Part& part : scene.Parts)
    {
      vtkSmartPointer<vtkPolyDataMapper> mapper = way.MakeMapper();
      mapper->SetInputData(part.Data);
      mapper->ScalarVisibilityOff();
      vtkSmartPointer<vtkActor> actor = way.MakeActor();
      actor->SetMapper(mapper);
      actor->SetPosition(part.Position[0], part.Position[1], part.Position[2]);
      this->Renderer->AddActor(actor);
    }
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Elevation(scene.Elevation);
    this->Renderer->GetActiveCamera()->Zoom(scene.Zoom);
    this->Renderer->ResetCameraClippingRange();
  }

  /// Returns milliseconds.
  double Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(3);
    this->Renderer->ResetCameraClippingRange();
    const auto start = Clock::now();
    this->Window->Render();
    const int* size = this->Window->GetSize();
    this->Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, this->Pixels);
    return MillisecondsSince(start);
  }

  std::string Name;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkUnsignedCharArray> Pixels;
  double First = 0;
  std::vector<double> Later;
};

/// Pixels in which a channel differs by more than two levels.
std::size_t Differing(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  std::size_t count = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    bool differs = false;
    for (int c = 0; c < 3; ++c)
    {
      differs |= std::abs(a->GetTypedComponent(i, c) - b->GetTypedComponent(i, c)) > 2;
    }
    count += differs;
  }
  return count;
}

/// Each way draws a block of frames, in turn: a frame straight after another way's finds the caches
/// full of that way's data, and its threads still at work. The first of each block is not counted.
nlohmann::json Measure(const Scene& scene, const std::vector<const Way*>& ways, int blocks)
{
  constexpr int kFramesPerBlock = 5;
  std::vector<std::unique_ptr<Candidate>> candidates;
  for (const Way* way : ways)
  {
    candidates.push_back(std::make_unique<Candidate>(*way, scene));
    candidates.back()->First = candidates.back()->Draw();
  }
  std::size_t differing = 0;
  for (int block = 0; block < blocks; ++block)
  {
    for (auto& candidate : candidates)
    {
      for (int frame = 0; frame < kFramesPerBlock; ++frame)
      {
        const double milliseconds = candidate->Draw();
        if (frame > 0)
        {
          candidate->Later.push_back(milliseconds);
        }
      }
      // The cameras have come to the same place.
      differing = std::max(differing, Differing(candidates.front()->Pixels, candidate->Pixels));
    }
  }
  nlohmann::json result = { { "scene", scene.Name }, { "triangles", scene.CountTriangles() },
    { "actors", scene.Parts.size() }, { "width", scene.Width }, { "height", scene.Height },
    { "samples", scene.Samples }, { "differing pixels", differing } };
  for (const auto& candidate : candidates)
  {
    result[candidate->Name] = { { "median ms", MedianOf(candidate->Later) },
      { "first ms", candidate->First } };
  }
  return result;
}

/// Who draws for OpenGL, as it calls itself.
std::string OpenGLRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  const std::string report = window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:";
  const std::size_t at = report.find(key);
  const std::size_t from = at == std::string::npos ? report.size() : at + key.size();
  return report.substr(from, report.find('\n', from) - from);
}

void PrintHead()
{
  std::printf("OpenGL is drawn by%s; frame times in milliseconds\n", OpenGLRenderer().c_str());
  std::printf("%-34s %9s | %8s %8s | %8s %8s | %8s %8s | %6s %6s %6s | %6s\n", "scene", "triangles",
    "limn", "first", "in gl", "first", "vtk-gl", "first", "ratio", "in gl", "first", "differ");
}

void Print(const nlohmann::json& r)
{
  const auto of = [&](const char* way, const char* what)
  { return r.contains(way) ? r[way][what].get<double>() : 0.0; };
  const double limn = of("limn", "median ms"), inGl = of("limn-in-gl", "median ms"),
               peer = of("vtk-gl", "median ms");
  std::printf(
    "%-34s %9lld | %8.1f %8.0f | %8.1f %8.0f | %8.1f %8.0f | %5.1fx %5.1fx %5.1fx | %6lld\n",
    r["scene"].get<std::string>().c_str(), r["triangles"].get<long long>(), limn,
    of("limn", "first ms"), inGl, of("limn-in-gl", "first ms"), peer, of("vtk-gl", "first ms"),
    peer / limn, peer / inGl, of("vtk-gl", "first ms") / of("limn", "first ms"),
    r["differing pixels"].get<long long>());
  std::fflush(stdout);
}
}

int main(int argc, char* argv[])
{
  CLI::App app("Frame times of Limn beside VTK's own OpenGL mapper, in milliseconds: medians and "
               "first frames, until the picture lies in memory. `differ` counts pixels that differ "
               "by more than two levels from Limn's window.");
  std::string only, json;
  int blocks = 4;
  bool list = false;
  app.add_option("--only", only, "scenes whose name contains this");
  app.add_option("--blocks", blocks, "blocks of five frames a way")->check(CLI::Range(1, 1000));
  app.add_option("--json", json, "also write the figures to this file");
  app.add_flag("--list", list, "print the scenes' names");
  CLI11_PARSE(app, argc, argv);

  nlohmann::json results = nlohmann::json::array();
  if (!list)
  {
    PrintHead();
  }
  for (const SceneMaker& maker : SceneMakers())
  {
    if (maker.Name.find(only) == std::string::npos)
    {
      continue;
    }
    if (list)
    {
      std::printf("%s\n", maker.Name.c_str());
      continue;
    }
    const Scene scene = maker.Make();
    results.push_back(Measure(scene, { &Ways[0], &Ways[1], &Ways[2] }, blocks));
    Print(results.back());
  }
  if (!json.empty())
  {
    std::ofstream(json) << results.dump(2) << '\n';
  }
  return EXIT_SUCCESS;
}
