// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Child.h"

#include <fstream>
#include <stdexcept>
#include <string>

#include <malloc.h>

namespace
{
/// A line of /proc/self/status that is given in KiB.
double StatusBytes(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, key.size(), key) == 0)
    {
      return 1024 * std::stod(line.substr(key.size()));
    }
  }
  throw std::runtime_error("/proc/self/status has no " + key);
}

void ForgetPeak()
{
  if (!(std::ofstream("/proc/self/clear_refs") << "5" << std::flush))
  {
    throw std::runtime_error("/proc/self/clear_refs cannot be written.");
  }
}

std::vector<double> Use(const Way& way, const SceneMaker& maker)
{
  constexpr int kFrames = 3, kSmallSide = 8;
  Candidate(way, TorusScene(kSmallSide, 0)).Draw();
  const Scene scene = maker.Make();
  malloc_trim(0);
  ForgetPeak();
  const double before = StatusBytes("VmRSS:");
  Candidate candidate(way, scene);
  for (int frame = 0; frame < kFrames; ++frame)
  {
    candidate.Draw();
  }
  const double peak = StatusBytes("VmHWM:");
  malloc_trim(0);
  return { peak - before, StatusBytes("VmRSS:") - before };
}
}

MemoryUse MeasureMemory(const Way& way, const SceneMaker& maker)
{
  const std::vector<double> use = InChild([&] { return Use(way, maker); });
  return { use.at(0), use.at(1) };
}
