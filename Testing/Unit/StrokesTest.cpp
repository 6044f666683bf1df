// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/SceneWindow.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

using testing::at;
using testing::OwnedMesh;
using testing::Picture;
using testing::Polyhedron;
using testing::Stage;

constexpr double kPi = 3.14159265358979323846;

/// Red lines; surfaces have none, so that red is coverage.
LineStyle redLine(float width)
{
  LineStyle style;
  style.color = {1, 0, 0};
  style.width = width;
  style.cap = LineCap::kButt;
  return style;
}

/// Chains of points and what a LineSet borrows of them.
struct Polylines {
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> vertex, first = {0};
  std::vector<std::uint8_t> flags;
  std::vector<float> share = {};

  void add(const std::vector<Vec3d>& chain)
  {
    for (const Vec3d& p : chain) {
      vertex.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(vec3Cast<float>(p));
    }
    first.push_back(static_cast<std::uint32_t>(vertex.size()));
  }
  LineSet lines(const LineStyle& style) const
  {
    return {{points, {}, {}}, vertex, first, flags, {}, style, share};
  }
};

OwnedMesh meshOf(const Polyhedron& solid)
{
  OwnedMesh mesh;
  mesh.positions = solid.positions;
  mesh.triangles = solid.triangles;
  mesh.cells = solid.cells;
  mesh.cellCount = solid.cells.empty() ? 0 : solid.cells.back() + 1u;
  mesh.vertexNormals.resize(mesh.positions.size(), {0, 0, 1});
  testing::finish(mesh);
  return mesh;
}

/// Nothing to see: lines need an instance.
const OwnedMesh& nothing()
{
  static const OwnedMesh mesh = testing::soup({{0, 0, 1e6}, {1, 0, 1e6}, {0, 1, 1e6}});
  return mesh;
}

class Strokes : public testing::BothBackends {
 protected:
  /// With radiance planes.
  Picture drawn(const Stage& stage, Background background = Background::kBlend) const
  {
    Picture picture(stage.width, stage.height);
    picture.addRadiance();
    stage.drawOver(picture, GetParam(), background);
    return picture;
  }
  static double redOf(const Picture& picture)
  {
    double sum = 0;
    for (const float red : picture.radiance[0])
      sum += static_cast<double>(red);
    return sum;
  }
  /// Of lines in the pixels of a stage without surfaces.
  double coverage(const Polylines& lines, const LineStyle& style, int side = 128) const
  {
    Stage stage = testing::pixelStage(side, 1);
    const std::vector<LineSet> sets = {lines.lines(style)};
    stage.instances = {testing::painted(nothing(), {0, 0, 1})};
    stage.instances[0].lines = sets;
    return redOf(drawn(stage));
  }
};

TEST_P(Strokes, CoverIsWidthTimesLength)
{
  for (int n = 0; n < 24; ++n) {
    const double angle = n * kPi / 24 + (n % 3 == 0 ? 0 : 0.01);
    const double length = 90 + n / 10.0;
    const Vec3d middle = {64.2 + n * 0.13, 63.9 - n * 0.07, 0};
    const Vec3d half = {std::cos(angle) * length / 2, std::sin(angle) * length / 2, 0};
    Polylines line;
    line.add({middle - half, middle + half});
    for (const float width : {0.05f, 0.3f, 0.5f, 1.0f, 1.5f, 2.7f, 8.0f})
      EXPECT_NEAR(coverage(line, redLine(width)) / (static_cast<double>(width) * length), 1, 0.005)
          << "angle " << angle << ", width " << width;
  }
}

TEST_P(Strokes, RoundEndsAddADisc)
{
  for (const float width : {3.0f, 6.0f, 11.0f}) {
    Polylines line;
    line.add({{30.3, 40.7, 0}, {95.1, 84.4, 0}});
    LineStyle style = redLine(width);
    const double butt = coverage(line, style);
    style.cap = LineCap::kRound;
    // Round an end the share of a pixel is taken as along a straight edge.
    EXPECT_NEAR(coverage(line, style) - butt, kPi / 4 * static_cast<double>(width * width), 0.5);
  }
}

TEST_P(Strokes, JointsAreNeitherDarkerNorPaler)
{
  const Vec3d a = {20.4, 33.1, 0}, b = {108.7, 91.6, 0};
  Polylines whole, cut;
  whole.add({a, b});
  std::vector<Vec3d> points;
  for (int i = 0; i <= 97; ++i)
    points.push_back(a + (b - a) * (i / 97.0));
  cut.add(points);
  for (const float width : {0.4f, 1.0f, 5.0f}) {
    LineStyle style = redLine(width);
    style.opacity = 0.5f;
    style.cap = LineCap::kRound;  // joints near butt ends reach beyond them
    Stage stage = testing::pixelStage(128, 1);
    stage.instances = {testing::painted(nothing(), {0, 0, 1})};
    Picture pictures[2] = {Picture(1, 1), Picture(1, 1)};
    for (int i = 0; i < 2; ++i) {
      const std::vector<LineSet> sets = {(i == 0 ? whole : cut).lines(style)};
      stage.instances[0].lines = sets;
      pictures[i] = drawn(stage);
    }
    for (std::size_t i = 0; i < pictures[0].color.size(); ++i)
      ASSERT_NEAR(pictures[0].radiance[0][i], pictures[1].radiance[0][i], 2e-3) << width;
  }
}

