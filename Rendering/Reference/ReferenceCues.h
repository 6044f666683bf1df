// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Reference/ReferenceOutline.h"

#include <vector>

namespace limn::reference {

/// Whether depth cues change anything in a frame with the instance.
bool hasCues(const Instance& instance);

/// How many pixels around the frame decide on the halos in it.
int haloApron(const Scene& scene);

/// Draws the cues of Rendering/DepthCues.h, pixel after pixel. `layers` are those of all pixels of
/// the frame, whose colours change with its, and which learn of the halos over them, and of so many
/// around it, at least haloApron(), row by row.
void drawCues(const Scene& scene, const FrameView& frame, std::vector<Layer>& layers, int apron);

/// What a halo has of a translucent surface.
struct HaloOverPane {
  float share = 0;
  Vec3f color = {0, 0, 0};
};

/// The halos over a frame, once drawCues() has found them, among layers of the same apron.
class HalosOverPanes {
 public:
  HalosOverPanes(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers,
                 int apron)
      : scene_(scene),
        columns_(frame.width + 2 * apron),
        apron_(apron),
        layers_(layers),
        toView_(scene.camera, frame.width, frame.height)
  {
  }
  /// Of a translucent surface in a pixel, at a depth of the window.
  HaloOverPane at(int x, int y, float depth) const;

 private:
  float widthOver(float distance, const Layer& border) const;
  const Halo& haloOf(const Layer& border) const;
  float coveredShare(const Layer& border) const;

  const Scene& scene_;
  int columns_, apron_;
  const std::vector<Layer>& layers_;
  ScreenToView toView_;
};

}  // namespace limn::reference
