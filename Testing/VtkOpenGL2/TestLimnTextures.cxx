// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's textures on Limn's actors, against the same scenes drawn by OpenGL.
#include "GLScene.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataTangents.h"
#include "vtkTexture.h"
#include "vtkTexturedSphereSource.h"
#include "vtkTransform.h"
#include "vtkTriangleFilter.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>

namespace
{
/// A pattern without symmetry: smooth colours and a bright square in a corner.
double PatternAt(double x, double y, int channel)
{
  if (x < 0.3 && y < 0.3 && channel < 2)
  {
    return 1.0;
  }
  switch (channel)
  {
    case 0:
      return 0.2 + 0.7 * x;
    case 1:
      return 0.9 - 0.6 * y;
    case 2:
      return 0.5 + 0.4 * std::cos(9.0 * x * y);
    default:
      return 1.0;
  }
}

vtkSmartPointer<vtkTexture> MakeTexture(
  int type = VTK_UNSIGNED_CHAR, int components = 3, int width = 16, int height = 16)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  const double most = type == VTK_UNSIGNED_CHAR ? 255 : type == VTK_UNSIGNED_SHORT ? 65535 : 1;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int channel = 0; channel < components; ++channel)
      {
        const int shown = components == 2 && channel == 1 ? 3 : channel;
        const double value = PatternAt((x + 0.5) / width, (y + 0.5) / height, shown);
        image->SetScalarComponentFromDouble(
          x, y, 0, channel, type == VTK_FLOAT ? value : std::floor(most * value));
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkTexture> MakeSmoothTexture()
{
  vtkSmartPointer<vtkTexture> texture = MakeTexture();
  texture->InterpolateOn();
  return texture;
}

vtkSmartPointer<vtkTexture> MakeWrapped(int wrap)
{
  vtkSmartPointer<vtkTexture> texture = MakeSmoothTexture();
  texture->SetWrap(wrap);
  texture->SetBorderColor(0.9f, 0.1f, 0.8f, 0.0f);
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.7, -1.2, 0.0);
  transform->RotateZ(15.0);
  transform->Scale(2.5, 3.0, 1.0);
  texture->SetTransform(transform);
  return texture;
}

vtkSmartPointer<vtkTexture> MakeMipmapped(float anisotropy)
{
  vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_UNSIGNED_CHAR, 3, 64, 64);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(anisotropy);
  vtkNew<vtkTransform> transform;
  transform->Scale(6.0, 6.0, 1.0);
  texture->SetTransform(transform);
  return texture;
}

/// Dents: the normal's x and y as sines.
vtkSmartPointer<vtkTexture> MakeNormalMap()
{
  vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_UNSIGNED_CHAR, 3, 32, 32);
  texture->InterpolateOn();
  auto* image = vtkImageData::SafeDownCast(texture->GetInput());
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 32; ++x)
    {
      const double nx = 0.5 * std::sin(0.4 * x);
      const double ny = 0.3 * std::sin(0.6 * y);
      const double n[3] = { nx, ny, std::sqrt(1 - nx * nx - ny * ny) };
      for (int channel = 0; channel < 3; ++channel)
      {
        image->SetScalarComponentFromDouble(x, y, 0, channel, std::floor(127.5 + 127 * n[channel]));
      }
    }
  }
  return texture;
}

/// Two textures, of which the second is turned and blended.
template <vtkTexture::VTKTextureBlendingMode Mode>
void Blend(vtkActor* actor)
{
  actor->SetTexture(MakeSmoothTexture());
  vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_UNSIGNED_CHAR, 3, 7, 5);
  texture->InterpolateOn();
  texture->SetBlendingMode(Mode);
  actor->GetProperty()->SetTexture("second", texture);
}

struct TextureLook
{
  const char* Name;
  void (*Apply)(vtkActor*);
  double ShareOff = 0.05; ///< of pixels, in percent, more than a level off
  int Levels = 1;
};

std::ostream& operator<<(std::ostream& os, const TextureLook& look)
{
  return os << look.Name;
}

