// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FollowFacets.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Lines/Folds.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace limn {
namespace {

/// Folds are looked for as far as so many edges times the angle between the normals at their ends:
/// in arcs an eighth lies between chord and curve. From half of that on points move less and less.
constexpr double kReach = 0.3;
/// Unit vectors are no farther apart, rounding included.
constexpr double kMostTurn = 2.001;
/// Lines are moved at steps of so many pixels, and a segment at no more places than that.
constexpr double kStep = 4;
constexpr double kMostSteps = 64;
/// Where it passes more than one corner, a step is halved so often.
constexpr int kHalvings = 3;
/// A stroke covers what lies less far from its middle than half of it, but for the pixel's half
/// that its border softens; and so little does not show.
constexpr double kSoftened = 0.5, kShowsNot = 0.25;
/// Contours farther out of the picture than this stay as they are.
constexpr double kMargin = 64;
constexpr std::size_t kPlacesPerTask = 1024;

double coveredBy(const LineStyle& style)
{
  if (style.opacity < 1) return kShowsNot;
  const double width = static_cast<double>(style.width) * static_cast<double>(style.outerFactor);
  return std::max(0.5 * width - kSoftened, kShowsNot);
}

/// What a segment may move to.
struct Reach {
  double pixels = 0;
  bool bulges = false;  ///< as its folds
  std::vector<Fold> folds;
};

/// What of an edge is nearest to a point.
struct Foot {
  double distance;  ///< in pixels
  Vec3d place;
};

Foot footOn(const PlacedEdge& edge, const PlacedPoint& p)
{
  const PlacedPoint &a = edge.screen[0], &b = edge.screen[1];
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const double t = squared > 0 ? std::min(std::max(along / squared, 0.0), 1.0) : 0.0;
  const double x = a.x + t * dx - p.x, y = a.y + t * dy - p.y;
  // What is linear on the screen is not so in space.
  const double share = t * a.w / (b.w * (1 - t) + t * a.w);
  return {std::sqrt(x * x + y * y),
          t < 1 ? edge.place[0] + (edge.place[1] - edge.place[0]) * share : edge.place[1]};
}

/// A place of the line, and where it goes.
struct Step {
  double share;      ///< of its segment
  const Fold* fold;  ///< the nearest within reach, or null
  Vec3d place;
  double rest;  ///< what share of the way to the fold is left

  bool isMoved() const { return rest < 1; }
};

/// What becomes of some places of the chains, in their order.
struct FollowedPlaces {
  struct Move {
    std::size_t place;
    Vec3d to;
    double rest;
  };
  /// Behind the point at a place.
  struct Addition {
    std::size_t place;
    Vec3d point;
    float slack;
  };
  std::vector<Move> moves, endMoves;  ///< of the chains' ends apart, as chains share them
  std::vector<Addition> additions;
  std::vector<std::size_t> chains;  ///< that have folds in reach here
};

/// Follows chains, one thread each. Nothing is kept from one segment to the next but what is found
/// sooner that way, so that it may begin anywhere.
class Follower {
 public:
  Follower(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
           const LinePicture& picture, const ContourLines& smooth)
      : mesh_(mesh),
        smooth_(smooth),
        covered_(coveredBy(picture.style)),
        plane_(picture.camera, picture.modelToWorld, picture.width, picture.height),
        eye_(picture.camera, picture.modelToWorld),
        finder_(mesh, table, arrays, plane_, eye_)
  {
  }

