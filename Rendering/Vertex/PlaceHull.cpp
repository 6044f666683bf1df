// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/PlaceHull.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/BuildClusters.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kChunk = 1 << 14;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Sine of the angle to the line of sight up to which a triangle counts as seen edge on, and an
/// edge as seen end on: above what rounding of normals does, below what shows.
constexpr double kEdgeOnSine = 0x1p-16;

enum class Facing : std::uint8_t { kFront, kEdgeOn, kBack, kNowhere };

struct Direction {
  double x, y;
};

/// The outward normals on the screen, unit, of the two edges of the outline at a vertex that are
/// farthest apart; of one edge twice.
struct Corner {
  Direction a, b;
  double deeper = 0;  ///< in normalized device coordinates

  void add(Direction n)
  {
    const double old = dot(a, b), toA = dot(n, a), toB = dot(n, b);
    if (toA < old && toA <= toB)
      b = n;
    else if (toB < old)
      a = n;
  }
  /// How far the vertex moves, in widths.
  Direction move() const
  {
    const double x = a.x + b.x, y = a.y + b.y;
    const double longer = 1.0 + dot(a, b);  // half the square of the sum's length
    constexpr double kShortest = 2.0 / (kHullMiter * kHullMiter);
    if (longer >= kShortest) return {x / longer, y / longer};
    const double length = std::sqrt(x * x + y * y);
    const double scale = length > 0 ? kHullMiter / length : 0.0;
    return {x * scale, y * scale};
  }

 private:
  static double dot(Direction p, Direction q) { return p.x * q.x + p.y * q.y; }
};

class HullPlacer {
 public:
  HullPlacer(const Instance& instance, const Camera& camera, const HullView& view,
             PlacedHull& placed)
      : instance_(instance),
        mesh_(instance.mesh),
        hull_(*instance.hull),
        threads_(view.threads),
        pixelsX_(view.width * 0.5),
        pixelsY_(view.height * 0.5),
        placed_(placed)
  {
    toClip_ = camera.viewToClip *
              (camera.worldToView * (instance.modelToWorld * translation(hull_.origin)));
    isVisible_ = invert(toClip_, toLocal_) && instance.style.outlineWidth > 0;
    if (isVisible_) {
      eye_ = column(2);
      right_ = imageDirection(0);
      up_ = imageDirection(1);
    }
  }

  void place()
  {
    if (isVisible_) {
      findFacings();
      findCorners();
      listTriangles();
    }
    describe();
  }

 private:
  struct Homogeneous {
    Vec3d xyz;
    double w;
  };
  /// What a vertex is a corner of; each comes to lie in a place of its own. Where a border turns
  /// from the front to the back, or becomes a contour, it may go on on the other side, so that
  /// there is no miter for both.
  enum Place { kHull, kFrontBorder, kBackBorder, kOwn };
  static constexpr int kMovedPlaces = 3, kPlaces = 4;

  struct OutlineEdge {
    std::uint32_t vertex[2];
    Direction normal;
    std::uint32_t border;  ///< its triangle, or kNone
    Place place;
  };
  struct ScreenPoint {
    double x, y, depth;  ///< pixels and normalized device coordinates
    bool isSeen;         ///< before the eye; else the others mean nothing
  };

  Homogeneous column(int c) const
  {
    const auto& m = toLocal_.m;
    return {{m[0][c], m[1][c], m[2][c]}, m[3][c]};
  }
  /// A direction of the model's space along which, from the eye's plane, clip x or y grows alone.
  Vec3d imageDirection(int axis) const
  {
    const Homogeneous h = column(axis);
    return eye_.w == 0 ? h.xyz : h.xyz - eye_.xyz * (h.w / eye_.w);
  }
  Vec3d position(std::uint32_t v) const { return mesh_.position(v) - hull_.origin; }
  /// Away from the eye: where a point goes when its clip z grows, if that is depth as ever.
  Vec3d sight(Vec3d p) const { return eye_.xyz - p * eye_.w; }

