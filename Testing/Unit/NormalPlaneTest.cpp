// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// FrameView::normal.
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn::testing {
namespace {

class NormalPlane : public BothBackends {
 protected:
  Picture drawNormals(const Stage& stage) const
  {
    Picture picture(stage.width, stage.height);
    picture.addNormals();
    for (std::vector<float>& plane : picture.normal)
      std::fill(plane.begin(), plane.end(), 7.0f);
    stage.drawOver(picture, GetParam());
    return picture;
  }
};
LIMN_ON_BOTH_BACKENDS(NormalPlane);

/// In view space, of a normal of the world.
Vec3d inView(const Stage& stage, Vec3d normal)
{
  const auto [right, up, back] = axesOf(stage.view);
  return {dot(right, normal), dot(up, normal), dot(back, normal)};
}

TEST_P(NormalPlane, HoldsTheNormalsOfASphereAndLeavesTheRestAlone)
{
  for (const int samples : {1, 4})
    for (const bool parallel : {false, true}) {
      Stage stage;
      stage.view.eye = {1.5, 1, 2.5};
      stage.view.parallel = parallel;
      stage.samples = samples;
      stage.instances = {instanceOf(fineSphere())};
      const Picture picture = drawNormals(stage);
      int seen = 0;
      for (int y = 0; y < stage.height; ++y)
        for (int x = 0; x < stage.width; ++x) {
          const auto i = static_cast<std::size_t>(y * stage.width + x);
          if (picture.coverage[i] == 0) {
            ASSERT_EQ(picture.normal[0][i], 7.0f) << "old values stay";
            continue;
          }
          const auto hit = hitSphere(stage.ray(x + 0.5, y + 0.5));
          if (!hit || dot(hit->normal, hit->towardEye) < 0.3) continue;
          const Vec3d n = inView(stage, hit->normal);
          // Triangles that have some samples alone are shaded at one of them.
          const double tolerance = samples == 1 ? 2e-3 : 3e-2;
          ASSERT_NEAR(picture.normal[0][i], n.x, tolerance) << x << ", " << y;
          ASSERT_NEAR(picture.normal[1][i], n.y, tolerance) << x << ", " << y;
          ASSERT_NEAR(picture.normal[2][i], n.z, tolerance) << x << ", " << y;
          ++seen;
        }
      EXPECT_GT(seen, 2000);
    }
}

TEST_P(NormalPlane, IsThatOfTheNearestSampleAndTurnedToTheEye)
{
  // A wall, and before its left half another that leans and is seen from behind.
  const OwnedMesh wall = sheet({0, 0, 0}, {16, 0, 0}, {0, 16, 0});
  const OwnedMesh leaning = sheet({0, 0, 0.25}, {0, 16, 0.125}, {7.5, 0, 0});
  Stage stage = pixelStage(16, 4);
  stage.instances = {painted(wall, {1, 1, 1}), painted(leaning, {1, 0, 0})};
  const Picture picture = drawNormals(stage);
  const double length = std::sqrt(1 + 1.0 / 16384);
  for (int x = 0; x < 16; ++x) {
    const auto i = static_cast<std::size_t>(5 * 16 + x);
    ASSERT_NEAR(picture.normal[1][i], x < 8 ? -1.0 / 128 / length : 0.0, 1e-6) << x;
    ASSERT_NEAR(picture.normal[2][i], x < 8 ? 1 / length : 1.0, 1e-6) << x;
  }
}

TEST_P(NormalPlane, IsClearedToZero)
{
  const OwnedMesh half = sheet({0, 0, 0}, {8, 0, 0}, {0, 16, 0});
  Stage stage = pixelStage(16, 1);
  stage.instances = {painted(half, {1, 1, 1})};
  Picture picture(16, 16);
  picture.addNormals();
  for (std::vector<float>& plane : picture.normal)
    std::fill(plane.begin(), plane.end(), 7.0f);
  FrameView frame = picture.frame(Background::kBlend);
  frame.clear.extent = FrameClear::Extent::kAll;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 2}).ok());
  for (std::size_t x = 0; x < 16; ++x) {
    EXPECT_EQ(picture.normal[0][x], 0.0f);
    EXPECT_EQ(picture.normal[2][x], x < 8 ? 1.0f : 0.0f);
  }
}

TEST_P(NormalPlane, IsRefusedInPart)
{
  Stage stage = pixelStage(16, 1);
  Picture picture(16, 16);
  picture.addNormals();
  FrameView frame = picture.frame(Background::kBlend);
  frame.normal.y = nullptr;
  EXPECT_EQ(render(stage.scene(), frame, {GetParam(), 1}).error, Error::kMissingData);
}

}  // namespace
}  // namespace limn::testing
