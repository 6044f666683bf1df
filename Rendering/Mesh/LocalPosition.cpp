// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/LocalPosition.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace limn {
namespace {

// Data nearer than this many box sizes keeps origin zero, so that float data needs no low part.
constexpr double kFarInBoxSizes = 16.0;

/// In the numbers' own precision.
template <class Vec>
FiniteBox finiteBoxOf(const Vec* position, std::size_t count)
{
  constexpr auto kInfinity = std::numeric_limits<decltype(Vec::x)>::infinity();
  Vec low = {kInfinity, kInfinity, kInfinity}, high = -low;
  bool holdsAll = true;
  for (std::size_t v = 0; v < count; ++v) {
    const Vec p = position[v];
    if (!isFinite(p)) {
      holdsAll = false;
      continue;
    }
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (low.x > high.x) return {{}, holdsAll};
  return {{vec3Cast<double>(low), vec3Cast<double>(high)}, holdsAll};
}

}  // namespace

FiniteBox finiteBox(const MeshView& mesh, int threads)
{
  constexpr std::size_t kChunk = 1 << 18;
  const std::size_t count = mesh.vertexCount();
  std::vector<FiniteBox> boxes((count + kChunk - 1) / kChunk);
  parallelFor(threads, boxes.size(), [&](std::size_t chunk) {
    const std::size_t first = chunk * kChunk, vertices = std::min(count - first, kChunk);
    boxes[chunk] = mesh.positions.empty()
                       ? finiteBoxOf(mesh.precisePositions.data() + first, vertices)
                       : finiteBoxOf(mesh.positions.data() + first, vertices);
  });
  FiniteBox all;
  for (const FiniteBox& box : boxes) {
    all.holdsAll = all.holdsAll && box.holdsAll;
    if (box.empty()) continue;
    all.add(box.low);
    all.add(box.high);
  }
  return all;
}

Vec3d localOrigin(const Box& box)
{
  if (box.empty()) return {0, 0, 0};
  const Vec3d size = box.high - box.low;
  const Vec3d centre = box.low * 0.5 + box.high * 0.5;
  const double extent = std::max({size.x, size.y, size.z});
  const double distance = std::max({std::fabs(centre.x), std::fabs(centre.y), std::fabs(centre.z)});
  return distance > kFarInBoxSizes * extent ? centre : Vec3d{0, 0, 0};
}

}  // namespace limn
