// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ShadowPlane.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace limn {

inline constexpr std::uint32_t kNoSlice = 0xFFFFFFFFu;

/// A stretch of u in which one slice is before all others.
struct Stretch {
  double u0, u1;
  std::uint32_t slice;
};

/// How far light comes at most, in kShadowSteps steps from u = low to u = high: to tell early what
/// it does not come to.
class LightFront {
 public:
  void start(double low, double high);
  void add(const Slice& slice);

  double low() const { return low_; }
  double high() const { return high_; }
  /// Where a step begins, and the last one ends.
  double at(int step) const
  {
    return step == kShadowSteps ? high_ : low_ + (high_ - low_) * (step * (1.0 / kShadowSteps));
  }
  /// Whether light does not come to the caster there.
  bool isDark(int step) const { return least_[step] >= 0; }
  bool isDark(double u) const;
  bool isAllDark() const { return lit_ == 0; }

  enum class Light { kComes, kEndsBefore, kIsDark };
  /// What is known of light that comes to the extent: whether it ends more than `apart` before all
  /// of it, or is not even at the caster.
  Light lightAt(const HalfPlane::Extent& extent, double apart) const;

 private:
  double low_ = 0, high_ = 1;
  int lit_ = 0;                      ///< steps that are not dark
  double least_[kShadowSteps] = {};  ///< by step: w that light does not get behind
};

/// Which of many slices, in the order of their triangles, is the first that light meets.
///
/// They are told apart between stops: where one begins or ends, or two cross, unless light ends
/// more than `apart` before that place or does not come to the caster. So the cost is that of what
/// light can come to: u is halved until few such slices are left, each half without those that lie
/// behind one that reaches over all of it.
class FirstMet {
 public:
  /// At slices, which are borrowed, and all of which `front` has been given.
  void look(const std::vector<Slice>& slices, const LightFront& front, double apart);

  /// choose(those there that may be met, the nearest to the light first; whether one of the others
  /// there isWayOut(), as a function) gives one of them, or kNoSlice.
  template <class Choose>
  void find(const Choose& choose, std::vector<Stretch>& result)
  {
    result.clear();
    if (parts_.empty()) return;
    std::size_t part = 0;
    enter(part);
    for (std::size_t i = 0; i + 1 < stops_.size(); ++i) {
      const double u0 = stops_[i], u1 = stops_[i + 1], middle = 0.5 * (u0 + u1);
      while (part + 1 < parts_.size() && middle >= parts_[part].high)
        enter(++part);
      if (!holds(parts_[part], middle)) continue;
      order(parts_[part], u0, u1);
      const std::uint32_t first = choose(there_, [&] { return isWayOutBehind(part, u0, u1); });
      if (first == kNoSlice) continue;
      if (!result.empty() && result.back().slice == first && result.back().u1 == u0)
        result.back().u1 = u1;
      else
        result.push_back({u0, u1, first});
    }
  }

 private:
  static constexpr std::size_t kFew = 12;
  static constexpr int kDeepest = 24;
  /// No more slices are looked at in all halves together than so many times their number.
  static constexpr std::size_t kMostWork = 64;

  /// A part of u, and its slices in parted_.
  struct Part {
    double low, high;
    std::size_t first, end;
  };

  /// The first and the last also what rounding moves out of the caster.
  bool holds(const Part& part, double u) const
  {
    return (u >= part.low || part.low <= low_) && (u < part.high || part.high >= high_);
  }
  void split(double low, double high, std::size_t begin, int depth);
  void dropHidden(double low, double high, std::size_t begin);
  void addPart(double low, double high, std::size_t begin);
  void addStops(const Part& part);
  bool isHidden(const Part& part, const Slice& slice, double u) const;
  void enter(std::size_t part);
  void order(const Part& part, double u0, double u1);
  bool isWayOutBehind(std::size_t part, double u0, double u1) const;

  const std::vector<Slice>* slices_ = nullptr;
  double low_ = 0, high_ = 1, apart_ = 0;
  std::size_t work_ = 0;
  std::vector<std::uint32_t>
      halves_;  ///< slices of the halves that are being split, one on another
  std::vector<Part> parts_;
  std::vector<std::uint32_t> parted_;
  std::vector<std::uint32_t> waysOut_;
  std::vector<std::size_t> lastPart_;  ///< by slice: the last entered that has it, from 1
  std::vector<double> stops_;
  std::vector<std::uint32_t> there_;
  std::vector<double> depth_;  ///< by slice: w where they are told apart
};

}  // namespace limn
