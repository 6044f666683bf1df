// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>

namespace limn {
namespace {

// Data nearer than this many box sizes keeps origin zero, so that float data needs no low part.
constexpr double kFarInBoxSizes = 16.0;

}  // namespace

void Box::add(Vec3d p)
{
  if (empty()) {
    low = high = p;
    return;
  }
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

Box finiteBox(const MeshView& mesh)
{
  Box box;
  for (std::size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
    const Vec3d p = mesh.position(vertex);
    if (isFinite(p)) box.add(p);
  }
  return box;
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

LocalPosition toLocal(Vec3d p, Vec3d origin)
{
  const Vec3d local = p - origin;
  const Vec3f high = vec3Cast<float>(local);
  return {high, vec3Cast<float>(local - vec3Cast<double>(high))};
}

}  // namespace limn
