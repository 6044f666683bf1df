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

/// What Oren and Nayar's model makes of n.l for the roughness sigma, by angles.
double orenNayar(const Hit& hit, Vec3d l, double sigma)
{
  const Vec3d n = hit.normal, v = hit.towardEye;
  const double nl = dot(n, l), nv = dot(n, v);
  if (nl < 0) return 0;
  const double a = 1 - 0.5 * sigma * sigma / (sigma * sigma + 0.33);
  const double b = 0.45 * sigma * sigma / (sigma * sigma + 0.09);
  const double toLight = std::acos(std::min(nl, 1.0)), toEye = std::acos(std::min(nv, 1.0));
  // Across the surface: where the two azimuths point.
  const Vec3d l1 = normalized(l - n * nl), v1 = normalized(v - n * nv);
  const double between = positive(dot(l1, v1));
  const double larger = std::max(toLight, toEye), smaller = std::min(toLight, toEye);
  return nl * (a + b * between * std::sin(larger) * std::tan(smaller));
}

/// One light's part of the metallic-roughness model, with I = 1 (Walter et al. 2007, Heitz 2014 for
/// the height-correlated shadowing).
struct Facets {
  double roughness, metallic, index;
  Vec3d albedo;

  Vec3d operator()(const Hit& hit, Vec3d l) const
  {
    const Vec3d n = hit.normal, v = hit.towardEye, h = normalized(l + v);
    const double nl = dot(n, l), nv = dot(n, v), nh = dot(n, h), hl = dot(h, l);
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
  void giveTo(Material& material) const
  {
    const auto mu = static_cast<float>(index);
    material.diffuse = 1;
    material.diffuseColor = vec3Cast<float>(albedo);
    material.roughness = static_cast<float>(roughness);
    material.metallic = static_cast<float>(metallic);
    material.refractiveIndex = {mu, mu, mu};
  }
};

/// The plane z = 0 under a lamp that falls off by 1/r^2.
struct LampAbovePlane {
  static constexpr double kIntensity = 3;
  OwnedMesh mesh = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0});
  Vec3d from = {0.5, 0.4, 1.2};
  Stage stage;

  explicit LampAbovePlane(Reflection reflection)
  {
    stage.view.eye = {1.2, 0.8, 2.2};
    stage.instances = {instanceOf(mesh)};
    stage.instances[0].style.reflection = reflection;
    Light light;
    light.kind = LightKind::kPoint;
    light.position = from;
    light.attenuation = {0, 0, 1};
    light.color = {kIntensity, kIntensity, kIntensity};
    stage.lights = {light};
  }
  Vec3d towardLamp(const Hit& hit) const { return normalized(from - hit.position); }
  double intensityAt(const Hit& hit) const
  {
    const Vec3d way = from - hit.position;
    return kIntensity / dot(way, way);
  }
};

/// The plane z = 0 from far away, under directional lights: all of it has one colour.
class EvenPlane {
 public:
  EvenPlane(Reflection reflection, Vec3d towardEye)
  {
    stage_.width = stage_.height = 4;
    stage_.view = parallelView(towardEye * 3.0, {0, 0, 0}, 1e-3);
    stage_.instances = {instanceOf(mesh_)};
    stage_.instances[0].style.reflection = reflection;
  }
  EvenPlane(const EvenPlane&) = delete;
  EvenPlane& operator=(const EvenPlane&) = delete;

  Instance& instance() { return stage_.instances[0]; }
  void light(Vec3d from, double intensity)
  {
    const auto i = static_cast<float>(intensity);
    Light light;
    light.kind = LightKind::kDirectional;
    light.direction = -from;
    light.color = {i, i, i};
    stage_.lights.push_back(light);
  }
  /// 255 is full.
  int brightness(Backend backend) const { return at(stage_.draw(backend), 2, 2).r; }

 private:
  OwnedMesh mesh_ = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage_;
};

