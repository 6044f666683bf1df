// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Binning/BinClusters.h"
#include "Rendering/Lines/Panes.h"
#include "Rendering/Shading/TranslucentFragments.h"
#include "Testing/Unit/TestScene.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace limn {
namespace {

using testing::at;
using testing::OwnedMesh;
using testing::Picture;
using testing::Stage;

constexpr int kSide = 32;
constexpr Vec3f kWhite = {1, 1, 1}, kBlack = {0, 0, 0}, kRed = {1, 0, 0};

/// A plate that fills pixels [x0, x1) of all rows.
OwnedMesh plate(double x0, double x1, double z)
{
  return testing::sheet({x0, 0, z}, {x1 - x0, 0, 0}, {0, kSide, 0});
}

Instance pane(const OwnedMesh& mesh, float opacity)
{
  Instance instance = testing::painted(mesh, kRed);
  instance.material.opacity = opacity;
  return instance;
}

/// A line through all columns that fills the rows 14 to 17.
struct Line {
  std::vector<Vec3f> points;
  std::vector<std::uint32_t> vertex = {0, 1}, first = {0, 2};
  std::vector<LineSet> sets;

  Line(float z, Vec3f color, float opacity = 1)
      : points({{-1, kSide / 2.0f, z}, {kSide + 1, kSide / 2.0f, z}})
  {
    LineStyle style;
    style.color = color;
    style.width = 4;
    style.opacity = opacity;
    style.cap = LineCap::kButt;
    sets.push_back({{points, {}, {}}, vertex, first, {}, {}, style, {}});
  }
};
constexpr int kInLine = 15, kBesideLine = 5;

void expectColor(const Picture& picture, int x, int y, double r, double g, double b)
{
  const Rgba8 color = at(picture, x, y);
  EXPECT_NEAR(color.r, r * 255, 0.51) << "at " << x << ", " << y;
  EXPECT_NEAR(color.g, g * 255, 0.51) << "at " << x << ", " << y;
  EXPECT_NEAR(color.b, b * 255, 0.51) << "at " << x << ", " << y;
}

class Veils : public testing::BothBackends {
 protected:
  OwnedMesh ground_ = plate(0, kSide, -0.5), right_ = plate(kSide / 2.0, kSide, 0),
            nearer_ = plate(3.0 * kSide / 4, kSide, 0.3), behind_ = plate(0, kSide, -0.9);
};

TEST_P(Veils, LieOverTheLinesOfWhatTheyCover)
{
  const Line line(-0.5f, kBlack);
  for (const int samples : {1, 4}) {
    Stage stage = testing::pixelStage(kSide, samples);
    stage.instances = {testing::painted(ground_, kWhite), pane(right_, 0.25f), pane(nearer_, 0.5f)};
    stage.instances[0].lines = line.sets;
    const Picture picture = draw(stage);
    expectColor(picture, 5, kInLine, 0, 0, 0);
    expectColor(picture, 20, kInLine, 0.25, 0, 0);
    expectColor(picture, 28, kInLine, 0.25 * 0.5 + 0.5, 0, 0);
    expectColor(picture, 5, kBesideLine, 1, 1, 1);
    expectColor(picture, 20, kBesideLine, 1, 0.75, 0.75);
    expectColor(picture, 28, kBesideLine, 1, 0.375, 0.375);
  }
}

TEST_P(Veils, KeepTheirOwnLines)
{
  const Line below(-0.5f, kBlack), above(0.2f, {0, 0, 1}, 0.5f);
  Stage stage = testing::pixelStage(kSide, 1);
  // The pane comes first: its lines are the last all the same.
  stage.instances = {pane(right_, 0.5f), testing::painted(ground_, kWhite)};
  stage.instances[0].lines = above.sets;
  stage.instances[1].lines = below.sets;
  const Picture picture = draw(stage);
  expectColor(picture, 5, kInLine, 0, 0, 0.5);
  expectColor(picture, 20, kInLine, 0.25, 0, 0.5);
}

TEST_P(Veils, BehindTheSurfaceChangeNoLine)
{
  const Line line(-0.5f, kBlack, 0.7f);
  Stage stage = testing::pixelStage(kSide, 4);
  stage.instances = {testing::painted(ground_, kWhite)};
  stage.instances[0].lines = line.sets;
  const Picture alone = draw(stage);
  stage.instances.push_back(pane(behind_, 0.5f));
  EXPECT_EQ(draw(stage).differingPixels(alone), 0u);
}

TEST_P(Veils, LieBehindLinesBeforeThem)
{
  // The outer half of a border's line reaches over a pane behind the plate.
  const OwnedMesh half = plate(0, kSide / 2.0, -0.2);
  Line line(-0.2f, kBlack);
  line.points = {{kSide / 2.0f, -1, -0.2f}, {kSide / 2.0f, kSide + 1, -0.2f}};
  for (const int samples : {1, 4}) {
    Stage stage = testing::pixelStage(kSide, samples);
    stage.instances = {testing::painted(half, kWhite), pane(behind_, 0.75f)};
    stage.instances[0].lines = line.sets;
    Picture picture = draw(stage);
    expectColor(picture, 15, kInLine, 0, 0, 0);
    expectColor(picture, 16, kInLine, 0, 0, 0);
    expectColor(picture, 20, kInLine, 0.75, 0, 0);
    // And another one before both, so that the line is below that.
    const OwnedMesh before = plate(0, kSide, 0.3);
    stage.instances.push_back(pane(before, 0.5f));
    picture = draw(stage);
    expectColor(picture, 15, kInLine, 0.5, 0, 0);
    expectColor(picture, 16, kInLine, 0.5, 0, 0);
    expectColor(picture, 20, kInLine, 0.5 + 0.5 * 0.75, 0, 0);
  }
}

TEST_P(Veils, LieOverALineOnlyWhereTheyAreBeforeIt)
{
  Line line(0, kBlack);
  line.points = {{0, kSide / 2.0f, -0.4f}, {kSide + 1, kSide / 2.0f, 0.45f}};
  const OwnedMesh low = plate(0, kSide, -0.2), high = plate(0, kSide, 0.2);
  for (const int samples : {1, 8}) {
    Stage stage = testing::pixelStage(kSide, samples);
    stage.instances = {testing::painted(ground_, kWhite), pane(low, 0.5f), pane(high, 0.75f)};
    stage.instances[0].lines = line.sets;
    const Picture picture = draw(stage);
    expectColor(picture, 3, kInLine, 0.5 * 0.25 + 0.75, 0, 0);
    expectColor(picture, 12, kInLine, 0.75, 0, 0);
    expectColor(picture, 28, kInLine, 0, 0, 0);
  }
}

TEST_P(Veils, CoverALineByTheShareOfTheSamplesThatTheyHave)
{
  const Line line(-0.5f, kBlack);
  const OwnedMesh half = plate(16.5, kSide, 0);
  Stage stage = testing::pixelStage(kSide, 4);
  stage.instances = {testing::painted(ground_, kWhite), pane(half, 0.5f)};
  stage.instances[0].lines = line.sets;
  const Picture picture = draw(stage);
  expectColor(picture, 15, kInLine, 0, 0, 0);
  expectColor(picture, 16, kInLine, 0.25, 0, 0);
  expectColor(picture, 17, kInLine, 0.5, 0, 0);
}

TEST_P(Veils, LieOverTheLinesOfOtherTranslucentSurfaces)
{
  const Line line(-0.9f, {0, 0, 1});
  const auto inOrder = [&](bool isLinedFirst) {
    Stage stage = testing::pixelStage(kSide, 1);
    stage.instances = {pane(behind_, 0.5f), pane(nearer_, 0.5f)};
    stage.instances[0].lines = line.sets;
    if (!isLinedFirst) std::swap(stage.instances[0], stage.instances[1]);
    return draw(stage);
  };
  for (const bool isLinedFirst : {true, false}) {
    const Picture picture = inOrder(isLinedFirst);
    expectColor(picture, 5, kInLine, 0, 0, 1);
    expectColor(picture, 28, kInLine, 0.5, 0, 0.5);
  }
}

TEST_P(Veils, AreNotLaidOverTheirOwnLines)
{
  // Of a closed surface those on its far side are seen as those on the near one.
  const double side = 2.0 * kSide;
  const OwnedMesh both = testing::soup({{0, 0, -0.9},
                                        {side, 0, -0.9},
                                        {0, side, -0.9},
                                        {0, 0, 0.3},
                                        {side, 0, 0.3},
                                        {0, side, 0.3}});
  const Line line(-0.9f, {0, 0, 1});
  Stage stage = testing::pixelStage(kSide, 1);
  stage.instances = {pane(both, 0.5f), pane(right_, 0.0f)};
  stage.instances[0].lines = line.sets;
  expectColor(draw(stage), 5, kInLine, 0, 0, 1);
}

TEST_P(Veils, LeaveWhatNoLineChanges)
{
  const Line line(-0.5f, {0.3f, 0.9f, 0.1f});
  Stage stage = testing::pixelStage(kSide, 4);
  stage.ambientLight = {0.37f, 0.41f, 0.59f};
  stage.instances = {testing::painted(ground_, {0.3f, 0.7f, 0.9f}), pane(right_, 0.37f)};
  const Picture bare = draw(stage);
  stage.instances[0].lines = line.sets;
  const Picture lined = draw(stage);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Rgba8 a = at(bare, x, y), b = at(lined, x, y);
      EXPECT_EQ(a.r == b.r && a.g == b.g && a.b == b.b, y < 14 || y > 17) << x << ", " << y;
    }
}

