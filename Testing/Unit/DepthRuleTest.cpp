// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Who is seen in a sample: the nearest, and of equally near the one drawn last.
#include "Testing/Unit/TestScene.h"

#include <algorithm>

namespace limn::testing {
namespace {

class DepthRule : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(DepthRule);

constexpr std::size_t kCentre = 48 * 96 + 40;

OwnedMesh square(double z)
{
  return sheet({-1, -1, z}, {2, 0, 0}, {0, 2, 0});
}

TEST_P(DepthRule, TheNearestIsSeenWhateverTheOrder)
{
  const OwnedMesh far = square(-0.5), near = square(0.5);
  Stage stage;
  stage.instances = {painted(far, {1, 0, 0}, 5), painted(near, {0, 1, 0}, 6)};
  EXPECT_EQ(draw(stage).instance[kCentre], 6u);
  std::swap(stage.instances[0], stage.instances[1]);
  EXPECT_EQ(draw(stage).instance[kCentre], 6u);
}

TEST_P(DepthRule, OfEqualDepthTheLaterInstanceIsSeen)
{
  const OwnedMesh mesh = square(0);
  Stage stage;
  for (std::uint32_t id = 0; id < 5; ++id)
    stage.instances.push_back(painted(mesh, {0.1f * static_cast<float>(id), 0, 0}, 90 - id));
  const Picture picture = draw(stage);
  EXPECT_EQ(picture.instance[kCentre], 86u);
  EXPECT_EQ(picture.color[kCentre].r, 102);
}

TEST_P(DepthRule, OfEqualDepthTheLaterTriangleIsSeen)
{
  // 300 triangles, which fill several clusters: squares of growing number, forwards and turned.
  OwnedMesh mesh = square(0);
  const std::vector<Triangle> once = mesh.triangles;
  for (int i = 1; i < 150; ++i)
    for (Triangle t : once) {
      if (i % 2 == 1) std::swap(t.vertex[1], t.vertex[2]);
      mesh.triangles.push_back(t);
    }
  mesh.cells.clear();
  mesh.cellCount = 0;
  finish(mesh);
  Stage stage;
  stage.instances = {painted(mesh, {1, 1, 1})};
  const Picture picture = draw(stage);
  for (std::size_t i = 0; i < picture.cell.size(); ++i) {
    if (picture.coverage[i] == 0) continue;
    ASSERT_GE(picture.cell[i], 298u);
  }
  EXPECT_NE(picture.coverage[kCentre], 0);
}

TEST_P(DepthRule, SurfacesThatCrossAreCutWhereTheyMeet)
{
  // Planes z = x and z = -x: they cross on the middle column.
  const OwnedMesh rising = sheet({-1, -1, -1}, {2, 0, 2}, {0, 2, 0}),
                  falling = sheet({-1, -1, 1}, {2, 0, -2}, {0, 2, 0});
  Stage stage;
  stage.view.parallel = true;
  stage.instances = {painted(rising, {1, 0, 0}, 1), painted(falling, {0, 1, 0}, 2)};
  const Picture picture = draw(stage);
  for (std::size_t y = 20; y < 76; ++y)
    for (std::size_t x = 10; x < 86; ++x)
      ASSERT_EQ(picture.instance[y * 96 + x], x < 48 ? 2u : 1u) << x << ", " << y;
}

TEST_P(DepthRule, OldDepthHidesWhatIsBehindIt)
{
  const OwnedMesh mesh = square(0);
  Stage stage;
  stage.view.parallel = true;
  stage.instances = {painted(mesh, {1, 0, 0}, 1)};
  // Window depth of z = 0: (3 - 0.5) / 9.5.
  const float surface = draw(stage).depth[kCentre];
  EXPECT_NEAR(surface, 2.5 / 9.5, 1e-7);
  Picture picture(96, 96);
  picture.depth[kCentre] = std::nextafter(surface, 0.0f);
  picture.depth[kCentre + 1] = surface;
  picture.depth[kCentre + 2] = 0;
  picture.color[kCentre] = {1, 2, 3, 4};
  stage.drawOver(picture, GetParam());
  EXPECT_EQ(picture.coverage[kCentre], 0) << "a hair behind";
  EXPECT_EQ(picture.color[kCentre].r, 1);
  EXPECT_EQ(picture.depth[kCentre], std::nextafter(surface, 0.0f));
  EXPECT_EQ(picture.instance[kCentre], kNobody);
  EXPECT_EQ(picture.coverage[kCentre + 1], 1) << "equally near: drawn later, so seen";
  EXPECT_EQ(picture.coverage[kCentre + 2], 0);
}

TEST_P(DepthRule, TheNearestSampleGivesDepthAndNames)
{
  // Two half planes that meet on the middle of a pixel; the right one is nearer.
  OwnedMesh left = sheet({-2, -2, 0}, {2.0125, 0, 0}, {0, 4, 0}),
            right = sheet({0.0125, -2, 0.5}, {2, 0, 0}, {0, 4, 0});
  Stage stage;
  stage.view.parallel = true;
  stage.samples = 8;
  stage.instances = {painted(right, {0, 1, 0}, 8), painted(left, {1, 0, 0}, 9)};
  const Picture picture = draw(stage);
  const std::size_t pixel = 48 * 96 + 48;
  EXPECT_EQ(picture.coverage[pixel], 0xFF);
  EXPECT_EQ(picture.instance[pixel], 8u);
  EXPECT_NEAR(picture.depth[pixel], 2.0 / 9.5, 1e-7);
  EXPECT_EQ(picture.instance[pixel - 1], 9u);
}

}  // namespace
}  // namespace limn::testing
