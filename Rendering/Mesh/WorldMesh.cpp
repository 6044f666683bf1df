// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/WorldMesh.h"

#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Rendering/Mesh/WeldVertices.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

class WorldBuilder {
 public:
  explicit WorldBuilder(WorldMesh& world) : world_(world) { world_.firstEdge.push_back(0); }

  Status add(const PlacedMesh& placed, bool wantsEdges, int threads)
  {
    const std::size_t firstTriangle = world_.triangles.size();
    if (world_.points.size() + placed.mesh.vertexCount() > kMost ||
        firstTriangle + placed.mesh.triangles.size() > kMost)
      return {Error::kTooManyPrimitives,
              "Meshes that cast shadows or cut each other have 1431655765 triangles or more in "
              "all; draw fewer at once."};
    EdgeTable table;
    if (wantsEdges) {
      if (Status status = buildEdgeTable(placed.mesh, 0, threads, table); !status.ok())
        return status;
    } else {
      table.place = weldVertices(placed.mesh, 0, threads);
    }
    addTriangles(placed, table.place);
    addEdges(placed.mesh, table, firstTriangle);
    ++body_;
    return {};
  }
  void finish()
  {
    const Vec3d diagonal = box_.empty() ? Vec3d{0, 0, 0} : box_.high - box_.low;
    world_.size = std::sqrt(dot(diagonal, diagonal));
  }

 private:
  static constexpr std::size_t kMost = 0xFFFFFFFFu / 3;

  void addTriangles(const PlacedMesh& placed, const std::vector<std::uint32_t>& place)
  {
    firstPoint_ = static_cast<std::uint32_t>(world_.points.size());
    for (std::size_t v = 0; v < placed.mesh.vertexCount(); ++v)
      world_.points.push_back(transformPoint(placed.modelToWorld, placed.mesh.position(v)));
    for (Triangle triangle : placed.mesh.triangles) {
      if (!isUsable(triangle, place)) {
        triangle = {{0, 0, 0}};
      } else {
        for (std::uint32_t& v : triangle.vertex) {
          v = place[v] + firstPoint_;
          box_.add(world_.points[v]);
        }
      }
      world_.triangles.push_back(triangle);
      world_.body.push_back(body_);
    }
  }
  bool isUsable(const Triangle& triangle, const std::vector<std::uint32_t>& place) const
  {
    for (const std::uint32_t v : triangle.vertex)
      if (v >= place.size() || !isFinite(world_.points[place[v] + firstPoint_])) return false;
    const auto at = [&](int k) { return place[triangle.vertex[k]]; };
    return at(0) != at(1) && at(1) != at(2) && at(2) != at(0);
  }
  void addEdges(const MeshView& mesh, const EdgeTable& table, std::size_t firstTriangle)
  {
    const auto first = static_cast<std::uint32_t>(firstTriangle);
    bool hasBorder = false;
    for (const MeshEdge& edge : table.edges) {
      WorldEdge placed = {{edge.vertex[0] + firstPoint_, edge.vertex[1] + firstPoint_},
                          {edge.corner[0] / 3 + first, kNoCorner},
                          true};
      if (edge.isShared()) {
        placed.triangle[1] = edge.corner[1] / 3 + first;
        placed.isWoundAlike = table.isWoundAlike(mesh, edge);
      }
      if (world_.isBroken(placed.triangle[0]) ||
          (edge.isShared() && world_.isBroken(placed.triangle[1])))
        continue;
      hasBorder = hasBorder || !edge.isShared();
      world_.edges.push_back(placed);
    }
    world_.isClosed.push_back(!hasBorder && !table.edges.empty() ? 1 : 0);
    if (world_.isClosed.back() != 0) turnOutside(firstTriangle);
    world_.firstEdge.push_back(world_.edges.size());
  }

  /// Bodies may have been modelled, or mirrored, inside out.
  void turnOutside(std::size_t firstTriangle)
  {
    const Vec3d origin = world_.points[firstPoint_];
    double volume = 0;
    for (std::size_t t = firstTriangle; t < world_.triangles.size(); ++t)
      if (!world_.isBroken(t))
        volume += dot(world_.corner(t, 0) - origin,
                      cross(world_.corner(t, 1) - origin, world_.corner(t, 2) - origin));
    if (!(volume < 0)) return;
    for (std::size_t t = firstTriangle; t < world_.triangles.size(); ++t)
      std::swap(world_.triangles[t].vertex[1], world_.triangles[t].vertex[2]);
  }

  WorldMesh& world_;
  Box box_;
  std::uint32_t body_ = 0, firstPoint_ = 0;
};

}  // namespace

Status buildWorldMesh(Span<const PlacedMesh> meshes, Span<const std::uint8_t> wantsEdges,
                      int threads, WorldMesh& world)
{
  world = {};
  WorldBuilder builder(world);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (Status status = builder.add(meshes[i], wantsEdges[i] != 0, threads); !status.ok())
      return status;
  builder.finish();
  return {};
}

Status worldNormals(const WorldMesh& world, Span<const double> creaseDegrees, int threads,
                    WorldNormals& normals)
{
  normals = {};
  normals.normals.push_back({0, 0, 0});
  normals.ofCorner.assign(3 * world.triangles.size(), 0);
  for (std::size_t first = 0, end = 0; first < world.triangles.size(); first = end) {
    const std::uint32_t body = world.body[first];
    while (end < world.triangles.size() && world.body[end] == body)
      ++end;
    std::uint32_t low = 0xFFFFFFFFu, high = 0;
    for (std::size_t t = first; t < end; ++t)
      if (!world.isBroken(t))
        for (const std::uint32_t v : world.triangles[t].vertex) {
          low = std::min(low, v);
          high = std::max(high, v);
        }
    if (low > high) continue;
    std::vector<Triangle> triangles(world.triangles.begin() + static_cast<std::ptrdiff_t>(first),
                                    world.triangles.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t t = first; t < end; ++t)
      for (std::uint32_t& v : triangles[t - first].vertex)
        v = world.isBroken(t) ? 0 : v - low;
    const Span<const Vec3d> points = {world.points.data() + low, high - low + 1};
    SplitNormals split;
    if (Status status = splitVertexNormals({{}, points, triangles}, {}, NormalWeight::kAngle,
                                           creaseDegrees[body], threads, split);
        !status.ok())
      return status;
    const auto before = static_cast<std::uint32_t>(normals.normals.size());
    normals.normals.insert(normals.normals.end(), split.normals.begin(), split.normals.end());
    for (std::size_t c = 0; c < split.ofCorner.size(); ++c)
      normals.ofCorner[3 * first + c] = split.ofCorner[c] + before;
  }
  return {};
}

}  // namespace limn
