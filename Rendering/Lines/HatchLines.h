// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/TraceHatching.h"

namespace limn {

/// What decides how dense strokes are in one frame.
struct HatchView {
  const Camera& camera;
  Vec3f ambientLight;  ///< I_a times k_a
  Span<const Light> lights;
  bool fallOff;         ///< as Style::fallOff
  ToneLight toneLight;  ///< as Style::toneLight
  int height;           ///< of the picture, in pixels
  float spacing;        ///< of the first family where half of the light arrives, in pixels
  float darkest;        ///< as Hatching::darkest
};

/// The parts of strokes that are drawn. With the darkness d = darkest (1 - t), t as Hatching has it
/// in the point's smooth normal, turned to the eye, strokes of the first family are
/// spacing / min(1, 2 d) pixels apart, those across them spacing / (2 d - 1) where d is above 1/2,
/// measured across them on the screen: a stroke is drawn where its rank is below what that takes.
/// So strokes stay where they are, and end where it gets lighter. Where the surface turns away from
/// the eye and would crowd them, some end too. No nearer than all strokes of `strokes` are. On a
/// flat face where that distance varies less than threefold its geometric mean is taken for all.
ContourLines hatchLines(const HatchStrokes& strokes, const Mat4d& modelToWorld,
                        const HatchView& view, int threads);

}  // namespace limn
