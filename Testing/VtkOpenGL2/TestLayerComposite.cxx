// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers made by hand against the same shapes drawn by OpenGL. What OpenGL itself drew, carried
// over as a layer, has to give back the very bytes.
#include "GLScene.h"
#include "LayerProp.h"
#include "Looks.h"

#include "Rendering/Base/SamplePositions.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <sstream>
#include <string>

namespace
{
const unsigned char Orange[3] = { 230, 120, 20 };

vtkSmartPointer<vtkActor> MakeSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.7);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  return MakeGLActor(sphere->GetOutputPort());
}

/// A cone that goes through the sphere.
vtkSmartPointer<vtkActor> MakeCone()
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(20);
  cone->SetHeight(2.0);
  cone->SetRadius(0.5);
  cone->SetDirection(1.0, 0.4, 0.6);
  vtkSmartPointer<vtkActor> actor = MakeGLActor(cone->GetOutputPort());
  actor->GetProperty()->SetColor(0.2, 0.7, 0.4);
  return actor;
}

/// What `scene` shows, as a layer that covers everything nearer than the far plane.
OwnedLayer LayerFrom(GLScene& scene)
{
  const Picture picture = scene.Render();
  const std::vector<float> depth = scene.ReadDepth();
  OwnedLayer layer(picture.Width, picture.Height, 1);
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const float z = depth[size_t(y) * picture.Width + x];
      layer.Set(x, y, picture.At(x, y), z, z < 1.0f ? 1 : 0);
    }
  }
  return layer;
}

/// A triangle in the plane z, given in pixels of a 200 x 160 window (see GLScene::SetUpCamera).
struct Triangle
{
  double X[3];
  double Y[3];

  bool Contains(double x, double y) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if ((X[j] - X[i]) * (y - Y[i]) - (Y[j] - Y[i]) * (x - X[i]) < 0.0)
      {
        return false;
      }
    }
    return true;
  }
};

vtkSmartPointer<vtkActor> MakeFlatTriangle(
  const Triangle& triangle, double z, const unsigned char rgb[3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint((triangle.X[i] - 100.0) / 80.0, (triangle.Y[i] - 80.0) / 80.0, z);
  }
  vtkNew<vtkCellArray> polys;
  const vtkIdType corners[3] = { 0, 1, 2 };
  polys->InsertNextCell(3, corners);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polys);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(data);
  vtkSmartPointer<vtkActor> actor = MakeGLActor(producer->GetOutputPort());
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
  return actor;
}

/// The same triangle as a layer: its samples tested one by one.
OwnedLayer LayerOf(const Triangle& triangle, float depth, int samples)
{
  OwnedLayer layer(200, 160, samples);
  const auto positions = limn::samplePositions(samples);
  for (int y = 0; y < 160; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      unsigned char coverage = 0;
      for (int s = 0; s < samples; ++s)
      {
        const limn::SampleOffset& offset = positions.begin()[s];
        coverage |= static_cast<unsigned char>(
          triangle.Contains(x + offset.x / 256.0, y + offset.y / 256.0) << s);
      }
      layer.Set(x, y, Orange, depth, coverage);
    }
  }
  return layer;
}

/// Corners lie on the 1/256 pixel grid to which OpenGL snaps them.
const Triangle Slanted = { { 22 + 3 / 256.0, 171 + 97 / 256.0, 61 + 181 / 256.0 },
  { 13 + 146 / 256.0, 47 + 61 / 256.0, 148 + 29 / 256.0 } };
constexpr double SlantedZ = 0.5;
/// Window depth of the plane z = 0.5 for a camera at 5 with clipping range 1 to 9.
constexpr float SlantedDepth = float((5.0 - SlantedZ - 1.0) / 8.0);
} // namespace

class IntersectionTest : public testing::TestWithParam<bool>
{
};

