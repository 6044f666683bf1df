// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormap.h"

#include <gtest/gtest.h>

namespace limn::viewer
{
namespace
{

using Bytes = std::array<int, 3>;

Bytes colorAt(const std::string& name, double value)
{
  const unsigned char* const color = makeColormap(name, { -1, 1 })->MapValue(value);
  return { color[0], color[1], color[2] };
}

TEST(Colormap, EndsAndMiddleAreTheColoursOfTheMap)
{
  EXPECT_EQ(colorAt("grayscale", -1), (Bytes{ 0, 0, 0 }));
  EXPECT_EQ(colorAt("grayscale", 1), (Bytes{ 255, 255, 255 }));
  EXPECT_EQ(colorAt("rainbow", -1), (Bytes{ 0, 0, 255 }));
  EXPECT_EQ(colorAt("rainbow", 1), (Bytes{ 255, 0, 0 }));
  EXPECT_EQ(colorAt("black-body", -1), (Bytes{ 0, 0, 0 }));
  EXPECT_EQ(colorAt("black-body", 1), (Bytes{ 255, 255, 255 }));
  EXPECT_EQ(colorAt("viridis", -1), (Bytes{ 68, 1, 84 }));
  EXPECT_EQ(colorAt("viridis", 1), (Bytes{ 253, 231, 37 }));
  EXPECT_EQ(colorAt("cool-warm", -1), (Bytes{ 59, 76, 192 }));
  EXPECT_EQ(colorAt("cool-warm", 1), (Bytes{ 180, 4, 38 }));
}

TEST(Colormap, TheMiddleOfCoolWarmIsNearlyGrey)
{
  const Bytes middle = colorAt("cool-warm", 0);
  EXPECT_NEAR(middle[0], 221, 2);
  EXPECT_NEAR(middle[1], 221, 2);
  EXPECT_NEAR(middle[2], 221, 2);
}

TEST(Colormap, ValuesBeyondTheRangeTakeItsEnds)
{
  EXPECT_EQ(colorAt("viridis", -5), colorAt("viridis", -1));
  EXPECT_EQ(colorAt("viridis", 5), colorAt("viridis", 1));
}

} // namespace
} // namespace limn::viewer
