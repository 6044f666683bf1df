// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/LocalPosition.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <vector>

namespace limn {
namespace {

// Data nearer than this many box sizes keeps origin zero, so that float data needs no low part.
constexpr double kFarInBoxSizes = 16.0;

}  // namespace

Box finiteBox(const MeshView& mesh, int threads)
{
  constexpr std::size_t kChunk = 1 << 18;
  const std::size_t count = mesh.vertexCount();
  std::vector<Box> boxes((count + kChunk - 1) / kChunk);
  parallelFor(threads, boxes.size(), [&](std::size_t chunk) {
    Box box;
    for (std::size_t v = chunk * kChunk; v < std::min(count, (chunk + 1) * kChunk); ++v) {
      const Vec3d p = mesh.position(v);
      if (isFinite(p)) box.add(p);
    }
    boxes[chunk] = box;
  });
  Box all;
  for (const Box& box : boxes)
    if (!box.empty()) {
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
