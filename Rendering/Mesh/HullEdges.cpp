// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/HullEdges.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/HalfEdges.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/WeldVertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace limn {
namespace {

constexpr std::size_t kChunk = 1 << 14;

/// Of the mesh's box: borders nearer to each other are gaps that rounding leaves, as at the poles
/// of globes.
constexpr double kGap = 1e-6;

bool isDrawable(const MeshView& mesh, const Triangle& triangle, Vec3d origin)
{
  for (const std::uint32_t v : triangle.vertex)
    if (v >= mesh.vertexCount() || !isFinite(mesh.position(v)) ||
        !isFinite(toLocal(mesh.position(v), origin).high))
      return false;
  return true;
}

struct Border {
  std::uint32_t end[2];  ///< places
  Vec3d third;           ///< corner of its triangle
};

/// Finds borders that others lie along: from a place that they share up to the next one, whatever
/// the places between, with the triangles on other sides.
class Seams {
 public:
  /// By place, all borders', where it is.
  Seams(Span<const Vec3d> placeAt, double gap, Span<const Border> borders)
      : placeAt_(placeAt), gap_(gap), borders_(borders), isCovered_(borders.size())
  {
    // No plane or cone that meshes have has this for its axis.
    const Vec3d axis = normalized(Vec3d{0.3712, 0.7301, 0.5737});
    for (std::size_t b = 0; b < borders.size(); ++b) {
      const auto [first, second] = borders[b].end;
      isCovered_[b] = first == second;
      if (first == second) continue;
      const double along = dot(normalized(placeAt[second] - placeAt[first]), axis);
      ways_.push_back({first, second, b, along});
      ways_.push_back({second, first, b, -along});
    }
    std::sort(ways_.begin(), ways_.end(), [](const Way& a, const Way& b) {
      return std::tie(a.from, a.along, a.border) < std::tie(b.from, b.along, b.border);
    });
  }

  /// By border.
  std::vector<bool> covered()
  {
    for (std::size_t i = 0, end; i < ways_.size(); i = end) {
      double shortest = length(ways_[i]);
      for (end = i + 1; end < ways_.size() && ways_[end].from == ways_[i].from; ++end)
        shortest = std::min(shortest, length(ways_[end]));
      // Those that go the same way, of which there may be few among very many.
      const double most = 2 * gap_ / shortest;
      for (std::size_t a = i; a < end; ++a)
        for (std::size_t b = a + 1; b < end && ways_[b].along - ways_[a].along <= most; ++b)
          follow(ways_[a], ways_[b]);
    }
    return isCovered_;
  }

 private:
  struct Way {
    std::uint32_t from, to;
    std::size_t border;
    double along;  ///< cosine of the angle to the constructor's axis
  };
  /// Along which ways are followed.
  struct Line {
    Vec3d start, along;  ///< of unit length
  };

  double length(const Way& way) const
  {
    const Vec3d along = placeAt_[way.to] - placeAt_[way.from];
    return std::sqrt(dot(along, along));
  }
  Vec3d aside(const Line& line, Vec3d place) const
  {
    const Vec3d way = place - line.start;
    return way - line.along * dot(way, line.along);
  }
  /// How far along the line a place is, or less than nothing if it is beside it.
  double distance(const Line& line, std::uint32_t place) const
  {
    const Vec3d beside = aside(line, placeAt_[place]);
    return dot(beside, beside) <= gap_ * gap_ ? dot(placeAt_[place] - line.start, line.along) : -1;
  }
  /// Whether triangles lie over each other, as those of two sheets do.
  bool areOnOneSide(const Line& line, const Way& first, const Way& second) const
  {
    constexpr double kSame = 0.99;
    const Vec3d a = normalized(aside(line, borders_[first.border].third));
    const Vec3d b = normalized(aside(line, borders_[second.border].third));
    return dot(a, b) > kSame;
  }