TEST_P(Strokes, SeveralSetsOfOneStyleAreBlendedOnce)
{
  Polylines line;
  line.add({{20, 64.5, 0}, {108, 64.5, 0}});
  LineStyle style = redLine(1);
  style.opacity = 0.5f;
  Stage stage = testing::pixelStage(128, 1);
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  LineStyle other = style;
  other.width = 1.001f;
  const std::vector<LineSet> same = {line.lines(style), line.lines(style)};
  const std::vector<LineSet> apart = {line.lines(style), line.lines(other)};
  stage.instances[0].lines = same;
  EXPECT_NEAR(drawn(stage).radiance[0][64 * 128 + 60], 0.5, 1e-3);
  stage.instances[0].lines = apart;
  EXPECT_NEAR(drawn(stage).radiance[0][64 * 128 + 60], 0.75, 1e-3);
}

TEST_P(Strokes, TaperTakesHalfOfItsLengthsWidthAway)
{
  Polylines line, loop;
  line.add({{20.3, 20, 0}, {100.3, 90, 0}});
  const double length = std::hypot(80.0, 70.0);
  LineStyle style = redLine(4);
  style.taper = 20;
  EXPECT_NEAR(coverage(line, style), 4 * (length - 20), 2);
  loop.add({{20, 20, 0}, {100, 20, 0}, {60, 90, 0}});
  loop.vertex.push_back(loop.vertex[0]);
  loop.first.back() = 4;
  LineStyle even = redLine(4);
  EXPECT_EQ(coverage(loop, style), coverage(loop, even)) << "loops have no ends";
}

TEST_P(Strokes, ShareOfTheWidthIsLinearBetweenPoints)
{
  Polylines line;
  line.add({{14, 20, 0}, {54, 50, 0}, {94, 80, 0}, {94, 110, 0}});
  line.share = {0, 1, 0.5f, 0.5f};
  // The mean of both ends, times 50, 50 and 30 pixels.
  const double shares = 0.5 * 50 + 0.75 * 50 + 0.5 * 30;
  for (const float width : {0.5f, 1.2f, 3.0f}) {
    EXPECT_NEAR(coverage(line, redLine(width)) / (static_cast<double>(width) * shares), 1, 0.02);
  }
  line.share.assign(4, 1.0f);
  Polylines full = line;
  full.share.clear();
  EXPECT_EQ(coverage(line, redLine(2)), coverage(full, redLine(2)));
}

TEST_P(Strokes, DashesCoverTheirShare)
{
  Polylines line;
  line.add({{14, 30.5, 0}, {34, 40.5, 0}, {114, 80.5, 0}});
  LineStyle style = redLine(3);
  style.dash = 7;
  style.gap = 3;
  const double whole = coverage(line, redLine(3));
  EXPECT_NEAR(coverage(line, style) / whole, 0.7, 0.03);
}

