// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/ResolveTable.h"
#include "Rendering/Scene.h"

#include <cstdint>

namespace limn {

/// A sum of colours, weighted by counts of samples, and its mean.
class ColorSum {
 public:
  explicit ColorSum(Resolve resolve)
      : table_(resolve == Resolve::kGamma22 ? &ResolveTable::gamma22() : nullptr)
  {
  }

  void add(Rgba8 color, std::uint32_t samples)
  {
    r_ += value(color.r) * samples;
    g_ += value(color.g) * samples;
    b_ += value(color.b) * samples;
    a_ += color.a * samples;
    count_ += samples;
  }
  Rgba8 mean() const { return {byte(r_), byte(g_), byte(b_), linearByte(a_)}; }

 private:
  std::uint32_t value(std::uint8_t byte) const
  {
    return table_ != nullptr ? table_->linear(byte) : byte;
  }
  std::uint8_t byte(std::uint32_t sum) const
  {
    return table_ != nullptr ? table_->byteOfMean(sum, count_) : linearByte(sum);
  }
  std::uint8_t linearByte(std::uint32_t sum) const
  {
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): every fragment covers a sample
    return static_cast<std::uint8_t>((sum + count_ / 2) / count_);
  }

  const ResolveTable* table_;  ///< null: linear
  std::uint32_t r_ = 0, g_ = 0, b_ = 0, a_ = 0, count_ = 0;
};

}  // namespace limn
