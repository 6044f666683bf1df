// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceStrokes.h"

#include "Rendering/Base/Mat4.h"
#include "Rendering/Vertex/ScreenToView.h"
#include "Rendering/Vertex/ScreenVertex.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace limn::reference {
namespace {

/// A point in clip space, how far towards the eye it is tested, and how wide the line is there.
struct Clip {
  double x, y, z, w, slack, share;
};

double between(double a, double b, double t)
{
  return a + t * (b - a);
}

Clip between(const Clip& a, const Clip& b, double t)
{
  return {between(a.x, b.x, t), between(a.y, b.y, t),         between(a.z, b.z, t),
          between(a.w, b.w, t), between(a.slack, b.slack, t), between(a.share, b.share, t)};
}

/// On the screen, with its own depth, those for the tests, of gaps the second, and its share of the
/// style's width.
struct Dot {
  double x, y, depth, tested, lenient, share;
};

Dot between(const Dot& a, const Dot& b, double t)
{
  return {between(a.x, b.x, t),
          between(a.y, b.y, t),
          between(a.depth, b.depth, t),
          between(a.tested, b.tested, t),
          between(a.lenient, b.lenient, t),
          between(a.share, b.share, t)};
}

enum class Seen { kNo, kHidden, kYes };

/// A segment of a chain that is before the eye.
struct Segment {
  Dot a, b;
  double from = 0, to = 1;   ///< shares inside the picture and its margin
  double start, length;      ///< along the chain
  double all = 1, left = 0;  ///< samples from a to b, and those of them before `seen`
  std::uint8_t flags;
  bool startsWhole, endsWhole;  ///< nothing was cut off there
  bool follows;                 ///< the segment before it ends where this one starts
  std::vector<Seen> seen;       ///< sample by sample
  std::vector<char> mayBeGap;   ///< hidden, but by no more than facets of the line's own can

  double share(std::size_t sample, double offset) const
  {
    return (left + static_cast<double>(sample) + offset) / all;
  }
};

/// What is drawn of a segment: pixels, half widths, depths.
struct Piece {
  Dot a, b;
  float halfA, halfB;
  float depthA, depthB;
  bool roundA, roundB;
};

constexpr float kNoDepth = 2;
constexpr double kShortest = 1e-6;
constexpr int kVoters = 2;  ///< to either side of a sample, of what it becomes
constexpr int kBlock = 64;  ///< lines are told by their distance to the corner of such blocks

/// Farther from its middle a line has no pixels.
double reachOf(const LineStyle& style)
{
  const double factor = std::max(1.0, static_cast<double>(style.outerFactor));
  return 0.5 * static_cast<double>(style.width) * factor + 1.0;
}

class Lines {
 public:
  Lines(const Scene& scene, const FrameView& frame, const WiderDepths& depths,
        const std::vector<Layer>& layers, const PanesOver& panes)
      : scene_(scene),
        frame_(frame),
        depths_(depths),
        layers_(layers),
        panes_(panes),
        toView_(scene.camera, frame.width, frame.height)
  {
    const auto pixels =
        static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    coverage_.resize(pixels);
    depth_.resize(pixels);
    if (isSplit()) open_.resize(pixels, Open{{0, 0, 0, 0}, 1});
  }

  void draw()
  {
    for (const Instance& instance : scene_.instances)
      if (!panes_ || !instance.isTranslucent()) draw(instance);
    for (const Instance& instance : scene_.instances)
      if (panes_ && instance.isTranslucent()) draw(instance);
    if (isSplit()) listOpen();
  }

 private:
  /// What lines have laid over those samples of a pixel that show nothing.
  struct Open {
    Vec4f color;  ///< multiplied by alpha, 255 is full
    float depth;
  };

  /// Whether samples that show nothing are left to the host.
  bool isSplit() const
  {
    return frame_.background == Background::kKeepApart && frame_.coverage != nullptr &&
           frame_.linePixels != nullptr;
  }

  void draw(const Instance& instance)
  {
    for (std::size_t i = 0; i < instance.lines.size(); ++i) {
      const LineSet& set = instance.lines[i];
      // Sets of equal style are one drawing.
      if (i == 0 || !(instance.lines[i - 1].style == set.style)) begin();
      cover(instance, set);
      if (i + 1 == instance.lines.size() || !(instance.lines[i + 1].style == set.style))
        blend(set.style, instance);
    }
  }

