// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Models beside the chapter's own, pixel by pixel, from their papers' formulas with angles, in
// double.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class ReflectionModels : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(ReflectionModels);

constexpr double kPi = 3.14159265358979323846;
const Vec3d kLight = normalized(Vec3d{2, 1, 3});

Stage litSphere(Reflection reflection)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = -kLight;
  stage.lights = {light};
  stage.instances[0].style.reflection = reflection;
  stage.instances[0].material.diffuse = 0.8f;
  return stage;
}

Material& materialOf(Stage& stage)
{
  return stage.instances[0].material;
}

double positive(double x)
{
  return std::max(0.0, x);
}
Vec3d grey(double value)
{
  return {value, value, value};
}
bool atTerminator(double nl)
{
  return std::fabs(nl) < 0.02;
}
double schlick(double f0, double cosine)
{
  return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}

TEST_P(ReflectionModels, IrradianceIsTheShareOverPi)
{
  Stage stage = litSphere(Reflection::kIrradiance);
  stage.lights[0].color = {2.5f, 2.5f, 2.5f};
  const auto lit = [](const Hit& hit) {
    return grey(0.8 / kPi * 2.5 * positive(dot(hit.normal, kLight)));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(ReflectionModels, IrradianceHasTheCosineInItsHighlight)
{
  constexpr double kPower = 20;
  Stage stage = litSphere(Reflection::kIrradiance);
  materialOf(stage).diffuse = 0;
  materialOf(stage).specular = 0.7f;
  materialOf(stage).specularPower = static_cast<float>(kPower);
  const auto lit = [](const Hit& hit) {
    const double nl = positive(dot(hit.normal, kLight));
    const double nh = positive(dot(hit.normal, normalized(kLight + hit.towardEye)));
    return grey(nl > 0 ? 0.7 * std::pow(nh, kPower) * nl : 0);
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + steepness(kPower) * kFacets);
}

TEST_P(ReflectionModels, OrenNayarWithoutRoughnessIsLambertToTheByte)
{
  Stage rough = litSphere(Reflection::kOrenNayar);
  materialOf(rough).roughness = 0;
  EXPECT_EQ(draw(rough).differingPixels(draw(litSphere(Reflection::kLambert))), 0u);
}

TEST_P(ReflectionModels, OrenNayarFollowsThePapersAngles)
{
  constexpr double kSigma = 0.5;
  Stage stage = litSphere(Reflection::kOrenNayar);
  materialOf(stage).roughness = static_cast<float>(kSigma);
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const Vec3d n = hit.normal, v = hit.towardEye;
    const double nl = dot(n, kLight), nv = dot(n, v);
    if (atTerminator(nl)) return std::nullopt;
    if (nl < 0) return grey(0);
    const double a = 1 - 0.5 * kSigma * kSigma / (kSigma * kSigma + 0.33);
    const double b = 0.45 * kSigma * kSigma / (kSigma * kSigma + 0.09);
    const double toLight = std::acos(std::min(nl, 1.0)), toEye = std::acos(std::min(nv, 1.0));
    // Across the surface: where the two azimuths point.
    const Vec3d l1 = normalized(kLight - n * nl), v1 = normalized(v - n * nv);
    const double between = positive(dot(l1, v1));
    const double larger = std::max(toLight, toEye), smaller = std::min(toLight, toEye);
    return grey(0.8 * nl * (a + b * between * std::sin(larger) * std::tan(smaller)));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

TEST_P(ReflectionModels, TheFullMoonOfOrenAndNayarIsFlatterThanLamberts)
{
  // The sphere's radius is 40 pixels; 36 to the right of its middle n.v is 0.41.
  constexpr int kAside = 36;
  const auto fallToTheRim = [&](Reflection reflection) {
    Stage stage = litSphere(reflection);
    stage.view.eye = {0, 0, 3};
    stage.view.parallel = true;
    stage.lights[0].direction = {0, 0, -1};
    materialOf(stage).roughness = 1;
    const Picture picture = draw(stage);
    const double middle = at(picture, 48, 48).r;
    return at(picture, 48 + kAside, 48).r / middle;
  };
  const double expected = std::sqrt(1 - ((kAside + 0.5) * (kAside + 0.5) + 0.25) / 1600);
  EXPECT_NEAR(fallToTheRim(Reflection::kLambert), expected, 0.01);
  EXPECT_GT(fallToTheRim(Reflection::kOrenNayar), 0.7);
}

/// One light's part of the metallic-roughness model, with I = 1 (Walter et al. 2007, Heitz 2014 for
/// the height-correlated shadowing).
struct Facets {
  double roughness, metallic, index;
  Vec3d albedo;

  Vec3d operator()(const Hit& hit) const
  {
    const Vec3d n = hit.normal, v = hit.towardEye, h = normalized(kLight + v);
    const double nl = dot(n, kLight), nv = dot(n, v), nh = dot(n, h), hl = dot(h, kLight);
    if (nl <= 0) return {0, 0, 0};
    const double alpha = roughness * roughness;
    const auto tangent2 = [](double cosine) { return (1 - cosine * cosine) / (cosine * cosine); };
    const double d =
        alpha * alpha / (kPi * std::pow(nh, 4) * std::pow(alpha * alpha + tangent2(nh), 2));
    const auto lambda = [&](double cosine) {
      return (-1 + std::sqrt(1 + alpha * alpha * tangent2(cosine))) / 2;
    };
    const double g = 1 / (1 + lambda(nl) + lambda(nv));
    const auto channel = [&](double color) {
      const double f0 = (1 - metallic) * std::pow((index - 1) / (index + 1), 2) + metallic * color;
      const double f = schlick(f0, hl);
      return ((1 - f) * (1 - metallic) * color / kPi + f * d * g / (4 * nl * nv)) * nl;
    };
    return {channel(albedo.x), channel(albedo.y), channel(albedo.z)};
  }
};

TEST_P(ReflectionModels, MetallicRoughnessIsTheFacetsEquation)
{
  for (const Facets facets :
       {Facets{0.6, 0, 1.5, {0.8, 0.4, 0.2}}, Facets{0.5, 1, 1.5, {1, 0.75, 0.3}},
        Facets{0.9, 0.5, 2.4, {0.9, 0.9, 0.9}}}) {
    Stage stage = litSphere(Reflection::kMetallicRoughness);
    Material& material = materialOf(stage);
    material.diffuse = 1;
    material.diffuseColor = vec3Cast<float>(facets.albedo);
    material.roughness = static_cast<float>(facets.roughness);
    material.metallic = static_cast<float>(facets.metallic);
    const auto mu = static_cast<float>(facets.index);
    material.refractiveIndex = {mu, mu, mu};
    const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
      if (atTerminator(dot(hit.normal, kLight))) return std::nullopt;
      return facets(hit);
    };
    expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 10 * kFacets);
  }
}

TEST_P(ReflectionModels, FresnelsTermGrowsFromHeadOnToGrazing)
{
  constexpr double kPower = 4;
  for (const Reflection reflection : {Reflection::kBlinnPhong, Reflection::kPhong}) {
    Stage stage = litSphere(reflection);
    stage.lights[0].color = {4, 4, 4};
    stage.instances[0].style.fresnel = true;
    Material& material = materialOf(stage);
    material.diffuse = 0;
    material.specular = 1;
    material.specularPower = static_cast<float>(kPower);
    material.refractiveIndex = {1.5f, 2.0f, 1.0f};
    const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
      const double nl = dot(hit.normal, kLight);
      if (atTerminator(nl)) return std::nullopt;
      if (nl < 0) return grey(0);
      const Vec3d h = normalized(kLight + hit.towardEye);
      const Vec3d r = hit.normal * (2 * nl) - kLight;
      const double cosine =
          reflection == Reflection::kPhong ? dot(r, hit.towardEye) : dot(hit.normal, h);
      const double highlight = 4 * std::pow(positive(cosine), kPower), hl = dot(h, kLight);
      return Vec3d{schlick(0.04, hl), schlick(1.0 / 9, hl), schlick(0, hl)} * highlight;
    };
    expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 4 * steepness(kPower) * kFacets);
  }
}