/// A camera of a viewport of `width` x `height` pixels, of which a window is drawn.
Camera windowOf(const Stage& large, double x, double y, int side)
{
  Camera camera = large.camera();
  const double sx = static_cast<double>(large.width) / side,
               sy = static_cast<double>(large.height) / side;
  const double tx = sx - 2 * x / side - 1, ty = sy - 2 * y / side - 1;
  const Mat4d window = {{{sx, 0, 0, tx}, {0, sy, 0, ty}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  camera.viewToClip = window * camera.viewToClip;
  return camera;
}

TEST_P(Strokes, WidthDependsOnNeitherResolutionNorAspectDistanceNorTilt)
{
  constexpr int kSide = 72;
  double sum = 0, squares = 0;
  int count = 0;
  for (const int height : {480, 1080, 2160, 4320})
    for (const double aspect : {4.0 / 3, 16.0 / 9})
      for (const double distance : {2.0, 20.0, 200.0})
        for (const double tilt : {0.0, 60.0, 85.0}) {
          Stage large;
          large.height = height;
          large.width = static_cast<int>(height * aspect);
          large.view = testing::perspectiveView({0.3 * distance, 0, distance}, {0.1, 0.05, 0}, 40,
                                                {distance / 4, distance * 4});
          const double slant = tilt * kPi / 180, spread = distance / 5;
          const Vec3d way = {0.31 * std::cos(slant), std::cos(slant), std::sin(slant)};
          const Vec3d from = way * -spread, to = way * spread;
          Polylines line;
          line.add({from, to});
          const Vec3d middle = large.project({0, 0, 0});
          Stage small = large;
          const std::vector<LineSet> sets = {line.lines(redLine(2.5f))};
          Instance instance = testing::painted(nothing(), {0, 0, 1});
          instance.lines = sets;
          Scene scene = small.scene();
          scene.camera =
              windowOf(large, std::floor(middle.x) - 36, std::floor(middle.y) - 36, kSide);
          scene.instances = {&instance, 1};
          Picture picture(kSide, kSide);
          picture.addRadiance();
          ASSERT_TRUE(render(scene, picture.frame(Background::kBlend), {GetParam(), 2}).ok());
          // On the screen straight lines stay straight.
          const Vec3d a = large.project(from), b = large.project(to);
          const double cosine = (b.y - a.y) / std::hypot(b.x - a.x, b.y - a.y);
          const bool isSteep = std::fabs(cosine) > 0.7;
          const double across = isSteep ? std::fabs(cosine) : std::sqrt(1 - cosine * cosine);
          const int half = tilt > 80 ? 4 : 16;
          for (int i = 36 - half; i < 36 + half; ++i) {
            double width = 0;
            for (int k = 0; k < kSide; ++k)
              width += static_cast<double>(picture.radiance[0][static_cast<std::size_t>(
                  isSteep ? i * kSide + k : k * kSide + i)]);
            sum += width * across;
            squares += width * across * width * across;
            ++count;
          }
        }
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  RecordProperty("mean", std::to_string(mean));
  RecordProperty("deviation", std::to_string(deviation));
  EXPECT_NEAR(mean, 2.5, 0.01);
  EXPECT_LT(deviation, 0.02);
}

/// Each edge of the cube alone, as a share of what it would cover without surfaces.
std::vector<double> shownEdges(const Stage& base, const OwnedMesh& cube, Backend backend,
                               const LineStyle& style, const Mat4d& place = Mat4d::identity())
{
  std::vector<double> shares;
  for (std::uint32_t a = 0; a < 8; ++a)
    for (std::uint32_t b = a + 1; b < 8; ++b) {
      const Vec3d p = vec3Cast<double>(cube.positions[a]), q = vec3Cast<double>(cube.positions[b]);
      const Vec3d apart = q - p;
      if (dot(apart, apart) > 4.5) continue;
      Polylines line;
      line.add({p, q});
      const std::vector<LineSet> sets = {line.lines(style)};
      Stage stage = base;
      stage.instances = {testing::painted(cube, {0, 0, 1})};
      stage.instances[0].modelToWorld = place;
      stage.instances[0].lines = sets;
      Picture picture(stage.width, stage.height);
      picture.addRadiance();
      stage.drawOver(picture, backend);
      double red = 0;
      for (const float value : picture.radiance[0])
        red += static_cast<double>(value);
      const Vec3d s = stage.project(transformPoint(place, p)),
                  t = stage.project(transformPoint(place, q));
      shares.push_back(red / (static_cast<double>(style.width) * std::hypot(t.x - s.x, t.y - s.y)));
    }
  return shares;
}

std::size_t countNear(const std::vector<double>& values, double target, double tolerance)
{
  return static_cast<std::size_t>(std::count_if(
      values.begin(), values.end(), [&](double v) { return std::fabs(v - target) <= tolerance; }));
}

TEST_P(Strokes, ACubeShowsNineOfItsEdgesAndHidesThree)
{
  const OwnedMesh cube = meshOf(testing::cube());
  const Mat4d mirrored = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  for (const int samples : {1, 4})
    for (const bool parallel : {false, true})
      for (const Mat4d& place : {Mat4d::identity(), mirrored}) {
        Stage stage;
        stage.width = stage.height = 160;
        stage.samples = samples;
        stage.view = parallel ? testing::parallelView({3, 2, 4}, {0, 0, 0}, 2.2)
                              : testing::perspectiveView({3, 2, 4}, {0, 0, 0}, 40);
        const auto off = shownEdges(stage, cube, GetParam(), redLine(1.5f), place);
        ASSERT_EQ(off.size(), 12u);
        EXPECT_EQ(countNear(off, 1, 0.03), 9u);
        EXPECT_EQ(countNear(off, 0, 0.08), 3u);
        LineStyle thin = redLine(1.5f);
        thin.hidden = HiddenLines::kThin;
        const auto shown = shownEdges(stage, cube, GetParam(), thin, place);
        EXPECT_EQ(countNear(shown, 1, 0.03), 9u);
        EXPECT_EQ(countNear(shown, kHiddenWidth, 0.08), 3u);
        thin.hidden = HiddenLines::kDashed;
        const auto dashed = shownEdges(stage, cube, GetParam(), thin, place);
        EXPECT_EQ(countNear(dashed, 0.275, 0.1), 3u);
      }
}

TEST_P(Strokes, ACubeSeenFaceOnIsASquare)
{
  const Polyhedron solid = testing::cube();
  const OwnedMesh cube = meshOf(solid);
  EdgeTable table;
  ASSERT_TRUE(buildEdgeTable(solid.view(), 0, 1, table).ok());
  const auto kinds = edgeKinds(solid.view(), table, {}, 30, 1);
  const EdgeChains edges = chainEdges(table, kinds, kCreaseEdge);
  Stage stage;
  stage.width = stage.height = 100;
  stage.view = testing::parallelView({0, 0, 5}, {0, 0, 0}, 2);
  const std::vector<LineSet> sets = {edges.chains.lines(solid.view(), redLine(2))};
  stage.instances = {testing::painted(cube, {0, 0, 1})};
  stage.instances[0].lines = sets;
  const Picture picture = drawn(stage);
  EXPECT_NEAR(redOf(picture), 4 * 2 * 50, 8);
  for (int i = 30; i < 70; ++i) {
    EXPECT_EQ(at(picture, i, 50).r, 0) << "inside";
    EXPECT_EQ(at(picture, i, 24).r, 255) << "its lower side";
  }
}

TEST_P(Strokes, LinesOnASurfaceAreWholeAndLinesBehindItGone)
{
  for (const double tilt : {0.0, 45.0, 80.0, 85.0}) {
    const double slant = tilt * kPi / 180;
    const Vec3d up = {0, std::cos(slant), -std::sin(slant)},
                out = {0, std::sin(slant), std::cos(slant)};
    const OwnedMesh sheet = testing::sheet(Vec3d{-1, 0, 0} - up, {2, 0, 0}, up * 2.0);
    for (const int samples : {1, 4})
      for (const double offset : {0.0, -0.012}) {
        double covered = 0, whole = 0;
        for (int n = 0; n < 5; ++n) {
          const Vec3d a = Vec3d{-0.7, 0, 0} + up * (n * 0.3 - 0.6) + out * offset;
          const Vec3d b = Vec3d{0.65, 0, 0} + up * (0.5 - n * 0.22) + out * offset;
          Polylines line;
          line.add({a, b});
          Stage stage;
          stage.width = stage.height = 200;
          stage.samples = samples;
          const std::vector<LineSet> sets = {line.lines(redLine(1.5f))};
          stage.instances = {testing::painted(sheet, {0, 0, 1})};
          stage.instances[0].lines = sets;
          covered += redOf(drawn(stage));
          const Vec3d p = stage.project(a), q = stage.project(b);
          whole += 1.5 * std::hypot(p.x - q.x, p.y - q.y);
        }
        if (offset == 0) {
          EXPECT_NEAR(covered / whole, 1, 0.01) << tilt << ' ' << samples;
        } else {
          EXPECT_EQ(covered, 0) << tilt << ' ' << samples;
        }
      }
  }
}

TEST_P(Strokes, SinglePixelsNeitherBreakALineNorShowAHiddenOne)
{
  Polylines line;
  line.add({{10, 32.5, -2}, {54, 32.5, -2}});
  const std::vector<LineSet> sets = {line.lines(redLine(1))};
  Stage stage = testing::pixelStage(64, 1);
  // Three pixels high, so that it hides what lies behind its middle.
  const OwnedMesh post = testing::sheet({30, 30, -1}, {2, 0, 0}, {0, 5, 0});
  stage.instances = {testing::painted(post, {0, 0, 1})};
  stage.instances[0].lines = sets;
  EXPECT_NEAR(redOf(drawn(stage)), 44, 0.1);
  const OwnedMesh left = testing::sheet({0, 20, -1}, {30, 0, 0}, {0, 24, 0});
  const OwnedMesh right = testing::sheet({31, 20, -1}, {30, 0, 0}, {0, 24, 0});
  stage.instances = {testing::painted(left, {0, 0, 1}), testing::painted(right, {0, 0, 1})};
  stage.instances[0].lines = sets;
  EXPECT_LE(redOf(drawn(stage)), 3) << "a slit of one pixel shows no more than three";
  const OwnedMesh wide = testing::sheet({31, 20, -1}, {20, 0, 0}, {0, 24, 0});
  stage.instances = {testing::painted(wide, {0, 0, 1})};
  stage.instances[0].lines = sets;
  EXPECT_NEAR(redOf(drawn(stage)), 44 - 20, 3);
}

TEST_P(Strokes, DepthIsWrittenWhereALineCoversHalfOfAnEmptyPixel)
{
  Stage stage = testing::pixelStage(64, 1);
  Polylines line;
  line.add({{10, 32.5, -3}, {54, 32.5, -3}});
  const std::vector<LineSet> sets = {line.lines(redLine(2))};
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  const Picture picture = drawn(stage);
  const auto depth = [&](int y) { return picture.depth[static_cast<std::size_t>(y * 64 + 30)]; };
  EXPECT_NEAR(static_cast<double>(depth(32)), stage.project({30, 32, -3}).z, 1e-6);
  EXPECT_LT(depth(33), 1) << "half covered";
  EXPECT_EQ(depth(34), 1);
  EXPECT_EQ(picture.instance[32 * 64 + 30], kNobody);
}

TEST_P(Strokes, ApartFromTheBackgroundALineIsItsShareOfSamples)
{
  Stage stage = testing::pixelStage(64, 4);
  Polylines line;
  line.add({{10, 32.7, -3}, {54, 32.7, -3}});  // 0.8 and 0.2 of a pixel
  const std::vector<LineSet> sets = {line.lines(redLine(1))};
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  const Picture picture = drawn(stage, Background::kKeepApart);
  const auto pixel = [](int y) { return static_cast<std::size_t>(y * 64 + 30); };
  EXPECT_EQ(testing::bitCount(picture.coverage[pixel(32)]), 3);
  EXPECT_EQ(testing::bitCount(picture.coverage[pixel(33)]), 1);
  EXPECT_EQ(picture.coverage[pixel(34)], 0);
  for (const int y : {32, 33}) {
    EXPECT_EQ(at(picture, 30, y).r, 255) << "the line's own colour";
    EXPECT_EQ(at(picture, 30, y).a, 255);
    EXPECT_LT(picture.depth[pixel(y)], 1);
  }
}

/// A stage's lines apart from the background, as a host lays them over white: whole samples first,
/// then the shares.
std::vector<double> greenOverWhite(const Stage& stage, Backend backend)
{
  Picture picture(stage.width, stage.height);
  std::vector<LinePixel> shares;
  FrameView frame = picture.frame(Background::kKeepApart);
  frame.linePixels = &shares;
  EXPECT_TRUE(render(stage.scene(), frame, {backend, 2}).ok());
  std::vector<double> green;
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    EXPECT_TRUE(picture.coverage[i] == 0 ||
                testing::bitCount(picture.coverage[i]) == stage.samples);
    green.push_back(picture.coverage[i] == 0 ? 255.0 : picture.color[i].g);
  }
  std::vector<int> count(green.size());
  for (const LinePixel& one : shares) {
    const auto i = static_cast<std::size_t>(one.y * stage.width + one.x);
    EXPECT_EQ(testing::bitCount(one.samples), stage.samples);
    EXPECT_EQ(picture.coverage[i], 0);
    EXPECT_EQ(++count[i], 1);
    EXPECT_LT(one.depth, 1);
    green[i] = one.color.g + green[i] * (1 - one.color.a / 255.0);
  }
  return green;
}

// A ramp of colours from line to line, some of them translucent, one over the other.
TEST_P(Strokes, SharesLaidOverTheBackgroundByTheHostAreTheLinesDrawnOverIt)
{
  for (const int samples : {1, 4}) {
    Stage stage = testing::pixelStage(64, samples);
    std::vector<Polylines> lines(4);
    std::vector<LineSet> sets;
    for (int i = 0; i < 4; ++i) {
      lines[static_cast<std::size_t>(i)].add({{10.3, 8.1 + 9 * i, -3}, {54.2, 30.3 + 5 * i, -2}});
      LineStyle style = redLine(1.2f + 0.65f * static_cast<float>(i));
      style.color.y = 0.3f * static_cast<float>(i);
      style.opacity = i == 2 ? 0.6f : 1;
      sets.push_back(lines[static_cast<std::size_t>(i)].lines(style));
    }
    stage.instances = {testing::painted(nothing(), {0, 0, 1})};
    stage.instances[0].lines = sets;
    Picture expected(64, 64);
    std::fill(expected.color.begin(), expected.color.end(), Rgba8{255, 255, 255, 255});
    stage.drawOver(expected, GetParam());
    const std::vector<double> green = greenOverWhite(stage, GetParam());
    double sum = 0, wanted = 0;
    for (std::size_t i = 0; i < green.size(); ++i) {
      // Rounding: the drawing's, that of the share and of its colour; where lines cross, more.
      ASSERT_NEAR(green[i], expected.color[i].g, 2.5) << i << ' ' << samples;
      sum += 255 - green[i];
      wanted += 255 - expected.color[i].g;
    }
    EXPECT_NEAR(sum / wanted, 1, 0.001);
    EXPECT_GT(wanted, 255 * 100);
  }
}

TEST_P(Strokes, SharesAreOfTheSamplesThatShowNothing)
{
  Stage stage = testing::pixelStage(64, 4);
  Polylines line;
  line.add({{10, 32.2, -2}, {54, 32.2, -2}});  // the surface's lower border runs in its middle
  const std::vector<LineSet> sets = {line.lines(redLine(0.4f))};
  const OwnedMesh half = testing::sheet({0, 32.5, -3}, {64, 0, 0}, {0, 20, 0});
  stage.instances = {testing::painted(half, {0, 0, 1})};
  stage.instances[0].lines = sets;
  Picture picture(64, 64);
  std::vector<LinePixel> shares = {{}, {}};
  FrameView frame = picture.frame(Background::kKeepApart);
  frame.linePixels = &shares;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
  ASSERT_EQ(shares.size(), 44u) << "old ones are gone";
  for (const LinePixel& one : shares) {
    const auto i = static_cast<std::size_t>(one.y * 64 + one.x);
    EXPECT_EQ(one.y, 32);
    EXPECT_EQ(one.samples ^ picture.coverage[i], 15);
    EXPECT_EQ(testing::bitCount(one.samples), 2);
    EXPECT_EQ(one.color.a, 102) << "0.4 of the pixel";
    EXPECT_EQ(one.color.r, 102);
    EXPECT_EQ(picture.color[i].r, 102) << "of the others, too";
    EXPECT_EQ(picture.color[i].a, 255);
  }
}

TEST_P(Strokes, SharesAreKeptApartOnlyWithTheBackground)
{
  Stage stage = testing::pixelStage(64, 1);
  Polylines line;
  line.add({{10, 32.2, -2}, {54, 32.2, -2}});
  const std::vector<LineSet> sets = {line.lines(redLine(0.4f))};
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  const Picture expected = stage.draw(GetParam());
  std::vector<LinePixel> shares = {{}};
  for (const bool blends : {true, false}) {
    Picture picture(64, 64);
    FrameView frame = picture.frame(blends ? Background::kBlend : Background::kKeepApart);
    if (!blends) frame.coverage = nullptr;
    frame.linePixels = &shares;
    ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
    EXPECT_TRUE(shares.empty());
    EXPECT_EQ(at(picture, 30, 32).r, at(expected, 30, 32).r);
  }
}

TEST_P(Strokes, OuterSegmentsAreHeavier)
{
  Polylines line;
  line.add({{10, 30.5, 0}, {60, 30.5, 0}, {110, 30.5, 0}});
  line.flags = {kOuterLine, 0, 0};
  LineStyle style = redLine(2);
  style.outerFactor = 3;
  EXPECT_NEAR(coverage(line, style), 50 * 6 + 50 * 2, 12) << "round at the joint";
}

TEST_P(Strokes, OrderAndDirectionOfLinesDoNotCount)
{
  Polylines forward, backward;
  std::vector<std::vector<Vec3d>> chains;
  for (int n = 0; n < 12; ++n)
    chains.push_back({{10.0 + 7 * n, 12, 0}, {110.0 - 5 * n, 60, 0}, {30 + 4.0 * n, 112, 0}});
  for (const auto& chain : chains)
    forward.add(chain);
  for (auto chain = chains.rbegin(); chain != chains.rend(); ++chain)
    backward.add(*chain);
  Stage stage = testing::pixelStage(128, 1);
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  const std::vector<LineSet> a = {forward.lines(redLine(1.7f))},
                             b = {backward.lines(redLine(1.7f))};
  stage.instances[0].lines = a;
  const Picture first = drawn(stage);
  stage.instances[0].lines = b;
  EXPECT_EQ(drawn(stage).differingPixels(first), 0u);
}

// Of a disc's border that touches the picture's border from inside or outside, half or less shows.
TEST_P(Strokes, BordersAreDrawnNextToThePicturesBorderAndBeyond)
{
  for (const double scale : {1.02, 1.0, 0.98}) {
    Stage stage;
    stage.view = testing::parallelView({0, 0, 3}, {0, 0, 0}, scale);
    stage.width = stage.height = 200;
    const OwnedMesh ball = testing::sphere(64, 128);
    Polylines ring;
    std::vector<Vec3d> chain;
    for (int i = 0; i <= 128; ++i)
      chain.push_back({std::cos(i * kPi / 64), std::sin(i * kPi / 64), 0});
    ring.add(chain);
    const std::vector<LineSet> sets = {ring.lines(redLine(12))};
    stage.instances = {testing::painted(ball, {0, 0, 1})};
    stage.instances[0].lines = sets;
    const Picture picture = drawn(stage);
    for (int k = 60; k < 140; ++k)
      for (const auto& [x, y] :
           {std::pair(k, 0), std::pair(k, 199), std::pair(0, k), std::pair(199, k)}) {
        const double off = std::hypot(x + 0.5 - 100, y + 0.5 - 100) - 100 / scale;
        if (std::fabs(off) > 5) continue;
        EXPECT_EQ(picture.radiance[0][static_cast<std::size_t>(y * 200 + x)], 1)
            << scale << ' ' << x << ' ' << y;
      }
  }
}

// Lines whose middle is outside, of which almost half shows: before the lower half of one lies
// something that nobody sees; something that is seen lies beside the lower half of the other.
TEST_P(Strokes, BesideTheFrameAreHiddenByWhatLiesThere)
{
  constexpr int kSide = 64;
  const OwnedMesh outside = testing::sheet({-10, -20, -2}, {9, 0, 0}, {0, 52, 0}),
                  inside = testing::sheet({64, -20, -2}, {-20, 0, 0}, {0, 52, 0});
  Polylines line;
  line.add({{-3.5, -20, -3}, {-3.5, 90, -3}});
  line.add({{67.5, -20, -3}, {67.5, 90, -3}});
  for (const int samples : {1, 4})
    for (const HiddenLines hidden : {HiddenLines::kOff, HiddenLines::kThin}) {
      LineStyle style = redLine(16);
      style.hidden = hidden;
      const std::vector<LineSet> sets = {line.lines(style)};
      Stage stage = testing::pixelStage(kSide, samples);
      stage.instances = {testing::painted(outside, {0, 0, 1}), testing::painted(inside, {0, 0, 1})};
      stage.instances[0].lines = sets;
      const Picture picture = drawn(stage);
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < 4; ++x) {
          const auto red = [&](int column) {
            return picture.radiance[0][static_cast<std::size_t>(y * kSide + column)];
          };
          EXPECT_NEAR(red(kSide - 1 - x), 1, 1e-4) << x << ' ' << y << ' ' << samples;
          if (y >= 30 && y < 34) continue;
          // Thin ones reach half a pixel into the frame.
          const float ofHidden = hidden == HiddenLines::kThin && x == 0 ? 0.5f : 0.0f;
          EXPECT_NEAR(red(x), y > 32 ? 1.0f : ofHidden, 1e-4) << x << ' ' << y << ' ' << samples;
        }
    }
}

