// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/TraceHatching.h"

#include "Rendering/Lines/CircleSeeds.h"
#include "Rendering/Lines/FlatHatching.h"
#include "Rendering/Lines/SurfaceWalk.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_map>

namespace limn {
namespace {

constexpr int kRounds = 6;
/// Strokes end where another of their family is nearer than this share of their distance, and
/// begin where none is nearer than the second; of a SeedLine, which is divided in whole parts, the
/// third.
constexpr double kNearest = 0.6, kApart = 0.95, kApartInLine = 0.75;
/// Ranks, as shares of a round's highest: about 3/4, so that its strokes begin where those before
/// are as dense as asked and are as wide as they where all together are. Apart enough for strokes
/// that end in one light not to end in line.
constexpr double kLowest = 0.7, kHighest = 0.8;
/// No nearer than this to where a stroke was too short is another one tried.
constexpr double kTried = 0.2;
constexpr std::size_t kMostSteps = 4096;
constexpr int kMostTurns = 4;
/// Vertices tried as first points of strokes in each round.
constexpr std::size_t kMostSeeds = 65536;

/// Points of strokes by where they lie.
class PointGrid {
 public:
  explicit PointGrid(double cell) : cell_(cell) {}

  struct Entry {
    Vec3d point, normal;
  };
  void add(const Entry& entry)
  {
    const auto [place, isNew] = cells_.try_emplace(keyOf(entry.point, 0, 0, 0), kNone);
    entries_.push_back({entry, place->second});
    place->second = static_cast<std::uint32_t>(entries_.size() - 1);
  }

  /// Whether a point is nearer than `distance`, at most a cell, on the same side of the surface.
  bool isNear(Vec3d p, Vec3d normal, double distance) const
  {
    for (int i = 0; i < 27; ++i) {
      const auto found = cells_.find(keyOf(p, i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
      if (found == cells_.end()) continue;
      for (std::uint32_t k = found->second; k != kNone; k = entries_[k].next) {
        const Entry& entry = entries_[k].entry;
        const Vec3d way = entry.point - p;
        if (dot(way, way) < distance * distance && dot(entry.normal, normal) > 0) return true;
      }
    }
    return false;
  }

 private:
  std::uint64_t keyOf(Vec3d p, int dx, int dy, int dz) const
  {
    const auto part = [&](double x, int d) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell_)) + d +
                                        (std::int64_t{1} << 20)) &
             0x1FFFFFu;
    };
    return (part(p.x, dx) << 42) | (part(p.y, dy) << 21) | part(p.z, dz);
  }

  struct Link {
    Entry entry;
    std::uint32_t next;  ///< of the same cell
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  double cell_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_;
  std::vector<Link> entries_;
};

/// Strokes keep apart from those on the same side: where nothing tells the sides, all of them would
/// run beside each other without end.
bool hasSides(Vec3d normal)
{
  return dot(normal, normal) > 0;  // not of NaN
}

/// One family of strokes.
class FamilyTracer {
 public:
  FamilyTracer(const SurfaceWalk& walk, const FlatRegions& flats, bool isCross,
               HatchStrokes& strokes)
      : walk_(walk), flats_(flats), isCross_(isCross), strokes_(strokes)
  {
  }

  void trace(Vec3d origin)
  {
    origin_ = origin;
    for (const std::uint32_t triangle : walk_.circledTriangles())
      seedLines_.emplace_back(walk_, triangle, isCross_, strokes_.step);
    for (int round = 0; round < kRounds; ++round) {
      distance_ = strokes_.spacing * static_cast<double>(1 << (kRounds - 1 - round));
      high_ = 1.0 / static_cast<double>(1 << (kRounds - 1 - round));
      PointGrid grid(distance_), tried(kTried * distance_);
      grid_ = &grid;
      tried_ = &tried;
      for (std::size_t s = 0; s < strokes_.strokeCount(); ++s)
        enter(s);
      traceRound();
    }
  }

 private:
  void traceRound()
  {
    seeds_.clear();
    for (SeedLine& line : seedLines_) {
      const std::vector<WalkPoint> seeds = line.next(distance_);
      density_ = line.density();
      for (const WalkPoint& seed : seeds)
        traceFrom(seed, kApartInLine);
    }
    density_ = 1;
    for (std::size_t s = 0; s < strokes_.strokeCount(); ++s)
      seedBeside(s);
    traceSeeds();
    const std::size_t count = walk_.seedCount(), stride = count / kMostSeeds + 1;
    for (std::size_t i = 0; i < count; i += stride) {
      WalkPoint seed;
      if (flats_.isFramed(i) || !walk_.seed(i, seed)) continue;
      seeds_.push_back(seed);
      traceSeeds();
    }
  }
  void traceSeeds()
  {
    for (; !seeds_.empty(); seeds_.pop_front())
      traceFrom(seeds_.front(), kApart);
  }

