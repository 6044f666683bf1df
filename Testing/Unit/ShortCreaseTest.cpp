// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Creases of the finished picture that are shorter than lines are.
#include "Testing/Unit/OutlinedScene.h"

#include <cmath>
#include <utility>

namespace limn::testing {
namespace {

class ShortCreases : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(ShortCreases);

/// Adds a rectangle that faces the eye with normals `degrees` aside of that.
void add(OwnedMesh& mesh, Vec3d corner, double width, double height, double degrees)
{
  const double angle = degrees * kPi / 180;
  const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}) {
    mesh.positions.push_back(vec3Cast<float>(corner + Vec3d{x, y, 0}));
    mesh.vertexNormals.push_back(vec3Cast<float>(Vec3d{std::sin(angle), 0, std::cos(angle)}));
  }
  mesh.triangles.push_back({{vertex, vertex + 1, vertex + 2}});
  mesh.triangles.push_back({{vertex, vertex + 2, vertex + 3}});
}

Picture drawn(OwnedMesh& mesh, float width, Backend backend)
{
  finish(mesh);
  Stage stage = flatStage(64, 1);
  stage.view.eye.z = 30;
  stage.view.near = 1;
  stage.view.far = 50;
  stage.instances = {outlined(mesh, width)};
  stage.instances[0].style.normals = NormalSource::kVertex;
  return drawOverWhite(stage, backend);
}

TEST_P(ShortCreases, MakeNoDots)
{
  for (const bool isLong : {false, true}) {
    OwnedMesh mesh;
    add(mesh, {-10, -10, 0}, 90, 90, 0);
    add(mesh, {30, 30, 0.1}, isLong ? 4 : 1, isLong ? 1 : 2, 60);
    const Picture picture = drawn(mesh, 5, GetParam());
    double sum = 0;
    for (const Rgba8 color : picture.color)
      sum += darknessOf(color);
    if (isLong)
      EXPECT_GT(sum, 30) << "ten ways across its border";
    else
      EXPECT_EQ(sum, 0) << "six ways across its border";
  }
}

TEST_P(ShortCreases, StayWhereTheyGoOnAsBorders)
{
  // A strip of six pixels with a crease across.
  OwnedMesh mesh;
  add(mesh, {29, 4, 0}, 6, 28, -30);
  add(mesh, {29, 32, 0}, 6, 28, 30);
  const Picture picture = drawn(mesh, 1, GetParam());
  for (int x = 30; x < 34; ++x) {
    EXPECT_NEAR(at(picture, x, 31).g, 127.5, 1) << x;
    EXPECT_NEAR(at(picture, x, 32).g, 127.5, 1) << x;
    EXPECT_EQ(at(picture, x, 30).g, 255) << x;
  }
}

TEST_P(ShortCreases, StayWhereTheyGoOnAsSteps)
{
  // A surface before another one, which has four ways across a crease beside the border.
  for (const double gap : {0.0, 12.0}) {
    OwnedMesh mesh;
    add(mesh, {-10, -10, 0}, 90, 90, 0);
    add(mesh, {-10, -10, 8}, 30, 90, 0);
    add(mesh, {20 + gap, 30, 0.1}, 1, 2, 60);
    const Picture picture = drawn(mesh, 2, GetParam());
    EXPECT_EQ(at(picture, 18, 31).g, 0) << "the step's line";
    EXPECT_EQ(at(picture, 21, 31).g, gap == 0 ? 0 : 255);
    EXPECT_EQ(at(picture, 32, 31).g, 255);
  }
}

}  // namespace
}  // namespace limn::testing
