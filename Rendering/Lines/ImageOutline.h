// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Lines/SurfaceLayers.h"

namespace limn {

/// What the lines of a frame are drawn from.
struct OutlinePass {
  const Scene& scene;
  const FrameView& frame;
  const SurfaceLayers& layers;
  PixelRectangle touched;  ///< all pixels that have layers lie in it, also those of the apron
  int threads;
};

/// Makes the layers as large as the frame and, if there are outlines or halos, `apron` pixels
/// around it.
void beginLayers(const Scene& scene, const FrameView& frame, int apron, SurfaceLayers& layers);

/// Draws the lines of Style::imageOutline over the finished picture. Gives the bytes of
/// Reference/ReferenceOutline, with any number of threads.
void drawImageOutlines(const OutlinePass& pass);

}  // namespace limn
