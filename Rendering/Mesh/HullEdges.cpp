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
#include <utility>

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
    if (isClosed() && volume() < 0)
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
    pairs_.resize(chunks);
    unpaired_.assign(chunks, 0);
    parallelForStretches(threads_, vertices, kChunk,
                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                           for (std::size_t v = begin; v < end; ++v)
                             pairAt(static_cast<std::uint32_t>(v), halves.sorted(v), pairs_[chunk],
                                    unpaired_[chunk]);
                         });
  }

  void pairAt(std::uint32_t v, Span<HalfEdge> halves, std::vector<HullEdge>& pairs,
              std::size_t& unpaired) const
  {
    constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
    const auto isForward = [&](const HalfEdge& half) { return vertex(half.corner) == v; };
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
        if (isAlone(edge)) pairs.push_back({{v, edge->end}, {edge->corner / 3, edge->corner / 3}});
        continue;
      }
      const HalfEdge &there = forward ? *edge : *other, &back = forward ? *other : *edge;
      // A triangle may have two corners in one place.
      if (there.corner / 3 != back.corner / 3)
        pairs.push_back({{v, edge->end}, {there.corner / 3, back.corner / 3}});
      other->corner = kTaken;
    }
  }

  bool isClosed() const
  {
    return std::all_of(unpaired_.begin(), unpaired_.end(), [](std::size_t n) { return n == 0; });
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
                             const auto& v = mesh_.triangles[t].vertex;
                             sum += dot(position(v[0]), cross(position(v[1]), position(v[2])));
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

  /// Leaves out borders that all but lie on another.
  void dropGaps()
  {
    using Ends = std::pair<std::uint32_t, std::uint32_t>;
    if (std::none_of(hull_.edges.begin(), hull_.edges.end(), isBorder)) return;
    const std::vector<std::uint32_t> near = weldVertices(mesh_, gap_, threads_);
    const auto endsOf = [&](const HullEdge& edge) {
      return Ends(std::minmax(near[edge.vertex[0]], near[edge.vertex[1]]));
    };
    std::vector<Ends> borders;
    for (const HullEdge& edge : hull_.edges)
      if (isBorder(edge)) borders.push_back(endsOf(edge));
    std::sort(borders.begin(), borders.end());
    const auto isGap = [&](const HullEdge& edge) {
      if (!isBorder(edge)) return false;
      const Ends ends = endsOf(edge);
      const auto [first, last] = std::equal_range(borders.begin(), borders.end(), ends);
      return ends.first == ends.second || last - first > 1;
    };
    hull_.edges.erase(std::remove_if(hull_.edges.begin(), hull_.edges.end(), isGap),
                      hull_.edges.end());
  }

  const MeshView& mesh_;
  int threads_;
  HullEdges& hull_;
  double gap_;
  std::vector<std::vector<HullEdge>> pairs_;
  std::vector<std::size_t> unpaired_;
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
