// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surface shaders and vertex shaders, as a program written with VTK has them.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnHardwareSelector.h"
#include "vtkLimnProperty.h"
#include "vtkLimnSurfaceShader.h"
#include "vtkLimnVertexShader.h"

#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPropPicker.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <sstream>

namespace
{
const Pixel Black = { 0, 0, 0 };

/// Where a fragment is, in numbers.
class NumberShader : public vtkLimnSurfaceShader
{
public:
  static NumberShader* New();
  vtkTypeMacro(NumberShader, vtkLimnSurfaceShader);
  vtkSetMacro(Blue, double);

  void Shade(const Fragments& f, const Lighting&, float* const color[3]) const override
  {
    for (int i = 0; i < f.Count; ++i)
    {
      color[0][i] = static_cast<float>(f.PixelX[i]) / 255;
      color[1][i] = static_cast<float>(f.Cell[i] + 1) / 255;
      color[2][i] = static_cast<float>(this->Blue);
    }
  }

protected:
  double Blue = 0;
};
vtkStandardNewMacro(NumberShader);

/// Where a fragment is, in coordinates.
class PlaceShader : public vtkLimnSurfaceShader
{
public:
  static PlaceShader* New();
  vtkTypeMacro(PlaceShader, vtkLimnSurfaceShader);

  void Shade(const Fragments& f, const Lighting& lighting, float* const color[3]) const override
  {
    double world[16];
    double view[16];
    lighting.GetModelToWorld(world);
    lighting.GetWorldToView(view);
    for (int i = 0; i < f.Count; ++i)
    {
      const double model[4] = { f.ModelPosition.X[i], f.ModelPosition.Y[i], f.ModelPosition.Z[i],
        1 };
      double inWorld[4];
      double inView[4];
      for (int row = 0; row < 4; ++row)
      {
        inWorld[row] = vtkMath::Dot(world + 4 * row, model) + world[4 * row + 3];
      }
      for (int row = 0; row < 4; ++row)
      {
        inView[row] = vtkMath::Dot(view + 4 * row, inWorld) + view[4 * row + 3];
      }
      const bool isSame = std::fabs(inView[0] - f.Position.X[i]) < 1e-4 &&
                          std::fabs(inView[1] - f.Position.Y[i]) < 1e-4 &&
                          std::fabs(inView[2] - f.Position.Z[i]) < 1e-4;
      color[0][i] = isSame ? 1.0f : 0.0f;
      color[1][i] = static_cast<float>(model[0]) / 255;
      color[2][i] = lighting.GetParallelProjection() ? 1.0f : 0.0f;
    }
  }
};
vtkStandardNewMacro(PlaceShader);

class BuiltInShader : public vtkLimnSurfaceShader
{
public:
  static BuiltInShader* New();
  vtkTypeMacro(BuiltInShader, vtkLimnSurfaceShader);
  void Shade(const Fragments& f, const Lighting& lighting, float* const color[3]) const override
  {
    lighting.Light(f, color);
  }
};
vtkStandardNewMacro(BuiltInShader);

class LambertShader : public vtkLimnSurfaceShader
{
public:
  static LambertShader* New();
  vtkTypeMacro(LambertShader, vtkLimnSurfaceShader);

  void Shade(const Fragments& f, const Lighting& lighting, float* const color[3]) const override
  {
    float sum[3][Capacity] = {};
    for (int light = 0; light < lighting.GetNumberOfLights(); ++light)
    {
      float toward[3][Capacity];
      float fall[Capacity];
      float* const towards[3] = { toward[0], toward[1], toward[2] };
      lighting.Arrive(light, f, towards, fall);
      float own[3];
      lighting.GetLightColor(light, own);
      for (int i = 0; i < f.Count; ++i)
      {
        const float nl = (f.Normal.X[i] * toward[0][i] + f.Normal.Y[i] * toward[1][i]) +
                         f.Normal.Z[i] * toward[2][i];
        for (int c = 0; nl > 0 && c < 3; ++c)
        {
          sum[c][i] += own[c] * (fall[i] * nl);
        }
      }
    }
    float ambient[3];
    lighting.GetAmbientLight(ambient);
    const float* const ka[3] = { f.Ambient.X, f.Ambient.Y, f.Ambient.Z };
    const float* const kd[3] = { f.Diffuse.X, f.Diffuse.Y, f.Diffuse.Z };
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < f.Count; ++i)
      {
        color[c][i] = ka[c][i] * ambient[c] + sum[c][i] * kd[c][i];
      }
    }
  }
};
vtkStandardNewMacro(LambertShader);

