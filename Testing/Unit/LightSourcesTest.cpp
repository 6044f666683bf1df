// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What arrives from each kind of light, seen on matt surfaces: equation (12.1), pixel by pixel.
#include "Rendering/Vertex/PlaceLights.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kDegrees = 3.14159265358979323846 / 180;

class LightSources : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(LightSources);

Stage sphereStage()
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(fineSphere())};
  return stage;
}

/// The plane z = 0 from straight above, 2 x 2 units on 96 x 96 pixels.
Stage planeStage(const OwnedMesh& plane)
{
  Stage stage;
  stage.view = parallelView({0, 0, 4}, {0, 0, 0}, 1);
  stage.instances = {instanceOf(plane)};
  return stage;
}
OwnedMesh plane()
{
  return sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
}

Light directional(Vec3d direction, Vec3f color = {1, 1, 1})
{
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = direction;
  light.color = color;
  return light;
}
Light point(Vec3d position, Vec3f color, Vec3f attenuation = {0, 0, 1})
{
  Light light;
  light.kind = LightKind::kPoint;
  light.position = position;
  light.color = color;
  light.attenuation = attenuation;
  return light;
}
Light spot(double coneDegrees, double exponent)
{
  Light light = point({0, 0, 1}, {1, 1, 1}, {1, 0, 0});
  light.kind = LightKind::kSpot;
  light.direction = {0, 0, -2};
  light.coneDegrees = static_cast<float>(coneDegrees);
  light.exponent = static_cast<float>(exponent);
  return light;
}

double cosineTo(const Hit& hit, Vec3d towardLight)
{
  return std::max(0.0, dot(hit.normal, normalized(towardLight)));
}
Vec3d gray(double value)
{
  return {value, value, value};
}

TEST_P(LightSources, AmbientLightIsTheSameEverywhere)
{
  Stage stage = sphereStage();
  stage.ambientLight = {0.2f, 0.5f, 3.0f};
  stage.instances[0].material.ambientColor = {1, 0.5f, 0.25f};
  stage.instances[0].material.ambient = 0.8f;
  const auto ambient = [](const Hit&) { return Vec3d{0.16, 0.2, 0.6}; };
  expectPicture(stage, draw(stage), hitSphere, ambient, kRounding + 0.01);
}

