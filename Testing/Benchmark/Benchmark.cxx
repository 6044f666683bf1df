// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frame times of Limn's window without OpenGL, of Limn composited into an OpenGL window, and of
// VTK's own mapper in an OpenGL window, until the picture lies in memory. See limn_benchmark
// --help.
#include "Candidate.h"
#include "Display.h"
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
#include <filesystem>
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

constexpr int kStatusOfUserError = 2;

struct Options
{
  std::string Only, Json, Scaling;
  int Blocks = 4;
  bool List = false;
};

/// For what the user can mend: the message says how.
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

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
  if (makers.empty())
  {
    throw UserError("--only=" + name + ": no scene's name contains this; --list prints the names");
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
    throw UserError(path + " cannot be written");
  }
}

/// Before minutes are spent on what is to be written there.
void RequireWritable(const std::string& path)
{
  const bool existed = std::filesystem::exists(path);
  if (!std::ofstream(path, std::ios::app))
  {
    throw UserError(path + " cannot be written; name a file in a folder that exists");
  }
  if (!existed)
  {
    std::filesystem::remove(path);
  }
}

void RequireDisplay()
{
  // VTK's window would abort the program.
  if (!IsDisplayOpen())
  {
    throw UserError("OpenGL needs an X display, and none can be opened; use ./dev bench, or run "
                    "this by xvfb-run -a -s -noreset");
  }
}

/// The parser would take the next argument for the value.
void RefuseEmptyValues(int argc, char* argv[])
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--", 0) == 0 && argument.find('=') == argument.size() - 1)
    {
      throw UserError(argument + " has no value; see --help");
    }
  }
}

void Run(const Options& options)
{
  const std::vector<SceneMaker> makers = MakersWith(options.Only);
  if (options.List)
  {
    for (const SceneMaker& maker : makers)
    {
      std::printf("%s\n", maker.Name.c_str());
    }
    return;
  }
  const std::string& file = options.Scaling.empty() ? options.Json : options.Scaling;
  if (!file.empty())
  {
    RequireWritable(file);
  }
  RequireDisplay();
  const nlohmann::json report =
    options.Scaling.empty() ? Benchmark(makers, options.Blocks) : Scaling();
  if (!file.empty())
  {
    Write(file, report);
  }
}
}

int main(int argc, char* argv[])
{
  CLI::App app(kAbout);
  Options options;
  app.add_option("--only", options.Only, "scenes whose name contains this");
  app
    .add_option(
      "--blocks", options.Blocks, "blocks of five frames a way, of which the first is not counted")
    ->capture_default_str()
    ->check(CLI::Range(1, 1000));
  app.add_option("--json", options.Json, "also write the figures to this file");
  app.add_option("--scaling", options.Scaling,
    "instead, write to this file how the cost grows with triangles, pixels, samples, actors and "
    "threads");
  app.add_flag("--list", options.List, "print the scenes' names");
  try
  {
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    Run(options);
    return EXIT_SUCCESS;
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == EXIT_SUCCESS ? EXIT_SUCCESS : kStatusOfUserError;
  }
  catch (const UserError& error)
  {
    std::fprintf(stderr, "limn_benchmark: error: %s\n", error.what());
    return kStatusOfUserError;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "limn_benchmark: error: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
