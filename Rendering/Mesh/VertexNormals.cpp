// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/VertexNormals.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/CornerLists.h"
#include "Rendering/Mesh/FetchPosition.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

/// Outward, as long as twice the area; zero for a triangle that does not count.
Vec3d twiceArea(const MeshView& mesh, const Triangle& triangle)
{
  const std::size_t count = mesh.vertexCount();
  const auto [a, b, c] = triangle.vertex;
  if (a >= count || b >= count || c >= count) return {0, 0, 0};
  const Vec3d p = mesh.position(a);
  const Vec3d area = cross(mesh.position(b) - p, mesh.position(c) - p);
  return isFinite(area) ? area : Vec3d{0, 0, 0};
}

/// What a triangle adds to the normals at its corners: one cache line, as vertices ask for the
/// triangles about them one by one.
struct alignas(kCacheLine) Contribution {
  Vec3d normal;  ///< unit; or zero
  Vec3d size;    ///< kArea: the vector area; kAngle: angles by corner
  std::uint32_t vertex[3];
  bool counts;  ///< or adds nothing

  Vec3d at(std::size_t k, NormalWeight weight) const
  {
    if (weight == NormalWeight::kArea) return size;
    if (weight == NormalWeight::kUniform) return normal;
    return normal * (k == 0 ? size.x : k == 1 ? size.y : size.z);
  }
};

Contribution contributionOf(const MeshView& mesh, const Triangle& triangle, NormalWeight weight)
{
  const auto [a, b, c] = triangle.vertex;
  const Vec3d area = twiceArea(mesh, triangle);
  Contribution added = {{0, 0, 0}, area, {a, b, c}, !(area == Vec3d{0, 0, 0})};
  if (!added.counts) return added;
  added.normal = normalized(area);
  if (weight != NormalWeight::kAngle) return added;
  const Vec3d p[3] = {mesh.position(a), mesh.position(b), mesh.position(c)};
  const double length = std::sqrt(dot(area, area));
  const auto angleAt = [&](std::size_t k) {
    const Vec3d& at = p[k];
    return angleOf(dot(p[(k + 1) % 3] - at, p[(k + 2) % 3] - at), length);
  };
  added.size = {angleAt(0), angleAt(1), angleAt(2)};
  return added;
}

/// Begins to read the positions of a triangle's vertices.
void fetchPositions(const MeshView& mesh, const Triangle& triangle)
{
  for (const std::uint32_t v : triangle.vertex)
    if (v < mesh.vertexCount()) fetchPosition(mesh, v);
}

/// What all triangles of a mesh add: found once where that takes bounded memory, as each is asked
/// for at three vertices.
class Contributions {
 public:
  Contributions(const MeshView& mesh, NormalWeight weight, int threads)
      : mesh_(mesh), weight_(weight)
  {
    if (mesh.triangles.size() > kMostKept) return;
    kept_.resize(mesh.triangles.size());
    parallelForStretches(threads, kept_.size(), kTrianglesPerTask,
                         [&](std::size_t, std::size_t begin, std::size_t end) {
                           for (std::size_t t = begin; t < end; ++t) {
                             if (t + kAhead < end) fetchPositions(mesh, mesh.triangles[t + kAhead]);
                             kept_[t] = contributionOf(mesh, mesh.triangles[t], weight);
                           }
                         });
  }

  NormalWeight weight() const { return weight_; }
  /// Begins to read what of() reads.
  void fetch(std::size_t triangle) const
  {
    if (kept_.empty())
      prefetch(mesh_.triangles.data() + triangle);
    else
      prefetch(kept_.data() + triangle);
  }
  Contribution of(std::size_t triangle) const
  {
    return kept_.empty() ? contributionOf(mesh_, mesh_.triangles[triangle], weight_)
                         : kept_[triangle];
  }

 private:
  static constexpr std::size_t kMostKept = std::size_t{1} << 22, kTrianglesPerTask = 8192,
                               kAhead = 12;

  const MeshView& mesh_;
  NormalWeight weight_;
  Array<Contribution> kept_;
};

