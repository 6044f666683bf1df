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

TEST(SamplePositions, NoTwoShareARowOrAColumn)
{
  for (const int samples : {1, 2, 4, 8}) {
    std::set<std::int32_t> columns, rows;
    for (const SampleOffset& offset : samplePositions(samples)) {
      columns.insert(offset.x);
      rows.insert(offset.y);
      EXPECT_TRUE(offset.x > 0 && offset.x < kSubpixels && offset.y > 0 && offset.y < kSubpixels);
    }
    EXPECT_EQ(columns.size(), static_cast<std::size_t>(samples));
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(samples));
  }
}

}  // namespace
}  // namespace limn
