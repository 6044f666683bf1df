// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/StrokePieces.h"

#include "Rendering/Lines/LinePlace.h"
#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Shorter segments, in pixels, show nothing.
constexpr double kShortest = 1e-6;

enum class Seen : std::uint8_t {
  kOutside,
  kHidden,
  kBridged,  ///< hidden, unless it is a gap between visible ones
  kVisible
};

/// So many samples on either side count for one, too.
constexpr int kSmoothed = 2;

/// A segment before the near plane. Its samples lie evenly, about a pixel apart, wherever the
/// picture ends; those are kept that may be in the picture, or count for such.
struct PathSegment {
  LinePoint a, b;
  double start, length;    ///< along the chain, in pixels
  double samples, before;  ///< that it has, and that come before the first that is kept
  bool isOuter;
  bool continues;  ///< begins where the one before it in the chain ends, both unclipped
  bool endsUnclipped;
  std::size_t firstSample, sampleCount;

  double at(double share, double LinePoint::*value) const
  {
    return a.*value + share * (b.*value - a.*value);
  }
};

/// The chain's part of a set, cut into pieces. Kept from chain to chain for its memory.
class ChainCutter {
 public:
  ChainCutter(const LineSet& set, const LinePlace& place, const FrameView& frame,
              const ApronDepths& around)
      : set_(set),
        style_(set.style),
        place_(place),
        frame_(frame),
        around_(around),
        margin_(strokeReach(set.style) + kSmoothed)
  {
  }

  void cut(std::size_t chain, std::vector<StrokePiece>& pieces)
  {
    first_ = set_.first[chain];
    end_ = set_.first[chain + 1];
    isClosed_ = end_ - first_ > 2 && set_.vertex[first_] == set_.vertex[end_ - 1];
    segments_.clear();
    seen_.clear();
    hasGaps_ = false;
    placeSegments();
    if (hasGaps_) bridgeGaps();
    smooth();
    for (std::size_t i = 0; i < segments_.size(); ++i)
      addRuns(i, pieces);
  }

 private:
  /// Pixels around that of a sample whose depths count.
  static constexpr int kReach = 2, kWindow = 2 * kReach + 1;

  void placeSegments()
  {
    double start = 0;
    bool isUnbroken = false;  // nothing was left out since the last segment
    for (std::size_t i = first_; i + 1 < end_; ++i) {
      const std::uint32_t p = set_.vertex[i], q = set_.vertex[i + 1];
      PathSegment segment;
      bool clipsStart = false, clipsEnd = false;
      if (!place_.place(set_, p, q, segment.a, segment.b, clipsStart, clipsEnd)) {
        isUnbroken = false;
        continue;
      }
      const double dx = segment.b.x - segment.a.x, dy = segment.b.y - segment.a.y;
      segment.length = std::sqrt(dx * dx + dy * dy);
      if (!(segment.length <= kLongestSegment)) {
        isUnbroken = false;
        continue;
      }
      if (segment.length <= kShortest) continue;
      segment.start = start;
      start += segment.length;
      if (!keepSamples(segment)) {
        isUnbroken = false;
        continue;
      }
      const bool isCutBefore = clipsStart || segment.before > 0;
      const bool isCutAfter =
          clipsEnd || segment.before + static_cast<double>(segment.sampleCount) < segment.samples;
      const std::uint8_t flags = set_.flags.empty() ? std::uint8_t{0} : set_.flags[i];
      segment.isOuter = (flags & kOuterLine) != 0;
      segment.continues = isUnbroken && !isCutBefore;
      segment.endsUnclipped = !isCutAfter;
      if (segments_.empty()) startsUnclipped_ = !isCutBefore && start == segment.length;
      addSamples(segment, (flags & kConcealedLine) != 0);
      segments_.push_back(segment);
      isUnbroken = segment.endsUnclipped;
    }
    length_ = start;
    endsUnclipped_ = isUnbroken;
    if (isClosed_ && !segments_.empty() && startsUnclipped_ && endsUnclipped_)
      segments_[0].continues = true;
  }

