// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Llvmpipe.h"

#include "Candidate.h"
#include "Child.h"
#include "Scenes.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace
{
constexpr char kThreadsName[] = "LP_NUM_THREADS", kWidthName[] = "LP_NATIVE_VECTOR_WIDTH";

struct Setting
{
  std::string Threads, Width;

  void Use() const
  {
    setenv(kThreadsName, this->Threads.c_str(), 1);
    setenv(kWidthName, this->Width.c_str(), 1);
  }
};

std::vector<std::string> ValuesOf(const char* name, const std::set<int>& choices)
{
  if (const char* given = std::getenv(name))
  {
    return { given };
  }
  std::vector<std::string> values;
  for (const int choice : choices)
  {
    values.push_back(std::to_string(choice));
  }
  return values;
}

std::vector<Setting> Settings()
{
  constexpr int kMostThreads = 32; // of llvmpipe
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  std::set<int> threads;
  for (const int count : { 0, 1, cores - 1, cores, cores + 1 })
  {
    threads.insert(std::clamp(count, 0, kMostThreads));
  }
  std::vector<Setting> settings;
  for (const std::string& width : ValuesOf(kWidthName, { 256, 512 }))
  {
    for (const std::string& count : ValuesOf(kThreadsName, threads))
    {
      settings.push_back({ count, width });
    }
  }
  return settings;
}

double BestFrame(const Scene& scene)
{
  constexpr int kFrames = 6;
  Candidate candidate(Ways().back(), scene);
  candidate.Draw();
  double best = std::numeric_limits<double>::max();
  for (int frame = 0; frame < kFrames; ++frame)
  {
    best = std::min(best, candidate.Draw());
  }
  return best;
}

/// Milliseconds for a frame of many triangles and one of many pixels, which take about as long;
/// infinite if it cannot draw all scenes: Mesa 22.3 ends the program where vectors of 512 bits meet
/// multisampling.
double TimeOf(const Setting& setting)
{
  constexpr int kSide = 300, kSmallSide = 30, kSamples = 4, kWidth = 1920, kHeight = 1080;
  setting.Use();
  try
  {
    return InChild(
      []
      {
        BestFrame(TorusScene(kSmallSide, kSamples));
        return std::vector<double>{ BestFrame(TorusScene(kSide, 0)) +
                                    BestFrame(SphereScene(kWidth, kHeight)) };
      })
      .at(0);
  }
  catch (const std::runtime_error&)
  {
    return std::numeric_limits<double>::infinity();
  }
}
}

void ChooseFastestLlvmpipe()
{
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  const std::vector<Setting> settings = Settings();
  Setting fastest = settings.front();
  double best = std::numeric_limits<double>::max();
  for (const Setting& setting : settings)
  {
    const double time = settings.size() > 1 ? TimeOf(setting) : 0;
    if (time < best)
    {
      best = time;
      fastest = setting;
    }
  }
  fastest.Use();
}

std::string OpenGLRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  const std::string report = window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:";
  const std::size_t at = report.find(key);
  const std::size_t from =
    at == std::string::npos ? report.size() : report.find_first_not_of(' ', at + key.size());
  const std::string name = report.substr(from, report.find('\n', from) - from);
  const std::string bits = std::getenv(kWidthName) + std::string(" bits");
  if (name.find("llvmpipe") != 0 || name.find(bits) == std::string::npos)
  {
    throw std::runtime_error(
      "OpenGL is drawn by \"" + name + "\", and not by llvmpipe with " + bits + ".");
  }
  return name + ", LP_NUM_THREADS=" + std::getenv(kThreadsName);
}