  /// Two ways from one place, by turns, until they meet.
  void follow(const Way& first, const Way& second)
  {
    const Vec3d start = placeAt_[first.from];
    const Way& longer = length(first) > length(second) ? first : second;
    Line line = {start, normalized(placeAt_[longer.to] - start)};
    std::uint32_t at[2] = {first.to, second.to};
    double reached[2] = {distance(line, at[0]), distance(line, at[1])};
    if (!(reached[0] > 0 && reached[1] > 0) || areOnOneSide(line, first, second)) return;
    std::vector<std::size_t> met = {first.border, second.border};
    while (at[0] != at[1]) {
      const int behind = reached[0] < reached[1] ? 0 : 1;
      const Way* const next = onward(line, at[behind], reached[behind]);
      if (next == nullptr) return;
      met.push_back(next->border);
      at[behind] = next->to;
      reached[behind] = distance(line, next->to);
      // What rounding does to a short first border grows along the line.
      if (reached[behind] > reached[1 - behind])
        line.along = normalized(placeAt_[next->to] - start);
    }
    for (const std::size_t border : met)
      isCovered_[border] = true;
  }
  /// Where a line goes on from a place, or null.
  const Way* onward(const Line& line, std::uint32_t from, double reached) const
  {
    auto way =
        std::lower_bound(ways_.begin(), ways_.end(), from,
                         [](const Way& one, std::uint32_t place) { return one.from < place; });
    for (; way != ways_.end() && way->from == from; ++way)
      if (distance(line, way->to) > reached) return &*way;
    return nullptr;
  }

  Span<const Vec3d> placeAt_;
  double gap_;
  Span<const Border> borders_;
  std::vector<bool> isCovered_;
  std::vector<Way> ways_;  ///< of each border both, by where they come from
};

/// Triangles that hang together, and which of them are turned against the first.
class TurnedParts {
 public:
  struct Member {
    std::size_t root;
    bool isTurned;  ///< against the root
  };

  explicit TurnedParts(std::size_t count) : parent_(count), isTurned_(count)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  /// Nothing changes where they hang together already.
  void join(std::size_t a, std::size_t b, bool areUnlike)
  {
    Member first = at(a), second = at(b);
    if (first.root == second.root) return;
    if (first.root > second.root) std::swap(first, second);
    parent_[second.root] = static_cast<std::uint32_t>(first.root);
    isTurned_[second.root] = (first.isTurned != second.isTurned) != areUnlike;
  }
  Member at(std::size_t i)
  {
    Member found = {i, false};
    for (; parent_[found.root] != found.root; found.root = parent_[found.root])
      found.isTurned = found.isTurned != isTurned_[found.root];
    // Those on the way find it at once from now on.
    for (bool isTurned = found.isTurned; i != found.root;) {
      const std::size_t next = parent_[i];
      const bool before = isTurned_[i];
      parent_[i] = static_cast<std::uint32_t>(found.root);
      isTurned_[i] = isTurned;
      isTurned = isTurned != before;
      i = next;
    }
    return found;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> isTurned_;  ///< against the parent
};

class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, const Box& box, int threads, HullEdges& hull)
      : mesh_(mesh), threads_(threads), hull_(hull)
  {
    const Vec3d diagonal = box.high - box.low;
    gap_ = box.empty() ? 0 : kGap * std::sqrt(dot(diagonal, diagonal));
  }

  void find()
  {
    findNormals();
    pair();
    if (isMixed()) {
      if (orient()) pair();
    } else if (isClosed() && volume() < 0)
      for (Vec3f& normal : hull_.normal)
        normal = -normal;
    keepConvex();
    dropGaps();
  }

 private:
  std::uint32_t vertex(std::size_t corner) const
  {
    return hull_.weld[mesh_.triangles[corner / 3].vertex[corner % 3]];
  }
  Vec3d position(std::uint32_t v) const { return mesh_.position(v) - hull_.origin; }
  bool counts(std::size_t triangle) const { return !(hull_.normal[triangle] == Vec3f{0, 0, 0}); }

