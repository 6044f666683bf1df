// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Terminator.h"
#include "Testing/Unit/EdgedMesh.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn {
namespace {

using testing::OwnedMesh;
using testing::Polyhedron;

const Camera kAnyCamera = {Mat4d::identity(), Mat4d::identity(), false};

LightRays directional(Vec3d direction)
{
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = direction;
  return lightRays(light, kAnyCamera);
}
LightRays pointLight(Vec3d position)
{
  Light light;
  light.kind = LightKind::kPoint;
  light.position = position;
  return lightRays(light, kAnyCamera);
}

struct Model : testing::EdgedMesh {
  using EdgedMesh::EdgedMesh;

  ContourLines terminator(const LightRays& light, const Mat4d& place = Mat4d::identity()) const
  {
    return terminatorLines(mesh, table, arrays, {}, light, place, 2);
  }
};

std::size_t closedChains(const LineChains& chains)
{
  std::size_t count = 0;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c)
    count += chains.vertex[chains.first[c]] == chains.vertex[chains.first[c + 1] - 1] ? 1 : 0;
  return count;
}
double length(const ContourLines& lines)
{
  double sum = 0;
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c)
    for (std::uint32_t i = lines.chains.first[c]; i + 1 < lines.chains.first[c + 1]; ++i) {
      const Vec3d step =
          lines.points[lines.chains.vertex[i]] - lines.points[lines.chains.vertex[i + 1]];
      sum += std::sqrt(dot(step, step));
    }
  return sum;
}

constexpr double kPi = 3.14159265358979323846;

TEST(LightRays, ComeFromWhereTheLightIs)
{
  Camera camera = kAnyCamera;
  // Looks along x: its z axis is -x of the world.
  camera.worldToView = {{{0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 0, 1}}};
  Light light;
  light.position = {1, 2, 3};
  light.direction = {0, -2, 0};
  const LightRays head = lightRays(light, camera);
  EXPECT_TRUE(head.isParallel && head.source == (Vec3d{-1, 0, 0}));
  light.kind = LightKind::kDirectional;
  EXPECT_TRUE(lightRays(light, camera).isParallel);
  EXPECT_EQ(lightRays(light, camera).towardLight({9, 9, 9}), (Vec3d{0, 1, 0}));
  for (const LightKind kind : {LightKind::kPoint, LightKind::kSphere, LightKind::kRectangle}) {
    light.kind = kind;
    const LightRays rays = lightRays(light, camera);
    EXPECT_FALSE(rays.isParallel || rays.isCone);
    EXPECT_EQ(rays.towardLight({1, 1, 1}), (Vec3d{0, 1, 2}));
  }
  light.kind = LightKind::kSpot;
  const LightRays spot = lightRays(light, camera);
  EXPECT_TRUE(spot.holds({1, -1, 3}) && spot.holds({2, -1, 3}));
  EXPECT_FALSE(spot.holds({1, 3, 3}) || spot.holds({3, -1, 3}));
}

TEST(Terminator, OfASphereInADirectionalLightIsAGreatCircleAcrossIt)
{
  const OwnedMesh sphere = testing::sphere(40, 64);
  const Model model(sphere.view(), sphere.vertexNormals);
  for (const Vec3d direction : {Vec3d{0.3, -1, 0.2}, Vec3d{-2, 0.1, 0.7}, Vec3d{0.1, 0.2, -0.9}}) {
    const LightRays light = directional(direction);
    const ContourLines lines = model.terminator(light);
    ASSERT_EQ(lines.chains.first.size(), 2u);
    EXPECT_EQ(closedChains(lines.chains), 1u);
    for (const Vec3d& p : lines.points) {
      EXPECT_NEAR(dot(p, light.source), 0, 1e-7);
      EXPECT_NEAR(dot(p, p), 1, 0.005);
    }
    EXPECT_NEAR(length(lines), 2 * kPi, 0.01);
  }
}

TEST(Terminator, OfASphereInAPointLightLiesInThePlaneOfTangents)
{
  const OwnedMesh sphere = testing::sphere(60, 96);
  const Model model(sphere.view(), sphere.vertexNormals);
  for (const double distance : {1.5, 3.0, 20.0}) {
    const Vec3d toward = normalized(Vec3d{1, -0.4, 0.6});
    const ContourLines lines = model.terminator(pointLight(toward * distance));
    ASSERT_EQ(closedChains(lines.chains), 1u);
    for (const Vec3d& p : lines.points)
      EXPECT_NEAR(dot(p, toward), 1 / distance, 2e-3) << distance;
    EXPECT_NEAR(length(lines), 2 * kPi * std::sqrt(1 - 1 / (distance * distance)), 0.01);
  }
}

