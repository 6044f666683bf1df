// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/HullEdges.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

namespace limn {
namespace {

constexpr std::size_t kChunk = 1 << 14;

template <class Body>
void forEachChunk(std::size_t count, int threads, Body body)
{
  parallelFor(threads, (count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    body(chunk, chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
  });
}

/// Finds vertices in the same place: by hash into parts, each part by a table of its own.
class Welder {
 public:
  Welder(const MeshView& mesh, int threads) : mesh_(mesh), threads_(threads) {}

  std::vector<std::uint32_t> weld()
  {
    sortByPart();
    std::vector<std::uint32_t> first(mesh_.vertexCount());
    parallelFor(threads_, kParts, [&](std::size_t part) { weldPart(part, first); });
    return first;
  }

 private:
  static constexpr int kPartBits = 5;
  static constexpr std::size_t kParts = 1 << kPartBits;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  static bool areSame(Vec3d a, Vec3d b) { return a == b; }
  std::uint32_t hashOf(Vec3d p) const
  {
    std::uint64_t hash = 0;
    for (const double coordinate : {p.x, p.y, p.z}) {
      const double value = coordinate + 0.0;  // -0 is 0
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::uint32_t>((hash * 0x9E3779B97F4A7C15u) >> 32);
  }

  void sortByPart()
  {
    const std::size_t count = mesh_.vertexCount();
    hash_.resize(count);
    forEachChunk(count, threads_, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        hash_[v] = hashOf(mesh_.position(v));
    });
    for (const std::uint32_t hash : hash_)
      ++firstOfPart_[(hash >> (32 - kPartBits)) + 1];
    std::partial_sum(firstOfPart_, firstOfPart_ + kParts + 1, firstOfPart_);
    order_.resize(count);
    std::size_t next[kParts];
    std::copy_n(firstOfPart_, kParts, next);
    for (std::size_t v = 0; v < count; ++v)
      order_[next[hash_[v] >> (32 - kPartBits)]++] = static_cast<std::uint32_t>(v);
  }

  void weldPart(std::size_t part, std::vector<std::uint32_t>& first) const
  {
    const std::size_t begin = firstOfPart_[part], end = firstOfPart_[part + 1];
    std::size_t slots = 16;
    while (slots < 2 * (end - begin))
      slots *= 2;
    std::vector<std::uint32_t> table(slots, kNone);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = order_[i];
      const Vec3d p = mesh_.position(v);
      std::size_t slot = hash_[v] & (slots - 1);
      while (table[slot] != kNone && !areSame(mesh_.position(table[slot]), p))
        slot = (slot + 1) & (slots - 1);
      // What is not a number equals nothing, and stays alone.
      if (table[slot] == kNone && isFinite(p)) table[slot] = v;
      first[v] = isFinite(p) ? table[slot] : v;
    }
  }

  const MeshView& mesh_;
  int threads_;
  Array<std::uint32_t> hash_, order_;
  std::size_t firstOfPart_[kParts + 1] = {};
};

bool isDrawable(const MeshView& mesh, const Triangle& triangle, Vec3d origin)
{
  for (const std::uint32_t v : triangle.vertex)
    if (v >= mesh.vertexCount() || !isFinite(mesh.position(v)) ||
        !isFinite(toLocal(mesh.position(v), origin).high))
      return false;
  return true;
}

/// An edge of one triangle, listed at the smaller of its vertices.
struct HalfEdge {
  std::uint32_t end;     ///< the larger vertex
  std::uint32_t corner;  ///< three times the triangle's number, and of the corner that it starts at
  bool forward;          ///< from the smaller vertex to the larger
};

class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, int threads, HullEdges& hull)
      : mesh_(mesh), threads_(threads), hull_(hull)
  {
  }

  void find()
  {
    findNormals();
    listHalfEdges();
    pair();
    if (isClosed() && volume() < 0)
      for (Vec3f& normal : hull_.normal)
        normal = -normal;
    keepConvex();
  }

