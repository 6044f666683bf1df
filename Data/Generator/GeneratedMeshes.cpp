// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedMeshes.h"

#include <cmath>

namespace limn {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct SurfacePoint {
  Vec3d position, normal;
};

/// How the two ends of a grid's parameter meet.
enum class Ends { kOpen, kJoined };

/// A grid of quads over surface(u, v), u and v in [0, 1]; du x dv must point outwards.
template <class Surface>
GeneratedMesh grid(int columns, Ends columnEnds, int rows, Ends rowEnds, Surface surface)
{
  GeneratedMesh mesh;
  const int width = columnEnds == Ends::kJoined ? columns : columns + 1;
  const int height = rowEnds == Ends::kJoined ? rows : rows + 1;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const SurfacePoint p =
          surface(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      mesh.positions.push_back(vec3Cast<float>(p.position));
      mesh.normals.push_back(vec3Cast<float>(normalized(p.normal)));
    }
  const auto at = [&](int column, int row) {
    return static_cast<std::uint32_t>((row % height) * width + column % width);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.polygons.push_back(
          {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
  return mesh;
}

/// Those of an open grid.
void addTexCoords(GeneratedMesh& mesh, int columns, int rows)
{
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      mesh.texCoords.push_back({static_cast<float>(column) / static_cast<float>(columns),
                                static_cast<float>(row) / static_cast<float>(rows)});
}

}  // namespace

std::vector<Triangle> GeneratedMesh::triangles() const
{
  std::vector<Triangle> result;
  for (const auto& polygon : polygons)
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      result.push_back({{polygon[0], polygon[i], polygon[i + 1]}});
  return result;
}

GeneratedMesh sphere(int around, int along, double radius)
{
  GeneratedMesh mesh;
  const auto add = [&](Vec3d direction) {
    mesh.positions.push_back(vec3Cast<float>(direction * radius));
    mesh.normals.push_back(vec3Cast<float>(direction));
  };
  add({0, 1, 0});
  for (int ring = 1; ring < along; ++ring)
    for (int column = 0; column < around; ++column) {
      const double polar = kPi * ring / along, turn = 2 * kPi * column / around;
      add({std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn)});
    }
  add({0, -1, 0});
  const auto at = [&](int column, int ring) {
    return static_cast<std::uint32_t>(1 + (ring - 1) * around + column % around);
  };
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (int column = 0; column < around; ++column) {
    mesh.polygons.push_back({0, at(column, 1), at(column + 1, 1)});
    for (int ring = 1; ring + 1 < along; ++ring)
      mesh.polygons.push_back(
          {at(column, ring), at(column, ring + 1), at(column + 1, ring + 1), at(column + 1, ring)});
    mesh.polygons.push_back({at(column, along - 1), last, at(column + 1, along - 1)});
  }
  return mesh;
}

GeneratedMesh rock(int around, int along)
{
  constexpr struct {
    double frequency, height;
  } kSizes[] = {{3, 0.06}, {8, 0.024}, {20, 0.01}};
  constexpr int kWaves = 7;
  const auto radius = [&](Vec3d p) {
    double sum = 1;
    int wave = 0;
    for (const auto& size : kSizes)
      for (int i = 0; i < kWaves; ++i, ++wave) {
        // Directions of Fibonacci's spiral.
        const double y = 1 - (2 * wave + 1) / 21.0, turn = 2.399963 * wave;
        const double r = std::sqrt(1 - y * y);
        const double place = r * std::cos(turn) * p.x + y * p.y + r * std::sin(turn) * p.z;
        sum += size.height * std::sin(size.frequency * (1 + 0.1 * i) * place + 1.7 * wave);
      }
    return sum;
  };
  GeneratedMesh mesh = sphere(around, along, 1);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3d p = vec3Cast<double>(mesh.normals[v]);
    mesh.positions[v] = vec3Cast<float>(p * radius(p));
  }
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d{0, 0, 0});
  for (const Triangle& triangle : mesh.triangles()) {
    const auto [a, b, c] = triangle.vertex;
    const Vec3d p = vec3Cast<double>(mesh.positions[a]);
    const Vec3d area =
        cross(vec3Cast<double>(mesh.positions[b]) - p, vec3Cast<double>(mesh.positions[c]) - p);
    for (const std::uint32_t v : triangle.vertex)
      sums[v] = sums[v] + area;
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    mesh.normals[v] = vec3Cast<float>(normalized(sums[v]));
  return mesh;
}

GeneratedMesh torus(int around, int across, double ring, double tube)
{
  return grid(around, Ends::kJoined, across, Ends::kJoined, [&](double u, double v) {
    const double a = 2 * kPi * u, b = 2 * kPi * v;
    const Vec3d outward = {std::sin(a), 0, std::cos(a)};
    const Vec3d normal = outward * std::cos(b) + Vec3d{0, std::sin(b), 0};
    return SurfacePoint{outward * ring + normal * tube, normal};
  });
}

GeneratedMesh knot(int along, int across, double tube)
{
  return grid(along, Ends::kJoined, across, Ends::kJoined, [&](double u, double v) {
    const double t = 2 * kPi * u, b = 2 * kPi * v;
    const Vec3d centre = {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                          -std::sin(3 * t)};
    const Vec3d first = {std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t),
                         -3 * std::cos(3 * t)};
    const Vec3d second = {-std::sin(t) - 8 * std::sin(2 * t), -std::cos(t) + 8 * std::cos(2 * t),
                          9 * std::sin(3 * t)};
    // Frenet's frame closes after one turn because the curve is periodic.
    const Vec3d tangent = normalized(first);
    const Vec3d binormal = normalized(cross(first, second));
    const Vec3d principal = cross(binormal, tangent);
    const Vec3d normal = principal * std::cos(b) - binormal * std::sin(b);
    return SurfacePoint{centre + normal * tube, normal};
  });
}

