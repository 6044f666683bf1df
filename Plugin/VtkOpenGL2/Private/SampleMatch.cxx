// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleMatch.h"

#include "Rendering/Base/SamplePositions.h"

#include "vtk_glew.h"

#include <cstddef>
#include <limits>

std::vector<SamplePoint> LayerSamplePoints(int samples)
{
  std::vector<SamplePoint> points;
  for (const limn::SampleOffset& offset : limn::samplePositions(samples))
  {
    points.push_back({ double(offset.x) / limn::kSubpixels, double(offset.y) / limn::kSubpixels });
  }
  return points;
}

std::vector<SamplePoint> FramebufferSamplePoints()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  std::vector<SamplePoint> points;
  for (GLint sample = 0; sample < samples; ++sample)
  {
    GLfloat position[2] = { 0.5f, 0.5f };
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(sample), position);
    points.push_back({ position[0], position[1] });
  }
  return points;
}

std::vector<int> MatchSamples(
  const std::vector<SamplePoint>& from, const std::vector<SamplePoint>& to)
{
  const bool eachOnce = from.size() == to.size();
  std::vector<bool> taken(from.size(), false);
  std::vector<int> match;
  for (const SamplePoint& target : to)
  {
    std::size_t nearest = 0;
    double nearestDistance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      const double dx = from[i].X - target.X;
      const double dy = from[i].Y - target.Y;
      const double distance = dx * dx + dy * dy;
      if (!taken[i] && distance < nearestDistance)
      {
        nearest = i;
        nearestDistance = distance;
      }
    }
    taken[nearest] = eachOnce;
    match.push_back(static_cast<int>(nearest));
  }
  return match;
}
