// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines from the finished picture where pipes cut each other: along the known curve, out to where
// it goes over into outlines, and without leaps as the pipes turn.
#include "Testing/Unit/OutlinedScene.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::testing {
namespace {

class CutPipes : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(CutPipes);

constexpr int kSide = 160;

/// Unit vectors across a pipe, and along it.
struct PipeAxes {
  Vec3d u, v, along;
};

/// An open pipe of facets with smooth normals, along its third axis.
OwnedMesh pipe(double radius, double half, const PipeAxes& axes, Vec3d middle = {0, 0, 0})
{
  constexpr std::uint32_t kFacets = 240;
  OwnedMesh mesh;
  for (std::uint32_t i = 0; i < kFacets; ++i) {
    const double angle = 2 * kPi * i / kFacets;
    const Vec3d normal = axes.u * std::cos(angle) + axes.v * std::sin(angle);
    for (const double end : {-half, half}) {
      mesh.positions.push_back(vec3Cast<float>(middle + normal * radius + axes.along * end));
      mesh.vertexNormals.push_back(vec3Cast<float>(normal));
    }
  }
  for (std::uint32_t i = 0; i < kFacets; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kFacets);
    mesh.triangles.push_back({{a, b, b + 1}});
    mesh.triangles.push_back({{a, b + 1, a + 1}});
  }
  finish(mesh);
  return mesh;
}

Instance lined(const OwnedMesh& mesh, float width, std::uint32_t id)
{
  Instance instance = outlined(mesh, width, id);
  instance.style.normals = NormalSource::kVertex;
  return instance;
}

/// One unit a pixel, about the origin.
Stage stageOf(int samples)
{
  Stage stage;
  stage.width = stage.height = kSide;
  stage.resolve = Resolve::kLinear;
  stage.samples = samples;
  stage.view = parallelView({0, 0, 400}, {0, 0, 0}, kSide / 2.0, {1, 900});
  return stage;
}

/// Two equal pipes that cross at right angles, turned in the picture's plane: they cut each other
/// along the two straight lines between, as they are seen, which end where the outlines meet.
TEST_P(CutPipes, HaveLinesAlongTheKnownCurveUpToItsEnds)
{
  const double radius = 37.3;
  const bool isFast = GetParam() == Backend::kPipeline;
  for (const int samples : isFast ? std::vector<int>{1, 4, 8} : std::vector<int>{4})
    for (const double degrees : {0.0, 7.0, 31.0}) {
      const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
      const Vec3d a = {c, s, 0}, b = {-s, c, 0}, z = {0, 0, 1};
      const OwnedMesh first = pipe(radius, 200, {b, z, a}), second = pipe(radius, 200, {a, z, b});
      constexpr float kWidth = 6;
      Stage stage = stageOf(samples);
      stage.instances = {lined(first, kWidth, 1), lined(second, kWidth, 2)};
      const Picture picture = drawOverWhite(stage, GetParam());
      double ink = 0, length = 0;
      constexpr int kMargin = 10;  // where lines may come from beyond the picture
      for (int y = kMargin; y < kSide - kMargin; ++y)
        for (int x = kMargin; x < kSide - kMargin; ++x) {
          // By what is seen, in the first quarter of the pipes' own axes.
          const double px = x + 0.5 - kSide / 2.0, py = y + 0.5 - kSide / 2.0;
          const double u = std::fabs(px * c + py * s), v = std::fabs(py * c - px * s);
          const double most = std::max(u, v), least = std::min(u, v);
          const double toCut = (most - least) / std::sqrt(2.0),
                       along = (most + least) / std::sqrt(2.0);
          if (along < 3) continue;  // where the surfaces touch
          // Where both outlines and the cut meet; there lines may end a little sooner or later.
          const bool isAtEnd = std::hypot(most - radius, least - radius) < 8;
          const double toOutline = least < radius ? radius - least : -HUGE_VAL;
          const double corner = radius * std::sqrt(2.0);
          const double far = along > corner ? std::hypot(toCut, along - corner) : toCut;
          // How far inside of the line's ideal area.
          double inside = kWidth / 2 - far;
          if (most > radius) inside = std::max(inside, kWidth - std::fabs(toOutline));
          if (toOutline < (isAtEnd ? 2 : 0.7)) continue;  // the background and its border
          const int seen = at(picture, x, y).g;
          if (inside > (isAtEnd ? 2.5 : 1.2)) {
            EXPECT_LE(seen, 40) << x << ", " << y << " of " << samples << " at " << degrees;
          } else if (inside < (isAtEnd ? -2.5 : -1.5)) {
            EXPECT_EQ(seen, 255) << x << ", " << y << " of " << samples << " at " << degrees;
          }
          if (along > 6 && along < corner - 16 && toCut < kWidth) {
            ink += darknessOf(at(picture, x, y));
          }
        }
      length = 4 * (radius * std::sqrt(2.0) - 16 - 6);
      EXPECT_NEAR(ink / (length * kWidth), 1, 0.05) << samples << " at " << degrees;
    }
}

