// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programs for the colour of visible points: what they are told, and what is drawn of their answer.
#include "Rendering/SurfaceShader.h"
#include "Testing/Unit/TestScene.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace limn::testing {
namespace {

class SurfaceShaders : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(SurfaceShaders);

/// One fragment after the other.
template <class Color>
class PointwiseShader final : public SurfaceShader {
 public:
  explicit PointwiseShader(Color color) : color_(color) {}
  void shade(const SurfaceFragments& fragments, const SurfaceLighting&,
             FragmentVectors& colors) const override
  {
    for (int i = 0; i < fragments.count; ++i)
      colors.set(i, color_(fragments, i));
  }

 private:
  Color color_;
};

class Lambert final : public SurfaceShader {
 public:
  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
             FragmentVectors& colors) const override
  {
    FragmentVectors sums = {};
    for (std::size_t l = 0; l < lighting.lights.size(); ++l) {
      FragmentVectors towards;
      float falls[FragmentVectors::kCapacity];
      lighting.arrive(l, fragments, towards, falls);
      for (int i = 0; i < fragments.count; ++i) {
        const float nl = dot(fragments.normal[i], towards[i]);
        if (nl > 0) sums.set(i, sums[i] + lighting.lights[l].color * (falls[i] * nl));
      }
    }
    for (int i = 0; i < fragments.count; ++i)
      colors.set(
          i, fragments.ambient[i] * lighting.scene.ambientLight + sums[i] * fragments.diffuse[i]);
  }
};

class BuiltIn final : public SurfaceShader {
 public:
  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
             FragmentVectors& colors) const override
  {
    lighting.light(fragments, colors);
  }
};

class HalfDiffuse final : public SurfaceShader {
 public:
  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
             FragmentVectors& colors) const override
  {
    FragmentVectors half;
    for (int i = 0; i < fragments.count; ++i)
      half.set(i, fragments.diffuse[i] * 0.5f);
    SurfaceFragments darker = fragments;
    darker.diffuse = half;
    lighting.light(darker, colors);
  }
};

Light lamp(LightKind kind, Vec3d position)
{
  Light light;
  light.kind = kind;
  light.position = position;
  light.direction = -position;
  light.color = {1, 0.5f, 0.75f};
  return light;
}

/// A glossy sphere and a sheet behind it, under a light of each kind.
Stage litStage(const OwnedMesh& sheet)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.samples = 4;
  stage.ambientLight = {0.2f, 0.3f, 0.1f};
  stage.lights = {lamp(LightKind::kDirectional, {1, 2, 3}), lamp(LightKind::kPoint, {-1, 2, 2}),
                  lamp(LightKind::kSpot, {2, 0, 2}), lamp(LightKind::kHeadlight, {0, 0, 1})};
  stage.instances = {instanceOf(sheet), instanceOf(fineSphere())};
  for (Instance& instance : stage.instances) {
    instance.material.ambient = 0.3f;
    instance.material.diffuse = 0.4f;
    instance.material.specular = 0.5f;
    instance.material.specularPower = 13;
  }
  return stage;
}
Picture drawnBy(Stage stage, const SurfaceShader& shader, Backend backend)
{
  for (Instance& instance : stage.instances)
    instance.style.surfaceShader = &shader;
  return stage.draw(backend);
}

OwnedMesh backdrop()
{
  return sheet({-2, -2, -1}, {4, 0, 0}, {0, 4, 0}, 3);
}

TEST_P(SurfaceShaders, NormalsOfASphereAreThoseOfView)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return fragments.normal[i] * 0.5f + Vec3f{0.5f, 0.5f, 0.5f};
  });
  const auto [right, up, back] = axesOf(stage.view);
  const auto normals = [right = right, up = up, back = back](const Hit& hit) {
    return Vec3d{0.5, 0.5, 0.5} +
           Vec3d{dot(hit.normal, right), dot(hit.normal, up), dot(hit.normal, back)} * 0.5;
  };
  expectPicture(stage, drawnBy(stage, shader, GetParam()), hitSphere, normals, kRounding + kFacets);
}