  void traceFrom(const WalkPoint& seed, double apart)
  {
    const Vec3d normal = walk_.normalAt(seed);
    if (!hasSides(normal) || grid_->isNear(seed.position - origin_, normal, apart * distance_) ||
        tried_->isNear(seed.position - origin_, normal, kTried * distance_))
      return;
    Course course = follow(seed, {1, 0}, nullptr);
    // On a mesh, which is not smooth, rings become spirals; turned back by what they stray by.
    double drift = 0;
    Course turned = course;
    for (int i = 0; i < kMostTurns && turned.isReturn && !turned.isClosed; ++i) {
      drift += turned.drift;
      turned = follow(seed, {1, drift}, nullptr);
    }
    if (turned.isClosed) course = std::move(turned);
    std::vector<WalkPoint> all;
    if (!course.isClosed) {
      const Course backward = follow(seed, {-1, 0}, &course.points);
      all.assign(backward.points.rbegin(), backward.points.rend());
    }
    all.push_back(seed);
    all.insert(all.end(), course.points.begin(), course.points.end());
    // Shorter ones are dots; so are rings about a pole.
    const bool isShort = static_cast<double>(all.size()) * strokes_.step < 2 * distance_;
    if (isShort && (!course.isClosed || walk_.circlesAt(seed.triangle) != 0)) {
      tried_->add({seed.position - origin_, normal});
      return;
    }
    add(all, course.isClosed);
    enter(strokes_.strokeCount() - 1);
    seedBeside(strokes_.strokeCount() - 1);
  }

  struct Start {
    int way;       ///< 1 or -1 times the field's direction
    double drift;  ///< as stepAlong() has it
  };
  struct Course {
    std::vector<WalkPoint> points;  ///< after the seed
    bool isClosed = false;          ///< comes back to the seed
    bool isReturn = false;          ///< or passes it at its side
    double drift = 0;               ///< that would have closed it
  };

  /// `other` are the points of the same stroke on the seed's other side.
  Course follow(const WalkPoint& seed, Start start, const std::vector<WalkPoint>* other) const
  {
    Course course;
    std::vector<WalkPoint>& points = course.points;
    WalkPoint at = seed;
    at.direction = walk_.fieldAt(seed, isCross_) * static_cast<double>(start.way);
    const Vec3d first = at.direction;
    PointGrid own(distance_);
    const std::size_t turn = static_cast<std::size_t>(std::ceil(distance_ / strokes_.step)) + 2;
    if (other != nullptr)
      for (std::size_t i = turn; i < other->size(); i += every())
        own.add({(*other)[i].position - origin_, walk_.normalAt((*other)[i])});
    while (points.size() < kMostSteps) {
      const Vec3d before = at.position;
      const bool isOn = walk_.stepAlong(at, isCross_, strokes_.step, start.drift);
      const Vec3d moved = at.position - before;
      // To a border strokes go.
      if (!isOn && !(dot(moved, moved) > 1e-6 * strokes_.step * strokes_.step)) break;
      const Vec3d normal = walk_.normalAt(at), p = at.position - origin_;
      if (!hasSides(normal)) break;
      if (points.size() > turn && closes(at, seed, first, course)) break;
      if (grid_->isNear(p, normal, kNearest * distance_) ||
          own.isNear(p, normal, kNearest * distance_))
        break;
      points.push_back(at);
      if (!isOn) break;
      // What lies this far behind is no longer the stroke's own neighbourhood. To its first
      // points it may come back.
      if (points.size() > 4 * turn && points.size() % every() == 0) {
        const WalkPoint& behind = points[points.size() - 2 * turn];
        own.add({behind.position - origin_, walk_.normalAt(behind)});
      }
    }
    return course;
  }

  /// Whether a stroke has come back to its seed, or past it, less than its distance aside.
  bool closes(const WalkPoint& at, const WalkPoint& seed, Vec3d first, Course& course) const
  {
    const Vec3d toStart = seed.position - at.position;
    const double squared = dot(toStart, toStart), along = dot(toStart, at.direction);
    if (!(squared < distance_ * distance_) || !(dot(at.direction, first) > 0.9)) return false;
    const Vec3d gap = toStart - at.direction * along;
    if (squared < strokes_.step * strokes_.step) {
      course.isClosed = true;
      closeGap(gap, course.points);
      return true;
    }
    if (!(std::fabs(along) < strokes_.step)) return false;
    course.isReturn = true;
    const Vec3d left = cross(walk_.normalAt(at), at.direction);
    course.drift = dot(gap, left) / (static_cast<double>(course.points.size()) * strokes_.step);
    return true;
  }