// A bar across a side of the frame hides two points of a line, which those at its two sides
// outvote: the farther one is the last that counts for a pixel.
TEST_P(Strokes, AreSeenInTheFirstPixelByWhatIsSeenOutside)
{
  constexpr int kSide = 64;
  for (int side = 0; side < 4; ++side) {
    // From the side inwards, and along it.
    const auto at = [&](double in, double along, double z) {
      const double u = side % 2 == 0 ? in : kSide - in;
      return side < 2 ? Vec3d{u, along, z} : Vec3d{along, u, z};
    };
    const Vec3d corner = at(-3, 0, -2);
    const OwnedMesh bar = testing::sheet(corner, at(1, 0, -2) - corner, at(-3, kSide, -2) - corner);
    Polylines line;  // with points at -2.4, -1.4, -0.4 and so on, of which two are behind the bar
    line.add({at(-20.9, 20.5, -3), at(30.1, 20.5, -3)});
    const std::vector<LineSet> sets = {line.lines(redLine(0.5f))};
    Stage stage = testing::pixelStage(kSide, 1);
    stage.instances = {testing::painted(bar, {0, 0, 1})};
    stage.instances[0].lines = sets;
    const Vec3d pixel = at(0.5, 20.5, 0);
    const auto index = static_cast<std::size_t>(std::floor(pixel.y) * kSide + std::floor(pixel.x));
    EXPECT_NEAR(drawn(stage).radiance[0][index], 0.5, 1e-3) << side;
  }
}