GeneratedMesh gear(int teeth, double thickness)
{
  constexpr double kBore = 0.35, kRoot = 0.8, kTip = 1.0;
  // A tooth's outline: fractions of its angle, and radii.
  constexpr double kAngle[] = {0.0, 0.25, 0.36, 0.64, 0.75};
  constexpr double kRadius[] = {kRoot, kRoot, kTip, kTip, kRoot};
  constexpr int kPointsPerTooth = 5;
  GeneratedMesh mesh;
  const int count = teeth * kPointsPerTooth;
  for (const double z : {-thickness / 2, thickness / 2})
    for (const bool outer : {false, true})
      for (int i = 0; i < count; ++i) {
        const int tooth = i / kPointsPerTooth, part = i % kPointsPerTooth;
        const double angle = 2 * kPi * (tooth + kAngle[part]) / teeth;
        const double radius = outer ? kRadius[part] : kBore;
        mesh.positions.push_back(
            vec3Cast<float>(Vec3d{radius * std::cos(angle), radius * std::sin(angle), z}));
      }
  enum { kBackBore, kBackRim, kFrontBore, kFrontRim };
  const auto at = [&](int ring, int i) {
    return static_cast<std::uint32_t>(ring * count + i % count);
  };
  const auto join = [&](int a, int b) {
    for (int i = 0; i < count; ++i)
      mesh.polygons.push_back({at(a, i), at(b, i), at(b, i + 1), at(a, i + 1)});
  };
  join(kFrontBore, kFrontRim);
  join(kFrontRim, kBackRim);
  join(kBackRim, kBackBore);
  join(kBackBore, kFrontBore);
  return mesh;
}

GeneratedMesh extrudedSine(int columns, int rows)
{
  return grid(columns, Ends::kOpen, rows, Ends::kOpen, [](double u, double v) {
    const double x = 4 * u - 2;
    return SurfacePoint{{x, 0.25 * std::sin(kPi * x), 1 - 2 * v},
                        {-0.25 * kPi * std::cos(kPi * x), 1, 0}};
  });
}

GeneratedMesh sheet(int side)
{
  return grid(side, Ends::kOpen, side, Ends::kOpen, [](double u, double v) {
    const double x = 2 * u - 1, z = 1 - 2 * v;
    const double height = 0.12 * std::sin(4 * x) * std::cos(3 * z);
    return SurfacePoint{
        {x, height, z},
        {-0.48 * std::cos(4 * x) * std::cos(3 * z), 1, 0.36 * std::sin(4 * x) * std::sin(3 * z)}};
  });
}

GeneratedMesh globe(int around, int along)
{
  GeneratedMesh mesh = grid(around, Ends::kOpen, along, Ends::kOpen, [](double u, double v) {
    const double turn = 2 * kPi * u + kPi, up = kPi * (v - 0.5);
    const Vec3d direction = {std::cos(up) * std::sin(turn), std::sin(up),
                             std::cos(up) * std::cos(turn)};
    return SurfacePoint{direction, direction};
  });
  addTexCoords(mesh, around, along);
  return mesh;
}

GeneratedMesh board(int side)
{
  GeneratedMesh mesh = grid(side, Ends::kOpen, side, Ends::kOpen, [](double u, double v) {
    return SurfacePoint{{2 * u - 1, 2 * v - 1, 0}, {0, 0, 1}};
  });
  addTexCoords(mesh, side, side);
  for (Vec2f& t : mesh.texCoords)
    t = {2 * t.x - 0.5f, 2 * t.y - 0.5f};
  return mesh;
}

GeneratedMesh cube()
{
  GeneratedMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {(i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 1.0f : -1.0f, (i & 4) != 0 ? 1.0f : -1.0f});
  mesh.polygons = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return mesh;
}

}  // namespace limn
