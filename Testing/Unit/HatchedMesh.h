// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchLines.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>

/// Meshes with the strokes on them.
namespace limn::testing {

inline constexpr double kPi = 3.14159265358979323846;

inline constexpr double kSmooth = 60, kSharp = 30;

/// A mesh with all that strokes on it are made from.
struct Hatched {
  Polyhedron mesh;
  std::vector<Vec3f> normals;
  Array<VertexCurvature> curvature;
  EdgeTable table;
  std::vector<std::uint8_t> kinds;
  CutMesh cut;
  HatchField field;
  HatchStrokes strokes;

  explicit Hatched(Polyhedron solid, std::vector<Vec3f> given = {}, double creaseDegrees = kSmooth)
      : mesh(std::move(solid)), normals(std::move(given))
  {
    if (normals.empty()) normals = vertexNormals(mesh.view(), NormalWeight::kArea);
    curvature = vertexCurvature(mesh.view(), normals, 2);
    EXPECT_TRUE(buildEdgeTable(mesh.view(), 0, 2, table).ok());
    kinds = edgeKinds(mesh.view(), table, {}, creaseDegrees, 2);
    EXPECT_TRUE(cutAtCreases(whole(), creaseDegrees, 2, cut).ok());
    field = hatchField(surface(), 2);
    strokes = traceHatching(surface(), field, 2);
  }
  HatchSurface whole() const { return {{mesh.view(), normals, curvature}, table, kinds}; }
  HatchSurface surface() const
  {
    return {cut.triangles.empty() ? whole().curved : cut.surface(), table, kinds};
  }

  /// Calls visit(middle, unit direction, is across, rank) for all pieces of strokes.
  template <class Visit>
  void forEachPiece(const Visit& visit) const
  {
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
      for (std::uint32_t i = strokes.first[s]; i + 1 < strokes.first[s + 1]; ++i) {
        const Vec3d a = strokes.points[strokes.vertex[i]];
        const Vec3d way = strokes.points[strokes.vertex[i + 1]] - a;
        visit(a + way * 0.5, way, strokes.isCross[s] != 0, static_cast<double>(strokes.rank[s]));
      }
  }
  Vec3d point(std::uint32_t i) const { return strokes.points[strokes.vertex[i]]; }
  bool isRing(std::size_t s) const
  {
    return strokes.vertex[strokes.first[s]] == strokes.vertex[strokes.first[s + 1] - 1];
  }
  /// Of strokes up to a rank.
  double length(bool isCross, double rank) const
  {
    double sum = 0;
    forEachPiece([&](Vec3d, Vec3d way, bool cross, double own) {
      if (cross == isCross && own <= rank) sum += std::sqrt(dot(way, way));
    });
    return sum;
  }
};

/// As SurfaceLines has it: the triangles of points that lie in one place share them.
inline Polyhedron welded(Polyhedron mesh)
{
  EdgeTable table;
  EXPECT_TRUE(buildEdgeTable(mesh.view(), 0, 1, table).ok());
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle.vertex)
      v = table.place[v];
  return mesh;
}

inline constexpr std::uint32_t kSides = 96;
/// Radius 1 about the z axis, 3 long, open at both ends, its seam closed.
inline const Hatched& cylinder()
{
  static const Hatched hatched = [] {
    Polyhedron mesh = grid(kSides, 40, [](double s, double t) {
      return vec3Cast<float>(Vec3d{std::cos(2 * kPi * s), std::sin(2 * kPi * s), 3 * t - 1.5});
    });
    for (Triangle& triangle : mesh.triangles)
      for (std::uint32_t& v : triangle.vertex)
        if (v % (kSides + 1) == kSides) v -= kSides;
    std::vector<Vec3f> normals;
    for (const Vec3f& p : mesh.positions)
      normals.push_back({p.x, p.y, 0});
    return Hatched(mesh, normals);
  }();
  return hatched;
}
inline const Hatched& plane()
{
  static const Hatched hatched(grid(30, 30, [](double s, double t) {
    return vec3Cast<float>(Vec3d{2 * s - 1, 2 * t - 1, 0});
  }));
  return hatched;
}
inline const Hatched& ring()
{
  static const Hatched hatched(torus(1, 0.35, 160, 80));
  return hatched;
}
inline const Hatched& ball()
{
  static const Hatched hatched = [] {
    const OwnedMesh sphere = testing::sphere(60, 90);
    Polyhedron mesh;
    mesh.positions = sphere.positions;
    mesh.triangles = sphere.triangles;
    return Hatched(welded(mesh));
  }();
  return hatched;
}

inline const double kDegree = std::sin(kPi / 180);

}  // namespace limn::testing
