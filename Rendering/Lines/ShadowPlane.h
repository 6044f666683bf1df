// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Vertex/LightRays.h"
#include "Rendering/Vertex/ShadowPiece.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

/// What light meets in the half plane through an edge; u and w as in ShadowPiece.h.
namespace limn {

/// Of an angle between ray and edge below which the edge casts nothing.
inline constexpr double kSmallestSine = 1e-12;

/// What the half plane through an edge and the light has of a triangle.
struct Slice {
  double u0, u1, w0, w1;
  std::uint32_t triangle;
  /// Of a smooth caster's own body, and then whether it is next to the caster and shows light the
  /// side to which that bulges.
  bool isOwn, isNear, isMatch;

  double at(double u) const
  {
    if (u == u0) return w0;
    if (u == u1) return w1;
    return w0 + (w1 - w0) * ((u - u0) / (u1 - u0));
  }
};

/// The half plane through an edge and the light.
class HalfPlane {
 public:
  HalfPlane(const LightRays& light, Vec3d a, Vec3d b, double size)
      : isParallel_(light.isParallel), a_(a), e_(b - a), b_(b), size_(size)
  {
    if (isParallel_) {
      d_ = -light.source;
      normal_ = cross(e_, d_);
      across_ = e_ - d_ * dot(e_, d_);
      scale_ = dot(across_, across_);
      isProper_ = scale_ > kSmallestSine * kSmallestSine * dot(e_, e_);
      contact_ = kShadowContact * size;
      towardA_ = across_;
    } else {
      l_ = light.source;
      toA_ = a - l_;
      toB_ = b - l_;
      normal_ = cross(toA_, toB_);
      scale_ = dot(normal_, normal_);
      const double farA = dot(toA_, toA_), farB = dot(toB_, toB_);
      isProper_ = scale_ > kSmallestSine * kSmallestSine * (farA * farB);
      contact_ = kShadowContact * size / std::sqrt(std::max(farA, farB));
    }
    if (!(scale_ < HUGE_VAL)) isProper_ = false;
  }

  bool isProper() const { return isProper_; }
  double contact() const { return contact_; }
  double side(Vec3d p) const { return dot(normal_, p - a_); }

  /// False only if nothing of it can lie in the half plane between the rays of A and B.
  bool meets(const Box& box) const
  {
    const Vec3d middle = (box.low + box.high) * 0.5, half = (box.high - box.low) * 0.5;
    const auto reach = [&](Vec3d n) {
      return (std::fabs(n.x) * half.x + std::fabs(n.y) * half.y) + std::fabs(n.z) * half.z;
    };
    // What rounding may do to a product with n.
    const double far = size_ + std::sqrt(dot(middle - a_, middle - a_));
    const auto slack = [&](Vec3d n) { return 1e-12 * far * std::sqrt(dot(n, n)); };
    if (std::fabs(dot(normal_, middle - a_)) > reach(normal_) + slack(normal_)) return false;
    const Vec3d besideA = isParallel_ ? towardA_ : cross(normal_, toA_);
    const Vec3d besideB = isParallel_ ? towardA_ : cross(normal_, toB_);
    return dot(besideA, middle - a_) + reach(besideA) + slack(besideA) >= 0 &&
           dot(besideB, middle - b_) - reach(besideB) - slack(besideB) <= 0;
  }

  /// Of the straight line from p to q in the plane, between u = low and high. False if nothing.
  bool slice(Vec3d p, Vec3d q, double low, double high, Slice& slice) const
  {
    if (!place(p, q, slice)) return false;
    if (slice.u0 > slice.u1) {
      std::swap(slice.u0, slice.u1);
      std::swap(slice.w0, slice.w1);
    }
    if (!(slice.u0 < slice.u1) || slice.u1 <= low || slice.u0 >= high) return false;
    const Slice whole = slice;
    if (slice.u0 < low) {
      slice.u0 = low;
      slice.w0 = whole.at(low);
    }
    if (slice.u1 > high) {
      slice.u1 = high;
      slice.w1 = whole.at(high);
    }
    return true;
  }

  Vec3d point(double u, double w) const
  {
    const Vec3d onEdge = a_ + e_ * u;
    return isParallel_ ? onEdge - d_ * w : l_ + (onEdge - l_) * (1.0 / (1.0 + w));
  }