TEST_P(Veils, LieOverOutlinesFromThePicture)
{
  const OwnedMesh small = plate(8, 24, -0.5);
  Stage stage = testing::pixelStage(kSide, 1);
  stage.instances = {testing::painted(small, kWhite), pane(right_, 0.25f)};
  Style& style = stage.instances[0].style;
  style.imageOutline.detector = OutlineDetector::kPlane;
  style.outlineWidth = 4;
  style.outlineColor = kBlack;
  const Picture picture = draw(stage);
  expectColor(picture, 8, kInLine, 0, 0, 0);
  expectColor(picture, 23, kInLine, 0.25, 0, 0);
  expectColor(picture, 18, kInLine, 1, 0.75, 0.75);
}

TEST_P(Veils, LieOverRadianceLikewise)
{
  const Line line(-0.5f, {0, 1, 0}, 0.5f);
  Stage stage = testing::pixelStage(kSide, 4);
  stage.instances = {testing::painted(ground_, kWhite), pane(right_, 0.25f)};
  stage.instances[0].lines = line.sets;
  Picture picture(kSide, kSide);
  picture.addRadiance();
  stage.drawOver(picture, GetParam());
  const std::size_t inLine = kInLine * kSide + 20, beside = kBesideLine * kSide + 20;
  EXPECT_NEAR(picture.radiance[0][inLine], 0.25 + 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(picture.radiance[1][inLine], 0.75, 1e-6);
  EXPECT_NEAR(picture.radiance[2][inLine], 0.75 * 0.5, 1e-6);
  EXPECT_NEAR(picture.radiance[1][beside], 0.75, 1e-6);
}

LIMN_ON_BOTH_BACKENDS(Veils);

TEST(Veil, LooksAtNoMoreThanTheLayersOfAPixel)
{
  // A hundred specks on one sample of the last pixel, and on the others fewer, at the memory's end:
  // a sanitizer sees more.
  const Line line(-0.9f, kBlack);
  constexpr double kPixels = 64, kX = 63 + 144 / 256.0, kY = 63 + 80 / 256.0, kHalf = 1 / 32.0;
  const OwnedMesh base = testing::sheet({-1, -1, -0.5}, {kPixels + 2, 0, 0}, {0, kPixels + 2, 0});
  std::vector<Vec3d> points;
  for (int i = 0; i < 100; ++i) {
    const double z = -0.4 + i * 0.005;
    points.insert(points.end(),
                  {{kX - kHalf, kY - kHalf, z}, {kX + kHalf, kY - kHalf, z}, {kX, kY + kHalf, z}});
  }
  const OwnedMesh specks = testing::soup(points);
  Stage stage = testing::pixelStage(static_cast<int>(kPixels), 8);
  stage.instances = {pane(base, 0.5f), pane(specks, 0.5f)};
  stage.instances[0].lines = line.sets;
  const Rgba8 color = at(stage.draw(Backend::kPipeline), 63, 63);
  EXPECT_GT(color.r, 127);
}

Panes panesOf(const Stage& stage)
{
  const Scene scene = stage.scene();
  const PlacedScene placed = placeScene(scene, {stage.width, stage.height});
  TileBins bins;
  EXPECT_TRUE(binClusters(placed, 2, bins).ok());
  return Panes(placed, bins, 2);
}

TEST(Panes, AreKeptOnlyWhereAHaloMayBe)
{
  Stage stage = testing::pixelStage(200, 1);
  const OwnedMesh all = testing::sheet({0, 0, -1}, {200, 0, 0}, {0, 200, 0});
  const OwnedMesh post = testing::sheet({10, 70, 0}, {50, 0, 0}, {0, 20, 0});
  stage.instances = {pane(all, 0.5f), pane(post, 1)};
  Halo& halo = stage.instances[1].style.cues.halo;
  for (const float width : {0.0f, 1.0f, 8.0f}) {
    halo.width = width;
    const Panes panes = panesOf(stage);
    for (std::size_t tile = 0; tile < 16; ++tile)
      EXPECT_EQ(panes.tile(tile).isReached(),
                width > 0 && (tile == 4 || (width == 8 && (tile == 0 || tile == 1 || tile == 5))))
          << tile << ", width " << width;
  }
}

TEST(Panes, AreNotKeptWhereAllLieBeforeHalosAndNoLineIs)
{
  Stage stage = testing::pixelStage(64, 1);
  const OwnedMesh mesh = plate(0, 64, -1);
  stage.instances = {pane(mesh, 0.5f)};
  const Scene scene = stage.scene();
  const PlacedScene placed = placeScene(scene, {stage.width, stage.height});
  const PlacedInstance& first = placed.instances[0];
  const TileCluster cluster = {{&first, first.mesh().clusters.data()}, {}};
  const TileClusters clusters = {&placed, {&cluster, 1}};
  TranslucentTile tile;
  tile.clear();
  const auto add = [&](std::uint32_t pixel, float depth) {
    *tile.placeEnd() = pixel << TranslucentTile::kSampleBits;
    *tile.ownerEnd() = 0;
    *tile.depthEnd() = depth;
    tile.grow(1);
  };
  add(5, 0.2f);
  add(6, 0.6f);
  add(40, 0.3f);
  TranslucentFragments fragments;
  fragments.collect(clusters, 1, tile, TranslucentFragments::Depths::kKept);

  const auto keptBy = [&](const PaneReach& reach) {
    TilePanes panes;
    panes.reach(reach);
    panes.add(clusters, 1, fragments);
    std::vector<std::uint32_t> pixels;
    for (const TilePanes::Pixel& one : panes.pixels())
      pixels.push_back(one.pixel);
    return pixels;
  };
  using Pixels = std::vector<std::uint32_t>;
  constexpr TileBlocks kAll = 0xFFFF, kFirst = 1;
  EXPECT_EQ(keptBy({kAll, 0, 0}), (Pixels{5, 6, 40}));
  EXPECT_EQ(keptBy({0, kAll, 0.5f}), (Pixels{6}));
  EXPECT_EQ(keptBy({kFirst, kAll, 0.5f}), (Pixels{5, 6}));
  EXPECT_EQ(keptBy({0, kAll, 0.25f}), (Pixels{6, 40}));
}

TEST(Panes, AreKeptOnlyWhereALineMayBe)
{
  const Line line(-0.5f, kBlack);
  Stage stage = testing::pixelStage(200, 1);
  const OwnedMesh all = testing::sheet({0, 0, 0}, {200, 0, 0}, {0, 200, 0});
  stage.instances = {pane(all, 0.5f)};
  stage.instances[0].lines = line.sets;
  const Panes panes = panesOf(stage);
  for (std::size_t tile = 0; tile < 16; ++tile)
    EXPECT_EQ(panes.tile(tile).isReached(), tile == 0) << tile;
  Line far(-0.5f, kBlack);
  far.points[1].x = 1e20f;
  stage.instances[0].lines = far.sets;
  EXPECT_TRUE(panesOf(stage).tile(3).isReached());
}

}  // namespace
}  // namespace limn