// Without multisampling a layer has all that OpenGL's buffers have: not a byte may differ, whether
// the layer or the actor that it intersects is drawn first.
TEST_P(IntersectionTest, EqualsOpenGLByteForByte)
{
  GLScene alone(0);
  alone.Renderer->AddActor(MakeSphere());
  OwnedLayer layer = LayerFrom(alone);

  GLScene wholly(0);
  GLScene composed(0);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  if (GetParam())
  {
    wholly.Renderer->AddActor(MakeSphere());
    wholly.Renderer->AddActor(MakeCone());
    composed.Renderer->AddViewProp(prop);
    composed.Renderer->AddActor(MakeCone());
  }
  else
  {
    wholly.Renderer->AddActor(MakeCone());
    wholly.Renderer->AddActor(MakeSphere());
    composed.Renderer->AddActor(MakeCone());
    composed.Renderer->AddViewProp(prop);
  }
  const Picture expected = wholly.Render();
  EXPECT_EQ(CountDifferent(expected, composed.Render()), 0);
  EXPECT_TRUE(prop->Drawn);
  EXPECT_EQ(wholly.ReadDepth(), composed.ReadDepth());
  EXPECT_GT(CountDifferent(expected, alone.Read()), 1000);
}
INSTANTIATE_TEST_SUITE_P(LayerFirst, IntersectionTest, testing::Bool());

class EdgeTest : public testing::TestWithParam<bool>
{
};

// In a multisampled window OpenGL's own samples behind an edge have to stay visible. A wrong order
// of the samples shows as hundreds of differing edge pixels.
TEST_P(EdgeTest, SamplesEqualOpenGLByteForByte)
{
  const bool layerFirst = GetParam();
  GLScene wholly(4);
  GLScene composed(4);
  composed.Renderer->AddActor(MakeCone());
  composed.Render();

  OwnedLayer layer = LayerOf(Slanted, SlantedDepth, 4);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  composed.Renderer->RemoveAllViewProps();
  if (layerFirst)
  {
    wholly.Renderer->AddActor(MakeFlatTriangle(Slanted, SlantedZ, Orange));
    composed.Renderer->AddViewProp(prop);
  }
  wholly.Renderer->AddActor(MakeCone());
  composed.Renderer->AddActor(MakeCone());
  if (!layerFirst)
  {
    wholly.Renderer->AddActor(MakeFlatTriangle(Slanted, SlantedZ, Orange));
    composed.Renderer->AddViewProp(prop);
  }
  const Picture expected = wholly.Render();
  EXPECT_EQ(CountDifferent(expected, composed.Render()), 0);
  EXPECT_EQ(prop->Samples, 4);

  GLScene aliased(0);
  aliased.Renderer->AddActor(MakeFlatTriangle(Slanted, SlantedZ, Orange));
  aliased.Renderer->AddActor(MakeCone());
  EXPECT_GT(CountDifferent(expected, aliased.Render()), 300) << "the edges are not antialiased";
}
INSTANTIATE_TEST_SUITE_P(LayerFirst, EdgeTest, testing::Bool());

// Into a window without multisampling the covered share of a pixel is blended over what is there.
TEST(LayerComposite, BlendsSharesWithoutMultisampling)
{
  GLScene scene(0);
  OwnedLayer layer(200, 160, 4);
  layer.Set(10, 20, Orange, 0.5f, 0b0001);
  layer.Set(11, 20, Orange, 0.5f, 0b1010);
  layer.Set(12, 20, Orange, 0.5f, 0b1111);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  scene.Renderer->AddViewProp(prop);
  const Picture picture = scene.Render();
  EXPECT_EQ(prop->Samples, 1);
  const double background[3] = { 0.1 * 255, 0.2 * 255, 0.3 * 255 };
  const double share[3] = { 0.25, 0.5, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double expected = share[i] * Orange[channel] + (1 - share[i]) * background[channel];
      EXPECT_NEAR(picture.At(10 + i, 20)[channel], expected, 1.0) << i;
    }
  }
  EXPECT_EQ(picture.At(13, 20)[0], 26) << "a pixel without coverage was written";
}

// Likewise of a translucent layer, whose colours are multiplied by alpha already.
TEST(LayerComposite, BlendsSharesOfTranslucentLayersWithoutMultisampling)
{
  GLScene scene(0);
  OwnedLayer layer(200, 160, 4);
  constexpr unsigned char kHalf = 128;
  for (int i = 0; i < 3; ++i)
  {
    const unsigned char coverage[3] = { 0b0100, 0b0011, 0b1111 };
    layer.Set(10 + i, 20, Orange, 1.0f, coverage[i]);
    layer.Color[4 * (20 * 200 + 10 + i) + 3] = kHalf;
  }
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  prop->IsBlended = true;
  scene.Renderer->AddViewProp(prop);
  const Picture picture = scene.Render();
  EXPECT_TRUE(prop->Drawn);
  EXPECT_EQ(prop->Samples, 1);
  const double background[3] = { 0.1 * 255, 0.2 * 255, 0.3 * 255 };
  const double share[3] = { 0.25, 0.5, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double through = 1 - share[i] * kHalf / 255;
      const double expected = share[i] * Orange[channel] + through * background[channel];
      // The share, what it leaves of the background, and that itself are rounded to bytes.
      EXPECT_NEAR(picture.At(10 + i, 20)[channel], expected, 1.5) << i;
    }
  }
  EXPECT_EQ(picture.At(13, 20)[0], 26) << "a pixel without coverage was written";
}

