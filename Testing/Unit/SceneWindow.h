// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace limn::testing {

/// A random scene in a picture of kSide x kSide pixels and in a window of that, drawn with
/// something and without.
class SceneWindow {
 public:
  static constexpr int kSide = 160;

  /// Where the window lies comes from `number`.
  SceneWindow(std::uint32_t seed, Random& number) : random_(seed, RandomScene::Detail::kLines)
  {
    const auto below = [&](int end) {
      return static_cast<int>(number.below(static_cast<std::uint32_t>(end)));
    };
    width_ = 20 + below(60);
    height_ = 20 + below(60);
    left_ = below(kSide - width_);
    bottom_ = below(kSide - height_);
    const Span<const Instance> all = random_.scene().instances;
    instances_.assign(all.begin(), all.end());
    lines_.reserve(all.size());
    for (Instance& instance : instances_) {
      lines_.emplace_back(instance.lines.begin(), instance.lines.end());
      // Gaps that are bridged may end anywhere outside.
      for (LineSet& set : lines_.back())
        if (!set.slack.empty()) set.flags = {};
      instance.lines = lines_.back();
    }
  }
  SceneWindow(const SceneWindow&) = delete;
  SceneWindow& operator=(const SceneWindow&) = delete;

  /// The scene's, with lines of which no gaps are bridged.
  const std::vector<Instance>& instances() const { return instances_; }

  struct Count {
    std::size_t changed = 0;    ///< pixels of the window that differ with and without
    std::size_t outermost = 0;  ///< of these, at its border
    std::size_t unlike = 0;     ///< that differ from those of the picture, only with
  };
  Count compare(const std::vector<Instance>& with, const std::vector<Instance>& without,
                Backend backend) const
  {
    const Picture window = draw(with, true, backend), picture = draw(with, false, backend);
    const Picture bareWindow = draw(without, true, backend), bare = draw(without, false, backend);
    Count count;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        const Rgba8 here = at(window, x, y), hereBare = at(bareWindow, x, y);
        const bool isOutermost = x == 0 || y == 0 || x == width_ - 1 || y == height_ - 1;
        if (!areLike(here, hereBare)) {
          ++count.changed;
          if (isOutermost) ++count.outermost;
        }
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
  /// But for rounding.
  static bool areLike(Rgba8 a, Rgba8 b)
  {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) <= 2;
  }

  RandomScene random_;
  std::vector<std::vector<LineSet>> lines_;
  std::vector<Instance> instances_;
  int width_, height_, left_, bottom_;
};

}  // namespace limn::testing
