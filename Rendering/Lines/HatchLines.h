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

/// Widest that strokes of hatching get, in widths of one that is not alone: where a flat face's are
/// farther apart than asked.
inline constexpr double kHatchSwell = 1.3;
/// A stroke of the rank r begins where all strokes up to 2 r / 3 would be as dense as asked and has
/// its width where those up to 4 r / 3 are, linear between, so that the ink grows with the
/// darkness.
inline constexpr double kRankBegins = 2.0 / 3, kRankIsWhole = 4.0 / 3;

/// The parts of strokes that are drawn. With the darkness d = darkest (1 - t), t as Hatching has it
/// in the point's smooth normal, turned to the eye, strokes of the first family are
/// spacing / min(1, 2 d) pixels apart, those across them spacing / (2 d - 1) where d is above 1/2,
/// measured across them on the screen. As strokes are spacing of `strokes` / r apart up to a rank
/// r, that takes those up to some rank: the next ones swell towards where they are needed. So
/// strokes stay where they are, and end where it gets lighter. Where the surface turns away from
/// the eye and would crowd them, some end too. No nearer than all strokes of `strokes` are.
///
/// On a flat face where that rank varies less than threefold its geometric mean is taken for all:
/// strokes up to the power of two below it, wider by what it is above, until, from kHatchSwell on,
/// the next ones come in between and take half of the ink over.
///
/// ContourLines::share is of kHatchSwell widths.
ContourLines hatchLines(const HatchStrokes& strokes, const Mat4d& modelToWorld,
                        const HatchView& view, int threads);

}  // namespace limn
