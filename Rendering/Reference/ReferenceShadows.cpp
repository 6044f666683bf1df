// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceShadows.h"

#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cmath>

namespace limn::reference {
namespace {

/// In the half plane of an edge.
struct Line {
  double u0, w0, u1, w1;
  std::uint32_t triangle;
  bool endsLight, isWayOut;  ///< whatever else is met

  double w(double u) const
  {
    if (u == u0) return w0;
    if (u == u1) return w1;
    return w0 + (w1 - w0) * ((u - u0) / (u1 - u0));
  }
  void cutAt(double low, double high)
  {
    const Line whole = *this;
    if (u0 < low) {
      w0 = whole.w(low);
      u0 = low;
    }
    if (u1 > high) {
      w1 = whole.w(high);
      u1 = high;
    }
  }
};

/// What one caster does.
class Shadow {
 public:
  Shadow(const WorldMesh& world, const LightRays& light, const ShadowCaster& caster,
         double creaseDegrees)
      : world_(world),
        light_(light),
        caster_(caster),
        bound_(cosineOfDegrees(creaseDegrees)),
        a_(caster.end[0]),
        b_(caster.end[1]),
        e_(b_ - a_)
  {
  }

  void cast(std::uint32_t number, std::vector<ShadowPiece>& pieces) const
  {
    double low, high;
    if (isAlongRays() || !coneHolds(low, high)) return;
    std::vector<Line> lines;
    for (std::uint32_t t = 0; t < world_.triangles.size(); ++t)
      if (Line line; !world_.isBroken(t) && !isAtCaster(t) && cut(t, line) && line.u1 > low &&
                     line.u0 < high) {
        line.cutAt(low, high);
        line.endsLight = endsLight(line);
        line.isWayOut = isOwn(line) && isNextTo(line) && !isOnRightSide(line);
        lines.push_back(line);
      }
    const Steps steps = stepsOf(low, high, lines);
    const std::vector<double> stops = stopsOf(lines, steps);
    const Line* before = nullptr;
    double since = 0;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (!(stops[i] < stops[i + 1])) continue;
      const Line* const first = steps.areDarkAt(0.5 * (stops[i] + stops[i + 1]))
                                    ? nullptr
                                    : firstOn(stops[i], stops[i + 1], lines);
      if (first != before) {
        if (before != nullptr) add(number, *before, since, stops[i], pieces);
        before = first;
        since = stops[i];
      }
    }
    if (before != nullptr) add(number, *before, since, stops.back(), pieces);
  }

 private:
  Vec3d planeNormal() const
  {
    if (light_.isParallel) return cross(e_, -light_.source);
    return cross(a_ - light_.source, b_ - light_.source);
  }
  double side(Vec3d p) const { return dot(planeNormal(), p - a_); }
  bool isAlongRays() const
  {
    constexpr double kLeast = 1e-12 * 1e-12;
    if (light_.isParallel) {
      const Vec3d d = -light_.source, across = e_ - d * dot(e_, d);
      return !(dot(across, across) > kLeast * dot(e_, e_)) || !(dot(across, across) < HUGE_VAL);
    }
    const Vec3d toA = a_ - light_.source, toB = b_ - light_.source, n = planeNormal();
    return !(dot(n, n) > kLeast * (dot(toA, toA) * dot(toB, toB))) || !(dot(n, n) < HUGE_VAL);
  }
  Vec3d normal(std::uint32_t t) const
  {
    return normalized(cross(world_.corner(t, 1) - world_.corner(t, 0),
                            world_.corner(t, 2) - world_.corner(t, 0)));
  }
  bool hasPoint(std::uint32_t t, std::uint32_t p) const
  {
    const auto& v = world_.triangles[t].vertex;
    return std::count(v, v + 3, p) > 0;
  }
  bool isAtCaster(std::uint32_t t) const
  {
    if (caster_.isContour()) return t == caster_.triangle[0];
    return hasPoint(t, caster_.point[0]) && hasPoint(t, caster_.point[1]);
  }

  /// Of the caster's own body, if facets next to it may deceive.
  bool isOwn(const Line& line) const
  {
    return caster_.reach > 0 && world_.body[line.triangle] == caster_.body;
  }
  bool isOnRightSide(const Line& line) const
  {
    const std::uint32_t t = line.triangle;
    const bool showsOut = dot(normal(t), light_.towardLight(world_.corner(t, 0))) > 0;
    return showsOut == caster_.bulgesOut;
  }
  bool isNextTo(const Line& line) const
  {
    const double u = 0.5 * (line.u0 + line.u1);
    const Vec3d way = at(u, line.w(u)) - at(u, 0);
    if (!(dot(way, way) <= caster_.reach * caster_.reach)) return false;
    for (const std::uint32_t t : caster_.triangle)
      if (dot(normal(line.triangle), normal(t)) >= bound_) return true;
    return false;
  }
  bool isBefore(const Line& line) const { return 0.5 * (line.w0 + line.w1) >= 0; }

