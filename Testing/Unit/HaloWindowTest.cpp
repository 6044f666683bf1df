// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Halos that come from outside of the frame.
#include "Testing/Unit/SceneWindow.h"

namespace limn::testing {
namespace {

class HaloWindows : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(HaloWindows);

SceneWindow::Count compareHaloed(std::uint32_t seed, Backend backend)
{
  Random number(seed);
  const SceneWindow window(seed, number);
  std::vector<Instance> haloed = window.instances();
  // Other cues are of the picture's size.
  for (Instance& instance : haloed)
    instance.style.cues = {};
  const std::vector<Instance> bare = haloed;
  for (Instance& instance : haloed) {
    Halo& halo = instance.style.cues.halo;
    halo.width = static_cast<float>(number.between(1, 16));
    halo.depth = static_cast<float>(number.between(0.05, 2));
    halo.color = number.color();
  }
  return window.compare(haloed, bare, backend);
}

TEST_P(HaloWindows, AreCutFromALargerPicture)
{
  const std::uint32_t scenes = GetParam() == Backend::kPipeline ? 60 : 20;
  std::size_t unlike = 0, haloed = 0;
  for (std::uint32_t seed = 0; seed < scenes; ++seed) {
    const SceneWindow::Count count = compareHaloed(seed, GetParam());
    unlike += count.unlike;
    haloed += count.outermost;
  }
  EXPECT_GT(haloed, 10u * scenes);
  EXPECT_LE(unlike, 1u) << "where rounding decides";
}

}  // namespace
}  // namespace limn::testing
