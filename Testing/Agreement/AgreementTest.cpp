// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pipeline draws what the reference renderer draws, bit for bit, on every instruction set and
// with any number of threads.
#include "Rendering/Post/EffectPlanes.h"
#include "Rendering/Renderer.h"
#include "Testing/Agreement/RandomScene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <functional>

namespace limn {
namespace {

using testing::drawn;
using testing::Picture;
using testing::RandomScene;

constexpr std::uint32_t kScenes = 400;

Picture drawnWithoutShaders(const RandomScene& random)
{
  Scene scene = random.scene();
  std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
  for (Instance& instance : instances)
    instance.style.surfaceShader = nullptr;
  scene.instances = instances;
  Picture picture = random.canvas();
  const Status status = render(scene, picture.frame(random.background()));
  EXPECT_TRUE(status.ok()) << status.message;
  return picture;
}

Picture drawnWithoutHulls(const RandomScene& random)
{
  Scene scene = random.scene();
  std::vector<Instance> instances;
  for (const Instance& instance : scene.instances)
    if (instance.hull == nullptr) instances.push_back(instance);
  scene.instances = instances;
  Picture picture = random.canvas();
  const Status status = render(scene, picture.frame(random.background()));
  EXPECT_TRUE(status.ok()) << status.message;
  return picture;
}

Picture drawnWithEffects(const RandomScene& random, const RenderOptions& options)
{
  Picture picture = random.canvas();
  picture.addRadiance();
  const FrameView frame = picture.frame(random.background());
  Status status = render(random.scene(), frame, options);
  EXPECT_TRUE(status.ok()) << status.message;
  // One for all scenes: what the one before left in it must not show.
  static EffectPlanes planes;
  status = applyEffects(random.effects(), random.scene().camera, frame, planes, options);
  EXPECT_TRUE(status.ok()) << status.message;
  return picture;
}

class EveryTarget : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(useTarget(GetParam())); }
  void TearDown() override { useTarget(""); }

  /// Of the scenes the best instruction set draws each, the others every eleventh: SameBytes holds
  /// them to the same bytes, and the reference takes long. (Eleven, as scenes vary with the
  /// remainders of their numbers by 3, 4, 5, 7 and 8.)
  static std::uint32_t stride() { return GetParam() == availableTargets().front() ? 1 : 11; }
  /// How many pixels must show what a test is about, if all its scenes are drawn; few may not.
  static std::size_t least(std::size_t pixels) { return stride() == 1 ? pixels : 0; }
};

TEST_P(EveryTarget, DrawsLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t coveredPixels = 0;
  for (std::uint32_t seed = 0; seed < kScenes; seed += stride()) {
    const RandomScene random(seed);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    const Picture actual = drawn(random, {Backend::kPipeline, kThreads[seed % 4]});
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    for (const std::uint8_t coverage : expected.coverage)
      coveredPixels += coverage != 0;
  }
  EXPECT_GE(coveredPixels, least(1000000u)) << "the scenes must show something";
}

TEST_P(EveryTarget, DrawsFineMeshesLikeTheReference)
{
  for (std::uint32_t seed = 0; seed < 40; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kFine);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, 2}).differingPixels(expected), 0u)
        << "seed " << seed;
  }
}

TEST_P(EveryTarget, DrawsCoarseMeshesLikeTheReference)
{
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kCoarse);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, 2}).differingPixels(expected), 0u)
        << "seed " << seed;
  }
}

TEST_P(EveryTarget, AppliesPostEffectsLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0, brightPixels = 0;
  for (std::uint32_t seed = 0; seed < 240; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kPost);
    const Picture expected = drawnWithEffects(random, {Backend::kReference, 1});
    const Picture actual = drawnWithEffects(random, {Backend::kPipeline, kThreads[seed % 4]});
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    const Picture plain = drawn(random, {Backend::kPipeline, 2});
    for (std::size_t i = 0; i < plain.color.size(); ++i) {
      changedPixels += plain.color[i].r != actual.color[i].r;
      brightPixels += actual.radiance[0][i] > 1;
    }
  }
  EXPECT_GE(changedPixels, least(500000u)) << "the effects must show";
  EXPECT_GE(brightPixels, least(50000u)) << "there must be colours above 1";
}

TEST_P(EveryTarget, TexturesLikeTheReference)
{
  for (std::uint32_t seed = 0; seed < 400; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kTextures);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, 2}).differingPixels(expected), 0u)
        << "seed " << seed;
  }
}

