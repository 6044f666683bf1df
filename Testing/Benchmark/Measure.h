// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Measure_h
#define Measure_h

#include "Limit.h"
#include "Memory.h"
#include "Scenes.h"

#include <cstddef>
#include <string>
#include <vector>

struct WayResult
{
  std::string Name;
  double FirstMilliseconds = 0;
  double MedianMilliseconds = 0;
  MemoryUse Memory = {};
  std::size_t DifferingPixels = 0; ///< from the first way's pictures; the most of any
};

struct SceneResult
{
  std::vector<WayResult> Ways;
  bool HasLimit = false; ///< Scene::HasLimit()
  Limit Bound;
  /// Limit by frame time of the first way, medians of the blocks' ratios. The frames show what the
  /// limit was measured on, and of them, as of the limit's runs, the fastest counts.
  double OfFullLimit = 0, OfOracleLimit = 0;
  std::size_t ReplayDifferingPixels = 0; ///< of the picture that the limit's kernels drew
};

/// Each way draws a block of frames, in turn: a frame straight after another way's finds the caches
/// full of that way's data, and its threads still at work. The first of each block is not counted.
/// The limit is measured anew in each block. Leaves Memory to the caller. Throws if a window has
/// not the samples that it was asked for.
SceneResult Measure(const Scene& scene, int blocks);

#endif