vtkLimnCompositor::LinePixel LineAt(unsigned short x, unsigned char alpha, unsigned char samples)
{
  vtkLimnCompositor::LinePixel pixel = { x, 20, { 0, 0, 0, alpha }, 0.5f, samples };
  for (int channel = 0; channel < 3; ++channel)
  {
    pixel.Color[channel] = static_cast<unsigned char>(Orange[channel] * alpha / 255);
  }
  return pixel;
}

// What lines cover wholly is what a layer covers; the first pixel tells one from the other.
TEST(LayerComposite, BlendsLinesIntoTheirSamples)
{
  for (const int samples : { 0, 4 })
  {
    GLScene scene(samples);
    OwnedLayer covered(200, 160, 4);
    OwnedLayer empty(200, 160, 4);
    vtkNew<LayerProp> prop;
    covered.Set(9, 21, Orange, 0.5f, 15);
    empty.Set(9, 21, Orange, 0.5f, 15);
    for (const unsigned char mask : { 1, 2, 4, 8, 6, 7, 15 })
    {
      covered.Set(10 + mask, 20, Orange, 0.5f, mask);
      prop->Lines.push_back(LineAt(10 + mask, 255, mask));
    }
    const std::vector<vtkLimnCompositor::LinePixel> lines = prop->Lines;
    prop->Lines.clear();
    prop->Layer = &covered;
    scene.Renderer->AddViewProp(prop);
    const Picture expected = scene.Render();
    prop->Layer = &empty;
    EXPECT_EQ(CountDifferent(expected, scene.Render()), 7);
    prop->Lines = lines;
    const Picture actual = scene.Render();
    EXPECT_TRUE(prop->Drawn);
    EXPECT_EQ(CountDifferent(expected, actual, samples == 0 ? 1 : 0), 0) << samples;
  }
}

TEST(LayerComposite, WritesTheDepthOfLinesThatCoverHalfOfAPixel)
{
  for (const bool writesDepth : { true, false })
  {
    GLScene scene(0);
    OwnedLayer layer(200, 160, 1);
    vtkNew<LayerProp> prop;
    prop->Layer = &layer;
    prop->Lines = { LineAt(10, 127, 1), LineAt(11, 128, 1), LineAt(12, 255, 1), LineAt(13, 60, 1) };
    prop->WritesDepth = writesDepth;
    scene.Renderer->AddViewProp(prop);
    const Picture picture = scene.Render();
    const std::vector<float> depth = scene.ReadDepth();
    for (int i = 0; i < 4; ++i)
    {
      const bool isDeep = writesDepth && (i == 1 || i == 2);
      EXPECT_EQ(depth[20 * 200 + 10 + i], isDeep ? 0.5f : 1.0f) << i;
      const double share = prop->Lines[i].Color[3] / 255.0;
      EXPECT_NEAR(picture.At(10 + i, 20)[0], share * Orange[0] + (1 - share) * 0.1 * 255, 1.5) << i;
    }
  }
}

// As of two layers: none of the lines hides another, in whatever order they come.
TEST(LayerComposite, BlendsLinesOfOnePixelInTheirOrder)
{
  GLScene scene(0);
  OwnedLayer layer(200, 160, 1);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  for (const bool isNearFirst : { false, true })
  {
    vtkLimnCompositor::LinePixel far = LineAt(10, 100, 1), near = LineAt(10, 150, 1);
    far.Depth = 0.6f;
    near.Depth = 0.4f;
    far.Color[1] = far.Color[2] = 0;
    near.Color[0] = 0;
    prop->Lines = { isNearFirst ? near : far, isNearFirst ? far : near };
    scene.Renderer->RemoveAllViewProps();
    scene.Renderer->AddViewProp(prop);
    const Picture picture = scene.Render();
    double red = 0.1 * 255;
    for (const vtkLimnCompositor::LinePixel& line : prop->Lines)
    {
      red = line.Color[0] + (1 - line.Color[3] / 255.0) * red;
    }
    EXPECT_NEAR(picture.At(10, 20)[0], red, 1.5);
    EXPECT_EQ(scene.ReadDepth()[20 * 200 + 10], 0.4f);
  }
}