TEST_P(EveryTarget, LightsLikeTheReference)
{
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kLights);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, 2}).differingPixels(expected), 0u)
        << "seed " << seed;
  }
}

TEST_P(EveryTarget, ReflectsLikeTheReference)
{
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kReflections);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, 2}).differingPixels(expected), 0u)
        << "seed " << seed;
  }
}

/// Of every `stride`th of the scenes [0, scenes) with a detail, that both renderers draw it alike,
/// and that it changes at least so many pixels.
void expectChanges(RandomScene::Detail detail, std::uint32_t scenes, std::uint32_t stride,
                   std::size_t least)
{
  std::size_t changedPixels = 0;
  constexpr int kThreads[] = {1, 2, 3, 8};
  for (std::uint32_t seed = 0; seed < scenes; seed += stride) {
    const RandomScene random(seed, detail);
    Picture expected = random.canvas(), actual = random.canvas();
    if (seed % 4 == 0)
      for (Picture* picture : {&expected, &actual})
        picture->addRadiance();
    const RenderOptions options = {Backend::kPipeline, kThreads[seed % 4]};
    ASSERT_TRUE(
        render(random.scene(), expected.frame(random.background()), {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), actual.frame(random.background()), options).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    const Picture plain = drawn(RandomScene(seed), {Backend::kPipeline, 2});
    for (std::size_t i = 0; i < plain.color.size(); ++i)
      changedPixels += plain.color[i].g != actual.color[i].g;
  }
  EXPECT_GE(changedPixels, least) << "it must show";
}

TEST_P(EveryTarget, TonesLikeTheReference)
{
  expectChanges(RandomScene::Detail::kTones, 250, stride(), least(300000u));
}

TEST_P(EveryTarget, HatchesLikeTheReference)
{
  expectChanges(RandomScene::Detail::kHatching, 300, stride(), least(500000u));
}

TEST_P(EveryTarget, ExaggeratesLikeTheReference)
{
  expectChanges(RandomScene::Detail::kExaggerated, 150, stride(), least(250000u));
}

TEST_P(EveryTarget, ExaggeratesAtCreasesLikeTheReference)
{
  expectChanges(RandomScene::Detail::kCreasedExaggeration, 120, stride(), least(200000u));
}

TEST_P(EveryTarget, TonesColorsOfDataLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kDataTones);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, kThreads[seed % 4]}).differingPixels(expected), 0u)
        << "seed " << seed;
    std::vector<Instance> classic(random.scene().instances.begin(), random.scene().instances.end());
    for (Instance& instance : classic)
      instance.style.toneOverData = ToneOverData::kClassic;
    Scene scene = random.scene();
    scene.instances = classic;
    Picture plain = random.canvas();
    ASSERT_TRUE(render(scene, plain.frame(random.background())).ok());
    for (std::size_t i = 0; i < plain.color.size(); ++i)
      changedPixels += plain.color[i].r != expected.color[i].r;
  }
  EXPECT_GE(changedPixels, least(500000u)) << "the tones must show";
}

TEST_P(EveryTarget, RunsShadersLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kShaders);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    ASSERT_EQ(drawn(random, {Backend::kPipeline, kThreads[seed % 4]}).differingPixels(expected), 0u)
        << "seed " << seed;
    const Picture plain = drawnWithoutShaders(random);
    for (std::size_t i = 0; i < plain.color.size(); ++i)
      changedPixels += plain.color[i].r != expected.color[i].r;
  }
  EXPECT_GE(changedPixels, least(500000u)) << "the shaders must show";
}

TEST_P(EveryTarget, LaysTranslucentSurfacesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 160; seed += stride()) {
    const RandomScene random(seed, seed % 8 == 1 ? RandomScene::Detail::kFineTranslucent
                                                 : RandomScene::Detail::kTranslucent);
    Picture expected = random.canvas(), actual = random.canvas(), opaque = random.canvas();
    if (seed % 3 == 0)
      for (Picture* picture : {&expected, &actual})
        picture->addRadiance();
    RenderStats stats[2];
    RenderOptions options = {Backend::kPipeline, kThreads[seed % 4]};
    options.optimizations.occlusionCulling = seed % 7 != 0;
    options.optimizations.smallClusters = seed % 11 != 0;
    ASSERT_TRUE(render(random.scene(), expected.frame(random.background()),
                       {Backend::kReference, 1}, &stats[0])
                    .ok());
    ASSERT_TRUE(render(random.scene(), actual.frame(random.background()), options, &stats[1]).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    ASSERT_EQ(stats[0].truncatedPixels, stats[1].truncatedPixels) << "seed " << seed;
    for (std::size_t i = 0; i < actual.color.size(); ++i)
      changedPixels += actual.color[i].g != opaque.color[i].g && actual.instance[i] == kNobody;
  }
  EXPECT_GE(changedPixels, least(160000u)) << "translucent surfaces must show";
}