/// Shears x by y and lifts z; counts the points that it was given.
class ShearShader : public vtkLimnVertexShader
{
public:
  static ShearShader* New();
  vtkTypeMacro(ShearShader, vtkLimnVertexShader);
  vtkSetMacro(Shear, double);
  vtkSetMacro(Lost, vtkIdType);
  vtkSetMacro(TurnsNormals, bool);

  void Move(const Vertices& v) const override
  {
    this->Points += v.Count;
    for (int i = 0; i < v.Count; ++i)
    {
      v.Position[0][i] += this->Shear * v.Position[1][i];
      if (v.First + i == this->Lost)
      {
        v.Position[2][i] = std::sqrt(-1.0);
      }
      if (v.Normal[0])
      {
        v.Normal[0][i] = 1;
        v.Normal[1][i] = 0;
        v.Normal[2][i] = 0;
      }
    }
  }
  bool MovesNormals() const override
  {
    return this->TurnsNormals || this->Superclass::MovesNormals();
  }

  mutable std::atomic<vtkIdType> Points{ 0 };

protected:
  double Shear = 1;
  vtkIdType Lost = -1;
  bool TurnsNormals = false;
};
vtkStandardNewMacro(ShearShader);

vtkSmartPointer<vtkPolyData> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(30);
  source->Update();
  return source->GetOutput();
}

/// A lit, glossy sphere.
struct LitStage : Stage
{
  vtkNew<vtkLimnProperty> Property;
  vtkNew<vtkLight> Lamp;

  explicit LitStage(vtkPolyData* data)
  {
    this->Mapper->SetInputData(data);
    this->Actor->SetProperty(this->Property);
    this->Actor->SetScale(1, 1.5, 1);
    this->Property->SetColor(0.8, 0.5, 0.3);
    this->Property->SetAmbient(0.2);
    this->Property->SetSpecular(0.5);
    this->Property->SetSpecularPower(9);
    this->Lamp->SetPosition(1, 2, 2);
    this->Lamp->SetPositional(true);
    this->Lamp->SetConeAngle(80);
    this->Lamp->SetAttenuationValues(0.5, 0.1, 0.1);
    this->Renderer->AddLight(this->Lamp);
    vtkNew<vtkLight> second;
    second->SetPosition(-1, 1, 0.5);
    second->SetDiffuseColor(0.2, 0.4, 0.9);
    this->Renderer->AddLight(second);
    this->Renderer->SetAmbient(0.3, 0.2, 0.5);
    this->Renderer->ResetCamera();
    this->Window->SetMultiSamples(4);
  }
};

void checkFragmentsNumbers()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkLimnProperty> property;
  stage.Actor->SetProperty(property);
  vtkNew<NumberShader> shader;
  property->SetSurfaceShader(shader);
  Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.CountOtherThan(Black), 800);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 20, 1, 0 }));
  CHECK_EQUAL(picture.At(59, 12), (Pixel{ 59, 2, 0 }));

  // A changed shader is a changed property, and is drawn.
  const vtkMTimeType time = property->GetMTime();
  shader->SetBlue(0.2);
  CHECK(property->GetMTime() > time);
  CHECK(stage.Actor->GetRedrawMTime() > time);
  CHECK_EQUAL(render(stage.Window).At(20, 20), (Pixel{ 20, 1, 51 }));

  vtkNew<vtkLimnProperty> copy;
  copy->DeepCopy(property);
  CHECK(copy->GetSurfaceShader() == shader);
  copy->SetSurfaceShader(nullptr);
  stage.Actor->SetProperty(copy);
  copy->LightingOff();
  CHECK_EQUAL(render(stage.Window).At(20, 20), (Pixel{ 255, 255, 255 }));
}

