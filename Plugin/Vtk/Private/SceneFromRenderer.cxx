// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFromRenderer.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>

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

Light translate(vtkLight* source)
{
  Light light;
  if (source->GetPositional())
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
