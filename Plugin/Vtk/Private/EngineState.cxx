// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineState.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cstdlib>
#include <string>

namespace limn::bridge
{
namespace
{

std::string environment(const char* name)
{
  const char* const value = std::getenv(name);
  return value ? value : "";
}

int threadsFromEnvironment()
{
  const std::string text = environment("LIMN_THREADS");
  if (text.empty())
  {
    return 0;
  }
  char* end = nullptr;
  const long threads = std::strtol(text.c_str(), &end, 10);
  constexpr long kMostThreads = 4096;
  if (*end != '\0' || threads < 0 || threads > kMostThreads)
  {
    vtkGenericWarningMacro("LIMN_THREADS is " << text
                                              << "; it has to be a number from 0 (all cores) to "
                                              << kMostThreads << ". Drawing with all cores.");
    return 0;
  }
  return static_cast<int>(threads);
}

void useInstructionSetFromEnvironment()
{
  const std::string name = environment("LIMN_INSTRUCTION_SET");
  if (name.empty() || useTarget(name))
  {
    return;
  }
  std::string names;
  for (const std::string& available : availableTargets())
  {
    names += " " + available;
  }
  vtkGenericWarningMacro("LIMN_INSTRUCTION_SET is " << name << "; this machine has:" << names
                                                    << ". Drawing with " << currentTarget() << ".");
}

Backend backendFromEnvironment()
{
  const std::string name = environment("LIMN_RENDERER");
  if (!name.empty() && name != "reference" && name != "pipeline")
  {
    vtkGenericWarningMacro("LIMN_RENDERER is "
                           << name
                           << "; it has to be pipeline or reference. Drawing with the pipeline.");
  }
  return name == "reference" ? Backend::kReference : Backend::kPipeline;
}

} // namespace

EngineState::EngineState()
{
  this->options.threads = threadsFromEnvironment();
  this->options.backend = backendFromEnvironment();
  useInstructionSetFromEnvironment();
}

EngineState& EngineState::instance()
{
  static EngineState state;
  return state;
}

void EngineState::beginRenderer(vtkRenderer* renderer)
{
  const bool isSameWindow = this->window_ && this->window_ == renderer->GetRenderWindow();
  if (!isSameWindow || this->renderers_.count(renderer) > 0)
  {
    this->figures_ = {};
    this->renderers_.clear();
  }
  this->window_ = renderer->GetRenderWindow();
  this->renderers_.insert(renderer);
}

void EngineState::add(const RenderStats& stats, double prepareMilliseconds)
{
  RenderStats& sum = this->figures_.stats;
  sum.instances += stats.instances;
  sum.clusters += stats.clusters;
  sum.triangles += stats.triangles;
  sum.vertices += stats.vertices;
  sum.binnedClusters += stats.binnedClusters;
  sum.bytes += stats.bytes;
  sum.binMilliseconds += stats.binMilliseconds;
  sum.tileMilliseconds += stats.tileMilliseconds;
  this->figures_.prepareMilliseconds += prepareMilliseconds;
}

} // namespace limn::bridge