/// Groups the corners around one vertex and sums each group's normal. Kept from vertex to vertex
/// for its memory.
class CornerGroups {
 public:
  CornerGroups(const Contributions& contributions, Span<const std::uint32_t> cells, double cosine)
      : contributions_(contributions), cells_(cells), cosine_(cosine)
  {
  }

  /// Appends the vertex's normals and numbers them, from 0 on, in ofCorner.
  void add(Span<const std::uint32_t> corners, std::vector<Vec3f>& normals,
           Array<std::uint32_t>& ofCorner)
  {
    read(corners);
    join();
    number(corners, normals, ofCorner);
  }

 private:
  struct Corner {
    Vec3d normal, added;
    std::uint32_t triangle;
    std::uint32_t group;  ///< the number of a corner of the same group, at most its own
    bool counts;
  };
  struct Edge {
    std::uint32_t end;     ///< vertex
    std::uint32_t corner;  ///< index into corners_
  };

  void read(Span<const std::uint32_t> corners)
  {
    corners_.clear();
    edges_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t triangle = corners[i] / 3, k = corners[i] % 3;
      const Contribution one = contributions_.of(triangle);
      corners_.push_back({one.normal, one.at(k, contributions_.weight()), triangle, i, one.counts});
      if (!one.counts) continue;
      edges_.push_back({one.vertex[(k + 1) % 3], i});
      edges_.push_back({one.vertex[(k + 2) % 3], i});
    }
  }

  std::uint32_t rootOf(std::uint32_t corner)
  {
    while (corners_[corner].group != corner) {
      corners_[corner].group = corners_[corners_[corner].group].group;
      corner = corners_[corner].group;
    }
    return corner;
  }
  bool isSmooth(std::uint32_t a, std::uint32_t b) const
  {
    const bool isOneCell =
        !cells_.empty() && cells_[corners_[a].triangle] == cells_[corners_[b].triangle];
    return isOneCell || dot(corners_[a].normal, corners_[b].normal) >= cosine_;
  }
  void join(const Edge& a, const Edge& b)
  {
    if (!isSmooth(a.corner, b.corner)) return;
    const std::uint32_t x = rootOf(a.corner), y = rootOf(b.corner);
    corners_[std::max(x, y)].group = std::min(x, y);
  }
  /// Joins each corner with the next one at the same edge.
  void join()
  {
    // Few are faster looked through than sorted.
    constexpr std::size_t kFew = 24;
    if (edges_.size() <= kFew) {
      for (auto a = edges_.begin(); a != edges_.end(); ++a) {
        const auto b = std::find_if(a + 1, edges_.end(),
                                    [&](const Edge& other) { return other.end == a->end; });
        if (b != edges_.end()) join(*a, *b);
      }
      return;
    }
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
      return a.end != b.end ? a.end < b.end : a.corner < b.corner;
    });
    for (std::size_t i = 1; i < edges_.size(); ++i)
      if (edges_[i - 1].end == edges_[i].end) join(edges_[i - 1], edges_[i]);
  }

  void number(Span<const std::uint32_t> corners, std::vector<Vec3f>& normals,
              Array<std::uint32_t>& ofCorner)
  {
    sums_.assign(corners.size(), Vec3d{0, 0, 0});
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      if (!corners_[i].counts) continue;
      Vec3d& sum = sums_[rootOf(i)];
      sum = sum + corners_[i].added;
    }
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t root = rootOf(i);
      if (root == i) {
        ofCorner[corners[i]] = static_cast<std::uint32_t>(normals.size());
        normals.push_back(vec3Cast<float>(normalized(sums_[i])));
      } else {
        ofCorner[corners[i]] = ofCorner[corners[root]];
      }
    }
  }

  const Contributions& contributions_;
  Span<const std::uint32_t> cells_;
  double cosine_;
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
  std::vector<Vec3d> sums_;
};

}  // namespace

