// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tests of outlines from the picture draw.
#pragma once

#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::testing {

inline constexpr double kPi = 3.14159265358979323846;

/// A white surface with a black line.
inline Instance outlined(const OwnedMesh& mesh, float width, std::uint32_t id = 0)
{
  Instance instance = painted(mesh, {1, 1, 1}, id);
  instance.style.imageOutline.detector = OutlineDetector::kPlane;
  instance.style.outlineWidth = width;
  return instance;
}

/// Stage of one unit a pixel with plain averages, over white.
inline Stage flatStage(int side, int samples)
{
  Stage stage = pixelStage(side, samples);
  stage.resolve = Resolve::kLinear;
  return stage;
}

inline Picture drawOverWhite(const Stage& stage, Backend backend,
                             Background background = Background::kBlend)
{
  Picture picture(stage.width, stage.height);
  std::fill(picture.color.begin(), picture.color.end(), Rgba8{255, 255, 255, 255});
  stage.drawOver(picture, backend, background);
  return picture;
}

inline double darknessOf(Rgba8 color)
{
  return (255.0 - color.g) / 255.0;
}

/// Checks the middle of a picture of 64 x 64 pixels, in which a line three pixels wide runs through
/// `middle`: it is black inside and has as much ink as it is long and wide.
inline void expectEvenLine(const Picture& picture, Vec3d middle, double degrees)
{
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  double sum = 0;
  for (int y = 12; y < 52; ++y)
    for (int x = 12; x < 52; ++x) {
      const double off = std::fabs((x + 0.5 - middle.x) * -s + (y + 0.5 - middle.y) * c);
      if (off < 1.5 - 0.75) {
        EXPECT_EQ(at(picture, x, y).g, 0) << x << ", " << y << " at " << degrees;
      }
      if (off < 3) sum += darknessOf(at(picture, x, y));
    }
  EXPECT_NEAR(sum, 3 * 40 / c, 3 * 40 / c * 0.02) << "at " << degrees;
}

/// A disc of many triangles.
inline OwnedMesh disc(Vec3d middle, double radius)
{
  std::vector<Vec3d> points;
  constexpr int kSides = 720;
  for (int i = 0; i < kSides; ++i) {
    const auto at = [&](int k) {
      const double angle = 2 * kPi * k / kSides;
      return middle + Vec3d{std::cos(angle), std::sin(angle), 0} * radius;
    };
    points.insert(points.end(), {middle, at(i), at(i + 1)});
  }
  return soup(points);
}

/// Half of the picture's plane, whose border passes the picture's middle, `shift` above it.
inline OwnedMesh halfPlane(int side, double degrees, double shift, double z = 0)
{
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  const Vec3d middle = {side / 2.0, side / 2.0 + shift, z}, along = {120 * c, 120 * s, 0},
              below = {120 * s, -120 * c, 0};
  return sheet(middle - along + below, along * 2.0, below * -1.0);
}

}  // namespace limn::testing
