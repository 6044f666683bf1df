// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is written to a frame: colours of partly covered pixels, coverage, names, and nothing else.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class Frames : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Frames);

constexpr int kSide = 8;

/// Pixels x >= 4.5: with two samples one of each pixel of column 4.
OwnedMesh rightHalf()
{
  return sheet({4.5, 0, 0}, {8, 0, 0}, {0, 8, 0});
}
std::size_t pixelAt(int x, int y)
{
  return static_cast<std::size_t>(y * kSide + x);
}
Picture filled(Rgba8 color)
{
  Picture picture(kSide, kSide);
  std::fill(picture.color.begin(), picture.color.end(), color);
  return picture;
}
Vec3f gray(int byte)
{
  const float value = static_cast<float>(byte) / 255;
  return {value, value, value};
}

TEST_P(Frames, AHalfCoveredPixelIsTheMeanAtGamma22)
{
  const OwnedMesh mesh = rightHalf();
  for (int front = 0; front < 256; front += 15)
    for (int back = 0; back < 256; back += 17) {
      Stage stage = pixelStage(kSide, 2);
      stage.instances = {painted(mesh, gray(front))};
      Picture picture = filled({static_cast<std::uint8_t>(back), 0, 0, 255});
      stage.drawOver(picture, GetParam());
      const double mean = (std::pow(front / 255.0, 2.2) + std::pow(back / 255.0, 2.2)) / 2;
      ASSERT_NEAR(picture.color[pixelAt(4, 4)].r, 255 * std::pow(mean, 1 / 2.2), kRounding + 1e-3)
          << front << " over " << back;
      ASSERT_EQ(picture.color[pixelAt(5, 4)].r, front);
      ASSERT_EQ(picture.color[pixelAt(3, 4)].r, back);
    }
}

TEST_P(Frames, LinearResolveIsThePlainMean)
{
  const OwnedMesh mesh = rightHalf();
  Stage stage = pixelStage(kSide, 8);
  stage.resolve = Resolve::kLinear;
  stage.instances = {painted(mesh, gray(200))};
  Picture picture = filled({40, 40, 40, 255});
  stage.drawOver(picture, GetParam());
  const int bits = bitCount(picture.coverage[pixelAt(4, 4)]);
  EXPECT_EQ(bits, 4);
  EXPECT_EQ(picture.color[pixelAt(4, 4)].r, 120);
}

TEST_P(Frames, AlphaIsTheLinearMeanWithTheOldAlpha)
{
  const OwnedMesh mesh = rightHalf();
  for (const Resolve resolve : {Resolve::kGamma22, Resolve::kLinear}) {
    Stage stage = pixelStage(kSide, 2);
    stage.resolve = resolve;
    stage.instances = {painted(mesh, {1, 1, 1})};
    Picture picture = filled({0, 0, 0, 55});
    stage.drawOver(picture, GetParam());
    EXPECT_EQ(picture.color[pixelAt(4, 4)].a, 155);
    EXPECT_EQ(picture.color[pixelAt(5, 4)].a, 255);
    EXPECT_EQ(picture.color[pixelAt(3, 4)].a, 55);
  }
}

TEST_P(Frames, KeptApartACoveredPixelHasTheSurfacesColorAlone)
{
  const OwnedMesh mesh = rightHalf();
  Stage stage = pixelStage(kSide, 8);
  stage.instances = {painted(mesh, gray(77))};
  Picture picture = filled({200, 100, 50, 10});
  stage.drawOver(picture, GetParam(), Background::kKeepApart);
  const Rgba8 border = picture.color[pixelAt(4, 4)];
  EXPECT_EQ(border.r, 77);
  EXPECT_EQ(border.g, 77);
  EXPECT_EQ(border.a, 255);
  EXPECT_EQ(picture.color[pixelAt(3, 4)].r, 200);
  EXPECT_EQ(picture.color[pixelAt(3, 4)].a, 10);
}

TEST_P(Frames, CoverageBitsNameTheSamplesRightOfAnEdge)
{
  const OwnedMesh mesh = rightHalf();
  // Direct3D's standard x positions, in sixteenths of a pixel.
  const std::vector<std::vector<int>> xs = {
      {8}, {12, 4}, {6, 14, 2, 10}, {9, 7, 13, 5, 3, 1, 11, 15}};
  for (std::size_t i = 0; i < xs.size(); ++i) {
    Stage stage = pixelStage(kSide, 1 << i);
    stage.instances = {painted(mesh, {1, 1, 1})};
    const Picture picture = draw(stage);
    unsigned expected = 0;
    for (std::size_t s = 0; s < xs[i].size(); ++s)
      if (xs[i][s] >= 8) expected |= 1u << s;
    EXPECT_EQ(picture.coverage[pixelAt(4, 3)], expected) << (1 << i) << " samples";
    EXPECT_EQ(picture.coverage[pixelAt(6, 3)], (1u << (1 << i)) - 1);
    EXPECT_EQ(picture.coverage[pixelAt(2, 3)], 0);
  }
}

