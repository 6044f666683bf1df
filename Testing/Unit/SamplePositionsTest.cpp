// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/SamplePositions.h"

#include <gtest/gtest.h>

#include <set>

namespace limn {
namespace {

TEST(SamplePositions, TheirMeanIsThePixelsCentre)
{
  for (const int samples : {1, 2, 4, 8}) {
    const auto offsets = samplePositions(samples);
    ASSERT_EQ(offsets.size(), static_cast<std::size_t>(samples));
    std::int32_t x = 0, y = 0;
    for (const SampleOffset& offset : offsets) {
      x += offset.x;
      y += offset.y;
    }
    EXPECT_EQ(x, samples * kPixelCentre.x);
    EXPECT_EQ(y, samples * kPixelCentre.y);
  }
}

TEST(SamplePositions, TheMeanOfSixteenIsAThirtySecondLeftAndBelow)
{
  std::int32_t x = 0, y = 0;
  for (const SampleOffset& offset : samplePositions(16)) {
    x += offset.x;
    y += offset.y;
  }
  EXPECT_EQ(x, 16 * (kPixelCentre.x - kSubpixels / 32));
  EXPECT_EQ(y, 16 * (kPixelCentre.y - kSubpixels / 32));
}

TEST(SamplePositions, NoTwoShareARowOrAColumn)
{
  for (const int samples : {1, 2, 4, 8, 16}) {
    std::set<std::int32_t> columns, rows;
    for (const SampleOffset& offset : samplePositions(samples)) {
      columns.insert(offset.x);
      rows.insert(offset.y);
      // Two of 16 lie on the left and lower border, which are the pixel's own.
      const int low = samples == 16 ? 0 : 1;
      EXPECT_TRUE(offset.x >= low && offset.x < kSubpixels && offset.y >= low &&
                  offset.y < kSubpixels);
    }
    EXPECT_EQ(columns.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(samples));
  }
}

}  // namespace
}  // namespace limn
