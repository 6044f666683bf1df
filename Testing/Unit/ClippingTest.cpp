// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Near and far plane, the eye's plane and the window's borders, against rays.
#include "Testing/Unit/TestScene.h"

#include "Rendering/Base/SamplePositions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn::testing {
namespace {

class Clipping : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Clipping);

/// The floor y = 0 from above, running from behind the eye to beyond the far plane.
Stage floorStage(const OwnedMesh& mesh, int samples)
{
  Stage stage;
  stage.view = perspectiveView({0, 1, 0}, {0, 0.8, -1}, 60, {1.6, 5});
  stage.instances = {painted(mesh, {1, 1, 1})};
  stage.samples = samples;
  return stage;
}

TEST_P(Clipping, EachSampleIsCutAtTheNearAndAtTheFarPlane)
{
  const OwnedMesh mesh = sheet({-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  for (const int samples : {1, 2, 4, 8}) {
    const Stage stage = floorStage(mesh, samples);
    const Picture picture = draw(stage);
    const Axes axes = axesOf(stage.view);
    const auto visible = [&](double x, double y) {
      const Ray ray = stage.ray(x, y);
      if (ray.direction.y >= 0) return false;
      const double depth = dot(axes.back, ray.direction * (ray.origin.y / ray.direction.y));
      return depth >= stage.view.near && depth <= stage.view.far;
    };
    int inside = 0, outside = 0;
    for (int y = 0; y < stage.height; ++y)
      for (int x = 0; x < stage.width; ++x)
        for (int s = 0; s < samples; ++s) {
          const SampleOffset o = samplePositions(samples)[static_cast<std::size_t>(s)];
          const double sx = x + o.x / 256.0, sy = y + o.y / 256.0;
          // Snapping decides within 1/100 pixel.
          if (visible(sx, sy - 0.01) != visible(sx, sy + 0.01)) continue;
          const bool drawn =
              (picture.coverage[static_cast<std::size_t>(y * stage.width + x)] >> s & 1) != 0;
          ASSERT_EQ(drawn, visible(sx, sy)) << "sample " << s << " of " << x << ", " << y;
          ++(drawn ? inside : outside);
        }
    EXPECT_GT(inside, 1000 * samples);
    EXPECT_GT(outside, 1000 * samples);
  }
}

TEST_P(Clipping, ParallelProjectionIsCutToo)
{
  const OwnedMesh mesh = sheet({-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  Stage stage = floorStage(mesh, 1);
  stage.view.parallel = true;
  stage.view.halfHeight = 2;
  const Picture picture = draw(stage);
  const Axes axes = axesOf(stage.view);
  for (int y = 0; y < stage.height; ++y) {
    const Ray ray = stage.ray(48.5, y + 0.5);
    const Vec3d p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
    const double depth = -dot(axes.back, p - stage.view.eye);
    if (std::fabs(depth - 1.6) < 0.01 || std::fabs(depth - 5) < 0.01) continue;
    EXPECT_EQ(covered(picture, 48, y), depth > 1.6 && depth < 5) << "row " << y;
  }
}

using Corners = std::array<Vec3d, 3>;

/// Whether a ray meets a triangle between the near and the far plane.
bool meets(const Stage& stage, const Corners& c, double x, double y)
{
  const Ray ray = stage.ray(x, y);
  const Vec3d normal = cross(c[1] - c[0], c[2] - c[0]);
  const double along = dot(normal, c[0] - ray.origin) / dot(normal, ray.direction);
  const Vec3d p = ray.origin + ray.direction * along;
  const double depth = -dot(axesOf(stage.view).back, p - stage.view.eye);
  if (!(depth >= stage.view.near && depth <= stage.view.far)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(normal, cross(c[(i + 1) % 3] - c[i], p - c[i])) < 0) return false;
  return true;
}

TEST_P(Clipping, TrianglesThroughTheEyesPlaneCoverWhatRaysMeet)
{
  Random random(7);
  int behind = 0, coveredPixels = 0;
  for (int i = 0; i < 60; ++i) {
    Stage stage;
    stage.width = stage.height = 48;
    stage.view = perspectiveView({0.1, 0.2, 0.4}, {0, 0, -1}, 70, {0.05, 20});
    const Corners corners = {random.inBox(2), random.inBox(2), random.inBox(2)};
    const Axes axes = axesOf(stage.view);
    for (const Vec3d& c : corners)
      behind += dot(axes.back, c - stage.view.eye) > 0;
    const OwnedMesh mesh = soup({corners[0], corners[1], corners[2]});
    stage.instances = {painted(mesh, {1, 1, 1})};
    const Picture picture = draw(stage);
    const Corners drawn = {vec3Cast<double>(mesh.positions[0]), vec3Cast<double>(mesh.positions[1]),
                           vec3Cast<double>(mesh.positions[2])};
    for (int y = 0; y < stage.height; ++y)
      for (int x = 0; x < stage.width; ++x) {
        const bool expected = meets(stage, drawn, x + 0.5, y + 0.5);
        // Within 1/50 pixel of a border, snapping decides.
        const bool atBorder = meets(stage, drawn, x + 0.52, y + 0.5) != expected ||
                              meets(stage, drawn, x + 0.48, y + 0.5) != expected ||
                              meets(stage, drawn, x + 0.5, y + 0.52) != expected ||
                              meets(stage, drawn, x + 0.5, y + 0.48) != expected;
        if (atBorder) continue;
        ASSERT_EQ(covered(picture, x, y), expected)
            << "triangle " << i << " pixel " << x << ", " << y;
        coveredPixels += expected;
      }
  }
  EXPECT_GT(behind, 50);
  EXPECT_GT(coveredPixels, 5000);
}

TEST_P(Clipping, AttributesOfClippedTrianglesStayPerspectiveCorrect)
{
  OwnedMesh mesh = sheet({-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  // Red from 0 at z = 50, behind the eye, to 255 at z = -50.
  mesh.vertexColors = {{0, 0, 0, 255}, {0, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}};
  Stage stage = floorStage(mesh, 1);
  stage.view.far = 100;
  const auto seen = [&](const Ray& ray) -> std::optional<Hit> {
    if (ray.direction.y >= 0) return std::nullopt;
    const Vec3d p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
    if (-dot(axesOf(stage.view).back, p - stage.view.eye) < 1.61) return std::nullopt;
    return Hit{p, {0, 1, 0}, -ray.direction};
  };
  const auto red = [](const Hit& hit) { return Vec3d{(50 - hit.position.z) / 100, 0, 0}; };
  expectPicture(stage, draw(stage), seen, red, kRounding + 0.05);
}

TEST_P(Clipping, WhatLiesWhollyOutsideIsNotDrawn)
{
  const Vec3d places[] = {{0, 0, 3.5}, {0, 0, 9}, {0, 0, -30}, {9, 0, 0},
                          {-9, 0, 0},  {0, 9, 0}, {0, -9, 0}};
  for (const Vec3d& place : places) {
    Stage stage;
    stage.instances = {painted(fineSphere(), {1, 1, 1})};
    stage.instances[0].modelToWorld = translation(place);
    stage.instances[0].modelToWorld.m[0][0] = 0.2;
    stage.instances[0].modelToWorld.m[1][1] = 0.2;
    stage.instances[0].modelToWorld.m[2][2] = 0.2;
    for (const std::uint8_t coverage : draw(stage).coverage)
      ASSERT_EQ(coverage, 0);
  }
}

}  // namespace
}  // namespace limn::testing
