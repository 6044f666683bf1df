// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outlines by normals: Style::evenOutline is as wide as it says, whatever the surface; its opacity.
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn::testing {
namespace {

class EvenOutlines : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(EvenOutlines);

constexpr int kSide = 400;

const OwnedMesh& smoothSphere()
{
  static const OwnedMesh mesh = sphere(256, 512);
  return mesh;
}

/// A white sphere with a black line.
Stage outlined(const OwnedMesh& mesh, float width)
{
  Stage stage;
  stage.width = stage.height = kSide;
  stage.view.parallel = true;
  stage.instances = {instanceOf(mesh)};
  stage.instances[0].style.reflection = Reflection::kNone;
  stage.instances[0].style.evenOutline = true;
  stage.instances[0].style.outlineWidth = width;
  return stage;
}

/// Of the widths that partly covered pixels tell.
struct Widths {
  double mean, deviation;
  int count;
};
Widths measure(const Picture& picture, double radius)
{
  double sum = 0, squares = 0;
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double share = 1 - at(picture, x, y).r / 255.0;
      const double inside = radius - std::hypot(x + 0.5 - kSide / 2.0, y + 0.5 - kSide / 2.0);
      if (inside < 0.5 || share < 0.02 || share > 0.98) continue;
      // share = width + 1/2 - inside
      const double width = share - 0.5 + inside;
      sum += width;
      squares += width * width;
      ++count;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean), count};
}

TEST_P(EvenOutlines, AreAsWideAsTheySayInParallelProjection)
{
  const double radius = kSide / 2 / 1.2;
  for (const float width : {1.5f, 3.0f, 6.0f}) {
    const Widths widths = measure(draw(outlined(smoothSphere(), width)), radius);
    EXPECT_NEAR(widths.mean, width, 0.02 * width) << width;
    EXPECT_LT(widths.deviation, 0.05) << width;
    EXPECT_GT(widths.count, 700);
  }
}

TEST_P(EvenOutlines, AreAsWideAsTheySayInPerspective)
{
  for (const double distance : {1.6, 3.0, 9.0}) {
    Stage stage = outlined(smoothSphere(), 3);
    const double tangent = 1.2 / std::sqrt(distance * distance - 1);
    stage.view = perspectiveView({0, 0, distance}, {0, 0, 0},
                                 2 * std::atan(tangent) * 180 / 3.14159265358979323846, {0.1, 20});
    const Widths widths = measure(draw(stage), kSide / 2 / 1.2);
    EXPECT_NEAR(widths.mean, 3, 0.05) << distance;
    EXPECT_LT(widths.deviation, 0.06) << distance;
    EXPECT_GT(widths.count, 700);
  }
}

TEST_P(EvenOutlines, AreAsWideAsTheySayOnCoarseMeshes)
{
  // Counted from the sphere's border. The mesh's own is up to 0.7 pixels inside.
  const OwnedMesh mesh = sphere(24, 48);
  const Widths widths = measure(draw(outlined(mesh, 4)), kSide / 2 / 1.2);
  EXPECT_NEAR(widths.mean, 4.5, 0.2);
  EXPECT_LT(widths.deviation, 0.15);
  EXPECT_GT(widths.count, 700);
}

TEST_P(EvenOutlines, TheThresholdsFaultIsThatItsWidthFollowsTheRadius)
{
  // |n.v| < c covers R - R sqrt(1 - c^2): of twice the radius twice the width.
  Stage stage = outlined(smoothSphere(), 3);
  stage.instances[0].style.evenOutline = false;
  stage.instances[0].style.outlineThreshold = 0.3f;
  const auto darkInRow = [&] {
    const Picture picture = draw(stage);
    int dark = 0;
    for (int x = 0; x < kSide; ++x)
      dark += covered(picture, x, kSide / 2) && at(picture, x, kSide / 2).r == 0;
    return dark;
  };
  const double rim = 1 - std::sqrt(1 - 0.09);
  EXPECT_NEAR(darkInRow(), 2 * rim * kSide / 2 / 1.2, 2);
  stage.view.halfHeight = 2.4;
  EXPECT_NEAR(darkInRow(), 2 * rim * kSide / 2 / 2.4, 2);
}

TEST_P(EvenOutlines, FacesThatAreLevelHaveNone)
{
  // Seen at 84 degrees: n.v is 0.1 and does not change.
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage = outlined(mesh, 5);
  stage.view = parallelView({0, -10, 1}, {0, 0, 0}, 1.2, {0.5, 20});
  const Picture picture = draw(stage);
  int seen = 0;
  for (std::size_t i = 0; i < picture.color.size(); ++i)
    if (picture.coverage[i] != 0) {
      EXPECT_EQ(picture.color[i].r, 255);
      ++seen;
    }
  EXPECT_GT(seen, 5000);
}

TEST_P(EvenOutlines, AWidthOfNothingCoversAlmostNothing)
{
  const Picture picture = draw(outlined(smoothSphere(), 0));
  const double radius = kSide / 2 / 1.2;
  int seen = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      if (std::hypot(x + 0.5 - kSide / 2.0, y + 0.5 - kSide / 2.0) > radius - 0.7) continue;
      ASSERT_EQ(at(picture, x, y).r, 255) << x << ", " << y;
      ++seen;
    }
  EXPECT_GT(seen, 80000);
}

TEST_P(EvenOutlines, OpacityMixesLineAndSurface)
{
  Stage stage = outlined(smoothSphere(), 6);
  Style& style = stage.instances[0].style;
  style.outlineColor = {1, 0, 0};
  style.outlineOpacity = 0.25f;
  const int rim = kSide / 2 + static_cast<int>(kSide / 2 / 1.2) - 3;
  Rgba8 color = at(draw(stage), rim, kSide / 2);
  EXPECT_EQ(color.r, 255);
  EXPECT_EQ(color.g, 191);
  style.evenOutline = false;
  style.outlineThreshold = 0.3f;
  color = at(draw(stage), rim, kSide / 2);
  EXPECT_EQ(color.r, 255);
  EXPECT_EQ(color.g, 191);
  style.outlineOpacity = 0;
  EXPECT_EQ(at(draw(stage), rim, kSide / 2).g, 255);
}

}  // namespace
}  // namespace limn::testing
