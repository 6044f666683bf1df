// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent surfaces against the over operator, computed here in sorted order.
#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Base/TranslucencyBound.h"
#include "Rendering/Raster/TranslucentTile.h"
#include "Rendering/Shading/TranslucentFragments.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace limn::testing {
namespace {

class Translucency : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Translucency);

constexpr int kSide = 8;
constexpr int kSampleCounts[] = {1, 2, 4, 8, 16};

/// Over all of a picture of kSide pixels, at a distance from the near plane.
OwnedMesh sheetAt(double distance, int side = kSide)
{
  const auto length = static_cast<double>(side);
  return sheet({0, 0, 0.5 - distance}, {length, 0, 0}, {0, length, 0});
}
Instance glass(const OwnedMesh& mesh, Vec3f color, float opacity)
{
  Instance instance = painted(mesh, color);
  instance.material.opacity = opacity;
  return instance;
}
Picture filled(Rgba8 color, int side = kSide)
{
  Picture picture(side, side);
  std::fill(picture.color.begin(), picture.color.end(), color);
  return picture;
}
/// A colour and how much of it: what the over operator joins.
struct Layer {
  double color, opacity;
};
/// The nearest first.
double over(const std::vector<Layer>& layers, double below)
{
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
    below = layer->color * layer->opacity + below * (1 - layer->opacity);
  return below;
}
std::size_t differences(const Picture& a, const Picture& b)
{
  return a.differingPixels(b);
}

TEST_P(Translucency, ASheetMixesItsColorWithTheBackgroundByItsOpacity)
{
  const OwnedMesh mesh = sheetAt(1);
  for (const int samples : kSampleCounts)
    for (int percent = 0; percent <= 100; percent += 10) {
      Stage stage = pixelStage(kSide, samples);
      const double a = percent / 100.0;
      stage.instances = {glass(mesh, {0.8f, 0.2f, 1}, static_cast<float>(a))};
      Picture picture = filled({50, 255, 0, 100});
      stage.drawOver(picture, GetParam());
      const Rgba8 c = at(picture, 3, 5);
      ASSERT_NEAR(c.r, over({{0.8 * 255, a}}, 50), kRounding + 1e-3) << a;
      ASSERT_NEAR(c.g, over({{0.2 * 255, a}}, 255), kRounding + 1e-3) << a;
      ASSERT_NEAR(c.b, over({{255, a}}, 0), kRounding + 1e-3) << a;
      ASSERT_NEAR(c.a, over({{255, a}}, 100), kRounding + 1e-3) << a;
    }
}

TEST_P(Translucency, ManySheetsLetThroughThePowerOfWhatOneDoes)
{
  for (const double a : {0.02, 0.1, 0.5})
    for (const int sheets : {1, 2, 3, 7, 40}) {
      std::vector<OwnedMesh> meshes;
      for (int i = 0; i < sheets; ++i)
        meshes.push_back(sheetAt(0.2 * (i + 1)));
      Stage stage = pixelStage(kSide, 4);
      for (const OwnedMesh& mesh : meshes)
        stage.instances.push_back(glass(mesh, {1, 1, 1}, static_cast<float>(a)));
      const Picture picture = draw(stage);
      // Not of the bytes of each sheet: an error of each would add up.
      ASSERT_NEAR(at(picture, 2, 2).r, 255 * (1 - std::pow(1 - a, sheets)), kRounding + 1e-2)
          << sheets << " sheets of " << a;
    }
}