  void findNormals()
  {
    hull_.normal.resize(mesh_.triangles.size());
    parallelForStretches(threads_, hull_.normal.size(), kChunk,
                         [&](std::size_t, std::size_t begin, std::size_t end) {
                           for (std::size_t t = begin; t < end; ++t) {
                             const Triangle& triangle = mesh_.triangles[t];
                             hull_.normal[t] = {0, 0, 0};
                             if (!isDrawable(mesh_, triangle, hull_.origin)) continue;
                             const Vec3d p = position(triangle.vertex[0]);
                             const Vec3d area = cross(position(triangle.vertex[1]) - p,
                                                      position(triangle.vertex[2]) - p);
                             const Vec3d unit = normalized(area);
                             if (isFinite(unit)) hull_.normal[t] = vec3Cast<float>(unit);
                           }
                         });
  }

  /// Whether a triangle is there, be it without an area: its neighbours do not end at it.
  bool isThere(std::size_t triangle) const
  {
    if (counts(triangle)) return true;
    if (!isDrawable(mesh_, mesh_.triangles[triangle], hull_.origin)) return false;
    const std::uint32_t a = vertex(3 * triangle), b = vertex(3 * triangle + 1),
                        c = vertex(3 * triangle + 2);
    return a != b && b != c && c != a;
  }

