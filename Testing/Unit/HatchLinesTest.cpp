// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of strokes on a surface those that are drawn in a light and a view.
#include "Testing/Unit/HatchedMesh.h"

namespace limn::testing {
namespace {

/// The plane from above, under light of one strength.
struct Lit {
  Stage stage;
  double light;
  float darkest = 1;
  ToneLight toneLight = ToneLight::kFirst;

  ContourLines lines(const Hatched& hatched) const
  {
    const Camera camera = stage.camera();
    const auto grey = static_cast<float>(light);
    return hatchLines(
        hatched.strokes, Mat4d::identity(),
        {camera, {grey, grey, grey}, stage.lights, true, toneLight, stage.height, 6, darkest}, 2);
  }
};
double lengthOf(const ContourLines& lines)
{
  double sum = 0;
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c)
    for (std::uint32_t i = lines.chains.first[c]; i + 1 < lines.chains.first[c + 1]; ++i) {
      const Vec3d way =
          lines.points[lines.chains.vertex[i + 1]] - lines.points[lines.chains.vertex[i]];
      sum += std::sqrt(dot(way, way));
    }
  return sum;
}
Lit fromAbove(double light)
{
  Lit lit;
  lit.light = light;
  lit.stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1);
  lit.stage.width = lit.stage.height = 400;
  return lit;
}

TEST(HatchLines, AreNoneInFullLightAndMoreTheDarkerItIs)
{
  EXPECT_EQ(lengthOf(fromAbove(1).lines(ball())), 0);
  double before = 0;
  for (const double light : {0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.2, 0.0}) {
    const double length = lengthOf(fromAbove(light).lines(ball()));
    EXPECT_GT(length, before) << light;
    before = length;
  }
}

TEST(HatchLines, AreAsFarApartOnTheScreenAsAsked)
{
  // 3 x 3 units on 400 x 400 pixels; half of the light leaves the first family alone. To half a
  // round of strokes, a square root of 2.
  Lit lit = fromAbove(0.5);
  lit.stage.view.halfHeight = 1.5;
  const double pixels = lit.stage.height / 3.0, area = 4 * kPi * kPi * 0.35 * pixels * pixels;
  const double length = lengthOf(lit.lines(ring())) * pixels;
  // Both sides of the torus have strokes; around it nothing is foreshortened from above.
  EXPECT_NEAR(area / length / 6, 1, 0.4);
}

/// Heights of the strokes that are drawn on the plane, in pixels.
std::vector<double> heightsOf(const Lit& lit)
{
  const ContourLines lines = lit.lines(plane());
  std::vector<double> heights;
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c) {
    const Vec3d p = lines.points[lines.chains.vertex[lines.chains.first[c]]];
    EXPECT_EQ(lines.points[lines.chains.vertex[lines.chains.first[c + 1] - 1]].y, p.y);
    heights.push_back(p.y * lit.stage.height / (2 * lit.stage.view.halfHeight));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

TEST(HatchLines, OfAFlatFaceAreEquallyFarApart)
{
  // By the power of two times the spacing of all that is nearest to what is asked, by its ratio.
  for (const double light : {0.5, 0.6, 0.65, 0.7, 0.8, 0.9})
    for (const double halfHeight : {1.0, 0.8, 0.5}) {
      Lit lit = fromAbove(light);
      lit.stage.view.halfHeight = halfHeight;
      const double all = plane().strokes.spacing * 200 / halfHeight;
      const double asked = 6 / (2 * (1 - light));
      double expected = all;
      while (expected * std::sqrt(2.0) < asked)
        expected *= 2;
      const std::vector<double> heights = heightsOf(lit);
      ASSERT_GT(heights.size(), 5u);
      for (std::size_t i = 0; i + 1 < heights.size(); ++i)
        EXPECT_NEAR(heights[i + 1] - heights[i], expected, 1e-4) << light << ' ' << halfHeight;
    }
}

TEST(HatchLines, OfAFlatFaceInPerspectiveGoFromBorderToBorder)
{
  for (const double light : {0.5, 0.55, 0.6, 0.65, 0.7, 0.75}) {
    Lit lit = fromAbove(light);
    lit.stage.view = perspectiveView({2, -2, 2.5}, {0, 0, 0}, 40);
    const ContourLines lines = lit.lines(plane());
    ASSERT_GT(lines.chains.first.size(), 10u);
    for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c) {
      const Vec3d a = lines.points[lines.chains.vertex[lines.chains.first[c]]];
      const Vec3d b = lines.points[lines.chains.vertex[lines.chains.first[c + 1] - 1]];
      EXPECT_NEAR(std::fabs(b.x - a.x), 2, 1e-9) << light;
    }
  }
}