  /// Those of the part that Liang and Barsky's algorithm leaves. False if there are none.
  bool keepSamples(PathSegment& segment) const
  {
    const LinePoint &a = segment.a, &b = segment.b;
    const double limitX = frame_.width + margin_, limitY = frame_.height + margin_;
    double from = 0, to = 1;
    if (!clipSide(a.x + margin_, b.x + margin_, from, to) ||
        !clipSide(limitX - a.x, limitX - b.x, from, to) ||
        !clipSide(a.y + margin_, b.y + margin_, from, to) ||
        !clipSide(limitY - a.y, limitY - b.y, from, to))
      return false;
    segment.samples = std::ceil(segment.length);
    segment.before = std::min(std::floor(from * segment.samples), segment.samples - 1);
    const double end = std::max(std::ceil(to * segment.samples), segment.before + 1);
    segment.sampleCount = static_cast<std::size_t>(end - segment.before);
    return true;
  }
  /// Keeps the part where the distance to a side, linear from a to b, is not negative.
  static bool clipSide(double a, double b, double& from, double& to)
  {
    if (a < 0 && b < 0) return false;
    if (a < 0) from = std::max(from, a / (a - b));
    if (b < 0) to = std::min(to, a / (a - b));
    return from < to;
  }

  void addSamples(PathSegment& segment, bool isConcealed)
  {
    segment.firstSample = seen_.size();
    for (std::size_t i = 0; i < segment.sampleCount; ++i) {
      const double share = shareAt(segment, static_cast<double>(i) + 0.5);
      const double depth = segment.at(share, &LinePoint::depth);
      const bool isTested = depth <= 1 && !isConcealed;
      if (depth > 1)
        seen_.push_back(Seen::kOutside);
      else if (isConcealed)
        seen_.push_back(Seen::kHidden);
      else
        seen_.push_back(isVisible(segment, share, &LinePoint::tested) ? Seen::kVisible
                                                                      : Seen::kHidden);
      if (!segment.isOuter || set_.slack.empty()) continue;
      if (!isTested || seen_.back() != Seen::kHidden) continue;
      if (!isVisible(segment, share, &LinePoint::bridged)) continue;
      seen_.back() = Seen::kBridged;
      hasGaps_ = true;
    }
  }

  /// LineSet::slack. Gaps that end too far outside to be told are none that it bridges.
  void bridgeGaps()
  {
    for (std::size_t s = 0; s < segments_.size();) {
      const std::size_t first = segments_[s].firstSample;
      for (++s; s < segments_.size() && segments_[s].continues;)
        ++s;
      bridgeGaps(first, s < segments_.size() ? segments_[s].firstSample : seen_.size());
    }
  }
  /// Of the samples of segments that continue each other.
  void bridgeGaps(std::size_t first, std::size_t end)
  {
    const bool isRing = first == 0 && end == seen_.size() && segments_[0].continues;
    // A ring is gone around from a sample on that is in no gap.
    std::size_t start = first;
    while (isRing && start < end && seen_[start] == Seen::kBridged)
      ++start;
    const std::size_t count = end - first, turned = start - first;
    const auto at = [&](std::size_t i) -> Seen& { return seen_[first + (turned + i) % count]; };
    for (std::size_t i = 0; i < count;) {
      std::size_t next = i;
      while (next < count && at(next) == Seen::kBridged)
        ++next;
      const bool isBefore = i > 0 && at(i - 1) == Seen::kVisible;
      const bool isAfter =
          next < count ? at(next) == Seen::kVisible : isRing && at(0) == Seen::kVisible;
      for (; i < next; ++i)
        at(i) = isBefore && isAfter ? Seen::kVisible : Seen::kHidden;
      ++i;
    }
  }

  static double shareAt(const PathSegment& segment, double sample)
  {
    return (segment.before + sample) / segment.samples;
  }