  template <class Body>
  void forEachChunk(std::size_t count, Body body) const
  {
    parallelFor(threads_, (count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
      body(chunk, chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
    });
  }

  void findFacings()
  {
    facing_.resize(mesh_.triangles.size());
    forEachChunk(facing_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const Vec3d n = vec3Cast<double>(hull_.normal[t]);
        if (n == Vec3d{0, 0, 0}) {
          facing_[t] = Facing::kNowhere;
          continue;
        }
        const Vec3d r = sight(position(mesh_.triangles[t].vertex[0]));
        const double along = dot(n, r);
        facing_[t] = along * along <= kEdgeOnSine * kEdgeOnSine * dot(r, r) ? Facing::kEdgeOn
                     : along > 0                                            ? Facing::kBack
                                                                            : Facing::kFront;
      }
    });
  }
  static bool isBorder(const HullEdge& edge) { return edge.triangle[0] == edge.triangle[1]; }
  bool isOutline(const HullEdge& edge) const
  {
    if (isBorder(edge)) return true;
    const Facing a = facing_[edge.triangle[0]], b = facing_[edge.triangle[1]];
    return a == Facing::kEdgeOn || b == Facing::kEdgeOn || a != b;
  }

  /// False for an edge seen end on.
  bool findNormal(const HullEdge& edge, Direction& normal) const
  {
    const Vec3d p = position(edge.vertex[0]), along = position(edge.vertex[1]) - p;
    const Vec3d r = sight(p);
    Vec3d plane = cross(r, along);
    if (!(dot(plane, plane) > kEdgeOnSine * kEdgeOnSine * (dot(r, r) * dot(along, along))))
      return false;
    // The triangles lie on the inner side of the plane through the eye and the edge.
    double inner = 0;
    for (const std::uint32_t t : edge.triangle)
      for (const std::uint32_t v : mesh_.triangles[t].vertex) {
        const std::uint32_t corner = hull_.weld[v];
        if (corner == edge.vertex[0] || corner == edge.vertex[1]) continue;
        const double side = dot(plane, position(corner) - p);
        if (std::fabs(side) > std::fabs(inner)) inner = side;
      }
    if (inner > 0) plane = -plane;
    const double x = dot(plane, right_) / pixelsX_, y = dot(plane, up_) / pixelsY_;
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0) || !std::isfinite(length)) return false;
    normal = {x / length, y / length};
    return true;
  }

  double clipRow(int row, Vec3d p) const
  {
    const auto& m = toClip_.m[row];
    return (m[0] * p.x + m[1] * p.y) + (m[2] * p.z + m[3]);
  }
  ScreenPoint project(std::uint32_t v) const
  {
    const Vec3d p = position(v);
    const double w = clipRow(3, p);
    return {clipRow(0, p) / w * pixelsX_, clipRow(1, p) / w * pixelsY_, clipRow(2, p) / w, w > 0};
  }
  void findCorners()
  {
    const std::size_t count = hull_.edges.size();
    std::vector<std::vector<OutlineEdge>> outline((count + kChunk - 1) / kChunk);
    forEachChunk(count, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        const HullEdge& edge = hull_.edges[e];
        Direction normal;
        if (isOutline(edge) && findNormal(edge, normal))
          outline[chunk].push_back({{edge.vertex[0], edge.vertex[1]},
                                    normal,
                                    isBorder(edge) ? edge.triangle[0] : kNone,
                                    placeOf(edge)});
      }
    });
    for (std::vector<std::uint32_t>& corners : cornerOf_)
      corners.assign(mesh_.vertexCount(), kNone);
    for (const std::vector<OutlineEdge>& edges : outline)
      for (const OutlineEdge& edge : edges) {
        for (const std::uint32_t v : edge.vertex)
          addToCorner(v, edge);
        if (edge.border != kNone) borders_.push_back(edge);
      }
  }
  Place placeOf(const HullEdge& edge) const
  {
    if (!isBorder(edge)) return kHull;
    return facing_[edge.triangle[0]] == Facing::kFront ? kFrontBorder : kBackBorder;
  }
  void addToCorner(std::uint32_t v, const OutlineEdge& edge)
  {
    std::uint32_t& number = cornerOf_[edge.place][v];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(corners_.size());
      corners_.push_back({edge.normal, edge.normal});
    } else {
      corners_[number].add(edge.normal);
    }
  }
  Direction pixelsOf(const Corner& corner) const
  {
    const Direction move = corner.move();
    const double width = instance_.style.outlineWidth;
    return {width * move.x, width * move.y};
  }

  bool isDrawn(std::size_t t) const
  {
    if (facing_[t] != Facing::kBack && facing_[t] != Facing::kEdgeOn) return false;
    const auto& vertex = mesh_.triangles[t].vertex;
    return std::any_of(vertex, vertex + 3, [this](std::uint32_t v) {
      return cornerOf_[kHull][hull_.weld[v]] != kNone;
    });
  }

  void listTriangles()
  {
    const std::size_t count = mesh_.triangles.size();
    std::vector<std::vector<std::uint32_t>> drawn((count + kChunk - 1) / kChunk);
    forEachChunk(count, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        if (isDrawn(t)) drawn[chunk].push_back(static_cast<std::uint32_t>(t));
    });
    for (const std::vector<std::uint32_t>& triangles : drawn)
      for (const std::uint32_t t : triangles) {
        const auto& v = mesh_.triangles[t].vertex;
        const std::uint32_t all[] = {hull_.weld[v[0]], hull_.weld[v[1]], hull_.weld[v[2]]};
        deepen(t, {all, 3}, kHull);
      }
    for (const OutlineEdge& edge : borders_)
      deepen(edge.border, {edge.vertex, 2}, edge.place);
    for (std::vector<std::uint32_t>& numbers : number_)
      numbers.assign(mesh_.vertexCount(), kNone);
    for (const std::vector<std::uint32_t>& triangles : drawn)
      for (const std::uint32_t t : triangles) {
        const auto& v = mesh_.triangles[t].vertex;
        addTriangle(t, {{numberOf(hull_.weld[v[0]], kHull), numberOf(hull_.weld[v[1]], kHull),
                         numberOf(hull_.weld[v[2]], kHull)}});
      }
    for (const OutlineEdge& edge : borders_) {
      addStrip(edge, edge.place);
      // Where the triangle itself is drawn, it begins where its own corners come to lie.
      if (isDrawn(edge.border)) addStrip(edge, kHull);
    }
    std::vector<bool> isJoined(borders_.empty() ? 0 : mesh_.vertexCount());
    for (const OutlineEdge& edge : borders_)
      for (const std::uint32_t v : edge.vertex) {
        if (!isJoined[v]) addJoins(v, edge.border);
        isJoined[v] = true;
      }
  }

  /// In what is drawn, where it is added if it is not there yet.
  std::uint32_t numberOf(std::uint32_t v, Place place)
  {
    std::uint32_t& number = number_[place][v];
    if (number == kNone) {
      number = static_cast<std::uint32_t>(placed_.positions.size());
      placed_.positions.push_back(placeOf(v, place));
    }
    return number;
  }
  void addTriangle(std::uint32_t t, Triangle triangle)
  {
    const Span<const std::uint32_t> cells = instance_.attributes.cells;
    placed_.triangles.push_back(triangle);
    placed_.cells.push_back(cells.empty() ? t : cells[t]);
  }
  /// From a border to where its ends come to lie.
  void addStrip(const OutlineEdge& edge, Place place)
  {
    const std::uint32_t a = numberOf(edge.vertex[0], kOwn), b = numberOf(edge.vertex[1], kOwn),
                        beyondB = numberOf(edge.vertex[1], place),
                        beyondA = numberOf(edge.vertex[0], place);
    addTriangle(edge.border, {{a, b, beyondB}});
    addTriangle(edge.border, {{a, beyondB, beyondA}});
  }

  /// Between the places that a vertex comes to lie in.
  void addJoins(std::uint32_t v, std::uint32_t border)
  {
    constexpr Place kMoved[] = {kHull, kFrontBorder, kBackBorder};
    for (const Place a : kMoved)
      for (const Place b : kMoved)
        if (a < b && cornerOf_[a][v] != kNone && cornerOf_[b][v] != kNone)
          addTriangle(border, {{numberOf(v, kOwn), numberOf(v, a), numberOf(v, b)}});
  }

  /// Lets corners of a triangle get as deep as its plane is where they come to lie, lest the
  /// hull lie before it; but no more than the triangle is deep, which may be seen all but edge on.
  void deepen(std::uint32_t t, Span<const std::uint32_t> vertices, Place place)
  {
    ScreenPoint p[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = project(hull_.weld[mesh_.triangles[t].vertex[k]]);
      if (!p[k].isSeen) return;
    }
    const double x1 = p[1].x - p[0].x, y1 = p[1].y - p[0].y, z1 = p[1].depth - p[0].depth;
    const double x2 = p[2].x - p[0].x, y2 = p[2].y - p[0].y, z2 = p[2].depth - p[0].depth;
    const double scale = 1.0 / (x1 * y2 - x2 * y1);
    const double slopeX = (z1 * y2 - z2 * y1) * scale, slopeY = (x1 * z2 - x2 * z1) * scale;
    if (facing_[t] == Facing::kEdgeOn || !std::isfinite(slopeX) || !std::isfinite(slopeY)) return;
    const auto [nearest, farthest] = std::minmax({p[0].depth, p[1].depth, p[2].depth});
    for (const std::uint32_t v : vertices) {
      if (cornerOf_[place][v] == kNone) continue;
      Corner& corner = corners_[cornerOf_[place][v]];
      const Direction pixels = pixelsOf(corner);
      const double deeper = std::min(slopeX * pixels.x + slopeY * pixels.y, farthest - nearest);
      corner.deeper = std::max(corner.deeper, deeper);
    }
  }

  /// Where a vertex comes to lie, or with its hull's depth only: its clip coordinates change by w
  /// times the move and the depth, and w not at all; brought back to the model's space.
  Vec3d placeOf(std::uint32_t v, Place place) const
  {
    const Vec3d p = position(v);
    const double w = clipRow(3, p);
    Direction pixels = {0, 0};
    double deeper = 2.0 * kHullDepth;
    if (place != kOwn && cornerOf_[place][v] != kNone) {
      const Corner& corner = corners_[cornerOf_[place][v]];
      pixels = pixelsOf(corner);
      deeper = deeper + corner.deeper;
    }
    const double x = w * (pixels.x / pixelsX_), y = w * (pixels.y / pixelsY_);
    const double z = w > 0 ? w * boundedDepth(deeper, clipRow(2, p) / w) : 0.0;
    const Homogeneous right = column(0), up = column(1);
    const double divisor = 1.0 + ((right.w * x + up.w * y) + eye_.w * z);
    if (!(divisor > 0)) return p + hull_.origin;
    const Vec3d q = (p + (right.xyz * x + up.xyz * y)) + eye_.xyz * z;
    return q * (1.0 / divisor) + hull_.origin;
  }
  /// Not behind the far plane, where nothing is drawn.
  static double boundedDepth(double deeper, double depth)
  {
    constexpr double kDeepest = 1.0 - 0x1p-20;
    const double room = kDeepest - depth;
    const double bounded = deeper < room ? deeper : room;
    return bounded > 0 ? bounded : 0.0;
  }

  void describe()
  {
    Instance& drawn = placed_.instance;
    drawn.mesh.precisePositions = {placed_.positions.data(), placed_.positions.size()};
    drawn.mesh.triangles = {placed_.triangles.data(), placed_.triangles.size()};
    drawn.attributes.cells = {placed_.cells.data(), placed_.cells.size()};
    // A few times what the mesh has at most: where they are too many there is no hull.
    const bool isBuilt = buildClusters(drawn.mesh, threads_, placed_.clusters).ok();
    if (!isBuilt) placed_.clusters = {};
    drawn.clusters = &placed_.clusters;
    drawn.modelToWorld = instance_.modelToWorld;
    drawn.id = instance_.id;
    drawn.style.normals = NormalSource::kTriangle;
    drawn.style.reflection = Reflection::kNone;
    drawn.material.diffuseColor = instance_.style.outlineColor;
    drawn.material.opacity = instance_.style.outlineOpacity;
  }

  const Instance& instance_;
  const MeshView& mesh_;
  const HullEdges& hull_;
  int threads_;
  double pixelsX_, pixelsY_;  ///< per unit of normalized device coordinates
  PlacedHull& placed_;
  Mat4d toClip_, toLocal_;
  bool isVisible_;
  Homogeneous eye_ = {};
  Vec3d right_ = {}, up_ = {};
  std::vector<Facing> facing_;                         ///< by triangle
  std::vector<std::uint32_t> cornerOf_[kMovedPlaces];  ///< by vertex: into corners_, or kNone
  std::vector<Corner> corners_;
  std::vector<OutlineEdge> borders_;            ///< of which strips are drawn
  std::vector<std::uint32_t> number_[kPlaces];  ///< by vertex: into placed_.positions, or kNone
};

}  // namespace

std::unique_ptr<const PlacedHull> placeHull(const Instance& instance, const Camera& camera,
                                            const HullView& view)
{
  auto placed = std::make_unique<PlacedHull>();
  HullPlacer(instance, camera, view, *placed).place();
  return placed;
}

}  // namespace limn
