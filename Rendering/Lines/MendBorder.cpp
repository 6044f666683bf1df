// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/MendBorder.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn {
namespace {

double distance(Vec3d a, Vec3d b)
{
  return std::sqrt(dot(a - b, a - b));
}
Vec3d nearestOn(Vec3d a, Vec3d b, Vec3d p)
{
  const Vec3d e = b - a;
  const double squared = dot(e, e);
  const double t = squared > 0 ? dot(p - a, e) / squared : 0.0;
  return a + e * std::min(std::max(t, 0.0), 1.0);
}

/// Straight parts in the order of their middles' x, to find those near a place.
class PartsByX {
 public:
  void add(Vec3d a, Vec3d b, std::uint32_t number)
  {
    parts_.push_back({0.5 * (a.x + b.x), a, b, number});
    longest_ = std::max(longest_, distance(a, b));
  }
  void sort()
  {
    std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
      return a.x != b.x ? a.x < b.x : a.number < b.number;
    });
  }
  /// Calls visit(number, nearest point, distance) for all within `reach`.
  template <class Visit>
  void visit(Vec3d p, double reach, const Visit& visit) const
  {
    const double wide = reach + 0.5 * longest_;
    auto part = std::lower_bound(parts_.begin(), parts_.end(), p.x - wide,
                                 [](const Part& one, double x) { return one.x < x; });
    for (; part != parts_.end() && part->x <= p.x + wide; ++part) {
      const Vec3d at = nearestOn(part->a, part->b, p);
      if (const double far = distance(at, p); far <= reach) visit(part->number, at, far);
    }
  }

 private:
  struct Part {
    double x;
    Vec3d a, b;
    std::uint32_t number;
  };
  std::vector<Part> parts_;
  double longest_ = 0;
};

class Mender {
 public:
  Mender(Span<const ShadowCaster> casters, BorderPieces& border)
      : casters_(casters), border_(border)
  {
  }

  void mend()
  {
    join();
    drop();
    lead();
  }

 private:
  /// An end of a chain that goes on nowhere.
  struct End {
    std::uint32_t point, chain;
    Vec3d outward;  ///< unit, along the chain's last stretch
  };

  void findEnds()
  {
    chainLinks(border_.links, border_.points.size(), chains_, nullptr);
    const std::size_t count = chains_.first.size() - 1;
    ends_.clear();
    length_.assign(count, 0.0);
    std::vector<std::uint32_t> links(border_.points.size(), 0);
    for (const LineLink& link : border_.links) {
      ++links[link.a];
      ++links[link.b];
    }
    for (std::uint32_t c = 0; c < count; ++c) {
      const std::uint32_t first = chains_.first[c], last = chains_.first[c + 1] - 1;
      for (std::uint32_t i = first; i < last; ++i)
        length_[c] += distance(point(i), point(i + 1));
      if (links[chains_.vertex[first]] == 1) ends_.push_back(endOf(c, first, last));
      if (links[chains_.vertex[last]] == 1) ends_.push_back(endOf(c, last, first));
    }
  }
  Vec3d point(std::uint32_t i) const { return border_.points[chains_.vertex[i]]; }
  /// Told by a stretch that rounding and single facets do not turn.
  End endOf(std::uint32_t chain, std::uint32_t at, std::uint32_t other) const
  {
    const std::uint32_t number = chains_.vertex[at];
    std::uint32_t i = at;
    do
      i = other > at ? i + 1 : i - 1;
    while (i != other && distance(point(i), point(at)) < kSteady * border_.reach[number]);
    return {number, chain, normalized(point(at) - point(i))};
  }

  void join()
  {
    findEnds();
    struct Pair {
      double apart;
      std::uint32_t a, b;  ///< of ends_
    };
    std::vector<Pair> pairs;
    PartsByX byX;
    for (std::uint32_t i = 0; i < ends_.size(); ++i) {
      const Vec3d p = border_.points[ends_[i].point];
      byX.add(p, p, i);
    }
    byX.sort();
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
      byX.visit(border_.points[ends_[i].point], border_.reach[ends_[i].point],
                [&](std::uint32_t j, Vec3d, double apart) {
                  if (i != j && fits(ends_[i], ends_[j], apart))
                    pairs.push_back({apart, std::min(i, j), std::max(i, j)});
                });
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return x.apart != y.apart ? x.apart < y.apart : x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    std::vector<std::uint8_t> isTaken(ends_.size(), 0);
    std::vector<std::uint32_t> joined(length_.size());  // by chain: one that it is joined to
    for (std::uint32_t c = 0; c < joined.size(); ++c)
      joined[c] = c;
    for (const Pair& pair : pairs) {
      if (isTaken[pair.a] != 0 || isTaken[pair.b] != 0) continue;
      const std::uint32_t a = rootOf(ends_[pair.a].chain, joined),
                          b = rootOf(ends_[pair.b].chain, joined);
      if (a == b && length_[a] < kLoop * reachOf(ends_[pair.a], ends_[pair.b])) continue;
      if (a != b) {
        joined[b] = a;
        length_[a] += length_[b] + pair.apart;
      }
      isTaken[pair.a] = isTaken[pair.b] = 1;
      border_.links.push_back(
          {ends_[pair.a].point, ends_[pair.b].point, border_.receiver[ends_[pair.a].point]});
    }
  }
  static std::uint32_t rootOf(std::uint32_t chain, const std::vector<std::uint32_t>& joined)
  {
    while (joined[chain] != chain)
      chain = joined[chain];
    return chain;
  }
  double reachOf(const End& a, const End& b) const
  {
    return std::max(border_.reach[a.point], border_.reach[b.point]);
  }
  bool fits(const End& a, const End& b, double apart) const
  {
    const double reach = reachOf(a, b);
    if (!(apart <= reach) || border_.showsOut[a.point] != border_.showsOut[b.point]) return false;
    if (apart <= kSteady * reach) return dot(a.outward, b.outward) < kBack;
    if (apart > std::min(length_[a.chain], length_[b.chain])) return false;
    const Vec3d way = border_.points[b.point] - border_.points[a.point];
    return dot(a.outward, way) > kStraight * apart && dot(b.outward, way) < -kStraight * apart;
  }

