// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limn's actors in OpenGL windows, beside OpenGL's, against the same scenes drawn wholly by OpenGL.
#include "GLScene.h"
#include "Looks.h"
#include "SelectedIds.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"
#include "vtkLimnToneLegend.h"

#include "vtkCallbackCommand.h"
#include "vtkCameraPass.h"
#include "vtkCellPicker.h"
#include "vtkConeSource.h"
#include "vtkElevationFilter.h"
#include "vtkFXAAOptions.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPointDataToCellData.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <tuple>

namespace
{
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

using MakeActor = vtkSmartPointer<vtkActor> (*)(vtkAlgorithmOutput*);

vtkSmartPointer<vtkActor> MakeSphere(MakeActor make)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkSmartPointer<vtkActor> actor = make(sphere->GetOutputPort());
  actor->GetProperty()->SetColor(0.9, 0.7, 0.3);
  return actor;
}

/// A wall behind the others.
vtkSmartPointer<vtkActor> MakeWall(MakeActor make)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.9, -0.9, -0.8);
  plane->SetPoint1(0.9, -0.8, -0.8);
  plane->SetPoint2(-0.8, 0.9, -0.8);
  vtkSmartPointer<vtkActor> actor = make(plane->GetOutputPort());
  actor->GetProperty()->SetColor(0.9, 0.9, 1.0);
  return actor;
}

/// A cone that goes through the sphere.
vtkSmartPointer<vtkActor> MakeCone(MakeActor make)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(30);
  cone->SetHeight(2.0);
  cone->SetRadius(0.5);
  cone->SetDirection(1.0, 0.4, 0.6);
  vtkSmartPointer<vtkActor> actor = make(cone->GetOutputPort());
  actor->GetProperty()->SetColor(0.2, 0.7, 0.4);
  return actor;
}

/// The share of pixels with a channel that differs by more than `tolerance`, in percent.
double PercentDifferent(const Picture& a, const Picture& b, int tolerance)
{
  return 100.0 * CountDifferent(a, b, tolerance) / (a.Width * a.Height);
}

/// One sample per pixel: the same pixels are covered. Both light in single precision, in another
/// order of operations, so a channel that falls on the border of two levels may take either.
void ExpectAlikeButRounding(const Picture& expected, const Picture& picture)
{
  EXPECT_EQ(CountDifferent(expected, picture, 1), 0);
  EXPECT_LT(PercentDifferent(expected, picture, 0), 0.5);
}

/// Several samples per pixel: the same samples are covered. In a pixel of several triangles OpenGL
/// lights each at the pixel's centre, even outside the triangle, and averages bytes; that differs
/// by a few levels along the edges of the mesh. A layer has one depth per pixel, so where surfaces
/// cross, and only there, the samples of a pixel are not told apart.
void ExpectAlikeButCrossings(const Picture& expected, const Picture& picture)
{
  EXPECT_LT(PercentDifferent(expected, picture, 3), 2.0);
  EXPECT_LT(PercentDifferent(expected, picture, 8), 0.3);
}
} // namespace

class SceneTest : public testing::TestWithParam<int>
{
protected:
  GLScene Wholly{ GetParam() };
  GLScene Mixed{ GetParam() };

  void ExpectScenesAlike()
  {
    const Picture expected = this->Wholly.Render();
    const Picture mixed = this->Mixed.Render();
    if (GetParam() == 0)
    {
      ExpectAlikeButRounding(expected, mixed);
    }
    else
    {
      ExpectAlikeButCrossings(expected, mixed);
    }
    RecordProperty("moreThan0", CountDifferent(expected, mixed));
    RecordProperty("moreThan8", CountDifferent(expected, mixed, 8));
  }
};

