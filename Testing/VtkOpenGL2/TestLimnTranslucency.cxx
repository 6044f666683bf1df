// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent surfaces beside VTK's own picture by depth peeling, and in OpenGL windows beside
// OpenGL's actors.
#include "GLScene.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkSuperquadricSource.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace
{
using MakeActor = vtkSmartPointer<vtkActor> (*)(vtkAlgorithmOutput*);

vtkSmartPointer<vtkActor> MakeLimnActor(vtkAlgorithmOutput* source)
{
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  vtkNew<vtkLimnProperty> property;
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkLimnActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}

vtkSmartPointer<vtkActor> MakeSphere(MakeActor make, double x, double radius, double opacity)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, 0.1, 0.0);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkSmartPointer<vtkActor> actor = make(sphere->GetOutputPort());
  actor->GetProperty()->SetColor(0.9, 0.3 + x / 2, 0.2);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

/// Upright, facing the camera.
vtkSmartPointer<vtkActor> MakePane(MakeActor make, double z, double opacity)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.9, -0.8, z);
  plane->SetPoint1(0.7, -0.9, z);
  plane->SetPoint2(-0.8, 0.8, z);
  vtkSmartPointer<vtkActor> actor = make(plane->GetOutputPort());
  actor->GetProperty()->SetColor(0.3, 0.9, 0.5);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

void AddSphere(vtkRenderer* renderer, MakeActor make)
{
  renderer->AddActor(MakeSphere(make, 0, 0.8, 0.4));
}

void AddNested(vtkRenderer* renderer, MakeActor make)
{
  renderer->AddActor(MakeSphere(make, 0, 0.9, 0.3));
  renderer->AddActor(MakeSphere(make, 0.2, 0.5, 0.6));
  renderer->AddActor(MakeSphere(make, -0.4, 0.3, 1.0));
}

/// What is opaque comes first.
void AddBefore(vtkRenderer* renderer, MakeActor make)
{
  renderer->AddActor(MakeSphere(make, 0.2, 0.5, 1));
  renderer->AddActor(MakePane(make, 0.8, 0.5));
  renderer->AddActor(MakePane(make, -0.8, 0.5));
}

void AddCrossing(vtkRenderer* renderer, MakeActor make)
{
  renderer->AddActor(MakeSphere(make, 0.3, 0.6, 0.5));
  renderer->AddActor(MakePane(make, 0.1, 0.5));
  renderer->AddActor(MakePane(make, -0.3, 0.7));
  renderer->AddActor(MakeSphere(make, -0.3, 0.6, 0.5));
}

void AddTorus(vtkRenderer* renderer, MakeActor make)
{
  vtkNew<vtkSuperquadricSource> source;
  source->ToroidalOn();
  source->SetThickness(0.4);
  source->SetSize(0.8);
  source->SetThetaResolution(64);
  source->SetPhiResolution(64);
  vtkSmartPointer<vtkActor> actor = make(source->GetOutputPort());
  actor->RotateX(60);
  actor->GetProperty()->SetOpacity(0.35);
  actor->GetMapper()->ScalarVisibilityOff();
  renderer->AddActor(actor);
}

/// Opacity from a lookup table.
void AddScalars(vtkRenderer* renderer, MakeActor make)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0, -0.5, 0);
  elevation->SetHighPoint(0, 0.5, 0);
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.1, 0.9);
  table->Build();
  vtkSmartPointer<vtkActor> actor = make(elevation->GetOutputPort());
  actor->GetMapper()->SetLookupTable(table);
  actor->SetScale(1.6);
  renderer->AddActor(actor);
  renderer->AddActor(MakePane(make, -0.7, 1.0));
}