TEST(LayerComposite, RefusesLinesOfAnotherSize)
{
  GLScene scene(0);
  OwnedLayer layer(200, 160, 1);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  scene.Renderer->AddViewProp(prop);
  scene.Render();
  const vtkLimnCompositor::LinePixel pixel = LineAt(10, 255, 1);
  EXPECT_FALSE(prop->Compositor->BlendLines(scene.Renderer, { 100, 160, 1, &pixel, 1, true }));
  EXPECT_FALSE(prop->Compositor->BlendLines(scene.Renderer, { 200, 160, 3, &pixel, 1, true }));
}

// Only the touched rectangle counts, whatever else is in the planes or was in the last picture.
class TouchedTest : public testing::TestWithParam<int>
{
};

TEST_P(TouchedTest, NothingElseIsDrawn)
{
  const int samples = GetParam();
  GLScene scene(samples);
  OwnedLayer layer(200, 160, std::max(samples, 1));
  const unsigned char all = samples == 4 ? 15 : 1;
  for (int y = 0; y < 160; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const unsigned char rgb[3] = { static_cast<unsigned char>(x), static_cast<unsigned char>(y),
        7 };
      layer.Set(x, y, rgb, 0.5f, all);
    }
  }
  const Picture background = scene.Render();
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  scene.Renderer->AddViewProp(prop);
  const int rectangles[4][4] = { { 0, 0, 200, 160 }, { 30, 40, 90, 100 }, { 150, 0, 300, 200 },
    { 99, 25, 101, 123 } };
  for (const auto& touched : rectangles)
  {
    layer.Touch(touched[0], touched[1], touched[2], touched[3]);
    const Picture picture = scene.Render();
    int wrong = 0;
    for (int y = 0; y < 160; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const bool inside = x >= touched[0] && x < touched[2] && y >= touched[1] && y < touched[3];
        const unsigned char* rgb = picture.At(x, y);
        wrong += inside ? rgb[0] != x || rgb[1] != y || rgb[2] != 7
                        : !std::equal(rgb, rgb + 3, background.At(x, y));
      }
    }
    EXPECT_EQ(wrong, 0) << touched[0];
  }
}
INSTANTIATE_TEST_SUITE_P(Samples, TouchedTest, testing::Values(0, 4));

// Each viewport and layer of a window gets its own picture, and none leaks into another.
TEST(LayerComposite, KeepsViewportsAndLayersApart)
{
  GLScene wholly(0);
  GLScene composed(0);
  OwnedLayer layers[2] = { OwnedLayer(100, 160, 1), OwnedLayer(100, 160, 1) };
  for (GLScene* scene : { &wholly, &composed })
  {
    scene->Window->SetNumberOfLayers(2);
    scene->Window->RemoveRenderer(scene->Renderer);
  }
  for (int side = 0; side < 2; ++side)
  {
    GLScene alone(0, 100, 160);
    alone.Renderer->AddActor(side ? MakeSphere() : MakeCone());
    layers[side] = LayerFrom(alone);
    for (GLScene* scene : { &wholly, &composed })
    {
      vtkNew<vtkRenderer> renderer;
      renderer->SetViewport(side * 0.5, 0.0, side * 0.5 + 0.5, 1.0);
      renderer->SetLayer(side);
      GLScene::SetUpCamera(renderer);
      scene->Window->AddRenderer(renderer);
      if (scene == &wholly)
      {
        renderer->AddActor(side ? MakeSphere() : MakeCone());
        continue;
      }
      vtkNew<LayerProp> prop;
      prop->Layer = &layers[side];
      renderer->AddViewProp(prop);
    }
  }
  EXPECT_EQ(CountDifferent(wholly.Render(), composed.Render()), 0);
}

// Textures only grow; a smaller picture after a larger one must not show old pixels.
TEST(LayerComposite, FollowsTheWindowsSize)
{
  GLScene composed(0);
  vtkNew<LayerProp> prop;
  composed.Renderer->AddViewProp(prop);
  const int sizes[4][2] = { { 200, 160 }, { 301, 97 }, { 64, 64 }, { 200, 160 } };
  for (const auto& size : sizes)
  {
    GLScene wholly(0, size[0], size[1]);
    wholly.Renderer->AddActor(MakeSphere());
    OwnedLayer layer = LayerFrom(wholly);
    prop->Layer = &layer;
    composed.Window->SetSize(size[0], size[1]);
    EXPECT_EQ(CountDifferent(wholly.Render(), composed.Render()), 0) << size[0];
  }
}