  bool isVisible(const PathSegment& segment, double share, double LinePoint::*by) const
  {
    const double x = segment.at(share, &LinePoint::x), y = segment.at(share, &LinePoint::y);
    const double tested = segment.at(share, by);
    const int column = inside(x, frame_.width), row = inside(y, frame_.height);
    float copy[kWindow * kWindow];
    const DepthRows depths = depthsAt(column, row, copy);
    const auto reaches = [&](int dx, int dy) {
      const float* const depth = depths.here + dy * depths.stride + dx;
      const double slopeX = slopeAt(depth, 1), slopeY = slopeAt(depth, depths.stride);
      const double alongX = x - (column + dx + 0.5), alongY = y - (row + dy + 0.5);
      const double carried = *depth + (slopeX * alongX + slopeY * alongY);
      const double bias = kSlopePixels * (std::fabs(slopeX) + std::fabs(slopeY)) + kDepthBias;
      return carried + bias >= tested;
    };
    // The pixel itself first: it mostly settles it.
    if (reaches(0, 0)) return true;
    // Beyond the apron depths are carried farther than that reckons with.
    const bool isInPixel =
        std::fabs(x - (column + 0.5)) <= 0.5 && std::fabs(y - (row + 0.5)) <= 0.5;
    if (isInPixel && isDeepBehind(depths.here, depths.stride, tested)) return false;
    constexpr int kOrder[8][2] = {{-1, 0},  {1, 0},  {0, -1}, {0, 1},
                                  {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    for (const auto& [dx, dy] : kOrder)
      if (reaches(dx, dy)) return true;
    return false;
  }
  /// Whether a depth is farther than what can be carried there from any of the pixels around: these
  /// are less than two pixels away in x and y, half of one more counts, and slopes are differences
  /// between them and those beside them.
  static bool isDeepBehind(const float* here, std::ptrdiff_t stride, double tested)
  {
    const float* at = here - kReach * stride - kReach;
    float low = *at, high = *at;
    for (int y = 0; y <= 2 * kReach; ++y, at += stride)
      for (int x = 0; x <= 2 * kReach; ++x) {
        low = at[x] < low ? at[x] : low;
        high = at[x] > high ? at[x] : high;
      }
    constexpr double kMostPixels = 2 * (1.5 + kSlopePixels), kRounding = 1e-9;
    const double nearest = low, farthest = high;
    return tested > farthest + kMostPixels * (farthest - nearest) + (kDepthBias + kRounding);
  }
  /// How the depth grows from pixel to pixel. Of the two sides the one that slopes less: the other
  /// may be the edge of something else.
  static double slopeAt(const float* depth, std::ptrdiff_t step)
  {
    const double here = *depth, before = here - depth[-step], after = depth[step] - here;
    return std::fabs(before) < std::fabs(after) ? before : after;
  }
  /// The pixel of a coordinate, or the next one around which depths are known.
  int inside(double coordinate, int size) const
  {
    const double first = kReach - around_.apron(), last = size - 1 - first;
    return static_cast<int>(std::min(std::max(std::floor(coordinate), first), last));
  }

  /// Depths of pixels, one of which is `here`.
  struct DepthRows {
    const float* here;
    std::ptrdiff_t stride;
  };
  /// Around a pixel, of `copy` where the frame does not have them all.
  DepthRows depthsAt(int column, int row, float (&copy)[kWindow * kWindow]) const
  {
    if (column >= kReach && row >= kReach && column + kReach < frame_.width &&
        row + kReach < frame_.height)
      return {frame_.depth + row * frame_.rowStride + column, frame_.rowStride};
    float* next = copy;
    for (int y = row - kReach; y <= row + kReach; ++y)
      for (int x = column - kReach; x <= column + kReach; ++x)
        *next++ = isInFrame(x, y) ? frame_.depth[y * frame_.rowStride + x] : *around_.at(x, y);
    return {copy + kReach * kWindow + kReach, kWindow};
  }
  bool isInFrame(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < frame_.width && y < frame_.height;
  }

  /// What three of five samples say, so that a single one changes nothing.
  void smooth()
  {
    raw_ = seen_;
    const auto last = static_cast<std::ptrdiff_t>(seen_.size()) - 1;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
      if (raw_[static_cast<std::size_t>(i)] == Seen::kOutside) continue;
      int visible = 0;
      for (std::ptrdiff_t k = i - kSmoothed; k <= i + kSmoothed; ++k) {
        const std::ptrdiff_t near = std::min(std::max<std::ptrdiff_t>(k, 0), last);
        visible += raw_[static_cast<std::size_t>(near)] == Seen::kVisible ? 1 : 0;
      }
      seen_[static_cast<std::size_t>(i)] = visible >= 3 ? Seen::kVisible : Seen::kHidden;
    }
  }

  void addRuns(std::size_t number, std::vector<StrokePiece>& pieces)
  {
    const PathSegment& segment = segments_[number];
    std::size_t i = 0;
    while (i < segment.sampleCount) {
      const Seen seen = seen_[segment.firstSample + i];
      std::size_t next = i + 1;
      while (next < segment.sampleCount && seen_[segment.firstSample + next] == seen)
        ++next;
      if (seen == Seen::kVisible || (seen == Seen::kHidden && style_.hidden != HiddenLines::kOff)) {
        const double s0 = segment.start + shareAt(segment, static_cast<double>(i)) * segment.length;
        const double s1 =
            segment.start + shareAt(segment, static_cast<double>(next)) * segment.length;
        const bool joins0 = i == 0 && joinsBefore(number, seen);
        const bool joins1 = next == segment.sampleCount && joinsAfter(number, seen);
        taper(segment, {s0, s1, joins0, joins1}, seen, pieces);
      }
      i = next;
    }
  }
  Seen firstSeen(const PathSegment& segment) const { return seen_[segment.firstSample]; }
  Seen lastSeen(const PathSegment& segment) const
  {
    return seen_[segment.firstSample + segment.sampleCount - 1];
  }
  bool joinsBefore(std::size_t number, Seen seen) const
  {
    if (segments_[number].continues)
      return lastSeen(segments_[number > 0 ? number - 1 : segments_.size() - 1]) == seen;
    return number == 0 && startsUnclipped_ && style_.cap == LineCap::kRound;
  }
  bool joinsAfter(std::size_t number, Seen seen) const
  {
    const bool isLast = number + 1 == segments_.size();
    const PathSegment& after = segments_[isLast ? 0 : number + 1];
    if ((!isLast || isClosed_) && after.continues) return firstSeen(after) == seen;
    return isLast && endsUnclipped_ && style_.cap == LineCap::kRound;
  }

  /// A stretch of a segment, by its place along the chain.
  struct Stretch {
    double s0, s1;
    bool joins0, joins1;
  };

  /// Cuts where the width does not grow evenly.
  void taper(const PathSegment& segment, Stretch stretch, Seen seen,
             std::vector<StrokePiece>& pieces) const
  {
    if (isTapered()) {
      const auto length = static_cast<double>(style_.taper);
      double knots[3] = {length, length_ * 0.5, length_ - length};
      std::sort(knots, knots + 3);
      for (const double knot : knots) {
        if (!(knot > stretch.s0 && knot < stretch.s1)) continue;
        dash(segment, {stretch.s0, knot, stretch.joins0, true}, seen, pieces);
        stretch.s0 = knot;
        stretch.joins0 = true;
      }
    }
    dash(segment, stretch, seen, pieces);
  }
  bool isTapered() const { return style_.taper > 0 && !isClosed_; }

  void dash(const PathSegment& segment, Stretch stretch, Seen seen,
            std::vector<StrokePiece>& pieces) const
  {
    double on = style_.dash, off = style_.gap;
    if (seen == Seen::kHidden && style_.hidden == HiddenLines::kDashed && style_.dash == 0) {
      on = kHiddenDash * static_cast<double>(style_.width) + 2.0;
      off = kHiddenGap * static_cast<double>(style_.width) + 2.0;
    }
    if (on == 0) {
      add(segment, stretch, seen, pieces);
      return;
    }
    const double period = on + off;
    for (double k = std::floor(stretch.s0 / period); k * period < stretch.s1; k += 1) {
      const double begin = k * period, end = begin + on;
      Stretch part = stretch;
      if (begin > stretch.s0) {
        part.s0 = begin;
        part.joins0 = false;
      }
      if (end < stretch.s1) {
        part.s1 = end;
        part.joins1 = false;
      }
      if (part.s0 < part.s1) add(segment, part, seen, pieces);
    }
  }

  void add(const PathSegment& segment, const Stretch& stretch, Seen seen,
           std::vector<StrokePiece>& pieces) const
  {
    const double t0 = (stretch.s0 - segment.start) / segment.length;
    const double t1 = (stretch.s1 - segment.start) / segment.length;
    const bool isHidden = seen == Seen::kHidden;
    StrokePiece piece;
    piece.x0 = segment.at(t0, &LinePoint::x);
    piece.y0 = segment.at(t0, &LinePoint::y);
    piece.x1 = segment.at(t1, &LinePoint::x);
    piece.y1 = segment.at(t1, &LinePoint::y);
    piece.half0 = halfWidth(segment, stretch.s0, isHidden);
    piece.half1 = halfWidth(segment, stretch.s1, isHidden);
    piece.depth0 = isHidden ? kNoDepth : static_cast<float>(segment.at(t0, &LinePoint::depth));
    piece.depth1 = isHidden ? kNoDepth : static_cast<float>(segment.at(t1, &LinePoint::depth));
    piece.round0 = stretch.joins0;
    piece.round1 = stretch.joins1;
    pieces.push_back(piece);
  }
  float halfWidth(const PathSegment& segment, double s, bool isHidden) const
  {
    double half = 0.5 * static_cast<double>(style_.width);
    if (segment.isOuter) half *= static_cast<double>(style_.outerFactor);
    if (isHidden) half *= static_cast<double>(kHiddenWidth);
    if (!set_.share.empty())
      half *= segment.at((s - segment.start) / segment.length, &LinePoint::share);
    if (isTapered()) {
      const double toEnd = std::max(std::min(s, length_ - s), 0.0);
      half *= std::min(toEnd / static_cast<double>(style_.taper), 1.0);
    }
    return static_cast<float>(half);
  }

  const LineSet& set_;
  const LineStyle& style_;
  const LinePlace& place_;
  const FrameView& frame_;
  const ApronDepths& around_;
  double margin_;
  std::size_t first_ = 0, end_ = 0;
  bool isClosed_ = false, startsUnclipped_ = false, endsUnclipped_ = false;
  bool hasGaps_ = false;  ///< some sample is kBridged
  double length_ = 0;     ///< of the chain
  std::vector<PathSegment> segments_;
  std::vector<Seen> seen_, raw_;
};

/// A thread cuts chains of about so many points at a time.
constexpr std::size_t kPointsPerTask = 512;

struct PlacedSet {
  const LineSet& set;
  LinePlace place;
  std::size_t group;
};

/// Some chains of a set, and what becomes of them.
struct CutTask {
  std::size_t set;
  std::size_t firstChain, endChain;
  std::vector<StrokePiece> pieces;
};

void addTasks(std::size_t number, const LineSet& set, std::vector<CutTask>& tasks)
{
  for (std::size_t chain = 0; chain < set.chainCount();) {
    const std::size_t first = chain;
    while (chain < set.chainCount() && set.first[chain] - set.first[first] < kPointsPerTask)
      ++chain;
    tasks.push_back({number, first, chain, {}});
  }
}

void join(const std::vector<PlacedSet>& sets, const std::vector<CutTask>& tasks, StrokePlan& plan)
{
  for (const CutTask& task : tasks)
    plan.groups[sets[task.set].group].endPiece += task.pieces.size();
  std::size_t end = 0;
  for (StrokeGroup& group : plan.groups)
    group.endPiece = end += group.endPiece;
  plan.pieces.reserve(end);
  for (const CutTask& task : tasks)
    plan.pieces.insert(plan.pieces.end(), task.pieces.begin(), task.pieces.end());
}

}  // namespace