TEST_P(LightSources, AmbientAndDiffuseCoefficientsAreApart)
{
  Stage stage = sphereStage();
  stage.ambientLight = {0.5f, 0.5f, 0.5f};
  stage.lights = {directional({0, -1, -1})};
  stage.instances[0].material.ambientColor = {0, 0.4f, 0};
  stage.instances[0].material.ambient = 1;
  stage.instances[0].material.diffuseColor = {0.9f, 0, 0};
  stage.instances[0].material.diffuse = 0.5f;
  const auto lit = [](const Hit& hit) { return Vec3d{0.45 * cosineTo(hit, {0, 1, 1}), 0.2, 0}; };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(LightSources, DirectionalLightFollowsTheCosineWhateverItsVectorsLength)
{
  Stage stage = sphereStage();
  stage.lights = {directional({-30, -10, -50}, {1, 0.5f, 0.25f})};
  const auto lit = [](const Hit& hit) { return Vec3d{1, 0.5, 0.25} * cosineTo(hit, {3, 1, 5}); };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(LightSources, HeadlightShinesAlongTheGaze)
{
  Stage stage = sphereStage();
  stage.lights = {Light{}};
  const auto lit = [&](const Hit& hit) { return gray(cosineTo(hit, stage.view.eye)); };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(LightSources, PointLightFallsOffWithTheSquareOfTheDistance)
{
  Stage stage = sphereStage();
  const Vec3d from = {1.5, 1, 1.2};
  stage.lights = {point(from, {0.8f, 0.6f, 0.4f})};
  const auto lit = [&](const Hit& hit) {
    const Vec3d way = from - hit.position;
    return Vec3d{0.8, 0.6, 0.4} * (cosineTo(hit, way) / dot(way, way));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

TEST_P(LightSources, TwiceTheDistanceGetsAQuarterOfThePointLight)
{
  const auto brightnessBelow = [&](double height) {
    const OwnedMesh mesh = plane();
    Stage stage = planeStage(mesh);
    stage.width = stage.height = 95;
    stage.lights = {point({0, 0, height}, {0.8f, 0.8f, 0.8f})};
    return static_cast<int>(at(draw(stage), 47, 47).g);
  };
  EXPECT_EQ(brightnessBelow(1), 204);
  EXPECT_EQ(brightnessBelow(2), 204 / 4);
}

TEST_P(LightSources, PointLightTakesVtksThreeAttenuations)
{
  Stage stage = sphereStage();
  const Vec3d from = {0, 2, 1};
  stage.lights = {point(from, {1, 1, 1}, {0.5f, 0.25f, 0.125f})};
  const auto lit = [&](const Hit& hit) {
    const Vec3d way = from - hit.position;
    const double r = std::sqrt(dot(way, way));
    return gray(cosineTo(hit, way) / (0.5 + 0.25 * r + 0.125 * r * r));
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + kFacets);
}

TEST_P(LightSources, SpotLightsUpACircleOfItsConeAngle)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.width = stage.height = 400;
  stage.lights = {spot(25, 0)};
  const Picture picture = draw(stage);
  double litPixels = 0;
  for (const Rgba8& color : picture.color)
    litPixels += color.g > 0;
  const double radius = std::sqrt(litPixels / 3.14159265358979323846);
  // Pixels of a disk of 93 pixels' radius count its area to some 60 (Gauss's circle problem).
  EXPECT_NEAR(radius, 200 * std::tan(25 * kDegrees), 0.1);
}

TEST_P(LightSources, SpotFadesWithThePowerOfItsCosineInsideTheCone)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.lights = {spot(40, 7.5)};
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const Vec3d way = normalized(Vec3d{0, 0, 1} - hit.position);
    if (std::fabs(way.z - std::cos(40 * kDegrees)) < 1e-3) return std::nullopt;
    const bool inside = way.z > std::cos(40 * kDegrees);
    return gray(inside ? way.z * std::pow(way.z, 7.5) : 0);
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.02);
}

TEST_P(LightSources, LightsAddUp)
{
  Stage stage = sphereStage();
  stage.ambientLight = {0.1f, 0.1f, 0.1f};
  stage.instances[0].material.ambient = 1;
  const Vec3d from = {-1, 2, 2};
  stage.lights = {directional({-1, 0, 0}, {0.4f, 0, 0}), directional({0, 0, -1}, {0.2f, 0.3f, 0}),
                  point(from, {0, 0.5f, 2})};
  const auto lit = [&](const Hit& hit) {
    const Vec3d way = from - hit.position;
    const double x = cosineTo(hit, {1, 0, 0}), z = cosineTo(hit, {0, 0, 1});
    const double p = cosineTo(hit, way) / dot(way, way);
    return Vec3d{0.1 + 0.4 * x + 0.2 * z, 0.1 + 0.3 * z + 0.5 * p, 0.1 + 2 * p};
  };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

TEST_P(LightSources, IntensityAboveOneSaturatesAtTheEndOnly)
{
  Stage stage = sphereStage();
  stage.lights = {directional({-1, -1, -4}, {4, 2, 0.5f})};
  stage.instances[0].material.diffuse = 0.5f;
  const auto lit = [](const Hit& hit) { return Vec3d{2, 1, 0.25} * cosineTo(hit, {1, 1, 4}); };
  expectPicture(stage, draw(stage), hitSphere, lit, kRounding + 2 * kFacets);
}

constexpr double kPi = 3.14159265358979323846;

TEST_P(LightSources, SpotFadesToItsEdgeOverTheSoftBand)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.lights = {spot(40, 0)};
  stage.lights[0].softDegrees = 15;
  const auto lit = [](const Hit& hit) {
    const double cosine = normalized(Vec3d{0, 0, 1} - hit.position).z;
    const double edge = std::cos(40 * kDegrees), inner = std::cos(25 * kDegrees);
    const double t = std::clamp((cosine - edge) / (inner - edge), 0.0, 1.0);
    return gray(cosine * t * t * (3 - 2 * t));
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.02);
}

TEST_P(LightSources, PointOfPowerPHasTheIntensityPOver4Pi)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  const Vec3d from = {0.3, -0.2, 1.4};
  stage.lights = {point(from, {18, 12, 6}, {1, 2, 3})};
  stage.lights[0].unit = LightUnit::kPower;
  const auto lit = [&](const Hit& hit) {
    const Vec3d way = from - hit.position;
    return Vec3d{18, 12, 6} * (cosineTo(hit, way) / (4 * kPi * dot(way, way)));
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.02);
}

TEST_P(LightSources, SpotOfPowerPIsAPointLightInAScreen)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.lights = {spot(40, 0)};
  stage.lights[0].color = {9, 9, 9};
  stage.lights[0].unit = LightUnit::kPower;
  const auto lit = [](const Hit& hit) -> std::optional<Vec3d> {
    const Vec3d way = Vec3d{0, 0, 1} - hit.position;
    const double cosine = normalized(way).z;
    if (std::fabs(cosine - std::cos(40 * kDegrees)) < 1e-3) return std::nullopt;
    const bool inside = cosine > std::cos(40 * kDegrees);
    return gray(inside ? 9 * cosine / (4 * kPi * dot(way, way)) : 0);
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.02);
}

Light rectangle(Vec3d position, Vec3d halfA, Vec3d halfB, int samples)
{
  Light light = point(position, {1, 1, 1});
  light.kind = LightKind::kRectangle;
  light.halfSide[0] = halfA;
  light.halfSide[1] = halfB;
  light.samples = samples;
  return light;
}