Vec3d direction(double degreesFromNormal, double azimuthDegrees)
{
  const double theta = degreesFromNormal * kPi / 180, phi = azimuthDegrees * kPi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
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
    if (atTerminator(dot(hit.normal, kLight))) return std::nullopt;
    return grey(0.8 * orenNayar(hit, kLight, kSigma));
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

TEST_P(ReflectionModels, MetallicRoughnessIsTheFacetsEquation)
{
  for (const Facets facets :
       {Facets{0.6, 0, 1.5, {0.8, 0.4, 0.2}}, Facets{0.5, 1, 1.5, {1, 0.75, 0.3}},
        Facets{0.9, 0.5, 2.4, {0.9, 0.9, 0.9}}}) {
    Stage stage = litSphere(Reflection::kMetallicRoughness);
    facets.giveTo(materialOf(stage));
    const auto lit = [&](const Hit& hit) -> std::optional<Vec3d> {
      if (atTerminator(dot(hit.normal, kLight))) return std::nullopt;
      return facets(hit, kLight);
    };
    expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 10 * kFacets);
  }
}

TEST_P(ReflectionModels, IrradianceFallsOffOnAPlaneUnderALamp)
{
  constexpr double kPower = 25;
  LampAbovePlane under(Reflection::kIrradiance);
  Material& material = materialOf(under.stage);
  material.diffuse = 0.5f;
  material.specular = 0.4f;
  material.specularPower = static_cast<float>(kPower);
  const auto lit = [&](const Hit& hit) {
    const Vec3d l = under.towardLamp(hit);
    const double nh = positive(dot(hit.normal, normalized(l + hit.towardEye)));
    const double irradiance = under.intensityAt(hit) * dot(hit.normal, l);
    return grey((0.5 / kPi + 0.4 * std::pow(nh, kPower)) * irradiance);
  };
  expectPicture(under.stage, draw(under.stage), hitPlane, lit, kRounding + 0.1);
}

TEST_P(ReflectionModels, OrenNayarFallsOffOnAPlaneUnderALamp)
{
  LampAbovePlane under(Reflection::kOrenNayar);
  materialOf(under.stage).roughness = 0.7f;
  materialOf(under.stage).diffuse = 0.3f;
  const auto lit = [&](const Hit& hit) {
    return grey(0.3 * under.intensityAt(hit) * orenNayar(hit, under.towardLamp(hit), 0.7));
  };
  expectPicture(under.stage, draw(under.stage), hitPlane, lit, kRounding + 0.1);
}

TEST_P(ReflectionModels, FacetsFallOffOnAPlaneUnderALamp)
{
  const Facets facets = {0.6, 0.5, 1.8, {0.9, 0.6, 0.2}};
  LampAbovePlane under(Reflection::kMetallicRoughness);
  facets.giveTo(materialOf(under.stage));
  const auto lit = [&](const Hit& hit) {
    return facets(hit, under.towardLamp(hit)) * under.intensityAt(hit);
  };
  expectPicture(under.stage, draw(under.stage), hitPlane, lit, kRounding + 0.1);
}

TEST_P(ReflectionModels, FacetsHeadOnReflectByTheirNumber)
{
  // D = 1 / (pi alpha^2), no shadowing, F = F_0.
  constexpr double kAlpha = 0.7 * 0.7, kF0 = 0.25 * 0.04 + 0.75 * 0.6;
  EvenPlane plane(Reflection::kMetallicRoughness, {0, 0, 1});
  Facets{0.7, 0.75, 1.5, grey(0.6)}.giveTo(plane.instance().material);
  plane.light({0, 0, 1}, 1);
  const double expected = kF0 / (4 * kPi * kAlpha * kAlpha) + (1 - kF0) * 0.25 * 0.6 / kPi;
  EXPECT_NEAR(plane.brightness(GetParam()), 255 * expected, 0.6);
}