  /// Of those that reach over the whole of an interval the one at which the light ends, told by
  /// going along its ray.
  const Line* firstOn(double from, double to, const std::vector<Line>& lines) const
  {
    const double u = 0.5 * (from + to);
    std::vector<const Line*> met;
    for (const Line& line : lines)
      if (line.u0 <= from && line.u1 >= to) met.push_back(&line);
    std::stable_sort(met.begin(), met.end(),
                     [&](const Line* a, const Line* b) { return a->w(u) > b->w(u); });
    bool isFirst = true;
    for (std::size_t i = 0; i < met.size(); ++i) {
      const Line& line = *met[i];
      if (!isOwn(line)) return &line;
      const bool isNear = isNextTo(line), isRight = isOnRightSide(line);
      if (isBefore(line)) {
        if (!isNear) return &line;
        // Comes through a contour's surface from the wrong side.
        if (isFirst && caster_.isContour() && !isRight) return &line;
        isFirst = false;
      } else if (isRight) {
        const bool leaves = std::any_of(
            met.begin() + static_cast<std::ptrdiff_t>(i) + 1, met.end(), [&](const Line* later) {
              return isOwn(*later) && isNextTo(*later) && !isOnRightSide(*later);
            });
        if (!isNear || !leaves) return &line;
      } else if (!isNear && world_.isClosed[caster_.body] == 0) {
        return &line;
      }
    }
    return nullptr;
  }

