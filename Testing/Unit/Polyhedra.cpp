// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/Polyhedra.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The convex hull's faces: planes through three points with all others on one side.
Polyhedron hullOf(const std::vector<Vec3d>& points, bool isUnit)
{
  Polyhedron solid;
  for (const Vec3d& p : points)
    solid.positions.push_back(vec3Cast<float>(isUnit ? normalized(p) : p));
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b)
      for (std::uint32_t c = b + 1; c < count; ++c) {
        Vec3d normal = cross(points[b] - points[a], points[c] - points[a]);
        if (dot(normal, points[a]) < 0) normal = -normal;
        std::vector<std::uint32_t> on;
        bool isHull = true;
        for (std::uint32_t p = 0; p < count; ++p) {
          const double side = dot(normal, points[p] - points[a]);
          if (side > 1e-9) isHull = false;
          if (std::fabs(side) <= 1e-9) on.push_back(p);
        }
        if (isHull && std::find(faces.begin(), faces.end(), on) == faces.end()) faces.push_back(on);
      }
  for (const auto& face : faces)
    solid.addFace(face);
  return solid;
}

}  // namespace

void Polyhedron::addFace(std::vector<std::uint32_t> corners)
{
  Vec3d centre = {0, 0, 0};
  for (const std::uint32_t corner : corners)
    centre = centre + vec3Cast<double>(positions[corner]);
  const Vec3d normal = normalized(centre);
  centre = centre * (1.0 / static_cast<double>(corners.size()));
  const Vec3d right = normalized(vec3Cast<double>(positions[corners[0]]) - centre);
  const Vec3d up = cross(normal, right);
  const auto angle = [&](std::uint32_t corner) {
    const Vec3d to = vec3Cast<double>(positions[corner]) - centre;
    return std::atan2(dot(to, up), dot(to, right));
  };
  std::sort(corners.begin(), corners.end(),
            [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
  const std::uint32_t cell = cells.empty() ? 0 : cells.back() + 1;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    triangles.push_back({{corners[0], corners[i], corners[i + 1]}});
    cells.push_back(cell);
  }
}

Polyhedron Polyhedron::unwelded() const
{
  Polyhedron soup;
  soup.cells = cells;
  for (const Triangle& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : triangle.vertex)
      soup.positions.push_back(positions[v]);
    soup.triangles.push_back({{first, first + 1, first + 2}});
  }
  return soup;
}

Polyhedron tetrahedron()
{
  return hullOf({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, true);
}

Polyhedron cube()
{
  std::vector<Vec3d> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({i % 2 * 2.0 - 1, i / 2 % 2 * 2.0 - 1, i / 4 * 2.0 - 1});
  return hullOf(points, false);
}

Polyhedron octahedron()
{
  return hullOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, true);
}

Polyhedron dodecahedron()
{
  const double phi = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3d> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({i % 2 * 2.0 - 1, i / 2 % 2 * 2.0 - 1, i / 4 * 2.0 - 1});
  for (const double a : {-1 / phi, 1 / phi})
    for (const double b : {-phi, phi})
      points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
  return hullOf(points, true);
}

Polyhedron icosahedron()
{
  const double phi = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3d> points;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-phi, phi})
      points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
  return hullOf(points, true);
}

Polyhedron plane(std::uint32_t count)
{
  Polyhedron mesh;
  for (std::uint32_t j = 0; j <= count; ++j)
    for (std::uint32_t i = 0; i <= count; ++i)
      mesh.positions.push_back(
          {static_cast<float>(2.0 * i / count - 1), static_cast<float>(2.0 * j / count - 1), 0});
  for (std::uint32_t j = 0; j < count; ++j)
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t p = j * (count + 1) + i;
      mesh.triangles.push_back({{p, p + 1, p + count + 2}});
      mesh.triangles.push_back({{p, p + count + 2, p + count + 1}});
      mesh.cells.insert(mesh.cells.end(), 2, j * count + i);
    }
  return mesh;
}

Polyhedron grid(std::uint32_t across, std::uint32_t along,
                const std::function<Vec3f(double, double)>& at)
{
  Polyhedron mesh;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i <= across; ++i)
      mesh.positions.push_back(at(1.0 * i / across, 1.0 * j / along));
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < across; ++i) {
      const std::uint32_t p = j * (across + 1) + i;
      mesh.triangles.push_back({{p, p + 1, p + across + 2}});
      mesh.triangles.push_back({{p, p + across + 2, p + across + 1}});
    }
  return mesh;
}

Polyhedron torus(double R, double r, std::uint32_t around, std::uint32_t across)
{
  Polyhedron mesh;
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * kPi * i / around, v = 2 * kPi * j / across;
      const double far = R + r * std::cos(v);
      mesh.positions.push_back(
          vec3Cast<float>(Vec3d{far * std::cos(u), far * std::sin(u), r * std::sin(v)}));
    }
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = i1 * across + j, c = i1 * across + j1,
                          d = i * across + j1;
      mesh.triangles.push_back({{a, b, c}});
      mesh.triangles.push_back({{a, c, d}});
      mesh.cells.insert(mesh.cells.end(), 2, a);
    }
  return mesh;
}

}  // namespace limn::testing