TEST_P(EveryTarget, PlacesHullsLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kHulls);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    for (bool Optimizations::*one :
         {&Optimizations::occlusionCulling, &Optimizations::smallClusters}) {
      RenderOptions options = {Backend::kPipeline, kThreads[seed % 4]};
      options.optimizations.*one = seed % 3 != 0;
      ASSERT_EQ(drawn(random, options).differingPixels(expected), 0u) << "seed " << seed;
    }
    changedPixels += drawnWithoutHulls(random).differingPixels(expected);
  }
  EXPECT_GE(changedPixels, least(200000u)) << "the hulls must show";
}

TEST_P(EveryTarget, DrawsLinesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0, newSamples = 0, newDepths = 0;
  for (std::uint32_t seed = 0; seed < 300; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kLines);
    Picture expected = random.canvas(), actual = random.canvas(), plain = random.canvas();
    if (seed % 3 == 0)
      for (Picture* picture : {&expected, &actual})
        picture->addRadiance();
    ASSERT_TRUE(
        render(random.scene(), expected.frame(random.background()), {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), actual.frame(random.background()),
                       {Backend::kPipeline, kThreads[seed % 4]})
                    .ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    Scene scene = random.scene();
    std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
    for (Instance& instance : instances)
      instance.lines = {};
    scene.instances = instances;
    ASSERT_TRUE(render(scene, plain.frame(random.background())).ok());
    for (std::size_t i = 0; i < plain.color.size(); ++i) {
      changedPixels += plain.color[i].r != actual.color[i].r;
      newSamples += plain.coverage[i] != actual.coverage[i];
      newDepths += plain.depth[i] != actual.depth[i];
    }
  }
  EXPECT_GE(changedPixels, least(300000u)) << "lines must show";
  EXPECT_GE(newSamples, least(5000u));
  EXPECT_GE(newDepths, least(20000u));
}

TEST_P(EveryTarget, DrawsSharesOfLinesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 200; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kLineShares);
    const Picture expected = drawn(random, {Backend::kReference, 1});
    const Picture actual = drawn(random, {Backend::kPipeline, kThreads[seed % 4]});
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    const RandomScene whole(seed, RandomScene::Detail::kLines);
    const Picture wide = drawn(whole, {Backend::kPipeline, 1});
    if (wide.color.size() != actual.color.size()) continue;
    changedPixels += wide.differingPixels(actual);
  }
  EXPECT_GE(changedPixels, least(20000u)) << "shares must show";
}

TEST_P(EveryTarget, DrawsLinesBelowTranslucentSurfacesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 100; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kVeils);
    Picture expected = random.canvas(), actual = random.canvas(), bare = random.canvas();
    if (seed % 4 == 1)
      for (Picture* const picture : {&expected, &actual, &bare})
        picture->addRadiance();
    const auto draw = [&](const Scene& scene, Picture& picture, RenderOptions options) {
      const Status status = render(scene, picture.frame(random.background()), options);
      ASSERT_TRUE(status.ok()) << status.message;
    };
    draw(random.scene(), expected, {Backend::kReference, 1});
    draw(random.scene(), actual, {Backend::kPipeline, kThreads[seed % 4]});
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;

    Scene scene = random.scene();
    std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
    for (Instance& instance : instances)
      if (!instance.isTranslucent()) instance.lines = {};
    scene.instances = instances;
    draw(scene, bare, {Backend::kPipeline, 1});
    changedPixels += actual.differingPixels(bare);
  }
  EXPECT_GE(changedPixels, least(20000u)) << "lines must show";
}

std::size_t pixelOf(const Picture& picture, const LinePixel& one)
{
  return static_cast<std::size_t>(one.y) * static_cast<std::size_t>(picture.width) + one.x;
}

bool same(const LinePixel& a, const LinePixel& b)
{
  return a.x == b.x && a.y == b.y && std::memcmp(&a.color, &b.color, sizeof a.color) == 0 &&
         std::memcmp(&a.depth, &b.depth, sizeof a.depth) == 0 && a.samples == b.samples;
}