// What a host has drawn goes on around the frame.
TEST_P(Strokes, BesideTheFrameAreHiddenByWhatItHeldAtItsBorder)
{
  constexpr int kSide = 64;
  Polylines line;
  line.add({{-2, -20, -3}, {-2, 90, -3}});
  const std::vector<LineSet> sets = {line.lines(redLine(12))};
  Stage stage = testing::pixelStage(kSide, 1);
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  for (const bool isKept : {true, false}) {
    Picture picture(kSide, kSide);
    for (int y = 0; y < 32; ++y)
      picture.depth[static_cast<std::size_t>(y * kSide)] = 0.1f;
    FrameView frame = picture.frame(Background::kBlend);
    if (!isKept) frame.clear.extent = FrameClear::Extent::kAll;
    ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
    for (int y = 0; y < kSide; ++y)
      if (y < 30 || y >= 34) {
        EXPECT_EQ(at(picture, 1, y).r, isKept && y < 32 ? 0 : 255) << y;
      }
  }
}

// Surfaces are drawn no farther from the frame than kWidestStrokeApron; beyond, the last of them
// count.
TEST_P(Strokes, WiderThanTheApronAreHiddenByWhatLiesInIt)
{
  constexpr int kSide = 64;
  const OwnedMesh far = testing::sheet({-260, -200, -2}, {20, 0, 0}, {0, 500, 0}),
                  near = testing::sheet({-140, -200, -2}, {20, 0, 0}, {0, 500, 0});
  Polylines line;
  line.add({{-250, -200, -3}, {-250, 300, -3}});
  line.flags = {kOuterLine, 0};
  LineStyle style = redLine(256);
  style.outerFactor = 2.3f;  // as far as x = 44.4
  const std::vector<LineSet> sets = {line.lines(style)};
  Stage stage = testing::pixelStage(kSide, 1);
  for (const OwnedMesh* mesh : {&far, &near}) {
    stage.instances = {testing::painted(*mesh, {0, 0, 1})};
    stage.instances[0].lines = sets;
    const Picture picture = drawn(stage);
    for (int y = 0; y < kSide; ++y) {
      EXPECT_EQ(at(picture, 42, y).r, mesh == &far ? 255 : 0) << y;
      EXPECT_EQ(at(picture, 46, y).r, 0) << y;
    }
  }
}