  /// What the walk has strayed to the side, less than a step, is spread over all of a ring.
  static void closeGap(Vec3d gap, std::vector<WalkPoint>& points)
  {
    const double share = 1.0 / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].position = points[i].position + gap * (static_cast<double>(i + 1) * share);
  }

  void add(const std::vector<WalkPoint>& points, bool isClosed)
  {
    const auto firstPoint = static_cast<std::uint32_t>(strokes_.points.size());
    if (strokes_.first.empty()) strokes_.first.push_back(0);
    for (const WalkPoint& p : points) {
      const Vec3d normal = walk_.normalAt(p);
      strokes_.vertex.push_back(static_cast<std::uint32_t>(strokes_.points.size()));
      strokes_.points.push_back(p.position);
      strokes_.triangle.push_back(p.triangle);
      strokes_.normals.push_back(vec3Cast<float>(normal));
      strokes_.across.push_back(vec3Cast<float>(walk_.fieldAt(p, !isCross_)));
    }
    if (isClosed) strokes_.vertex.push_back(firstPoint);
    strokes_.first.push_back(static_cast<std::uint32_t>(strokes_.vertex.size()));
    // Numerical Recipes' series modulo 2^32; its upper bits are good.
    random_ = random_ * 1664525u + 1013904223u;
    const double share = (static_cast<double>(random_ >> 8) + 1) / 16777216.0;
    const double rank = high_ * density_ * (kLowest + (kHighest - kLowest) * share);
    strokes_.rank.push_back(static_cast<float>(std::min(rank, 1.0)));
    strokes_.isCross.push_back(isCross_ ? 1 : 0);
    strokes_.face.push_back(HatchStrokes::kNoFace);
  }
  /// Of the points of a stroke those that say where it is, a fifth of the distance apart.
  std::uint32_t every() const
  {
    return std::max(1u, static_cast<std::uint32_t>(0.2 * distance_ / strokes_.step));
  }
  void enter(std::size_t stroke)
  {
    for (std::uint32_t i = strokes_.first[stroke]; i < strokes_.first[stroke + 1]; i += every()) {
      const std::uint32_t p = strokes_.vertex[i];
      grid_->add({strokes_.points[p] - origin_, vec3Cast<double>(strokes_.normals[p])});
    }
  }
  /// Points at the strokes' distance to both sides.
  void seedBeside(std::size_t stroke)
  {
    const auto every = static_cast<std::uint32_t>(std::ceil(2 * distance_ / strokes_.step));
    for (std::uint32_t i = strokes_.first[stroke]; i < strokes_.first[stroke + 1]; i += every)
      for (const double way : {1.0, -1.0}) {
        const std::uint32_t p = strokes_.vertex[i];
        WalkPoint at = {strokes_.triangle[p], strokes_.points[p],
                        vec3Cast<double>(strokes_.across[p]) * way};
        bool isOn = true;
        for (double left = distance_; left > 0 && isOn; left -= strokes_.step)
          isOn = walk_.stepAlong(at, !isCross_, std::min(left, strokes_.step));
        if (isOn) seeds_.push_back(at);
      }
  }

  const SurfaceWalk& walk_;
  const FlatRegions& flats_;
  bool isCross_;
  HatchStrokes& strokes_;
  Vec3d origin_ = {0, 0, 0};
  double distance_ = 0, high_ = 0;
  double density_ = 1;  ///< of the strokes that are traced, in those that the round has
  PointGrid* grid_ = nullptr;
  PointGrid* tried_ = nullptr;  ///< where the round's strokes would be too short
  std::deque<WalkPoint> seeds_;
  std::vector<SeedLine> seedLines_;
  std::uint32_t random_ = 40961u;
};

}  // namespace

HatchStrokes traceHatching(const HatchSurface& surface, const HatchField& field, int threads)
{
  HatchStrokes strokes;
  const Box box = finiteBox(surface.curved.mesh, threads);
  if (box.empty()) return strokes;
  const Vec3d diagonal = box.high - box.low;
  strokes.spacing = kHatchDensity * std::sqrt(dot(diagonal, diagonal));
  strokes.step = 0.75 * strokes.spacing;
  if (!(strokes.spacing > 0)) return strokes;
  const SurfaceWalk walk(surface, field);
  HatchStrokes family[2] = {strokes, strokes};
  parallelFor(threads, 2, [&](std::size_t f) {
    FamilyTracer(walk, field.flats, f == 1, family[f]).trace(box.low);
  });
  hatchFlats(surface, field.flats, threads, strokes);
  for (const HatchStrokes& some : family)
    strokes.append(some);
  return strokes;
}

}  // namespace limn
