// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which side of a surface is lit, and which is drawn at all.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class Sidedness : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Sidedness);

constexpr Mat4d kMirror = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

Light from(Vec3d towardLight)
{
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = -towardLight;
  return light;
}

/// The square |x|, |y| <= 1 at z = 0, counter-clockwise from +z, seen along -z or along +z.
Stage squareSeenFrom(const OwnedMesh& square, double eyeZ)
{
  Stage stage;
  stage.view.eye = {0, 0, eyeZ};
  stage.instances = {instanceOf(square)};
  return stage;
}
OwnedMesh square()
{
  return sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
}
int coveredPixels(const Picture& picture)
{
  return static_cast<int>(std::count(picture.coverage.begin(), picture.coverage.end(), 1));
}

TEST_P(Sidedness, BackFacesAreLitWithTurnedNormals)
{
  const OwnedMesh mesh = square();
  for (const NormalSource source :
       {NormalSource::kTriangle, NormalSource::kVertex, NormalSource::kCell})
    for (const ShadingFrequency frequency :
         {ShadingFrequency::kFlat, ShadingFrequency::kGouraud, ShadingFrequency::kPhong}) {
      OwnedMesh withCells = mesh;
      withCells.cellNormals = {{0, 0, 1}};
      Stage stage = squareSeenFrom(withCells, -3);
      stage.lights = {from({0.6, 0, -0.8})};
      stage.instances[0].style.normals = source;
      stage.instances[0].style.frequency = frequency;
      EXPECT_EQ(at(draw(stage), 48, 48).g, 204);
    }
}

TEST_P(Sidedness, TheFarSideOfASheetIsDarkForALightBehindIt)
{
  const OwnedMesh mesh = square();
  Stage stage = squareSeenFrom(mesh, -3);
  stage.lights = {from({0.6, 0, 0.8})};
  EXPECT_EQ(at(draw(stage), 48, 48).g, 0);
}

TEST_P(Sidedness, TheInsideOfASphereIsLitFromInside)
{
  Stage stage;
  stage.view = perspectiveView({0.3, 0.1, 0.5}, {0, 0, -1}, 60, {0.1, 4});
  stage.instances = {instanceOf(fineSphere())};
  Light light;
  light.kind = LightKind::kPoint;
  light.position = {0, 0.5, 0};
  light.color = {0.5f, 0.5f, 0.5f};
  stage.lights = {light};
  const auto inside = [](const Ray& ray) -> std::optional<Hit> {
    const double half = dot(ray.origin, ray.direction);
    const double root = std::sqrt(half * half - dot(ray.origin, ray.origin) + 1);
    const Vec3d p = ray.origin + ray.direction * (root - half);
    return Hit{p, -p, -ray.direction};
  };
  const auto lit = [](const Hit& hit) {
    const Vec3d way = Vec3d{0, 0.5, 0} - hit.position;
    const double value = 0.5 * std::max(0.0, dot(hit.normal, normalized(way))) / dot(way, way);
    return Vec3d{value, value, value};
  };
  expectPicture(stage, draw(stage), inside, lit, kRounding + 2 * kFacets);
}

TEST_P(Sidedness, AMirroringMatrixKeepsTheOutsideOutside)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].modelToWorld = kMirror;
  const Vec3d l = normalized(Vec3d{2, 1, 3});
  stage.lights = {from(l)};
  const auto lit = [&](const Hit& hit) {
    const double value = std::max(0.0, dot(hit.normal, l));
    return Vec3d{value, value, value};
  };
  for (const NormalSource source : {NormalSource::kVertex, NormalSource::kTriangle}) {
    stage.instances[0].style.normals = source;
    // A facet's own normal is off by up to half its diagonal: 0.0174 radians.
    const double facets = source == NormalSource::kVertex ? kFacets : 255 * 0.0175;
    expectPicture(stage, draw(stage), hitSphere, lit, kRounding + facets);
  }
}

TEST_P(Sidedness, AStretchingMatrixTurnsNormalsByItsInverseTranspose)
{
  // The plane z = x/2, stretched by 3 along x: z = x/6, with normal (-1, 0, 6).
  const OwnedMesh mesh = sheet({-1, -1, -0.5}, {2, 0, 1}, {0, 2, 0});
  Stage stage = squareSeenFrom(mesh, 3);
  stage.instances[0].modelToWorld.m[0][0] = 3;
  stage.lights = {from({-0.6, 0, 0.8})};
  const double expected = dot(normalized(Vec3d{-1, 0, 6}), Vec3d{-0.6, 0, 0.8});
  EXPECT_NEAR(at(draw(stage), 48, 48).g, 255 * expected, kRounding + 0.01);
}

struct Culling {
  bool cullBack, cullFront;
  double eyeZ;
  bool mirrored, drawn;
};

TEST_P(Sidedness, CullingLeavesOutWhatTurnsTheNamedSideToTheEye)
{
  const OwnedMesh mesh = square();
  // Front is counter-clockwise on the screen, so a mirror swaps front and back.
  const Culling cases[] = {{false, false, 3, false, true}, {false, false, -3, false, true},
                           {true, false, 3, false, true},  {true, false, -3, false, false},
                           {false, true, 3, false, false}, {false, true, -3, false, true},
                           {true, true, 3, false, false},  {true, true, -3, false, false},
                           {true, false, 3, true, false},  {true, false, -3, true, true},
                           {false, true, 3, true, true},   {false, true, -3, true, false}};
  for (const Culling& c : cases) {
    Stage stage = squareSeenFrom(mesh, c.eyeZ);
    Instance& instance = stage.instances[0];
    instance.cullBackFaces = c.cullBack;
    instance.cullFrontFaces = c.cullFront;
    if (c.mirrored) instance.modelToWorld = kMirror;
    EXPECT_EQ(coveredPixels(draw(stage)) > 0, c.drawn)
        << "back " << c.cullBack << " front " << c.cullFront << " eye " << c.eyeZ << " mirrored "
        << c.mirrored;
  }
}

TEST_P(Sidedness, CullingHoldsForClippedAndForHugeTriangles)
{
  const OwnedMesh mesh = sheet({-1e4, -1, -1e4}, {2e4, 0, 0}, {0, 0, 2e4});
  Stage stage;
  stage.view = perspectiveView({0, 1, 0}, {0, 0.9, -1}, 50, {0.5, 100});
  stage.instances = {instanceOf(mesh)};
  // The sheet's normal is -y, away from the eye.
  stage.instances[0].cullFrontFaces = true;
  EXPECT_GT(coveredPixels(draw(stage)), 1000);
  stage.instances[0].cullFrontFaces = false;
  stage.instances[0].cullBackFaces = true;
  EXPECT_EQ(coveredPixels(draw(stage)), 0);
}

TEST_P(Sidedness, AClosedSurfaceLooksTheSameWithoutItsBackFaces)
{
  Stage stage;
  stage.instances = {instanceOf(fineSphere())};
  stage.lights = {from({1, 1, 1})};
  const Picture all = draw(stage);
  stage.instances[0].cullBackFaces = true;
  EXPECT_EQ(draw(stage).differingPixels(all), 0u);
}

}  // namespace
}  // namespace limn::testing