TEST_P(SurfaceShaders, StripesOfDepthLieWhereTheEyesDistanceSays)
{
  const OwnedMesh plane = sheet({-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
  Stage stage;
  stage.view.eye = {0, -2, 2};
  stage.instances = {instanceOf(plane)};
  const auto stripe = [](auto depth) {
    const auto bands = depth * 4;
    return bands - std::floor(bands);
  };
  const PointwiseShader shader([&](const SurfaceFragments& fragments, int i) {
    const float depth = -fragments.position[i].z;
    return Vec3f{stripe(depth) < 0.5f ? 1.0f : 0.0f, 0, depth / 8};
  });
  const Vec3d back = axesOf(stage.view).back;
  const auto bands = [&](const Hit& hit) -> std::optional<Vec3d> {
    const double depth = dot(stage.view.eye - hit.position, back), s = stripe(depth);
    if (std::fabs(s - 0.5) < 0.01 || s < 0.01 || s > 0.99) return std::nullopt;
    return Vec3d{s < 0.5 ? 1.0 : 0.0, 0, depth / 8};
  };
  expectPicture(stage, drawnBy(stage, shader, GetParam()), hitPlane, bands, kRounding + 0.05);
}

TEST_P(SurfaceShaders, LambertByHandIsTheBuiltInToTheByte)
{
  const OwnedMesh behind = backdrop();
  const Stage stage = litStage(behind);
  EXPECT_EQ(drawnBy(stage, Lambert(), GetParam()).differingPixels(stage.draw(GetParam())), 0u);
}

TEST_P(SurfaceShaders, TheBuiltInModelIsWhatIsDrawnWithoutAShader)
{
  const OwnedMesh behind = backdrop();
  Stage stage = litStage(behind);
  for (const Reflection reflection : {Reflection::kAsVtk, Reflection::kNone, Reflection::kLambert,
                                      Reflection::kBlinnPhong, Reflection::kPhong})
    for (const Tone tone : {Tone::kNone, Tone::kGooch}) {
      for (Instance& instance : stage.instances) {
        instance.style.reflection = reflection;
        instance.style.tone = tone;
      }
      EXPECT_EQ(drawnBy(stage, BuiltIn(), GetParam()).differingPixels(stage.draw(GetParam())), 0u)
          << static_cast<int>(reflection);
    }
}

TEST_P(SurfaceShaders, TheBuiltInModelTakesOtherReflectances)
{
  const OwnedMesh behind = backdrop();
  Stage stage = litStage(behind);
  for (Instance& instance : stage.instances)
    instance.style.reflection = Reflection::kBlinnPhong;
  const Picture shaded = drawnBy(stage, HalfDiffuse(), GetParam());
  const Picture bright = stage.draw(GetParam());
  EXPECT_GT(shaded.differingPixels(bright), 3000u);
  for (Instance& instance : stage.instances)
    instance.material.diffuse *= 0.5f;
  EXPECT_EQ(shaded.differingPixels(stage.draw(GetParam())), 0u);
}

TEST_P(SurfaceShaders, DataColorsAreReflectances)
{
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 2);
  mesh.vertexColors.assign(mesh.positions.size(), {10, 200, 90, 255});
  Stage stage;
  stage.instances = {instanceOf(mesh)};
  const PointwiseShader shader(
      [](const SurfaceFragments& fragments, int i) { return fragments.diffuse[i]; });
  const Rgba8 color = at(drawnBy(stage, shader, GetParam()), 48, 48);
  EXPECT_EQ(color.r, 10);
  EXPECT_EQ(color.g, 200);
  EXPECT_EQ(color.b, 90);
}

TEST_P(SurfaceShaders, ModelPositionsAreThoseOfTheMeshWhereverItStands)
{
  const OwnedMesh far = [] {
    OwnedMesh mesh = sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
    for (const Vec3f p : mesh.positions)
      mesh.precise.push_back(vec3Cast<double>(p) + Vec3d{4096, 8192, -2048});
    mesh.positions.clear();
    finish(mesh);
    return mesh;
  }();
  Stage stage = pixelStage(64, 1);
  stage.instances = {instanceOf(far)};
  stage.instances[0].modelToWorld = {
      {{64, 0, 0, -4096.0 * 64}, {0, 64, 0, -8192.0 * 64}, {0, 0, 1, 2048}, {0, 0, 0, 1}}};
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return fragments.modelPosition[i] - Vec3f{4096, 8192, -2048};
  });
  const Picture picture = drawnBy(stage, shader, GetParam());
  for (int y = 0; y < 64; y += 7)
    for (int x = 0; x < 64; x += 7) {
      // A float at 8192 has steps of 1/1024: a quarter of a byte.
      EXPECT_NEAR(at(picture, x, y).r, (x + 0.5) / 64 * 255, kRounding + 0.25);
      EXPECT_NEAR(at(picture, x, y).g, (y + 0.5) / 64 * 255, kRounding + 0.25);
      EXPECT_EQ(at(picture, x, y).b, 0);
    }
}