TEST_P(Translucency, TheOrderOfInstancesDoesNotMatter)
{
  const Vec3f colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0.3f, 1}, {1, 1, 0}};
  const float opacity[] = {0.3f, 0.5f, 0.7f, 0.25f};
  std::vector<OwnedMesh> meshes;
  for (int i = 0; i < 4; ++i)
    meshes.push_back(sheetAt(1 + i));
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  Stage stage = pixelStage(kSide, 4);
  Picture first(kSide, kSide);
  bool isFirst = true;
  do {
    stage.instances.clear();
    for (const std::size_t i : order)
      stage.instances.push_back(glass(meshes[i], colors[i], opacity[i]));
    const Picture picture = draw(stage);
    if (isFirst) first = picture;
    isFirst = false;
    ASSERT_EQ(differences(picture, first), 0u);
  } while (std::next_permutation(order.begin(), order.end()));
  std::vector<Layer> green;
  for (std::size_t i = 0; i < 4; ++i)
    green.push_back({colors[i].y * 255.0, opacity[i]});
  EXPECT_NEAR(at(first, 4, 4).g, over(green, 0), kRounding + 1e-3);
}

TEST_P(Translucency, TheOrderOfTrianglesDoesNotMatter)
{
  // Loose triangles at depths of their own, with colours of their own.
  constexpr std::uint32_t kTriangles = 60;
  const auto makeSoup = [&](Random random, const std::vector<std::uint32_t>& order) {
    std::vector<std::array<Vec3d, 3>> corners;
    for (std::uint32_t t = 0; t < kTriangles; ++t) {
      std::array<Vec3d, 3> corner;
      for (Vec3d& p : corner)
        p = {random.between(-4, 12), random.between(-4, 12), 0.4 - 0.1 * t};
      corners.push_back(corner);
    }
    std::vector<Vec3d> points;
    for (const std::uint32_t t : order)
      points.insert(points.end(), corners[t].begin(), corners[t].end());
    OwnedMesh mesh = soup(points);
    for (const std::uint32_t t : order)
      mesh.cellColors.push_back(
          {static_cast<std::uint8_t>(t * 4), 90, static_cast<std::uint8_t>(255 - t), 255});
    return mesh;
  };
  std::vector<std::uint32_t> order(kTriangles);
  std::iota(order.begin(), order.end(), 0u);
  Picture first(kSide, kSide);
  for (std::uint32_t turn = 0; turn < 6; ++turn) {
    const OwnedMesh mesh = makeSoup(Random(7), order);
    Stage stage = pixelStage(kSide, 8);
    stage.instances = {glass(mesh, {1, 1, 1}, 0.2f)};
    const Picture picture = draw(stage);
    if (turn == 0) first = picture;
    ASSERT_EQ(differences(picture, first), 0u);
    Random random(turn);
    for (std::uint32_t i = kTriangles; i-- > 1;)
      std::swap(order[i], order[random.below(i + 1)]);
  }
  EXPECT_GT(at(first, 4, 4).g, 60);
}

TEST_P(Translucency, ASurfaceOfManyTrianglesShowsNoSeams)
{
  for (const int samples : kSampleCounts)
    for (const std::uint32_t cells : {1u, 7u, 61u}) {
      const OwnedMesh mesh = sheet({-3, -5, 0.4}, {75, 1, -3}, {2, 75, -4}, cells);
      Stage stage = pixelStage(64, samples);
      stage.instances = {glass(mesh, {1, 1, 1}, 0.5f)};
      const Picture picture = draw(stage);
      for (const Rgba8& color : picture.color)
        ASSERT_EQ(color.r, 128) << samples << " samples, " << cells << " cells";
    }
}

TEST_P(Translucency, SheetsThatCrossAreSortedInEachSample)
{
  // One falls to the right, the other one to the left; they meet at x = 4.
  const OwnedMesh falling = sheet({0, 0, 0}, {8, 0, -2}, {0, 8, 0});
  const OwnedMesh rising = sheet({0, 0, -2}, {8, 0, 2}, {0, 8, 0});
  for (const int samples : kSampleCounts) {
    Stage stage = pixelStage(kSide, samples);
    stage.instances = {glass(falling, {1, 0, 0}, 0.5f), glass(rising, {0, 1, 0}, 0.25f)};
    const Picture picture = draw(stage);
    for (int x = 0; x < kSide; ++x) {
      const bool redInFront = x < 4;
      const std::vector<Layer> red = {{redInFront ? 255.0 : 0.0, redInFront ? 0.5 : 0.25},
                                      {redInFront ? 0.0 : 255.0, redInFront ? 0.25 : 0.5}};
      ASSERT_NEAR(at(picture, x, 3).r, over(red, 0), kRounding + 1e-3) << x << ' ' << samples;
    }
  }
}