Light ball(Vec3d position, double radius, int samples)
{
  Light light = point(position, {1, 1, 1});
  light.kind = LightKind::kSphere;
  light.radius = radius;
  light.samples = samples;
  return light;
}

TEST_P(LightSources, RectangleOfOneSampleIsAPointAtItsCentreWithTheCosineToItsFront)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.lights = {rectangle({0.2, 0.1, 1}, {0, 0.7, 0}, {0.9, 0, 0}, 1)};
  const auto lit = [](const Hit& hit) {
    const Vec3d way = Vec3d{0.2, 0.1, 1} - hit.position;
    return gray(std::pow(normalized(way).z, 2) / dot(way, way));
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.02);
}

TEST_P(LightSources, RectangleSendsNothingBackwards)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.lights = {rectangle({0.2, 0.1, 1}, {0.9, 0, 0}, {0, 0.7, 0}, 64)};
  const auto dark = [](const Hit&) { return gray(0); };
  expectPicture(stage, draw(stage), hitPlane, dark, 0);
}

/// Form factor from a spot of a plane to a rectangle parallel to it, whose corner is straight above
/// the spot: x and y are its sides over the distance. Odd in both.
double formFactor(double x, double y)
{
  const double a = std::sqrt(1 + x * x), b = std::sqrt(1 + y * y);
  return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * kPi);
}

TEST_P(LightSources, ManySamplesOfARectangleNearTheIntegralOverIt)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  const double a = 0.6, b = 0.4, height = 0.8;
  const Vec3d centre = {0.1, -0.3, height};
  stage.lights = {rectangle(centre, {0, b, 0}, {a, 0, 0}, 512)};
  const auto lit = [&](const Hit& hit) {
    const Vec3d p = hit.position - centre;
    double sum = 0;
    for (const double x : {p.x - a, p.x + a})
      for (const double y : {p.y - b, p.y + b}) {
        const double sign = (x == p.x + a) == (y == p.y + b) ? 1 : -1;
        sum += sign * formFactor(x / height, y / height);
      }
    return gray(sum * kPi / (4 * a * b));
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.6);
}

TEST_P(LightSources, RectangleOfPowerPSendsPOverPiStraightAhead)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  stage.width = stage.height = 95;
  stage.lights = {rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 1)};
  stage.lights[0].color = {2, 2, 2};
  stage.lights[0].unit = LightUnit::kPower;
  EXPECT_NEAR(at(draw(stage), 47, 47).g, 255 * 2 / kPi, kRounding);
}

TEST_P(LightSources, BallLightsWhatLiesOutsideItLikeItsCentre)
{
  const OwnedMesh mesh = plane();
  Stage stage = planeStage(mesh);
  const Vec3d centre = {-0.2, 0.3, 1.1};
  stage.lights = {ball(centre, 0.5, 8192)};
  // Newton's theorem of shells: the field of 1 / r^2 about a ball of even density.
  const auto lit = [&](const Hit& hit) {
    const Vec3d way = centre - hit.position;
    return gray(cosineTo(hit, way) / dot(way, way));
  };
  expectPicture(stage, draw(stage), hitPlane, lit, kRounding + 0.6);
}

TEST(SampledLights, FillTheirBallEvenly)
{
  constexpr int kSamples = 8192;
  const Light light = ball({0, 0, 0}, 2, kSamples);
  const Mat4d identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  Vec3d sum = {0, 0, 0};
  double squares = 0, inner = 0;
  for (const ViewLight& sample : placeLights({&light, 1}, {identity, identity, false})) {
    const Vec3d p = vec3Cast<double>(sample.position);
    sum = sum + p;
    squares += dot(p, p);
    inner += dot(p, p) < 1;
  }
  EXPECT_NEAR(squares / kSamples, 4 * 3.0 / 5, 0.01);
  EXPECT_NEAR(inner / kSamples, 1.0 / 8, 0.003) << "half the radius has an eighth of the volume";
  for (const double mean : {sum.x, sum.y, sum.z})
    EXPECT_NEAR(mean / kSamples, 0, 0.01);
}

TEST_P(LightSources, BallReachesPointsThatItsCentreDoesNot)
{
  Stage stage = sphereStage();
  stage.lights = {ball({0, 0, 3}, 1.9, 200)};
  const Picture soft = draw(stage);
  stage.lights = {point({0, 0, 3}, {1, 1, 1})};
  const Picture hard = draw(stage);
  std::size_t more = 0, less = 0;
  for (std::size_t i = 0; i < soft.color.size(); ++i) {
    more += hard.color[i].r == 0 && soft.color[i].r > 0;
    less += hard.color[i].r > 0 && soft.color[i].r == 0;
  }
  EXPECT_GT(more, 100u);
  EXPECT_EQ(less, 0u);
}

}  // namespace
}  // namespace limn::testing