  std::size_t pixel(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(x);
  }

  void begin()
  {
    std::fill(coverage_.begin(), coverage_.end(), 0.0f);
    std::fill(depth_.begin(), depth_.end(), kNoDepth);
  }

  void cover(const Instance& instance, const LineSet& set)
  {
    toClip_ = scene_.camera.viewToClip * (scene_.camera.worldToView * instance.modelToWorld);
    for (std::size_t chain = 0; chain < set.chainCount(); ++chain)
      coverChain(set, set.first[chain], set.first[chain + 1]);
  }

  Clip clip(const LineSet& set, std::uint32_t vertex) const
  {
    const Vec3d p = set.points.position(vertex);
    const auto row = [&](int r) {
      return (toClip_.m[r][0] * p.x + toClip_.m[r][1] * p.y) +
             (toClip_.m[r][2] * p.z + toClip_.m[r][3]);
    };
    return {row(0),
            row(1),
            row(2),
            row(3),
            set.slack.empty() ? 0.0 : static_cast<double>(set.slack[vertex]),
            set.share.empty() ? 1.0 : static_cast<double>(set.share[vertex])};
  }
  Dot dot(const Clip& c) const
  {
    const double inverse = 1.0 / c.w;
    const double halfWidth = frame_.width / 2.0, halfHeight = frame_.height / 2.0;
    // Towards the eye: view z grows by the slack.
    const auto depthBefore = [&](double slack) {
      const double z = c.z + scene_.camera.viewToClip.m[2][2] * slack;
      const double w = c.w + scene_.camera.viewToClip.m[3][2] * slack;
      const bool isBeforeAll = z + w < 0 || w < kSmallestW;
      return isBeforeAll ? 0.0 : z / w * 0.5 + 0.5;
    };
    return {c.x * inverse * halfWidth + halfWidth,
            c.y * inverse * halfHeight + halfHeight,
            c.z * inverse * 0.5 + 0.5,
            depthBefore(c.slack),
            depthBefore(c.slack * kBridgedSlack),
            c.share};
  }

  /// Without its place along the chain and its samples.
  std::optional<Segment> segment(const LineSet& set, std::uint32_t p, std::uint32_t q) const
  {
    const Clip a = clip(set, p), b = clip(set, q);
    for (const double value : {a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w})
      if (!std::isfinite(value)) return std::nullopt;
    const double nearA = a.z + a.w, nearB = b.z + b.w;
    if (nearA < 0 && nearB < 0) return std::nullopt;
    const double t = nearA / (nearA - nearB);
    const Clip from = nearA < 0 ? between(a, b, t) : a;
    const Clip to = nearB < 0 ? between(a, b, t) : b;
    if (from.w < kSmallestW || to.w < kSmallestW) return std::nullopt;
    Segment result = {};
    result.a = dot(from);
    result.b = dot(to);
    result.from = 0;
    result.to = 1;
    result.startsWhole = nearA >= 0;
    result.endsWhole = nearB >= 0;
    return result;
  }

  /// Makes samples of the segment in the picture and a margin about it. False if there are none.
  bool clipToPicture(const LineSet& set, Segment& s) const
  {
    const double margin = reachOf(set.style) + kVoters;
    const double sides[4][2] = {{s.a.x + margin, s.b.x + margin},
                                {frame_.width + margin - s.a.x, frame_.width + margin - s.b.x},
                                {s.a.y + margin, s.b.y + margin},
                                {frame_.height + margin - s.a.y, frame_.height + margin - s.b.y}};
    for (const auto& [a, b] : sides) {
      if (a < 0 && b < 0) return false;
      if (a < 0) s.from = std::max(s.from, a / (a - b));
      if (b < 0) s.to = std::min(s.to, a / (a - b));
      if (!(s.from < s.to)) return false;
    }
    // A sample of which a part is in there is a whole one all the same.
    s.all = std::ceil(s.length);
    s.left = std::min(std::floor(s.from * s.all), s.all - 1);
    const double right = std::max(std::ceil(s.to * s.all), s.left + 1);
    s.seen.resize(static_cast<std::size_t>(right - s.left));
    s.startsWhole = s.startsWhole && s.left == 0;
    s.endsWhole = s.endsWhole && right == s.all;
    return true;
  }

