// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HatchField.h"

#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;
constexpr double kReliable = 0.5;
/// What is trusted so far is not smoothed at all.
constexpr double kCertain = 0.95;
/// Half of the trust is lost where the curvatures differ by 1 over the mesh's diagonal, and where
/// they differ by this share of the sum of their sizes.
constexpr double kUnlike = 0.15;
/// Fewer reliable vertices than one in so many are noise.
constexpr std::size_t kFewest = 50;
/// Feature sizes in the diagonal.
constexpr double kFeatureSizes = 40;

/// Four times an angle, as (cosine, sine): that of a cross, whichever arm was measured.
struct Quadruple {
  double cosine, sine;
};
Quadruple twice(double cosine, double sine)
{
  return {cosine * cosine - sine * sine, 2 * cosine * sine};
}
Quadruple unit(Quadruple q)
{
  const double length = std::sqrt(q.cosine * q.cosine + q.sine * q.sine);
  return length > 0 ? Quadruple{q.cosine / length, q.sine / length} : q;
}
/// Of unit length; the half between -90 and 90 degrees.
Quadruple half(Quadruple q)
{
  if (q.cosine > 0) {
    const double cosine = std::sqrt(0.5 * (1 + q.cosine));
    return {cosine, 0.5 * q.sine / cosine};
  }
  const double sine = std::sqrt(0.5 * (1 - q.cosine));
  return q.sine < 0 ? Quadruple{-0.5 * q.sine / sine, -sine} : Quadruple{0.5 * q.sine / sine, sine};
}

class CrossSmoother {
 public:
  CrossSmoother(const HatchSurface& surface, const FlatRegions& flats, int threads)
      : surface_(surface.curved), threads_(threads), count_(surface.curved.mesh.vertexCount())
  {
    markCurved(flats);
    gatherLinks(surface.table);
    trustCurvature();
  }

  /// What HatchField has of circles, after smooth().
  std::vector<std::uint8_t> takeCircles() { return std::move(circles_); }
  std::vector<std::uint32_t> takeCircled() { return std::move(circled_); }

  std::vector<Vec3f> smooth()
  {
    cross_.assign(count_, Quadruple{0, 0});
    axis_.assign(count_, Vec3d{0, 0, 0});
    circles_.assign(count_, 0);
    gatherParts();
    hasCircles_.assign(partFirst_.size(), 0);
    for (std::size_t p = 0; p + 1 < partFirst_.size(); ++p) {
      const Span<const std::uint32_t> part = {parts_.data() + partFirst_[p],
                                              partFirst_[p + 1] - partFirst_[p]};
      if (fillIn(part)) continue;
      hasCircles_[p] = 1;
      setCircles(part);
    }
    relax();
    parallelForEach(threads_, count_, kPerTask, [&](std::size_t v) {
      if (hasLinks(v) && axis_[v] == Vec3d{0, 0, 0}) axis_[v] = armOf(v, cross_[v]);
    });
    isChosen_.assign(count_, 0);
    for (std::size_t p = 0; p + 1 < partFirst_.size(); ++p)
      if (!hasCircles_[p])
        chooseArms({parts_.data() + partFirst_[p], partFirst_[p + 1] - partFirst_[p]});
    std::vector<Vec3f> result(count_);
    parallelForEach(threads_, count_, kPerTask,
                    [&](std::size_t v) { result[v] = vec3Cast<float>(axis_[v]); });
    return result;
  }

 private:
  struct Link {
    std::uint32_t other;
    float cosine, sine;  ///< of four times the turn of the other's frame in this one's
  };

