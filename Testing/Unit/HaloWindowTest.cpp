// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Halos that come from outside of the frame.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace limn::testing {
namespace {

class HaloWindows : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(HaloWindows);

/// But for rounding.
bool areLike(Rgba8 a, Rgba8 b)
{
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= 2;
}

/// A scene in a picture of kSide x kSide pixels and in a window of that, with halos and without.
class HaloedScene {
 public:
  static constexpr int kSide = 160;

  explicit HaloedScene(std::uint32_t seed) : random_(seed, RandomScene::Detail::kLines)
  {
    Random number(seed);
    const auto below = [&](int end) {
      return static_cast<int>(number.below(static_cast<std::uint32_t>(end)));
    };
    width_ = 20 + below(60);
    height_ = 20 + below(60);
    left_ = below(kSide - width_);
    bottom_ = below(kSide - height_);
    const Span<const Instance> all = random_.scene().instances;
    lines_.reserve(all.size());
    for (const Instance& instance : all) {
      bare_.push_back(instance);
      // Other cues are of the picture's size, and bridged gaps may end anywhere outside.
      bare_.back().style.cues = {};
      lines_.emplace_back(instance.lines.begin(), instance.lines.end());
      for (LineSet& set : lines_.back())
        if (!set.slack.empty()) set.flags = {};
      bare_.back().lines = lines_.back();
      haloed_.push_back(bare_.back());
      Halo& halo = haloed_.back().style.cues.halo;
      halo.width = static_cast<float>(number.between(1, 16));
      halo.depth = static_cast<float>(number.between(0.05, 2));
      halo.color = number.color();
    }
  }

  struct Count {
    std::size_t haloed = 0;  ///< pixels of the window's outermost that halos change
    std::size_t unlike = 0;  ///< that differ from those of the picture, though they do not without
  };
  Count compare(Backend backend) const
  {
    const Picture window = draw(haloed_, true, backend), picture = draw(haloed_, false, backend);
    const Picture bareWindow = draw(bare_, true, backend), bare = draw(bare_, false, backend);
    Count count;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const Rgba8 here = at(window, x, y), hereBare = at(bareWindow, x, y);
        const bool isOutermost = x == 0 || y == 0 || x == width_ - 1 || y == height_ - 1;
        if (isOutermost && !areLike(here, hereBare)) ++count.haloed;
        if (areLike(hereBare, at(bare, x + left_, y + bottom_)) &&
            !areLike(here, at(picture, x + left_, y + bottom_)))
          ++count.unlike;
      }
    return count;
  }

 private:
  Picture draw(const std::vector<Instance>& instances, bool isWindow, Backend backend) const
  {
    Scene scene = random_.scene();
    scene.instances = instances;
    Picture picture(isWindow ? width_ : kSide, isWindow ? height_ : kSide);
    if (isWindow) {
      const double sx = double{kSide} / width_, sy = double{kSide} / height_;
      const Mat4d window = {{{sx, 0, 0, sx - 2.0 * left_ / width_ - 1},
                             {0, sy, 0, sy - 2.0 * bottom_ / height_ - 1},
                             {0, 0, 1, 0},
                             {0, 0, 0, 1}}};
      scene.camera.viewToClip = window * scene.camera.viewToClip;
    }
    const Status status = render(scene, picture.frame(Background::kBlend), {backend, 2});
    EXPECT_TRUE(status.ok()) << status.message;
    return picture;
  }

  RandomScene random_;
  std::vector<std::vector<LineSet>> lines_;
  std::vector<Instance> bare_, haloed_;
  int width_, height_, left_, bottom_;
};

TEST_P(HaloWindows, AreCutFromALargerPicture)
{
  const std::uint32_t scenes = GetParam() == Backend::kPipeline ? 60 : 20;
  std::size_t unlike = 0, haloed = 0;
  for (std::uint32_t seed = 0; seed < scenes; ++seed) {
    const HaloedScene::Count count = HaloedScene(seed).compare(GetParam());
    unlike += count.unlike;
    haloed += count.haloed;
  }
  EXPECT_GT(haloed, 10u * scenes);
  EXPECT_LE(unlike, 1u) << "where rounding decides";
}

}  // namespace
}  // namespace limn::testing