TEST_P(Translucency, BehindAnOpaqueSurfaceNothingShowsAndBeforeItBothDo)
{
  const OwnedMesh wall = sheetAt(3), behind = sheetAt(4), before = sheetAt(1);
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {painted(wall, {0, 0, 1}, 5)};
  const Picture opaque = draw(stage);
  stage.instances = {glass(behind, {1, 1, 1}, 0.9f), painted(wall, {0, 0, 1}, 5)};
  EXPECT_EQ(differences(draw(stage), opaque), 0u);
  stage.instances = {glass(before, {1, 0, 0}, 0.4f), painted(wall, {0, 0, 1}, 5)};
  const Picture picture = draw(stage);
  EXPECT_NEAR(at(picture, 4, 4).r, 102, kRounding);
  EXPECT_NEAR(at(picture, 4, 4).b, 153, kRounding);
  // What is picked is the wall, as the pane writes neither depth nor names.
  EXPECT_EQ(picture.instance, opaque.instance);
  EXPECT_EQ(picture.cell, opaque.cell);
  EXPECT_EQ(picture.depth, opaque.depth);
}

TEST_P(Translucency, OfEqualDepthsItLiesOnTheOpaqueSurfaceWhateverTheOrder)
{
  const OwnedMesh mesh = sheetAt(2);
  for (const bool isFirst : {true, false}) {
    Stage stage = pixelStage(kSide, 2);
    stage.instances = {painted(mesh, {0, 0, 1}), painted(mesh, {0, 0, 1})};
    stage.instances[isFirst ? 0 : 1] = glass(mesh, {1, 0, 0}, 0.4f);
    EXPECT_NEAR(at(draw(stage), 4, 4).r, 102, kRounding) << isFirst;
  }
}

TEST_P(Translucency, OfEqualDepthsTheLaterIsNearer)
{
  const OwnedMesh mesh = sheetAt(2);
  Stage stage = pixelStage(kSide, 1);
  stage.instances = {glass(mesh, {1, 0, 0}, 0.5f), glass(mesh, {0, 1, 0}, 0.5f)};
  EXPECT_NEAR(at(draw(stage), 4, 4).r, 64, kRounding);
  EXPECT_NEAR(at(draw(stage), 4, 4).g, 128, kRounding);
}

TEST_P(Translucency, OldDepthsHideIt)
{
  const OwnedMesh mesh = sheetAt(2);
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {glass(mesh, {1, 1, 1}, 0.5f)};
  Picture picture(kSide, kSide);
  picture.depth[0] = 0.1f;
  stage.drawOver(picture, GetParam());
  EXPECT_EQ(picture.color[0].r, 0);
  EXPECT_EQ(picture.coverage[0], 0);
  EXPECT_NEAR(picture.color[1].r, 128, kRounding);
  EXPECT_EQ(picture.coverage[1], 15);
}

TEST_P(Translucency, AtABorderEachSampleIsMixedByItself)
{
  // Over the samples right of x = 4.5, before a wall over those right of x = 4.25.
  const OwnedMesh pane = sheet({4.5, 0, 0}, {8, 0, 0}, {0, 8, 0});
  const OwnedMesh wall = sheet({4.25, 0, -1}, {8, 0, 0}, {0, 8, 0});
  for (const int samples : kSampleCounts) {
    Stage stage = pixelStage(kSide, samples);
    stage.instances = {glass(pane, {1, 1, 1}, 0.5f), painted(wall, {0.4f, 0.4f, 0.4f})};
    Picture picture = filled({20, 20, 20, 255});
    stage.drawOver(picture, GetParam());
    double sum = 0;
    for (const SampleOffset& offset : samplePositions(samples)) {
      double byte = offset.x >= 64 ? 102 : 20;
      if (offset.x >= 128) byte = std::nearbyint(over({{255, 0.5}}, byte));
      sum += std::pow(byte / 255, 2.2);
    }
    EXPECT_NEAR(at(picture, 4, 4).r, 255 * std::pow(sum / samples, 1 / 2.2), kRounding + 1e-3)
        << samples;
  }
}

