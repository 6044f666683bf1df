// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a surface sends on to the eye: the chapter's models and VTK's own, pixel by pixel.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class Reflections : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Reflections);

const Vec3d kLight = normalized(Vec3d{2, 1, 3});
constexpr double kPower = 20;

Stage glossySphere(Reflection reflection)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = -kLight;
  light.color = {1, 0.5f, 0.75f};
  stage.lights = {light};
  Material& material = stage.instances[0].material;
  material.diffuse = 0.3f;
  material.specular = 0.6f;
  material.specularPower = static_cast<float>(kPower);
  stage.instances[0].style.reflection = reflection;
  return stage;
}

double positive(double x)
{
  return std::max(0.0, x);
}
double halfwayTerm(const Hit& hit, Vec3d l)
{
  return std::pow(positive(dot(hit.normal, normalized(l + hit.towardEye))), kPower);
}
double reflectedTerm(const Hit& hit, Vec3d l, Vec3d v)
{
  const Vec3d r = hit.normal * (2 * dot(hit.normal, l)) - l;
  return std::pow(positive(dot(r, v)), kPower);
}
/// 0.3 of matt and 0.6 of glossy reflection of the light's three colours.
Vec3d mixed(double matt, double glossy)
{
  const double sum = 0.3 * matt + 0.6 * glossy;
  return Vec3d{1, 0.5, 0.75} * sum;
}
/// Highlights end at n.l = 0 with a step, which facets may move by a pixel.
bool atTerminator(double nl)
{
  return std::fabs(nl) < 0.02;
}
const double kGlossyTolerance = kRounding + steepness(kPower) * kFacets;

TEST_P(Reflections, LambertIsEquation12_1)
{
  const Stage stage = glossySphere(Reflection::kLambert);
  const auto lit = [](const Hit& hit) { return mixed(positive(dot(hit.normal, kLight)), 0); };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(Reflections, BlinnPhongIsEquation12_3)
{
  const Stage stage = glossySphere(Reflection::kBlinnPhong);
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const double nl = dot(hit.normal, kLight);
    if (atTerminator(nl)) return std::nullopt;
    return mixed(positive(nl), nl > 0 ? halfwayTerm(hit, kLight) : 0);
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
}

TEST_P(Reflections, PhongUsesTheReflectedRay)
{
  const Stage stage = glossySphere(Reflection::kPhong);
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const double nl = dot(hit.normal, kLight);
    if (atTerminator(nl)) return std::nullopt;
    return mixed(positive(nl), nl > 0 ? reflectedTerm(hit, kLight, hit.towardEye) : 0);
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
}

TEST_P(Reflections, TheEyeIsFarAwayUnderParallelProjection)
{
  for (const Reflection reflection : {Reflection::kBlinnPhong, Reflection::kPhong}) {
    Stage stage = glossySphere(reflection);
    stage.view.parallel = true;
    const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
      const double nl = dot(hit.normal, kLight);
      if (atTerminator(nl)) return std::nullopt;
      const double highlight = reflection == Reflection::kPhong
                                   ? reflectedTerm(hit, kLight, hit.towardEye)
                                   : halfwayTerm(hit, kLight);
      return mixed(positive(nl), nl > 0 ? highlight : 0);
    };
    expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
  }
}

TEST_P(Reflections, PointLightsHighlightFallsOffToo)
{
  Stage stage = glossySphere(Reflection::kBlinnPhong);
  const Vec3d from = {1, 1.5, 1.5};
  stage.lights[0].kind = LightKind::kPoint;
  stage.lights[0].position = from;
  const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
    const Vec3d way = from - hit.position;
    const double nl = dot(hit.normal, normalized(way));
    if (atTerminator(nl)) return std::nullopt;
    const double fall = 1 / dot(way, way);
    return mixed(fall * positive(nl), nl > 0 ? fall * halfwayTerm(hit, normalized(way)) : 0);
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
}

TEST_P(Reflections, NoneIsUnlit)
{
  Stage stage = glossySphere(Reflection::kNone);
  stage.ambientLight = {9, 9, 9};
  stage.instances[0].material.ambientColor = {0.1f, 0, 0.5f};
  stage.instances[0].material.ambient = 1;
  const auto paint = [](const Hit&) { return Vec3d{0.4, 0.3, 0.8}; };
  expectPicture(stage, draw(stage), hitSphere, paint, kRounding + 0.01);
}