/// How many pixels of a picture are by a third of black and white off the mean of what they are in
/// the pictures before and after it: not those of lines that move by less than a third of a pixel.
int leapsOf(const Picture& before, const Picture& picture, const Picture& after)
{
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto dark = [&](const Picture& of) { return darknessOf(at(of, x, y)); };
      count += std::fabs(dark(picture) - (dark(before) + dark(after)) / 2) > 0.33 ? 1 : 0;
    }
  return count;
}

TEST_P(CutPipes, DoNotFlickerAsTheyTurn)
{
  const bool isFast = GetParam() == Backend::kPipeline;
  constexpr double kStep = 0.05;
  std::vector<Picture> pictures;
  for (int frame = 0; frame < (isFast ? 32 : 6); ++frame) {
    const double angle = frame * kStep * kPi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec3d x = {c, 0, -s}, y = {0, 1, 0}, z = {s, 0, c};
    const OwnedMesh first = pipe(36, 200, {x, z, y}), second = pipe(36, 200, {y, z, x});
    Stage stage = stageOf(4);
    stage.view = parallelView({0, 120, 380}, {0, 0, 0}, kSide / 2.0, {1, 900});
    stage.instances = {lined(first, 4, 1), lined(second, 4, 2)};
    pictures.push_back(drawOverWhite(stage, GetParam()));
  }
  int leaps = 0;
  for (std::size_t i = 1; i + 1 < pictures.size(); ++i)
    leaps += leapsOf(pictures[i - 1], pictures[i], pictures[i + 1]);
  EXPECT_LE(leaps, 2 * static_cast<int>(pictures.size()));
}

// What is drawn by two and by one alike, with all that may be beside it.
TEST(CutPipe, IsTheSameInBothBackends)
{
  for (const int samples : {1, 4, 8})
    for (const int bare : {-1, 0, 1}) {
      const double c = std::cos(0.3), s = std::sin(0.3);
      const Vec3d x = {c, s, 0}, y = {-s * 0.8, c * 0.8, -0.6}, z = {-s * 0.6, c * 0.6, 0.8};
      const OwnedMesh first = pipe(30, 200, {x, z, y}), second = pipe(21.5, 200, {y, z, x}),
                      third = pipe(9, 30, {x, y, z}, z * 20.0);
      if (samples != 4 && bare >= 0) continue;
      Stage stage = stageOf(samples);
      stage.width = stage.height = 96;
      stage.instances = {lined(first, 4, 1), lined(second, 7, 2), lined(third, 3, 3)};
      if (bare >= 0) stage.instances[static_cast<std::size_t>(bare)].style.imageOutline = {};
      const Picture picture = drawOverWhite(stage, Backend::kPipeline);
      EXPECT_EQ(drawOverWhite(stage, Backend::kReference).differingPixels(picture), 0u)
          << samples << " samples, without line " << bare;
    }
}

}  // namespace
}  // namespace limn::testing
