// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of Limn's window without OpenGL, of Limn composited into an OpenGL window, and of
// VTK's own mapper in an OpenGL window, until the picture lies in memory. See limn_benchmark
// --help.
#include "Measure.h"
#include "Report.h"
#include "Scenes.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace
{
/// Who draws for OpenGL, as it calls itself.
std::string OpenGLRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  const std::string report = window->ReportCapabilities();
  const std::string key = "OpenGL renderer string:";
  const std::size_t at = report.find(key);
  if (at == std::string::npos)
  {
    return {};
  }
  const std::size_t from = report.find_first_not_of(' ', at + key.size());
  return report.substr(from, report.find('\n', from) - from);
}

constexpr char kAbout[] =
  "Frame times of Limn beside VTK's own OpenGL mapper, in milliseconds: medians and first frames, "
  "until the picture lies in memory. `ratio` is VTK's time by this one's, and `differ` counts "
  "pixels that differ by more than two levels from Limn's window. The limit is what Limn's kernels "
  "take when all that they read lies in the caches, or what the memory takes for the bytes of mesh "
  "and picture, whichever is more: `full` with all clusters, `oracle` with those that are seen.";
}

int main(int argc, char* argv[])
{
  CLI::App app(kAbout);
  std::string only, json;
  int blocks = 4;
  bool list = false;
  app.add_option("--only", only, "scenes whose name contains this");
  app.add_option("--blocks", blocks, "blocks of five frames a way")->check(CLI::Range(1, 1000));
  app.add_option("--json", json, "also write the figures to this file");
  app.add_flag("--list", list, "print the scenes' names");
  CLI11_PARSE(app, argc, argv);

  std::vector<SceneMaker> chosen;
  for (const SceneMaker& maker : SceneMakers())
  {
    if (maker.Name.find(only) != std::string::npos)
    {
      chosen.push_back(maker);
    }
  }
  if (list)
  {
    for (const SceneMaker& maker : chosen)
    {
      std::printf("%s\n", maker.Name.c_str());
    }
    return EXIT_SUCCESS;
  }

  nlohmann::json report = { { "OpenGL", OpenGLRenderer() } };
  std::printf("OpenGL is drawn by %s.\n", report["OpenGL"].get<std::string>().c_str());
  for (const SceneMaker& maker : chosen)
  {
    const Scene scene = maker.Make();
    report["scenes"].push_back(ToJson(scene, Measure(scene, blocks)));
    Print(report["scenes"].back());
  }
  if (!json.empty())
  {
    std::ofstream(json) << report.dump(2) << '\n';
  }
  return EXIT_SUCCESS;
}
