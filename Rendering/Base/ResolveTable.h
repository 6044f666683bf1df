// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

/// The average of bytes at gamma 2.2, in integers: byte i stands for (i/255)^2.2, and a mean
/// becomes the byte whose interval ((j-1/2)/255)^2.2 <= mean < ((j+1/2)/255)^2.2 holds it.
class ResolveTable {
 public:
  static constexpr int kUnitBits = 24;  ///< of full intensity
  static constexpr int kMostCount = 16;

  static const ResolveTable& gamma22();

  std::uint32_t linear(std::uint8_t byte) const { return linear_[byte]; }
  /// Requires: `sum` is the sum of `count` linear() values, 1 <= count <= kMostCount.
  std::uint8_t byteOfMean(std::uint32_t sum, std::uint32_t count) const
  {
    // The mean or a little less, without a division.
    const auto mean = static_cast<std::uint32_t>(std::uint64_t{sum} * reciprocal_[count] >> 32);
    unsigned byte = firstGuess_[mean >> kGuessBits];
    // 16 * 2^24 fits an unsigned 32-bit number.
    while (byte < 255 && lowerEnd_[byte + 1] * count <= sum)
      ++byte;
    return static_cast<std::uint8_t>(byte);
  }

 private:
  static constexpr int kGuessBits = 12;
  static constexpr std::uint32_t kGuesses = 1u << (kUnitBits - kGuessBits);

  ResolveTable();

  std::uint32_t linear_[256];
  std::uint32_t reciprocal_[kMostCount + 1];  ///< (2^32 - 1) / count, rounded down
  std::uint32_t lowerEnd_[256];               ///< smallest mean that becomes byte j
  std::uint8_t firstGuess_[kGuesses + 1];  ///< of means from n * 2^kGuessBits on: that byte or less
};

}  // namespace limn