TEST(HatchLines, EndWhereItGetsLighter)
{
  Lit lit = fromAbove(0);
  Light lamp;
  lamp.kind = LightKind::kPoint;
  lamp.position = {1, 0, 1};
  lamp.attenuation = {1, 0, 0};
  lit.stage.lights = {lamp};
  const ContourLines lines = lit.lines(plane());
  std::size_t left = 0, right = 0;
  for (const Vec3d& p : lines.points)
    (p.x < 0 ? left : right) += 1;
  EXPECT_GT(left, 2 * right);
  EXPECT_GT(right, 0u);
}

TEST(HatchLines, OfRingsThatAreDrawnInPartAreNotCutWhereTheRingBegins)
{
  Lit lit = fromAbove(0.1);
  lit.toneLight = ToneLight::kUpperRight;
  const ContourLines lines = lit.lines(ball());
  std::size_t ends = 0, rings = 0;
  std::vector<Vec3d> begins;
  const auto end = [&](std::size_t c, std::uint32_t back) {
    return lines.points[lines.chains.vertex[lines.chains.first[c + back] - back]];
  };
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c) {
    if (end(c, 0) == end(c, 1))
      ++rings;
    else
      begins.push_back(end(c, 0));
  }
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c)
    if (!(end(c, 0) == end(c, 1)))
      ends += std::find(begins.begin(), begins.end(), end(c, 1)) != begins.end();
  EXPECT_EQ(ends, 0u);
  EXPECT_GT(rings, 3u);
  EXPECT_GT(begins.size(), 30u);
}

TEST(HatchLines, TakeTheCamerasLightWhereAsked)
{
  Lit lit = fromAbove(0);
  lit.toneLight = ToneLight::kUpperRight;
  const ContourLines lines = lit.lines(ball());
  double bright = 0, dark = 0;
  for (const Vec3d& p : lines.points)
    if (p.z > 0.3) (p.x + p.y > 0 ? bright : dark) += 1;
  EXPECT_GT(dark, 1.5 * bright);
  EXPECT_GT(bright, 0);
}

TEST(HatchLines, StayWhereTheyAreWhenTheCameraMoves)
{
  Lit lit = fromAbove(0.5);
  const ContourLines before = lit.lines(ball());
  lit.stage.view.eye = {0.3, 0.2, 5};
  const ContourLines after = lit.lines(ball());
  std::size_t shared = 0;
  std::vector<Vec3d> old = before.points;
  const auto less = [](const Vec3d& a, const Vec3d& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(old.begin(), old.end(), less);
  for (const Vec3d& p : after.points)
    shared += std::binary_search(old.begin(), old.end(), p, less);
  EXPECT_GT(static_cast<double>(shared), 0.8 * static_cast<double>(after.points.size()));
}

TEST(HatchLines, AreTheSameOnAnyNumberOfThreadsAndFromBothRenderers)
{
  const HatchSurface surface = ring().surface();
  const HatchField alone = hatchField(surface, 1), many = hatchField(surface, 8);
  EXPECT_TRUE(std::equal(alone.axis.begin(), alone.axis.end(), many.axis.begin()));
  const HatchStrokes strokes = traceHatching(surface, alone, 1);
  EXPECT_EQ(strokes.vertex, ring().strokes.vertex);
  EXPECT_EQ(strokes.first, ring().strokes.first);
  EXPECT_TRUE(
      std::equal(strokes.points.begin(), strokes.points.end(), ring().strokes.points.begin()));
  const Lit lit = fromAbove(0.2);
  const ContourLines lines = lit.lines(ring());
  const LineSet set = lines.lines({});
  const OwnedMesh square = sheet({-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
  Stage stage = lit.stage;
  stage.view.halfHeight = 1.6;
  Instance instance = painted(square, {1, 1, 1});
  instance.lines = {&set, 1};
  stage.instances = {instance};
  const Picture picture = stage.draw(Backend::kPipeline);
  EXPECT_EQ(stage.draw(Backend::kReference).differingPixels(picture), 0u);
  std::size_t ink = 0;
  for (const Rgba8 color : picture.color)
    ink += color.a != 0 && color.g < 128;
  EXPECT_GT(ink, 3000u);
}

}  // namespace
}  // namespace limn::testing
