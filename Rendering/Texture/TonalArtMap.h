// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace limn {

/// Strokes for hatching in kTones tones, each a picture of kSide x kSide texels that repeats
/// (Praun, Hoppe, Webb and Finkelstein 2001), the last all ink.
///
/// One picture serves all sizes. The level k of a tone is the picture with texels of size 2^k, for
/// every whole k. Levels are nested as tones are: a stroke of level k + 1 lies upon one of level k.
/// For that, each stroke along row r needs one along all of row 2r; so the darkest rows and columns
/// that a tone has may be broken, and all lighter ones of it go through.
class TonalArtMap {
 public:
  static constexpr int kTones = 6;
  static constexpr int kSide = 128;
  /// From row to row of the second tone, of which a quarter is ink.
  static constexpr int kQuarterSpacing = 8;

  /// Made from a fixed series of random whole numbers.
  TonalArtMap();

  /// The lightest tone, 1 to kTones, of which a texel is ink. Row 0 is the lowest.
  int firstTone(int x, int y) const
  {
    return static_cast<int>(first_[static_cast<std::size_t>(y * kSide + x)]);
  }
  /// The same, row by row.
  const float* firstTones() const { return first_.data(); }
  /// Share of ink of a tone, exact; 0 of tone 0, which is paper.
  float coverage(int tone) const { return coverage_[static_cast<std::size_t>(tone)]; }
  /// 1 / (coverage(tone + 1) - coverage(tone)).
  float perCoverage(int tone) const { return perCoverage_[static_cast<std::size_t>(tone)]; }

 private:
  std::array<float, kSide * kSide> first_;
  std::array<float, kTones + 1> coverage_;
  std::array<float, kTones> perCoverage_;
};

/// The one that all hatching uses; made once.
const TonalArtMap& tonalArtMap();

}  // namespace limn
