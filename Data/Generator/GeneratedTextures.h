// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Texture/TextureImage.h"

#include <cstdint>
#include <vector>

/// The textures of Data/Textures, made from formulas, the same bytes everywhere. All but toonRamp()
/// and litSphere() repeat without a seam.
namespace limn {

struct GeneratedTexture {
  int width, height, components;
  std::vector<std::uint8_t> texels;  ///< rows from the lowest up

  TextureView view() const
  {
    return {width, height, components, TexelFormat::kUnorm8, texels.data(), texels.size()};
  }
};

/// 8 x 8 cells; A1 is at the lower left, letters run along u and numbers along v, red grows with u
/// and green with v. 256 x 256, RGB.
GeneratedTexture uvGrid();
/// Heights of a wall of bricks, mortar low. 128 x 128, one channel.
GeneratedTexture brickHeights();
/// The normals of brickHeights(): (n + 1) / 2 of n = (-d b_u, -d b_v, 1) / its length, (b_u, b_v)
/// the heightGradient() at each texel and d = kBrickDepth. 128 x 128, RGB.
GeneratedTexture brickNormals();
inline constexpr float kBrickDepth = 0.03f;
/// Seas, land and ice of a planet by longitude and latitude. 256 x 128, RGB.
GeneratedTexture planet();
/// A leaded window: opaque bars about lozenges of coloured glass, every third of which is broken
/// and lets all through. 128 x 128, RGBA.
GeneratedTexture leadedWindow();
/// Four inks by the tone to the right, which upwards grow from one pale wash to full contrast. 128
/// x 64, RGB.
GeneratedTexture toonRamp();
/// A sphere of glazed clay that fills the picture, lit warm from the upper left, cool from the
/// lower right. 128 x 128, RGB.
GeneratedTexture litSphere();

}  // namespace limn
