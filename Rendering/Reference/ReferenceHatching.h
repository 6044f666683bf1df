// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

/// The strokes of Tone::kHatching.
namespace limn::reference {

/// At a pixel, and a pixel to the right and above in the triangle's plane.
struct HatchPositions {
  Vec3f here, right, above;
};
struct HatchCoordinates {
  Vec2f here, right, above;
};

/// How strokes are to be drawn at a pixel.
struct HatchTone {
  float darkness;  ///< ink's share in the mean, 0 to 1
  float spacing;   ///< Hatching::spacing
};

/// Ink's share of a pixel. `normal` is unit, or 0.
float hatchInModel(const HatchPositions& position, Vec3f normal, HatchTone tone);
float hatchByTexture(const HatchCoordinates& uv, HatchTone tone);

}  // namespace limn::reference
