// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/VertexNormals.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/CornerLists.h"

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

/// What a triangle of this vector area, not zero, and this unit normal adds at its corner k.
Vec3d contribution(const MeshView& mesh, const Triangle& triangle, int k, Vec3d area, Vec3d normal,
                   NormalWeight weight)
{
  if (weight == NormalWeight::kArea) return area;
  if (weight == NormalWeight::kUniform) return normal;
  const auto position = [&](int i) { return mesh.position(triangle.vertex[(k + i) % 3]); };
  const Vec3d u = position(1) - position(0), v = position(2) - position(0);
  return normal * angleOf(dot(u, v), std::sqrt(dot(area, area)));
}

/// Groups the corners around one vertex and sums each group's normal. Kept from vertex to vertex
/// for its memory.
class CornerGroups {
 public:
  CornerGroups(const MeshView& mesh, Span<const std::uint32_t> cells, NormalWeight weight,
               double featureDegrees)
      : mesh_(mesh), cells_(cells), weight_(weight), cosine_(cosineOfDegrees(featureDegrees))
  {
  }

  /// Appends the vertex's normals and numbers them, from 0 on, in ofCorner.
  void add(Span<const std::uint32_t> corners, std::vector<Vec3f>& normals,
           std::vector<std::uint32_t>& ofCorner)
  {
    read(corners);
    join();
    number(corners, normals, ofCorner);
  }

 private:
  struct Corner {
    Vec3d area, normal;
    std::uint32_t group;  ///< the number of a corner of the same group, at most its own
  };
  struct Edge {
    std::uint32_t end;     ///< vertex
    std::uint32_t corner;  ///< index into corners_
  };

  const Triangle& triangleOf(std::uint32_t corner) const { return mesh_.triangles[corner / 3]; }

  void read(Span<const std::uint32_t> corners)
  {
    corners_.clear();
    edges_.clear();
    triangles_.clear();
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const Triangle& triangle = triangleOf(corners[i]);
      const std::uint32_t k = corners[i] % 3;
      const Vec3d area = twiceArea(mesh_, triangle);
      corners_.push_back({area, normalized(area), i});
      triangles_.push_back(corners[i] / 3);
      if (area == Vec3d{0, 0, 0}) continue;
      edges_.push_back({triangle.vertex[(k + 1) % 3], i});
      edges_.push_back({triangle.vertex[(k + 2) % 3], i});
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
    const bool isOneCell = !cells_.empty() && cells_[triangles_[a]] == cells_[triangles_[b]];
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
              std::vector<std::uint32_t>& ofCorner)
  {
    sums_.assign(corners.size(), Vec3d{0, 0, 0});
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const Corner& corner = corners_[i];
      if (corner.area == Vec3d{0, 0, 0}) continue;
      Vec3d& sum = sums_[rootOf(i)];
      sum = sum + contribution(mesh_, triangleOf(corners[i]), static_cast<int>(corners[i] % 3),
                               corner.area, corner.normal, weight_);
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

  const MeshView& mesh_;
  Span<const std::uint32_t> cells_;
  NormalWeight weight_;
  double cosine_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Edge> edges_;
  std::vector<Vec3d> sums_;
};

}  // namespace

std::vector<Vec3f> vertexNormals(const MeshView& mesh, NormalWeight weight)
{
  const std::size_t count = mesh.vertexCount();
  std::vector<Vec3d> sums(count, Vec3d{0, 0, 0});
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3d area = twiceArea(mesh, triangle);
    if (area == Vec3d{0, 0, 0}) continue;
    const Vec3d normal = weight == NormalWeight::kArea ? area : normalized(area);
    for (int k = 0; k < 3; ++k) {
      Vec3d& sum = sums[triangle.vertex[k]];
      sum = sum + contribution(mesh, triangle, k, area, normal, weight);
    }
  }
  std::vector<Vec3f> normals(count);
  for (std::size_t v = 0; v < count; ++v)
    normals[v] = vec3Cast<float>(normalized(sums[v]));
  return normals;
}

Status splitVertexNormals(const MeshView& mesh, Span<const std::uint32_t> cells,
                          NormalWeight weight, double featureDegrees, int threads,
                          SplitNormals& split)
{
  if (mesh.triangles.size() >= std::numeric_limits<std::uint32_t>::max() / 3)
    return {Error::kTooManyPrimitives,
            "The mesh has too many triangles for normals split at a feature angle; draw it in "
            "parts, or without one."};
  // Corners without a vertex have the first normal: none of them is drawn.
  split.ofCorner.assign(3 * mesh.triangles.size(), 0);
  const CornerLists corners(mesh, threads, [](std::size_t) { return true; });

  constexpr std::size_t kBlock = 4096;
  const std::size_t blocks = (mesh.vertexCount() + kBlock - 1) / kBlock;
  std::vector<std::vector<Vec3f>> normals(blocks);
  const auto forEachVertex = [&](std::size_t block, auto visit) {
    const std::size_t end = std::min(mesh.vertexCount(), (block + 1) * kBlock);
    for (std::size_t vertex = block * kBlock; vertex < end; ++vertex)
      visit(corners.of(vertex));
  };
  parallelFor(threads, blocks, [&](std::size_t block) {
    CornerGroups groups(mesh, cells, weight, featureDegrees);
    forEachVertex(block, [&](Span<const std::uint32_t> around) {
      groups.add(around, normals[block], split.ofCorner);
    });
  });

  std::vector<std::size_t> first(blocks + 1, 0);
  for (std::size_t block = 0; block < blocks; ++block)
    first[block + 1] = first[block] + normals[block].size();
  // Never empty: corners without a vertex name the first.
  split.normals.assign(std::max<std::size_t>(first[blocks], 1), Vec3f{0, 0, 0});
  parallelFor(threads, blocks, [&](std::size_t block) {
    std::copy(normals[block].begin(), normals[block].end(), split.normals.begin() + first[block]);
    forEachVertex(block, [&](Span<const std::uint32_t> around) {
      for (const std::uint32_t corner : around)
        split.ofCorner[corner] += static_cast<std::uint32_t>(first[block]);
    });
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
