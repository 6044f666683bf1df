// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/TraceHatching.h"

#include "Rendering/Lines/SurfaceWalk.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_map>

namespace limn {
namespace {

constexpr int kRounds = 4;
/// Strokes end where another of their family is nearer than this share of their distance, and
/// begin where none is nearer than the second.
constexpr double kNearest = 0.6, kApart = 0.95;
constexpr std::size_t kMostSteps = 4096;
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

/// One family of strokes.
class FamilyTracer {
 public:
  FamilyTracer(const SurfaceWalk& walk, bool isCross, HatchStrokes& strokes)
      : walk_(walk), isCross_(isCross), strokes_(strokes)
  {
  }

  void trace(Vec3d origin)
  {
    origin_ = origin;
    for (int round = 0; round < kRounds; ++round) {
      distance_ = strokes_.spacing * static_cast<double>(1 << (kRounds - 1 - round));
      high_ = 1.0 / static_cast<double>(1 << (kRounds - 1 - round));
      low_ = round == 0 ? 0.0 : high_ / 2;
      PointGrid grid(distance_);
      grid_ = &grid;
      for (std::size_t s = 0; s < strokes_.strokeCount(); ++s)
        enter(s);
      traceRound();
    }
  }

 private:
  void traceRound()
  {
    seeds_.clear();
    for (std::size_t s = 0; s < strokes_.strokeCount(); ++s)
      seedBeside(s);
    traceSeeds();
    const std::size_t count = walk_.seedCount(), stride = count / kMostSeeds + 1;
    for (std::size_t i = 0; i < count; i += stride) {
      WalkPoint seed;
      if (!walk_.seed(i, seed)) continue;
      seeds_.push_back(seed);
      traceSeeds();
    }
  }
  void traceSeeds()
  {
    for (; !seeds_.empty(); seeds_.pop_front())
      traceFrom(seeds_.front());
  }

  void traceFrom(const WalkPoint& seed)
  {
    const Vec3d normal = walk_.normalAt(seed);
    if (grid_->isNear(seed.position - origin_, normal, kApart * distance_)) return;
    bool isClosed = false;
    std::vector<WalkPoint> forward = follow(seed, 1, nullptr, isClosed), backward;
    if (!isClosed) backward = follow(seed, -1, &forward, isClosed);
    std::vector<WalkPoint> all(backward.rbegin(), backward.rend());
    all.push_back(seed);
    all.insert(all.end(), forward.begin(), forward.end());
    // Shorter ones are dots.
    if (static_cast<double>(all.size()) * strokes_.step < 2 * distance_ && !isClosed) return;
    add(all, isClosed);
    enter(strokes_.strokeCount() - 1);
    seedBeside(strokes_.strokeCount() - 1);
  }

  /// Points after the seed. `other` are those of the same stroke on the seed's other side.
  std::vector<WalkPoint> follow(const WalkPoint& seed, int way, const std::vector<WalkPoint>* other,
                                bool& isClosed) const
  {
    std::vector<WalkPoint> points;
    WalkPoint at = seed;
    at.direction = walk_.fieldAt(seed, isCross_) * static_cast<double>(way);
    const Vec3d start = at.direction;
    PointGrid own(distance_);
    const std::size_t turn = static_cast<std::size_t>(std::ceil(distance_ / strokes_.step)) + 2;
    if (other != nullptr)
      for (std::size_t i = turn; i < other->size(); ++i)
        own.add({(*other)[i].position - origin_, walk_.normalAt((*other)[i])});
    while (points.size() < kMostSteps) {
      if (!walk_.stepAlong(at, isCross_, strokes_.step)) break;
      const Vec3d normal = walk_.normalAt(at), p = at.position - origin_;
      const Vec3d toStart = seed.position - at.position;
      if (points.size() > turn && dot(toStart, toStart) < strokes_.step * strokes_.step &&
          dot(at.direction, start) > 0.9) {
        isClosed = true;
        closeGap(toStart - at.direction * dot(toStart, at.direction), points);
        break;
      }
      if (grid_->isNear(p, normal, kNearest * distance_) ||
          own.isNear(p, normal, kNearest * distance_))
        break;
      points.push_back(at);
      // What lies this far behind is no longer the stroke's own neighbourhood.
      if (points.size() > 2 * turn) {
        const WalkPoint& behind = points[points.size() - 2 * turn];
        own.add({behind.position - origin_, walk_.normalAt(behind)});
      }
    }
    return points;
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
    strokes_.rank.push_back(static_cast<float>(low_ + (high_ - low_) * share));
    strokes_.isCross.push_back(isCross_ ? 1 : 0);
  }
  void enter(std::size_t stroke)
  {
    for (std::uint32_t i = strokes_.first[stroke]; i < strokes_.first[stroke + 1]; ++i) {
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
  bool isCross_;
  HatchStrokes& strokes_;
  Vec3d origin_ = {0, 0, 0};
  double distance_ = 0, low_ = 0, high_ = 0;
  PointGrid* grid_ = nullptr;
  std::deque<WalkPoint> seeds_;
  std::uint32_t random_ = 40961u;
};

template <class T>
void append(const std::vector<T>& more, std::vector<T>& all)
{
  all.insert(all.end(), more.begin(), more.end());
}
void append(const HatchStrokes& more, HatchStrokes& all)
{
  const auto points = static_cast<std::uint32_t>(all.points.size());
  const auto vertices = static_cast<std::uint32_t>(all.vertex.size());
  append(more.points, all.points);
  append(more.triangle, all.triangle);
  append(more.normals, all.normals);
  append(more.across, all.across);
  append(more.rank, all.rank);
  append(more.isCross, all.isCross);
  for (const std::uint32_t vertex : more.vertex)
    all.vertex.push_back(points + vertex);
  for (std::size_t i = all.first.empty() ? 0 : 1; i < more.first.size(); ++i)
    all.first.push_back(vertices + more.first[i]);
}

}  // namespace

HatchStrokes traceHatching(const CurvedSurface& surface, const EdgeTable& table,
                           Span<const Vec3f> field, int threads)
{
  HatchStrokes strokes;
  const Box box = finiteBox(surface.mesh);
  if (box.empty()) return strokes;
  const Vec3d diagonal = box.high - box.low;
  strokes.spacing = kHatchDensity * std::sqrt(dot(diagonal, diagonal));
  strokes.step = 0.75 * strokes.spacing;
  if (!(strokes.spacing > 0)) return strokes;
  const SurfaceWalk walk(surface, table, field);
  HatchStrokes across = strokes;
  parallelFor(threads, 2, [&](std::size_t family) {
    FamilyTracer(walk, family == 1, family == 1 ? across : strokes).trace(box.low);
  });
  append(across, strokes);
  return strokes;
}

}  // namespace limn