int strokeApron(const Scene& scene)
{
  double reach = 0;
  for (const Instance& instance : scene.instances)
    for (const LineSet& set : instance.lines)
      reach = std::max(reach, strokeReach(set.style));
  if (!(reach > 0)) return 0;
  return static_cast<int>(std::min<double>(std::ceil(reach) + kStrokeApron, kWidestStrokeApron));
}

StrokePlan findStrokePieces(const Scene& scene, const FrameView& frame, const ApronDepths& around,
                            int threads)
{
  StrokePlan plan;
  std::vector<PlacedSet> sets;
  std::vector<CutTask> tasks;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const LineStyle* before = nullptr;
    for (const LineSet& set : instance.lines) {
      if (before == nullptr || !(*before == set.style))
        plan.groups.push_back(
            {static_cast<std::uint32_t>(i), set.style.color, set.style.opacity, 0});
      before = &set.style;
      addTasks(sets.size(), set, tasks);
      sets.push_back({set,
                      {scene.camera, instance.modelToWorld, frame.width, frame.height},
                      plan.groups.size() - 1});
    }
  }
  // Of all sets at once, as some are one long chain.
  parallelFor(threads, tasks.size(), [&](std::size_t t) {
    CutTask& task = tasks[t];
    const PlacedSet& placed = sets[task.set];
    ChainCutter cutter(placed.set, placed.place, frame, around);
    for (std::size_t chain = task.firstChain; chain < task.endChain; ++chain)
      cutter.cut(chain, task.pieces);
  });
  join(sets, tasks, plan);
  return plan;
}

}  // namespace limn