  /// The places [begin, end).
  void follow(std::size_t begin, std::size_t end, FollowedPlaces& result)
  {
    const std::vector<std::uint32_t>& first = smooth_.chains.first;
    auto chain = static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), begin) -
                                          first.begin() - 1);
    for (; chain + 1 < first.size() && first[chain] < end; ++chain) {
      first_ = first[chain];
      last_ = first[chain + 1] - 1;
      isClosed_ = last_ - first_ > 1 && pointAt(first_) == pointAt(last_);
      if (followChain(std::max(begin, first_), std::min(end, last_ + 1), result))
        result.chains.push_back(chain);
    }
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// The places [begin, end) of one chain; whether there are folds in reach.
  bool followChain(std::size_t begin, std::size_t end, FollowedPlaces& result)
  {
    findReach(segmentBefore(begin), before_);
    findReach(begin < last_ ? begin : kNone, own_);
    bool hasFolds = false;
    Step here = stepAtPoint(begin, before_, own_);
    for (std::size_t place = begin; place < end; ++place) {
      findReach(segmentAfter(place), after_);
      hasFolds = hasFolds || !own_.folds.empty();
      const bool isEnd = place == first_ || place == last_;
      if (here.fold != nullptr)
        (isEnd ? result.endMoves : result.moves).push_back({place, here.place, here.rest});
      if (place == last_) break;
      const Step there = stepAtPoint(place + 1, own_, after_);
      if (!before_.folds.empty() || !own_.folds.empty() || !after_.folds.empty())
        addSteps(place, here, there, result.additions);
      here = there;  // whose fold stays where it is
      std::swap(before_, own_);
      std::swap(own_, after_);
    }
    return hasFolds;
  }

  std::uint32_t pointAt(std::size_t place) const { return smooth_.chains.vertex[place]; }
  Vec3d positionAt(std::size_t place) const { return smooth_.points[pointAt(place)]; }
  // Segments are named by the place from which they set out.
  std::size_t segmentBefore(std::size_t place) const
  {
    if (place > first_) return place - 1;
    return isClosed_ ? last_ - 1 : kNone;
  }
  std::size_t segmentAfter(std::size_t segment) const
  {
    if (segment + 1 < last_) return segment + 1;
    return isClosed_ && segment + 1 == last_ ? first_ : kNone;
  }

  void findReach(std::size_t segment, Reach& reach)
  {
    reach.pixels = 0;
    reach.bulges = false;
    reach.folds.clear();
    if (segment == kNone) return;
    const ContourFacet facet = smooth_.facets[segment];
    if (facet.triangle == kNoCorner) return;
    const PlacedPoint a = plane_.place(positionAt(segment)),
                      b = plane_.place(positionAt(segment + 1));
    if (!a.isPlaced || !b.isPlaced) return;
    if (!plane_.contains(a, kMargin) && !plane_.contains(b, kMargin)) return;
    const auto pixelsOf = [&](double turn) {
      return kReach * turn * plane_.pixelsPerUnit() / std::min(a.w, b.w);
    };
    // Without their normals first, which are read from elsewhere.
    if (!(pixelsOf(kMostTurn * longestEdge(facet.triangle)) > covered_)) return;
    reach.pixels = pixelsOf(turnOf(facet.triangle));
    if (!(reach.pixels > covered_)) return;
    reach.bulges = facet.bulges;
    finder_.addAbout(facet.triangle, reach.folds);
  }
  double longestEdge(std::uint32_t triangle) const
  {
    const auto [a, b, c] = mesh_.triangles[triangle].vertex;
    const Vec3d p = mesh_.position(a), q = mesh_.position(b), r = mesh_.position(c);
    const auto squared = [](Vec3d v) { return dot(v, v); };
    return std::sqrt(std::max({squared(q - p), squared(r - q), squared(p - r)}));
  }
  /// The greatest length of an edge times the angle between its normals.
  double turnOf(std::uint32_t triangle) const
  {
    Vec3d p[3], n[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
      p[k] = mesh_.position(mesh_.triangles[triangle].vertex[k]);
      n[k] = finder_.normalOf(3 * triangle + k);
    }
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3d edge = p[(k + 1) % 3] - p[k], turn = n[(k + 1) % 3] - n[k];
      squared = std::max(squared, dot(edge, edge) * dot(turn, turn));
    }
    return std::sqrt(squared);
  }

  void addSteps(std::size_t segment, const Step& here, const Step& there,
                std::vector<FollowedPlaces::Addition>& additions)
  {
    const PlacedPoint a = plane_.place(positionAt(segment)),
                      b = plane_.place(positionAt(segment + 1));
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::min(std::ceil(std::sqrt(dx * dx + dy * dy) / kStep), kMostSteps);
    const int count = length >= 1 ? static_cast<int>(length) : 0;
    steps_.clear();
    Step before = here;
    before.share = 0;
    bool isMoved = before.isMoved();
    for (int k = 1; k <= count; ++k) {
      Step step = there;
      step.share = static_cast<double>(k) / count;
      if (k < count) step = stepAt(step.share, segment);
      addCorners(before, step, segment, kHalvings);
      if (k < count) steps_.push_back(step);
      isMoved = isMoved || step.isMoved();
      before = step;
    }
    const bool hasCorners =
        std::any_of(steps_.begin(), steps_.end(), [](const Step& step) { return step.isMoved(); });
    if (!isMoved && !hasCorners) return;
    const auto slackOf = [&](std::size_t place) {
      return static_cast<double>(smooth_.slack[pointAt(place)]);
    };
    for (const Step& step : steps_) {
      const double slack = (1 - step.share) * slackOf(segment) + step.share * slackOf(segment + 1);
      additions.push_back({segment, step.place, static_cast<float>(step.rest * slack)});
    }
  }
  /// Those that facets have between two steps, so far from the line that it has to go there. Where
  /// folds are short there may be more than one.
  void addCorners(const Step& a, const Step& b, std::size_t segment, int halvings)
  {
    if (a.fold == nullptr || b.fold == nullptr || a.fold->isSame(*b.fold)) return;
    const double share = 0.5 * (a.share + b.share);
    if (const PlacedPoint* const corner = cornerBetween(*a.fold, *b.fold)) {
      const Vec3d place = a.fold->edge.place[corner - a.fold->edge.screen];
      const Foot foot =
          footOn({{a.place, b.place}, {plane_.place(a.place), plane_.place(b.place)}}, *corner);
      if (!(foot.distance > covered_)) return;
      const double rest = covered_ / foot.distance;
      steps_.push_back({share, nullptr, place + (foot.place - place) * rest, rest});
    } else if (halvings > 0) {
      const Step middle = stepAt(share, segment);
      addCorners(a, middle, segment, halvings - 1);
      steps_.push_back(middle);
      addCorners(middle, b, segment, halvings - 1);
    }
  }
  /// One of a's ends.
  static const PlacedPoint* cornerBetween(const Fold& a, const Fold& b)
  {
    for (int i = 0; i < 2; ++i)
      if (a.vertex[i] == b.vertex[0] || a.vertex[i] == b.vertex[1]) return &a.edge.screen[i];
    return nullptr;
  }

  /// By what the segments on both sides of it reach.
  Step stepAtPoint(std::size_t place, const Reach& in, const Reach& out) const
  {
    const Reach* const about[] = {&in, &out};
    return step(positionAt(place), 0, {about, 2});
  }
  Step stepAt(double share, std::size_t segment) const
  {
    const Vec3d p = positionAt(segment), q = positionAt(segment + 1);
    const Reach* const about[] = {&before_, &own_, &after_};
    return step(p + (q - p) * share, share, {about, 3});
  }
  Step step(Vec3d at, double share, Span<const Reach* const> about) const
  {
    Step step = {share, nullptr, at, 1};
    double within = 0;
    bool bulges = false;
    for (const Reach* const reach : about) {
      within = std::max(within, reach->pixels);
      bulges = bulges || reach->bulges;
    }
    if (!(within > covered_)) return step;
    const PlacedPoint screen = plane_.place(at);
    if (!screen.isPlaced) return step;
    Foot nearest = {within, at};
    for (const Reach* const reach : about)
      for (const Fold& fold : reach->folds) {
        if (fold.bulges != bulges) continue;
        const Foot foot = footOn(fold.edge, screen);
        if (!(foot.distance < nearest.distance)) continue;
        nearest = foot;
        step.fold = &fold;
      }
    if (step.fold == nullptr || !(nearest.distance > covered_)) return step;
    const double move = std::min(2 - 2 * nearest.distance / within, 1.0);
    step.rest = 1 - move * (1 - covered_ / nearest.distance);
    step.place = nearest.place + (at - nearest.place) * step.rest;
    return step;
  }

  const MeshView& mesh_;
  const ContourLines& smooth_;
  double covered_;
  PicturePlane plane_;
  ModelEye eye_;
  FoldFinder finder_;
  // Of the chain that is followed: its places, both ends included.
  std::size_t first_ = 0, last_ = 0;
  bool isClosed_ = false;
  Reach before_, own_, after_;  ///< of the segment that is followed, and those beside it
  std::vector<Step> steps_;     ///< of a segment, between its ends
};

