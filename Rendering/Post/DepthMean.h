// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Post/CuePass.h"

#include <vector>

namespace limn {

/// One row of pixels for the depth unsharp mask. The arrays have paddedWidth() values.
struct UnsharpRow {
  const float* distance;
  const float* pixel;   ///< ViewPoint::pixel
  const float* darken;  ///< strength where x < 0; 0: `light` stays
  const float* lighten;
  float* light;  ///< strength times x
};

/// in[x + k step] by weights[k], first <= k <= last.
struct WeightedSum {
  const float* in;
  std::ptrdiff_t step;
  const float* weights;
  int first, last;
};

/// A row of pixels' blocks; both lines start with a block before the first.
struct UnsharpLines {
  const float* distance;
  const float* weight;
  int width;        ///< pixels
  float side;       ///< of a block
  float lastBlock;  ///< its number
  float sigma;
};

/// The Gaussian mean of a picture's distances, of DepthUnsharp.
class DepthMean {
 public:
  DepthMean(const DistancePlane& distances, float sigma, int threads);

  /// The row's strength times x.
  void shade(int y, const UnsharpRow& row) const;

 private:
  /// A plane of blocks whose rows have zeros at both ends.
  struct Plane {
    std::vector<float> values;
    float* row(const DepthMean& mean, int y) { return values.data() + mean.offsetOf(y); }
    const float* row(const DepthMean& mean, int y) const
    {
      return values.data() + mean.offsetOf(y);
    }
  };

  std::ptrdiff_t offsetOf(int y) const { return y * stride_ + pad_; }
  void sumBlocks(const DistancePlane& distances, int by);
  void convolve(int threads);
  void interpolate(const Plane& plane, int y, std::vector<float>& line) const;

  float sigma_;
  int side_, width_, height_, pixels_, reach_ = 0, pad_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::vector<float> weights_;
  Plane distance_, weight_;
};

}  // namespace limn