  void drop()
  {
    findEnds();
    std::vector<std::uint8_t> isDropped(border_.points.size(), 0);
    for (const End& end : ends_)
      if (length_[end.chain] < border_.reach[end.point])
        for (std::uint32_t i = chains_.first[end.chain]; i < chains_.first[end.chain + 1]; ++i)
          isDropped[chains_.vertex[i]] = 1;
    border_.links.erase(std::remove_if(border_.links.begin(), border_.links.end(),
                                       [&](const LineLink& link) {
                                         return isDropped[link.a] != 0 && isDropped[link.b] != 0;
                                       }),
                        border_.links.end());
  }

  /// Leads ends on, unless another line is there, at which they end.
  void lead()
  {
    findEnds();
    PartsByX contours, turns, others;
    std::map<std::uint64_t, int> counts;
    for (std::uint32_t c = 0; c < casters_.size(); ++c) {
      if (!casters_[c].isContour()) continue;
      contours.add(casters_[c].end[0], casters_[c].end[1], c);
      for (const std::uint64_t place : casters_[c].place)
        counts[place] += casters_[c].bulgesOut ? 1 : 0;
    }
    for (std::uint32_t c = 0; c < casters_.size(); ++c)
      for (int end = 0; end < 2; ++end)
        if (casters_[c].isContour() && counts[casters_[c].place[end]] == 1)
          turns.add(casters_[c].end[end], casters_[c].end[end], c);
    for (std::uint32_t c = 0; c + 1 < chains_.first.size(); ++c)
      for (std::uint32_t i = chains_.first[c]; i + 1 < chains_.first[c + 1]; ++i)
        others.add(point(i), point(i + 1), c);
    contours.sort();
    turns.sort();
    others.sort();
    for (const End& end : ends_)
      if (border_.isOfContour[end.point] != 0 && !isAtOther(end, others) && !leadTo(end, turns))
        leadTo(end, contours);
  }
  bool isAtOther(const End& end, const PartsByX& others) const
  {
    bool result = false;
    others.visit(
        border_.points[end.point], kSteady * border_.reach[end.point],
        [&](std::uint32_t chain, Vec3d, double) { result = result || chain != end.chain; });
    return result;
  }
  /// To the nearest that lies ahead. True also if it is there.
  bool leadTo(const End& end, const PartsByX& parts)
  {
    const Vec3d p = border_.points[end.point];
    const double reach = border_.reach[end.point];
    double least = HUGE_VAL;
    std::uint32_t nearest = 0;
    Vec3d at = p;
    bool isThere = false, isNear = false;
    parts.visit(p, kSteady * reach, [&](std::uint32_t, Vec3d, double far) {
      isNear = true;
      isThere = isThere || far <= kThere * reach;
    });
    // Next to it a contour is either ahead or has just been passed.
    const double straightest = isNear ? kStraight : kAhead;
    parts.visit(p, kLead * reach, [&](std::uint32_t number, Vec3d there, double far) {
      const double ahead = dot(there - p, end.outward);
      if (!(ahead > straightest * far)) return;
      // What turns less may be farther.
      const double way = far * (far / ahead);
      if (way < least || (way == least && number < nearest)) {
        least = way;
        nearest = number;
        at = there;
      }
    });
    if (isThere || !(least < HUGE_VAL)) return isThere || isNear;
    border_.points.push_back(at);
    border_.receiver.push_back(casters_[nearest].triangle[0]);
    border_.reach.push_back(reach);
    border_.isOfContour.push_back(1);
    border_.showsOut.push_back(border_.showsOut[end.point]);
    border_.links.push_back({end.point, static_cast<std::uint32_t>(border_.points.size() - 1),
                             border_.receiver[end.point]});
    return true;
  }

  /// As shares of the reach: what is next to each other, and how far a contour may be.
  static constexpr double kSteady = 0.25, kThere = 0.05, kLead = 2;
  /// The least cosine between a chain's end and what it goes on to.
  static constexpr double kStraight = 0.6, kAhead = 0.3;
  /// Ends next to each other that point the same way are of a line that folds back: rounding's
  /// work.
  static constexpr double kBack = 0.7;
  /// Chains that are not so many times as long as the reach stay open.
  static constexpr double kLoop = 4;

  Span<const ShadowCaster> casters_;
  BorderPieces& border_;
  LineChains chains_;
  std::vector<End> ends_;
  std::vector<double> length_;  ///< by chain
};

}  // namespace

void mendBorder(Span<const ShadowCaster> casters, BorderPieces& border)
{
  Mender(casters, border).mend();
}

}  // namespace limn