// A line on a slope whose depths are carried to it from the apron's end.
TEST_P(Strokes, WiderThanTheApronAreSeenOnTheSlopeTheyLieOn)
{
  constexpr int kSide = 64;
  const auto onSlope = [](double x, double y) { return Vec3d{x, y, -2 + 0.002 * x}; };
  const Vec3d corner = onSlope(-450, -200);
  const OwnedMesh slope = testing::sheet(corner, onSlope(200, -200) - corner, {0, 500, 0});
  Polylines line;
  line.add({onSlope(-300, -200), onSlope(-300, 300)});
  line.flags = {kOuterLine, 0};
  LineStyle style = redLine(256);
  style.outerFactor = 2.7f;  // as far as x = 45.6
  const std::vector<LineSet> sets = {line.lines(style)};
  Stage stage = testing::pixelStage(kSide, 1);
  stage.instances = {testing::painted(slope, {0, 0, 1})};
  stage.instances[0].lines = sets;
  const Picture picture = drawn(stage);
  for (int y = 0; y < kSide; ++y) {
    EXPECT_EQ(at(picture, 20, y).r, 255) << y;
    EXPECT_EQ(at(picture, 48, y).r, 0) << y;
  }
}

testing::SceneWindow::Count compareLined(std::uint32_t seed, Backend backend)
{
  testing::Random number(seed);
  const testing::SceneWindow window(seed, number);
  std::vector<Instance> bare = window.instances();
  for (Instance& instance : bare)
    instance.lines = {};
  return window.compare(window.instances(), bare, backend);
}

