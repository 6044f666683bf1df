// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One hash for every compiler, optimisation level, instruction set and processor: a build that
// draws other bytes than the build before fails here. When a picture is meant to change, the
// message shows the new hash; say in the commit why it changed.
#include "Rendering/Post/EffectPlanes.h"
#include "Rendering/Renderer.h"
#include "Testing/Agreement/RandomScene.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iostream>

namespace limn {
namespace {

using testing::Picture;
using testing::RandomScene;

constexpr std::uint64_t kHashOfScenes = 4481409563840940949u;
constexpr std::uint64_t kHashOfReflections = 2261506406569148229u;
constexpr std::uint64_t kHashOfLights = 13210657878963063253u;
constexpr std::uint64_t kHashOfTextures = 6601808570278293167u;
constexpr std::uint64_t kHashOfTranslucency = 16651314980494972301u;
constexpr std::uint64_t kHashOfPostEffects = 17085701275895408605u;
constexpr std::uint64_t kHashOfLines = 4075793474562834939u;
constexpr std::uint64_t kHashOfLineShares = 14920037556769455317u;
constexpr std::uint64_t kHashOfVeils = 14725471550897955599u;
constexpr std::uint64_t kHashOfLinePixels = 7450183944059899050u;
constexpr std::uint64_t kHashOfImageLines = 12418922405537175232u;
constexpr std::uint64_t kHashOfCreases = 7870372108384718485u;
constexpr std::uint64_t kHashOfIdBorders = 2112306762885223265u;
constexpr std::uint64_t kHashOfCues = 14698238778559541124u;
constexpr std::uint64_t kHashOfShaders = 227987643536633135u;
constexpr std::uint64_t kHashOfTones = 14800548386128781990u;
constexpr std::uint64_t kHashOfDataTones = 5431401692603874508u;
constexpr std::uint64_t kHashOfHatching = 5579474759704979671u;
constexpr std::uint64_t kHashOfExaggeration = 3273500294967713027u;
constexpr std::uint64_t kHashOfCreasedExaggeration = 1093329653533397760u;
constexpr std::uint64_t kHashOfHulls = 16297438070228432309u;

/// FNV-1a, 64 bits.
class Hash {
 public:
  template <class T>
  void add(const std::vector<T>& values)
  {
    for (const T& value : values) {
      unsigned char bytes[sizeof(T)];
      std::memcpy(bytes, &value, sizeof value);
      for (const unsigned char byte : bytes)
        value_ = (value_ ^ byte) * 1099511628211u;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

std::uint64_t hashOfScenes(RandomScene::Detail detail, std::uint32_t scenes = 100)
{
  Hash hash;
  for (std::uint32_t seed = 5000; seed < 5000 + scenes; ++seed) {
    const RandomScene random(seed, detail);
    Picture picture = random.canvas();
    const Status status = render(random.scene(), picture.frame(random.background()));
    EXPECT_TRUE(status.ok()) << status.message;
    hash.add(picture.color);
    hash.add(picture.depth);
    hash.add(picture.coverage);
    hash.add(picture.instance);
    hash.add(picture.cell);
  }
  return hash.value();
}

std::uint64_t hashOfPostEffects()
{
  Hash hash;
  EffectPlanes planes;
  for (std::uint32_t seed = 5000; seed < 5100; ++seed) {
    const RandomScene random(seed, RandomScene::Detail::kPost);
    Picture picture = random.canvas();
    picture.addRadiance();
    const FrameView frame = picture.frame(random.background());
    Status status = render(random.scene(), frame);
    EXPECT_TRUE(status.ok()) << status.message;
    status = applyEffects(random.effects(), random.scene().camera, frame, planes);
    EXPECT_TRUE(status.ok()) << status.message;
    hash.add(picture.color);
    for (const std::vector<float>& plane : picture.radiance)
      hash.add(plane);
  }
  return hash.value();
}

std::uint64_t hashOfLinePixels()
{
  Hash hash;
  for (std::uint32_t seed = 5000; seed < 5100; ++seed) {
    const RandomScene random(seed, RandomScene::Detail::kLines);
    Picture picture = random.canvas();
    FrameView frame = picture.frame(Background::kKeepApart);
    frame.linePixels = &picture.linePixels;
    const Status status = render(random.scene(), frame);
    EXPECT_TRUE(status.ok()) << status.message;
    picture.sortLinePixels();
    hash.add(picture.color);
    hash.add(picture.depth);
    hash.add(picture.coverage);
    // Value by value: there is room between them.
    std::vector<std::uint32_t> values;
    std::vector<Rgba8> colors;
    std::vector<float> depths;
    for (const LinePixel& one : picture.linePixels) {
      values.insert(values.end(), {one.x, one.y, one.samples});
      colors.push_back(one.color);
      depths.push_back(one.depth);
    }
    hash.add(values);
    hash.add(colors);
    hash.add(depths);
  }
  return hash.value();
}

/// Of those that take longest: for each scene all normals are smoothed many times.
constexpr std::uint32_t kExaggeratedScenes = 40;

class SameBytes : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(useTarget(GetParam())); }
  void TearDown() override { useTarget(""); }
};

TEST_P(SameBytes, HundredScenesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kAny);
  std::cout << "hash " << GetParam() << ' ' << hash << '\n';
  std::cout << "kHashOfScenes " << hash << '\n';
  EXPECT_EQ(hash, kHashOfScenes);
}

TEST_P(SameBytes, ReflectionsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kReflections);
  std::cout << "kHashOfReflections " << hash << '\n';
  EXPECT_EQ(hash, kHashOfReflections);
}

TEST_P(SameBytes, LightsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kLights);
  std::cout << "kHashOfLights " << hash << '\n';
  EXPECT_EQ(hash, kHashOfLights);
}