TEST_P(SurfaceShaders, PixelsAndCellsAreNamed)
{
  const OwnedMesh mesh = sheet({0, 0, 0}, {128, 0, 0}, {0, 128, 0}, 4);
  Stage stage = pixelStage(128, 2);
  stage.instances = {instanceOf(mesh)};
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return Vec3f{static_cast<float>(fragments.pixelX[i]) / 255.0f,
                 static_cast<float>(fragments.pixelY[i]) / 255.0f,
                 static_cast<float>(fragments.cell[i]) / 255.0f};
  });
  const Picture picture = drawnBy(stage, shader, GetParam());
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const Rgba8 color = at(picture, x, y);
      EXPECT_EQ(color.r, x);
      EXPECT_EQ(color.g, y);
      EXPECT_EQ(color.b, y / 32 * 4 + x / 32);
    }
}

TEST_P(SurfaceShaders, TextureCoordinatesAreTheMeshsOrMissing)
{
  OwnedMesh mesh = sheet({0, 0, 0}, {64, 0, 0}, {0, 64, 0}, 2);
  Stage stage = pixelStage(64, 1);
  stage.instances = {instanceOf(mesh)};
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return fragments.u == nullptr ? Vec3f{0, 0, 1} : Vec3f{fragments.u[i], fragments.v[i], 0};
  });
  EXPECT_EQ(at(drawnBy(stage, shader, GetParam()), 20, 20).b, 255);

  std::vector<Vec2f> uv;
  for (const Vec3f p : mesh.positions)
    uv.push_back({p.x / 64, 1 - p.y / 64});
  stage.instances[0].attributes.uv = uv;
  const Picture picture = drawnBy(stage, shader, GetParam());
  for (int y = 0; y < 64; y += 5)
    for (int x = 0; x < 64; x += 5) {
      EXPECT_NEAR(at(picture, x, y).r, (x + 0.5) / 64 * 255, kRounding + 0.01);
      EXPECT_NEAR(at(picture, x, y).g, (63.5 - y) / 64 * 255, kRounding + 0.01);
      EXPECT_EQ(at(picture, x, y).b, 0);
    }
}

TEST_P(SurfaceShaders, FlatSurfacesShowTheFacesNormal)
{
  const OwnedMesh coarse = sphere(6, 8);
  Stage stage;
  stage.instances = {instanceOf(coarse)};
  stage.instances[0].style.frequency = ShadingFrequency::kFlat;
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return fragments.normal[i] * 0.5f + Vec3f{0.5f, 0.5f, 0.5f};
  });
  const Picture picture = drawnBy(stage, shader, GetParam());
  const Axes axes = axesOf(stage.view);
  int compared = 0;
  for (std::size_t p = 0; p < picture.color.size(); ++p) {
    if (picture.coverage[p] == 0) continue;
    const Vec3d n = vec3Cast<double>(coarse.faces.normal[picture.cell[p]]);
    EXPECT_NEAR(picture.color[p].r, (dot(n, axes.right) + 1) * 127.5, kRounding + 0.01);
    EXPECT_NEAR(picture.color[p].g, (dot(n, axes.up) + 1) * 127.5, kRounding + 0.01);
    EXPECT_NEAR(picture.color[p].b, (dot(n, axes.back) + 1) * 127.5, kRounding + 0.01);
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST_P(SurfaceShaders, NormalsAreTurnedToTheEye)
{
  const OwnedMesh plane = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0});
  const PointwiseShader shader([](const SurfaceFragments& fragments, int i) {
    return Vec3f{fragments.normal[i].z, 0, 0};
  });
  for (const double side : {3.0, -3.0}) {
    Stage stage;
    stage.view.eye = {0, 0, side};
    stage.instances = {instanceOf(plane)};
    EXPECT_EQ(at(drawnBy(stage, shader, GetParam()), 48, 48).r, 255);
  }
}

