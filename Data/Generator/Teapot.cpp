// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Utah teapot: control points as published by Martin Newell (1975), z up. The body of
// revolution is given by its profile, handle and spout by one half; the rest follows by reflection.
#include "Data/Generator/GeneratedMeshes.h"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace limn {
namespace {

using Row = std::array<Vec3d, 4>;
using Patch = std::array<Row, 4>;

/// A quarter of a circle about the z axis, from +x to -y, as Newell approximated it.
Row arc(double radius, double z)
{
  const double inner = radius == 0.8 ? 0.45 : 0.56 * radius;  // the knob alone is rounded
  return {{{radius, 0, z}, {radius, -inner, z}, {inner, -radius, z}, {0, -radius, z}}};
}

Row reversed(const Row& row)
{
  return {{row[3], row[2], row[1], row[0]}};
}

/// Half of a tube's outline: two points in the plane y = 0 and two at y = -width.
Row outline(double x0, double z0, double x1, double z1, double width)
{
  return {{{x0, 0, z0}, {x0, -width, z0}, {x1, -width, z1}, {x1, 0, z1}}};
}

const Patch kQuarters[] = {
    {arc(1.4, 2.4), arc(1.3375, 2.53125), arc(1.4375, 2.53125), arc(1.5, 2.4)},  // rim
    {arc(1.5, 2.4), arc(1.75, 1.875), arc(2, 1.35), arc(2, 0.9)},                // body
    {arc(2, 0.9), arc(2, 0.45), arc(1.5, 0.225), arc(1.5, 0.15)},
    {arc(0, 3.15), arc(0.8, 3.15), arc(0, 2.85), arc(0.2, 2.7)},  // lid
    {arc(0.2, 2.7), arc(0.4, 2.55), arc(1.3, 2.55), arc(1.3, 2.4)},
    {reversed(arc(0, 0)), reversed(arc(1.425, 0)), reversed(arc(1.5, 0.075)),
     reversed(arc(1.5, 0.15))},  // bottom
};

const Patch kHalves[] = {
    {outline(-1.6, 2.025, -1.5, 2.25, 0.3), outline(-2.3, 2.025, -2.5, 2.25, 0.3),
     outline(-2.7, 2.025, -3, 2.25, 0.3), outline(-2.7, 1.8, -3, 1.8, 0.3)},  // handle
    {outline(-2.7, 1.8, -3, 1.8, 0.3), outline(-2.7, 1.575, -3, 1.35, 0.3),
     outline(-2.5, 1.125, -2.65, 0.9375, 0.3), outline(-2, 0.9, -1.9, 0.6, 0.3)},
    {outline(1.7, 1.425, 1.7, 0.6, 0.66), outline(2.6, 1.425, 3.1, 0.825, 0.66),
     outline(2.3, 2.1, 2.4, 2.025, 0.25), outline(2.7, 2.4, 3.3, 2.4, 0.25)},  // spout
    {outline(2.7, 2.4, 3.3, 2.4, 0.25), outline(2.8, 2.475, 3.525, 2.49375, 0.25),
     outline(2.9, 2.475, 3.45, 2.5125, 0.15), outline(2.8, 2.4, 3.2, 2.4, 0.15)},
};

/// Reflected in x and y; one reflection turns the patch over, so its rows are read backwards.
Patch reflected(const Patch& patch, double signX, double signY)
{
  Patch result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Row row = signX * signY < 0 ? reversed(patch[i]) : patch[i];
    for (std::size_t j = 0; j < 4; ++j)
      result[i][j] = {signX * row[j].x, signY * row[j].y, row[j].z};
  }
  return result;
}

std::array<double, 4> bernstein(double t)
{
  const double s = 1 - t;
  return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}
std::array<double, 4> bernsteinSlope(double t)
{
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * t * s, 6 * t * s - 3 * t * t, 3 * t * t};
}

Vec3d blend(const Patch& patch, const std::array<double, 4>& a, const std::array<double, 4>& b)
{
  Vec3d sum = {0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum = sum + patch[i][j] * (a[i] * b[j]);
  return sum;
}

Vec3d normalAt(const Patch& patch, double u, double v)
{
  const Vec3d du = blend(patch, bernsteinSlope(u), bernstein(v));
  const Vec3d dv = blend(patch, bernstein(u), bernsteinSlope(v));
  return cross(dv, du);
}

/// Patches meet in shared vertices; where they meet at an angle, each keeps its own normal.
class Welder {
 public:
  explicit Welder(GeneratedMesh& mesh) : mesh_(mesh) {}

  std::uint32_t add(Vec3d position, Vec3d normal)
  {
    const auto key = std::make_tuple(std::lround(position.x * 1e5), std::lround(position.y * 1e5),
                                     std::lround(position.z * 1e5));
    const auto [first, last] = known_.equal_range(key);
    for (auto it = first; it != last; ++it)
      if (dot(vec3Cast<double>(mesh_.normals[it->second]), normal) > 0.7) return it->second;
    const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(vec3Cast<float>(position));
    mesh_.normals.push_back(vec3Cast<float>(normal));
    known_.emplace(key, vertex);
    return vertex;
  }

 private:
  GeneratedMesh& mesh_;
  std::multimap<std::tuple<long, long, long>, std::uint32_t> known_;
};

/// The data has z up.
Vec3d yUp(Vec3d p)
{
  return {p.x, p.z, -p.y};
}

void addPatch(const Patch& patch, int divisions, Welder& welder, GeneratedMesh& mesh)
{
  const int side = divisions + 1;
  std::vector<std::uint32_t> vertex;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double u = static_cast<double>(i) / divisions, v = static_cast<double>(j) / divisions;
      Vec3d normal = normalAt(patch, u, v);
      // The first row of the lid's knob and of the bottom is one point on the axis.
      if (dot(normal, normal) < 1e-12) normal = {0, 0, normalAt(patch, 1e-3, v).z > 0 ? 1.0 : -1.0};
      vertex.push_back(
          welder.add(yUp(blend(patch, bernstein(u), bernstein(v))), yUp(normalized(normal))));
    }
  const auto at = [&](int i, int j) { return vertex[static_cast<std::size_t>(i * side + j)]; };
  for (int i = 0; i < divisions; ++i)
    for (int j = 0; j < divisions; ++j) {
      std::vector<std::uint32_t> polygon;
      for (const std::uint32_t v : {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)})
        if (polygon.empty() || (polygon.back() != v && polygon.front() != v)) polygon.push_back(v);
      if (polygon.size() >= 3) mesh.polygons.push_back(polygon);
    }
}

}  // namespace

GeneratedMesh teapot(int divisions)
{
  GeneratedMesh mesh;
  Welder welder(mesh);
  for (const Patch& quarter : kQuarters)
    for (const double signX : {1.0, -1.0})
      for (const double signY : {1.0, -1.0})
        addPatch(reflected(quarter, signX, signY), divisions, welder, mesh);
  for (const Patch& half : kHalves)
    for (const double signY : {1.0, -1.0})
      addPatch(reflected(half, 1, signY), divisions, welder, mesh);
  return mesh;
}

}  // namespace limn
