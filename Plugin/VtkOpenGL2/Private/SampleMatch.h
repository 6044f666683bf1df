// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SampleMatch_h
#define SampleMatch_h

#include <vector>

/// Offset of a sample from its pixel's lower left corner, in pixels.
struct SamplePoint
{
  double X;
  double Y;
};

/// Where the samples of Limn's pictures lie. Requires: samples is 1, 2, 4 or 8.
std::vector<SamplePoint> LayerSamplePoints(int samples);

/// Where OpenGL has the samples of the framebuffer bound for drawing; empty if it is not
/// multisampled. Requires: a current context.
std::vector<SamplePoint> FramebufferSamplePoints();

/// For each of `to` the index of the sample of `from` that stands for it: the nearest one, and with
/// equal numbers each exactly once, so that no share of a pixel is lost or counted twice.
std::vector<int> MatchSamples(
  const std::vector<SamplePoint>& from, const std::vector<SamplePoint>& to);

#endif
