// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceLayers.h"

namespace limn {

/// A pixel, and one of the same instance with another id: to its right, or else above it.
struct IdPair {
  int x, y;
  bool isToRight;
};

/// Where the border between two ids is nearest to the middle between the two pixels, along the axis
/// that it runs across: ImageOutline::ids. Pixels from the frame's corner, at most one and a half
/// from either centre. Of borders that are less than a pixel apart it is a guess.
Vec2f placeOfIdBorder(const SurfaceLayers& layers, const IdPair& pair);

}  // namespace limn