TEST_P(Frames, PixelsThatShowNothingKeepEveryPlane)
{
  const OwnedMesh mesh = rightHalf();
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {painted(mesh, {1, 1, 1}, 3)};
  Picture picture(kSide, kSide);
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    picture.color[i] = {static_cast<std::uint8_t>(i), 7, 8, 9};
    picture.depth[i] = 0.9f + static_cast<float>(i) / 1000;
    picture.coverage[i] = static_cast<std::uint8_t>(i);
    picture.instance[i] = 1000 + n;
    picture.cell[i] = 2000 + n;
  }
  const Picture before = picture;
  stage.drawOver(picture, GetParam());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < 4; ++x) {
      const std::size_t i = pixelAt(x, y);
      EXPECT_EQ(picture.color[i].r, before.color[i].r);
      EXPECT_EQ(picture.color[i].a, before.color[i].a);
      EXPECT_EQ(picture.depth[i], before.depth[i]);
      EXPECT_EQ(picture.coverage[i], before.coverage[i]);
      EXPECT_EQ(picture.instance[i], before.instance[i]);
      EXPECT_EQ(picture.cell[i], before.cell[i]);
    }
  EXPECT_EQ(picture.instance[pixelAt(6, 6)], 3u);
}

TEST_P(Frames, NamesAreTheInstancesIdAndTheTrianglesCell)
{
  // Cells of one pixel; each of two triangles.
  const OwnedMesh mesh = sheet({0, 0, 0}, {8, 0, 0}, {0, 8, 0}, kSide);
  Stage stage = pixelStage(kSide, 1);
  stage.instances = {painted(mesh, {1, 1, 1}, 0xABCDEF01)};
  Picture picture = draw(stage);
  for (std::size_t i = 0; i < picture.cell.size(); ++i) {
    EXPECT_EQ(picture.cell[i], i);
    EXPECT_EQ(picture.instance[i], 0xABCDEF01);
  }
  // Without cells every triangle is its own.
  stage.instances[0].attributes = {};
  picture = draw(stage);
  for (std::size_t i = 0; i < picture.cell.size(); ++i)
    EXPECT_EQ(picture.cell[i] / 2, i);
}

TEST_P(Frames, PlanesOfCoverageAndNamesMayBeMissing)
{
  const OwnedMesh mesh = rightHalf();
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {painted(mesh, gray(90))};
  const Picture whole = draw(stage);
  Picture picture(kSide, kSide);
  FrameView frame = picture.frame(Background::kBlend);
  frame.coverage = nullptr;
  frame.instance = frame.cell = nullptr;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
  for (std::size_t i = 0; i < whole.color.size(); ++i) {
    EXPECT_EQ(picture.color[i].r, whole.color[i].r);
    EXPECT_EQ(picture.depth[i], whole.depth[i]);
  }
}

TEST_P(Frames, RowsMayBeLongerThanThePicture)
{
  const OwnedMesh mesh = rightHalf();
  Stage stage = pixelStage(kSide, 2);
  stage.instances = {painted(mesh, gray(90), 4)};
  const Picture whole = draw(stage);
  Picture wide(kSide + 5, kSide);
  FrameView frame = wide.frame(Background::kBlend);
  frame.width = kSide;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 1}).ok());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide + 5; ++x) {
      const auto i = static_cast<std::size_t>(y * (kSide + 5) + x);
      EXPECT_EQ(wide.color[i].r, x < kSide ? whole.color[pixelAt(x, y)].r : 0);
      EXPECT_EQ(wide.instance[i], x < kSide ? whole.instance[pixelAt(x, y)] : kNobody);
    }
}