TEST_P(Reflections, AsVtkALoneHeadlightSeesOnlyTheNormalsZ)
{
  Stage stage = glossySphere(Reflection::kAsVtk);
  stage.lights[0].kind = LightKind::kHeadlight;
  stage.ambientLight = {9, 9, 9};
  stage.instances[0].material.ambient = 0.1f;
  const Vec3d gaze = normalized(stage.view.eye);
  const auto lit = [&](const Hit& hit) {
    const double nz = positive(dot(hit.normal, gaze));
    return Vec3d{0.1, 0.1, 0.1} + mixed(nz, std::pow(nz, kPower));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
}

TEST_P(Reflections, AsVtkOtherLightsReflectTowardsTheEyesPoint)
{
  // VTK takes the eye's point even under parallel projection.
  for (const bool parallel : {false, true}) {
    Stage stage = glossySphere(Reflection::kAsVtk);
    stage.view.parallel = parallel;
    stage.instances[0].material.ambient = 0.1f;
    stage.lights.push_back(Light{});
    const Vec3d gaze = normalized(stage.view.eye);
    const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
      const Vec3d v = normalized(stage.view.eye - hit.position);
      const double nl = dot(hit.normal, kLight), nz = dot(hit.normal, gaze);
      if (atTerminator(nl) || atTerminator(nz)) return std::nullopt;
      const double second = nz > 0 ? 0.3 * nz + 0.6 * reflectedTerm(hit, gaze, v) : 0;
      return Vec3d{0.1 + second, 0.1 + second, 0.1 + second} +
             mixed(positive(nl), nl > 0 ? reflectedTerm(hit, kLight, v) : 0);
    };
    expectPicture(stage, draw(stage), hitSphere, lit, 2 * kGlossyTolerance - kRounding);
  }
}

TEST_P(Reflections, AsVtkSpotIsAttenuatedInBothTerms)
{
  Stage stage = glossySphere(Reflection::kAsVtk);
  const Vec3d from = {2, 1, 2.5};
  Light& light = stage.lights[0];
  light.kind = LightKind::kSpot;
  light.position = from;
  light.direction = -from;
  light.coneDegrees = 12;
  light.exponent = 5;
  light.attenuation = {0.5f, 0, 0.125f};
  const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
    const Vec3d way = from - hit.position, l = normalized(way);
    const double axis = dot(l, normalized(from)), edge = std::cos(12 * 3.14159265358979 / 180);
    const double nl = dot(hit.normal, l);
    if (atTerminator(nl) || std::fabs(axis - edge) < 1e-3) return std::nullopt;
    if (axis < edge || nl < 0) return Vec3d{0, 0, 0};
    const double fall = std::pow(axis, 5) / (0.5 + 0.125 * dot(way, way));
    return mixed(fall * nl, fall * reflectedTerm(hit, l, hit.towardEye));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kGlossyTolerance);
}

TEST_P(Reflections, NothingIsLitFromBehindItsTangentPlane)
{
  // A highlight of power 1 would reach far past the terminator.
  for (const Reflection reflection :
       {Reflection::kLambert, Reflection::kBlinnPhong, Reflection::kPhong, Reflection::kAsVtk}) {
    Stage stage = glossySphere(reflection);
    stage.instances[0].material.specularPower = 1;
    const auto dark = [](const Hit& hit) -> std::optional<Vec3d> {
      if (dot(hit.normal, kLight) > -0.01) return std::nullopt;
      return Vec3d{0, 0, 0};
    };
    stage.view.eye = {-2, 0.5, 1.5};
    expectPicture(stage, draw(stage), hitSphere, dark, 0);
  }
}

TEST_P(Reflections, DarkensBelowTheOutlineThreshold)
{
  Stage stage = glossySphere(Reflection::kNone);
  stage.instances[0].style.outlineThreshold = 0.5f;
  stage.instances[0].style.outlineColor = {1, 0, 0};
  const auto paint = [](const Hit& hit) -> std::optional<Vec3d> {
    const double nv = dot(hit.normal, hit.towardEye);
    if (std::fabs(nv - 0.5) < 0.01) return std::nullopt;
    return nv < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0.3, 0.3, 0.3};
  };
  expectPicture(stage, draw(stage), hitSphere, paint, kRounding + 0.01);
}

}  // namespace
}  // namespace limn::testing