TEST_P(SameBytes, TexturesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kTextures);
  std::cout << "kHashOfTextures " << hash << '\n';
  EXPECT_EQ(hash, kHashOfTextures);
}

TEST_P(SameBytes, TranslucencyHasTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kTranslucent);
  std::cout << "kHashOfTranslucency " << hash << '\n';
  EXPECT_EQ(hash, kHashOfTranslucency);
}

TEST_P(SameBytes, PostEffectsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfPostEffects();
  std::cout << "kHashOfPostEffects " << hash << '\n';
  EXPECT_EQ(hash, kHashOfPostEffects);
}

TEST_P(SameBytes, ImageLinesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kImageLines);
  std::cout << "kHashOfImageLines " << hash << '\n';
  EXPECT_EQ(hash, kHashOfImageLines);
}

TEST_P(SameBytes, CreasesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kCreases);
  std::cout << "kHashOfCreases " << hash << '\n';
  EXPECT_EQ(hash, kHashOfCreases);
}

TEST_P(SameBytes, BordersOfIdsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kIdBorders);
  std::cout << "kHashOfIdBorders " << hash << '\n';
  EXPECT_EQ(hash, kHashOfIdBorders);
}

TEST_P(SameBytes, DepthCuesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kCues);
  std::cout << "kHashOfCues " << hash << '\n';
  EXPECT_EQ(hash, kHashOfCues);
}

TEST_P(SameBytes, HundredScenesWithShadersHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kShaders);
  std::cout << "kHashOfShaders " << hash << '\n';
  EXPECT_EQ(hash, kHashOfShaders);
}

TEST_P(SameBytes, TonesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kTones);
  std::cout << "kHashOfTones " << hash << '\n';
  EXPECT_EQ(hash, kHashOfTones);
}

TEST_P(SameBytes, TonesOverDataHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kDataTones);
  std::cout << "kHashOfDataTones " << hash << '\n';
  EXPECT_EQ(hash, kHashOfDataTones);
}

TEST_P(SameBytes, HatchingHasTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kHatching);
  std::cout << "kHashOfHatching " << hash << '\n';
  EXPECT_EQ(hash, kHashOfHatching);
}

TEST_P(SameBytes, ExaggerationHasTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kExaggerated, kExaggeratedScenes);
  std::cout << "kHashOfExaggeration " << hash << '\n';
  EXPECT_EQ(hash, kHashOfExaggeration);
}

TEST_P(SameBytes, ExaggerationAtCreasesHasTheKnownHash)
{
  const std::uint64_t hash =
      hashOfScenes(RandomScene::Detail::kCreasedExaggeration, kExaggeratedScenes);
  std::cout << "kHashOfCreasedExaggeration " << hash << '\n';
  EXPECT_EQ(hash, kHashOfCreasedExaggeration);
}

TEST_P(SameBytes, HullsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kHulls);
  std::cout << "kHashOfHulls " << hash << '\n';
  EXPECT_EQ(hash, kHashOfHulls);
}

TEST_P(SameBytes, LinesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kLines);
  std::cout << "kHashOfLines " << hash << '\n';
  EXPECT_EQ(hash, kHashOfLines);
}

TEST_P(SameBytes, LineSharesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kLineShares);
  std::cout << "kHashOfLineShares " << hash << '\n';
  EXPECT_EQ(hash, kHashOfLineShares);
}

TEST_P(SameBytes, VeiledLinesHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfScenes(RandomScene::Detail::kVeils);
  std::cout << "kHashOfVeils " << hash << '\n';
  EXPECT_EQ(hash, kHashOfVeils);
}

TEST_P(SameBytes, LinePixelsHaveTheKnownHash)
{
  const std::uint64_t hash = hashOfLinePixels();
  std::cout << "kHashOfLinePixels " << hash << '\n';
  EXPECT_EQ(hash, kHashOfLinePixels);
}

INSTANTIATE_TEST_SUITE_P(Targets, SameBytes, ::testing::ValuesIn(availableTargets()),
                         [](const auto& target) { return target.param; });

}  // namespace
}  // namespace limn