TEST_P(Frames, NothingOutsideTheTouchedRectangleIsWritten)
{
  Stage stage;
  stage.width = 300;
  stage.height = 200;
  stage.view.target = {0.7, 0.4, 0};
  stage.samples = 8;
  stage.instances = {painted(fineSphere(), {1, 1, 1})};
  Picture picture(stage.width, stage.height);
  const PixelRectangle touched = stage.drawOver(picture, GetParam()).touched;
  int left = stage.width, right = 0;
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x) {
      if (!covered(picture, x, y)) continue;
      ASSERT_TRUE(x >= touched.x0 && x < touched.x1 && y >= touched.y0 && y < touched.y1)
          << x << ", " << y;
      left = std::min(left, x);
      right = std::max(right, x + 1);
    }
  EXPECT_GE(touched.x0, 0);
  EXPECT_LE(touched.x1, stage.width);
  EXPECT_LE(touched.y1, stage.height);
  // The reference renderer names the whole picture. The pipeline names the boxes of its clusters,
  // which at the outline stick out by up to a cluster of 128 triangles, some 36 pixels, on each
  // side.
  const int slack = GetParam() == Backend::kPipeline ? 72 : stage.width;
  EXPECT_GT(right - left, 100);
  EXPECT_LE(touched.x1 - touched.x0, right - left + slack);
}

/// Two tiles and more, of which the sphere meets only some.
Stage sphereAside()
{
  Stage stage;
  stage.width = 300;
  stage.height = 200;
  stage.view.target = {1.1, 0.4, 0};
  stage.samples = 2;
  stage.instances = {painted(fineSphere(), {1, 1, 1})};
  return stage;
}

TEST_P(Frames, ClearingWhileDrawingIsDrawingOverAClearedFrame)
{
  const Stage stage = sphereAside();
  Picture expected(stage.width, stage.height);
  std::fill(expected.color.begin(), expected.color.end(), Rgba8{9, 8, 7, 6});
  std::fill(expected.depth.begin(), expected.depth.end(), 0.9f);
  stage.drawOver(expected, GetParam());

  Picture picture(stage.width, stage.height);
  std::fill(picture.color.begin(), picture.color.end(), Rgba8{200, 0, 0, 0});
  std::fill(picture.depth.begin(), picture.depth.end(), 0.1f);
  std::fill(picture.coverage.begin(), picture.coverage.end(), std::uint8_t{3});
  std::fill(picture.cell.begin(), picture.cell.end(), 3u);
  std::fill(picture.instance.begin(), picture.instance.end(), 3u);
  FrameView frame = picture.frame(Background::kBlend);
  frame.clear = {FrameClear::Extent::kAll, {9, 8, 7, 6}, 0.9f};
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 2}).ok());
  EXPECT_EQ(picture.differingPixels(expected), 0u);
}

TEST_P(Frames, ClearingWhatIsTouchedLeavesTheRest)
{
  const Stage stage = sphereAside();
  const Picture expected = stage.draw(GetParam());
  Picture picture(stage.width, stage.height);
  std::fill(picture.color.begin(), picture.color.end(), Rgba8{200, 0, 0, 0});
  FrameView frame = picture.frame(Background::kBlend);
  frame.clear.extent = FrameClear::Extent::kTouched;
  RenderStats stats;
  ASSERT_TRUE(render(stage.scene(), frame, {GetParam(), 2}, &stats).ok());
  std::size_t left = 0;
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x) {
      const auto i = static_cast<std::size_t>(y * stage.width + x);
      const PixelRectangle& t = stats.touched;
      if (x >= t.x0 && x < t.x1 && y >= t.y0 && y < t.y1) {
        ASSERT_EQ(picture.color[i].r, expected.color[i].r) << x << ", " << y;
      }
      left += picture.color[i].r == 200;
    }
  EXPECT_EQ(left > 10000, GetParam() == Backend::kPipeline);
}

TEST_P(Frames, AnErrorClearsNothing)
{
  Stage stage = pixelStage(kSide, 4);
  stage.samples = 3;
  Picture picture = filled({1, 2, 3, 4});
  FrameView frame = picture.frame(Background::kBlend);
  frame.clear.extent = FrameClear::Extent::kAll;
  EXPECT_FALSE(render(stage.scene(), frame, {GetParam(), 1}).ok());
  EXPECT_EQ(picture.differingPixels(filled({1, 2, 3, 4})), 0u);
}

TEST_P(Frames, AnEmptySceneChangesNothing)
{
  const OwnedMesh empty = soup({});
  Stage stage = pixelStage(kSide, 4);
  for (int instances = 0; instances < 2; ++instances) {
    Picture picture = filled({1, 2, 3, 4});
    const PixelRectangle touched = stage.drawOver(picture, GetParam()).touched;
    EXPECT_EQ(picture.differingPixels(filled({1, 2, 3, 4})), 0u);
    EXPECT_EQ(touched.x0 >= touched.x1, GetParam() == Backend::kPipeline);
    stage.instances = {painted(empty, {1, 1, 1})};
  }
}

}  // namespace
}  // namespace limn::testing