/// Opacity from a texture.
void AddTexture(vtkRenderer* renderer, MakeActor make)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int i = 0; i < 64; ++i)
  {
    const double rgba[4] = { 30.0 * (i % 8), 200.0, 25.0 * (i / 8), 4.0 * i };
    for (int channel = 0; channel < 4; ++channel)
    {
      image->SetScalarComponentFromDouble(i % 8, i / 8, 0, channel, rgba[channel]);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkSmartPointer<vtkActor> actor = MakePane(make, 0.5, 0.9);
  actor->SetTexture(texture);
  renderer->AddActor(actor);
  renderer->AddActor(MakeSphere(make, 0, 0.6, 1));
}

struct Case
{
  const char* Name;
  void (*Add)(vtkRenderer*, MakeActor);
};

std::ostream& operator<<(std::ostream& os, const Case& one)
{
  return os << one.Name;
}

const Case AllCases[] = { { "Sphere", AddSphere }, { "Nested", AddNested }, { "Before", AddBefore },
  { "Crossing", AddCrossing }, { "Torus", AddTorus }, { "Scalars", AddScalars },
  { "Texture", AddTexture } };

/// VTK's own, by dual depth peeling, all layers.
Picture Peeled(void (*add)(vtkRenderer*, MakeActor))
{
  GLScene scene(0);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(100);
  scene.Renderer->SetOcclusionRatio(0);
  add(scene.Renderer, MakeGLActor);
  const Picture picture = scene.Render();
  EXPECT_TRUE(scene.Renderer->GetLastRenderingUsedDepthPeeling());
  return picture;
}

/// OpenGL rounds to bytes each time it blends: half a level for each of up to six layers.
void ExpectAlike(const Picture& expected, const Picture& picture)
{
  const double pixels = expected.Width * expected.Height;
  testing::Test::RecordProperty("moreThan1", CountDifferent(expected, picture, 1));
  testing::Test::RecordProperty("moreThan2", CountDifferent(expected, picture, 2));
  testing::Test::RecordProperty("moreThan3", CountDifferent(expected, picture, 3));
  EXPECT_LT(CountDifferent(expected, picture, 2), 0.01 * pixels);
  EXPECT_LT(CountDifferent(expected, picture, 3), 0.001 * pixels);
}
} // namespace

class TranslucentCase : public testing::TestWithParam<Case>
{
};

TEST_P(TranslucentCase, InLimnsWindowLooksAsPeeledByVtk)
{
  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(200, 160);
  window->SetMultiSamples(0);
  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.3);
  window->AddRenderer(renderer);
  GLScene::SetUpCamera(renderer);
  GetParam().Add(renderer, MakeLimnActor);
  window->Render();
  const Picture picture = ReadPicture(window);
  ExpectAlike(Peeled(GetParam().Add), picture);
}

TEST_P(TranslucentCase, InOpenGLsWindowLooksAsPeeledByVtk)
{
  for (const bool peels : { false, true })
  {
    GLScene scene(0);
    scene.Renderer->SetUseDepthPeeling(peels);
    scene.Renderer->SetMaximumNumberOfPeels(100);
    GetParam().Add(scene.Renderer, MakeLimnActor);
    const Picture first = scene.Render();
    ExpectAlike(Peeled(GetParam().Add), first);
    EXPECT_EQ(CountDifferent(first, scene.Render()), 0) << "the next frame";
  }
}

INSTANTIATE_TEST_SUITE_P(All, TranslucentCase, testing::ValuesIn(AllCases),
  [](const auto& test) { return std::string(test.param.Name); });

// OpenGL's opaque actors hide what lies behind them, and show through what lies before them.
TEST(TranslucentLayer, IsSortedAmongOpenGLsOpaqueActors)
{
  for (const int samples : { 0, 4 })
  {
    const auto add = [](vtkRenderer* renderer, MakeActor opaque, MakeActor translucent)
    {
      renderer->AddActor(MakePane(translucent, 0.5, 0.4));
      renderer->AddActor(MakeSphere(opaque, 0.2, 0.6, 1));
      renderer->AddActor(MakePane(translucent, 0.0, 0.6));
      renderer->AddActor(MakePane(opaque, -0.7, 1));
      renderer->AddActor(MakePane(translucent, -0.9, 0.9));
    };
    GLScene vtk(0);
    vtk.Renderer->UseDepthPeelingOn();
    vtk.Renderer->SetMaximumNumberOfPeels(100);
    add(vtk.Renderer, MakeGLActor, MakeGLActor);
    GLScene mixed(samples);
    add(mixed.Renderer, MakeGLActor, MakeLimnActor);
    const Picture expected = vtk.Render();
    const Picture picture = mixed.Render();
    const double pixels = expected.Width * expected.Height;
    // With several samples the borders differ.
    EXPECT_LT(CountDifferent(expected, picture, 2), (samples == 0 ? 0.002 : 0.05) * pixels);
    EXPECT_EQ(CountDifferent(picture, mixed.Render()), 0);
  }
}

