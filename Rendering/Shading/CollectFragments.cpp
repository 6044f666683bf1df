// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/FragmentList.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/CollectFragments.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Shading/CollectFragments-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(collectFragmentsKernel);

void FragmentList::reserve(int samples)
{
  const std::size_t most =
      static_cast<std::size_t>(kTilePixels) * static_cast<std::size_t>(samples);
  const std::size_t room = most + HWY_MAX_BYTES / sizeof(std::uint32_t);
  if (owner.size() >= room) return;
  owner.resize(room);
  pixel.resize(room);
  coverage.resize(room);
}

void FragmentList::addRun(std::uint32_t runOwner, int firstPixel, int length)
{
  if (triangleCount == 0) place_.fill(FragmentRun::kNone);
  constexpr std::uint32_t kGoldenRatio = 0x9E3779B9u;
  std::size_t at = (runOwner * kGoldenRatio) >> (32 - kPlaceBits);
  while (place_[at] != FragmentRun::kNone && triangleOwner[place_[at]] != runOwner)
    at = (at + 1) % kPlaces;
  if (place_[at] == FragmentRun::kNone) {
    triangleOwner[triangleCount] = runOwner;
    firstRun[triangleCount] = FragmentRun::kNone;
    place_[at] = static_cast<std::uint16_t>(triangleCount++);
  }
  std::uint16_t& head = firstRun[place_[at]];
  run[runCount] = {static_cast<std::uint16_t>(firstPixel), static_cast<std::uint16_t>(length),
                   head};
  head = static_cast<std::uint16_t>(runCount++);
}

void FragmentList::breakRuns(std::size_t triangle, int samples)
{
  for (std::uint16_t r = firstRun[triangle]; r != FragmentRun::kNone; r = run[r].next) {
    for (int i = 0; i < run[r].length; ++i) {
      owner[count] = triangleOwner[triangle];
      pixel[count] = static_cast<std::uint32_t>(run[r].pixel + i);
      coverage[count++] = static_cast<std::uint16_t>((1u << samples) - 1u);
    }
    run[r].length = 0;
  }
}

void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      bool byRuns, FragmentList& fragments)
{
  fragments.reserve(samples);
  fragments.count = fragments.runCount = fragments.triangleCount = 0;
  HWY_DYNAMIC_DISPATCH(collectFragmentsKernel)(tile, pixels, samples, byRuns, fragments);
}

}  // namespace limn
#endif  // HWY_ONCE