/// Puts what was found into the contours, kPlacesPerTask of whose places each task followed.
class FollowedContours {
 public:
  FollowedContours(Span<const FollowedPlaces> followed, ContourLines& contours)
      : followed_(followed), contours_(contours), pointCount_(contours.points.size())
  {
    for (const FollowedPlaces& some : followed) {
      before_.push_back(added_);
      added_ += some.additions.size();
      isMoved_ = isMoved_ || !some.moves.empty() || !some.endMoves.empty();
    }
  }

  void put(int threads)
  {
    if (!isMoved_ && added_ == 0) return;
    moveEnds();
    contours_.points.resize(pointCount_ + added_);
    contours_.slack.resize(pointCount_ + added_);
    const std::size_t count = contours_.chains.vertex.size();
    chains_.vertex.resize(count + added_);
    chains_.flags.resize(count + added_);
    facets_.resize(count + added_);
    chains_.first.assign(contours_.chains.first.size(),
                         static_cast<std::uint32_t>(chains_.vertex.size()));
    parallelForStretches(threads, count, kPlacesPerTask,
                         [this](std::size_t task, std::size_t begin, std::size_t end) {
                           for (const FollowedPlaces::Move& move : followed_[task].moves)
                             apply(move);
                           putPlaces(task, begin, end);
                         });
    contours_.chains = std::move(chains_);
    contours_.facets = std::move(facets_);
  }