// The light moves as the mesh does; unevenly scaled spheres have their line where x . A l = 0.
TEST(Terminator, GoesWithTheMesh)
{
  const OwnedMesh sphere = testing::sphere(40, 64);
  const Model model(sphere.view(), sphere.vertexNormals);
  const Mat4d place = {{{2, 0, 0, 5}, {0, 0.5, 0, -1}, {0, 0, 1, 3}, {0, 0, 0, 1}}};
  const LightRays light = directional({1, 2, -1});
  const ContourLines lines = model.terminator(light, place);
  ASSERT_EQ(closedChains(lines.chains), 1u);
  for (const Vec3d& p : lines.points)
    EXPECT_NEAR(p.x / 2 * light.source.x + p.y / 0.5 * light.source.y + p.z * light.source.z, 0,
                1e-7);
}

TEST(Terminator, IsNotWhereAllIsLitOrDark)
{
  const Polyhedron plane = testing::plane(4);
  const std::vector<Vec3f> normals(plane.positions.size(), {0, 0, 1});
  const Model model(plane.view(), normals);
  EXPECT_TRUE(model.terminator(directional({0.2, 0.3, -1})).chains.empty());
  EXPECT_TRUE(model.terminator(directional({0.2, 0.3, 1})).chains.empty());
  EXPECT_TRUE(model.terminator(pointLight({0, 5, 1})).chains.empty());
  const OwnedMesh sphere = testing::sphere(20, 30);
  const Model round(sphere.view(), sphere.vertexNormals);
  EXPECT_TRUE(round.terminator(pointLight({0.1, 0, 0})).chains.empty());
}

TEST(Terminator, FollowsHardEdgesThatAreLitOnOneSide)
{
  const Polyhedron cube = testing::cube();
  SplitNormals split;
  ASSERT_TRUE(splitVertexNormals(cube.view(), cube.cells, NormalWeight::kArea, 30, 2, split).ok());
  Model model(cube.view(), split.normals);
  model.arrays.normalOfCorner = split.ofCorner;
  const ContourLines lines = model.terminator(directional({-3, -2, -4}));
  EXPECT_EQ(closedChains(lines.chains), 1u);
  EXPECT_NEAR(length(lines), 12, 1e-12) << "the hexagon of six edges";
  EXPECT_NEAR(length(model.terminator(pointLight({0, 0, 5}))), 8, 1e-12) << "one face is lit";
}

TEST(Terminator, OfASpotEndsAtItsCone)
{
  const OwnedMesh sphere = testing::sphere(40, 64);
  const Model model(sphere.view(), sphere.vertexNormals);
  Light spot;
  spot.kind = LightKind::kSpot;
  spot.position = {0, 0, 2};
  spot.direction = {0, 1, -2};
  spot.coneDegrees = 20;
  const LightRays light = lightRays(spot, kAnyCamera);
  const ContourLines lines = model.terminator(light);
  ASSERT_EQ(lines.chains.first.size(), 2u);
  EXPECT_EQ(closedChains(lines.chains), 0u);
  EXPECT_GT(length(lines), 0.5);
  for (const std::uint32_t v : lines.chains.vertex) {
    const Vec3d way = lines.points[v] - light.source;
    EXPECT_GE(dot(normalized(way), light.axis), std::cos(20 * kPi / 180) - 1e-9);
  }
  const auto ends = {lines.chains.vertex.front(), lines.chains.vertex.back()};
  for (const std::uint32_t v : ends)
    EXPECT_NEAR(dot(normalized(lines.points[v] - light.source), light.axis),
                std::cos(20 * kPi / 180), 1e-9);
}

class TerminatorPictures : public testing::BothBackends {};

// Lambert's shading of the same normals is dark on one side and not on the other.
TEST_P(TerminatorPictures, AgreesWithTheShading)
{
  const OwnedMesh sphere = testing::sphere(12, 16);
  const Model model(sphere.view(), sphere.vertexNormals);
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-1, -0.5, -0.4};
  light.color = {50, 50, 50};
  testing::Stage stage;
  stage.width = stage.height = 200;
  stage.view = testing::parallelView({0, 0, 4}, {0, 0, 0}, 1.2);
  stage.lights = {light};
  stage.instances = {testing::painted(sphere, {0, 0, 1})};
  stage.instances[0].material.ambient = 0;
  stage.instances[0].style.reflection = Reflection::kLambert;
  stage.instances[0].style.normals = NormalSource::kVertex;
  const testing::Picture shaded = draw(stage);
  LineStyle style;
  style.color = {1, 0, 0};
  style.width = 1;
  const ContourLines lines = model.terminator(lightRays(light, stage.camera()));
  const LineSet set = lines.lines(style);
  stage.instances[0].lines = {&set, 1};
  const testing::Picture drawn = draw(stage);
  int onLine = 0;
  for (int y = 2; y < 198; ++y)
    for (int x = 2; x < 198; ++x) {
      if (testing::at(drawn, x, y).r < 200) continue;
      ++onLine;
      bool isDark = false, isLit = false;
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          const Rgba8 pixel = testing::at(shaded, x + dx, y + dy);
          isDark = isDark || pixel.b == 0;
          isLit = isLit || pixel.b > 0;
        }
      EXPECT_TRUE(isDark && isLit) << x << ' ' << y;
    }
  EXPECT_GT(onLine, 60);
}
LIMN_ON_BOTH_BACKENDS(TerminatorPictures);

}  // namespace
}  // namespace limn
