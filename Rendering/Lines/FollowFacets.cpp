// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FollowFacets.h"

#include "Rendering/Mesh/EdgesAhead.h"
#include "Rendering/Vertex/ScreenVertex.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace limn {
namespace {

/// Folds are looked for as far as so many edges times the angle between the normals at their ends:
/// in arcs an eighth lies between chord and curve. From half of that on points move less and less.
constexpr double kReach = 0.3;
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

double coveredBy(const LineStyle& style)
{
  if (style.opacity < 1) return kShowsNot;
  const double width = static_cast<double>(style.width) * static_cast<double>(style.outerFactor);
  return std::max(0.5 * width - kSoftened, kShowsNot);
}

struct ScreenPoint {
  double x, y, w;
  bool isPlaced;  ///< not before the near plane
};

struct ScreenEdge {
  Vec3d place[2];
  ScreenPoint screen[2];
};

/// An edge at which facets end on the screen.
struct Fold {
  std::uint32_t vertex[2];
  ScreenEdge edge;
  bool bulges;  ///< the nearer of its faces turns its front to the eye

  bool isSame(const Fold& other) const
  {
    return vertex[0] == other.vertex[0] && vertex[1] == other.vertex[1];
  }
};

/// What a segment may move to.
struct Reach {
  std::size_t firstFold, endFold;
  double pixels = 0;
  bool bulges = false;  ///< as its folds
};

/// What of an edge is nearest to a point.
struct Foot {
  double distance;  ///< in pixels
  Vec3d place;
};

Foot footOn(const ScreenEdge& edge, const ScreenPoint& p)
{
  const ScreenPoint &a = edge.screen[0], &b = edge.screen[1];
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

class Follower {
 public:
  Follower(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
           const Camera& camera, const Mat4d& modelToWorld, const LinePicture& picture,
           const ContourLines& smooth)
      : mesh_(mesh),
        table_(table),
        arrays_(arrays),
        smooth_(smooth),
        toClip_(camera.viewToClip * (camera.worldToView * modelToWorld)),
        eye_(camera, modelToWorld),
        halfWidth_(picture.width / 2.0),
        halfHeight_(picture.height / 2.0),
        covered_(coveredBy(picture.style))
  {
    for (int r = 0; r < 2; ++r) {
      const auto& m = toClip_.m[r];
      const double size = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      pixelsPerUnit_ = std::max(pixelsPerUnit_, size * (r == 0 ? halfWidth_ : halfHeight_));
    }
  }

  ContourLines follow()
  {
    moved_.points = smooth_.points;
    moved_.slack = smooth_.slack;
    moved_.chains.first.push_back(0);
    isSettled_.assign(smooth_.points.size(), 0);
    for (std::size_t c = 0; c + 1 < smooth_.chains.first.size(); ++c)
      follow(smooth_.chains.first[c], smooth_.chains.first[c + 1]);
    return std::move(moved_);
  }

 private:
  void follow(std::size_t first, std::size_t end)
  {
    first_ = first;
    count_ = end - first - 1;
    isClosed_ = count_ > 1 && smooth_.chains.vertex[first] == smooth_.chains.vertex[end - 1];
    folds_.clear();
    reaches_.clear();
    for (std::size_t i = 0; i < count_; ++i)
      reaches_.push_back(reachOf(first + i));
    if (folds_.empty()) {
      for (std::size_t i = 0; i <= count_; ++i)
        add(pointOf(i), i);
      moved_.chains.first.push_back(static_cast<std::uint32_t>(moved_.chains.vertex.size()));
      return;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      settle(i);
      add(pointOf(i), i);
      addSteps(i);
    }
    settle(count_);
    add(pointOf(count_), count_);
    moved_.chains.first.push_back(static_cast<std::uint32_t>(moved_.chains.vertex.size()));
  }
  std::uint32_t pointOf(std::size_t i) const { return smooth_.chains.vertex[first_ + i]; }

  void add(std::uint32_t point, std::size_t segment)
  {
    moved_.chains.vertex.push_back(point);
    moved_.chains.flags.push_back(smooth_.chains.flags[first_ + segment]);
    moved_.facets.push_back(smooth_.facets[first_ + segment]);
  }
  /// Moves the point from which a segment sets out, once.
  void settle(std::size_t segment)
  {
    const std::uint32_t point = pointOf(segment);
    if (isSettled_[point] != 0) return;
    isSettled_[point] = 1;
    const Step step = stepAtPoint(segment);
    moved_.points[point] = step.place;
    moved_.slack[point] *= static_cast<float>(step.rest);
  }
  void addBetween(const Step& step, std::size_t segment)
  {
    const auto slackOf = [&](std::size_t end) {
      return static_cast<double>(smooth_.slack[pointOf(end)]);
    };
    moved_.points.push_back(step.place);
    moved_.slack.push_back(static_cast<float>(
        step.rest * ((1 - step.share) * slackOf(segment) + step.share * slackOf(segment + 1))));
    add(static_cast<std::uint32_t>(moved_.points.size() - 1), segment);
  }

  void addSteps(std::size_t segment)
  {
    const About about = aboutOf(segment, 1);
    if (std::all_of(about.reach, about.reach + about.count,
                    [](const Reach* reach) { return reach->firstFold == reach->endFold; }))
      return;
    const ScreenPoint a = onScreen(smooth_.points[pointOf(segment)]);
    const ScreenPoint b = onScreen(smooth_.points[pointOf(segment + 1)]);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length = std::min(std::ceil(std::sqrt(dx * dx + dy * dy) / kStep), kMostSteps);
    const int count = length >= 1 ? static_cast<int>(length) : 0;
    steps_.clear();
    Step before = stepAtPoint(segment);
    bool isMoved = before.isMoved();
    for (int k = 1; k <= count; ++k) {
      const Step step =
          k < count ? stepAt(static_cast<double>(k) / count, segment) : stepAtEnd(segment);
      addCorners(before, step, segment, kHalvings);
      if (k < count) steps_.push_back(step);
      isMoved = isMoved || step.isMoved();
      before = step;
    }
    const bool hasCorners =
        std::any_of(steps_.begin(), steps_.end(), [](const Step& step) { return step.isMoved(); });
    if (!isMoved && !hasCorners) return;
    for (const Step& step : steps_)
      addBetween(step, segment);
  }
  /// Those that facets have between two steps, so far from the line that it has to go there. Where
  /// folds are short there may be more than one.
  void addCorners(const Step& a, const Step& b, std::size_t segment, int halvings)
  {
    if (a.fold == nullptr || b.fold == nullptr || a.fold->isSame(*b.fold)) return;
    const double share = 0.5 * (a.share + b.share);
    if (const ScreenPoint* const corner = cornerBetween(*a.fold, *b.fold)) {
      const Vec3d place = a.fold->edge.place[corner - a.fold->edge.screen];
      const Foot foot =
          footOn({{a.place, b.place}, {onScreen(a.place), onScreen(b.place)}}, *corner);
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
  static const ScreenPoint* cornerBetween(const Fold& a, const Fold& b)
  {
    for (int i = 0; i < 2; ++i)
      if (a.vertex[i] == b.vertex[0] || a.vertex[i] == b.vertex[1]) return &a.edge.screen[i];
    return nullptr;
  }

  ScreenPoint onScreen(Vec3d at) const
  {
    const auto row = [&](int r) {
      const auto& m = toClip_.m[r];
      return (m[0] * at.x + m[1] * at.y) + (m[2] * at.z + m[3]);
    };
    const double w = row(3);
    if (!(w >= kSmallestW) || !(row(2) + w >= 0)) return {0, 0, 1, false};
    return {row(0) / w * halfWidth_ + halfWidth_, row(1) / w * halfHeight_ + halfHeight_, w, true};
  }
  bool isInPicture(const ScreenPoint& p) const
  {
    return p.x > -kMargin && p.x < 2 * halfWidth_ + kMargin && p.y > -kMargin &&
           p.y < 2 * halfHeight_ + kMargin;
  }

  Vec3d normalOf(std::uint32_t corner) const
  {
    const std::uint32_t normal = arrays_.normalOfCorner.empty()
                                     ? mesh_.triangles[corner / 3].vertex[corner % 3]
                                     : arrays_.normalOfCorner[corner];
    return normalized(vec3Cast<double>(arrays_.vertexNormals[normal]));
  }
  std::uint32_t vertexOf(std::uint32_t corner) const
  {
    return table_.place[mesh_.triangles[corner / 3].vertex[corner % 3]];
  }
  /// Opposite to the edge that a face has from a corner on.
  Vec3d apexOf(std::uint32_t corner) const
  {
    return mesh_.position(vertexOf(nextCorner(nextCorner(corner))));
  }

  /// Of the segment from a place of the chains on.
  Reach reachOf(std::size_t place)
  {
    Reach reach;
    reach.firstFold = reach.endFold = folds_.size();
    const std::uint32_t triangle = smooth_.facets[place].triangle;
    if (triangle == kNoCorner) return reach;
    const std::uint32_t from = smooth_.chains.vertex[place], to = smooth_.chains.vertex[place + 1];
    const ScreenPoint a = onScreen(smooth_.points[from]), b = onScreen(smooth_.points[to]);
    if (!a.isPlaced || !b.isPlaced || (!isInPicture(a) && !isInPicture(b))) return reach;
    reach.pixels = kReach * turnOf(triangle) * pixelsPerUnit_ / std::min(a.w, b.w);
    if (!(reach.pixels > covered_)) return reach;
    reach.bulges = smooth_.facets[place].bulges;
    addFoldsAbout(triangle);
    reach.endFold = folds_.size();
    return reach;
  }
  /// The greatest length of an edge times the angle between its normals.
  double turnOf(std::uint32_t triangle) const
  {
    Vec3d p[3], n[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
      p[k] = mesh_.position(mesh_.triangles[triangle].vertex[k]);
      n[k] = normalOf(3 * triangle + k);
    }
    double squared = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec3d edge = p[(k + 1) % 3] - p[k], turn = n[(k + 1) % 3] - n[k];
      squared = std::max(squared, dot(edge, edge) * dot(turn, turn));
    }
    return std::sqrt(squared);
  }

  /// Of a triangle's edges and those of its neighbours.
  void addFoldsAbout(std::uint32_t triangle)
  {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const MeshEdge* const edge = edgeFrom(3 * triangle + k);
      if (edge == nullptr) continue;
      addFold(*edge);
      forEachFace(*edge, [&](std::uint32_t corner) {
        if (corner / 3 == triangle) return;
        for (const std::uint32_t other : {nextCorner(corner), nextCorner(nextCorner(corner))})
          if (const MeshEdge* const beside = edgeFrom(other); beside != nullptr) addFold(*beside);
      });
    }
  }
  /// Null where the table has left it out.
  const MeshEdge* edgeFrom(std::uint32_t corner) const
  {
    const auto [low, high] = std::minmax({vertexOf(corner), vertexOf(nextCorner(corner))});
    const MeshEdge* const end = table_.edges.data() + table_.edges.size();
    const MeshEdge* const found = std::lower_bound(
        table_.edges.data(), end, std::pair(low, high), [](const MeshEdge& edge, const auto& ends) {
          return std::pair(edge.vertex[0], edge.vertex[1]) < ends;
        });
    return found != end && found->vertex[0] == low && found->vertex[1] == high ? found : nullptr;
  }

  void addFold(const MeshEdge& edge)
  {
    Fold fold;
    for (int end = 0; end < 2; ++end) {
      fold.vertex[end] = edge.vertex[end];
      fold.edge.place[end] = mesh_.position(edge.vertex[end]);
      fold.edge.screen[end] = onScreen(fold.edge.place[end]);
      if (!fold.edge.screen[end].isPlaced) return;
    }
    const Vec3d along = fold.edge.place[1] - fold.edge.place[0];
    std::uint32_t nearer = edge.corner[0];
    if (edge.isShared()) {
      const Vec3d apex[2] = {apexOf(edge.corner[0]), apexOf(edge.corner[1])};
      const double side =
          sideOf(fold.edge, onScreen(apex[0])) * sideOf(fold.edge, onScreen(apex[1]));
      if (!(side > 0)) return;
      // One face hides the other if this lies behind its plane.
      const Vec3d normal = cross(along, apex[0] - fold.edge.place[0]);
      const bool isBefore = dot(normal, apex[1] - fold.edge.place[0]) > 0;
      if (isBefore == (dot(normal, eye_.toward(fold.edge.place[0])) > 0)) nearer = edge.corner[1];
    }
    const Vec3d normal = cross(along, apexOf(nearer) - fold.edge.place[0]);
    const std::uint32_t first = nearer / 3 * 3;
    const Vec3d outward = normalOf(first) + normalOf(first + 1) + normalOf(first + 2);
    fold.bulges = (dot(normal, outward) > 0) == (dot(normal, eye_.toward(fold.edge.place[0])) > 0);
    folds_.push_back(fold);
  }
  /// Of the edge's line; 0 if it is not known.
  static double sideOf(const ScreenEdge& edge, const ScreenPoint& p)
  {
    const ScreenPoint &a = edge.screen[0], &b = edge.screen[1];
    return p.isPlaced ? (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) : 0.0;
  }

  /// Of the point from which a segment sets out.
  Step stepAtPoint(std::size_t segment) const
  {
    return step(smooth_.points[pointOf(segment)], 0, segment, 0);
  }
  Step stepAt(double share, std::size_t segment) const
  {
    const Vec3d p = smooth_.points[pointOf(segment)], q = smooth_.points[pointOf(segment + 1)];
    return step(p + (q - p) * share, share, segment, 1);
  }
  Step stepAtEnd(std::size_t segment) const
  {
    Step step = stepAtPoint(segment + 1);
    step.share = 1;
    return step;
  }
  /// A segment, the one before it, and `after` of those after it.
  struct About {
    const Reach* reach[3];
    std::size_t count = 0;
  };
  About aboutOf(std::size_t segment, std::size_t after) const
  {
    About about;
    for (std::size_t k = 0; k < 2 + after; ++k) {
      const std::size_t place = segment + k;  // one ahead
      if (isClosed_ ? about.count < count_ : place > 0 && place <= count_)
        about.reach[about.count++] = &reaches_[(place + count_ - 1) % count_];
    }
    return about;
  }
  /// By what aboutOf() has.
  Step step(Vec3d at, double share, std::size_t segment, std::size_t after) const
  {
    const ScreenPoint screen = onScreen(at);
    Step step = {share, nullptr, at, 1};
    if (!screen.isPlaced) return step;
    const About about = aboutOf(segment, after);
    double reach = 0;
    bool bulges = false;
    for (std::size_t k = 0; k < about.count; ++k) {
      reach = std::max(reach, about.reach[k]->pixels);
      bulges = bulges || about.reach[k]->bulges;
    }
    Foot nearest = {reach, at};
    for (std::size_t k = 0; k < about.count; ++k)
      for (std::size_t f = about.reach[k]->firstFold; f < about.reach[k]->endFold; ++f) {
        if (folds_[f].bulges != bulges) continue;
        const Foot foot = footOn(folds_[f].edge, screen);
        if (!(foot.distance < nearest.distance)) continue;
        nearest = foot;
        step.fold = &folds_[f];
      }
    if (step.fold == nullptr || !(nearest.distance > covered_)) return step;
    const double move = std::min(2 - 2 * nearest.distance / reach, 1.0);
    step.rest = 1 - move * (1 - covered_ / nearest.distance);
    step.place = nearest.place + (at - nearest.place) * step.rest;
    return step;
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  const FeatureArrays& arrays_;
  const ContourLines& smooth_;
  Mat4d toClip_;
  ModelEye eye_;
  double halfWidth_, halfHeight_, covered_;
  double pixelsPerUnit_ = 0;  ///< at w = 1, at most
  ContourLines moved_;
  std::vector<char> isSettled_;  ///< by point: is moved, if it has to be
  // Of the chain that is followed.
  std::size_t first_ = 0, count_ = 0;  ///< of its segments
  bool isClosed_ = false;
  std::vector<Fold> folds_;
  std::vector<Reach> reaches_;  ///< by segment
  std::vector<Step> steps_;     ///< of a segment, between its ends
};

}  // namespace

void followFacets(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                  const Camera& camera, const Mat4d& modelToWorld, const LinePicture& picture,
                  ContourLines& contours)
{
  contours = Follower(mesh, table, arrays, camera, modelToWorld, picture, contours).follow();
}

}  // namespace limn