 private:
  bool place(Vec3d p, Vec3d q, Slice& slice) const
  {
    if (isParallel_) {
      const auto uOf = [&](Vec3d x) { return dot(x - a_, across_) / scale_; };
      const auto wOf = [&](Vec3d x, double u) { return u * dot(e_, d_) - dot(x - a_, d_); };
      slice.u0 = uOf(p);
      slice.u1 = uOf(q);
      slice.w0 = wOf(p, slice.u0);
      slice.w1 = wOf(q, slice.u1);
      return true;
    }
    Weights from = weights(p), to = weights(q);
    const double sFrom = from.a + from.b, sTo = to.a + to.b;
    if (sFrom < kShadowNear && sTo < kShadowNear) return false;
    const Weights start = from;
    if (sFrom < kShadowNear) from = mixed(start, to, (kShadowNear - sFrom) / (sTo - sFrom));
    if (sTo < kShadowNear) to = mixed(start, to, (kShadowNear - sFrom) / (sTo - sFrom));
    slice.u0 = from.b / (from.a + from.b);
    slice.u1 = to.b / (to.a + to.b);
    slice.w0 = 1.0 / (from.a + from.b) - 1.0;
    slice.w1 = 1.0 / (to.a + to.b) - 1.0;
    return true;
  }
  /// x = L + a (A - L) + b (B - L)
  struct Weights {
    double a, b;
  };
  Weights weights(Vec3d x) const
  {
    const Vec3d way = x - l_;
    return {dot(cross(way, toB_), normal_) / scale_, dot(cross(toA_, way), normal_) / scale_};
  }
  static Weights mixed(Weights from, Weights to, double t)
  {
    return {from.a + t * (to.a - from.a), from.b + t * (to.b - from.b)};
  }

  bool isParallel_, isProper_ = false;
  Vec3d a_, e_, b_ = {0, 0, 0};
  Vec3d l_ = {0, 0, 0}, d_ = {0, 0, 0}, toA_ = {0, 0, 0}, toB_ = {0, 0, 0};
  Vec3d normal_ = {0, 0, 0}, across_ = {0, 0, 0}, towardA_ = {0, 0, 0};
  double scale_ = 0, contact_ = 0, size_ = 0;
};

inline constexpr std::uint32_t kNoSlice = 0xFFFFFFFFu;

/// A stretch of u in which one slice is before all others.
struct Stretch {
  double u0, u1;
  std::uint32_t slice;
};

/// Which of many slices, in the order of their triangles, is the first that light meets. Goes along
/// u with those that are there, so that of a surface cut at many places few are compared.
class FirstMet {
 public:
  explicit FirstMet(const std::vector<Slice>& slices) : slices_(slices), byStart_(slices.size())
  {
    for (std::size_t i = 0; i < byStart_.size(); ++i)
      byStart_[i] = static_cast<std::uint32_t>(i);
    std::sort(byStart_.begin(), byStart_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return slices_[a].u0 != slices_[b].u0 ? slices_[a].u0 < slices_[b].u0 : a < b;
    });
  }

  /// choose(those there, the nearest to the light first) gives one of them, or kNoSlice.
  template <class Choose>
  std::vector<Stretch> find(const Choose& choose) const
  {
    const std::vector<double> stops = this->stops();
    std::vector<Stretch> result;
    std::vector<std::uint32_t> there;
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double u0 = stops[i], u1 = stops[i + 1];
      while (next < byStart_.size() && slices_[byStart_[next]].u0 <= u0)
        there.push_back(byStart_[next++]);
      leave(u0, there);
      const std::uint32_t first = choose(inOrder(0.5 * (u0 + u1), there));
      if (first == kNoSlice) continue;
      if (!result.empty() && result.back().slice == first && result.back().u1 == u0)
        result.back().u1 = u1;
      else
        result.push_back({u0, u1, first});
    }
    return result;
  }

 private:
  /// Takes out what has ended.
  void leave(double u, std::vector<std::uint32_t>& there) const
  {
    there.erase(std::remove_if(there.begin(), there.end(),
                               [&](std::uint32_t i) { return slices_[i].u1 <= u; }),
                there.end());
  }
  /// Where a slice begins or ends or two cross, each once.
  std::vector<double> stops() const
  {
    std::vector<double> stops;
    std::vector<std::uint32_t> there;
    for (const std::uint32_t i : byStart_) {
      stops.push_back(slices_[i].u0);
      stops.push_back(slices_[i].u1);
      leave(slices_[i].u0, there);
      for (const std::uint32_t j : there)
        addCrossing(slices_[std::min(i, j)], slices_[std::max(i, j)], stops);
      there.push_back(i);
    }
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    return stops;
  }
  static void addCrossing(const Slice& p, const Slice& q, std::vector<double>& stops)
  {
    const double low = std::max(p.u0, q.u0), high = std::min(p.u1, q.u1);
    const double atLow = p.at(low) - q.at(low), atHigh = p.at(high) - q.at(high);
    if ((atLow < 0) != (atHigh < 0))
      stops.push_back(low + (high - low) * (atLow / (atLow - atHigh)));
  }
  std::vector<std::uint32_t> inOrder(double u, std::vector<std::uint32_t> there) const
  {
    std::sort(there.begin(), there.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double wa = slices_[a].at(u), wb = slices_[b].at(u);
      return wa != wb ? wa > wb : a < b;
    });
    return there;
  }

  const std::vector<Slice>& slices_;
  std::vector<std::uint32_t> byStart_;
};

}  // namespace limn
