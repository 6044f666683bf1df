// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of the mesh in an OpenGL window, beside those in Limn's own.
#include "GLScene.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace
{
/// Blue, with a red contour three pixels wide.
vtkSmartPointer<vtkActor> MakeSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.6);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkLimnProperty> property;
  property->SetColor(0, 0, 1);
  property->LightingOff();
  property->ContourLinesOn();
  property->SetStrokeColor(1, 0, 0);
  property->SetStrokeWidth(3);
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkLimnActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}

/// OpenGL's, over the right half of the window.
vtkSmartPointer<vtkActor> MakeCurtain(double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, -0.9, z);
  plane->SetPoint1(1, -0.9, z);
  plane->SetPoint2(0, 0.9, z);
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkOpenGLActor>::New();
  vtkNew<vtkOpenGLProperty> property;
  property->SetColor(0, 1, 0);
  property->LightingOff();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}

/// Red of columns [first, end) as a number of whole pixels.
double RedOf(const Picture& picture, int first, int end)
{
  double red = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = first; x < end; ++x)
    {
      red += picture.At(x, y)[0] / 255.0;
    }
  }
  return red;
}

class StrokesTest : public ::testing::TestWithParam<int>
{
protected:
  GLScene Scene{ GetParam() };

  void SetUp() override { this->Scene.Renderer->SetBackground(0, 0, 0); }
};

// The radius is 48 pixels.
TEST_P(StrokesTest, HaveTheirWidthOverTheBackgroundToo)
{
  this->Scene.Renderer->AddActor(MakeSphere());
  const Picture picture = this->Scene.Render();
  const double circle = 2 * 3.14159265 * 48 * 3;
  EXPECT_NEAR(RedOf(picture, 0, picture.Width), circle, circle * (GetParam() > 0 ? 0.1 : 0.05));
}

TEST_P(StrokesTest, AreBeforeAndBehindOpenGLsActorsWhereTheirSurfaceIs)
{
  this->Scene.Renderer->AddActor(MakeSphere());
  const double whole = RedOf(this->Scene.Render(), 100, 200);
  vtkSmartPointer<vtkActor> curtain = MakeCurtain(1);
  this->Scene.Renderer->AddActor(curtain);
  EXPECT_LT(RedOf(this->Scene.Render(), 101, 200), 0.02 * whole);
  this->Scene.Renderer->RemoveActor(curtain);
  this->Scene.Renderer->AddActor(MakeCurtain(-1));
  EXPECT_NEAR(RedOf(this->Scene.Render(), 100, 200), whole, 0.02 * whole);
}

INSTANTIATE_TEST_SUITE_P(MultiSamples, StrokesTest, ::testing::Values(0, 8));
}
