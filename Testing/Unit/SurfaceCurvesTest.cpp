// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/SurfaceCurves.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>
#include <cstring>

namespace limn {
namespace {

using testing::Polyhedron;
using testing::Stage;

constexpr double kPi = 3.14159265358979323846;

/// A mesh with normals by area and its curvature.
struct Curved {
  Polyhedron mesh;
  std::vector<Vec3f> normals;
  Array<VertexCurvature> curvature;
  EdgeTable table;

  explicit Curved(Polyhedron solid, std::vector<Vec3f> given = {})
      : mesh(std::move(solid)), normals(std::move(given))
  {
    if (normals.empty()) normals = vertexNormals(mesh.view(), NormalWeight::kArea);
    curvature = vertexCurvature(mesh.view(), normals, 2);
    EXPECT_TRUE(buildEdgeTable(mesh.view(), 0, 2, table).ok());
  }
  CurvedSurface surface() const { return {mesh.view(), normals, curvature}; }
  ContourLines extremes(ExtremeKind kind) const
  {
    return extremeLines(surface(), table, kind, {}, featureSize(mesh.view()), 2);
  }
  ContourLines suggestive(const Stage& stage) const
  {
    return suggestiveContours(surface(), table, {}, stage.camera(), Mat4d::identity(), {}, 2);
  }
};

Polyhedron ellipsoid(Vec3d axes)
{
  const testing::OwnedMesh sphere = testing::sphere(40, 64);
  Polyhedron mesh;
  for (const Vec3f& p : sphere.positions)
    mesh.positions.push_back(vec3Cast<float>(vec3Cast<double>(p) * axes));
  mesh.triangles = sphere.triangles;
  return mesh;
}

/// x^4 + y^4 + z^4 = 1: convex, with flat faces and round edges.
Polyhedron roundedCube()
{
  const testing::OwnedMesh sphere = testing::sphere(60, 96);
  Polyhedron mesh;
  for (const Vec3f& p : sphere.positions) {
    const Vec3d q = vec3Cast<double>(p);
    const double fourth = q.x * q.x * q.x * q.x + q.y * q.y * q.y * q.y + q.z * q.z * q.z * q.z;
    mesh.positions.push_back(vec3Cast<float>(q * (1 / std::sqrt(std::sqrt(fourth)))));
  }
  mesh.triangles = sphere.triangles;
  return mesh;
}

constexpr double kWave = 4;
constexpr double kHeight = 0.3;

/// z = kHeight sin(kWave x) over [-1.6, 1.6] x [-1, 1].
Polyhedron extrudedSine()
{
  return testing::grid(160, 24, [](double s, double t) {
    const double x = 3.2 * s - 1.6 + 0.003, y = 2 * t - 1;
    return vec3Cast<float>(Vec3d{x, y, kHeight * std::sin(kWave * x)});
  });
}
std::vector<Vec3f> normalsOfSine(const Polyhedron& mesh)
{
  std::vector<Vec3f> normals;
  for (const Vec3f& p : mesh.positions) {
    const double slope = kHeight * kWave * std::cos(kWave * static_cast<double>(p.x));
    normals.push_back(vec3Cast<float>(normalized(Vec3d{-slope, 0, 1})));
  }
  return normals;
}

TEST(Curvature, OfASphereIsOneOverItsRadius)
{
  const Polyhedron mesh = ellipsoid({2, 2, 2});
  std::vector<Vec3f> normals;
  for (const Vec3f& p : mesh.positions)
    normals.push_back(normalized(p));
  const Curved sphere(mesh, normals);
  for (const VertexCurvature& c : sphere.curvature) {
    EXPECT_NEAR(c.curvature[0], 0.5, 0.01);
    EXPECT_NEAR(c.curvature[1], 0.5, 0.01);
  }
}

TEST(Curvature, OfATorusIsThatOfItsCircles)
{
  const double R = 1, r = 0.3;
  const Curved torus(testing::torus(R, r, 120, 64));
  for (std::size_t v = 0; v < torus.mesh.positions.size(); v += 7) {
    const Vec3d p = vec3Cast<double>(torus.mesh.positions[v]);
    const double far = std::hypot(p.x, p.y), cosine = (far - R) / r;
    EXPECT_NEAR(static_cast<double>(torus.curvature[v].curvature[0]), 1 / r, 0.05);
    EXPECT_NEAR(static_cast<double>(torus.curvature[v].curvature[1]), cosine / far, 0.03);
    // D_2 of k_1 is 0; along the tube k_2 changes.
    EXPECT_NEAR(static_cast<double>(torus.curvature[v].derivative[0]), 0, 0.3);
  }
}

TEST(Curvature, AnyNumberOfThreadsGivesTheSameBits)
{
  const Polyhedron mesh = extrudedSine();
  const std::vector<Vec3f> normals = vertexNormals(mesh.view(), NormalWeight::kArea);
  const auto one = vertexCurvature(mesh.view(), normals, 1);
  const auto eight = vertexCurvature(mesh.view(), normals, 8);
  ASSERT_EQ(one.size(), eight.size());
  EXPECT_EQ(std::memcmp(one.data(), eight.data(), one.size() * sizeof one[0]), 0);
}

TEST(Curvature, BrokenFacesGiveZeros)
{
  Polyhedron mesh = testing::plane(2);
  mesh.positions.push_back({5, 5, 5});
  mesh.triangles.push_back({{0, 0, 9}});
  mesh.triangles.push_back({{0, 1, 1000}});
  const std::vector<Vec3f> normals(mesh.positions.size(), {0, 0, 1});
  for (const VertexCurvature& c : vertexCurvature(mesh.view(), normals, 2)) {
    EXPECT_EQ(c.curvature[0], 0);
    EXPECT_EQ(c.derivative[3], 0);
  }
}

TEST(SuggestiveContours, ConvexBodiesHaveNone)
{
  const Curved bodies[] = {Curved(ellipsoid({1, 1, 1})), Curved(ellipsoid({1, 0.7, 0.5})),
                           Curved(roundedCube())};
  for (const Curved& body : bodies)
    for (int turn = 0; turn < 12; ++turn) {
      Stage stage;
      const double angle = turn * kPi / 6 + 0.1;
      stage.view = turn % 2 == 0
                       ? testing::perspectiveView({3 * std::cos(angle), 1, 3 * std::sin(angle)},
                                                  {0, 0, 0}, 50)
                       : testing::parallelView({3 * std::cos(angle), 1, 3 * std::sin(angle)},
                                               {0, 0, 0}, 1.2);
      EXPECT_TRUE(body.suggestive(stage).chains.empty()) << turn;
    }
}

TEST(SuggestiveContours, OfAnExtrudedSineAreAtItsInflections)
{
  const Polyhedron mesh = extrudedSine();
  const Curved sine(mesh, normalsOfSine(mesh));
  for (const double lean : {-0.6, -0.3, 0.4, 0.7}) {
    Stage stage;
    stage.view = testing::parallelView({lean * 3, -0.6, 3}, {0, 0, 0}, 1.5);
    const ContourLines lines = sine.suggestive(stage);
    ASSERT_FALSE(lines.chains.empty());
    for (const Vec3d& p : lines.points) {
      const double n = p.x * kWave / kPi;
      EXPECT_NEAR(n, std::round(n), 0.02);
    }
  }
}

TEST(Ridges, OfAnExtrudedSineAreItsCrestsAndValleysItsTroughs)
{
  const Polyhedron mesh = extrudedSine();
  const Curved sine(mesh, normalsOfSine(mesh));
  for (const ExtremeKind kind : {ExtremeKind::kRidge, ExtremeKind::kValley}) {
    const double z = kind == ExtremeKind::kRidge ? kHeight : -kHeight;
    const ContourLines lines = sine.extremes(kind);
    ASSERT_EQ(lines.chains.first.size(), 3u) << "two of them";
    EXPECT_GT(lines.points.size(), 90u);
    for (const Vec3d& p : lines.points) {
      EXPECT_NEAR(p.z, z, 2e-3);
      const double phase = p.x * kWave / kPi - (kind == ExtremeKind::kRidge ? 0.5 : -0.5);
      EXPECT_NEAR(phase / 2, std::round(phase / 2), 0.01);
    }
  }
}

// The crests bend by kHeight kWave^2.
TEST(Ridges, AreWhereTheSurfaceBendsMoreThanTheThreshold)
{
  const Polyhedron mesh = extrudedSine();
  const Curved sine(mesh, normalsOfSine(mesh));
  const double size = featureSize(mesh.view()), bend = kHeight * kWave * kWave * size;
  for (const ExtremeKind kind : {ExtremeKind::kRidge, ExtremeKind::kValley}) {
    const auto lines = [&](double threshold) {
      return extremeLines(sine.surface(), sine.table, kind, {threshold, 0.01}, size, 2);
    };
    EXPECT_FALSE(lines(0.9 * bend).chains.empty());
    EXPECT_TRUE(lines(1.1 * bend).chains.empty());
  }
}

// Their larger curvature is the same all along its direction, but for rounding. So fine that this
// would draw thousands.
TEST(Ridges, ToriHaveNone)
{
  const Curved torus(testing::torus(1, 0.5, 300, 300));
  EXPECT_TRUE(torus.extremes(ExtremeKind::kRidge).chains.empty());
  EXPECT_TRUE(torus.extremes(ExtremeKind::kValley).chains.empty());
}

TEST(Ridges, SpheresHaveNone)
{
  const Curved sphere(ellipsoid({1, 1, 1}));
  EXPECT_TRUE(sphere.extremes(ExtremeKind::kValley).chains.empty());
}

}  // namespace
}  // namespace limn