 private:
  std::uint32_t vertex(std::size_t corner) const
  {
    return hull_.weld[mesh_.triangles[corner / 3].vertex[corner % 3]];
  }
  std::uint32_t nextVertex(std::size_t corner) const
  {
    return vertex(corner / 3 * 3 + (corner + 1) % 3);
  }
  Vec3d position(std::uint32_t v) const { return mesh_.position(v) - hull_.origin; }
  bool counts(std::size_t triangle) const { return !(hull_.normal[triangle] == Vec3f{0, 0, 0}); }

  void findNormals()
  {
    hull_.normal.resize(mesh_.triangles.size());
    forEachChunk(hull_.normal.size(), threads_,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t t = begin; t < end; ++t) {
                     const Triangle& triangle = mesh_.triangles[t];
                     hull_.normal[t] = {0, 0, 0};
                     if (!isDrawable(mesh_, triangle, hull_.origin)) continue;
                     const Vec3d p = position(triangle.vertex[0]);
                     const Vec3d area =
                         cross(position(triangle.vertex[1]) - p, position(triangle.vertex[2]) - p);
                     const Vec3d unit = normalized(area);
                     if (isFinite(unit)) hull_.normal[t] = vec3Cast<float>(unit);
                   }
                 });
  }

  template <class Visit>
  void forEachHalfEdge(Visit visit) const
  {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!counts(t)) continue;
      for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
        const std::uint32_t a = vertex(corner), b = nextVertex(corner);
        visit(std::min(a, b), HalfEdge{std::max(a, b), static_cast<std::uint32_t>(corner), a < b});
      }
    }
  }

  void listHalfEdges()
  {
    first_.assign(mesh_.vertexCount() + 1, 0);
    forEachHalfEdge([&](std::uint32_t vertex, const HalfEdge&) { ++first_[vertex + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    halfEdges_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    forEachHalfEdge(
        [&](std::uint32_t vertex, const HalfEdge& edge) { halfEdges_[next[vertex]++] = edge; });
  }

  /// Pairs the half edges of each vertex; what is left over is counted.
  void pair()
  {
    const std::size_t vertices = mesh_.vertexCount();
    const std::size_t chunks = (vertices + kChunk - 1) / kChunk;
    pairs_.resize(chunks);
    unpaired_.assign(chunks, 0);
    forEachChunk(vertices, threads_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        pairAt(static_cast<std::uint32_t>(v), pairs_[chunk], unpaired_[chunk]);
    });
    halfEdges_ = {};
  }

  void pairAt(std::uint32_t v, std::vector<HullEdge>& pairs, std::size_t& unpaired)
  {
    HalfEdge* const begin = halfEdges_.data() + first_[v];
    HalfEdge* const end = halfEdges_.data() + first_[v + 1];
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.end != b.end ? a.end < b.end : a.corner < b.corner;
    });
    constexpr std::uint32_t kTaken = std::numeric_limits<std::uint32_t>::max();
    for (HalfEdge* edge = begin; edge != end; ++edge) {
      if (edge->corner == kTaken) continue;
      HalfEdge* other = edge + 1;
      while (other != end && other->end == edge->end &&
             (other->corner == kTaken || other->forward == edge->forward))
        ++other;
      if (other == end || other->end != edge->end) {
        ++unpaired;
        continue;
      }
      const HalfEdge &there = edge->forward ? *edge : *other,
                     &back = edge->forward ? *other : *edge;
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
    forEachChunk(mesh_.triangles.size(), threads_,
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

  const MeshView& mesh_;
  int threads_;
  HullEdges& hull_;
  std::vector<std::uint32_t> first_;  ///< by vertex, its half edges
  Array<HalfEdge> halfEdges_;
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
  hull.origin = localOrigin(finiteBox(mesh, threads));
  hull.weld = Welder(mesh, threads).weld();
  EdgeFinder(mesh, threads, hull).find();
  return {};
}

}  // namespace limn