TEST_P(SurfaceShaders, WhatIsNotANumberIsBlackAndMoreThanOneIsFull)
{
  const OwnedMesh plane = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0});
  Stage stage;
  stage.instances = {instanceOf(plane)};
  const PointwiseShader shader([](const SurfaceFragments&, int) {
    return Vec3f{std::numeric_limits<float>::quiet_NaN(), 7, -3};
  });
  const Rgba8 color = at(drawnBy(stage, shader, GetParam()), 48, 48);
  EXPECT_EQ(color.r, 0);
  EXPECT_EQ(color.g, 255);
  EXPECT_EQ(color.b, 0);
}

TEST_P(SurfaceShaders, ColorsAboveOneReachTheRadiance)
{
  const OwnedMesh plane = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0});
  Stage stage;
  stage.instances = {instanceOf(plane)};
  const PointwiseShader shader([](const SurfaceFragments&, int) { return Vec3f{3.5f, 0.25f, -1}; });
  stage.instances[0].style.surfaceShader = &shader;
  Picture picture(stage.width, stage.height);
  picture.addRadiance();
  stage.drawOver(picture, GetParam());
  const std::size_t middle = picture.color.size() / 2;
  EXPECT_EQ(picture.radiance[0][middle], 3.5f);
  EXPECT_EQ(picture.radiance[1][middle], 0.25f);
  EXPECT_EQ(picture.radiance[2][middle], 0.0f);
}

TEST_P(SurfaceShaders, OutlinesAreDrawnOverThem)
{
  Stage stage;
  stage.instances = {instanceOf(fineSphere())};
  stage.instances[0].style.outlineThreshold = 0.5f;
  stage.instances[0].style.outlineColor = {1, 0, 0};
  const PointwiseShader shader([](const SurfaceFragments&, int) {
    return Vec3f{0.2f, 0.4f, 0.6f};
  });
  const auto paint = [](const Hit& hit) -> std::optional<Vec3d> {
    const double nv = dot(hit.normal, hit.towardEye);
    if (std::fabs(nv - 0.5) < 0.01) return std::nullopt;
    return nv < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0.2, 0.4, 0.6};
  };
  expectPicture(stage, drawnBy(stage, shader, GetParam()), hitSphere, paint, kRounding + 0.01);
}

TEST(SurfaceShaderRuns, OncePerPixelAndTriangle)
{
  // A square of 16 x 16 pixels cut along its diagonal, of which every pixel shows both parts.
  const OwnedMesh mesh = sheet({0, 0, 0}, {16, 0, 0}, {0, 16, 0});
  Stage stage = pixelStage(64, 4);
  stage.instances = {instanceOf(mesh)};
  std::atomic<int> calls = 0, fragments = 0;
  const PointwiseShader shader([&](const SurfaceFragments&, int i) {
    calls += i == 0;
    ++fragments;
    return Vec3f{1, 1, 1};
  });
  drawnBy(stage, shader, Backend::kPipeline);
  EXPECT_EQ(fragments, 16 * 16 + 16);
  EXPECT_LE(calls, (16 * 16 + 16 + 63) / 64);
}

TEST(SurfaceShaderRuns, OnlyOverTheirOwnInstances)
{
  const OwnedMesh left = sheet({0, 0, 0}, {8, 0, 0}, {0, 16, 0}),
                  right = sheet({8, 0, 0}, {8, 0, 0}, {0, 16, 0});
  Stage stage = pixelStage(16, 1);
  stage.instances = {painted(left, {0, 0, 1}, 1), painted(right, {0, 0, 1}, 2)};
  std::atomic<int> wrong = 0, fragments = 0;
  const PointwiseShader shader([&](const SurfaceFragments& f, int i) {
    wrong += f.pixelX[i] >= 8;
    ++fragments;
    return Vec3f{1, 0, 0};
  });
  stage.instances[0].style.surfaceShader = &shader;
  const Picture picture = stage.draw(Backend::kPipeline);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(fragments, 8 * 16);
  EXPECT_EQ(at(picture, 3, 5).r, 255);
  EXPECT_EQ(at(picture, 12, 5).b, 255);
}

}  // namespace
}  // namespace limn::testing
