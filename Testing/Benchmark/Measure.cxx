// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Candidate.h"
#include "CoreScene.h"

#include "Rendering/Base/Executor.h"

#include "vtkLimnEngine.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace
{
constexpr int kFramesPerBlock = 5;

void DrawBlock(Candidate& candidate, std::vector<double>& milliseconds)
{
  for (int frame = 0; frame < kFramesPerBlock; ++frame)
  {
    candidate.Turn();
    const double time = candidate.Draw();
    if (frame > 0)
    {
      milliseconds.push_back(time);
    }
  }
}

/// Milliseconds of the fastest of some frames of the same view.
double FastestFrame(Candidate& candidate)
{
  double fastest = std::numeric_limits<double>::max();
  for (int frame = 0; frame < kFramesPerBlock; ++frame)
  {
    fastest = std::min(fastest, candidate.Draw());
  }
  return fastest;
}

double MedianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}
}

SceneResult Measure(const Scene& scene, int blocks)
{
  std::vector<std::unique_ptr<Candidate>> candidates;
  std::vector<std::vector<double>> frames(Ways().size());
  SceneResult result;
  result.HasLimit = scene.HasLimit();
  const int samples = std::max(scene.Samples, 1);
  for (const Way& way : Ways())
  {
    candidates.push_back(std::make_unique<Candidate>(way, scene));
    result.Ways.push_back({ way.Name, candidates.back()->Draw() });
    if (candidates.back()->SamplesPerPixel() != samples)
    {
      throw std::runtime_error(way.Name + " draws with " +
                               std::to_string(candidates.back()->SamplesPerPixel()) +
                               " samples a pixel, and not with " + std::to_string(samples) + ".");
    }
  }
  Candidate& limn = *candidates.front();
  const std::size_t pixels = static_cast<std::size_t>(scene.Width) * scene.Height;
  const auto differing = [&](const unsigned char* picture)
  { return CountDiffering(limn.Pixels->GetPointer(0), picture, pixels); };
  const int threads = limn::resolveThreadCount(vtkLimnEngine::GetNumberOfThreads());
  CoreScene replayed(limn.Renderer, samples);
  std::vector<limn::Rgba8> color;
  std::vector<double> ofFull, ofOracle;
  for (int block = 0; block < blocks; ++block)
  {
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      DrawBlock(*candidates[i], frames[i]);
      // The cameras have come to the same place.
      result.Ways[i].DifferingPixels =
        std::max(result.Ways[i].DifferingPixels, differing(candidates[i]->Pixels->GetPointer(0)));
    }
    if (!result.HasLimit)
    {
      continue;
    }
    result.Bound = MeasureLimit({ replayed.Look(), scene.Width, scene.Height, threads }, color);
    result.ReplayDifferingPixels =
      std::max(result.ReplayDifferingPixels, differing(&color.front().r));
    const double frame = FastestFrame(limn);
    ofFull.push_back(result.Bound.Milliseconds(result.Bound.Full) / frame);
    ofOracle.push_back(result.Bound.Milliseconds(result.Bound.Oracle) / frame);
  }
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    result.Ways[i].MedianMilliseconds = MedianOf(frames[i]);
  }
  if (result.HasLimit)
  {
    result.OfFullLimit = MedianOf(ofFull);
    result.OfOracleLimit = MedianOf(ofOracle);
  }
  return result;
}
