// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FlatRegions.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 8192;
constexpr std::uint32_t kNone = FlatRegions::kNone;
/// Of 0.1 degrees, squared.
constexpr double kSineSquared = 3.0461742e-6;
/// Of 5 degrees: what rounding may tilt a triangle that lies in the plane.
constexpr double kTiltedCosine = 0.99619470;
/// Off the plane, as shares of the diagonal: at all, and by rounding alone.
constexpr double kFarthest = 1e-4, kRounding = 5e-7;
constexpr double kLeastTimes = 4;
/// Of 1 degree: itself, and of its quadruple.
constexpr double kAlikeCosine = 0.99984770, kAlikeQuadruple = 0.99756405;
constexpr double kLeastShare = 0.2, kTie = 0.95;
constexpr std::size_t kMostCandidates = 64;

/// Level where the plane is not, else as x as can be.
Vec3d levelIn(Vec3d normal)
{
  if (std::fabs(normal.z) > 0.9) return normalized(Vec3d{1, 0, 0} - normal * normal.x);
  return normalized(cross(Vec3d{0, 0, 1}, normal));
}

/// One straight piece of a region's border.
struct Side {
  Vec3d from, way;
  double length;
  double cosine, sine;  ///< of four times the angle to the level: right angles are alike
};

/// Chooses a region's direction from its border.
class DirectionChooser {
 public:
  DirectionChooser(Vec3d normal, std::vector<Side>& sides)
      : level_(levelIn(normal)), square_(cross(normal, level_)), sides_(sides)
  {
    for (Side& side : sides_) {
      const double x = dot(side.way, level_), y = dot(side.way, square_);
      const double squared = x * x + y * y;
      side.length = std::sqrt(squared);
      perimeter_ += side.length;
      if (!(squared > 0)) continue;
      const double c = (x * x - y * y) / squared, s = 2 * x * y / squared;
      side.cosine = c * c - s * s;
      side.sine = 2 * c * s;
    }
  }

  void choose(FlatRegion& region)
  {
    region.along = level_;
    const Side* const side = mostCommon();
    if (side == nullptr) return;
    region.origin = side->from;
    const Vec3d one =
        normalized(level_ * dot(side->way, level_) + square_ * dot(side->way, square_));
    const Vec3d other = cross(region.normal, one);
    const double ofOne = lengthAlong(one), ofOther = lengthAlong(other);
    const bool isTie = ofOne > kTie * ofOther && ofOther > kTie * ofOne;
    const bool isLevel = std::fabs(dot(one, level_)) >= std::fabs(dot(other, level_));
    region.along = (isTie ? isLevel : ofOne > ofOther) ? one : other;
  }

 private:
  /// The longest side of the direction that most of the border has; nullptr if that is little.
  const Side* mostCommon() const
  {
    std::vector<std::uint32_t> candidates(sides_.size());
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
      candidates[i] = i;
    const std::size_t count = std::min(kMostCandidates, candidates.size());
    std::partial_sort(
        candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
        candidates.end(), [&](std::uint32_t a, std::uint32_t b) {
          return sides_[a].length != sides_[b].length ? sides_[a].length > sides_[b].length : a < b;
        });
    candidates.resize(count);
    std::vector<double> sum(count, 0.0);
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Side& one = sides_[candidates[i]];
      for (const Side& other : sides_)
        if (one.cosine * other.cosine + one.sine * other.sine >= kAlikeQuadruple)
          sum[i] += other.length;
      most = std::max(most, sum[i]);
    }
    if (!(most >= kLeastShare * perimeter_)) return nullptr;
    const Side* best = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      const Side& one = sides_[candidates[i]];
      // Of directions that are alike but for rounding the longest side, which comes first.
      if (sum[i] >= kTie * most && (best == nullptr || one.cosine > best->cosine + 1e-3))
        best = &one;
    }
    return best;
  }
  double lengthAlong(Vec3d direction) const
  {
    double sum = 0;
    for (const Side& side : sides_)
      if (std::fabs(dot(side.way, direction)) >= kAlikeCosine * side.length) sum += side.length;
    return sum;
  }

  Vec3d level_, square_;
  std::vector<Side>& sides_;
  double perimeter_ = 0;
};

class RegionFinder {
 public:
  RegionFinder(const HatchSurface& surface, int threads)
      : surface_(surface), mesh_(surface.curved.mesh), threads_(threads)
  {
    const Box box = finiteBox(mesh_, threads);
    const Vec3d size = box.empty() ? Vec3d{0, 0, 0} : box.high - box.low;
    diagonal_ = std::sqrt(dot(size, size));
    readTriangles();
    readEdges();
  }

  FlatRegions find()
  {
    group_.assign(mesh_.triangles.size(), kNone);
    for (std::uint32_t t = 0; t < group_.size(); ++t)
      if (group_[t] == kNone && !isSliver_[t]) grow(t);
    FlatRegions found;
    const double spacing = kHatchDensity * diagonal_, least = 4 * spacing * spacing;
    for (std::uint32_t g = 0; g < groups_.size(); ++g)
      if (groups_[g].area >= least) keepIfFlat(g, found);
    return found;
  }

