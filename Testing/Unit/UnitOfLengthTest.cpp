// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A scene looks alike in metres and in any other unit: to the bit, if that is a power of two.
#include "Testing/Unit/OutlinedScene.h"

#include <cmath>
#include <vector>

namespace limn::testing {
namespace {

class UnitOfLength : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(UnitOfLength);

OwnedMesh scaled(OwnedMesh mesh, double unit)
{
  for (Vec3f& p : mesh.positions)
    p = p * static_cast<float>(unit);
  finish(mesh);
  return mesh;
}

struct Lines {
  bool drawn;
};

/// Spheres that cut each other, without normals of their own, in perspective.
Picture spheres(double unit, NormalSource normals, Lines lines, int samples, Backend backend)
{
  const OwnedMesh mesh = scaled(sphere(20, 32), unit);
  Stage stage;
  stage.width = stage.height = 120;
  stage.samples = samples;
  stage.view = perspectiveView(Vec3d{1, 0.7, 3.4} * unit, {0, 0, 0}, 50, {1 * unit, 6 * unit});
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-1, -2, -1};
  stage.lights = {light};
  for (const double x : {-0.4, 0.4}) {
    Instance instance = instanceOf(mesh);
    instance.style.normals = normals;
    instance.modelToWorld.m[0][3] = x * unit;
    if (lines.drawn) {
      instance.style.imageOutline.detector = OutlineDetector::kPlane;
      instance.style.outlineWidth = 3;
    }
    stage.instances.push_back(instance);
  }
  return stage.draw(backend);
}

void expectAlike(NormalSource normals, Lines lines, Backend backend)
{
  for (const int samples : {1, 4}) {
    const Picture metres = spheres(1, normals, lines, samples, backend);
    EXPECT_GT(at(metres, 60, 60).g, 100);
    for (const int power : {-60, -40, 30, 33, 40, 60})
      EXPECT_EQ(
          spheres(std::ldexp(1, power), normals, lines, samples, backend).differingPixels(metres),
          0u)
          << "2 to the power of " << power << ", samples: " << samples;
  }
}

TEST_P(UnitOfLength, DoesNotShowInFacets)
{
  expectAlike(NormalSource::kTriangle, {false}, GetParam());
}

TEST_P(UnitOfLength, DoesNotShowInOutlinesOfTheImage)
{
  expectAlike(NormalSource::kTriangle, {true}, GetParam());
  expectAlike(NormalSource::kVertex, {true}, GetParam());
}

}  // namespace
}  // namespace limn::testing
