// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFromRenderer.h"

#include "vtkLimnLight.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn::bridge
{
namespace
{

Vec3f toVec3f(const double* v)
{
  return vec3Cast<float>(Vec3d{ v[0], v[1], v[2] });
}

// VTK's cone is a spot only below this angle.
constexpr double kWidestCone = 90;

Light positionalLight(vtkLight* source)
{
  Light light;
  const double* const attenuation = source->GetAttenuationValues();
  light.attenuation = toVec3f(attenuation);
  light.kind = LightKind::kPoint;
  if (source->GetConeAngle() < kWidestCone)
  {
    light.kind = LightKind::kSpot;
    light.coneDegrees = static_cast<float>(std::max(source->GetConeAngle(), 0.0));
    light.exponent = static_cast<float>(source->GetExponent());
  }
  return light;
}

Vec3d transformedVector(vtkLight* source, Vec3d vector)
{
  double from[3] = { vector.x, vector.y, vector.z };
  double to[3] = { vector.x, vector.y, vector.z };
  if (source->GetTransformMatrix())
  {
    source->TransformVector(from, to);
  }
  return { to[0], to[1], to[2] };
}

/// Half the sides of a rectangle that faces the focal point, in the light's own coordinates.
std::array<Vec3d, 2> halfSidesOf(vtkLimnLight* source)
{
  const double* const position = source->GetPosition();
  const double* const focus = source->GetFocalPoint();
  const double* const up = source->GetViewUp();
  const Vec3d ahead =
    normalized(Vec3d{ focus[0] - position[0], focus[1] - position[1], focus[2] - position[2] });
  Vec3d right = cross(Vec3d{ up[0], up[1], up[2] }, ahead);
  if (right == Vec3d{ 0, 0, 0 })
  {
    right = cross(std::fabs(ahead.y) < 0.9 ? Vec3d{ 0, 1, 0 } : Vec3d{ 0, 0, 1 }, ahead);
  }
  right = normalized(right);
  return { right * (source->GetWidth() / 2), cross(ahead, right) * (source->GetHeight() / 2) };
}

/// By which factor lengths grow, on the average, in the light's transform.
double scaleOf(vtkLight* source)
{
  vtkMatrix4x4* const matrix = source->GetTransformMatrix();
  return matrix ? std::cbrt(std::fabs(matrix->Determinant())) : 1;
}

void setShape(vtkLimnLight* source, Light& light)
{
  light.samples = source->GetSamples();
  if (source->GetShape() == vtkLimnLight::SHAPE_SPHERE)
  {
    light.kind = LightKind::kSphere;
    light.radius = source->GetRadius() * scaleOf(source);
  }
  else if (source->GetShape() == vtkLimnLight::SHAPE_RECTANGLE)
  {
    light.kind = LightKind::kRectangle;
    const auto [width, height] = halfSidesOf(source);
    light.halfSide[0] = transformedVector(source, width);
    light.halfSide[1] = transformedVector(source, height);
  }
  light.softDegrees = static_cast<float>(source->GetSoftEdgeAngle());
  if (source->GetUnit() == vtkLimnLight::UNIT_POWER)
  {
    light.unit = LightUnit::kPower;
  }
}

Light translate(vtkLight* source)
{
  Light light;
  vtkLimnLight* const limn = vtkLimnLight::SafeDownCast(source);
  if (source->GetPositional() || (limn && limn->GetShape() != vtkLimnLight::SHAPE_POINT))
  {
    light = positionalLight(source);
  }
  else
  {
    light.kind = source->LightTypeIsHeadlight() ? LightKind::kHeadlight : LightKind::kDirectional;
  }
  double position[3];
  double focus[3];
  source->GetTransformedPosition(position);
  source->GetTransformedFocalPoint(focus);
  light.position = { position[0], position[1], position[2] };
  light.direction = Vec3d{ focus[0], focus[1], focus[2] } - light.position;
  light.color = toVec3f(source->GetDiffuseColor()) * static_cast<float>(source->GetIntensity());
  if (limn)
  {
    setShape(limn, light);
  }
  return light;
}

/// Where position and focal point are one, VTK's shaders have a light that reaches nothing.
bool pointsNowhere(const Light& light)
{
  return (light.kind == LightKind::kDirectional || light.kind == LightKind::kSpot) &&
         light.direction == Vec3d{ 0, 0, 0 };
}

} // namespace

Mat4d toMat4(vtkMatrix4x4* matrix)
{
  Mat4d result{};
  for (int row = 0; row < 4; ++row)
  {
    std::copy_n(matrix->Element[row], 4, result.m[row]);
  }
  return result;
}

Camera cameraOf(vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Mat4d worldToView = toMat4(camera->GetModelViewTransformMatrix());
  const Mat4d viewToClip =
    toMat4(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  return { worldToView, viewToClip, camera->GetParallelProjection() != 0 };
}

std::vector<Light> lightsOf(vtkRenderer* renderer)
{
  std::vector<Light> lights;
  vtkLightCollection* const sources = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  sources->InitTraversal(iterator);
  while (vtkLight* const source = sources->GetNextLight(iterator))
  {
    const Light light = translate(source);
    if (source->GetSwitch() && !pointsNowhere(light))
    {
      lights.push_back(light);
    }
  }
  return lights;
}

bool isUnlit(vtkRenderer* renderer)
{
  vtkLightCollection* const sources = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  sources->InitTraversal(iterator);
  while (vtkLight* const source = sources->GetNextLight(iterator))
  {
    if (source->GetSwitch())
    {
      return false;
    }
  }
  return true;
}

Vec3f ambientLightOf(vtkRenderer* renderer)
{
  return toVec3f(renderer->GetAmbient());
}

} // namespace limn::bridge
