// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedTextures.h"

#include "Rendering/Texture/SampleTexture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

TextureImage imageOf(const GeneratedTexture& texture)
{
  TextureImage image;
  const Status status = image.build(texture.view(), MipChain::kNone);
  EXPECT_TRUE(status.ok()) << status.message;
  return image;
}

/// The greatest change of red between columns that are neighbours across the seam, and elsewhere.
struct Steps {
  float acrossSeam, elsewhere;
};

Steps steps(const TextureImage& image)
{
  Steps most = {0, 0};
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const int next = (x + 1) % image.width();
      float& of = next == 0 ? most.acrossSeam : most.elsewhere;
      of = std::max(of, std::fabs(image.texel(0, x, y).x - image.texel(0, next, y).x));
    }
  return most;
}

TEST(GeneratedTextures, HaveNoSeam)
{
  for (const GeneratedTexture& texture : {brickHeights(), brickNormals(), planet()}) {
    const Steps most = steps(imageOf(texture));
    EXPECT_LE(most.acrossSeam, most.elsewhere);
    EXPECT_GT(most.elsewhere, 0.1f);
  }
}

TEST(GeneratedTextures, NormalsOfBricksAreThoseOfTheirHeights)
{
  const TextureImage heights = imageOf(brickHeights()), normals = imageOf(brickNormals());
  float most = 0;
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x) {
      const int side = heights.width();
      const auto height = [&](int i, int j) {
        return heights.texel(0, (i + side) % side, (j + side) % side).x;
      };
      const float scale = kBrickDepth * static_cast<float>(side) / 2;
      const Vec3f expected = normalized(Vec3f{(height(x - 1, y) - height(x + 1, y)) * scale,
                                              (height(x, y - 1) - height(x, y + 1)) * scale, 1});
      const Vec4f coded = normals.texel(0, x, y);
      EXPECT_NEAR(2 * coded.x - 1, expected.x, 1.01f / 255);
      EXPECT_NEAR(2 * coded.y - 1, expected.y, 1.01f / 255);
      EXPECT_NEAR(2 * coded.z - 1, expected.z, 1.01f / 255);
      most = std::max(most, std::fabs(expected.x));
    }
  EXPECT_GT(most, 0.5f) << "bricks have steep edges";
}

TEST(GeneratedTextures, WindowHasBarsGlassAndHoles)
{
  const TextureImage window = imageOf(leadedWindow());
  int bars = 0, glass = 0, holes = 0;
  for (int y = 0; y < window.height(); ++y)
    for (int x = 0; x < window.width(); ++x) {
      const float alpha = window.texel(0, x, y).w;
      ++(alpha == 1 ? bars : alpha == 0 ? holes : glass);
      // Both diagonals are periods: nothing breaks at the border.
      EXPECT_EQ(window.texel(0, x, y), window.texel(0, (x + 64) % 128, (y + 64) % 128));
    }
  EXPECT_GT(bars, 128 * 128 / 5);
  EXPECT_GT(glass, 128 * 128 / 3);
  EXPECT_GT(holes, 128 * 128 / 8);
}

TEST(GeneratedTextures, GridNamesItsCellsFromTheLowerLeft)
{
  const TextureImage grid = imageOf(uvGrid());
  // The middle of the bar that tells A from H, F from E and 1 from 7.
  const auto isInk = [&](int column, int row, int x, int y) {
    return grid.texel(0, 32 * column + x, 32 * row + y) == Vec4f{1, 1, 1, 1};
  };
  const int left = 5, bottom = 9, size = 2;
  EXPECT_TRUE(isInk(0, 0, left + 2 * size, bottom + 6 * size)) << "the roof of A";
  EXPECT_FALSE(isInk(7, 0, left + 2 * size, bottom + 6 * size)) << "H has none";
  EXPECT_TRUE(isInk(4, 3, left + 4 * size, bottom)) << "the foot of E";
  EXPECT_FALSE(isInk(5, 3, left + 4 * size, bottom)) << "F has none";
  EXPECT_TRUE(isInk(0, 0, left + 8 * size, bottom)) << "the foot of 1";
  EXPECT_FALSE(isInk(0, 6, left + 10 * size, bottom)) << "7 has none there";
  EXPECT_LT(grid.texel(0, 2, 2).x, grid.texel(0, 250, 2).x) << "red grows with u";
  EXPECT_LT(grid.texel(0, 2, 2).y, grid.texel(0, 2, 250).y) << "green grows with v";
}

}  // namespace
}  // namespace limn
