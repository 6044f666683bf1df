// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

/// How many pixels a picture has, and how many around it are looked at though nobody sees them, for
/// what is made of a pixel's neighbours.
struct Viewport {
  int width, height, apron = 0;
};

}  // namespace limn
