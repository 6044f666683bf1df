// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Testing/Agreement/RandomScene.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Small scenes with known answers. Whatever a test compares a picture with is computed here and in
/// the tests in double, by libm, and shares no code with the renderers.
namespace limn::testing {

/// Where a camera stands and what it takes in. Up is +y; a gaze along y is not allowed.
struct Viewpoint {
  Vec3d eye = {0, 0, 3}, target = {0, 0, 0};
  bool parallel = false;
  double fovyDegrees = 50;  ///< perspective
  double halfHeight = 1.2;  ///< parallel: VTK's parallel scale
  double near = 0.5, far = 10;
};

struct ClipRange {
  double near = 0.5, far = 10;
};
Viewpoint perspectiveView(Vec3d eye, Vec3d target, double fovyDegrees, ClipRange range = {});
Viewpoint parallelView(Vec3d eye, Vec3d target, double halfHeight, ClipRange range = {});

struct Axes {
  Vec3d right, up, back;
};
Axes axesOf(const Viewpoint& view);

struct Ray {
  Vec3d origin, direction;  ///< unit
};

/// A scene and a size of picture; owns the lists that a Scene borrows.
struct Stage {
  Viewpoint view;
  int width = 96, height = 96;
  Vec3f ambientLight = {0, 0, 0};
  std::vector<Light> lights;
  std::vector<Instance> instances;
  int samples = 1;
  Resolve resolve = Resolve::kGamma22;

  Camera camera() const;
  Scene scene() const;
  /// Draws over black, transparent, farthest.
  Picture draw(Backend backend) const;
  /// Draws over what the picture holds.
  RenderStats drawOver(Picture& picture, Backend backend,
                       Background background = Background::kBlend) const;

  /// The ray through a point of the window, in pixels.
  Ray ray(double x, double y) const;
  /// Window x and y in pixels, and window depth.
  Vec3d project(Vec3d world) const;
};

/// side x side pixels under parallel projection, one unit a pixel, origin in the window's corner:
/// multiples of 1/256 stay exact where `side` is a power of two.
Stage pixelStage(int side, int samples);

/// A point seen in a pixel.
struct Hit {
  Vec3d position, normal, towardEye;
};
/// First meeting with the unit sphere about the origin.
std::optional<Hit> hitSphere(const Ray& ray);
/// Meeting with the plane z = 0; its normal is +z.
std::optional<Hit> hitPlane(const Ray& ray);

using Surface = std::function<std::optional<Hit>(const Ray&)>;
/// Colour of a hit, 1 is full; nullopt for points that are not to be compared.
using Equation = std::function<std::optional<Vec3d>(const Hit&)>;

/// Rounding to a byte alone.
inline constexpr double kRounding = 0.5;
/// fineSphere() lies at most 1.5e-4 under the sphere; at the steepest angle compared (n.v = 0.3)
/// the point seen is 5e-4 off: 0.12 bytes for the cosine law, and steepness() times that for
/// highlights.
inline constexpr double kFacets = 0.15;
/// Largest slope of cos(x)^p, by which it magnifies kFacets.
double steepness(double power);

/// Compares each pixel whose ray meets `surface` with n.v >= 0.3, clamped to [0, 1], in all three
/// channels. Requires at least a tenth of the picture to be compared.
void expectPicture(const Stage& stage, const Picture& picture, const Surface& surface,
                   const Equation& equation, double tolerance);

/// Fills in clusters and face geometry from positions, triangles and cells.
void finish(OwnedMesh& mesh);
/// Rings and sectors about the z axis, poles and all; exact normals. Cells are quads, and the
/// triangles at the poles.
OwnedMesh sphere(std::uint32_t rings, std::uint32_t sectors);
/// The unit sphere of 65 024 triangles; made once.
const OwnedMesh& fineSphere();
/// The parallelogram corner + s u + t v as cells x cells quads; normals along u x v.
OwnedMesh sheet(Vec3d corner, Vec3d u, Vec3d v, std::uint32_t cells = 1);
/// Loose triangles, three points each; normals +z.
OwnedMesh soup(const std::vector<Vec3d>& points);

/// The mesh with all its attributes, for Reflection::kLambert. `mesh` must stay where it is.
Instance instanceOf(const OwnedMesh& mesh);
/// Painted in one colour, without light.
Instance painted(const OwnedMesh& mesh, Vec3f color, std::uint32_t id = 0);

Rgba8 at(const Picture& picture, int x, int y);
bool covered(const Picture& picture, int x, int y);
int bitCount(std::uint8_t bits);

/// The base of tests that hold for both renderers.
class BothBackends : public ::testing::TestWithParam<Backend> {
 protected:
  Picture draw(const Stage& stage) const { return stage.draw(GetParam()); }
};
inline auto bothBackends()
{
  return ::testing::Values(Backend::kReference, Backend::kPipeline);
}
inline std::string backendName(const ::testing::TestParamInfo<Backend>& backend)
{
  return backend.param == Backend::kPipeline ? "Pipeline" : "Reference";
}

}  // namespace limn::testing

/// Runs a fixture derived from BothBackends on both.
#define LIMN_ON_BOTH_BACKENDS(fixture)                                         \
  INSTANTIATE_TEST_SUITE_P(Backends, fixture, ::limn::testing::bothBackends(), \
                           ::limn::testing::backendName)
