// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FitCamera.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace limn::viewer
{
namespace
{

/// The part of the picture's width and height that the mesh may fill.
constexpr double kFill = 0.92;

/// Where the eye stands: this far to the right and up for each step to the front.
constexpr double kRight = 0.5, kUp = 0.45;

Vector3 plus(const Vector3& a, double factor, const Vector3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

double dot(const Vector3& a, const Vector3& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

Vector3 cross(const Vector3& a, const Vector3& b)
{
  Vector3 product;
  vtkMath::Cross(a.data(), b.data(), product.data());
  return product;
}

Vector3 normalized(Vector3 vector)
{
  vtkMath::Normalize(vector.data());
  return vector;
}

bool areParallel(const Vector3& a, const Vector3& b)
{
  constexpr double kSmallestSine = 1e-6;
  const Vector3 normal = cross(normalized(a), normalized(b));
  return std::sqrt(dot(normal, normal)) < kSmallestSine;
}

/// The view's axes: right and up in the picture, and back towards the eye.
struct Axes
{
  Vector3 right, up, back;
};

Axes axesOf(const Vector3& back, const Vector3& up)
{
  Axes axes;
  axes.back = normalized(back);
  axes.right = normalized(cross(up, axes.back));
  axes.up = cross(axes.back, axes.right);
  return axes;
}

/// From the mesh to the eye, where the user does not say.
Vector3 defaultBack(const Vector3& meshUp)
{
  const Vector3 right = meshUp[0] != 0 ? Vector3{ 0, 1, 0 } : Vector3{ 1, 0, 0 };
  const Vector3 front = cross(right, meshUp);
  return plus(plus(front, kRight, right), kUp, meshUp);
}

/// Up in the picture: the user's, else the mesh's, else what is not along the gaze.
Vector3 chooseUp(const CameraSettings& settings, const Vector3& back)
{
  const Vector3 candidates[] = { settings.viewUp.value_or(settings.up), settings.up, { 0, 1, 0 },
    { 0, 0, 1 } };
  return *std::find_if(std::begin(candidates), std::end(candidates),
    [&](const Vector3& up) { return !areParallel(up, back); });
}

/// How far from the centre of the box the eye must be at least, and half the height that a parallel
/// view must have at least.
struct Fit
{
  double distance = 0, halfHeight = 0;
};

Fit fitPoints(const Subject& subject, const Axes& axes, double tangent, double aspect)
{
  Vector3 center;
  subject.box.GetCenter(center.data());
  Fit fit;
  for (vtkPoints* const points : subject.points)
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      Vector3 point;
      points->GetPoint(i, point.data());
      if (!subject.box.ContainsPoint(point.data()))
      {
        continue;
      }
      const Vector3 offset = plus(point, -1, center);
      const double x = std::abs(dot(offset, axes.right));
      const double y = std::abs(dot(offset, axes.up));
      const double halfHeight = std::max(y, x / aspect) / kFill;
      fit.halfHeight = std::max(fit.halfHeight, halfHeight);
      fit.distance = std::max(fit.distance, dot(offset, axes.back) + halfHeight / tangent);
    }
  }
  // A single point has no size; any distance shows it.
  return fit.distance > 0 && fit.halfHeight > 0 ? fit : Fit{ 1, 1 };
}

} // namespace

void fitCamera(
  const CameraSettings& settings, const Subject& subject, double aspect, vtkCamera& camera)
{
  Vector3 center;
  subject.box.GetCenter(center.data());
  const Vector3 focalPoint = settings.focalPoint.value_or(center);
  Vector3 back = defaultBack(settings.up);
  if (settings.position && settings.position != focalPoint)
  {
    back = plus(*settings.position, -1, focalPoint);
  }
  const Vector3 up = chooseUp(settings, back);
  const Axes axes = axesOf(back, up);
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(settings.viewAngleDegrees) / 2);
  const Fit fit = fitPoints(subject, axes, tangent, aspect);
  const Vector3 position = settings.position.value_or(plus(focalPoint, fit.distance, axes.back));

  camera.SetFocalPoint(focalPoint.data());
  camera.SetPosition(position.data());
  camera.SetViewUp(up.data());
  camera.SetViewAngle(settings.viewAngleDegrees);
  camera.SetParallelProjection(settings.orthographic);
  camera.SetParallelScale(settings.parallelScale.value_or(fit.halfHeight));
}

} // namespace limn::viewer