TEST_P(Strokes, AreThoseOfALargerPictureInItsWindows)
{
  const std::uint32_t scenes = GetParam() == Backend::kPipeline ? 200 : 20;
  std::size_t unlike = 0, lined = 0;
  for (std::uint32_t seed = 0; seed < scenes; ++seed) {
    const testing::SceneWindow::Count count = compareLined(seed, GetParam());
    unlike += count.unlike;
    lined += count.changed;
  }
  EXPECT_GT(lined, 300u * scenes);
  EXPECT_LE(unlike, 4u) << "where rounding decides";
}

TEST_P(Strokes, LinesBeforeTheEyeAndOutsideThePictureAreCutOff)
{
  Stage stage;
  stage.width = stage.height = 100;
  Polylines line;
  line.add({{0, -0.3, 20}, {0, 0, -3}});
  line.add({{-1e5, 0.1, 0}, {1e5, 0.1, 0}});
  line.add({{std::nan(""), 0, 0}, {0, 0, 0}});
  line.add({{-1e38, 0.2, 0}, {1e38, 0.2, 0}});
  line.add({{0, -1e20, 0}, {0.1, 3e20, 0}});
  const std::vector<LineSet> sets = {line.lines(redLine(1))};
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  const double covered = redOf(drawn(stage));
  EXPECT_GT(covered, 110);
  EXPECT_LT(covered, 150.5);
}

TEST_P(Strokes, TouchedHoldsAllPixelsOfLines)
{
  Stage stage = testing::pixelStage(256, 1);
  Polylines line;
  line.add({{70, 80, 0}, {180, 150, 0}});
  const std::vector<LineSet> sets = {line.lines(redLine(6))};
  stage.instances = {testing::painted(nothing(), {0, 0, 1})};
  stage.instances[0].lines = sets;
  Picture picture(256, 256);
  for (Rgba8& color : picture.color)
    color = {9, 9, 9, 9};
  FrameView frame = picture.frame(Background::kKeepApart);
  frame.clear.extent = FrameClear::Extent::kTouched;
  RenderStats stats;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 2}, &stats).ok());
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      const bool isInside = x >= stats.touched.x0 && x < stats.touched.x1 &&
                            y >= stats.touched.y0 && y < stats.touched.y1;
      const Rgba8 color = at(picture, x, y);
      ASSERT_TRUE(isInside ? color.g != 9 : !testing::covered(picture, x, y)) << x << ' ' << y;
    }
  EXPECT_EQ(at(picture, 125, 115).r, 255);
}

LIMN_ON_BOTH_BACKENDS(Strokes);

}  // namespace
}  // namespace limn
