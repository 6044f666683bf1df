// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/ResolveTable.h"

#include <cmath>

namespace limn {
namespace {

constexpr double kUnit = 1 << ResolveTable::kUnitBits;

/// x^(1/5) by Newton's iteration, which needs only + - * /.
double fifthRoot(double x)
{
  if (x <= 0.0) return 0.0;
  double root = 1.0;
  for (int step = 0; step < 100; ++step) {
    const double next = (4.0 * root + x / (root * root * root * root)) / 5.0;
    if (next >= root && step > 0) break;
    root = next;
  }
  return root;
}

/// (numerator / 510)^2.2 = t^2 t^(1/5), in units of kUnit, rounded to nearest.
std::uint32_t gamma22Of510ths(int numerator)
{
  const double t = numerator / 510.0;
  return static_cast<std::uint32_t>(std::nearbyint(t * t * fifthRoot(t) * kUnit));
}

}  // namespace

const ResolveTable& ResolveTable::gamma22()
{
  static const ResolveTable table;
  return table;
}

ResolveTable::ResolveTable()
{
  for (int byte = 0; byte < 256; ++byte) {
    linear_[byte] = gamma22Of510ths(2 * byte);
    lowerEnd_[byte] = byte == 0 ? 0 : gamma22Of510ths(2 * byte - 1);
  }
  reciprocal_[0] = 0;
  for (std::uint32_t count = 1; count <= kMostCount; ++count)
    reciprocal_[count] = 0xFFFFFFFFu / count;
  unsigned byte = 0;
  for (std::uint32_t guess = 0; guess <= kGuesses; ++guess) {
    while (byte < 255 && lowerEnd_[byte + 1] <= guess << kGuessBits)
      ++byte;
    firstGuess_[guess] = static_cast<std::uint8_t>(byte);
  }
}

}  // namespace limn
