// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/Executor.h"
#include "Rendering/Renderer.h"
#include "Testing/Agreement/RandomScene.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using testing::drawn;
using testing::Picture;
using testing::RandomScene;

TEST(Threads, AnyNumberDrawsTheSamePicture)
{
  for (std::uint32_t seed = 1000; seed < 1040; ++seed) {
    const RandomScene random(seed);
    const Picture one = drawn(random, {Backend::kPipeline, 1});
    for (const int threads : {2, 3, 8})
      ASSERT_EQ(drawn(random, {Backend::kPipeline, threads}).differingPixels(one), 0u)
          << "seed " << seed << ", " << threads << " threads";
  }
}

// With all threads of the caller's, a thread that waits for a frame could begin another.
TEST(Threads, LoopsOfFramesDrawTheSamePictures)
{
  constexpr std::uint32_t kFirst = 1000;
  constexpr std::size_t kFrames = 100;
  const auto sceneOf = [](std::size_t i) {
    return RandomScene(kFirst + static_cast<std::uint32_t>(i), RandomScene::Detail::kImageLines);
  };
  std::vector<Picture> looped(kFrames, Picture(1, 1));
  parallelFor(8, kFrames, [&](std::size_t i) { looped[i] = drawn(sceneOf(i), {}); });
  for (std::size_t i = 0; i < kFrames; ++i)
    ASSERT_EQ(drawn(sceneOf(i), {Backend::kPipeline, 1}).differingPixels(looped[i]), 0u) << i;
}

}  // namespace
}  // namespace limn