TEST_P(ReflectionModels, TheHighlightHasTheColourOfTheSurface)
{
  constexpr double kPower = 10;
  Stage stage = litSphere(Reflection::kBlinnPhong);
  Material& material = materialOf(stage);
  material.diffuse = 0;
  material.specular = 0.9f;
  material.specularColor = {1, 0.6f, 0.35f};
  material.specularPower = static_cast<float>(kPower);
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const double nl = dot(hit.normal, kLight);
    if (atTerminator(nl)) return std::nullopt;
    const double nh = positive(dot(hit.normal, normalized(kLight + hit.towardEye)));
    return Vec3d{0.9, 0.54, 0.315} * (nl > 0 ? std::pow(nh, kPower) : 0.0);
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + steepness(kPower) * kFacets);
}

TEST_P(ReflectionModels, VelvetGrowsTowardsTheOutline)
{
  Stage stage = litSphere(Reflection::kLambert);
  stage.ambientLight = {0.1f, 0.1f, 0.1f};
  Material& material = materialOf(stage);
  material.diffuse = 0.2f;
  material.ambient = 0.5f;
  material.rim = {0.9f, 0.2f, 0};
  material.rimPower = 2;
  const auto lit = [](const Hit& hit) {
    const double rim = std::pow(1 - dot(hit.normal, hit.towardEye), 2);
    const double nl = positive(dot(hit.normal, kLight));
    const auto channel = [&](double k) { return 0.1 * (0.5 + k * rim) + nl * (0.2 + k * rim); };
    return Vec3d{channel(0.9), channel(0.2), channel(0)};
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

TEST_P(ReflectionModels, WithoutFallOffDistanceDoesNotMatter)
{
  Stage stage = litSphere(Reflection::kLambert);
  const Vec3d from = {1, 1.5, 1.5};
  stage.lights[0].kind = LightKind::kPoint;
  stage.lights[0].position = from;
  stage.instances[0].style.fallOff = false;
  const auto lit = [&](const Hit& hit) {
    return grey(0.8 * positive(dot(hit.normal, normalized(from - hit.position))));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

}  // namespace
}  // namespace limn::testing