// A nearest texel is the one or the other by the last bit of a coordinate. Which probes make an
// anisotropic filter, OpenGL leaves open.
const TextureLook TextureLooks[] = {
  { "Nearest", [](vtkActor* actor) { actor->SetTexture(MakeTexture()); } },
  { "Bilinear", [](vtkActor* actor) { actor->SetTexture(MakeSmoothTexture()); } },
  { "Repeated", [](vtkActor* actor) { actor->SetTexture(MakeWrapped(vtkTexture::Repeat)); } },
  { "Clamped", [](vtkActor* actor) { actor->SetTexture(MakeWrapped(vtkTexture::ClampToEdge)); } },
  { "Mirrored",
    [](vtkActor* actor) { actor->SetTexture(MakeWrapped(vtkTexture::MirroredRepeat)); } },
  { "Bordered",
    [](vtkActor* actor) { actor->SetTexture(MakeWrapped(vtkTexture::ClampToBorder)); } },
  { "Trilinear", [](vtkActor* actor) { actor->SetTexture(MakeMipmapped(1.0f)); }, 0.05, 3 },
  { "Anisotropic", [](vtkActor* actor) { actor->SetTexture(MakeMipmapped(4.0f)); }, 2.0, 16 },
  { "Grey", [](vtkActor* actor) { actor->SetTexture(MakeTexture(VTK_UNSIGNED_CHAR, 1)); } },
  { "OpaqueRgba", [](vtkActor* actor) { actor->SetTexture(MakeTexture(VTK_UNSIGNED_CHAR, 4)); } },
  { "MappedFloats",
    [](vtkActor* actor)
    {
      vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_FLOAT, 1);
      texture->InterpolateOn();
      actor->SetTexture(texture);
    } },
  { "MappedByTable",
    [](vtkActor* actor)
    {
      vtkNew<vtkLookupTable> table;
      table->SetRange(0.0, 200.0);
      table->SetHueRange(0.6, 0.0);
      table->Build();
      vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_UNSIGNED_CHAR, 1);
      texture->SetColorModeToMapScalars();
      texture->SetLookupTable(table);
      actor->SetTexture(texture);
    } },
  { "DirectFloats",
    [](vtkActor* actor)
    {
      vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_FLOAT, 3);
      texture->SetColorModeToDirectScalars();
      texture->InterpolateOn();
      actor->SetTexture(texture);
    } },
  { "DirectShorts",
    [](vtkActor* actor)
    {
      vtkSmartPointer<vtkTexture> texture = MakeTexture(VTK_UNSIGNED_SHORT, 3);
      texture->SetColorModeToDirectScalars();
      texture->InterpolateOn();
      actor->SetTexture(texture);
    } },
  { "Srgb",
    [](vtkActor* actor)
    {
      vtkSmartPointer<vtkTexture> texture = MakeSmoothTexture();
      texture->UseSRGBColorSpaceOn();
      actor->SetTexture(texture);
    } },
  { "SeveralModulated",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      for (const char* name : { "b", "a" })
      {
        vtkSmartPointer<vtkTexture> texture = MakeSmoothTexture();
        texture->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
        actor->GetProperty()->SetTexture(name, texture);
      }
    } },
  { "Replaced", Blend<vtkTexture::VTK_TEXTURE_BLENDING_MODE_REPLACE> },
  { "Added", Blend<vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD> },
  { "AddedSigned", Blend<vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD_SIGNED> },
  { "Subtracted", Blend<vtkTexture::VTK_TEXTURE_BLENDING_MODE_SUBTRACT> },
  { "NotBlended", Blend<vtkTexture::VTK_TEXTURE_BLENDING_MODE_NONE> },
  { "FrontOnly",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      actor->GetProperty()->ShowTexturesOnBackfaceOff();
      actor->RotateY(180.0);
    } },
  { "InterpolatedScalars",
    [](vtkActor* actor)
    {
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(9);
      table->UseBelowRangeColorOn();
      table->SetBelowRangeColor(1.0, 1.0, 1.0, 1.0);
      table->Build();
      vtkMapper* mapper = actor->GetMapper();
      mapper->SetLookupTable(table);
      mapper->SetScalarRange(-0.3, 0.4);
      mapper->ScalarVisibilityOn();
      mapper->InterpolateScalarsBeforeMappingOn();
      actor->GetProperty()->SetAmbient(0.2);
      actor->GetProperty()->SetSpecular(0.2);
    } },
  { "Unlit",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      actor->GetProperty()->LightingOff();
    } },
  { "Flat",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      actor->GetProperty()->SetInterpolationToFlat();
    } },
  { "Shiny",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      actor->GetProperty()->SetSpecular(0.7);
      actor->GetProperty()->SetSpecularPower(8.0);
      actor->GetProperty()->SetAmbient(0.2);
    } },
  { "PbrIgnoresOrdinary",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeSmoothTexture());
      actor->GetProperty()->SetInterpolationToPBR();
    } },
  { "PbrBaseColor",
    [](vtkActor* actor)
    {
      vtkSmartPointer<vtkTexture> texture = MakeSmoothTexture();
      texture->UseSRGBColorSpaceOn();
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetBaseColorTexture(texture);
      actor->GetProperty()->SetMetallic(0.3);
    } },
};

