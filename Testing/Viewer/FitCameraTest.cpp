// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FitCamera.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn::viewer
{
namespace
{

/// The largest |x| and |y| of the box's corners in the picture, whose edges are at 1.
struct Extent
{
  double x = 0, y = 0;
};

Extent extentOf(const vtkBoundingBox& box, double aspect, vtkCamera& camera)
{
  Extent extent;
  camera.SetClippingRange(0.001, 1e6);
  vtkMatrix4x4* const matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[4] = { 0, 0, 0, 1 };
    box.GetCorner(corner, point);
    matrix->MultiplyPoint(point, point);
    EXPECT_GT(point[3], 0) << "in front of the eye";
    extent.x = std::max(extent.x, std::abs(point[0] / point[3]));
    extent.y = std::max(extent.y, std::abs(point[1] / point[3]));
  }
  return extent;
}

/// The corners of a box as a subject.
class Corners
{
public:
  explicit Corners(const vtkBoundingBox& box)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      double point[3];
      box.GetCorner(corner, point);
      points_->InsertNextPoint(point);
    }
    subject = { box, { points_ } };
  }

  Subject subject;

private:
  vtkNew<vtkPoints> points_;
};

/// The box as the camera sees it after a fit.
Extent fittedExtent(const CameraSettings& settings, const vtkBoundingBox& box, double aspect)
{
  vtkNew<vtkCamera> camera;
  fitCamera(settings, Corners(box).subject, aspect, *camera);
  return extentOf(box, aspect, *camera);
}

TEST(FitCamera, TheBoxFillsThePictureAndStaysInside)
{
  const vtkBoundingBox boxes[] = { { -1, 1, -1, 1, -1, 1 }, { 0, 9, 0, 1, 0, 1 },
    { 5, 6, 0, 20, -3, 3 } };
  for (const vtkBoundingBox& box : boxes)
  {
    for (const double aspect : { 0.5, 1.0, 5.0 / 3 })
    {
      for (const bool orthographic : { false, true })
      {
        CameraSettings settings;
        settings.orthographic = orthographic;
        const Extent extent = fittedExtent(settings, box, aspect);
        EXPECT_NEAR(std::max(extent.x, extent.y), 0.92, 1e-9) << aspect << orthographic;
      }
    }
  }
}

TEST(FitCamera, TheMeshStandsUprightWhateverAxisIsUp)
{
  const Corners cube({ -1, 1, -1, 1, -1, 1 });
  for (const Vector3& up : { Vector3{ 1, 0, 0 }, Vector3{ -1, 0, 0 }, Vector3{ 0, 1, 0 },
         Vector3{ 0, -1, 0 }, Vector3{ 0, 0, 1 }, Vector3{ 0, 0, -1 } })
  {
    CameraSettings settings;
    settings.up = up;
    vtkNew<vtkCamera> camera;
    fitCamera(settings, cube.subject, 1, *camera);
    double top[4] = { up[0], up[1], up[2], 1 };
    camera->GetViewTransformMatrix()->MultiplyPoint(top, top);
    EXPECT_NEAR(top[0], 0, 1e-12);
    EXPECT_GT(top[1], 0.5);
  }
}

TEST(FitCamera, WhatTheUserGivesStays)
{
  CameraSettings settings;
  settings.position = Vector3{ 7, 8, 9 };
  settings.focalPoint = Vector3{ 1, 2, 3 };
  settings.viewUp = Vector3{ 0, 0, 1 };
  settings.viewAngleDegrees = 50;
  settings.orthographic = true;
  settings.parallelScale = 4;
  vtkNew<vtkCamera> camera;
  fitCamera(settings, Corners({ -1, 1, -1, 1, -1, 1 }).subject, 1, *camera);
  EXPECT_EQ(camera->GetPosition()[1], 8);
  EXPECT_EQ(camera->GetFocalPoint()[2], 3);
  EXPECT_EQ(camera->GetViewUp()[2], 1);
  EXPECT_EQ(camera->GetViewAngle(), 50);
  EXPECT_EQ(camera->GetParallelScale(), 4);
}

TEST(FitCamera, LookingAlongUpChoosesAnotherUp)
{
  CameraSettings settings;
  settings.position = Vector3{ 0, 10, 0 };
  vtkNew<vtkCamera> camera;
  fitCamera(settings, Corners({ -1, 1, -1, 1, -1, 1 }).subject, 1, *camera);
  EXPECT_NE(camera->GetViewUp()[1], 1);
  EXPECT_NE(camera->GetViewTransformMatrix()->Determinant(), 0);
}

TEST(FitCamera, PointsOutsideOfTheBoxDoNotCount)
{
  const Corners cube({ -1, 1, -1, 1, -1, 1 });
  const Corners far({ -9, 9, -9, 9, -9, 9 });
  Subject subject = cube.subject;
  subject.points.push_back(far.subject.points[0]);
  vtkNew<vtkCamera> camera, expected;
  fitCamera({}, subject, 1, *camera);
  fitCamera({}, cube.subject, 1, *expected);
  EXPECT_EQ(camera->GetDistance(), expected->GetDistance());
}

TEST(FitCamera, APointIsSeenFromSomewhere)
{
  vtkNew<vtkCamera> camera;
  fitCamera({}, Corners({ 3, 3, 3, 3, 3, 3 }).subject, 1, *camera);
  EXPECT_GT(camera->GetDistance(), 0);
  EXPECT_GT(camera->GetParallelScale(), 0);
}

} // namespace
} // namespace limn::viewer
