// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/ResolveTable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

const ResolveTable& table()
{
  return ResolveTable::gamma22();
}

TEST(ResolveTable, EachByteStandsForItsPower)
{
  // In units of 2^-24, rounded to nearest.
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_NEAR(table().linear(static_cast<std::uint8_t>(byte)),
                std::pow(byte / 255.0, 2.2) * 0x1p24, 0.5 + 1e-6);
}

TEST(ResolveTable, TheMeanOfEqualBytesIsThatByte)
{
  for (int byte = 0; byte < 256; ++byte)
    for (std::uint32_t count = 1; count <= 16; ++count) {
      const std::uint32_t sum = count * table().linear(static_cast<std::uint8_t>(byte));
      EXPECT_EQ(table().byteOfMean(sum, count), byte) << count << " samples";
    }
}

TEST(ResolveTable, TheMeanOfAnyTwoBytesIsTheNearestByteToTheExactMean)
{
  for (int a = 0; a < 256; ++a)
    for (int b = a; b < 256; ++b) {
      const std::uint32_t sum = table().linear(static_cast<std::uint8_t>(a)) +
                                table().linear(static_cast<std::uint8_t>(b));
      const double mean = (std::pow(a / 255.0, 2.2) + std::pow(b / 255.0, 2.2)) / 2;
      // The table's steps of 2^-24 shift the end of an interval by a thousandth of it, and by more
      // only where bytes 0 to 2 meet, as their powers are a few steps apart.
      const double slack = b < 8 ? 0.05 : 1e-3;
      ASSERT_NEAR(table().byteOfMean(sum, 2), 255 * std::pow(mean, 1 / 2.2), 0.5 + slack)
          << a << ", " << b;
    }
}

TEST(ResolveTable, AMeanLiesBetweenItsBytes)
{
  for (int a = 0; a < 256; a += 3)
    for (int b = a; b < 256; b += 3)
      for (std::uint32_t share = 0; share <= 8; ++share) {
        const std::uint32_t sum = share * table().linear(static_cast<std::uint8_t>(a)) +
                                  (8 - share) * table().linear(static_cast<std::uint8_t>(b));
        const int mean = table().byteOfMean(sum, 8);
        ASSERT_GE(mean, a);
        ASSERT_LE(mean, b);
      }
}

}  // namespace
}  // namespace limn
