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
  bool endsLight;  ///< of any ray that comes so far

  /// Whether light that comes in next to the caster may go out here again.
  bool isWayOut() const { return isOwn && isNear && !isMatch; }
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
      : isParallel_(light.isParallel), a_(a), e_(b - a), size_(size)
  {
    if (isParallel_) {
      d_ = -light.source;
      normal_ = cross(e_, d_);
      across_ = e_ - d_ * dot(e_, d_);
      scale_ = dot(across_, across_);
      isProper_ = scale_ > kSmallestSine * kSmallestSine * dot(e_, e_);
      contact_ = kShadowContact * size;
    } else {
      l_ = light.source;
      toA_ = a - l_;
      toB_ = b - l_;
      normal_ = cross(toA_, toB_);
      scale_ = dot(normal_, normal_);
      const double farA = dot(toA_, toA_), farB = dot(toB_, toB_);
      isProper_ = scale_ > kSmallestSine * kSmallestSine * (farA * farB);
      far_ = std::sqrt(std::max(farA, farB));
      contact_ = kShadowContact * size / far_;
    }
    if (!(scale_ < HUGE_VAL)) isProper_ = false;
    if (isProper_) prepare();
  }

  bool isProper() const { return isProper_; }
  double contact() const { return contact_; }
  double side(Vec3d p) const { return dot(normal_, p - a_); }

  /// How far behind what ends the light something is not looked at, in w: enough for rounding.
  double apart() const { return std::max(contact_, kShadowRounding); }

  /// Bounds of what a box can have in the half plane: u between u0 and u1, w no more than `most`.
  struct Extent {
    double u0, u1, most;
  };
  /// False only if nothing of it can lie in the half plane between the rays of A and B. Requires:
  /// isProper().
  bool meets(const Box& box, Extent& extent) const
  {
    const Vec3d middle = (box.low + box.high) * 0.5 - a_, half = (box.high - box.low) * 0.5;
    if (std::fabs(through_.at(middle)) > through_.reach(half)) return false;
    if (besideA_.at(middle) + besideA_.reach(half) < 0 ||
        besideB_.at(middle) - besideB_.reach(half) > 0)
      return false;
    const double u = along_.at(middle), uReach = along_.reach(half);
    const double w = toward_.at(middle), wReach = toward_.reach(half);
    extent = {u - uReach, u + uReach, w + wReach};
    if (isParallel_) return true;
    const double near = -(w + wReach), far = -(w - wReach);
    if (near > kShadowNear)
      extent = {extent.u0 < 0 ? extent.u0 / near : extent.u0 / far,
                extent.u1 < 0 ? extent.u1 / far : extent.u1 / near, 1.0 / near - 1.0};
    else
      extent = {0, 1, HUGE_VAL};
    return true;
  }
  /// Whether the light comes to the first of two boxes before it comes to the second.
  bool isBefore(const Box& first, const Box& second) const
  {
    return dot(toward_.of, (first.low + first.high) - (second.low + second.high)) > 0;
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
  /// Linear in a place seen from A.
  struct Functional {
    Functional() = default;
    Functional(Vec3d v, Vec3d origin, double far)
        : of(v),
          size{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)},
          atOrigin(dot(v, origin)),
          rounding(1e-12 * far * std::sqrt(dot(v, v)))
    {
    }
    double at(Vec3d p) const { return dot(of, p) - atOrigin; }
    /// The most by which a box differs from its middle, rounding included.
    double reach(Vec3d half) const { return dot(size, half) + rounding; }

    Vec3d of = {0, 0, 0}, size = {0, 0, 0};
    double atOrigin = 0, rounding = 0;
  };
  void prepare()
  {
    // All of the scene is no farther away than its size, if a little more for curved patches.
    const double far = 4 * size_ + far_;
    const Vec3d none = {0, 0, 0};
    through_ = Functional(normal_, none, far);
    besideA_ = Functional(isParallel_ ? across_ : cross(normal_, toA_), none, far);
    besideB_ = Functional(isParallel_ ? across_ : cross(normal_, toB_), e_, far);
    if (isParallel_) {
      along_ = Functional(across_ * (1.0 / scale_), none, far);
      toward_ = Functional(across_ * (dot(e_, d_) / scale_) - d_, none, far);
    } else {
      const Vec3d ofA = cross(toB_, normal_) * (1.0 / scale_);
      const Vec3d ofB = cross(normal_, toA_) * (1.0 / scale_);
      along_ = Functional(ofB, -toA_, far);
      toward_ = Functional(-(ofA + ofB), -toA_, far);
    }
  }

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
  Vec3d a_, e_;
  Vec3d l_ = {0, 0, 0}, d_ = {0, 0, 0}, toA_ = {0, 0, 0}, toB_ = {0, 0, 0};
  Vec3d normal_ = {0, 0, 0}, across_ = {0, 0, 0};
  double scale_ = 0, contact_ = 0, size_ = 0, far_ = 0;
  Functional through_, besideA_, besideB_;
  Functional along_;   ///< u; of a point's rays u times s = 1 / (1 + w), from the light
  Functional toward_;  ///< w; of a point's rays -s
};

}  // namespace limn
