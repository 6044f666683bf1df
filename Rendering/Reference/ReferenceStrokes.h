// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Reference/ReferenceOutline.h"

#include <functional>
#include <vector>

namespace limn::reference {

/// What a line looks like behind the translucent surfaces that are before it.
struct SeenLine {
  Vec3f color;  ///< 0 to 1
  Vec3f radiance;
};
/// Of a line in a pixel, of this depth and of this instance.
using PanesOver =
    std::function<SeenLine(int x, int y, Vec3f color, float depth, std::uint32_t instance)>;

/// Depths of all pixels of a frame, and of so many on all sides of it, row by row from below.
struct WiderDepths {
  int apron;
  std::vector<float> depth;
};

/// How many pixels around the frame show what hides lines of which a part lies in it.
int strokeApron(const Scene& scene);

/// Instance::lines over a picture of all surfaces, by the shortest obvious scalar code: every line
/// against every pixel of its box. The oracle for Lines/DrawStrokes. `depths` are the surfaces', of
/// at least strokeApron(). `layers` are those of the same pixels, whose halos cut what lies behind
/// them, or empty. With `panes`, which may be empty, lines are seen behind translucent surfaces,
/// and those of translucent instances come last.
void drawStrokes(const Scene& scene, const FrameView& frame, const WiderDepths& depths,
                 const std::vector<Layer>& layers, const PanesOver& panes);

}  // namespace limn::reference
