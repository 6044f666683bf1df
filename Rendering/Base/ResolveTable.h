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

  static const ResolveTable& gamma22();

  std::uint32_t linear(std::uint8_t byte) const { return linear_[byte]; }
  /// Requires: `sum` is the sum of `count` linear() values, 1 <= count <= 16.
  std::uint8_t byteOfMean(std::uint32_t sum, std::uint32_t count) const;

 private:
  static constexpr int kGuessBits = 12;
  static constexpr std::uint32_t kGuesses = 1u << (kUnitBits - kGuessBits);

  ResolveTable();

  std::uint32_t linear_[256];
  std::uint32_t lowerEnd_[256];            ///< smallest mean that becomes byte j
  std::uint8_t firstGuess_[kGuesses + 1];  ///< of means from n * 2^kGuessBits on: that byte or less
};

}  // namespace limn
