// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/TriangleTree.h"

#include <algorithm>

namespace limn {
namespace {

double along(Vec3d p, int axis)
{
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

int longestAxis(const Box& box)
{
  const Vec3d size = box.high - box.low;
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

Vec3d thriceMiddle(const WorldMesh& world, std::uint32_t triangle)
{
  return (world.corner(triangle, 0) + world.corner(triangle, 1)) + world.corner(triangle, 2);
}

}  // namespace

TriangleTree::TriangleTree(const WorldMesh& world)
{
  for (std::size_t t = 0; t < world.triangles.size(); ++t)
    if (!world.isBroken(t)) order_.push_back(static_cast<std::uint32_t>(t));
  if (order_.empty()) return;
  nodes_.reserve(order_.size());
  nodes_.push_back({});
  split(world, 0, 0, static_cast<std::uint32_t>(order_.size()));
}

void TriangleTree::split(const WorldMesh& world, std::uint32_t node, std::uint32_t first,
                         std::uint32_t end)
{
  Box box, middles;
  for (std::uint32_t i = first; i < end; ++i) {
    for (int k = 0; k < 3; ++k)
      box.add(world.corner(order_[i], k));
    middles.add(thriceMiddle(world, order_[i]));
  }
  if (end - first <= kLeaf) {
    nodes_[node] = {box, first, end - first};
    return;
  }
  const int axis = longestAxis(middles);
  const std::uint32_t half = first + (end - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double atA = along(thriceMiddle(world, a), axis);
                     const double atB = along(thriceMiddle(world, b), axis);
                     return atA != atB ? atA < atB : a < b;
                   });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {box, children, 0};
  nodes_.push_back({});
  nodes_.push_back({});
  split(world, children, first, half);
  split(world, children + 1, half, end);
}

}  // namespace limn