void checkPlaces()
{
  LitStage stage(sphere());
  stage.Actor->SetPosition(0.1, 0.2, 0.3);
  stage.Window->SetMultiSamples(0);
  vtkNew<PlaceShader> shader;
  stage.Property->SetSurfaceShader(shader);
  const Picture picture = render(stage.Window);
  const int covered = picture.CountOtherThan(Black);
  CHECK(covered > 1000);
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const Pixel pixel = picture.At(x, y);
      CHECK(pixel == Black || (pixel[0] == 255 && pixel[2] == 0));
    }
  }
  stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
  CHECK_EQUAL(render(stage.Window).At(50, 40)[2], 255);
}

void checkBuiltInModels()
{
  LitStage stage(sphere());
  vtkNew<BuiltInShader> shader;
  for (int model : { vtkLimnProperty::REFLECTION_AS_VTK, vtkLimnProperty::REFLECTION_LAMBERT,
         vtkLimnProperty::REFLECTION_BLINN_PHONG, vtkLimnProperty::REFLECTION_PHONG })
  {
    stage.Property->SetReflectionModel(model);
    stage.Property->SetSurfaceShader(nullptr);
    const Picture plain = render(stage.Window);
    CHECK(plain.CountOtherThan(Black) > 1000);
    stage.Property->SetSurfaceShader(shader);
    CHECK(render(stage.Window) == plain);
  }
}

void checkLambertByHand()
{
  LitStage stage(sphere());
  stage.Property->SetReflectionModelToLambert();
  const Picture plain = render(stage.Window);
  stage.Property->SetReflectionModelToBlinnPhong();
  CHECK(!(render(stage.Window) == plain));
  vtkNew<LambertShader> shader;
  stage.Property->SetSurfaceShader(shader);
  CHECK(render(stage.Window) == plain);
}

/// The same data as the shader leaves it.
vtkSmartPointer<vtkPolyData> sheared(vtkPolyData* data, double shear)
{
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(data);
  for (vtkIdType i = 0; i < copy->GetNumberOfPoints(); ++i)
  {
    double p[3];
    copy->GetPoint(i, p);
    copy->GetPoints()->SetPoint(i, p[0] + shear * p[1], p[1], p[2]);
  }
  copy->GetPointData()->SetNormals(nullptr);
  return copy;
}

// Byte by byte what a mesh shows that was given with the moved points.
void checkMovedPoints()
{
  vtkNew<ShearShader> shader;
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkSmartPointer<vtkPolyData> data = sphere();
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->DeepCopy(data->GetPoints());
    data->SetPoints(points);
    const vtkSmartPointer<vtkPolyData> given = sheared(data, 1);
    for (int frequency : { vtkLimnProperty::FREQUENCY_FLAT, vtkLimnProperty::FREQUENCY_GOURAUD,
           vtkLimnProperty::FREQUENCY_PHONG })
    {
      LitStage stage(data);
      stage.Property->SetShadingFrequency(frequency);
      const Picture still = render(stage.Window);
      stage.Mapper->SetVertexShader(shader);
      const Picture moved = render(stage.Window);
      stage.Mapper->SetVertexShader(nullptr);
      CHECK(render(stage.Window) == still);
      stage.Mapper->SetInputData(given);
      CHECK(render(stage.Window) == moved);
      CHECK(!(still == moved));
    }
  }
}

void checkMovedNormals()
{
  LitStage stage(sphere());
  stage.Property->SetReflectionModelToLambert();
  vtkNew<ShearShader> shader;
  shader->SetTurnsNormals(true);
  stage.Mapper->SetVertexShader(shader);
  const Picture turned = render(stage.Window);

  const vtkSmartPointer<vtkPolyData> given = sheared(stage.Mapper->GetInput(), 1);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < given->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(1, 0, 0);
  }
  given->GetPointData()->SetNormals(normals);
  stage.Mapper->SetVertexShader(nullptr);
  stage.Mapper->SetInputData(given);
  CHECK(render(stage.Window) == turned);
}

void checkBounds()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 60);
  vtkNew<ShearShader> shader;
  stage.Mapper->SetVertexShader(shader);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 90);
  CHECK_EQUAL(stage.Actor->GetBounds()[0], 20);
  shader->SetShear(0.5);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 75);
  stage.Mapper->SetVertexShader(nullptr);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 60);

  // A camera that is set by the bounds has all of it in view.
  shader->SetShear(3);
  stage.Mapper->SetVertexShader(shader);
  stage.Renderer->ResetCamera();
  const Picture moved = render(stage.Window);
  CHECK(moved.CountOtherThan(Black) > 100);
  stage.Mapper->SetVertexShader(nullptr);
  stage.Mapper->SetInputData(sheared(twoSquares(), 3));
  stage.Renderer->ResetCamera();
  CHECK(render(stage.Window) == moved);
}