  /// Pairs the half edges of each vertex; what is left over is counted. Borders go with the pairs.
  void pair()
  {
    HalfEdges halves(mesh_, hull_.weld, threads_, [this](std::size_t t) { return isThere(t); });
    const std::size_t vertices = mesh_.vertexCount();
    const std::size_t chunks = (vertices + kChunk - 1) / kChunk;
    pairs_.assign(chunks, {});
    unpaired_.assign(chunks, 0);
    unlike_.assign(chunks, 0);
    parallelForStretches(threads_, vertices, kChunk,
                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                           for (std::size_t v = begin; v < end; ++v)
                             pairAt(static_cast<std::uint32_t>(v), halves.sorted(v), pairs_[chunk],
                                    unpaired_[chunk], unlike_[chunk]);
                         });
  }

  void pairAt(std::uint32_t v, Span<HalfEdge> halves, std::vector<HullEdge>& pairs,
              std::size_t& unpaired, std::size_t& unlike) const
  {
    constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
    const auto isForward = [&](const HalfEdge& half) {
      return (vertex(half.corner) == v) != isTurned(half.corner / 3);
    };
    const auto isAlone = [&](const HalfEdge* edge) {
      return (edge == halves.begin() || edge[-1].end != edge->end) &&
             (edge + 1 == halves.end() || edge[1].end != edge->end);
    };
    for (HalfEdge* edge = halves.begin(); edge != halves.end(); ++edge) {
      if (edge->corner == kTaken || !counts(edge->corner / 3)) continue;
      const bool forward = isForward(*edge);
      HalfEdge* other = edge + 1;
      while (
          other != halves.end() && other->end == edge->end &&
          (other->corner == kTaken || !counts(other->corner / 3) || isForward(*other) == forward))
        ++other;
      if (other == halves.end() || other->end != edge->end) {
        ++unpaired;
        if (isAlone(edge))
          pairs.push_back({{v, edge->end}, {edge->corner / 3, edge->corner / 3}});
        else
          ++unlike;
        continue;
      }
      const HalfEdge &there = forward ? *edge : *other, &back = forward ? *other : *edge;
      // A triangle may have two corners in one place.
      if (there.corner / 3 != back.corner / 3)
        pairs.push_back({{v, edge->end}, {there.corner / 3, back.corner / 3}});
      other->corner = kTaken;
    }
  }

  bool isTurned(std::size_t triangle) const { return !isTurned_.empty() && isTurned_[triangle]; }

  /// Whether there may be neighbours that are not wound alike.
  bool isMixed() const
  {
    return std::any_of(unlike_.begin(), unlike_.end(), [](std::size_t n) { return n > 0; });
  }

  /// Turns triangles over so that neighbours at edges of two are wound alike, as far as there is a
  /// way: closed parts outward, others as most of their triangles are. False if all stay.
  bool orient()
  {
    const std::size_t count = mesh_.triangles.size();
    TurnedParts parts(count);
    std::vector<bool> isMixed(count), isOpen(count);
    HalfEdges halves(mesh_, hull_.weld, threads_, [this](std::size_t t) { return isThere(t); });
    for (std::uint32_t v = 0; v < mesh_.vertexCount(); ++v) {
      const Span<HalfEdge> all = halves.sorted(v);
      for (const HalfEdge *first = all.begin(), *end; first != all.end(); first = end) {
        end = std::find_if(first, static_cast<const HalfEdge*>(all.end()),
                           [&](const HalfEdge& half) { return half.end != first->end; });
        const std::size_t a = first->corner / 3, b = end[-1].corner / 3;
        if (end - first != 2 || a == b || !counts(a) || !counts(b)) {
          for (const HalfEdge* half = first; half != end; ++half)
            isOpen[half->corner / 3] = true;
          continue;
        }
        const bool isUnlike = (vertex(first->corner) == v) == (vertex(end[-1].corner) == v);
        parts.join(a, b, isUnlike);
        if (isUnlike) isMixed[a] = true;
      }
    }
    struct Part {
      double volume = 0;
      std::int64_t turned = 0;  ///< more of its triangles than not
      bool isMixed = false, isOpen = false;
    };
    std::vector<Part> partAt(count);  // by its root
    for (std::size_t t = 0; t < count; ++t) {
      const TurnedParts::Member member = parts.at(t);
      Part& part = partAt[member.root];
      part.volume += member.isTurned ? -volumeBelow(t) : volumeBelow(t);
      part.turned += member.isTurned ? 1 : -1;
      part.isMixed = part.isMixed || isMixed[t];
      part.isOpen = part.isOpen || isOpen[t];
    }
    isTurned_.assign(count, false);
    bool isAny = false;
    for (std::size_t t = 0; t < count; ++t) {
      const TurnedParts::Member member = parts.at(t);
      const Part& part = partAt[member.root];
      const bool isWrong = part.isOpen ? part.isMixed && part.turned > 0 : part.volume < 0;
      if (member.isTurned == isWrong) continue;
      isTurned_[t] = isAny = true;
      hull_.normal[t] = -hull_.normal[t];
    }
    return isAny;
  }

  bool isClosed() const
  {
    return std::all_of(unpaired_.begin(), unpaired_.end(), [](std::size_t n) { return n == 0; });
  }

  /// Six times that of the tetrahedron between a triangle and the origin.
  double volumeBelow(std::size_t triangle) const
  {
    if (!counts(triangle)) return 0;
    const auto& v = mesh_.triangles[triangle].vertex;
    return dot(position(v[0]), cross(position(v[1]), position(v[2])));
  }

  /// Six times what the mesh encloses.
  double volume() const
  {
    std::vector<double> sums((mesh_.triangles.size() + kChunk - 1) / kChunk);
    parallelForStretches(threads_, mesh_.triangles.size(), kChunk,
                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                           double sum = 0;
                           for (std::size_t t = begin; t < end; ++t) {
                             if (!counts(t)) continue;
                             sum += isTurned(t) ? -volumeBelow(t) : volumeBelow(t);
                           }
                           sums[chunk] = sum;
                         });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
  }

  bool isConvex(const HullEdge& edge) const
  {
    if (isBorder(edge)) return true;
    const Vec3d a = vec3Cast<double>(hull_.normal[edge.triangle[0]]);
    const Vec3d b = vec3Cast<double>(hull_.normal[edge.triangle[1]]);
    constexpr double kFlatSine = 1e-6;  // above what rounding to float does to normals
    const Vec3d sine = cross(a, b);
    const double cosine = dot(a, b);
    if (dot(sine, sine) <= kFlatSine * kFlatSine) return cosine < 0;
    // A corner of the second triangle that is not on the edge lies below the first.
    const Vec3d p = position(edge.vertex[0]);
    double height = 0;
    for (const std::uint32_t v : mesh_.triangles[edge.triangle[1]].vertex) {
      const std::uint32_t corner = hull_.weld[v];
      if (corner != edge.vertex[0] && corner != edge.vertex[1])
        height = dot(a, position(corner) - p);
    }
    return height < 0;
  }

  void keepConvex()
  {
    parallelFor(threads_, pairs_.size(), [&](std::size_t chunk) {
      std::vector<HullEdge>& pairs = pairs_[chunk];
      pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                                 [&](const HullEdge& edge) { return !isConvex(edge); }),
                  pairs.end());
    });
    std::size_t count = 0;
    for (const std::vector<HullEdge>& pairs : pairs_)
      count += pairs.size();
    hull_.edges.reserve(count);
    for (const std::vector<HullEdge>& pairs : pairs_)
      hull_.edges.insert(hull_.edges.end(), pairs.begin(), pairs.end());
  }

  static bool isBorder(const HullEdge& edge) { return edge.triangle[0] == edge.triangle[1]; }

  /// Leaves out borders that all but lie on others.
  void dropGaps()
  {
    std::vector<std::uint32_t> ends;  // of borders, each once
    for (const HullEdge& edge : hull_.edges)
      if (isBorder(edge)) ends.insert(ends.end(), edge.vertex, edge.vertex + 2);
    if (ends.empty()) return;
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Vec3d> placeAt;
    placeAt.reserve(ends.size());
    for (const std::uint32_t v : ends)
      placeAt.push_back(position(v));
    MeshView points;
    points.precisePositions = {placeAt.data(), placeAt.size()};
    const std::vector<std::uint32_t> near = weldVertices(points, gap_, threads_);
    const auto placeOf = [&](std::uint32_t v) {
      return near[static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), v) -
                                           ends.begin())];
    };
    std::vector<Border> borders;
    for (const HullEdge& edge : hull_.edges)
      if (isBorder(edge))
        borders.push_back({{placeOf(edge.vertex[0]), placeOf(edge.vertex[1])}, thirdOf(edge)});
    const std::vector<bool> areCovered = Seams(placeAt, gap_, borders).covered();
    std::size_t next = 0;
    hull_.edges.erase(
        std::remove_if(hull_.edges.begin(), hull_.edges.end(),
                       [&](const HullEdge& edge) { return isBorder(edge) && areCovered[next++]; }),
        hull_.edges.end());
  }
  /// The corner of a border's triangle that is not on it.
  Vec3d thirdOf(const HullEdge& border) const
  {
    for (const std::uint32_t v : mesh_.triangles[border.triangle[0]].vertex) {
      const std::uint32_t corner = hull_.weld[v];
      if (corner != border.vertex[0] && corner != border.vertex[1]) return position(corner);
    }
    return position(border.vertex[0]);
  }

  const MeshView& mesh_;
  int threads_;
  HullEdges& hull_;
  double gap_;
  std::vector<std::vector<HullEdge>> pairs_;
  std::vector<std::size_t> unpaired_, unlike_;  ///< the second beside others
  std::vector<bool> isTurned_;                  ///< by triangle; empty: none is
};

}  // namespace

Status buildHullEdges(const MeshView& mesh, int threads, HullEdges& hull)
{
  constexpr std::size_t kLimit = std::numeric_limits<std::uint32_t>::max();
  if (mesh.triangles.size() >= kLimit / 3 || mesh.vertexCount() >= kLimit)
    return {Error::kTooManyPrimitives,
            "The mesh has too many triangles or vertices for an inverted hull; cut it into parts."};
  hull = {};
  const Box box = finiteBox(mesh, threads);
  hull.origin = localOrigin(box);
  hull.weld = weldVertices(mesh, 0, threads);
  EdgeFinder(mesh, box, threads, hull).find();
  return {};
}

}  // namespace limn
