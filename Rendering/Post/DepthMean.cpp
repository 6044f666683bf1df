// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/DepthMean.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/DepthMean.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/DepthMean-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(weightedSumKernel);
HWY_EXPORT(betweenRowsKernel);
HWY_EXPORT(unsharpKernel);

DepthMean::DepthMean(const DistancePlane& distances, float sigma, int threads)
    : sigma_(sigma),
      side_(std::max(1, static_cast<int>(std::floor(sigma / 8.0f)))),
      width_((distances.width + side_ - 1) / side_),
      height_((distances.height + side_ - 1) / side_),
      pixels_(distances.width)
{
  const float s = sigma / static_cast<float>(side_);
  reach_ = static_cast<int>(std::ceil(3.0f * s));
  for (int k = -reach_; k <= reach_; ++k) {
    const float exponent = -static_cast<float>(k * k) / (2.0f * s * s);
    weights_.push_back(power_detail::exp2Clamped(exponent * 1.44269504f));
  }
  pad_ = reach_ + 1;
  stride_ = static_cast<std::ptrdiff_t>(paddedWidth(width_)) + 2 * pad_;
  distance_.values.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_));
  weight_.values.resize(distance_.values.size());
  parallelFor(threads, static_cast<std::size_t>(height_),
              [&](std::size_t by) { sumBlocks(distances, static_cast<int>(by)); });
  convolve(threads);
}

void DepthMean::sumBlocks(const DistancePlane& distances, int by)
{
  float* const sums = distance_.row(*this, by);
  float* const counts = weight_.row(*this, by);
  for (int y = by * side_; y < std::min((by + 1) * side_, distances.height); ++y) {
    const float* const row = distances.row(y);
    for (int bx = 0; bx < width_; ++bx)
      for (int x = bx * side_; x < std::min((bx + 1) * side_, distances.width); ++x) {
        if (row[x] == DistancePlane::kFar) continue;
        sums[bx] += row[x];
        counts[bx] += 1.0f;
      }
  }
}

void DepthMean::convolve(int threads)
{
  const float* const weights = weights_.data() + reach_;
  const auto width = static_cast<std::size_t>(width_);
  for (Plane* plane : {&distance_, &weight_}) {
    Plane along, both;
    along.values.resize(plane->values.size());
    both.values.resize(plane->values.size());
    const auto forRows = [&](const auto& sumOf, Plane& out) {
      parallelFor(threads, static_cast<std::size_t>(height_), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::vector<float> line(paddedWidth(width_));
        HWY_DYNAMIC_DISPATCH(weightedSumKernel)(sumOf(y), width, line.data());
        std::copy_n(line.data(), width, out.row(*this, y));
      });
    };
    forRows(
        [&](int y) {
          return WeightedSum{plane->row(*this, y), 1, weights, -reach_, reach_};
        },
        along);
    forRows(
        [&](int y) {
          return WeightedSum{along.row(*this, y), stride_, weights, std::max(-reach_, -y),
                             std::min(reach_, height_ - 1 - y)};
        },
        both);
    plane->values.swap(both.values);
  }
}

/// The line of blocks at the height of a row of pixels, with one more at both ends.
void DepthMean::interpolate(const Plane& plane, int y, std::vector<float>& line) const
{
  const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(side_) - 0.5f;
  const float below = std::floor(v);
  const auto rowAt = [&](int by) { return plane.row(*this, std::clamp(by, 0, height_ - 1)); };
  const int first = static_cast<int>(below);
  line.resize(paddedWidth(width_) + 2);
  HWY_DYNAMIC_DISPATCH(betweenRowsKernel)
  (rowAt(first), rowAt(first + 1), v - below, static_cast<std::size_t>(width_), line.data() + 1);
  line[0] = line[1];
  line[static_cast<std::size_t>(width_) + 1] = line[static_cast<std::size_t>(width_)];
}

void DepthMean::shade(int y, const UnsharpRow& row) const
{
  thread_local std::vector<float> distance, weight;
  interpolate(distance_, y, distance);
  interpolate(weight_, y, weight);
  const UnsharpLines lines = {distance.data(),
                              weight.data(),
                              pixels_,
                              static_cast<float>(side_),
                              static_cast<float>(width_ - 1),
                              sigma_};
  HWY_DYNAMIC_DISPATCH(unsharpKernel)(lines, row);
}

}  // namespace limn
#endif  // HWY_ONCE