// Depths of several samples are one for a pixel: only the borders show it.
TEST(TranslucentLayer, WithSeveralSamplesLooksAsInLimnsWindow)
{
  GLScene scene(4);
  AddCrossing(scene.Renderer, MakeLimnActor);
  scene.Renderer->AddActor(MakeSphere(MakeLimnActor, 0, 0.4, 1));
  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(200, 160);
  window->SetMultiSamples(4);
  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.3);
  window->AddRenderer(renderer);
  GLScene::SetUpCamera(renderer);
  AddCrossing(renderer, MakeLimnActor);
  renderer->AddActor(MakeSphere(MakeLimnActor, 0, 0.4, 1));
  window->Render();
  const Picture exact = ReadPicture(window);
  const Picture picture = scene.Render();
  const double pixels = exact.Width * exact.Height;
  RecordProperty("moreThan2", CountDifferent(exact, picture, 2));
  RecordProperty("moreThan8", CountDifferent(exact, picture, 8));
  EXPECT_LT(CountDifferent(exact, picture, 2), 0.05 * pixels);
  EXPECT_LT(CountDifferent(exact, picture, 8), 0.02 * pixels);
}

// Whole layers: OpenGL's translucent actors lie over Limn's, wherever they are.
TEST(TranslucentLayer, LiesBehindOpenGLsTranslucentActors)
{
  for (const bool peels : { false, true })
  {
    Picture pictures[2];
    for (const int before : { 0, 1 })
    {
      GLScene scene(0);
      scene.Renderer->SetUseDepthPeeling(peels);
      scene.Renderer->AddActor(MakePane(MakeLimnActor, 0.0, 0.5));
      scene.Renderer->AddActor(MakePane(MakeGLActor, before ? 0.5 : -0.5, 0.5));
      pictures[before] = scene.Render();
    }
    EXPECT_EQ(CountDifferent(pictures[0], pictures[1]), 0) << peels;
    GLScene scene(0);
    scene.Renderer->UseDepthPeelingOn();
    scene.Renderer->AddActor(MakePane(MakeGLActor, 0.0, 0.5));
    scene.Renderer->AddActor(MakePane(MakeGLActor, 0.5, 0.5));
    // In alpha VTK's weighted blending has another sum.
    Picture expected = scene.Render();
    for (size_t i = 3; i < expected.Bytes.size(); i += 4)
    {
      expected.Bytes[i] = pictures[1].Bytes[i];
    }
    EXPECT_LT(CountDifferent(pictures[1], expected, 2), 30) << peels;
  }
}

// Blending leaves OpenGL's depths as they are, and its state.
TEST(TranslucentLayer, LeavesDepthAndStateAsTheyWere)
{
  GLScene with(0);
  GLScene without(0);
  for (GLScene* scene : { &with, &without })
  {
    scene->Renderer->AddActor(MakeSphere(MakeGLActor, 0.2, 0.5, 1));
    scene->Renderer->AddActor(MakeSphere(MakeGLActor, -0.2, 0.4, 0.5));
  }
  with.Renderer->AddActor(MakePane(MakeLimnActor, 0.6, 0.0));
  EXPECT_EQ(CountDifferent(with.Render(), without.Render()), 0);
  EXPECT_EQ(with.ReadDepth(), without.ReadDepth());
}

// Two renderers side by side: each reads and blends its own part of the window.
TEST(TranslucentLayer, KeepsToItsViewport)
{
  GLScene scene(0);
  vtkNew<vtkRenderer> right;
  scene.Renderer->SetViewport(0, 0, 0.5, 1);
  right->SetViewport(0.5, 0, 1, 1);
  right->SetBackground(0.1, 0.2, 0.3);
  scene.Window->AddRenderer(right);
  GLScene::SetUpCamera(right);
  for (vtkRenderer* renderer : { scene.Renderer.Get(), right.Get() })
  {
    renderer->AddActor(MakePane(MakeGLActor, 0.5, 1));
    renderer->GetActors()->GetLastActor()->SetScale(0.5);
    renderer->AddActor(MakePane(MakeLimnActor, 0.0, 0.5));
  }
  const Picture picture = scene.Render();
  int different = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      different += !std::equal(picture.At(x, y), picture.At(x, y) + 3, picture.At(x + 100, y));
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_NE(picture.At(20, 80)[1], 51) << "the pane shows";
}