void checkThatNothingRunsTwice()
{
  LitStage stage(sphere());
  const vtkIdType points = stage.Mapper->GetInput()->GetNumberOfPoints();
  vtkNew<ShearShader> shader;
  stage.Mapper->SetVertexShader(shader);
  const auto runs = [&](const std::function<void()>& change)
  {
    shader->Points = 0;
    change();
    stage.Renderer->ResetCamera();
    render(stage.Window);
    render(stage.Window);
    const vtkIdType done = shader->Points;
    return done / static_cast<double>(points);
  };
  CHECK_EQUAL(runs([] {}), 1);
  CHECK_EQUAL(runs([] {}), 0);
  CHECK_EQUAL(runs([&] { stage.Renderer->GetActiveCamera()->Azimuth(10); }), 0);
  CHECK_EQUAL(runs([&] { stage.Property->SetShadingFrequencyToFlat(); }), 0);
  vtkPolyData* const data = stage.Mapper->GetInput();
  const auto addScalars = [&]
  {
    vtkNew<vtkFloatArray> scalars;
    scalars->SetNumberOfTuples(points);
    scalars->Fill(1);
    data->GetPointData()->SetScalars(scalars);
  };
  CHECK_EQUAL(runs(addScalars), 0);
  const vtkIdType builds = stage.Mapper->GetNumberOfGeometryBuilds();
  CHECK_EQUAL(runs([&] { shader->SetShear(1.1); }), 1);
  CHECK_EQUAL(runs([&] { shader->SetShear(1.1); }), 0);
  CHECK_EQUAL(runs([&] { data->GetPoints()->Modified(); }), 1);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), builds);
  CHECK_EQUAL(runs([&] { stage.Mapper->SetInputData(sphere()); }), 1);
}

void checkLostPoints()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<ShearShader> shader;
  shader->SetShear(0);
  shader->SetLost(5);
  stage.Mapper->SetVertexShader(shader);
  Messages messages;
  // One square, and the half of the other that does not use the point, without its long edge.
  const int pixels = render(stage.Window).CountOtherThan(Black);
  render(stage.Window);
  CHECK_EQUAL(pixels, 400 + 190);
  CHECK_EQUAL(messages.Count("ShearShader moves 1 points, the first of them point 5"), 1);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 60);
  messages.Forget();
  shader->SetLost(-1);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
  CHECK_EQUAL(messages.GetText(), std::string());
}

void checkPicking()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<ShearShader> shader;
  stage.Mapper->SetVertexShader(shader);
  render(stage.Window);
  vtkNew<vtkPropPicker> picker;
  CHECK_EQUAL(picker->PickProp(85, 28, stage.Renderer), 1);
  CHECK_EQUAL(picker->PickProp(12, 28, stage.Renderer), 0);
}

void checkCopyAndPrint()
{
  vtkNew<vtkLimnPolyDataMapper> mapper;
  vtkNew<ShearShader> shader;
  mapper->SetVertexShader(shader);
  CHECK_EQUAL(shader->GetReferenceCount(), 2);
  const vtkMTimeType time = mapper->GetMTime();
  shader->SetShear(3);
  CHECK(mapper->GetMTime() > time);
  vtkNew<vtkLimnPolyDataMapper> copy;
  copy->ShallowCopy(mapper);
  CHECK(copy->GetVertexShader() == shader);
  std::ostringstream text;
  mapper->Print(text);
  CHECK(text.str().find("MovesNormals: no") != std::string::npos);

  vtkNew<vtkLimnProperty> property;
  std::ostringstream none;
  property->Print(none);
  CHECK(none.str().find("SurfaceShader: (none)") != std::string::npos);
}
}

int TestLimnShaders(int, char*[])
{
  checkFragmentsNumbers();
  checkPlaces();
  checkBuiltInModels();
  checkLambertByHand();
  checkMovedPoints();
  checkMovedNormals();
  checkBounds();
  checkThatNothingRunsTwice();
  checkLostPoints();
  checkPicking();
  checkCopyAndPrint();
  return result();
}
