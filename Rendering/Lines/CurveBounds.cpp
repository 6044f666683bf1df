// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CurveBounds.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kBoxesPerTask = 512;

/// What rounding may make of v^T K v, as a share of K, with room to spare.
constexpr double kRounding = 1e-5;

struct Tensor {
  double value[6];
};

Tensor tensorOf(const VertexCurvature& c)
{
  const Vec3d a = vec3Cast<double>(c.direction[0]), b = vec3Cast<double>(c.direction[1]);
  const auto k = static_cast<double>(c.curvature[0]), l = static_cast<double>(c.curvature[1]);
  return {{k * a.x * a.x + l * b.x * b.x, k * a.y * a.y + l * b.y * b.y,
           k * a.z * a.z + l * b.z * b.z, k * a.x * a.y + l * b.x * b.y,
           k * a.y * a.z + l * b.y * b.z, k * a.z * a.x + l * b.z * b.x}};
}

/// Of the vertices of some edges.
CurvatureBox boxOf(const CurvedSurface& surface, Span<const MeshEdge> edges)
{
  Box places;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double low[6], high[6], size = 0;
  std::fill(low, low + 6, kFar);
  std::fill(high, high + 6, -kFar);
  bool isKnown = true;
  for (const MeshEdge& edge : edges)
    for (const std::uint32_t vertex : edge.vertex) {
      places.add(surface.mesh.position(vertex));
      const VertexCurvature& c = surface.curvature[vertex];
      const Tensor tensor = tensorOf(c);
      for (int i = 0; i < 6; ++i) {
        low[i] = std::min(low[i], tensor.value[i]);
        high[i] = std::max(high[i], tensor.value[i]);
        isKnown = isKnown && std::isfinite(tensor.value[i]);
      }
      size = std::max(size, std::fabs(static_cast<double>(c.curvature[0])) +
                                std::fabs(static_cast<double>(c.curvature[1])));
    }
  const Vec3d center = (places.low + places.high) * 0.5, reach = places.high - center;
  CurvatureBox box = {};
  box.center = vec3Cast<float>(center);
  const Vec3d rounded = vec3Cast<double>(box.center) - center;
  const double radius = std::sqrt(dot(reach, reach)) + std::sqrt(dot(rounded, rounded));
  box.radius = static_cast<float>(radius * (1 + kRounding));
  box.size =
      isKnown ? static_cast<float>(size * (1 + kRounding)) : std::numeric_limits<float>::infinity();
  for (int i = 0; i < 6; ++i) {
    box.middle[i] = static_cast<float>(0.5 * (low[i] + high[i]));
    box.half[i] = static_cast<float>(0.5 * (high[i] - low[i]));
  }
  return box;
}

}  // namespace

double featureSize(const MeshView& mesh)
{
  const Box box = finiteBox(mesh);
  if (box.empty()) return 1;
  const Vec3d diagonal = box.high - box.low;
  const double size = 0.025 * std::sqrt(dot(diagonal, diagonal));
  return size > 0 ? size : 1;
}

CurveBounds boundCurves(const CurvedSurface& surface, const EdgeTable& table, int threads)
{
  FeatureArrays arrays;
  arrays.vertexNormals = surface.normals;
  CurveBounds bounds = {
      boundNormals(surface.mesh, table, arrays, threads), {}, {}, featureSize(surface.mesh)};
  const auto isConvex = [&](std::uint32_t v) {
    return surface.curvature[v].curvature[0] >= 0 && surface.curvature[v].curvature[1] >= 0;
  };
  const std::size_t count = bounds.facing.boxes.size();
  bounds.boxes.resize(count);
  bounds.isConvex.resize(count);
  parallelForEach(threads, count, kBoxesPerTask, [&](std::size_t b) {
    const std::size_t first = b * kEdgesPerBound;
    const Span<const MeshEdge> edges = {table.edges.data() + first,
                                        std::min(kEdgesPerBound, table.edges.size() - first)};
    bounds.boxes[b] = boxOf(surface, edges);
    bounds.isConvex[b] = std::all_of(edges.begin(), edges.end(), [&](const MeshEdge& edge) {
      return isConvex(edge.vertex[0]) && isConvex(edge.vertex[1]);
    });
  });
  return bounds;
}

bool BoundedCurves::hasOneSign(const CurvatureBox& box) const
{
  const Vec3d toEye = eye_.toward(vec3Cast<double>(box.center));
  const double squared = dot(toEye, toEye), radius = static_cast<double>(box.radius);
  // The unit vector v turns by less than twice the ball's radius over its distance.
  if (!eye_.isParallel && !(squared > 4 * radius * radius)) return false;
  const double turn = (eye_.isParallel ? 0 : 2 * radius / std::sqrt(squared)) + kRounding;
  const double products[6] = {toEye.x * toEye.x,     toEye.y * toEye.y,     toEye.z * toEye.z,
                              2 * toEye.x * toEye.y, 2 * toEye.y * toEye.z, 2 * toEye.z * toEye.x};
  double middle = 0, half = turn * (2 + turn) * static_cast<double>(box.size) * squared;
  for (int i = 0; i < 6; ++i) {
    middle += products[i] * static_cast<double>(box.middle[i]);
    half += std::fabs(products[i]) * static_cast<double>(box.half[i]);
  }
  return std::fabs(middle) > half;
}

}  // namespace limn