TEST_P(Translucency, KeptApartColorsAreMultipliedByAlpha)
{
  const OwnedMesh mesh = sheetAt(2);
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {glass(mesh, {1, 0.5f, 0}, 0.5f), glass(mesh, {0, 0, 1}, 0.5f)};
  Picture picture = filled({200, 200, 200, 200});
  stage.drawOver(picture, GetParam(), Background::kKeepApart);
  const Rgba8 c = at(picture, 4, 4);
  EXPECT_NEAR(c.r, 63.75, kRounding);
  EXPECT_NEAR(c.g, 31.875, kRounding);
  EXPECT_NEAR(c.b, 127.5, kRounding);
  EXPECT_NEAR(c.a, 191.25, kRounding);
  EXPECT_EQ(picture.coverage[9], 15);
}

TEST_P(Translucency, RadianceIsMixedBeforeItIsClamped)
{
  const OwnedMesh pane = sheetAt(1), wall = sheetAt(2);
  Stage stage = pixelStage(kSide, 4);
  stage.instances = {glass(pane, {3, 0.5f, 0}, 0.25f), painted(wall, {2, 0, 8})};
  Picture picture(kSide, kSide);
  picture.addRadiance();
  stage.drawOver(picture, GetParam());
  EXPECT_NEAR(picture.radiance[0][9], 3 * 0.25 + 2 * 0.75, 1e-6);
  EXPECT_NEAR(picture.radiance[1][9], 0.125, 1e-6);
  EXPECT_NEAR(picture.radiance[2][9], 6, 1e-6);
  EXPECT_EQ(picture.color[9].r, 255);
  EXPECT_NEAR(picture.color[9].b, 0.75 * 255, kRounding);
}

TEST_P(Translucency, AlphaOfTheDataMultipliesOpacityWhereItIsAskedFor)
{
  OwnedMesh mesh = sheetAt(1, 64);
  mesh.vertexColors = {
      {255, 255, 255, 0}, {255, 255, 255, 255}, {255, 255, 255, 0}, {255, 255, 255, 255}};
  Stage stage = pixelStage(64, 1);
  stage.instances = {glass(mesh, {1, 1, 1}, 0.5f)};
  EXPECT_NEAR(at(draw(stage), 16, 9).r, 127.5, kRounding);
  stage.instances[0].style.readsAlpha = true;
  for (int x = 0; x < 64; x += 5)
    EXPECT_NEAR(at(draw(stage), x, 9).r, 127.5 * (x + 0.5) / 64, kRounding + 1e-3) << x;
  mesh.vertexColors.clear();
  mesh.cellColors = {{255, 255, 255, 51}};
  stage.instances = {glass(mesh, {1, 1, 1}, 1)};
  stage.instances[0].style.readsAlpha = true;
  EXPECT_EQ(at(draw(stage), 16, 9).r, 51);
}

