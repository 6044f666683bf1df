// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/PlaceLights.h"

#include "Rendering/Base/Power.h"

#include <cstdint>
#include <limits>

namespace limn {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A coordinate of the additive sequence 1/2, 1/2 + a, 1/2 + 2 a ..., modulo 1, from -1 to 1.
class AdditiveSequence {
 public:
  /// a in units of 2^-32.
  explicit AdditiveSequence(std::uint32_t step) : step_(step) {}

  double next()
  {
    const double value = (value_ - 2147483648.0) / 2147483648.0;
    value_ += step_;
    return value;
  }

 private:
  std::uint32_t step_, value_ = 0x80000000u;
};

// a = 1/g, 1/g^2, ... of the number g > 1 with g^3 = g + 1, and for the ball with g^4 = g + 1.
constexpr std::uint32_t kSteps2[] = {3242174889u, 2447445414u};
constexpr std::uint32_t kSteps3[] = {3518319155u, 2882110345u, 2360945575u};

/// Cone, soft band and exponent, each a constant of the batch.
void shape(const Light& light, ViewLight& view)
{
  const double outer = cosineOfDegrees(light.coneDegrees);
  const double inner = cosineOfDegrees(light.coneDegrees - light.softDegrees);
  const double scale = 1.0 / (inner - outer);
  const bool isSoft =
      light.softDegrees > 0 && inner > outer && scale <= std::numeric_limits<float>::max();
  view.coneCosine = static_cast<float>(outer);
  view.softScale = isSoft ? static_cast<float>(scale) : 0.0f;
  view.exponent = light.exponent;
}

float intensityOf(const Light& light)
{
  if (light.unit == LightUnit::kIntensity) return 1.0f;
  return static_cast<float>(light.kind == LightKind::kRectangle ? 1.0 / kPi : 1.0 / (4.0 * kPi));
}

ViewLight atItsPosition(const Light& light, const Camera& camera)
{
  const Vec3d along = light.kind == LightKind::kRectangle
                          ? cross(light.halfSide[0], light.halfSide[1])
                          : light.direction;
  const Vec3d direction = normalized(transformDirection(camera.worldToView, along));
  ViewLight view;
  view.kind = light.kind;
  view.position = vec3Cast<float>(transformPoint(camera.worldToView, light.position));
  view.towardLight =
      light.kind == LightKind::kHeadlight ? Vec3f{0, 0, 1} : vec3Cast<float>(-direction);
  view.color = light.color * intensityOf(light);
  view.attenuation = light.unit == LightUnit::kPower ? Vec3f{0, 0, 1} : light.attenuation;
  shape(light, view);
  return view;
}

/// Calls place(offset from the light's position) for each of its samples.
template <class Place>
void forEachSample(const Light& light, Place place)
{
  if (light.kind == LightKind::kRectangle) {
    AdditiveSequence u(kSteps2[0]), v(kSteps2[1]);
    for (int i = 0; i < light.samples; ++i) {
      const double s = u.next(), t = v.next();
      place(light.halfSide[0] * s + light.halfSide[1] * t);
    }
    return;
  }
  AdditiveSequence x(kSteps3[0]), y(kSteps3[1]), z(kSteps3[2]);
  for (int i = 0; i < light.samples;) {
    const double px = x.next(), py = y.next(), pz = z.next();
    const Vec3d p = {px, py, pz};
    if (dot(p, p) > 1.0) continue;
    place(p * light.radius);
    ++i;
  }
}

}  // namespace

std::vector<ViewLight> placeLights(Span<const Light> lights, const Camera& camera)
{
  std::vector<ViewLight> placed;
  for (const Light& light : lights) {
    ViewLight view = atItsPosition(light, camera);
    if (light.kind != LightKind::kRectangle && light.kind != LightKind::kSphere) {
      placed.push_back(view);
      continue;
    }
    if (light.kind == LightKind::kSphere) view.kind = LightKind::kPoint;
    view.color = view.color * (1.0f / static_cast<float>(light.samples));
    forEachSample(light, [&](Vec3d offset) {
      view.position = vec3Cast<float>(transformPoint(camera.worldToView, light.position + offset));
      placed.push_back(view);
    });
  }
  return placed;
}

}  // namespace limn
