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
/// Calls visit(middle, along, mean width) for each piece of a line.
template <class Visit>
void forEachPiece(const ContourLines& lines, const Visit& visit)
{
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c)
    for (std::uint32_t i = lines.chains.first[c]; i + 1 < lines.chains.first[c + 1]; ++i) {
      const std::uint32_t p = lines.chains.vertex[i], q = lines.chains.vertex[i + 1];
      const double share = 0.5 * static_cast<double>(lines.share[p] + lines.share[q]);
      visit((lines.points[p] + lines.points[q]) * 0.5, lines.points[q] - lines.points[p],
            share * kHatchSwell);
    }
}
double lengthOf(const ContourLines& lines)
{
  double sum = 0;
  forEachPiece(lines, [&](Vec3d, Vec3d way, double) { sum += std::sqrt(dot(way, way)); });
  return sum;
}
/// Length times width.
double inkOf(const ContourLines& lines)
{
  double sum = 0;
  forEachPiece(lines,
               [&](Vec3d, Vec3d way, double width) { sum += std::sqrt(dot(way, way)) * width; });
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
    const double ink = inkOf(fromAbove(light).lines(ball()));
    EXPECT_GT(ink, before) << light;
    before = ink;
  }
}

TEST(HatchLines, AreAsFarApartOnTheScreenAsAsked)
{
  // 3 x 3 units on 400 x 400 pixels; half of the light leaves the first family alone.
  Lit lit = fromAbove(0.5);
  lit.stage.view.halfHeight = 1.5;
  const double pixels = lit.stage.height / 3.0, area = 4 * kPi * kPi * 0.35 * pixels * pixels;
  const double ink = inkOf(lit.lines(ring())) * pixels;
  // Both sides of the torus have strokes; around it nothing is foreshortened from above.
  EXPECT_NEAR(area / ink / 6, 1, 0.4);
}

/// Strokes that are drawn on the plane, in pixels.
struct FlatStroke {
  double height, width;
};
std::vector<FlatStroke> flatStrokesOf(const Lit& lit)
{
  const ContourLines lines = lit.lines(plane());
  std::vector<FlatStroke> strokes;
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c) {
    const std::uint32_t first = lines.chains.vertex[lines.chains.first[c]];
    const std::uint32_t last = lines.chains.vertex[lines.chains.first[c + 1] - 1];
    EXPECT_EQ(lines.points[last].y, lines.points[first].y);
    EXPECT_EQ(lines.share[last], lines.share[first]);
    strokes.push_back({lines.points[first].y * lit.stage.height / (2 * lit.stage.view.halfHeight),
                       static_cast<double>(lines.share[first]) * kHatchSwell});
  }
  std::sort(strokes.begin(), strokes.end(),
            [](const FlatStroke& a, const FlatStroke& b) { return a.height < b.height; });
  return strokes;
}

TEST(HatchLines, OfAFlatFaceAreEquallyFarApartAndCarryTheInkThatIsAsked)
{
  std::size_t even = 0, alternating = 0;
  for (double light = 0.5; light < 0.95; light += 0.01)
    for (const double halfHeight : {1.0, 0.8, 0.5}) {
      Lit lit = fromAbove(light);
      lit.stage.view.halfHeight = halfHeight;
      const double all = plane().strokes.spacing * 200 / halfHeight;
      const double asked = 6 / (2 * (1 - light));
      // Else all are drawn and cannot carry more.
      if (asked < all / kHatchSwell) continue;
      const std::vector<FlatStroke> strokes = flatStrokesOf(lit);
      ASSERT_GT(strokes.size(), 5u);
      const double apart = strokes[1].height - strokes[0].height;
      EXPECT_NEAR(std::exp2(std::round(std::log2(apart / all))), apart / all, 1e-6);
      for (std::size_t i = 0; i + 2 < strokes.size(); ++i) {
        EXPECT_NEAR(strokes[i + 1].height - strokes[i].height, apart, 1e-4) << light;
        EXPECT_EQ(strokes[i + 2].width, strokes[i].width);
        const double mean = 0.5 * (strokes[i].width + strokes[i + 1].width);
        EXPECT_NEAR(mean / apart, 1 / asked, 1e-5 / asked) << light << ' ' << halfHeight;
      }
      ++(strokes[0].width == strokes[1].width ? even : alternating);
    }
  EXPECT_GT(even, 2 * alternating);
  EXPECT_GT(alternating, 5u);
}

TEST(HatchLines, DoNotJumpAsItGetsDarkerOrNearer)
{
  for (const Hatched* mesh : {&plane(), &ball()}) {
    double before = -1;
    for (double light = 0.94; light > 0.05; light -= 0.03) {
      const double ink = inkOf(fromAbove(light).lines(*mesh));
      if (before > 0) {
        EXPECT_GE(ink, before) << light;
        EXPECT_LT(ink, before * (1 + 0.07 / (1 - light))) << light;
      }
      before = ink;
    }
    before = -1;
    for (double halfHeight = 4; halfHeight > 1; halfHeight *= 0.95) {
      Lit lit = fromAbove(0.5);
      lit.stage.view.halfHeight = halfHeight;
      const double ink = inkOf(lit.lines(*mesh));
      if (before > 0) {
        EXPECT_NEAR(ink / before, 1.053, 0.04) << halfHeight;
      }
      before = ink;
    }
  }
}

/// Ink by tone, in shares of what is asked, of a ball as it is seen.
void expectTones(Lit lit, double steepest)
{
  constexpr int kBins = 12;
  double ink[kBins] = {}, asked[kBins] = {};
  const Axes axes = axesOf(lit.stage.view);
  const double pixels = lit.stage.height / (2 * lit.stage.view.halfHeight);
  const Vec3d light = (axes.right + axes.up) * std::sqrt(0.5);
  const auto darkness = [&](Vec3d n) { return 0.5 - 0.5 * dot(n, light); };
  const auto binOf = [&](Vec3d n) {
    return std::min(kBins - 1, static_cast<int>(darkness(n) * kBins));
  };
  for (double x = -1; x < 1; x += 0.004)
    for (double y = -1; y < 1; y += 0.004) {
      const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
      if (z < steepest) continue;
      const Vec3d n = axes.right * x + axes.up * y + axes.back * z;
      const double d = darkness(n);
      const double density = std::min(1.0, 2 * d) + std::max(0.0, 2 * d - 1);
      asked[binOf(n)] += 0.004 * 0.004 * pixels * density / 6;
    }
  forEachPiece(lit.lines(ball()), [&](Vec3d p, Vec3d way, double width) {
    const Vec3d n = normalized(p);
    if (dot(n, axes.back) < steepest) return;
    const double x = dot(way, axes.right), y = dot(way, axes.up);
    ink[binOf(n)] += std::sqrt(x * x + y * y) * width;
  });
  for (int bin = 0; bin < kBins; ++bin) {
    if (asked[bin] < 0.02 * pixels) continue;
    EXPECT_NEAR(ink[bin] / asked[bin], 1, 0.15) << "tone " << bin << " of " << kBins;
  }
}

TEST(HatchLines, OfABallHaveTheTonesThatAreAsked)
{
  for (const Vec3d eye : {Vec3d{0, 0, 5}, Vec3d{4, -2, 3}, Vec3d{5, 0, 0.5}}) {
    Lit lit = fromAbove(0);
    lit.toneLight = ToneLight::kUpperRight;
    lit.stage.view = parallelView(eye, {0, 0, 0}, 1.1);
    expectTones(lit, 0.5);
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
