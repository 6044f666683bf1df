// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CurveBounds.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/EdgesAhead.h"
#include "Rendering/Mesh/FetchPosition.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/RecentValues.h"

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

/// How a surface bends at a vertex.
struct VertexBend {
  Vec3d position;
  Tensor tensor;
  double size;
  bool isKnown, isConvex;
};

VertexBend bendAt(const CurvedSurface& surface, std::uint32_t vertex)
{
  const VertexCurvature& c = surface.curvature[vertex];
  VertexBend bend = {surface.mesh.position(vertex), tensorOf(c),
                     std::fabs(static_cast<double>(c.curvature[0])) +
                         std::fabs(static_cast<double>(c.curvature[1])),
                     true, c.curvature[0] >= 0 && c.curvature[1] >= 0};
  for (const double value : bend.tensor.value)
    bend.isKnown = bend.isKnown && std::isfinite(value);
  return bend;
}

/// About the vertices of some edges.
class CurvatureBoxBuilder {
 public:
  CurvatureBoxBuilder()
  {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    std::fill(low_, low_ + 6, kFar);
    std::fill(high_, high_ + 6, -kFar);
  }

  void add(const VertexBend& bend)
  {
    places_.add(bend.position);
    for (int i = 0; i < 6; ++i) {
      low_[i] = std::min(low_[i], bend.tensor.value[i]);
      high_[i] = std::max(high_[i], bend.tensor.value[i]);
    }
    size_ = std::max(size_, bend.size);
    isKnown_ = isKnown_ && bend.isKnown;
    isConvex_ = isConvex_ && bend.isConvex;
  }
  bool isConvex() const { return isConvex_; }
  CurvatureBox box() const
  {
    const Vec3d center = (places_.low + places_.high) * 0.5, reach = places_.high - center;
    CurvatureBox box = {};
    box.center = vec3Cast<float>(center);
    const Vec3d rounded = vec3Cast<double>(box.center) - center;
    const double radius = std::sqrt(dot(reach, reach)) + std::sqrt(dot(rounded, rounded));
    box.radius = static_cast<float>(radius * (1 + kRounding));
    box.size = isKnown_ ? static_cast<float>(size_ * (1 + kRounding))
                        : std::numeric_limits<float>::infinity();
    for (int i = 0; i < 6; ++i) {
      box.middle[i] = static_cast<float>(0.5 * (low_[i] + high_[i]));
      box.half[i] = static_cast<float>(0.5 * (high_[i] - low_[i]));
    }
    return box;
  }

 private:
  Box places_;
  double low_[6], high_[6], size_ = 0;
  bool isKnown_ = true, isConvex_ = true;
};

}  // namespace

double featureSize(const MeshView& mesh, int threads)
{
  return featureSize(finiteBox(mesh, threads));
}

double featureSize(const Box& box)
{
  if (box.empty()) return 1;
  const Vec3d diagonal = box.high - box.low;
  const double size = 0.025 * std::sqrt(dot(diagonal, diagonal));
  return size > 0 ? size : 1;
}

CurveBounds boundCurves(const CurvedSurface& surface, const EdgeTable& table, int threads)
{
  const Box box = finiteBox(surface.mesh, threads);
  CurveBounds bounds = {
      boundEnds(surface.mesh, box, table, surface.normals, threads), {}, {}, featureSize(box)};
  const std::size_t count = bounds.facing.boxes.size();
  bounds.boxes.resize(count);
  bounds.isConvex.resize(count);
  constexpr std::size_t kEdgesPerTask = kBoxesPerTask * kEdgesPerBound;
  parallelForStretches(
      threads, table.edges.size(), kEdgesPerTask,
      [&](std::size_t, std::size_t first, std::size_t end) {
        RecentValues<VertexBend> bends;
        CurvatureBoxBuilder bend;
        const auto fetch = [&](const MeshEdge& edge) {
          for (const std::uint32_t vertex : edge.vertex) {
            if (bends.has(vertex)) continue;
            prefetch(surface.curvature.data() + vertex);
            fetchPosition(surface.mesh, vertex);
          }
        };
        forEachEdgeAhead(
            table, first, end, fetch, [](const MeshEdge&) {},
            [&](std::size_t e) {
              forEachNewEnd(table, e, [&](std::uint32_t vertex) {
                bend.add(bends.at(vertex, [&](std::uint32_t v) { return bendAt(surface, v); }));
              });
              if ((e + 1) % kEdgesPerBound != 0 && e + 1 != end) return;
              bounds.boxes[e / kEdgesPerBound] = bend.box();
              bounds.isConvex[e / kEdgesPerBound] = bend.isConvex() ? 1 : 0;
              bend = {};
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
