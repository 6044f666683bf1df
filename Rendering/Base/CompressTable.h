// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace limn {

/// For each mask of eight lanes the lanes that are set, in their order, then zeros.
constexpr std::array<std::array<std::uint8_t, 8>, 256> makeLanesOfMask()
{
  std::array<std::array<std::uint8_t, 8>, 256> lanes = {};
  for (std::size_t mask = 0; mask < lanes.size(); ++mask) {
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < 8; ++lane)
      if ((mask >> lane & 1) != 0) lanes[mask][count++] = static_cast<std::uint8_t>(lane);
  }
  return lanes;
}
alignas(64) inline constexpr auto kLanesOfMask = makeLanesOfMask();

}  // namespace limn
