// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scaling.h"

#include "Candidate.h"
#include "Scenes.h"
#include "Stopwatch.h"

#include "vtkLimnEngine.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
struct Point
{
  double X;
  Scene Shown;
};

const Way& Limn = Ways().front();
const Way& Vtk = Ways().back();

double FastestFrame(Candidate& candidate)
{
  constexpr int kFewest = 12;
  constexpr double kMilliseconds = 1500;
  candidate.Draw();
  double fastest = std::numeric_limits<double>::max();
  const Stopwatch time;
  for (int frame = 0; frame < kFewest || time.Milliseconds() < kMilliseconds; ++frame)
  {
    fastest = std::min(fastest, candidate.Draw());
  }
  return fastest;
}

/// Makes scenes one by one, as all of them together may not fit the memory.
nlohmann::json MeasureLine(
  const Way& way, const std::vector<int>& steps, const std::function<Point(int)>& pointOf)
{
  nlohmann::json points = nlohmann::json::array();
  for (const int step : steps)
  {
    const Point point = pointOf(step);
    Candidate candidate(way, point.Shown);
    points.push_back({ point.X, FastestFrame(candidate) });
  }
  return { { "label", way.Name }, { "points", points } };
}

nlohmann::json ByTriangles()
{
  const auto torus = [](int side)
  {
    const Scene scene = TorusScene(side, 0);
    return Point{ static_cast<double>(scene.CountTriangles()), scene };
  };
  return { { "name", "triangles" }, { "x", "triangles" },
    { "lines", { MeasureLine(Limn, { 32, 100, 316, 1000, 2000, 3000, 5000 }, torus),
                 MeasureLine(Vtk, { 32, 100, 316, 1000, 2000 }, torus) } } };
}

nlohmann::json ByPixels()
{
  const auto sphere = [](int height)
  {
    const int width = height * 16 / 9;
    return Point{ static_cast<double>(width) * height, SphereScene(width, height) };
  };
  const std::vector<int> heights = { 90, 180, 360, 720, 1080, 1440, 2160 };
  return { { "name", "pixels" }, { "x", "pixels of the picture" },
    { "lines", { MeasureLine(Limn, heights, sphere), MeasureLine(Vtk, heights, sphere) } } };
}

nlohmann::json BySamples()
{
  constexpr int kSide = 316;
  const auto torus = [](int samples) {
    return Point{ static_cast<double>(samples), TorusScene(kSide, samples > 1 ? samples : 0) };
  };
  // llvmpipe has no other numbers of samples.
  return { { "name", "samples" }, { "x", "samples a pixel" },
    { "lines", { MeasureLine(Limn, { 1, 2, 4, 8 }, torus), MeasureLine(Vtk, { 1, 4 }, torus) } } };
}

nlohmann::json ByActors()
{
  const auto actors = [](int count) {
    return Point{ static_cast<double>(count), ActorsScene(count) };
  };
  const std::vector<int> counts = { 1, 8, 64, 512, 1728, 4096 };
  return { { "name", "actors" }, { "x", "actors of 960 triangles" },
    { "lines", { MeasureLine(Limn, counts, actors), MeasureLine(Vtk, counts, actors) } } };
}

/// Milliseconds of a frame and of its stages; the rest of a frame is VTK's, and the copy that is
/// read from the window.
struct Frame
{
  double Whole = std::numeric_limits<double>::max();
  double Bin = 0, Tiles = 0;
};

/// Numbers of threads take turns, so that the machine's other work meets all of them.
nlohmann::json LineByThreads(const std::string& label, const Scene& scene)
{
  constexpr int kRounds = 40, kAllThreads = 0;
  std::vector<Frame> fastest(static_cast<std::size_t>(limn::resolveThreadCount(kAllThreads)));
  Candidate candidate(Limn, scene);
  candidate.Draw();
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t i = 0; i < fastest.size(); ++i)
    {
      vtkLimnEngine::SetNumberOfThreads(static_cast<int>(i) + 1);
      const double whole = candidate.Draw();
      if (whole < fastest[i].Whole)
      {
        fastest[i] = { whole, vtkLimnEngine::GetBinMilliseconds(),
          vtkLimnEngine::GetTileMilliseconds() };
      }
    }
  }
  vtkLimnEngine::SetNumberOfThreads(kAllThreads);
  nlohmann::json line = { { "label", label } };
  for (std::size_t i = 0; i < fastest.size(); ++i)
  {
    line["points"].push_back({ i + 1, fastest[i].Whole });
    line["stages"].push_back({ { "bin ms", fastest[i].Bin }, { "tiles ms", fastest[i].Tiles } });
  }
  return line;
}

nlohmann::json ByThreads()
{
  nlohmann::json lines = nlohmann::json::array();
  for (const char* name : { "torus 2M", "torus 18M", "sphere 4K", "16 sheets 4K" })
  {
    const auto maker = std::find_if(SceneMakers().begin(), SceneMakers().end(),
      [name](const SceneMaker& candidate) { return candidate.Name == name; });
    lines.push_back(LineByThreads(name, maker->Make()));
  }
  return { { "name", "threads" }, { "x", "threads" }, { "lines", lines } };
}
}

nlohmann::json MeasureScaling()
{
  nlohmann::json charts = nlohmann::json::array();
  for (const auto measure : { ByTriangles, ByPixels, BySamples, ByActors, ByThreads })
  {
    charts.push_back(measure());
    std::printf("%s\n", charts.back().dump().c_str());
    std::fflush(stdout);
  }
  return charts;
}
