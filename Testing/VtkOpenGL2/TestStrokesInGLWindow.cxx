// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of the mesh in an OpenGL window, beside those in Limn's own.
#include "GLScene.h"

#include "vtkLimnActor.h"
#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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

using MakeScene = std::function<void(vtkRenderer*)>;

Picture InLimnsWindow(int multiSamples, const MakeScene& make)
{
  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(200, 160);
  window->SetMultiSamples(multiSamples);
  vtkNew<vtkLimnRenderer> renderer;
  window->AddRenderer(renderer);
  GLScene::SetUpCamera(renderer);
  make(renderer);
  window->Render();
  return ReadPicture(window);
}

Picture InOpenGLsWindow(int multiSamples, const MakeScene& make)
{
  GLScene scene(multiSamples);
  make(scene.Renderer);
  return scene.Render();
}

constexpr double SideLength = 80;
constexpr double LineWidth = 2.5;

/// Red, eighty pixels a side and turned by some degrees, with a border, half of which lies outside.
vtkSmartPointer<vtkActor> MakeSquare(double degrees, double opacity = 1)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkLimnProperty> property;
  property->SetColor(1, 0, 0);
  property->LightingOff();
  property->BorderLinesOn();
  property->SetStrokeColor(0, 0.5, 0.25);
  property->SetStrokeWidth(LineWidth);
  property->SetStrokeOpacity(opacity);
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkLimnActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  actor->RotateZ(degrees);
  actor->SetScale(SideLength / 80);
  actor->SetPosition(0.013, -0.021, 0);
  return actor;
}

/// All over the window and of one colour, by the mapper of whoever it is for.
vtkSmartPointer<vtkActor> MakeSheet(double z, bool isLimns)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2, -2, z);
  plane->SetPoint1(2, -2, z);
  plane->SetPoint2(-2, 2, z);
  vtkSmartPointer<vtkActor> actor;
  if (isLimns)
  {
    vtkNew<vtkLimnPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    actor = vtkSmartPointer<vtkLimnActor>::New();
    actor->SetMapper(mapper);
  }
  else
  {
    actor = MakeGLActor(plane->GetOutputPort());
  }
  actor->GetProperty()->SetColor(0.8, 1, 0.9);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// What is missing to white in the first channel, in whole pixels.
double InkOf(const Picture& picture)
{
  double ink = 0;
  for (size_t i = 0; i < picture.Bytes.size(); i += 4)
  {
    ink += (255 - picture.Bytes[i]) / 255.0;
  }
  return ink;
}

/// Pixels that differ by more than a level. Of those that the square shares with what is behind it,
/// none: their samples become one before a line is mixed in or after that.
int CountWrong(const Picture& expected, const Picture& actual, double degrees, int multiSamples)
{
  const Picture square = InLimnsWindow(multiSamples,
    [&](vtkRenderer* renderer)
    {
      renderer->SetBackground(1, 1, 1);
      vtkSmartPointer<vtkActor> plain = MakeSquare(degrees);
      vtkLimnProperty::SafeDownCast(plain->GetProperty())->BorderLinesOff();
      renderer->AddActor(plain);
    });
  int wrong = 0;
  int compared = 0;
  for (size_t i = 0; i < square.Bytes.size(); i += 4)
  {
    const unsigned char green = square.Bytes[i + 1];
    if (green == 0 || green == 255)
    {
      ++compared;
      for (size_t channel = i; channel < i + 3; ++channel)
      {
        wrong += std::abs(expected.Bytes[channel] - actual.Bytes[channel]) > 1;
      }
    }
  }
  EXPECT_GE(compared, multiSamples > 0 ? 31400 : 32000);
  return wrong;
}