class TextureTest : public testing::TestWithParam<TextureLook>
{
};

using Make = vtkSmartPointer<vtkActor> (*)(vtkAlgorithmOutput*);

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

/// With the points' heights as scalars, one of them not a number, that are not shown.
vtkSmartPointer<vtkPolyData> WithScalars(vtkAlgorithm* source)
{
  source->Update();
  vtkSmartPointer<vtkPolyData> data = vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
  vtkNew<vtkFloatArray> heights;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(data->GetPoint(i)[1]));
  }
  heights->SetValue(5, std::numeric_limits<float>::quiet_NaN());
  data->GetPointData()->SetScalars(heights);
  return data;
}

/// A tilted floor and a ball over it, in perspective.
void AddSurfaces(GLScene& scene, Make make, void (*apply)(vtkActor*))
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.9, -0.8, 1.0);
  plane->SetPoint1(0.9, -0.8, 1.0);
  plane->SetPoint2(-0.9, 0.2, -1.5);
  plane->SetResolution(3, 2);
  vtkNew<vtkTexturedSphereSource> ball;
  ball->SetRadius(0.5);
  ball->SetThetaResolution(30);
  ball->SetPhiResolution(20);
  vtkNew<vtkTrivialProducer> floorData;
  floorData->SetOutput(WithScalars(plane));
  vtkNew<vtkTrivialProducer> ballData;
  ballData->SetOutput(WithScalars(ball));
  const vtkSmartPointer<vtkActor> floorActor = make(floorData->GetOutputPort());
  const vtkSmartPointer<vtkActor> ballActor = make(ballData->GetOutputPort());
  for (vtkActor* actor : { floorActor.Get(), ballActor.Get() })
  {
    actor->GetMapper()->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(1.0, 0.9, 0.8);
    apply(actor);
    scene.Renderer->AddActor(actor);
  }
  ballActor->AddPosition(0.2, 0.3, 0.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(0.0, 0.3, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewAngle(30.0);
  scene.Renderer->ResetCameraClippingRange();
}
} // namespace

TEST_P(TextureTest, LooksAsInOpenGL)
{
  Picture pictures[2];
  for (int limn : { 0, 1 })
  {
    GLScene scene(0);
    AddSurfaces(scene, limn ? MakeLimnActor : MakeGLActor, GetParam().Apply);
    pictures[limn] = scene.Render();
    const std::string actorName = scene.Renderer->GetActors()->GetLastActor()->GetClassName();
    ASSERT_EQ(actorName, limn ? "vtkLimnActor" : "vtkOpenGLActor");
  }
  const auto share = [&](int levels)
  {
    return 100.0 * CountDifferent(pictures[0], pictures[1], levels) /
           (pictures[0].Width * pictures[0].Height);
  };
  RecordProperty("moreThan0", CountDifferent(pictures[0], pictures[1]));
  RecordProperty("moreThan8", CountDifferent(pictures[0], pictures[1], 8));
  EXPECT_LE(share(GetParam().Levels), GetParam().ShareOff);
}
INSTANTIATE_TEST_SUITE_P(All, TextureTest, testing::ValuesIn(TextureLooks),
  [](const auto& test) { return std::string(test.param.Name); });

// VTK bends normals by the tangents of the points and their cross product with the normal, Limn by
// the directions of u and v: the same where these are at right angles.
TEST(LimnTextures, NormalMapsLookAsInOpenGL)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.9, -0.8, 0.2);
  plane->SetPoint1(0.9, -0.8, -0.2);
  plane->SetPoint2(-0.8, 0.8, 0.65);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  Picture pictures[2];
  for (int limn : { 0, 1 })
  {
    GLScene scene(0);
    const vtkSmartPointer<vtkActor> actor =
      (limn ? MakeLimnActor : MakeGLActor)(tangents->GetOutputPort());
    actor->GetProperty()->SetNormalTexture(MakeNormalMap());
    actor->GetProperty()->SetNormalScale(0.8);
    scene.Renderer->AddActor(actor);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1.0, 2.0, 2.0);
    scene.Renderer->AddLight(light);
    pictures[limn] = scene.Render();
    if (!limn)
    {
      actor->GetProperty()->RemoveAllTextures();
      EXPECT_GT(CountDifferent(pictures[0], scene.Render(), 8), 2000) << "the map shows";
    }
  }
  EXPECT_LT(CountDifferent(pictures[0], pictures[1], 2), 50);
}