// As in the window without OpenGL, before and behind actors of OpenGL; a translucent outline of an
// opaque actor lets the background through.
TEST(LimnOutline, GoesThroughTheWindowsDepth)
{
  GLScene scene(0);
  vtkSmartPointer<vtkActor> sphere = MakeSphere(MakeLimnActor);
  scene.Renderer->AddActor(MakeWall(MakeGLActor));
  scene.Renderer->AddActor(sphere);
  auto* const property = vtkLimnProperty::SafeDownCast(sphere->GetProperty());
  const Picture without = scene.Render();
  property->SetOutlineToHull();
  property->SetOutlineColor(0, 1, 0);
  property->SetOutlineWidth(6);
  const Picture with = scene.Render();
  // The sphere has 56 pixels of radius around (100, 80).
  const auto at = [](const Picture& picture, int x, int channel)
  { return int{ picture.Bytes[4 * (80 * picture.Width + x) + channel] }; };
  for (int x = 100 + 57; x < 100 + 61; ++x)
  {
    EXPECT_EQ(at(with, x, 0), 0) << x;
    EXPECT_EQ(at(with, x, 1), 255) << x;
  }
  for (const int x : { 100, 140, 165, 190 })
  {
    EXPECT_EQ(at(with, x, 0), at(without, x, 0)) << x;
    EXPECT_EQ(at(with, x, 1), at(without, x, 1)) << x;
  }
  property->SetOutlineOpacity(0.5);
  const Picture faint = scene.Render();
  EXPECT_NEAR(at(faint, 159, 0), at(without, 159, 0) / 2, 1);
  EXPECT_NEAR(at(faint, 159, 1), (at(without, 159, 1) + 255) / 2, 1);
  EXPECT_EQ(at(faint, 140, 1), at(without, 140, 1));
}

