// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceHull.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace limn::reference {
namespace {

/// A triangle or an edge at a smaller angle to the line of sight is seen edge on, or end on.
constexpr double kSmallestSine = 0x1p-16;

struct Normal2 {
  double x, y;
};
double dot2(Normal2 a, Normal2 b)
{
  return a.x * b.x + a.y * b.y;
}

/// The two normals at a vertex with the largest angle between them.
struct Pair {
  Normal2 a, b;
};

/// Between two triangles, or at one that shows its front, or its back.
enum class EdgeSort { kContour, kFrontBorder, kBackBorder };

/// The mesh of one instance in one view, in coordinates relative to its origin.
class View {
 public:
  View(const Scene& scene, const Instance& instance, const FrameView& frame)
      : mesh_(instance.mesh), edges_(*instance.hull)
  {
    halfWidth_ = frame.width * 0.5;
    halfHeight_ = frame.height * 0.5;
    toClip_ = scene.camera.viewToClip *
              (scene.camera.worldToView * (instance.modelToWorld * translation(edges_.origin)));
    isInvertible_ = invert(toClip_, toLocal_);
  }

  bool isInvertible() const { return isInvertible_; }
  Vec3d point(std::uint32_t vertex) const { return mesh_.position(vertex) - edges_.origin; }

  /// The point (0, 0, 1, 0) of clip space: the eye, as a homogeneous point.
  Vec3d eye() const { return xyz(2); }
  double eyeW() const { return toLocal_.m[3][2]; }
  Vec3d awayFromEye(Vec3d p) const { return eye() - p * eyeW(); }

  /// Cosine of the angle between the outward normal and the way of sight; 0 for edge on.
  double facing(std::size_t triangle) const
  {
    const Vec3d n = vec3Cast<double>(edges_.normal[triangle]);
    const Vec3d sight = awayFromEye(point(mesh_.triangles[triangle].vertex[0]));
    const double along = dot(n, sight);
    return along * along <= kSmallestSine * kSmallestSine * dot(sight, sight) ? 0.0 : along;
  }

  EdgeSort sortOf(const HullEdge& edge) const
  {
    if (edge.triangle[0] != edge.triangle[1]) return EdgeSort::kContour;
    return facing(edge.triangle[0]) < 0 ? EdgeSort::kFrontBorder : EdgeSort::kBackBorder;
  }

  /// Of an edge with one triangle in front and one behind, or some edge on.
  std::optional<Normal2> outlineNormal(const HullEdge& edge) const
  {
    const double first = facing(edge.triangle[0]), second = facing(edge.triangle[1]);
    const bool isBetween = edge.triangle[0] != edge.triangle[1];
    if (isBetween && ((first > 0 && second > 0) || (first < 0 && second < 0))) return std::nullopt;
    const Vec3d start = point(edge.vertex[0]);
    const Vec3d along = point(edge.vertex[1]) - start, sight = awayFromEye(start);
    // Normal of the plane through the eye and the edge, away from the triangles.
    Vec3d plane = cross(sight, along);
    if (!(dot(plane, plane) >
          kSmallestSine * kSmallestSine * (dot(sight, sight) * dot(along, along))))
      return std::nullopt;
    double inside = 0;
    for (const std::uint32_t triangle : edge.triangle)
      for (const std::uint32_t given : mesh_.triangles[triangle].vertex) {
        const std::uint32_t v = edges_.weld[given];
        if (v == edge.vertex[0] || v == edge.vertex[1]) continue;
        const double distance = dot(plane, point(v) - start);
        if (std::fabs(distance) > std::fabs(inside)) inside = distance;
      }
    if (inside > 0) plane = -plane;
    // The plane's coefficients of clip x and y, then of pixels.
    const double x = dot(plane, imageAxis(0)) / halfWidth_;
    const double y = dot(plane, imageAxis(1)) / halfHeight_;
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    return Normal2{x / length, y / length};
  }

  /// How much deeper the plane of a triangle is so many pixels away, in normalized device
  /// coordinates; at most as much as the triangle's corners differ. 0 if it is edge on.
  double deepening(std::size_t triangle, Normal2 pixels) const
  {
    Vec3d corner[3];
    for (int k = 0; k < 3; ++k) {
      const Vec3d p = point(edges_.weld[mesh_.triangles[triangle].vertex[k]]);
      const double w = clip(3, p);
      if (!(w > 0)) return 0;
      corner[k] = {clip(0, p) / w * halfWidth_, clip(1, p) / w * halfHeight_, clip(2, p) / w};
    }
    if (facing(triangle) == 0) return 0;
    const Vec3d u = corner[1] - corner[0], v = corner[2] - corner[0];
    const double inverseArea = 1.0 / (u.x * v.y - v.x * u.y);
    const double perX = (u.z * v.y - v.z * u.y) * inverseArea;
    const double perY = (u.x * v.z - v.x * u.z) * inverseArea;
    if (!std::isfinite(perX) || !std::isfinite(perY)) return 0;
    const double most = std::max({corner[0].z, corner[1].z, corner[2].z}) -
                        std::min({corner[0].z, corner[1].z, corner[2].z});
    return std::max(0.0, std::min(perX * pixels.x + perY * pixels.y, most));
  }