  Vec3d normalOf(std::size_t v) const { return vec3Cast<double>(surface_.normals[v]); }
  Vec3d axisU(std::size_t v) const
  {
    const Vec3d n = normalOf(v);
    return normalized(cross(n, std::fabs(n.x) > 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
  }
  bool hasLinks(std::size_t v) const { return first_[v] != first_[v + 1]; }
  Span<const Link> linksOf(std::size_t v) const
  {
    return {links_.data() + first_[v], first_[v + 1] - first_[v]};
  }

  void markCurved(const FlatRegions& flats)
  {
    isCurved_.assign(count_, 0);
    const Span<const Triangle> triangles = surface_.mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (flats.of(t) == FlatRegions::kNone)
        for (const std::uint32_t v : triangles[t].vertex)
          if (v < count_ && !(surface_.normals[v] == Vec3f{0, 0, 0})) isCurved_[v] = 1;
  }

  /// Calls visit(a, b) for the vertices at both ends of an edge, for both sides where they differ.
  template <class Visit>
  void forEachPair(const EdgeTable& table, const Visit& visit) const
  {
    for (const MeshEdge& edge : table.edges) {
      std::uint32_t a[2] = {kNoCorner, kNoCorner}, b[2] = {kNoCorner, kNoCorner};
      for (int f = 0; f < 2; ++f) {
        if (edge.corner[f] == kNoCorner) continue;
        const auto& vertex = surface_.mesh.triangles[edge.corner[f] / 3].vertex;
        a[f] = vertex[edge.corner[f] % 3];
        b[f] = vertex[(edge.corner[f] + 1) % 3];
        if (a[f] > b[f]) std::swap(a[f], b[f]);
        const bool isNew = f == 0 || a[0] != a[1] || b[0] != b[1];
        if (isNew && b[f] < count_ && isCurved_[a[f]] && isCurved_[b[f]]) visit(a[f], b[f]);
      }
    }
  }
  void gatherLinks(const EdgeTable& table)
  {
    first_.assign(count_ + 1, 0);
    forEachPair(table, [&](std::uint32_t a, std::uint32_t b) {
      ++first_[a + 1];
      ++first_[b + 1];
    });
    for (std::size_t v = 0; v < count_; ++v)
      first_[v + 1] += first_[v];
    links_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    forEachPair(table, [&](std::uint32_t a, std::uint32_t b) {
      links_[next[a]++].other = b;
      links_[next[b]++].other = a;
    });
    parallelForEach(threads_, count_, kPerTask, [&](std::size_t v) {
      const Vec3d u = axisU(v), w = cross(normalOf(v), u);
      for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
        const Vec3d turned = turnedTo(v, links_[i].other, axisU(links_[i].other));
        const Quadruple half = twice(dot(turned, u), dot(turned, w));
        const Quadruple all = unit(twice(half.cosine, half.sine));
        links_[i].cosine = static_cast<float>(all.cosine);
        links_[i].sine = static_cast<float>(all.sine);
      }
    });
  }
  /// A direction in the other's plane turned the shortest way, as its normal becomes that of v.
  Vec3d turnedTo(std::size_t v, std::size_t other, Vec3d direction) const
  {
    const Vec3d n = normalOf(v), old = normalOf(other);
    const double cosine = dot(old, n);
    if (!(cosine > -1)) return direction;
    return direction - (old + n) * (dot(direction, n) / (1 + cosine));
  }

  void trustCurvature()
  {
    trust_.assign(count_, 0.0);
    principal_.assign(count_, Quadruple{0, 0});
    const double size = kFeatureSizes * featureSize(surface_.mesh, threads_);
    parallelForEach(threads_, count_, kPerTask, [&](std::size_t v) {
      if (!hasLinks(v)) return;
      const Vec3d d = principalOf(v), u = axisU(v), w = cross(normalOf(v), u);
      const Quadruple half = twice(dot(d, u), dot(d, w));
      principal_[v] = unit(twice(half.cosine, half.sine));
      const VertexCurvature& c = surface_.curvature[v];
      const auto a = static_cast<double>(c.curvature[0]), b = static_cast<double>(c.curvature[1]);
      const double bend = (a - b) * size, sum = (std::fabs(a) + std::fabs(b)) * (kUnlike * size);
      const double bend2 = bend * bend, sum2 = sum * sum;
      const double trust = bend2 * bend2 / (bend2 * bend2 + 1) *
                           (bend2 * bend2 / (bend2 * bend2 + (sum2 * sum2 + 1e-30)));
      trust_[v] = trust >= kCertain ? 1.0 : trust > 0 ? trust : 0.0;
    });
  }
  /// Of the greater curvature, signed.
  Vec3d principalOf(std::size_t v) const
  {
    const VertexCurvature& c = surface_.curvature[v];
    return vec3Cast<double>(c.direction[c.curvature[0] >= c.curvature[1] ? 0 : 1]);
  }

  /// Vertices of each connected part, one part after another.
  void gatherParts()
  {
    std::vector<char> isSeen(count_, 0);
    partFirst_.assign(1, 0);
    for (std::uint32_t v = 0; v < count_; ++v) {
      if (!hasLinks(v) || isSeen[v]) continue;
      isSeen[v] = 1;
      parts_.push_back(v);
      for (std::size_t i = partFirst_.back(); i < parts_.size(); ++i)
        for (const Link& link : linksOf(parts_[i]))
          if (!isSeen[link.other]) {
            isSeen[link.other] = 1;
            parts_.push_back(link.other);
          }
      partFirst_.push_back(parts_.size());
    }
  }

  /// False, and nothing done, where nothing is reliable.
  bool fillIn(Span<const std::uint32_t> part)
  {
    std::vector<std::uint32_t> known;
    for (const std::uint32_t v : part)
      if (trust_[v] >= kReliable) known.push_back(v);
    if (known.size() * kFewest < part.size()) return false;
    for (const std::uint32_t v : known)
      cross_[v] = principal_[v];
    // Crosses are units: zero is unknown. The nearest to what is reliable come first.
    for (std::size_t i = 0; i < known.size(); ++i)
      for (const Link& link : linksOf(known[i])) {
        Quadruple& cross = cross_[link.other];
        if (!(cross.cosine == 0 && cross.sine == 0)) continue;
        cross = meanAround(link.other);
        if (cross.cosine == 0 && cross.sine == 0) cross = {1, 0};
        known.push_back(link.other);
      }
    return true;
  }
  void setCircles(Span<const std::uint32_t> part)
  {
    Vec3d sum = {0, 0, 0};
    for (const std::uint32_t v : part)
      sum = sum + normalOf(v) * normalOf(v);
    constexpr double kDoubt = 1.25;
    const bool isZ = sum.z <= kDoubt * std::min(sum.x, sum.y);
    const bool isY = !isZ && sum.y <= sum.x;
    const Vec3d axis = isZ ? Vec3d{0, 0, 1} : isY ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    circled_.push_back(part[0]);
    for (const std::uint32_t v : part) {
      circles_[v] = isZ ? 3 : isY ? 2 : 1;
      axis_[v] = normalized(cross(axis, normalOf(v)));
      if (axis_[v] == Vec3d{0, 0, 0}) axis_[v] = axisU(v);
      trust_[v] = 1;
    }
  }

  Quadruple meanAround(std::size_t v) const
  {
    Quadruple sum = {0, 0};
    for (const Link& link : linksOf(v)) {
      const Quadruple other = cross_[link.other];
      const auto c = static_cast<double>(link.cosine), s = static_cast<double>(link.sine);
      sum.cosine += other.cosine * c - other.sine * s;
      sum.sine += other.cosine * s + other.sine * c;
    }
    return unit(sum);
  }
  void relax()
  {
    std::vector<Quadruple> next = cross_;
    for (int round = 0; round < kFieldRounds; ++round) {
      parallelForEach(threads_, count_, kPerTask, [&](std::size_t v) {
        if (trust_[v] >= 1 || !hasLinks(v)) return;
        const Quadruple around = meanAround(v), own = principal_[v];
        const double share = 1 - trust_[v];
        const Quadruple mixed = unit({own.cosine * trust_[v] + around.cosine * share,
                                      own.sine * trust_[v] + around.sine * share});
        next[v] = mixed.cosine == 0 && mixed.sine == 0 ? cross_[v] : mixed;
      });
      cross_.swap(next);
    }
  }

  Vec3d armOf(std::size_t v, Quadruple cross) const
  {
    const Quadruple angle = half(half(cross));
    const Vec3d u = axisU(v);
    return normalized(u * angle.cosine + limn::cross(normalOf(v), u) * angle.sine);
  }

  /// Makes the arms in axis_ go on from vertex to vertex, where the crosses are surest first, so
  /// that cuts between singularities lie where nothing is sure.
  void chooseArms(Span<const std::uint32_t> part)
  {
    struct Step {
      std::uint32_t from, to;
    };
    constexpr int kLevels = 8;
    std::vector<Step> steps[kLevels];
    std::size_t next[kLevels] = {};
    const auto levelOf = [&](std::uint32_t v) {
      return std::min(kLevels - 1, static_cast<int>(trust_[v] * kLevels));
    };
    const std::uint32_t start = *std::max_element(
        part.begin(), part.end(), [&](auto a, auto b) { return trust_[a] < trust_[b]; });
    steps[kLevels - 1].push_back({start, start});
    for (int level = kLevels - 1; level >= 0;) {
      if (next[level] == steps[level].size()) {
        --level;
        continue;
      }
      const Step step = steps[level][next[level]++];
      if (isChosen_[step.to]) continue;
      isChosen_[step.to] = 1;
      const Vec3d before = turnedTo(step.to, step.from, axis_[step.from]);
      const Vec3d other = cross(normalOf(step.to), axis_[step.to]);
      if (std::fabs(dot(before, axis_[step.to])) < std::fabs(dot(before, other)))
        axis_[step.to] = other;
      for (const Link& link : linksOf(step.to))
        if (!isChosen_[link.other]) {
          const int to = levelOf(link.other);
          steps[to].push_back({step.to, link.other});
          level = std::max(level, to);
        }
    }
    if (isMostlyOther(part))
      for (const std::uint32_t v : part)
        axis_[v] = cross(normalOf(v), axis_[v]);
  }
  /// Whether the other arm has the principal direction of most.
  bool isMostlyOther(Span<const std::uint32_t> part) const
  {
    double sum = 0;
    for (const std::uint32_t v : part) {
      const Vec3d wanted = principalOf(v);
      const double along = dot(wanted, axis_[v]);
      const double across = dot(wanted, cross(normalOf(v), axis_[v]));
      sum += trust_[v] * (along * along - across * across);
    }
    return sum < 0;
  }

  const CurvedSurface& surface_;
  int threads_;
  std::size_t count_;
  std::vector<char> isCurved_;  ///< has a triangle outside of flat regions
  std::vector<std::size_t> first_;
  std::vector<Link> links_;
  std::vector<double> trust_;
  std::vector<Quadruple> principal_, cross_;
  std::vector<std::uint32_t> parts_;
  std::vector<std::size_t> partFirst_;
  std::vector<char> hasCircles_;  ///< by part
  std::vector<Vec3d> axis_;
  std::vector<std::uint8_t> circles_;
  std::vector<std::uint32_t> circled_;
  std::vector<char> isChosen_;
};

}  // namespace

HatchField hatchField(const HatchSurface& surface, int threads)
{
  HatchField field;
  field.flats = flatRegions(surface, threads);
  CrossSmoother smoother(surface, field.flats, threads);
  field.axis = smoother.smooth();
  field.circles = smoother.takeCircles();
  field.circled = smoother.takeCircled();
  return field;
}

}  // namespace limn
