// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FlatHatching.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Of the border from the first line of strokes, in spacings: half way between the rarest that
/// are drawn in middle light, and on no line.
constexpr double kInset = 3.5;
constexpr int kMostDoublings = 10;
constexpr double kSqrtHalf = 0.70710678118654752;
/// Strokes' points are farther apart where nothing bends; ends within a hundredth of the spacing
/// are one; and shorter strokes than half of it are dots.
constexpr double kStepsAtOnce = 4, kJoint = 0.01, kShortest = 0.5;

/// What a line of strokes has of a triangle.
struct Interval {
  std::int64_t line;
  double begin, end;  ///< along the line
  Vec3d from, to;
  std::uint32_t triangle;
};

class RegionHatcher {
 public:
  RegionHatcher(const MeshView& mesh, const FlatRegions& flats, std::uint32_t number,
                HatchStrokes& strokes)
      : mesh_(mesh), region_(flats.regions[number]), number_(number), strokes_(strokes)
  {
  }

  void hatch(Span<const std::uint32_t> triangles, bool isCross)
  {
    isCross_ = isCross;
    along_ = isCross ? cross(region_.normal, region_.along) : region_.along;
    across_ = cross(region_.normal, along_);
    intervals_.clear();
    for (const std::uint32_t t : triangles)
      cut(t);
    std::sort(intervals_.begin(), intervals_.end(), [](const Interval& a, const Interval& b) {
      if (a.line != b.line) return a.line < b.line;
      return a.begin != b.begin ? a.begin < b.begin : a.triangle < b.triangle;
    });
    join();
  }

 private:
  struct Corner {
    Vec3d p;
    double line, along;
    std::uint32_t vertex;
  };

  void cut(std::uint32_t triangle)
  {
    Corner corner[3];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh_.triangles[triangle].vertex[k];
      const Vec3d p = mesh_.position(v), way = p - region_.origin;
      corner[k] = {p, dot(way, across_) / strokes_.spacing - kInset, dot(way, along_), v};
    }
    const auto [low, high] = std::minmax({corner[0].line, corner[1].line, corner[2].line});
    const auto last = static_cast<std::int64_t>(std::floor(high));
    for (auto line = static_cast<std::int64_t>(std::ceil(low)); line <= last; ++line) {
      Interval one = {line, 0, 0, {}, {}, triangle};
      int count = 0;
      for (int k = 0; k < 3; ++k)
        count += crossSide(corner[k], corner[(k + 1) % 3], count, one) ? 1 : 0;
      if (count != 2) continue;
      if (one.begin > one.end) {
        std::swap(one.begin, one.end);
        std::swap(one.from, one.to);
      }
      intervals_.push_back(one);
    }
  }
  /// Where the line crosses a side, computed alike for both triangles at it.
  static bool crossSide(Corner a, Corner b, int count, Interval& one)
  {
    const auto line = static_cast<double>(one.line);
    if ((a.line < line) == (b.line < line)) return false;
    if (a.vertex > b.vertex) std::swap(a, b);
    const double t = (line - a.line) / (b.line - a.line);
    (count == 0 ? one.begin : one.end) = a.along + (b.along - a.along) * t;
    (count == 0 ? one.from : one.to) = a.p + (b.p - a.p) * t;
    return true;
  }

  void join()
  {
    const double joint = kJoint * strokes_.spacing;
    for (std::size_t i = 0; i < intervals_.size();) {
      Interval all = intervals_[i];
      for (++i; i < intervals_.size() && intervals_[i].line == all.line &&
                intervals_[i].begin <= all.end + joint;
           ++i)
        if (intervals_[i].end > all.end) {
          all.end = intervals_[i].end;
          all.to = intervals_[i].to;
        }
      if (all.end - all.begin >= kShortest * strokes_.spacing) add(all);
    }
  }
  void add(const Interval& stroke)
  {
    const auto pieces =
        static_cast<int>(std::ceil((stroke.end - stroke.begin) / (kStepsAtOnce * strokes_.step)));
    if (strokes_.first.empty()) strokes_.first.push_back(0);
    for (int i = 0; i <= pieces; ++i) {
      strokes_.vertex.push_back(static_cast<std::uint32_t>(strokes_.points.size()));
      strokes_.points.push_back(stroke.from +
                                (stroke.to - stroke.from) * (static_cast<double>(i) / pieces));
      strokes_.triangle.push_back(stroke.triangle);
      strokes_.normals.push_back(vec3Cast<float>(region_.normal));
      strokes_.across.push_back(vec3Cast<float>(across_));
    }
    strokes_.first.push_back(static_cast<std::uint32_t>(strokes_.vertex.size()));
    double rank = kSqrtHalf;
    std::int64_t line = stroke.line;
    for (int k = 0; k < kMostDoublings && line % 2 == 0; ++k) {
      line /= 2;
      rank /= 2;
    }
    strokes_.rank.push_back(static_cast<float>(rank));
    strokes_.isCross.push_back(isCross_ ? 1 : 0);
    strokes_.face.push_back(2 * number_ + (isCross_ ? 1u : 0u));
  }

  const MeshView& mesh_;
  const FlatRegion& region_;
  std::uint32_t number_;
  HatchStrokes& strokes_;
  bool isCross_ = false;
  Vec3d along_ = {}, across_ = {};
  std::vector<Interval> intervals_;
};

}  // namespace

void hatchFlats(const HatchSurface& surface, const FlatRegions& flats, int threads,
                HatchStrokes& strokes)
{
  std::vector<std::vector<std::uint32_t>> triangles(flats.regions.size());
  for (std::uint32_t t = 0; t < flats.ofTriangle.size(); ++t)
    if (flats.isFramed(t)) triangles[flats.ofTriangle[t]].push_back(t);
  std::vector<HatchStrokes> found(flats.regions.size());
  parallelFor(threads, found.size(), [&](std::size_t r) {
    found[r].spacing = strokes.spacing;
    found[r].step = strokes.step;
    RegionHatcher hatcher(surface.curved.mesh, flats, static_cast<std::uint32_t>(r), found[r]);
    for (const bool isCross : {false, true})
      hatcher.hatch(triangles[r], isCross);
  });
  for (const HatchStrokes& some : found)
    strokes.append(some);
}

}  // namespace limn
