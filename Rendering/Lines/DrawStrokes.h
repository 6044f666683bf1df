// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Binning/TileGrid.h"
#include "Rendering/FrameView.h"
#include "Rendering/Lines/ApronDepths.h"
#include "Rendering/Lines/Panes.h"
#include "Rendering/Lines/SurfaceLayers.h"
#include "Rendering/Scene.h"

namespace limn {

/// Whether any instance has lines.
bool hasLines(const Scene& scene);

/// Pixels outside of which no stroke has any; empty if x0 >= x1.
TileRectangle boundStrokes(const Scene& scene, int width, int height, int threads);

/// What the strokes of a frame are drawn from.
struct StrokePass {
  const Scene& scene;
  const FrameView& frame;       ///< with the finished surfaces
  const ApronDepths& around;    ///< of strokeApron() pixels, or more
  const SurfaceLayers* layers;  ///< the frame's, or null; their halos take from the coverage
  /// Or null. Through them a line is seen that is behind translucent surfaces of other instances,
  /// and lines of translucent instances are drawn after all others.
  const Panes* panes;
  int threads;
};

/// Draws the scene's lines over its finished surfaces, which the frame holds, as Instance::lines
/// says: the bytes of Reference/ReferenceStrokes. With Background::kBlend colours become
/// C + (line - C) a with a the coverage times the opacity, and the radiance likewise; with
/// kKeepApart, and a plane of coverage, those of the covered samples, while round(a n) of the n
/// uncovered samples become covered, by the line alone. With FrameView::linePixels all of these do
/// where a is 1, and none elsewhere, where a line makes the premultiplied color P of the samples,
/// alpha too, into P + (line - P) a, in float until all lines are drawn. Depths become those of the
/// nearest line where a >= 1/2, or the pixel was not covered before, and it is nearer.
void drawStrokes(const StrokePass& pass);

}  // namespace limn
