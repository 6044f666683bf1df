// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CircleSeeds.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kMostSteps = 65536;
/// Profiles of a sphere run together towards its poles, until some end, and are so many times as
/// long in all as at their distance half way.
constexpr double kProfilesMore = 1.1;

}  // namespace

SeedLine::SeedLine(const SurfaceWalk& walk, std::uint32_t triangle, bool isCross, double step)
    : walk_(&walk), axis_(SurfaceWalk::axisOf(walk.circlesAt(triangle))), step_(step)
{
  WalkPoint start;
  if (axis_ == Vec3d{0, 0, 0} || !walk.seed(triangle, start)) return;
  findProfile(start);
  if (isCross) findCircle();
}

/// From the lowest place that is reached to the highest.
void SeedLine::findProfile(WalkPoint start)
{
  go(start, -1);
  std::reverse(points_.begin(), points_.end());
  for (WalkPoint& point : points_)
    point.direction = -point.direction;
  if (!points_.empty()) points_.pop_back();
  go(start, 1);
  length_ = static_cast<double>(points_.empty() ? 0 : points_.size() - 1) * step_;
}
void SeedLine::go(WalkPoint from, double way)
{
  from.direction = axis_ * way;
  from.direction = walk_->fieldAt(from, true);
  for (double height = -1e300; points_.size() < kMostSteps;) {
    const double here = dot(from.position, axis_) * way;
    if (!(here > height)) return;
    points_.push_back(from);
    height = here;
    if (!walk_->stepAlong(from, true, step_)) return;
  }
}

/// The one through the middle of the profile.
void SeedLine::findCircle()
{
  if (points_.empty()) return;
  WalkPoint point = points_[points_.size() / 2];
  point.direction = walk_->fieldAt(point, false);
  const WalkPoint start = point;
  points_.assign(1, start);
  isCircle_ = true;
  bool hasTurned = false;
  while (points_.size() < kMostSteps && walk_->stepAlong(point, false, step_)) {
    const Vec3d toStart = start.position - point.position;
    hasTurned = hasTurned || dot(point.direction, start.direction) < 0;
    if (hasTurned && dot(toStart, toStart) < step_ * step_) {
      length_ = static_cast<double>(points_.size()) * step_ + dot(toStart, point.direction);
      return;
    }
    points_.push_back(point);
  }
  length_ = 0;
}

WalkPoint SeedLine::at(double share) const
{
  const double steps = share * length_ / step_;
  const std::size_t before = std::min(static_cast<std::size_t>(steps), points_.size() - 1);
  WalkPoint point = points_[before];
  walk_->stepAlong(point, !isCircle_, (steps - static_cast<double>(before)) * step_);
  return point;
}

std::vector<WalkPoint> SeedLine::next(double distance)
{
  std::vector<WalkPoint> seeds;
  if (count_ > 0) {
    ++halvings_;
  } else {
    // Of shorter ones the circles would be too short to be drawn, and later seeds too near.
    if (!(length_ >= distance)) return seeds;
    count_ = std::floor(length_ / distance + 0.5);
  }
  const double all = count_ * std::ldexp(1.0, halvings_);
  density_ = distance * all / length_ * (isCircle_ ? kProfilesMore : 1.0);
  // On a profile the first are half of a distance away from its ends, the next in the middle
  // between them, and from then on ends count as if they were there.
  const bool isFirst = halvings_ == 0, isSecond = halvings_ == 1;
  const auto number = static_cast<std::size_t>(all);
  const auto add = [&](double i) { seeds.push_back(at(i / all)); };
  if (isFirst)
    for (std::size_t i = 0; i < number; ++i)
      add(static_cast<double>(i) + (isCircle_ ? 0.0 : 0.5));
  else
    for (std::size_t i = isSecond && !isCircle_ ? 2 : 1; i < number; i += 2)
      add(static_cast<double>(i));
  return seeds;
}

}  // namespace limn