// A stroke's end is mitred: the band about a square is one of its perimeter.
TEST_P(StrokesTest, AreAsSmoothOverTheBackgroundAsInTheWindowWithoutOpenGL)
{
  for (const double degrees : { 0.0, 7.0, 31.0, 45.0 })
  {
    const MakeScene make = [&](vtkRenderer* renderer)
    {
      renderer->SetBackground(1, 1, 1);
      renderer->AddActor(MakeSquare(degrees));
    };
    const Picture expected = InLimnsWindow(GetParam(), make);
    const Picture actual = InOpenGLsWindow(GetParam(), make);
    EXPECT_EQ(CountWrong(expected, actual, degrees, GetParam()), 0) << degrees;
    // The surface, red on white, has no ink of its own.
    EXPECT_NEAR(InkOf(actual), 4 * SideLength * LineWidth, 5) << degrees;
    EXPECT_NEAR(InkOf(actual) / InkOf(expected), 1, GetParam() > 0 ? 0.01 : 0.001) << degrees;
  }
}

// In whatever order the actors come. The plane is behind the lines and their square.
TEST_P(StrokesTest, AreAsSmoothOverWhatOpenGLDrawsBehindThem)
{
  for (const bool isSheetFirst : { true, false })
  {
    const auto make = [&](bool isLimns)
    {
      return [=](vtkRenderer* renderer)
      {
        vtkSmartPointer<vtkActor> sheet = MakeSheet(-1, isLimns);
        if (isSheetFirst)
        {
          renderer->AddActor(sheet);
        }
        renderer->AddActor(MakeSquare(31));
        if (!isSheetFirst)
        {
          renderer->AddActor(sheet);
        }
      };
    };
    const Picture expected = InLimnsWindow(GetParam(), make(true));
    const Picture actual = InOpenGLsWindow(GetParam(), make(false));
    EXPECT_EQ(CountWrong(expected, actual, 31, GetParam()), 0) << isSheetFirst;
  }
}

TEST_P(StrokesTest, AreHiddenByWhatOpenGLDrawsBeforeThem)
{
  for (const bool isSheetFirst : { true, false })
  {
    GLScene scene(GetParam());
    scene.Renderer->AddActor(MakeSheet(1, false));
    const Picture sheet = scene.Render();
    scene.Renderer->RemoveAllViewProps();
    const vtkSmartPointer<vtkActor> actors[2] = { MakeSheet(1, false), MakeSquare(31) };
    scene.Renderer->AddActor(actors[isSheetFirst ? 0 : 1]);
    scene.Renderer->AddActor(actors[isSheetFirst ? 1 : 0]);
    EXPECT_EQ(CountDifferent(scene.Render(), sheet), 0) << isSheetFirst;
  }
}

// Lines that let something through let OpenGL's through, too.
TEST_P(StrokesTest, OfSomeOpacityShowWhatOpenGLDrawsBehindThem)
{
  const auto make = [&](bool isLimns)
  {
    return [=](vtkRenderer* renderer)
    {
      renderer->AddActor(MakeSquare(31, 0.4));
      renderer->AddActor(MakeSheet(-1, isLimns));
    };
  };
  const Picture expected = InLimnsWindow(GetParam(), make(true));
  const Picture actual = InOpenGLsWindow(GetParam(), make(false));
  EXPECT_EQ(CountWrong(expected, actual, 31, GetParam()), 0);
}

/// As the object factory makes it in programs with windows of OpenGL.
vtkSmartPointer<vtkActor> AsFactorysActor(vtkActor* actor)
{
  const auto compositor = vtkSmartPointer<vtkLimnCompositor>::Take(vtkLimnCompositor::New());
  auto made = vtkSmartPointer<vtkActor>::Take(compositor->NewActor());
  EXPECT_STREQ(made->GetClassName(), "vtkLimnOpenGLActor");
  made->ShallowCopy(actor);
  return made;
}