  /// The point of the model's space that is seen `pixels` beside p and deeper by `deeper`, in
  /// normalized device coordinates, but for the far plane.
  Vec3d shifted(Vec3d p, Normal2 pixels, double deeper) const
  {
    const double w = clip(3, p);
    const double dx = w * (pixels.x / halfWidth_), dy = w * (pixels.y / halfHeight_);
    double dz = 0;
    if (w > 0) {
      const double depth = clip(2, p) / w, farthest = 1.0 - 0x1p-20;
      dz = w * std::max(0.0, std::min(deeper, farthest - depth));
    }
    const double newW =
        1.0 + ((toLocal_.m[3][0] * dx + toLocal_.m[3][1] * dy) + toLocal_.m[3][2] * dz);
    if (!(newW > 0)) return p + edges_.origin;
    const Vec3d moved = (p + (xyz(0) * dx + xyz(1) * dy)) + xyz(2) * dz;
    return moved * (1.0 / newW) + edges_.origin;
  }

 private:
  double clip(int row, Vec3d p) const
  {
    const auto& m = toClip_.m[row];
    return (m[0] * p.x + m[1] * p.y) + (m[2] * p.z + m[3]);
  }
  Vec3d xyz(int column) const
  {
    return {toLocal_.m[0][column], toLocal_.m[1][column], toLocal_.m[2][column]};
  }
  Vec3d imageAxis(int axis) const
  {
    if (eyeW() == 0) return xyz(axis);
    return xyz(axis) - eye() * (toLocal_.m[3][axis] / eyeW());
  }

  const MeshView& mesh_;
  const HullEdges& edges_;
  double halfWidth_, halfHeight_;
  Mat4d toClip_, toLocal_ = {};
  bool isInvertible_;
};

void widen(Pair& pair, Normal2 n)
{
  const double before = dot2(pair.a, pair.b);
  const double withA = dot2(n, pair.a), withB = dot2(n, pair.b);
  if (withA < before && withA <= withB)
    pair.b = n;
  else if (withB < before)
    pair.a = n;
}

/// The move m, in widths, with m.a = m.b = 1, or as far along it as is allowed.
Normal2 miter(const Pair& pair)
{
  const Normal2 sum = {pair.a.x + pair.b.x, pair.a.y + pair.b.y};
  const double divisor = 1.0 + dot2(pair.a, pair.b);
  if (divisor >= 2.0 / (kHullMiter * kHullMiter)) return {sum.x / divisor, sum.y / divisor};
  const double length = std::sqrt(dot2(sum, sum));
  if (!(length > 0)) return {0, 0};
  const double scale = kHullMiter / length;
  return {sum.x * scale, sum.y * scale};
}

/// A vertex as an end of edges of one sort.
using OutlineEnd = std::pair<std::uint32_t, EdgeSort>;

/// What moves on the screen.
struct Outline {
  std::map<OutlineEnd, Normal2> moves;  ///< in pixels
  std::vector<HullEdge> borders;
};

Outline outlineOf(const View& view, const HullEdges& edges, double width)
{
  Outline outline;
  std::map<OutlineEnd, Pair> corners;
  for (const HullEdge& edge : edges.edges) {
    const std::optional<Normal2> normal = view.outlineNormal(edge);
    if (!normal) continue;
    const EdgeSort sort = view.sortOf(edge);
    if (sort != EdgeSort::kContour) outline.borders.push_back(edge);
    for (const std::uint32_t v : edge.vertex) {
      const auto [place, isNew] = corners.insert({{v, sort}, {*normal, *normal}});
      if (!isNew) widen(place->second, *normal);
    }
  }
  for (const auto& [end, pair] : corners) {
    const Normal2 move = miter(pair);
    outline.moves[end] = {width * move.x, width * move.y};
  }
  return outline;
}

/// The triangles that are drawn, with welded vertices, by their number.
std::map<std::uint32_t, Triangle> trianglesAtOutline(const View& view, const Instance& instance,
                                                     const Outline& outline)
{
  std::map<std::uint32_t, Triangle> drawn;
  for (std::uint32_t t = 0; t < instance.mesh.triangles.size(); ++t) {
    if (instance.hull->normal[t] == Vec3f{0, 0, 0} || view.facing(t) < 0) continue;
    Triangle triangle = instance.mesh.triangles[t];
    bool isMoved = false;
    for (std::uint32_t& v : triangle.vertex) {
      v = instance.hull->weld[v];
      isMoved = isMoved || outline.moves.count({v, EdgeSort::kContour}) > 0;
    }
    if (isMoved) drawn[t] = triangle;
  }
  return drawn;
}

}  // namespace

