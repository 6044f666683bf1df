// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of Limn's window without OpenGL, of Limn composited into an OpenGL window, and of
// VTK's own mapper in an OpenGL window, until the picture lies in memory. See limn_benchmark
// --help.
#include "Candidate.h"
#include "Llvmpipe.h"
#include "Measure.h"
#include "Memory.h"
#include "Report.h"
#include "Scaling.h"
#include "Scenes.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
constexpr char kAbout[] =
  "Frame times of Limn beside VTK's own OpenGL mapper, in milliseconds: medians and first frames, "
  "until the picture lies in memory. `ratio` is VTK's time by this one's, and `differ` counts "
  "pixels that differ by more than two levels from Limn's window. Memory is what is used beyond "
  "the "
  "scene's own arrays: `B/tri` after some frames, by triangle, and `peak` while they are made. The "
  "limit is what Limn's kernels "
  "take when all that they read lies in the caches, or what the memory takes for the bytes of mesh "
  "and picture, whichever is more: `full` with all clusters, `oracle` with those that are seen.";

std::vector<SceneMaker> MakersWith(const std::string& name)
{
  std::vector<SceneMaker> makers;
  for (const SceneMaker& maker : SceneMakers())
  {
    if (maker.Name.find(name) != std::string::npos)
    {
      makers.push_back(maker);
    }
  }
  return makers;
}

/// By scene, then by way.
std::vector<std::vector<MemoryUse>> MeasureMemory(const std::vector<SceneMaker>& makers)
{
  std::vector<std::vector<MemoryUse>> uses;
  for (const SceneMaker& maker : makers)
  {
    uses.emplace_back();
    for (const Way& way : Ways())
    {
      uses.back().push_back(MeasureMemory(way, maker));
    }
  }
  return uses;
}

nlohmann::json Benchmark(const std::vector<SceneMaker>& makers, int blocks)
{
  // Children first, while this process has no threads and no OpenGL.
  ChooseFastestLlvmpipe();
  const std::vector<std::vector<MemoryUse>> memory = MeasureMemory(makers);
  const std::string openGL = OpenGLRenderer();
  std::printf("OpenGL is drawn by %s.\n", openGL.c_str());
  nlohmann::json scenes = nlohmann::json::array();
  for (std::size_t i = 0; i < makers.size(); ++i)
  {
    const Scene scene = makers[i].Make();
    SceneResult result = Measure(scene, blocks);
    for (std::size_t way = 0; way < result.Ways.size(); ++way)
    {
      result.Ways[way].Memory = memory[i][way];
    }
    scenes.push_back(ToJson(scene, result));
    Print(scenes.back());
  }
  return { { "OpenGL", openGL }, { "scenes", scenes } };
}

nlohmann::json Scaling()
{
  ChooseFastestLlvmpipe();
  const std::string openGL = OpenGLRenderer();
  return { { "OpenGL", openGL }, { "charts", MeasureScaling() } };
}

void Write(const std::string& path, const nlohmann::json& report)
{
  if (!(std::ofstream(path) << report.dump(2) << std::endl))
  {
    throw std::runtime_error(path + " cannot be written.");
  }
}
}

int main(int argc, char* argv[])
{
  CLI::App app(kAbout);
  std::string only, json, scaling;
  int blocks = 4;
  bool list = false;
  app.add_option("--only", only, "scenes whose name contains this");
  app.add_option("--blocks", blocks, "blocks of five frames a way")->check(CLI::Range(1, 1000));
  app.add_option("--json", json, "also write the figures to this file");
  app.add_option("--scaling", scaling,
    "instead, write to this file how the cost grows with triangles, pixels, samples, actors and "
    "threads");
  app.add_flag("--list", list, "print the scenes' names");
  CLI11_PARSE(app, argc, argv);

  const std::vector<SceneMaker> makers = MakersWith(only);
  if (list)
  {
    for (const SceneMaker& maker : makers)
    {
      std::printf("%s\n", maker.Name.c_str());
    }
    return EXIT_SUCCESS;
  }
  try
  {
    if (!scaling.empty())
    {
      Write(scaling, Scaling());
      return EXIT_SUCCESS;
    }
    const nlohmann::json report = Benchmark(makers, blocks);
    if (!json.empty())
    {
      Write(json, report);
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "limn_benchmark: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
