// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

/// Sets round-to-nearest-even and gradual underflow for the calling thread, whatever the host
/// program chose (llvmpipe and -ffast-math libraries flush denormals), and restores on destruction.
class FloatMode {
 public:
  FloatMode();
  ~FloatMode();
  FloatMode(const FloatMode&) = delete;
  FloatMode& operator=(const FloatMode&) = delete;

 private:
  std::uint64_t saved_;
};

}  // namespace limn