TEST_P(EveryTarget, KeepsSharesOfLinesApartLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t pixels = 0, partly = 0;
  for (std::uint32_t seed = 0; seed < 200; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kLines);
    Picture expected = random.canvas(), actual = random.canvas();
    for (Picture* picture : {&expected, &actual}) {
      const RenderOptions options = picture == &expected
                                        ? RenderOptions{Backend::kReference, 1}
                                        : RenderOptions{Backend::kPipeline, kThreads[seed % 4]};
      if (seed % 3 == 0) picture->addRadiance();
      FrameView frame = picture->frame(Background::kKeepApart);
      frame.linePixels = &picture->linePixels;
      ASSERT_TRUE(render(random.scene(), frame, options).ok());
      picture->sortLinePixels();
    }
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    ASSERT_EQ(actual.linePixels.size(), expected.linePixels.size()) << "seed " << seed;
    for (std::size_t i = 0; i < actual.linePixels.size(); ++i) {
      const LinePixel& one = actual.linePixels[i];
      ASSERT_TRUE(same(one, expected.linePixels[i])) << "seed " << seed;
      partly += actual.coverage.empty() ? 0 : actual.coverage[pixelOf(actual, one)] != 0;
    }
    pixels += actual.linePixels.size();
  }
  EXPECT_GE(pixels, least(2000u));
  EXPECT_GE(partly, least(500u)) << "some pixels show a surface too";
}

TEST_P(EveryTarget, FindsNormalsLikeTheReference)
{
  constexpr RandomScene::Detail kDetails[] = {
      RandomScene::Detail::kAny,        RandomScene::Detail::kFine,    RandomScene::Detail::kCoarse,
      RandomScene::Detail::kTextures,   RandomScene::Detail::kShaders, RandomScene::Detail::kLights,
      RandomScene::Detail::kTranslucent};
  std::size_t normals = 0;
  for (std::uint32_t seed = 0; seed < 140; seed += stride()) {
    const RandomScene random(seed, kDetails[seed % 7]);
    Picture expected = random.canvas(), actual = random.canvas();
    for (Picture* picture : {&expected, &actual})
      picture->addNormals();
    FrameView frame = actual.frame(random.background());
    FrameView plain = expected.frame(random.background());
    if (seed % 5 == 0) frame.clear.extent = plain.clear.extent = FrameClear::Extent::kAll;
    ASSERT_TRUE(render(random.scene(), plain, {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), frame, {Backend::kPipeline, 2}).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    for (const float z : actual.normal[2])
      normals += z != 0;
  }
  EXPECT_GE(normals, least(100000u));
}

TEST_P(EveryTarget, DrawsImageLinesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 90; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kImageLines);
    Picture expected = random.canvas(), actual = random.canvas(), plain = random.canvas();
    if (seed % 3 == 0)
      for (Picture* picture : {&expected, &actual})
        picture->addRadiance();
    FrameView referenceFrame = expected.frame(random.background());
    FrameView frame = actual.frame(random.background());
    if (seed % 5 == 0) frame.clear.extent = referenceFrame.clear.extent = FrameClear::Extent::kAll;
    ASSERT_TRUE(render(random.scene(), referenceFrame, {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), frame, {Backend::kPipeline, kThreads[seed % 4]}).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    Scene without = random.scene();
    std::vector<Instance> instances(without.instances.begin(), without.instances.end());
    for (Instance& instance : instances)
      instance.style.imageOutline = {};
    without.instances = instances;
    frame = plain.frame(random.background());
    if (seed % 5 == 0) frame.clear.extent = FrameClear::Extent::kAll;
    ASSERT_TRUE(render(without, frame).ok());
    for (std::size_t i = 0; i < plain.color.size(); ++i)
      changedPixels += plain.color[i].r != actual.color[i].r;
  }
  EXPECT_GE(changedPixels, least(50000u)) << "the lines must show";
}

Picture drawnWithout(const RandomScene& random, const FrameClear& clear,
                     const std::function<void(Style&)>& change)
{
  Scene scene = random.scene();
  std::vector<Instance> instances(scene.instances.begin(), scene.instances.end());
  for (Instance& instance : instances)
    change(instance.style);
  scene.instances = instances;
  Picture picture = random.canvas();
  FrameView frame = picture.frame(random.background());
  frame.clear = clear;
  EXPECT_TRUE(render(scene, frame).ok());
  return picture;
}