  double depthOf(int x, int y) const
  {
    const int columns = frame_.width + 2 * depths_.apron;
    return depths_
        .depth[static_cast<std::size_t>(y + depths_.apron) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x + depths_.apron)];
  }
  /// The gentler one of the slopes to the two sides.
  static double slope(double before, double here, double after)
  {
    return std::fabs(here - before) < std::fabs(after - here) ? here - before : after - here;
  }

  bool isBefore(const Dot& p, double tested) const
  {
    // Of the neighbours' neighbours, too, depths have to be there.
    const double least = 2.0 - depths_.apron;
    const double right = frame_.width + depths_.apron - 3.0;
    const double top = frame_.height + depths_.apron - 3.0;
    const int column = static_cast<int>(std::clamp(std::floor(p.x), least, right));
    const int row = static_cast<int>(std::clamp(std::floor(p.y), least, top));
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = column + dx, y = row + dy;
        const double here = depthOf(x, y);
        const double slopeX = slope(depthOf(x - 1, y), here, depthOf(x + 1, y));
        const double slopeY = slope(depthOf(x, y - 1), here, depthOf(x, y + 1));
        const double surface = here + (slopeX * (p.x - (x + 0.5)) + slopeY * (p.y - (y + 0.5)));
        const double bias = kSlopePixels * (std::fabs(slopeX) + std::fabs(slopeY)) + kDepthBias;
        if (surface + bias >= tested) return true;
      }
    return false;
  }

  void look(Segment& s) const
  {
    s.mayBeGap.resize(s.seen.size());
    for (std::size_t i = 0; i < s.seen.size(); ++i) {
      const Dot p = between(s.a, s.b, s.share(i, 0.5));
      const bool isVisible = (s.flags & kConcealedLine) == 0 && isBefore(p, p.tested);
      s.seen[i] = p.depth > 1 ? Seen::kNo : isVisible ? Seen::kYes : Seen::kHidden;
      s.mayBeGap[i] = s.seen[i] == Seen::kHidden && (s.flags & kConcealedLine) == 0 &&
                      (s.flags & kOuterLine) != 0 && isBefore(p, p.lenient);
    }
  }

  /// Gaps are seen that lie between two samples which are.
  static void bridge(std::vector<Segment>& segments, bool isRing)
  {
    struct Sample {
      Seen* seen;
      bool mayBeGap, startsAnew;
    };
    std::vector<Sample> samples;
    for (Segment& s : segments)
      for (std::size_t i = 0; i < s.seen.size(); ++i) {
        const bool isFirst = samples.empty() ? !isRing : i == 0 && !s.follows;
        samples.push_back({&s.seen[i], s.mayBeGap[i] != 0, isFirst});
      }
    const std::size_t count = samples.size();
    std::vector<std::size_t> bridged;
    for (std::size_t i = 0; i < count; ++i) {
      if (!samples[i].mayBeGap) continue;
      // At most once around.
      std::size_t before = i, after = i, steps = 0;
      while (samples[before].mayBeGap && !samples[before].startsAnew && ++steps < count)
        before = (before + count - 1) % count;
      for (steps = 0; samples[after].mayBeGap && ++steps < count;) {
        const std::size_t next = (after + 1) % count;
        if (samples[next].startsAnew) break;
        after = next;
      }
      if (*samples[before].seen == Seen::kYes && *samples[after].seen == Seen::kYes)
        bridged.push_back(i);
    }
    for (const std::size_t i : bridged)
      *samples[i].seen = Seen::kYes;
  }

  /// Each sample becomes what most of the five about it are.
  static void smooth(std::vector<Segment>& segments)
  {
    std::vector<Seen*> samples;
    for (Segment& s : segments)
      for (Seen& seen : s.seen)
        samples.push_back(&seen);
    std::vector<Seen> old;
    old.reserve(samples.size());
    for (const Seen* seen : samples)
      old.push_back(*seen);
    const int last = static_cast<int>(old.size()) - 1;
    for (int i = 0; i <= last; ++i) {
      int visible = 0;
      for (int k = i - kVoters; k <= i + kVoters; ++k)
        visible += old[static_cast<std::size_t>(std::clamp(k, 0, last))] == Seen::kYes ? 1 : 0;
      Seen& seen = *samples[static_cast<std::size_t>(i)];
      if (seen != Seen::kNo) seen = visible > 2 ? Seen::kYes : Seen::kHidden;
    }
  }

  void coverChain(const LineSet& set, std::uint32_t first, std::uint32_t end)
  {
    const bool isClosed = end - first > 2 && set.vertex[first] == set.vertex[end - 1];
    std::vector<Segment> segments;
    double length = 0;
    bool isBroken = true, startsAtTheStart = false;
    for (std::uint32_t i = first; i + 1 < end; ++i) {
      auto s = segment(set, set.vertex[i], set.vertex[i + 1]);
      if (!s) {
        isBroken = true;
        continue;
      }
      const double dx = s->b.x - s->a.x, dy = s->b.y - s->a.y;
      s->length = std::sqrt(dx * dx + dy * dy);
      if (!(s->length <= kLongestSegment)) {
        isBroken = true;
        continue;
      }
      if (s->length <= kShortest) continue;
      s->start = length;
      length += s->length;
      if (!clipToPicture(set, *s)) {
        isBroken = true;
        continue;
      }
      s->flags = set.flags.empty() ? std::uint8_t{0} : set.flags[i];
      s->follows = !isBroken && s->startsWhole;
      look(*s);
      if (segments.empty()) startsAtTheStart = s->startsWhole && s->start == 0;
      isBroken = !s->endsWhole;
      segments.push_back(*s);
    }
    if (segments.empty()) return;
    const bool endsAtTheEnd = !isBroken;
    const bool isRing = isClosed && startsAtTheStart && endsAtTheEnd;
    bridge(segments, isRing && std::all_of(segments.begin() + 1, segments.end(),
                                           [](const Segment& s) { return s.follows; }));
    smooth(segments);
    if (isRing) segments.front().follows = true;
    const bool hasRoundEnds = set.style.cap == LineCap::kRound;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      const Segment& before = segments[(i + segments.size() - 1) % segments.size()];
      const Segment& after = segments[(i + 1) % segments.size()];
      const bool isLast = i + 1 == segments.size();
      const bool isFollowed = after.follows && (!isLast || isClosed);
      for (std::size_t k = 0; k < s.seen.size();) {
        std::size_t next = k;
        while (next < s.seen.size() && s.seen[next] == s.seen[k])
          ++next;
        bool joinsA = false, joinsB = false;
        if (k == 0)
          joinsA = s.follows ? before.seen.back() == s.seen[k]
                             : i == 0 && startsAtTheStart && hasRoundEnds;
        if (next == s.seen.size())
          joinsB =
              isFollowed ? after.seen.front() == s.seen[k] : isLast && endsAtTheEnd && hasRoundEnds;
        const bool isDrawn = s.seen[k] == Seen::kYes ||
                             (s.seen[k] == Seen::kHidden && set.style.hidden != HiddenLines::kOff);
        const Stretch stretch = {s.start + s.share(k, 0) * s.length,
                                 s.start + s.share(next, 0) * s.length, joinsA, joinsB};
        if (isDrawn)
          coverTapered({set.style, s, s.seen[k] == Seen::kHidden, isClosed, length}, stretch);
        k = next;
      }
    }
  }

  struct Stretch {
    double a, b;  ///< along the chain
    bool joinsA, joinsB;
  };
  /// What a stretch is of.
  struct Line {
    const LineStyle& style;
    const Segment& segment;
    bool isHidden, isClosed;
    double length;  ///< of the chain

    bool isTapered() const { return style.taper > 0 && !isClosed; }
  };

  void coverTapered(const Line& line, Stretch stretch)
  {
    if (line.isTapered()) {
      const auto taper = static_cast<double>(line.style.taper);
      std::vector<double> knots = {taper, line.length * 0.5, line.length - taper};
      std::sort(knots.begin(), knots.end());
      for (const double knot : knots)
        if (stretch.a < knot && knot < stretch.b) {
          coverDashes(line, {stretch.a, knot, stretch.joinsA, true});
          stretch = {knot, stretch.b, true, stretch.joinsB};
        }
    }
    coverDashes(line, stretch);
  }

  void coverDashes(const Line& line, const Stretch& stretch)
  {
    const LineStyle& style = line.style;
    double dash = style.dash, gap = style.gap;
    if (line.isHidden && style.hidden == HiddenLines::kDashed && style.dash == 0) {
      dash = kHiddenDash * static_cast<double>(style.width) + 2.0;
      gap = kHiddenGap * static_cast<double>(style.width) + 2.0;
    }
    if (dash == 0) {
      coverStretch(line, stretch);
      return;
    }
    for (double k = std::floor(stretch.a / (dash + gap)); k * (dash + gap) < stretch.b; k += 1) {
      const double begin = k * (dash + gap), end = begin + dash;
      const Stretch part = {std::max(begin, stretch.a), std::min(end, stretch.b),
                            begin <= stretch.a && stretch.joinsA,
                            end >= stretch.b && stretch.joinsB};
      if (part.a < part.b) coverStretch(line, part);
    }
  }

  static float halfWidth(const Line& line, double s)
  {
    double half = 0.5 * static_cast<double>(line.style.width);
    if ((line.segment.flags & kOuterLine) != 0) half *= static_cast<double>(line.style.outerFactor);
    if (line.isHidden) half *= static_cast<double>(kHiddenWidth);
    half *= between(line.segment.a, line.segment.b, (s - line.segment.start) / line.segment.length)
                .share;
    if (line.isTapered())
      half *= std::min(
          std::max(std::min(s, line.length - s), 0.0) / static_cast<double>(line.style.taper), 1.0);
    return static_cast<float>(half);
  }

  void coverStretch(const Line& line, const Stretch& stretch)
  {
    const Segment& s = line.segment;
    Piece piece;
    piece.a = between(s.a, s.b, (stretch.a - s.start) / s.length);
    piece.b = between(s.a, s.b, (stretch.b - s.start) / s.length);
    piece.halfA = halfWidth(line, stretch.a);
    piece.halfB = halfWidth(line, stretch.b);
    piece.depthA = line.isHidden ? kNoDepth : static_cast<float>(piece.a.depth);
    piece.depthB = line.isHidden ? kNoDepth : static_cast<float>(piece.b.depth);
    piece.roundA = stretch.joinsA;
    piece.roundB = stretch.joinsB;
    const double reach = static_cast<double>(std::max(piece.halfA, piece.halfB)) + 1.0;
    const auto pixelOf = [](double v, int size) {
      return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
    };
    const int x0 = pixelOf(std::floor(std::min(piece.a.x, piece.b.x) - reach), frame_.width);
    const int x1 = pixelOf(std::ceil(std::max(piece.a.x, piece.b.x) + reach), frame_.width);
    const int y0 = pixelOf(std::floor(std::min(piece.a.y, piece.b.y) - reach), frame_.height);
    const int y1 = pixelOf(std::ceil(std::max(piece.a.y, piece.b.y) + reach), frame_.height);
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        coverPixel(piece, x, y);
  }

  /// The share of a pixel that lies before a line of normal (x, y) at distance d from its centre:
  /// what a square turned against the line has on one side of it.
  static float shareBefore(double normalX, double normalY, float d)
  {
    const double more = std::max(std::fabs(normalX), std::fabs(normalY));
    const double less = std::max(std::min(std::fabs(normalX), std::fabs(normalY)), 1e-4);
    const auto inner = static_cast<float>(0.5 * (more - less));
    const auto outer = static_cast<float>(0.5 * (more + less));
    const float y = std::fabs(d);
    float share;
    if (y <= inner) {
      share = 0.5f + y * static_cast<float>(1.0 / more);
    } else {
      const float rest = outer > y ? outer - y : 0.0f;
      share = 1.0f - rest * rest * static_cast<float>(1.0 / (2.0 * more * less));
    }
    return d < 0.0f ? 1.0f - share : share;
  }

  static float positive(float v) { return v > 0.0f ? v : 0.0f; }

  void coverPixel(const Piece& piece, int column, int row)
  {
    const double dx = piece.b.x - piece.a.x, dy = piece.b.y - piece.a.y;
    const double length = std::sqrt(dx * dx + dy * dy);
    const double alongX = length > 0 ? dx / length : 1.0, alongY = length > 0 ? dy / length : 0.0;
    const int left = column / kBlock * kBlock, bottom = row / kBlock * kBlock;
    const double cornerX = left - piece.a.x, cornerY = bottom - piece.a.y;
    const float x = static_cast<float>(column - left) + 0.5f;
    const float y = static_cast<float>(row - bottom) + 0.5f;
    const float d = (static_cast<float>(cornerX * -alongY + cornerY * alongX) +
                     x * static_cast<float>(-alongY)) +
                    y * static_cast<float>(alongX);
    const float s =
        (static_cast<float>(cornerX * alongX + cornerY * alongY) + x * static_cast<float>(alongX)) +
        y * static_cast<float>(alongY);
    const auto end = static_cast<float>(length);
    const float t =
        std::min(positive(s * (length > 0 ? static_cast<float>(1.0 / length) : 0.0f)), 1.0f);

    // Beyond a round end what counts is the distance to it.
    const float beyond =
        (piece.roundA ? positive(-s) : 0.0f) + (piece.roundB ? positive(s - end) : 0.0f);
    const float distance = std::sqrt(d * d + beyond * beyond);
    const float half = piece.halfA + t * (piece.halfB - piece.halfA);
    const float across = shareBefore(-alongY, alongX, distance + half) -
                         shareBefore(-alongY, alongX, distance - half);
    const float from = piece.roundA ? -1e30f : 0.0f, to = piece.roundB ? 1e30f : end;
    const float along = std::min(positive(std::min(s + 0.5f, to) - std::max(s - 0.5f, from)), 1.0f);
    const float covered = across * along;
    if (!(covered > 0.0f)) return;
    const std::size_t at = pixel(column, row);
    coverage_[at] = std::max(coverage_[at], covered);
    depth_[at] = std::min(depth_[at], piece.depthA + t * (piece.depthB - piece.depthA));
  }

  void blend(const LineStyle& style, const Instance& instance)
  {
    const auto number = static_cast<std::uint32_t>(&instance - scene_.instances.data());
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x) {
        const float depth = depth_[pixel(x, y)];
        const float seen = coverage_[pixel(x, y)] * (1.0f - cutShare(x, y, depth, number));
        if (!(seen > 0.0f)) continue;
        const Vec3f c = style.color;
        const SeenLine line =
            panes_ ? panes_(x, y, c, depth, number)
                   : SeenLine{{std::min(c.x, 1.0f), std::min(c.y, 1.0f), std::min(c.z, 1.0f)}, c};
        blendPixel(line, y * frame_.rowStride + x, seen * style.opacity, depth);
      }
  }

  /// How much nearer than a pixel its neighbours of the same instance are, at most.
  float riseAt(std::size_t at) const
  {
    const int columns = frame_.width + 2 * depths_.apron;
    float rise = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Layer& near =
            layers_[static_cast<std::size_t>(static_cast<int>(at) + dy * columns + dx)];
        if (near.instance == layers_[at].instance)
          rise = std::max(rise, near.point.position.z - layers_[at].point.position.z);
      }
    return rise;
  }

  /// How much of a stroke of an instance a halo takes at a pixel.
  float cutShare(int x, int y, float depth, std::uint32_t instance) const
  {
    const int apron = depths_.apron, columns = frame_.width + 2 * apron;
    const int here = (y + apron) * columns + x + apron;
    if (layers_.empty() || layers_[static_cast<std::size_t>(here)].halo == 0) return 0;
    const Layer& under = layers_[static_cast<std::size_t>(here)];
    const Layer& before = layers_[under.haloOf];
    const float nearest = -before.point.position.z;
    const float centreX = static_cast<float>(x) + 0.5f, centreY = static_cast<float>(y) + 0.5f;
    const float distance = depth > 1 ? HUGE_VALF : -toView_.at(centreX, centreY, depth).position.z;
    const Halo& halo = scene_.instances[before.instance].style.cues.halo;
    const float full = halo.depth * halo.width * before.point.pixel;
    const auto of = static_cast<int>(under.haloOf);
    const auto dx = static_cast<float>(x + apron - of % columns);
    const auto dy = static_cast<float>(y + apron - of / columns);
    const float apart = std::sqrt(dx * dx + dy * dy);
    const float horizon = Halo::kHorizon * riseAt(under.haloOf) * (apart / 2 + 1);
    if (before.instance == instance && !(distance - nearest > full + horizon)) return 0;
    if (!(distance > nearest)) return 0;
    const float t = depth > 1 ? 1.0f : std::min(1.0f, (distance - nearest) / full);
    const float width = halo.width * ((t * t) * (3.0f - 2.0f * t));
    const float covered = static_cast<float>(before.count) / static_cast<float>(scene_.samples);
    const float fromBorder = apart - (covered - 0.5f);
    return width == 0 ? 0.0f : std::clamp(width + 0.5f - fromBorder, 0.0f, 1.0f);
  }

  void blendPixel(const SeenLine& line, std::ptrdiff_t index, float a, float depth)
  {
    float share = a;
    bool isNew = false;
    if (frame_.background == Background::kKeepApart && frame_.coverage != nullptr) {
      std::vector<int> open;
      for (int s = 0; s < scene_.samples; ++s)
        if ((frame_.coverage[index] >> s & 1) == 0) open.push_back(s);
      const int covered = scene_.samples - static_cast<int>(open.size());
      int more = static_cast<int>(std::floor(a * static_cast<float>(open.size()) + 0.5f));
      if (isSplit() && a < 1) {
        more = 0;
        addOpen(line.color, index, a, depth);
      }
      if (covered + more == 0) return;
      share = (static_cast<float>(more) + a * static_cast<float>(covered)) /
              static_cast<float>(covered + more);
      for (int i = 0; i < more; ++i)
        frame_.coverage[index] = static_cast<std::uint8_t>(frame_.coverage[index] |
                                                           1 << open[static_cast<std::size_t>(i)]);
      isNew = covered == 0;
    }
    const auto mixed = [&](float old, float own) { return old + (own - old) * share; };
    const auto byte = [&](std::uint8_t old, float own) {
      return static_cast<std::uint8_t>(std::floor(mixed(old, own * 255.0f) + 0.5f));
    };
    Rgba8& color = frame_.color[index];
    color = {byte(color.r, line.color.x), byte(color.g, line.color.y), byte(color.b, line.color.z),
             byte(color.a, 1.0f)};
    const RadianceView& planes = frame_.radiance;
    if (!planes.empty()) {
      planes.r[index] = mixed(planes.r[index], line.radiance.x);
      planes.g[index] = mixed(planes.g[index], line.radiance.y);
      planes.b[index] = mixed(planes.b[index], line.radiance.z);
    }
    if ((a >= 0.5f || isNew) && depth < frame_.depth[index]) frame_.depth[index] = depth;
  }

  void addOpen(Vec3f line, std::ptrdiff_t index, float a, float depth)
  {
    Open& open = open_[pixel(static_cast<int>(index % frame_.rowStride),
                             static_cast<int>(index / frame_.rowStride))];
    const auto over = [&](float old, float own) { return old + (own * 255.0f - old) * a; };
    open.color = {over(open.color.x, line.x), over(open.color.y, line.y),
                  over(open.color.z, line.z), over(open.color.w, 1.0f)};
    open.depth = std::min(open.depth, depth);
  }

  void listOpen() const
  {
    const auto byte = [](float value) {
      return static_cast<std::uint8_t>(std::floor(value + 0.5f));
    };
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x) {
        const Open& open = open_[pixel(x, y)];
        LinePixel one = {
            static_cast<std::uint16_t>(x),
            static_cast<std::uint16_t>(y),
            {byte(open.color.x), byte(open.color.y), byte(open.color.z), byte(open.color.w)},
            open.depth,
            0};
        for (int s = 0; s < scene_.samples; ++s)
          if ((frame_.coverage[y * frame_.rowStride + x] >> s & 1) == 0)
            one.samples = static_cast<std::uint8_t>(one.samples | 1 << s);
        if (one.color.a > 0 && one.samples != 0) frame_.linePixels->push_back(one);
      }
  }

  const Scene& scene_;
  const FrameView& frame_;
  const WiderDepths& depths_;
  const std::vector<Layer>& layers_;
  const PanesOver& panes_;
  ScreenToView toView_;
  Mat4d toClip_ = Mat4d::identity();
  std::vector<float> coverage_, depth_;  ///< of the drawing that is being made
  std::vector<Open> open_;
};

}  // namespace

int strokeApron(const Scene& scene)
{
  double widest = 0;
  for (const Instance& instance : scene.instances)
    for (const LineSet& set : instance.lines)
      widest = std::max(widest, std::ceil(reachOf(set.style)) + kStrokeApron);
  return static_cast<int>(std::min(widest, static_cast<double>(kWidestStrokeApron)));
}

void drawStrokes(const Scene& scene, const FrameView& frame, const WiderDepths& depths,
                 const std::vector<Layer>& layers, const PanesOver& panes)
{
  const bool isAny = std::any_of(scene.instances.begin(), scene.instances.end(),
                                 [](const Instance& one) { return !one.lines.empty(); });
  if (isAny) Lines(scene, frame, depths, layers, panes).draw();
}

}  // namespace limn::reference