  /// u and w of the straight line in which the half plane cuts a triangle.
  bool cut(std::uint32_t t, Line& line) const
  {
    const auto& v = world_.triangles[t].vertex;
    std::vector<Vec3d> ends;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = std::min(v[k], v[(k + 1) % 3]);
      const std::uint32_t to = std::max(v[k], v[(k + 1) % 3]);
      const Vec3d p = world_.points[from], q = world_.points[to];
      if ((side(p) >= 0) != (side(q) >= 0))
        ends.push_back(p + (q - p) * (side(p) / (side(p) - side(q))));
    }
    if (ends.size() != 2) return false;
    line.triangle = t;
    if (light_.isParallel) {
      placeParallel(ends[0], line.u0, line.w0);
      placeParallel(ends[1], line.u1, line.w1);
    } else if (!placeFromPoint(ends[0], ends[1], line)) {
      return false;
    }
    if (line.u0 > line.u1) line = {line.u1, line.w1, line.u0, line.w0, t, false, false};
    return line.u0 < line.u1;
  }
  void placeParallel(Vec3d x, double& u, double& w) const
  {
    const Vec3d d = -light_.source, across = e_ - d * dot(e_, d);
    u = dot(x - a_, across) / dot(across, across);
    w = u * dot(e_, d) - dot(x - a_, d);
  }
  bool placeFromPoint(Vec3d from, Vec3d to, Line& line) const
  {
    const Vec3d toA = a_ - light_.source, toB = b_ - light_.source, n = planeNormal();
    // x = L + alpha (A - L) + beta (B - L), and alpha + beta grows from the light.
    const auto alpha = [&](Vec3d x) { return dot(cross(x - light_.source, toB), n) / dot(n, n); };
    const auto beta = [&](Vec3d x) { return dot(cross(toA, x - light_.source), n) / dot(n, n); };
    double p[2] = {alpha(from), beta(from)}, q[2] = {alpha(to), beta(to)};
    const double sP = p[0] + p[1], sQ = q[0] + q[1];
    if (sP < kShadowNear && sQ < kShadowNear) return false;
    const double t = (kShadowNear - sP) / (sQ - sP);
    const double cut[2] = {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
    if (sP < kShadowNear) std::copy(cut, cut + 2, p);
    if (sQ < kShadowNear) std::copy(cut, cut + 2, q);
    line.u0 = p[1] / (p[0] + p[1]);
    line.u1 = q[1] / (q[0] + q[1]);
    line.w0 = 1.0 / (p[0] + p[1]) - 1.0;
    line.w1 = 1.0 / (q[0] + q[1]) - 1.0;
    return true;
  }

  /// Of a line that is not next to the caster: what firstOn() does not pass by.
  bool endsLight(const Line& line) const
  {
    if (!isOwn(line)) return true;
    if (isNextTo(line)) return false;
    return isBefore(line) || isOnRightSide(line) || world_.isClosed[caster_.body] == 0;
  }

  /// The caster's steps, and in which one triangle alone keeps the light from all of it.
  struct Steps {
    double start[kShadowSteps + 1];
    bool isDark[kShadowSteps];

    bool areDarkAt(double u) const
    {
      const auto after = std::count_if(start + 1, start + kShadowSteps,
                                       [&](double border) { return border <= u; });
      return isDark[after];
    }
  };
  static Steps stepsOf(double low, double high, const std::vector<Line>& lines)
  {
    Steps steps;
    for (int k = 0; k < kShadowSteps; ++k)
      steps.start[k] = low + (high - low) * (k * (1.0 / kShadowSteps));
    steps.start[kShadowSteps] = high;
    for (int k = 0; k < kShadowSteps; ++k) {
      const double from = steps.start[k], to = steps.start[k + 1];
      steps.isDark[k] = std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
        return line.endsLight && line.u0 <= from && line.u1 >= to && line.w(from) >= 0 &&
               line.w(to) >= 0;
      });
    }
    return steps;
  }

  /// Where lines begin, end and cross, in order, and where dark steps do.
  std::vector<double> stopsOf(const std::vector<Line>& lines, const Steps& steps) const
  {
    std::vector<double> stops;
    for (int k = 1; k < kShadowSteps; ++k)
      if (steps.isDark[k] != steps.isDark[k - 1]) stops.push_back(steps.start[k]);
    const auto add = [&](const Line& line, double u) {
      if (!steps.areDarkAt(u) && !isHidden(line, u, lines)) stops.push_back(u);
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const double end : {lines[i].u0, lines[i].u1})
        if (!lines[i].isWayOut)
          add(lines[i], end);
        else if (!steps.areDarkAt(end))
          stops.push_back(end);
      for (std::size_t j = 0; j < i; ++j)
        if (double u; meet(lines[j], lines[i], u)) add(lines[j], u);
    }
    std::sort(stops.begin(), stops.end());
    return stops;
  }
  static bool meet(const Line& p, const Line& q, double& u)
  {
    const double low = std::max(p.u0, q.u0), high = std::min(p.u1, q.u1);
    if (!(low < high)) return false;
    const double atLow = p.w(low) - q.w(low), atHigh = p.w(high) - q.w(high);
    u = low + (high - low) * (atLow / (atLow - atHigh));
    return (atLow < 0) != (atHigh < 0);
  }
  /// Whether light ends there before the line, by more than rounding.
  bool isHidden(const Line& line, double u, const std::vector<Line>& lines) const
  {
    const double behind =
        line.w(std::clamp(u, line.u0, line.u1)) + std::max(contact(), kShadowRounding);
    return std::any_of(lines.begin(), lines.end(), [&](const Line& other) {
      return other.endsLight && other.u0 <= u && other.u1 >= u && other.w(u) > behind;
    });
  }
  /// The part of the edge inside of a spot's cone.
  bool coneHolds(double& low, double& high) const
  {
    low = 0;
    high = 1;
    if (!light_.isCone) return true;
    const auto at = [&](double u) { return a_ + e_ * u; };
    double inside = light_.holds(a_) ? 0.0 : 1.0;
    if (!light_.holds(at(inside))) {
      double left = 0, right = 1;
      const auto depth = [&](double u) {
        const Vec3d way = at(u) - light_.source;
        return dot(way, light_.axis) - light_.cosine * std::sqrt(dot(way, way));
      };
      for (int i = 0; i < 60; ++i) {
        const double p = left + (right - left) / 3, q = right - (right - left) / 3;
        if (depth(p) < depth(q))
          left = p;
        else
          right = q;
      }
      inside = 0.5 * (left + right);
    }
    if (!light_.holds(at(inside))) return false;
    const auto lastInside = [&](double outside) {
      double held = inside;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (held + outside);
        if (light_.holds(at(middle)))
          held = middle;
        else
          outside = middle;
      }
      return held;
    };
    if (!light_.holds(a_)) low = lastInside(0);
    if (!light_.holds(b_)) high = lastInside(1);
    return low < high;
  }

  Vec3d at(double u, double w) const
  {
    const Vec3d p = a_ + e_ * u;
    if (light_.isParallel) return p + light_.source * w;
    return light_.source + (p - light_.source) * (1.0 / (1.0 + w));
  }
  /// Too little to count, in w.
  double contact() const
  {
    const double contact = kShadowContact * world_.size;
    if (light_.isParallel) return contact;
    const Vec3d toA = a_ - light_.source, toB = b_ - light_.source;
    return contact / std::sqrt(std::max(dot(toA, toA), dot(toB, toB)));
  }
  void add(std::uint32_t number, const Line& line, double u0, double u1,
           std::vector<ShadowPiece>& pieces) const
  {
    const double contact = this->contact();
    const bool isBehind0 = line.w(u0) < -contact, isBehind1 = line.w(u1) < -contact;
    if (!isBehind0 && !isBehind1) return;
    const double limit =
        line.u0 + (line.u1 - line.u0) * ((-contact - line.w0) / (line.w1 - line.w0));
    if (!isBehind0) u0 = limit;
    if (!isBehind1) u1 = limit;
    if (!(u1 - u0 > kShadowSliver)) return;
    pieces.push_back({number, line.triangle, u0, u1, at(u0, line.w(u0)), at(u1, line.w(u1))});
  }

  const WorldMesh& world_;
  const LightRays& light_;
  const ShadowCaster& caster_;
  double bound_;
  Vec3d a_, b_, e_;
};

}  // namespace

std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const LightRays& light,
                                      Span<const ShadowCaster> casters,
                                      Span<const double> creaseDegrees)
{
  std::vector<ShadowPiece> pieces;
  for (std::uint32_t c = 0; c < casters.size(); ++c)
    Shadow(world, light, casters[c], creaseDegrees[casters[c].body]).cast(c, pieces);
  return pieces;
}

}  // namespace limn::reference