TEST_P(Translucency, TexturesChangeAlphaByTheirMode)
{
  OwnedMesh mesh = sheetAt(1);
  mesh.uv = {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}};
  mesh.vertexColors.assign(4, {255, 255, 255, 102});
  const std::vector<std::uint8_t> texel = {255, 255, 255, 128};
  TextureImage image;
  ASSERT_TRUE(image.build({1, 1, 4, TexelFormat::kUnorm8, texel.data(), 4}, MipChain::kNone).ok());
  const struct {
    TextureMode mode;
    double alpha;
  } cases[] = {{TextureMode::kModulate, 0.4 * 128 / 255},
               {TextureMode::kReplace, 128 / 255.0},
               {TextureMode::kDecal, 0.4},
               {TextureMode::kAdd, 0.4 * 128 / 255}};
  for (const TextureRole role : {TextureRole::kShaded, TextureRole::kSurface})
    for (const auto& one : cases) {
      TextureLayer layer;
      layer.image = &image;
      layer.role = role;
      layer.mode = one.mode;
      Stage stage = pixelStage(kSide, 1);
      stage.instances = {glass(mesh, {1, 1, 1}, 0.8f)};
      stage.instances[0].attributes.uv = mesh.uv;
      stage.instances[0].layers = {&layer, 1};
      stage.instances[0].style.readsAlpha = true;
      EXPECT_NEAR(at(draw(stage), 4, 4).a, 255 * 0.8 * one.alpha, kRounding + 1e-3);
      // From inside this texture is not there.
      layer.onBackFaces = false;
      stage.instances[0].modelToWorld.m[0][0] = -1;
      stage.instances[0].modelToWorld.m[0][3] = kSide;
      stage.instances[0].modelToWorld.m[2][2] = -1;
      EXPECT_NEAR(at(draw(stage), 4, 4).a, 255 * 0.8 * 0.4, kRounding + 1e-3);
    }
}

/// With full alpha the nearest surface alone is seen, as if it were opaque.
TEST_P(Translucency, FullAlphaLooksAsOpaque)
{
  for (std::uint32_t seed = 300; seed < 330; ++seed) {
    const RandomScene random(seed);
    Scene scene = random.scene();
    scene.samples = 1;
    Picture opaque = random.canvas(), translucent = random.canvas();
    const RenderOptions options = {GetParam(), 2};
    ASSERT_TRUE(render(scene, opaque.frame(Background::kBlend), options).ok());
    std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
    for (Instance& instance : instances)
      instance.style.readsAlpha = true;
    scene.instances = instances;
    ASSERT_TRUE(render(scene, translucent.frame(Background::kBlend), options).ok());
    EXPECT_EQ(std::memcmp(opaque.color.data(), translucent.color.data(),
                          opaque.color.size() * sizeof(Rgba8)),
              0)
        << seed;
    EXPECT_EQ(opaque.coverage, translucent.coverage);
    EXPECT_EQ(translucent.depth, random.canvas().depth);
  }
}

/// A stack over a picture of 64 pixels a side, `far` red sheets behind `near` green ones.
struct Stack {
  std::vector<OwnedMesh> meshes;
  Stage stage;

  Stack(int far, int near, int samples, double opacity, int height)
  {
    stage = pixelStage(64, samples);
    for (int i = 0; i < far + near; ++i)
      // Some of 16 samples lie on a pixel's border.
      meshes.push_back(
          sheet({-1, -1, 0.4 - 9.0 * i / (far + near)}, {66, 0, 0}, {0, height + 1 - 1.0 / 64, 0}));
    for (int i = 0; i < far + near; ++i)
      stage.instances.push_back(glass(meshes[static_cast<std::size_t>(i)],
                                      i < near ? Vec3f{0, 1, 0} : Vec3f{1, 0, 0},
                                      static_cast<float>(opacity)));
  }
};

TEST_P(Translucency, ATileThatExceedsTheBoundIsDrawnByPartsAndExactly)
{
  constexpr int kSheets = 9;
  static_assert(kSheets * 64 * 64 * 16 > kMaxTranslucentSamples);
  const Stack stack(kSheets, 0, 16, 0.1, 65);
  Picture picture(64, 64);
  const RenderStats stats = stack.stage.drawOver(picture, GetParam());
  EXPECT_EQ(stats.truncatedPixels, 0u);
  for (const Rgba8& color : picture.color)
    ASSERT_NEAR(color.r, 255 * (1 - std::pow(0.9, kSheets)), kRounding + 1e-2);
}

