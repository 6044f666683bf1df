// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InteractiveSamples.h"

#include "Rendering/Mesh/ClusteredMesh.h"

#include "vtkRenderer.h"

namespace limn::bridge
{
namespace
{

/// Nanoseconds on two cores with AVX-512, as ./dev bench finds them.
double reckonedNanoseconds(double triangles, double pixels, int samples)
{
  return triangles * (2.0 + 1.4 * samples) + pixels * (3.0 + 3.0 * samples);
}

} // namespace

int interactiveSamples(const Scene& scene, vtkRenderer* renderer, int wanted)
{
  constexpr double kStill = 1.0;
  const double seconds = renderer->GetAllocatedRenderTime();
  if (seconds >= kStill)
  {
    return wanted;
  }
  double triangles = 0;
  for (const Instance& instance : scene.instances)
  {
    // A hull is some triangles along the outline of a mesh that is counted itself.
    const auto count = instance.hull ? 0 : static_cast<double>(instance.clusters->triangleCount);
    const bool isTranslucent = instance.material.opacity < 1 || instance.style.readsAlpha;
    // None of them hides another, and all are shaded.
    constexpr double kTranslucent = 10;
    triangles += isTranslucent ? kTranslucent * count : count;
  }
  int size[2];
  renderer->GetTiledSize(&size[0], &size[1]);
  const double pixels = static_cast<double>(size[0]) * size[1];
  int samples = wanted;
  while (samples > 1 && reckonedNanoseconds(triangles, pixels, samples) > 1e9 * seconds)
  {
    samples /= 2;
  }
  return samples;
}

} // namespace limn::bridge
