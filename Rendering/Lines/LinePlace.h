// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenVertex.h"

namespace limn {

/// A point of a line on the screen.
struct LinePoint {
  double x, y;     ///< pixels
  double depth;    ///< window depth
  double tested;   ///< that of the point moved by its slack towards the eye
  double bridged;  ///< likewise by kBridgedSlack times that
  double share;    ///< of the style's width
};

/// The way of a set's points to the screen, in double all along.
class LinePlace {
 public:
  LinePlace(const Camera& camera, const Mat4d& modelToWorld, int width, int height)
      : toClip_(camera.viewToClip * (camera.worldToView * modelToWorld)),
        zBySlack_(camera.viewToClip.m[2][2]),
        wBySlack_(camera.viewToClip.m[3][2]),
        halfWidth_(width / 2.0),
        halfHeight_(height / 2.0)
  {
  }

  /// The segment between two points of the set, without what lies before the near plane. False if
  /// nothing is left, or a point is not finite.
  bool place(const LineSet& set, std::uint32_t p, std::uint32_t q, LinePoint& a, LinePoint& b,
             bool& clipsStart, bool& clipsEnd) const
  {
    Clip from = clip(set, p), to = clip(set, q);
    if (!from.isFinite() || !to.isFinite()) return false;
    const double nearFrom = from.z + from.w, nearTo = to.z + to.w;
    if (nearFrom < 0 && nearTo < 0) return false;
    clipsStart = nearFrom < 0;
    clipsEnd = nearTo < 0;
    const Clip whole = from;
    const double t = nearFrom / (nearFrom - nearTo);
    if (clipsStart) from = mixed(whole, to, t);
    if (clipsEnd) to = mixed(whole, to, t);
    if (from.w < kSmallestW || to.w < kSmallestW) return false;
    a = onScreen(from);
    b = onScreen(to);
    return true;
  }
  /// False where it is before the near plane or not finite.
  bool place(const LineSet& set, std::uint32_t p, LinePoint& a) const
  {
    const Clip point = clip(set, p);
    if (!point.isFinite() || point.z + point.w < 0 || point.w < kSmallestW) return false;
    a = onScreen(point);
    return true;
  }

 private:
  struct Clip {
    double x, y, z, w, slack, share;

    bool isFinite() const
    {
      return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(w);
    }
  };

  Clip clip(const LineSet& set, std::uint32_t p) const
  {
    const Vec3d at = set.points.position(p);
    const auto row = [&](int r) {
      const auto& m = toClip_.m[r];
      return (m[0] * at.x + m[1] * at.y) + (m[2] * at.z + m[3]);
    };
    const double slack = set.slack.empty() ? 0.0 : static_cast<double>(set.slack[p]);
    const double share = set.share.empty() ? 1.0 : static_cast<double>(set.share[p]);
    return {row(0), row(1), row(2), row(3), slack, share};
  }
  static Clip mixed(const Clip& a, const Clip& b, double t)
  {
    return {a.x + t * (b.x - a.x),
            a.y + t * (b.y - a.y),
            a.z + t * (b.z - a.z),
            a.w + t * (b.w - a.w),
            a.slack + t * (b.slack - a.slack),
            a.share + t * (b.share - a.share)};
  }
  LinePoint onScreen(const Clip& clip) const
  {
    const double inverse = 1.0 / clip.w;
    const auto movedBy = [&](double slack) {
      const double z = clip.z + zBySlack_ * slack, w = clip.w + wBySlack_ * slack;
      // Nearer than all that is drawn once it is before the near plane.
      return z + w < 0 || w < kSmallestW ? 0.0 : z / w * 0.5 + 0.5;
    };
    const double tested = movedBy(clip.slack);
    return {clip.x * inverse * halfWidth_ + halfWidth_,
            clip.y * inverse * halfHeight_ + halfHeight_,
            clip.z * inverse * 0.5 + 0.5,
            tested,
            clip.slack > 0 ? movedBy(kBridgedSlack * clip.slack) : tested,
            clip.share};
  }

  Mat4d toClip_;
  double zBySlack_, wBySlack_;
  double halfWidth_, halfHeight_;
};

}  // namespace limn