TEST_P(SceneTest, AloneLooksAsInOpenGL)
{
  this->Wholly.Renderer->AddActor(MakeSphere(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeSphere(MakeLimnActor));
  this->ExpectScenesAlike();
}

TEST_P(SceneTest, IntersectsOpenGLsActors)
{
  this->Wholly.Renderer->AddActor(MakeSphere(MakeGLActor));
  this->Wholly.Renderer->AddActor(MakeCone(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeSphere(MakeLimnActor));
  this->Mixed.Renderer->AddActor(MakeCone(MakeGLActor));
  this->ExpectScenesAlike();
}

TEST_P(SceneTest, SeveralActorsIntersectEachOther)
{
  for (GLScene* scene : { &this->Wholly, &this->Mixed })
  {
    MakeActor make = scene == &this->Wholly ? MakeGLActor : MakeLimnActor;
    scene->Renderer->AddActor(MakeCone(make));
    scene->Renderer->AddActor(MakeWall(MakeGLActor));
    scene->Renderer->AddActor(MakeSphere(make));
  }
  this->ExpectScenesAlike();
}

// What OpenGL draws later behind an edge has to show in the edge's pixels, and nothing of the
// background: else a fringe runs along the edge.
TEST_P(SceneTest, EdgesBlendWithWhatIsDrawnLater)
{
  for (GLScene* scene : { &this->Wholly, &this->Mixed })
  {
    scene->Renderer->SetBackground(0.0, 0.0, 0.0);
    scene->Renderer->AddActor(MakeSphere(scene == &this->Wholly ? MakeGLActor : MakeLimnActor));
    scene->Renderer->AddActor(MakeWall(MakeGLActor));
  }
  this->ExpectScenesAlike();
  EXPECT_EQ(CountDifferent(this->Wholly.Read(), this->Mixed.Read(), 32), 0) << "a fringe";
}

// The depth test decides, not the order in which the props were added.
TEST_P(SceneTest, DoesNotDependOnTheOrderOfProps)
{
  this->Wholly.Renderer->AddActor(MakeSphere(MakeLimnActor));
  this->Wholly.Renderer->AddActor(MakeCone(MakeGLActor));
  this->Wholly.Renderer->AddActor(MakeWall(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeWall(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeCone(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeSphere(MakeLimnActor));
  EXPECT_EQ(CountDifferent(this->Wholly.Render(), this->Mixed.Render()), 0);
}

TEST_P(SceneTest, FollowsTheWindowsSize)
{
  this->Wholly.Renderer->AddActor(MakeSphere(MakeGLActor));
  this->Wholly.Renderer->AddActor(MakeCone(MakeGLActor));
  this->Mixed.Renderer->AddActor(MakeSphere(MakeLimnActor));
  this->Mixed.Renderer->AddActor(MakeCone(MakeGLActor));
  const int sizes[3][2] = { { 200, 160 }, { 333, 222 }, { 90, 120 } };
  for (const auto& size : sizes)
  {
    this->Wholly.Window->SetSize(size[0], size[1]);
    this->Mixed.Window->SetSize(size[0], size[1]);
    this->ExpectScenesAlike();
  }
}

TEST_P(SceneTest, KeepsViewportsAndLayersApart)
{
  for (GLScene* scene : { &this->Wholly, &this->Mixed })
  {
    MakeActor make = scene == &this->Wholly ? MakeGLActor : MakeLimnActor;
    scene->Window->SetNumberOfLayers(2);
    scene->Renderer->SetViewport(0.0, 0.0, 0.55, 1.0);
    scene->Renderer->AddActor(MakeSphere(make));
    scene->Renderer->AddActor(MakeCone(MakeGLActor));
    vtkNew<vtkRenderer> beside;
    beside->SetViewport(0.55, 0.2, 1.0, 1.0);
    beside->AddActor(MakeCone(make));
    vtkNew<vtkRenderer> above;
    above->SetViewport(0.2, 0.0, 0.8, 0.6);
    above->SetLayer(1);
    above->AddActor(MakeSphere(make));
    for (vtkRenderer* renderer : { beside.Get(), above.Get() })
    {
      GLScene::SetUpCamera(renderer);
      scene->Window->AddRenderer(renderer);
    }
  }
  this->ExpectScenesAlike();
}
INSTANTIATE_TEST_SUITE_P(MultiSamples, SceneTest, testing::Values(0, 4));

class FallbackTest : public testing::TestWithParam<std::tuple<Look, int>>
{
};

// What Limn does not draw is drawn by VTK's own classes: the same bytes.
TEST_P(FallbackTest, EqualsVtkByteForByte)
{
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(MakeQuads());
  Picture pictures[2];
  for (int limn = 0; limn < 2; ++limn)
  {
    GLScene scene(std::get<1>(GetParam()));
    vtkSmartPointer<vtkActor> actor =
      limn ? MakeLimnActor(source->GetOutputPort()) : MakeGLActor(source->GetOutputPort());
    std::get<0>(GetParam()).Apply(actor);
    scene.Renderer->AddActor(actor);
    pictures[limn] = scene.Render();
  }
  EXPECT_EQ(CountDifferent(pictures[0], pictures[1]), 0);
}
INSTANTIATE_TEST_SUITE_P(LooksThatLimnLeavesToVtk, FallbackTest,
  testing::Combine(testing::ValuesIn(Looks + 1, std::end(Looks)), testing::Values(0, 4)),
  [](const auto& test)
  {
    return std::string(std::get<0>(test.param).Name) + "With" +
           std::to_string(std::get<1>(test.param)) + "Samples";
  });

/// The parameters of FXAA that take ways of their own.
struct FxaaCase
{
  const char* Name;
  void (*SetUp)(vtkFXAAOptions*);
};

std::ostream& operator<<(std::ostream& os, const FxaaCase& one)
{
  return os << one.Name;
}

const FxaaCase AllFxaaCases[] = {
  { "Default", [](vtkFXAAOptions*) {} },
  { "EndpointsByMeans", [](vtkFXAAOptions* options) { options->UseHighQualityEndpointsOff(); } },
  { "EdgesOnly",
    [](vtkFXAAOptions* options)
    {
      options->SetSubpixelBlendLimit(0);
      options->SetEndpointSearchIterations(30);
    } },
  { "Sensitive",
    [](vtkFXAAOptions* options)
    {
      options->SetRelativeContrastThreshold(0.05f);
      options->SetHardContrastThreshold(0.02f);
      options->SetSubpixelContrastThreshold(0);
      options->SetSubpixelBlendLimit(1);
    } },
};

class FxaaTest : public testing::TestWithParam<FxaaCase>
{
protected:
  static void SetUp(vtkRenderer* renderer, MakeActor make)
  {
    renderer->AddActor(MakeSphere(make));
    renderer->AddActor(MakeCone(make));
    renderer->AddActor(MakeWall(make));
    renderer->UseFXAAOn();
    GetParam().SetUp(renderer->GetFXAAOptions());
  }
  static Picture ByVtk()
  {
    GLScene scene(0);
    SetUp(scene.Renderer, MakeGLActor);
    return scene.Render();
  }
};

// VTK's own pass works on the picture that Limn's layer is part of.
TEST_P(FxaaTest, WorksOnLimnsLayerInOpenGLsWindow)
{
  GLScene mixed(0);
  SetUp(mixed.Renderer, MakeLimnActor);
  const Picture expected = ByVtk();
  const Picture smooth = mixed.Render();
  EXPECT_LT(PercentDifferent(expected, smooth, 1), 0.1);
  mixed.Renderer->UseFXAAOff();
  EXPECT_GT(PercentDifferent(smooth, mixed.Render(), 8), 1);
}

// Limn's is the same algorithm: but where the two pictures' lit colours differ by rounding, and for
// the coarse weights with which llvmpipe mixes texels, it gives the same picture.
TEST_P(FxaaTest, InLimnsWindowLooksAsVtks)
{
  vtkNew<vtkLimnRenderWindow> window;
  window->SetSize(200, 160);
  window->SetMultiSamples(0);
  vtkNew<vtkLimnRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.3);
  window->AddRenderer(renderer);
  GLScene::SetUpCamera(renderer);
  SetUp(renderer, MakeLimnActor);
  window->Render();
  const Picture picture = ReadPicture(window);
  const Picture expected = ByVtk();
  RecordProperty("moreThan1", CountDifferent(expected, picture, 1));
  RecordProperty("moreThan2", CountDifferent(expected, picture, 2));
  RecordProperty("moreThan8", CountDifferent(expected, picture, 8));
  EXPECT_LT(PercentDifferent(expected, picture, 2), 0.1);
}
INSTANTIATE_TEST_SUITE_P(Options, FxaaTest, testing::ValuesIn(AllFxaaCases),
  [](const auto& test) { return std::string(test.param.Name); });

struct Passes
{
  const char* Name;
  void (*SetUp)(vtkRenderer*);
};

std::ostream& operator<<(std::ostream& os, const Passes& passes)
{
  return os << passes.Name;
}

const Passes AllPasses[] = {
  { "SSAA",
    [](vtkRenderer* renderer)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAAPass> pass;
      pass->SetDelegatePass(steps);
      renderer->SetPass(pass);
    } },
  { "SSAO",
    [](vtkRenderer* renderer)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAOPass> pass;
      pass->SetRadius(0.3);
      pass->SetDelegatePass(steps);
      renderer->SetPass(pass);
    } },
  { "ShadowMap",
    [](vtkRenderer* renderer)
    {
      vtkNew<vtkShadowMapPass> shadows;
      vtkNew<vtkRenderPassCollection> passes;
      passes->AddItem(shadows->GetShadowMapBakerPass());
      passes->AddItem(shadows);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(passes);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      renderer->SetPass(camera);
    } },
  { "UseSSAO",
    [](vtkRenderer* renderer)
    {
      renderer->UseSSAOOn();
      renderer->SetSSAORadius(0.3);
    } },
  { "UseShadows", [](vtkRenderer* renderer) { renderer->UseShadowsOn(); } },
};

class PassTest : public testing::TestWithParam<Passes>
{
};

// Render passes reach into the shaders of VTK's own mapper, which therefore draws: the same bytes.
TEST_P(PassTest, EqualsVtkByteForByte)
{
  Picture pictures[3];
  for (int limn = 0; limn < 2; ++limn)
  {
    GLScene scene(0);
    MakeActor make = limn ? MakeLimnActor : MakeGLActor;
    scene.Renderer->AddActor(MakeWall(make));
    scene.Renderer->AddActor(MakeSphere(make));
    vtkNew<vtkLight> light;
    light->SetPosition(1.0, 1.0, 3.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->PositionalOn();
    light->SetConeAngle(30.0);
    scene.Renderer->AddLight(light);
    pictures[2] = scene.Render();
    GetParam().SetUp(scene.Renderer);
    pictures[limn] = scene.Render();
  }
  EXPECT_GT(CountDifferent(pictures[0], pictures[2]), 50) << "the pass shows";
  EXPECT_EQ(CountDifferent(pictures[0], pictures[1]), 0);
}
INSTANTIATE_TEST_SUITE_P(All, PassTest, testing::ValuesIn(AllPasses),
  [](const auto& test) { return std::string(test.param.Name); });

// From Limn to VTK and back while the window lives.
TEST(LimnInGLWindow, ChangesBetweenLimnAndFallback)
{
  GLScene scene(0);
  vtkSmartPointer<vtkActor> actor = MakeSphere(MakeLimnActor);
  scene.Renderer->AddActor(actor);
  const Picture before = scene.Render();
  actor->GetProperty()->SetOpacity(0.5);
  EXPECT_GT(CountDifferent(before, scene.Render(), 20), 1000);
  actor->GetProperty()->SetOpacity(1.0);
  EXPECT_EQ(CountDifferent(before, scene.Render()), 0);
}

// A frame from another side draws from what the first one prepared.
TEST(LimnInGLWindow, ShowsTheToneLegend)
{
  GLScene scene(0);
  vtkNew<vtkLookupTable> table;
  table->Build();
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  property->SetToneOverDataToUndertone();
  vtkNew<vtkLimnToneLegend> legend;
  legend->SetLookupTable(table);
  legend->SetSurfaceProperty(property);
  legend->SetNumberOfValues(16);
  legend->SetNumberOfTones(8);
  legend->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  legend->SetPosition(10, 20);
  legend->GetPosition2Coordinate()->SetCoordinateSystemToViewport();
  legend->SetPosition2(160, 80);
  scene.Renderer->AddActor2D(legend);
  const auto isShown = [&]
  {
    const Picture picture = scene.Render();
    vtkImageData* const image = legend->GetImage();
    int wrong = 0;
    for (int row = 0; row < 8; ++row)
    {
      for (int column = 0; column < 16; ++column)
      {
        const auto* const own =
          static_cast<const unsigned char*>(image->GetScalarPointer(column, row, 0));
        wrong += !std::equal(own, own + 3, picture.At(15 + 10 * column, 25 + 10 * row));
      }
    }
    const unsigned char* const background = picture.At(190, 150);
    wrong += !std::equal(background, background + 3, picture.At(8, 25));
    wrong += !std::equal(background, background + 3, picture.At(172, 98));
    return wrong == 0;
  };
  EXPECT_TRUE(isShown());
  property->SetToneOverDataToClassic();
  EXPECT_TRUE(isShown());
}

TEST(LimnInGLWindow, PreparesGeometryOnce)
{
  GLScene scene(4);
  vtkSmartPointer<vtkActor> actor = MakeSphere(MakeLimnActor);
  scene.Renderer->AddActor(actor);
  const Picture first = scene.Render();
  auto* mapper = vtkLimnPolyDataMapper::SafeDownCast(actor->GetMapper());
  const vtkIdType builds = mapper->GetNumberOfGeometryBuilds();
  EXPECT_GT(builds, 0);
  scene.Renderer->GetActiveCamera()->Azimuth(30.0);
  EXPECT_GT(CountDifferent(first, scene.Render()), 500);
  EXPECT_EQ(mapper->GetNumberOfGeometryBuilds(), builds);
}

// Culling is set up around each actor; one that is culled must not cost another its picture.
TEST(LimnInGLWindow, CullsAsOpenGLDoes)
{
  Picture pictures[2];
  for (int limn = 0; limn < 2; ++limn)
  {
    MakeActor make = limn ? MakeLimnActor : MakeGLActor;
    GLScene scene(0);
    vtkSmartPointer<vtkActor> hollow = MakeSphere(make);
    hollow->GetProperty()->FrontfaceCullingOn();
    scene.Renderer->AddActor(hollow);
    vtkSmartPointer<vtkActor> cone = MakeCone(make);
    cone->GetProperty()->BackfaceCullingOn();
    scene.Renderer->AddActor(cone);
    pictures[limn] = scene.Render();
  }
  ExpectAlikeButRounding(pictures[0], pictures[1]);
}

TEST(LimnInGLWindow, IsUnlitWithoutLights)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  vtkNew<vtkElevationFilter> ofPoints;
  ofPoints->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkPointDataToCellData> ofCells;
  ofCells->SetInputConnection(ofPoints->GetOutputPort());
  for (vtkAlgorithmOutput* colors :
    { sphere->GetOutputPort(), ofPoints->GetOutputPort(), ofCells->GetOutputPort() })
  {
    Picture pictures[2];
    for (int limn = 0; limn < 2; ++limn)
    {
      GLScene scene(0);
      scene.Renderer->AutomaticLightCreationOff();
      vtkSmartPointer<vtkActor> actor = limn ? MakeLimnActor(colors) : MakeGLActor(colors);
      actor->GetProperty()->SetColor(0.9, 0.6, 0.2);
      actor->GetProperty()->SetAmbientColor(0.1, 0.5, 1.0);
      actor->GetProperty()->SetAmbient(0.2);
      actor->GetProperty()->SetDiffuse(0.6);
      actor->GetProperty()->SetSpecular(0.5);
      scene.Renderer->AddActor(actor);
      pictures[limn] = scene.Render();
    }
    ExpectAlikeButRounding(pictures[0], pictures[1]);
  }
}

namespace
{
struct Metal
{
  double Metallic;
  double Roughness;
  double Index;
};

void AddLamps(vtkRenderer* renderer)
{
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(2.0, 3.0, 2.0);
  sun->SetColor(1.0, 0.8, 0.7);
  renderer->AddLight(sun);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetPosition(-1.0, 0.5, 1.5);
  lamp->SetAttenuationValues(0.5, 0.0, 1.0);
  lamp->SetConeAngle(40.0);
  lamp->SetExponent(2.0);
  renderer->AddLight(lamp);
}
}

namespace
{
void MakePhysicallyBased(vtkProperty* property, const Metal& metal)
{
  property->SetInterpolationToPBR();
  property->SetMetallic(metal.Metallic);
  property->SetRoughness(metal.Roughness);
  property->SetBaseIOR(metal.Index);
  property->SetEdgeTint(0.5, 0.8, 1.0);
  property->SetAmbient(0.3);
}

void ExpectMetalAsInOpenGL(
  const Metal& metal, const std::string& name, void (*arrange)(vtkRenderer*, vtkActor*))
{
  Picture pictures[2];
  for (int mixed : { 0, 1 })
  {
    GLScene scene(0);
    vtkSmartPointer<vtkActor> sphere = MakeSphere(mixed ? MakeLimnActor : MakeGLActor);
    MakePhysicallyBased(sphere->GetProperty(), metal);
    scene.Renderer->AddActor(sphere);
    arrange(scene.Renderer, sphere);
    pictures[mixed] = scene.Render();
  }
  EXPECT_EQ(CountDifferent(pictures[0], pictures[1], 1), 0)
    << metal.Metallic << ' ' << metal.Roughness << ' ' << name;
}

void AddSun(vtkRenderer* renderer, double x, double y, double z)
{
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(x, y, z);
  sun->SetColor(1.0, 0.8, 0.7);
  renderer->AddLight(sun);
}
}

TEST(LimnInGLWindow, PhysicallyBasedMaterialsLookAsInOpenGL)
{
  for (const Metal& metal : { Metal{ 0.0, 0.4, 1.5 }, Metal{ 1.0, 0.3, 1.5 },
         Metal{ 0.5, 0.6, 2.0 }, Metal{ 0.2, 0.0, 1.5 } })
  {
    ExpectMetalAsInOpenGL(metal, "headlight", [](vtkRenderer*, vtkActor*) {});
    ExpectMetalAsInOpenGL(
      metal, "lamps", [](vtkRenderer* renderer, vtkActor*) { AddLamps(renderer); });
  }
}

TEST(LimnInGLWindow, PhysicallyBasedMaterialsLookAsInOpenGLInOtherLights)
{
  const Metal metal = { 0.4, 0.5, 1.7 };
  ExpectMetalAsInOpenGL(metal, "parallel projection",
    [](vtkRenderer* renderer, vtkActor*)
    {
      renderer->GetActiveCamera()->ParallelProjectionOn();
      renderer->GetActiveCamera()->SetParallelScale(1.0);
    });
  ExpectMetalAsInOpenGL(metal, "two suns",
    [](vtkRenderer* renderer, vtkActor*)
    {
      AddSun(renderer, 2.0, 3.0, 2.0);
      AddSun(renderer, -2.0, 1.0, 0.5);
    });
  ExpectMetalAsInOpenGL(metal, "dim light from the eye",
    [](vtkRenderer* renderer, vtkActor*)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToHeadlight();
      light->SetColor(0.9, 0.6, 0.3);
      light->SetIntensity(0.5);
      renderer->AddLight(light);
    });
  ExpectMetalAsInOpenGL(metal, "darker by its coefficient",
    [](vtkRenderer*, vtkActor* sphere) { sphere->GetProperty()->SetDiffuse(0.6); });
  ExpectMetalAsInOpenGL(metal, "coloured by data",
    [](vtkRenderer*, vtkActor* sphere)
    {
      vtkNew<vtkElevationFilter> heights;
      heights->SetInputConnection(sphere->GetMapper()->GetInputConnection(0, 0));
      heights->SetLowPoint(0.0, -0.7, 0.0);
      heights->SetHighPoint(0.0, 0.7, 0.0);
      sphere->GetMapper()->SetInputConnection(heights->GetOutputPort());
    });
}

TEST(LimnInGLWindow, AnswersHardwareSelectors)
{
  GLScene scene(0);
  vtkSmartPointer<vtkActor> sphere = MakeSphere(MakeLimnActor);
  vtkSmartPointer<vtkActor> cone = MakeCone(MakeGLActor);
  scene.Renderer->AddActor(sphere);
  scene.Renderer->AddActor(cone);
  GLScene expected(0);
  vtkSmartPointer<vtkActor> expectedSphere = MakeSphere(MakeGLActor);
  vtkSmartPointer<vtkActor> expectedCone = MakeCone(MakeGLActor);
  expected.Renderer->AddActor(expectedSphere);
  expected.Renderer->AddActor(expectedCone);
  for (int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    const Picture before = scene.Render();
    expected.Render();
    SelectedIds selected = Select(scene, association);
    SelectedIds expectedIds = Select(expected, association);
    EXPECT_GT(expectedIds[expectedSphere].size(), 100u);
    EXPECT_EQ(selected[sphere], expectedIds[expectedSphere]);
    EXPECT_EQ(selected[cone], expectedIds[expectedCone]);
    EXPECT_EQ(CountDifferent(before, scene.Render()), 0) << "a selection leaves no trace";
  }
}

TEST(LimnInGLWindow, AnswersCellPickers)
{
  GLScene scene(0);
  vtkSmartPointer<vtkActor> sphere = MakeSphere(MakeLimnActor);
  scene.Renderer->AddActor(sphere);
  scene.Render();
  vtkNew<vtkCellPicker> picker;
  ASSERT_TRUE(picker->Pick(100, 80, 0, scene.Renderer));
  EXPECT_EQ(picker->GetActor(), sphere);
  EXPECT_NEAR(picker->GetPickPosition()[2], 0.7, 0.01);
  EXPECT_FALSE(picker->Pick(5, 5, 0, scene.Renderer));
}

TEST(LimnWindow, RefusesAnInteractorThatNeedsAScreen)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  ASSERT_STREQ(interactor->GetClassName(), "vtkXRenderWindowInteractor");
  vtkNew<vtkLimnRenderWindow> window;
  std::string message;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&message);
  listener->SetCallback([](vtkObject*, unsigned long, void* to, void* text)
    { *static_cast<std::string*>(to) += static_cast<const char*>(text); });
  window->AddObserver(vtkCommand::ErrorEvent, listener);
  interactor->SetRenderWindow(window);
  EXPECT_NE(message.find("vtkLimnRenderWindowInteractor"), std::string::npos) << message;
  EXPECT_EQ(interactor->GetRenderWindow(), nullptr);
  EXPECT_EQ(window->GetInteractor(), nullptr);
}