/// What a white metal sends towards the eye when it is as bright from everywhere.
double shareSentBack(double roughness, double tilt, Backend backend)
{
  constexpr int kLights = 4000;
  EvenPlane plane(Reflection::kMetallicRoughness, direction(tilt, 0));
  Facets{roughness, 1, 1.5, grey(1)}.giveTo(plane.instance().material);
  for (int i = 0; i < kLights; ++i) {
    const double z = (i + 0.5) / kLights;
    plane.light(direction(std::acos(z) * 180 / kPi, 137.50776405 * i), 2 * kPi / kLights);
  }
  return plane.brightness(backend) / 255.0;
}

TEST_P(ReflectionModels, FacetsSendBackNoMoreThanComes)
{
  for (const double tilt : {0.0, 30.0, 60.0, 75.0}) {
    double smoother = 1;
    for (const double roughness : {0.5, 0.7, 1.0}) {
      const double share = shareSentBack(roughness, tilt, GetParam());
      EXPECT_LT(share, smoother) << roughness << ' ' << tilt;
      smoother = share;
    }
  }
  // With alpha = 1 and v = n the integral is that of c / (1 + c) over c = n.l.
  EXPECT_NEAR(shareSentBack(1, 0, GetParam()), 1 - std::log(2.0), 0.003);
}

/// Brightness of the plane when lit from `from` so strongly that n.l does not count.
int perIrradiance(Reflection reflection, Vec3d from, Vec3d towardEye, Backend backend)
{
  EvenPlane plane(reflection, towardEye);
  Facets{0.6, 0.4, 1.7, grey(0.7)}.giveTo(plane.instance().material);
  plane.instance().material.specular = 0.3f;
  plane.instance().material.specularPower = 12;
  const bool isOverPi =
      reflection != Reflection::kOrenNayar && reflection != Reflection::kBlinnPhong;
  plane.light(from, (isOverPi ? 1.8 : 0.8) / from.z);
  return plane.brightness(backend);
}

TEST_P(ReflectionModels, LightGoesBackTheWayItCame)
{
  const Vec3d pairs[][2] = {{direction(20, 10), direction(55, 100)},
                            {direction(70, 0), direction(30, 175)},
                            {direction(65, 40), direction(10, 45)}};
  for (const auto& [one, other] : pairs) {
    for (const Reflection reflection :
         {Reflection::kIrradiance, Reflection::kOrenNayar, Reflection::kMetallicRoughness}) {
      const int there = perIrradiance(reflection, one, other, GetParam());
      EXPECT_NEAR(there, perIrradiance(reflection, other, one, GetParam()), 1);
      EXPECT_GT(there, 50);
      EXPECT_LT(there, 255);
    }
    // (12.2) has no such symmetry.
    EXPECT_GT(std::abs(perIrradiance(Reflection::kBlinnPhong, one, other, GetParam()) -
                       perIrradiance(Reflection::kBlinnPhong, other, one, GetParam())),
              4);
  }
}

TEST_P(ReflectionModels, FresnelsTermIsThatOfTheIndexHeadOnAndAlmostOneAtGrazingAngles)
{
  const auto brightness = [&](double degrees, float index, double intensity) {
    EvenPlane plane(Reflection::kBlinnPhong, direction(degrees, 0));
    plane.instance().style.fresnel = true;
    Material& material = plane.instance().material;
    material.diffuse = 0;
    material.specular = 1;
    material.refractiveIndex = {index, index, index};
    // As in a mirror: h = n.
    plane.light(direction(degrees, 180), intensity);
    return plane.brightness(GetParam());
  };
  EXPECT_NEAR(brightness(0, 1.5f, 20), 255 * 20 * 0.04, 0.6);
  EXPECT_NEAR(brightness(0, 3, 2), 255 * 2 * 0.25, 0.6);
  EXPECT_EQ(brightness(0, 1, 1000), 0);
  EXPECT_GE(brightness(89.9, 1.5f, 1), 252);
  EXPECT_GE(brightness(89.9, 1, 1), 252);
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
