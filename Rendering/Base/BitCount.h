// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

/// Samples of a coverage.
inline std::uint32_t bitCount(std::uint32_t bits)
{
  std::uint32_t count = 0;
  for (; bits != 0; bits &= bits - 1)
    ++count;
  return count;
}

}  // namespace limn