// A window may give up its context and get a new one; multisampling may be changed between frames.
TEST(LayerComposite, SurvivesLossOfTheContext)
{
  GLScene scene(0);
  OwnedLayer layer = LayerOf(Slanted, SlantedDepth, 1);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  scene.Renderer->AddViewProp(prop);
  const Picture before = scene.Render();
  scene.Window->Finalize();
  EXPECT_EQ(CountDifferent(before, scene.Render()), 0);
  prop->Compositor->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(CountDifferent(before, scene.Render()), 0);
  scene.Window->SetMultiSamples(4);
  scene.Render();
  EXPECT_EQ(prop->Samples, 4);
  scene.Window->SetMultiSamples(0);
  EXPECT_EQ(CountDifferent(before, scene.Render()), 0);
  EXPECT_EQ(prop->Samples, 1);
}

// One compositor serves two windows, and a window may go before it.
TEST(LayerComposite, ServesSeveralWindows)
{
  OwnedLayer layer = LayerOf(Slanted, SlantedDepth, 1);
  vtkNew<LayerProp> prop;
  prop->Layer = &layer;
  GLScene scene(0);
  scene.Renderer->AddViewProp(prop);
  const Picture first = scene.Render();
  {
    GLScene other(0);
    other.Renderer->AddViewProp(prop);
    EXPECT_EQ(CountDifferent(first, other.Render()), 0);
  }
  std::ostringstream kept;
  prop->Compositor->Print(kept);
  EXPECT_NE(kept.str().find("Windows: 1\n"), std::string::npos) << kept.str();
  EXPECT_EQ(CountDifferent(first, scene.Render()), 0);
}

// Drawing a layer leaves no trace in OpenGL's state: whatever is drawn or uploaded after it looks
// as without it.
TEST(LayerComposite, LeavesStateAsItWas)
{
  for (int multiSamples : { 0, 4 })
  {
    GLScene without(multiSamples);
    GLScene with(multiSamples);
    OwnedLayer nothing(200, 160, 4);
    nothing.Touch(3, 4, 5, 6);
    vtkNew<LayerProp> prop;
    prop->Layer = &nothing;
    with.Renderer->AddViewProp(prop);
    for (GLScene* scene : { &without, &with })
    {
      vtkSmartPointer<vtkActor> inside = MakeCone();
      inside->GetProperty()->FrontfaceCullingOn();
      vtkNew<vtkPlaneSource> plane;
      vtkSmartPointer<vtkActor> picture = MakeGLActor(plane->GetOutputPort());
      picture->SetTexture(MakeTexture());
      vtkSmartPointer<vtkActor> glass = MakeSphere();
      glass->GetProperty()->SetOpacity(0.4);
      vtkNew<vtkRegularPolygonSource> disc;
      disc->SetCenter(60.0, 60.0, 0.0);
      disc->SetRadius(40.0);
      vtkNew<vtkPolyDataMapper2D> discMapper;
      discMapper->SetInputConnection(disc->GetOutputPort());
      vtkNew<vtkActor2D> overlay;
      overlay->SetMapper(discMapper);
      overlay->GetProperty()->SetOpacity(0.5);
      for (vtkProp* each : { static_cast<vtkProp*>(inside), static_cast<vtkProp*>(picture),
             static_cast<vtkProp*>(glass), static_cast<vtkProp*>(overlay) })
      {
        scene->Renderer->AddViewProp(each);
      }
    }
    EXPECT_EQ(CountDifferent(without.Render(), with.Render()), 0) << multiSamples;
    EXPECT_EQ(CountDifferent(without.Render(), with.Render()), 0) << multiSamples;
  }
}

TEST(LayerComposite, RefusesBadLayers)
{
  GLScene scene(0);
  vtkNew<LayerProp> prop;
  scene.Renderer->AddViewProp(prop);
  vtkObject::GlobalWarningDisplayOff();

  OwnedLayer tooSmall(199, 160, 1);
  prop->Layer = &tooSmall;
  scene.Render();
  EXPECT_FALSE(prop->Drawn);

  OwnedLayer threeSamples(200, 160, 3);
  prop->Layer = &threeSamples;
  scene.Render();
  EXPECT_FALSE(prop->Drawn);

  OwnedLayer good(200, 160, 1);
  prop->Layer = &good;
  scene.Render();
  EXPECT_TRUE(prop->Drawn);
  vtkObject::GlobalWarningDisplayOn();
}