// These have a pass of their own, after that of the opaque actors.
TEST_P(StrokesTest, AreUnderTranslucentSurfacesOfOpenGL)
{
  for (const int way : { 0, 1, 2, 3 })
  {
    const bool isSheetFirst = way % 2 == 0;
    GLScene scene(GetParam());
    vtkSmartPointer<vtkActor> square = MakeSquare(31);
    if (way >= 2)
    {
      square = AsFactorysActor(square);
    }
    scene.Renderer->AddActor(square);
    const Picture without = scene.Render();
    scene.Renderer->RemoveAllViewProps();
    vtkSmartPointer<vtkActor> sheet = MakeSheet(1, false);
    sheet->GetProperty()->SetOpacity(0.5);
    scene.Renderer->AddActor(isSheetFirst ? sheet : square);
    scene.Renderer->AddActor(isSheetFirst ? square : sheet);
    const Picture actual = scene.Render();
    int wrong = 0;
    for (int y = 0; y < 160; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        // Samples become one after the sheet is blended, which differs where they do.
        const double expected = 0.5 * 255 + 0.5 * without.At(x, y)[1];
        wrong += std::abs(actual.At(x, y)[1] - expected) > 2;
      }
    }
    EXPECT_LE(wrong, GetParam() > 0 ? 4 * SideLength * 1.5 : 0) << way;
  }
}

TEST_P(StrokesTest, OfTranslucentSurfacesAreAsSmooth)
{
  const auto make = [&](bool isLimns)
  {
    return [=](vtkRenderer* renderer)
    {
      vtkSmartPointer<vtkActor> square = MakeSquare(31);
      square->GetProperty()->SetOpacity(0.5);
      renderer->AddActor(square);
      renderer->AddActor(MakeSheet(-1, isLimns));
    };
  };
  const Picture expected = InLimnsWindow(GetParam(), make(true));
  const Picture actual = InOpenGLsWindow(GetParam(), make(false));
  // One more rounding: OpenGL keeps bytes of the surface, and mixes the lines in then.
  EXPECT_LE(CountDifferent(expected, actual, 2), GetParam() > 0 ? 4 * SideLength * 1.5 : 0);
}

// Each viewport has its own lines; a frame leaves none to the next.
TEST_P(StrokesTest, StayInTheirViewportAndFrame)
{
  GLScene scene(GetParam());
  scene.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0, 1, 1);
  other->SetBackground(1, 1, 1);
  GLScene::SetUpCamera(other);
  scene.Window->AddRenderer(other);
  scene.Renderer->AddActor(MakeSquare(7));
  const Picture first = scene.Render();
  EXPECT_EQ(CountDifferent(scene.Render(), first), 0);
  other->AddActor(MakeSquare(7));
  const Picture both = scene.Render();
  for (int y = 0; y < 160; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      ASSERT_EQ(both.At(x, y)[1], first.At(x, y)[1]) << x << ' ' << y;
      ASSERT_EQ(first.At(x + 100, y)[1], 255) << x << ' ' << y;
    }
  }
  scene.Renderer->RemoveAllViewProps();
  other->RemoveAllViewProps();
  const Picture empty = scene.Render();
  for (int x = 0; x < 200; ++x)
  {
    ASSERT_EQ(empty.At(x, 40)[1], x < 100 ? 51 : 255) << x;
  }
}

TEST_P(StrokesTest, AreDrawnWithActorsThatAreNotLimnsToo)
{
  const auto make = [&](bool isLimns)
  {
    return [=](vtkRenderer* renderer)
    {
      renderer->SetBackground(1, 1, 1);
      vtkSmartPointer<vtkActor> square = MakeSquare(31);
      if (!isLimns)
      {
        vtkSmartPointer<vtkActor> plain = vtkSmartPointer<vtkOpenGLActor>::New();
        plain->ShallowCopy(square);
        square = plain;
      }
      renderer->AddActor(square);
    };
  };
  EXPECT_EQ(CountDifferent(
              InOpenGLsWindow(GetParam(), make(true)), InOpenGLsWindow(GetParam(), make(false))),
    0);
}

INSTANTIATE_TEST_SUITE_P(MultiSamples, StrokesTest, ::testing::Values(0, 8));
}