TEST_P(Translucency, ARowUpToTheBoundIsExactAndBeyondItKeepsTheNearest)
{
  constexpr int kMost = 256, kRows = 2;
  ASSERT_EQ(translucentLayersKept(16), static_cast<std::size_t>(kMost));
  for (const int far : {6, 7}) {
    const Stack stack(far, kMost - 6, 16, 0.004, kRows);
    Picture picture(64, 64);
    const RenderStats stats = stack.stage.drawOver(picture, GetParam());
    EXPECT_EQ(stats.truncatedPixels, far == 6 ? 0u : 64u * kRows);
    const double through = std::pow(1 - 0.004, kMost - 6);
    const Rgba8 c = at(picture, 60, 1);
    EXPECT_NEAR(c.g, 255 * (1 - through), kRounding + 1e-2);
    EXPECT_NEAR(c.r, 255 * through * (1 - std::pow(1 - 0.004, 6)), kRounding + 1e-2);
    EXPECT_EQ(at(picture, 60, kRows).r, 0);
  }
}

/// Beyond the bound, where sheets cross in every direction and their colours change within a pixel.
TEST(TranslucencyBound, BothRenderersKeepTheSame)
{
  Random random(11);
  std::vector<OwnedMesh> meshes;
  std::vector<std::vector<Rgba8>> colors;
  Stage stage = pixelStage(64, 16);
  stage.height = 3;
  stage.view = parallelView({32, 1.5, 1}, {32, 1.5, 0}, 1.5);
  for (int i = 0; i < 300; ++i) {
    const auto slope = [&] { return random.between(-2, 2); };
    meshes.push_back(sheet({-20, -20, random.between(-6, -2)}, {100, slope(), slope()},
                           {slope(), 100, slope()}, 12));
    colors.emplace_back();
    const auto byte = [&] { return static_cast<std::uint8_t>(random.chance(2) ? 255 : 0); };
    for (std::size_t v = 0; v < meshes.back().positions.size(); ++v)
      colors.back().push_back({byte(), byte(), byte(), 255});
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    stage.instances.push_back(
        glass(meshes[i], {1, 1, 1}, static_cast<float>(random.between(0, 0.02))));
    stage.instances.back().attributes.vertexColors = colors[i];
  }
  const auto drawn = [&](Backend backend) {
    Picture picture(stage.width, stage.height);
    EXPECT_EQ(stage.drawOver(picture, backend).truncatedPixels, 64u * 3);
    return picture;
  };
  const Picture expected = drawn(Backend::kReference);
  for (const std::string& target : availableTargets()) {
    ASSERT_TRUE(useTarget(target));
    EXPECT_EQ(differences(drawn(Backend::kPipeline), expected), 0u) << target;
  }
  useTarget("");
}

/// The pieces of a clipped triangle may overlap by rounding, which random scenes never did.
TEST(TranslucentFragments, ATriangleThatMeetsASampleTwiceCountsOnceWhereItIsNearest)
{
  TranslucentTile tile;
  tile.clear();
  const auto add = [&](std::uint32_t owner, float depth) {
    *tile.placeEnd() = 5u << TranslucentTile::kSampleBits;
    *tile.ownerEnd() = owner;
    *tile.depthEnd() = depth;
    tile.grow(1);
  };
  constexpr std::uint32_t kClipped = 64, kOther = 65;
  add(kClipped, 0.5f);
  add(kClipped, 0.3f);
  add(kOther, 0.4f);
  tile.notePieces();
  TranslucentFragments fragments;
  fragments.collect({nullptr, {}}, 1, tile, TranslucentFragments::Depths::kKept);
  ASSERT_EQ(fragments.touched().size(), 1u);
  EXPECT_EQ(fragments.touched()[0].pixel, 5u);
  const std::uint32_t* const layers = fragments.layers();
  ASSERT_EQ(layers[0], 2u);
  const TranslucentFragments::Rest& rest = fragments.rest();
  ASSERT_EQ(rest.count, 2u);
  EXPECT_EQ(rest.owner[layers[1]], kOther);
  EXPECT_EQ(rest.owner[layers[2]], kClipped);
  EXPECT_EQ(fragments.depths()[1], 0.4f);
  EXPECT_EQ(fragments.depths()[2], 0.3f);
}

}  // namespace
}  // namespace limn::testing
