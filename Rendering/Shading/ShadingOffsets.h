// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/SamplePositions.h"

#include <hwy/base.h>

#include <cstdint>

namespace limn {

/// Offsets of the shading point in the pixel, by coverage: the pixel's centre for all samples,
/// which surround it, else the first sample; so never outside the triangle.
class ShadingOffsets {
 public:
  explicit ShadingOffsets(int samples)
      : all_((1u << samples) - 1u), offsets_(samplePositions(samples))
  {
  }

  SampleOffset operator[](std::uint32_t coverage) const
  {
    return coverage == all_ ? kPixelCentre : offsets_[hwy::Num0BitsBelowLS1Bit_Nonzero32(coverage)];
  }

 private:
  std::uint32_t all_;
  Span<const SampleOffset> offsets_;
};

}  // namespace limn