TEST_P(EveryTarget, DrawsCreasesLikeTheReferenceByEveryDetector)
{
  std::size_t changedPixels[3] = {0, 0, 0};
  for (std::uint32_t seed = 0; seed < 60; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kCreases);
    Picture expected = random.canvas(), actual = random.canvas();
    const FrameView frame = actual.frame(random.background());
    ASSERT_TRUE(
        render(random.scene(), expected.frame(random.background()), {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), frame, {Backend::kPipeline, 2}).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    for (const CreaseDetector detector :
         {CreaseDetector::kAngle, CreaseDetector::kSobel, CreaseDetector::kLaplacian}) {
      const Picture without = drawnWithout(random, {}, [detector](Style& style) {
        if (style.imageOutline.creases == detector) style.imageOutline.creaseDegrees = 180;
      });
      changedPixels[static_cast<int>(detector)] += actual.differingPixels(without);
    }
  }
  for (const std::size_t changed : changedPixels)
    EXPECT_GE(changed, least(2000u)) << "creases must show";
}

TEST_P(EveryTarget, DrawsBordersOfIdsLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changedPixels = 0;
  for (std::uint32_t seed = 0; seed < 90; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kIdBorders);
    Picture expected = random.canvas(), actual = random.canvas();
    const FrameView frame = actual.frame(random.background());
    ASSERT_TRUE(
        render(random.scene(), expected.frame(random.background()), {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), frame, {Backend::kPipeline, kThreads[seed % 4]}).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    const Picture without =
        drawnWithout(random, {}, [](Style& style) { style.imageOutline.ids = false; });
    changedPixels += actual.differingPixels(without);
  }
  EXPECT_GE(changedPixels, least(10000u)) << "the borders must show";
}

TEST_P(EveryTarget, DrawsDepthCuesLikeTheReference)
{
  constexpr int kThreads[] = {1, 2, 3, 8};
  std::size_t changed[3] = {0, 0, 0};
  for (std::uint32_t seed = 0; seed < 90; seed += stride()) {
    const RandomScene random(seed, RandomScene::Detail::kCues);
    Picture expected = random.canvas(), actual = random.canvas();
    if (seed % 3 == 0)
      for (Picture* picture : {&expected, &actual})
        picture->addRadiance();
    FrameView referenceFrame = expected.frame(random.background());
    FrameView frame = actual.frame(random.background());
    if (seed % 5 == 0) frame.clear.extent = referenceFrame.clear.extent = FrameClear::Extent::kAll;
    ASSERT_TRUE(render(random.scene(), referenceFrame, {Backend::kReference, 1}).ok());
    ASSERT_TRUE(render(random.scene(), frame, {Backend::kPipeline, kThreads[seed % 4]}).ok());
    ASSERT_EQ(actual.differingPixels(expected), 0u) << "seed " << seed;
    const Picture without[] = {
        drawnWithout(random, frame.clear, [](Style& style) { style.cues.eyeDome = {}; }),
        drawnWithout(random, frame.clear, [](Style& style) { style.cues.unsharp = {}; }),
        drawnWithout(random, frame.clear, [](Style& style) { style.cues.halo = {}; })};
    for (std::size_t i = 0; i < actual.color.size(); ++i)
      for (std::size_t cue = 0; cue < 3; ++cue)
        changed[cue] += without[cue].color[i].r != actual.color[i].r;
  }
  EXPECT_GE(changed[0], least(30000u)) << "eye-dome lighting must show";
  EXPECT_GE(changed[1], least(30000u)) << "unsharp masks must show";
  EXPECT_GE(changed[2], least(5000u)) << "halos must show";
}

TEST_P(EveryTarget, DrawsTheSameWithoutEachOptimization)
{
  std::size_t occluded = 0;
  for (std::uint32_t seed = 100; seed < 160; seed += stride()) {
    const RandomScene random(
        seed, seed % 3 == 0 ? RandomScene::Detail::kCoarse : RandomScene::Detail::kFine);
    Picture fast = random.canvas();
    RenderStats stats;
    ASSERT_TRUE(
        render(random.scene(), fast.frame(random.background()), {Backend::kPipeline, 2}, &stats)
            .ok());
    occluded += stats.occludedClusters;
    for (bool Optimizations::*one : {&Optimizations::occlusionCulling,
                                     &Optimizations::smallClusters, &Optimizations::fragmentRuns}) {
      RenderOptions options = {Backend::kPipeline, 2};
      options.optimizations.*one = false;
      ASSERT_EQ(drawn(random, options).differingPixels(fast), 0u) << "seed " << seed;
    }
  }
  EXPECT_GE(occluded, least(1000u));
}

INSTANTIATE_TEST_SUITE_P(Targets, EveryTarget, ::testing::ValuesIn(availableTargets()),
                         [](const auto& target) { return target.param; });

}  // namespace
}  // namespace limn