 private:
  struct Group {
    double area;
    std::uint32_t first, end;  ///< in order_
  };

  Vec3d corner(std::uint32_t triangle, int k) const
  {
    return mesh_.position(mesh_.triangles[triangle].vertex[k % 3]);
  }

  void readTriangles()
  {
    const std::size_t count = mesh_.triangles.size();
    normal_.assign(count, Vec3d{0, 0, 0});
    area_.assign(count, 0.0);
    isSliver_.assign(count, 1);
    parallelForEach(threads_, count, kPerTask, [&](std::size_t i) {
      const auto t = static_cast<std::uint32_t>(i);
      for (const std::uint32_t v : mesh_.triangles[t].vertex)
        if (v >= mesh_.vertexCount()) return;
      const Vec3d a = corner(t, 1) - corner(t, 0), b = corner(t, 2) - corner(t, 0), c = b - a;
      const Vec3d twice = cross(a, b);
      const double length = std::sqrt(dot(twice, twice));
      const double longest = std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
      if (!isFinite(twice) || !(length > 0)) return;
      area_[i] = 0.5 * length;
      normal_[i] = normalized(twice);
      isSliver_[i] = length < 1e-5 * diagonal_ * longest ? 1 : 0;
    });
  }
  void readEdges()
  {
    neighbour_.assign(3 * mesh_.triangles.size(), kNone);
    const Array<MeshEdge>& edges = surface_.table.edges;
    parallelForEach(threads_, edges.size(), kPerTask, [&](std::size_t e) {
      const MeshEdge& edge = edges[e];
      if (edge.faceCount != 2 || (surface_.kinds[e] & kCreaseEdge) != 0) return;
      neighbour_[edge.corner[0]] = edge.corner[1] / 3;
      neighbour_[edge.corner[1]] = edge.corner[0] / 3;
    });
  }

  bool isInPlane(std::uint32_t t, std::uint32_t first) const
  {
    const Vec3d n = normal_[first], p = corner(first, 0), m = normal_[t];
    double off = 0;
    for (int k = 0; k < 3; ++k)
      off = std::max(off, std::fabs(dot(corner(t, k) - p, n)));
    if (!(off <= kFarthest * diagonal_)) return false;
    if (isSliver_[t] != 0) return off <= kRounding * diagonal_;
    const double cosine = dot(m, n);
    const Vec3d turn = cross(m, n);
    if (cosine > 0 && dot(turn, turn) <= kSineSquared) return true;
    return cosine > kTiltedCosine && off <= kRounding * diagonal_;
  }
  void grow(std::uint32_t first)
  {
    const auto number = static_cast<std::uint32_t>(groups_.size());
    const auto begin = static_cast<std::uint32_t>(order_.size());
    double area = 0;
    group_[first] = number;
    order_.push_back(first);
    for (std::size_t i = begin; i < order_.size(); ++i) {
      const std::uint32_t t = order_[i];
      area += area_[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t next = neighbour_[3 * std::size_t{t} + k];
        if (next == kNone || group_[next] != kNone || !isInPlane(next, first)) continue;
        group_[next] = number;
        order_.push_back(next);
      }
    }
    groups_.push_back({area, begin, static_cast<std::uint32_t>(order_.size())});
  }

  void keepIfFlat(std::uint32_t number, FlatRegions& found) const
  {
    const Group& group = groups_[number];
    const std::uint32_t first = order_[group.first];
    FlatRegion region = {normal_[first], {}, corner(first, 0), true};
    std::vector<Side> sides;
    double largest = 0;
    for (std::uint32_t i = group.first; i < group.end; ++i) {
      const std::uint32_t t = order_[i];
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t next = neighbour_[3 * std::size_t{t} + static_cast<std::size_t>(k)];
        if (next != kNone && group_[next] == number) continue;
        const Vec3d from = corner(t, k);
        sides.push_back({from, corner(t, k + 1) - from, 0, 0, 0});
        if (next == kNone) continue;
        region.isFramed = false;
        if (group_[next] != kNone) largest = std::max(largest, groups_[group_[next]].area);
      }
    }
    if (!region.isFramed && !(group.area >= kLeastTimes * largest)) return;
    DirectionChooser(region.normal, sides).choose(region);
    if (found.ofTriangle.empty()) found.ofTriangle.assign(mesh_.triangles.size(), kNone);
    for (std::uint32_t i = group.first; i < group.end; ++i)
      found.ofTriangle[order_[i]] = static_cast<std::uint32_t>(found.regions.size());
    found.regions.push_back(region);
  }

  const HatchSurface& surface_;
  const MeshView& mesh_;
  int threads_;
  double diagonal_ = 0;
  std::vector<Vec3d> normal_;
  std::vector<double> area_;
  std::vector<char> isSliver_;
  std::vector<std::uint32_t> neighbour_;  ///< by corner, across the edge that begins there
  std::vector<std::uint32_t> group_, order_;
  std::vector<Group> groups_;
};

}  // namespace

FlatRegions flatRegions(const HatchSurface& surface, int threads)
{
  return RegionFinder(surface, threads).find();
}

}  // namespace limn