 private:
  void apply(const FollowedPlaces::Move& move)
  {
    const std::uint32_t point = contours_.chains.vertex[move.place];
    contours_.points[point] = move.to;
    contours_.slack[point] *= static_cast<float>(move.rest);
  }
  /// Several chains may end at one point: the first of those that have folds tells where it goes.
  void moveEnds()
  {
    const LineChains& chains = contours_.chains;
    std::vector<char> isSettled(pointCount_, 0);
    for (const FollowedPlaces& some : followed_)
      for (const std::size_t chain : some.chains)
        for (const std::size_t place :
             {std::size_t{chains.first[chain]}, std::size_t{chains.first[chain + 1]} - 1}) {
          if (std::exchange(isSettled[chains.vertex[place]], 1) == 0) moveEnd(place);
        }
  }
  void moveEnd(std::size_t place)
  {
    const std::vector<FollowedPlaces::Move>& moves = followed_[place / kPlacesPerTask].endMoves;
    const auto move = std::lower_bound(
        moves.begin(), moves.end(), place,
        [](const FollowedPlaces::Move& one, std::size_t at) { return one.place < at; });
    if (move != moves.end() && move->place == place) apply(*move);
  }
  void putPlaces(std::size_t task, std::size_t begin, std::size_t end)
  {
    const LineChains& chains = contours_.chains;
    const std::vector<FollowedPlaces::Addition>& additions = followed_[task].additions;
    std::size_t to = begin + before_[task], next = 0;
    const auto add = [&](std::uint32_t point, std::size_t place) {
      chains_.vertex[to] = point;
      chains_.flags[to] = chains.flags[place];
      facets_[to] = contours_.facets[place];
      ++to;
    };
    auto chain = static_cast<std::size_t>(
        std::lower_bound(chains.first.begin(), chains.first.end(), begin) - chains.first.begin());
    for (std::size_t place = begin; place < end; ++place) {
      if (place == chains.first[chain]) chains_.first[chain++] = static_cast<std::uint32_t>(to);
      add(chains.vertex[place], place);
      for (; next < additions.size() && additions[next].place == place; ++next) {
        const std::size_t point = pointCount_ + before_[task] + next;
        contours_.points[point] = additions[next].point;
        contours_.slack[point] = additions[next].slack;
        add(static_cast<std::uint32_t>(point), place);
      }
    }
  }

  Span<const FollowedPlaces> followed_;
  ContourLines& contours_;
  std::size_t pointCount_, added_ = 0;
  std::vector<std::size_t> before_;  ///< by task: points that those before it add
  bool isMoved_ = false;
  LineChains chains_;
  std::vector<ContourFacet> facets_;
};

}  // namespace

void followFacets(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                  const LinePicture& picture, int threads, ContourLines& contours)
{
  const std::size_t count = contours.chains.vertex.size();
  std::vector<FollowedPlaces> followed(stretchCount(count, kPlacesPerTask));
  parallelForStretches(
      threads, count, kPlacesPerTask, [&](std::size_t task, std::size_t begin, std::size_t end) {
        Follower(mesh, table, arrays, picture, contours).follow(begin, end, followed[task]);
      });
  FollowedContours(followed, contours).put(threads);
}

}  // namespace limn