std::vector<Vec3f> vertexNormals(const MeshView& mesh, NormalWeight weight)
{
  const std::size_t count = mesh.vertexCount();
  std::vector<Vec3d> sums(count, Vec3d{0, 0, 0});
  constexpr std::size_t kAhead = 12;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t + kAhead < mesh.triangles.size()) {
      const Triangle& ahead = mesh.triangles[t + kAhead];
      fetchPositions(mesh, ahead);
      for (const std::uint32_t v : ahead.vertex)
        if (v < count) prefetch(sums.data() + v);
    }
    const Contribution one = contributionOf(mesh, mesh.triangles[t], weight);
    if (!one.counts) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3d& sum = sums[one.vertex[k]];
      sum = sum + one.at(k, weight);
    }
  }
  std::vector<Vec3f> normals(count);
  for (std::size_t v = 0; v < count; ++v)
    normals[v] = vec3Cast<float>(normalized(sums[v]));
  return normals;
}

Status splitVertexNormals(const MeshView& mesh, Span<const std::uint32_t> cells,
                          NormalWeight weight, double featureDegrees, int threads,
                          SplitNormals& split, Array<std::uint32_t>* only)
{
  if (mesh.triangles.size() >= std::numeric_limits<std::uint32_t>::max() / 3)
    return {Error::kTooManyPrimitives,
            "The mesh has too many triangles for normals split at a feature angle; draw it in "
            "parts, or without one."};
  split.ofCorner.resize(3 * mesh.triangles.size());
  const CornerLists corners(mesh, threads, [](std::size_t) { return true; });
  const Contributions contributions(mesh, weight, threads);
  const double cosine = cosineOfDegrees(featureDegrees);

  constexpr std::size_t kBlock = 4096, kTrianglesPerTask = 8192, kAhead = 4;
  const std::size_t vertices = mesh.vertexCount(), blocks = stretchCount(vertices, kBlock);
  std::vector<std::vector<Vec3f>> normals(blocks);
  if (only != nullptr) only->resize(vertices);
  parallelForStretches(threads, vertices, kBlock,
                       [&](std::size_t block, std::size_t begin, std::size_t end) {
                         CornerGroups groups(contributions, cells, cosine);
                         normals[block].reserve(end - begin);
                         for (std::size_t v = begin; v < end; ++v) {
                           if (v + kAhead < end)
                             for (const std::uint32_t corner : corners.of(v + kAhead)) {
                               contributions.fetch(corner / 3);
                               prefetch(split.ofCorner.data() + corner);
                             }
                           const std::size_t before = normals[block].size();
                           groups.add(corners.of(v), normals[block], split.ofCorner);
                           if (only == nullptr) continue;
                           const bool isOnly = normals[block].size() == before + 1;
                           (*only)[v] = isOnly ? static_cast<std::uint32_t>(before) : kNoOnlyNormal;
                         }
                       });

  std::vector<std::size_t> first(blocks + 1, 0);
  for (std::size_t block = 0; block < blocks; ++block)
    first[block + 1] = first[block] + normals[block].size();
  // Never empty: corners without a vertex name the first.
  split.normals.assign(std::max<std::size_t>(first[blocks], 1), Vec3f{0, 0, 0});
  parallelFor(threads, blocks, [&](std::size_t block) {
    std::copy(normals[block].begin(), normals[block].end(), split.normals.data() + first[block]);
    const std::size_t end = std::min(vertices, (block + 1) * kBlock);
    for (std::size_t v = block * kBlock; only != nullptr && v < end; ++v)
      if ((*only)[v] != kNoOnlyNormal) (*only)[v] += static_cast<std::uint32_t>(first[block]);
  });
  parallelForEach(threads, mesh.triangles.size(), kTrianglesPerTask, [&](std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t].vertex[k];
      std::uint32_t& number = split.ofCorner[3 * t + k];
      // Corners without a vertex have the first normal: none of them is drawn.
      number = v < vertices ? number + static_cast<std::uint32_t>(first[v / kBlock]) : 0;
    }
  });
  return {};
}

std::vector<std::uint32_t> verticesOfNormals(const MeshView& mesh, const SplitNormals& split)
{
  std::vector<std::uint32_t> vertices(split.normals.size(), 0);
  const std::uint32_t* number = split.ofCorner.data();
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle.vertex) {
      if (vertex < mesh.vertexCount()) vertices[*number] = vertex;
      ++number;
    }
  return vertices;
}

}  // namespace limn