void makeHull(const Scene& scene, const Instance& instance, const FrameView& frame, Hull& hull)
{
  const View view(scene, instance, frame);
  const double width = instance.style.outlineWidth;
  Outline outline;
  if (view.isInvertible() && width > 0) outline = outlineOf(view, *instance.hull, width);
  const std::map<OutlineEnd, Normal2>& moves = outline.moves;
  const auto triangles = trianglesAtOutline(view, instance, outline);
  std::map<OutlineEnd, double> deepest;
  const auto deepen = [&](std::uint32_t t, OutlineEnd end) {
    if (moves.count(end) > 0)
      deepest[end] = std::max(deepest[end], view.deepening(t, moves.at(end)));
  };
  for (const auto& [t, triangle] : triangles)
    for (const std::uint32_t v : triangle.vertex)
      deepen(t, {v, EdgeSort::kContour});
  for (const HullEdge& border : outline.borders)
    for (const std::uint32_t v : border.vertex)
      deepen(border.triangle[0], {v, view.sortOf(border)});

  std::map<OutlineEnd, std::uint32_t> numbers;
  std::map<std::uint32_t, std::uint32_t> ownNumbers;
  const auto addPosition = [&](Vec3d position) {
    hull.positions.push_back(position);
    return static_cast<std::uint32_t>(hull.positions.size() - 1);
  };
  const auto movedNumber = [&](OutlineEnd end) {
    if (numbers.count(end) == 0) {
      const auto move = moves.find(end);
      const bool isMoved = move != moves.end();
      numbers[end] =
          addPosition(view.shifted(view.point(end.first), isMoved ? move->second : Normal2{0, 0},
                                   2.0 * kHullDepth + (isMoved ? deepest[end] : 0.0)));
    }
    return numbers[end];
  };
  const auto ownNumber = [&](std::uint32_t v) {
    if (ownNumbers.count(v) == 0)
      ownNumbers[v] = addPosition(view.shifted(view.point(v), {0, 0}, 2.0 * kHullDepth));
    return ownNumbers[v];
  };
  const auto add = [&](std::uint32_t t, Triangle triangle) {
    hull.triangles.push_back(triangle);
    hull.cells.push_back(instance.attributes.cells.empty() ? t : instance.attributes.cells[t]);
  };
  for (const auto& [t, given] : triangles) {
    Triangle triangle = given;
    for (std::uint32_t& v : triangle.vertex)
      v = movedNumber({v, EdgeSort::kContour});
    add(t, triangle);
  }
  // A quadrilateral of two triangles beyond each border; another up to its triangle, if that moves.
  const auto addBeyond = [&](const HullEdge& border, EdgeSort sort) {
    const std::uint32_t t = border.triangle[0], a = border.vertex[0], b = border.vertex[1];
    add(t, {{ownNumber(a), ownNumber(b), movedNumber({b, sort})}});
    add(t, {{ownNumber(a), movedNumber({b, sort}), movedNumber({a, sort})}});
  };
  for (const HullEdge& border : outline.borders) {
    addBeyond(border, view.sortOf(border));
    if (triangles.count(border.triangle[0]) > 0) addBeyond(border, EdgeSort::kContour);
  }
  // Where edges of two sorts meet, what lies between.
  std::set<std::uint32_t> joined;
  for (const HullEdge& border : outline.borders)
    for (const std::uint32_t v : border.vertex) {
      if (!joined.insert(v).second) continue;
      const auto join = [&](EdgeSort first, EdgeSort second) {
        if (moves.count({v, first}) > 0 && moves.count({v, second}) > 0)
          add(border.triangle[0],
              {{ownNumber(v), movedNumber({v, first}), movedNumber({v, second})}});
      };
      join(EdgeSort::kContour, EdgeSort::kFrontBorder);
      join(EdgeSort::kContour, EdgeSort::kBackBorder);
      join(EdgeSort::kFrontBorder, EdgeSort::kBackBorder);
    }
  hull.instance.mesh = {{}, hull.positions, hull.triangles};
  hull.instance.attributes.cells = hull.cells;
  hull.instance.modelToWorld = instance.modelToWorld;
  hull.instance.id = instance.id;
  hull.instance.style.normals = NormalSource::kTriangle;
  hull.instance.style.reflection = Reflection::kNone;
  hull.instance.material.diffuseColor = instance.style.outlineColor;
  hull.instance.material.opacity = instance.style.outlineOpacity;
}

}  // namespace limn::reference
