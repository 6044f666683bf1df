// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of the mesh, as a vtkLimnProperty asks for them.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"

#include "vtkPointData.h"
#include "vtkParametricTorus.h"
#include "vtkParametricFunctionSource.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkLight.h"
#include "vtkSphereSource.h"
#include "vtkSuperquadricSource.h"

#include <cmath>
#include <limits>

namespace
{
const Pixel Red = { 255, 0, 0 };

/// White on black, with red lines, seen flat.
struct LineStage : Stage
{
  vtkNew<vtkLimnProperty> Property;

  LineStage()
  {
    this->Actor->SetProperty(this->Property);
    this->LookFlat();
    this->Property->SetColor(0, 0, 1);
    this->Property->SetStrokeColor(1, 0, 0);
    this->Property->SetStrokeWidth(2);
  }
  double Coverage()
  {
    const Picture picture = render(this->Window);
    double red = 0;
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        red += picture.At(x, y)[0] / 255.0;
      }
    }
    return red;
  }
};

/// Puts the camera aslant above the middle, and hatches what is there.
void hatchFromAbove(LineStage& stage)
{
  vtkCamera* const camera = stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -100, 60);
  camera->SetClippingRange(10, 300);
  stage.Property->HatchLinesOn();
  stage.Property->SetHatchSpacing(4);
}

void checkIsNear(double actual, double expected, double tolerance)
{
  CHECK(std::fabs(actual - expected) <= tolerance);
  if (!(std::fabs(actual - expected) <= tolerance))
  {
    std::cerr << actual << " is not " << expected << " +- " << tolerance << std::endl;
  }
}

// Two squares of 20 x 20 pixels have 160 pixels of border, two of width.
void checkBorders()
{
  LineStage stage;
  stage.Mapper->SetInputData(twoSquares());
  CHECK_EQUAL(stage.Coverage(), 0);
  stage.Property->BorderLinesOn();
  checkIsNear(stage.Coverage(), 320, 2);
  stage.Property->SetStrokeWidth(4);
  checkIsNear(stage.Coverage(), 640, 8); // corners are round
  stage.Property->SetStrokeWidth(1);
  stage.Property->SetOuterWidthFactor(2);
  checkIsNear(stage.Coverage(), 320, 2);
  stage.Property->SetStrokeOpacity(0.5);
  checkIsNear(stage.Coverage(), 160, 2);
  stage.Property->BorderLinesOff();
  stage.Property->CreaseLinesOn();
  CHECK_EQUAL(stage.Coverage(), 0);
}

void checkUnits()
{
  LineStage stage;
  stage.Mapper->SetInputData(twoSquares());
  stage.Property->BorderLinesOn();
  stage.Window->SetDPI(144);
  stage.Property->SetStrokeUnitToPoints();
  stage.Property->SetStrokeWidth(1);
  checkIsNear(stage.Coverage(), 320, 2);
  stage.Property->SetStrokeUnitToMillimeters();
  stage.Property->SetStrokeWidth(2 * 25.4 / 144);
  checkIsNear(stage.Coverage(), 320, 2);
  stage.Property->SetStrokeUnitToPixels();
  stage.Property->SetStrokeWidth(2);
  checkIsNear(stage.Coverage(), 320, 2);
}

void checkIds()
{
  LineStage stage;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(10, 10, 0);
  plane->SetPoint1(50, 10, 0);
  plane->SetPoint2(10, 50, 0);
  plane->SetResolution(4, 4);
  plane->Update();
  vtkPolyData* const data = plane->GetOutput();
  vtkNew<vtkIntArray> parts;
  parts->SetName("part");
  for (int cell = 0; cell < 16; ++cell)
  {
    parts->InsertNextValue(cell < 8 ? 3 : 7);
  }
  data->GetCellData()->AddArray(parts);
  stage.Mapper->SetInputData(data);
  stage.Property->IdLinesOn();
  CHECK_EQUAL(stage.Coverage(), 0); // no cell scalars
  stage.Property->SetIdArrayName("part");
  checkIsNear(stage.Coverage(), 80, 4);
  parts->SetValue(0, 7);
  parts->Modified();
  data->Modified();
  checkIsNear(stage.Coverage(), 120, 8);
}

void checkIdsOfThePicture()
{
  LineStage stage;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20, -20, 0);
  plane->SetPoint1(140, -20, 0);
  plane->SetPoint2(-20, 140, 0);
  plane->SetResolution(2, 2);
  plane->Update();
  vtkPolyData* const data = plane->GetOutput();
  vtkNew<vtkDoubleArray> parts;
  parts->SetName("part");
  for (int cell = 0; cell < 4; ++cell)
  {
    parts->InsertNextValue(cell < 2 ? 0.25 : 0.5);
  }
  data->GetCellData()->AddArray(parts);
  stage.Mapper->SetInputData(data);
  stage.Property->SetOutlineToImage();
  stage.Property->SetOutlineWidth(2);
  stage.Property->SetOutlineColor(1, 0, 0);
  const double width = render(stage.Window).Width;
  stage.Property->OutlineIdsOn();
  CHECK_EQUAL(stage.Coverage(), 0); // no cell scalars
  stage.Property->SetIdArrayName("part");
  checkIsNear(stage.Coverage(), 2 * width, 2);
  parts->SetValue(2, 0.25);
  parts->SetValue(3, 0.25);
  parts->Modified();
  data->Modified();
  CHECK_EQUAL(stage.Coverage(), 0);
  // An actor of the same mapper with another array.
  vtkNew<vtkIntArray> others;
  others->SetName("other");
  for (int cell = 0; cell < 4; ++cell)
  {
    others->InsertNextValue(cell);
  }
  data->GetCellData()->AddArray(others);
  stage.Property->SetIdArrayName("other");
  CHECK(stage.Coverage() > 2 * width);
  stage.Property->OutlineIdsOff();
  CHECK_EQUAL(stage.Coverage(), 0);
}

void checkCaching()
{
  LineStage stage;
  const vtkSmartPointer<vtkPolyData> data = twoSquares();
  stage.Mapper->SetInputData(data);
  stage.Property->BorderLinesOn();
  checkIsNear(stage.Coverage(), 320, 2);
  data->GetPoints()->SetPoint(1, 50, 10, 0);
  data->GetPoints()->SetPoint(2, 50, 30, 0);
  data->GetPoints()->Modified();
  stage.Mapper->SetInputData(data);
  // 40 x 20 and 20 x 20, which lie over each other in part: 180 pixels of line.
  checkIsNear(stage.Coverage(), 360, 10);
}

void checkContour()
{
  LineStage stage;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(50, 40, 0);
  sphere->SetRadius(30);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  stage.Mapper->SetInputConnection(sphere->GetOutputPort());
  stage.Renderer->GetActiveCamera()->SetPosition(50, 40, 100);
  stage.Renderer->GetActiveCamera()->SetClippingRange(10, 200);
  stage.Property->ContourLinesOn();
  const double circle = 2 * 3.14159265 * 30 * 2;
  checkIsNear(stage.Coverage(), circle, 0.01 * circle);
  stage.Property->SetCreaseAngle(0);
  checkIsNear(stage.Coverage(), circle, 0.03 * circle);
  stage.Property->ContourLinesOff();
  stage.Property->SilhouetteLinesOn();
  checkIsNear(stage.Coverage(), circle, 0.03 * circle);
  stage.Property->SilhouetteLinesOff();
  stage.Property->ContourLinesOn();
  // Normals of the data are not asked: soup has the same contour.
  stage.Property->SetCreaseAngle(40);
  vtkNew<vtkPolyDataNormals> split;
  split->SetInputConnection(sphere->GetOutputPort());
  split->SetFeatureAngle(0);
  split->SplittingOn();
  stage.Mapper->SetInputConnection(split->GetOutputPort());
  checkIsNear(stage.Coverage(), circle, 0.01 * circle);
}

vtkSmartPointer<vtkSuperquadricSource> lyingTorus()
{
  auto torus = vtkSmartPointer<vtkSuperquadricSource>::New();
  torus->ToroidalOn();
  torus->SetSize(28);
  torus->SetAxisOfSymmetry(2);
  torus->SetThetaResolution(64);
  torus->SetPhiResolution(64);
  return torus;
}

void lookFromAside(LineStage& stage)
{
  vtkCamera* const camera = stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -100, 60);
  camera->SetClippingRange(10, 300);
}

void checkCurves()
{
  LineStage stage;
  const vtkSmartPointer<vtkSuperquadricSource> torus = lyingTorus();
  stage.Mapper->SetInputConnection(torus->GetOutputPort());
  lookFromAside(stage);
  stage.Property->SuggestiveLinesOn();
  CHECK(stage.Coverage() > 30);
  stage.Property->SuggestiveLinesOff();
  stage.Property->ValleyLinesOn();
  CHECK_EQUAL(stage.Coverage(), 0);
}

// What is kept of a mesh to find its lines sooner is made anew when its points move.
void checkMovedPoints()
{
  using Switch = void (vtkLimnProperty::*)();
  for (const Switch turnOn : { static_cast<Switch>(&vtkLimnProperty::SilhouetteLinesOn),
         static_cast<Switch>(&vtkLimnProperty::ContourLinesOn),
         static_cast<Switch>(&vtkLimnProperty::SuggestiveLinesOn) })
  {
    const vtkSmartPointer<vtkSuperquadricSource> torus = lyingTorus();
    torus->Update();
    vtkPolyData* const data = torus->GetOutput();
    data->GetPointData()->SetNormals(nullptr);
    const auto show = [&](LineStage& stage, vtkPolyData* shown)
    {
      stage.Mapper->SetInputData(shown);
      lookFromAside(stage);
      (stage.Property->*turnOn)();
    };
    LineStage kept;
    show(kept, data);
    const double before = kept.Coverage();
    vtkPoints* const points = data->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      points->SetPoint(i, p[0] + 0.4 * p[1], 0.9 * p[1], 1.3 * p[2]);
    }
    points->Modified();
    data->Modified();
    LineStage fresh;
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(data);
    show(fresh, copy);
    const double after = kept.Coverage();
    CHECK(after > 20);
    CHECK(after != before);
    CHECK_EQUAL(after, fresh.Coverage());
  }
}

/// Light that travels from a point towards another.
vtkSmartPointer<vtkLight> lightAlong(double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-x, -y, -z);
  light->SetFocalPoint(0, 0, 0);
  return light;
}

/// Seen along -z, from 100 in front.
void lookFromAfar(LineStage& stage)
{
  stage.Renderer->GetActiveCamera()->SetPosition(50, 40, 100);
  stage.Renderer->GetActiveCamera()->SetClippingRange(10, 200);
}

void setBall(LineStage& stage, vtkSphereSource* ball)
{
  ball->SetCenter(50, 40, 0);
  ball->SetRadius(30);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  stage.Mapper->SetInputConnection(ball->GetOutputPort());
}

// A great circle, seen from its edge, from the front and from a side.
void checkTerminator()
{
  LineStage stage;
  vtkNew<vtkSphereSource> ball;
  setBall(stage, ball);
  lookFromAfar(stage);
  stage.Property->TerminatorLinesOn();
  const vtkSmartPointer<vtkLight> light = lightAlong(1, 0, 0);
  stage.Renderer->AutomaticLightCreationOff();
  stage.Renderer->AddLight(light);
  checkIsNear(stage.Coverage(), 60 * 2, 3);
  // Half of it is before the ball, and a few pixels behind it that run along the border.
  light->SetPosition(-1, 0, 1);
  const double ellipse = 3.14159265 * 30 * 1.7204 / 2; // half of that with axes 1 and 1/sqrt(2)
  checkIsNear(stage.Coverage(), ellipse * 2 + 20, 20);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  stage.Renderer->RemoveAllLights();
  stage.Renderer->AddLight(head);
  stage.Renderer->AddLight(light);
  checkIsNear(stage.Coverage(), ellipse * 2 + 20, 20); // the first that is no headlight
  const vtkSmartPointer<vtkLight> other = lightAlong(1, 0, 0);
  stage.Renderer->AddLight(other);
  const double one = stage.Coverage();
  stage.Property->SetLineLightsToAll();
  CHECK(stage.Coverage() > one + 80);
  light->SwitchOff();
  head->SwitchOff();
  checkIsNear(stage.Coverage(), 60 * 2, 3);
  other->SwitchOff();
  CHECK_EQUAL(stage.Coverage(), 0);
}

vtkSmartPointer<vtkPolyData> squareOf(double x, double y, double z, double side)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x, y, z);
  plane->SetPoint1(x + side, y, z);
  plane->SetPoint2(x, y + side, z);
  plane->Update();
  return plane->GetOutput();
}

// A square of 10 x 10 over a wall: its shadow is moved aside, as the light, the square or the wall
// move, and is where a new window would have it.
void checkShadow()
{
  LineStage stage;
  lookFromAfar(stage);
  stage.Mapper->SetInputData(squareOf(20, 30, 20, 10));
  vtkNew<vtkLimnPolyDataMapper> wallMapper;
  wallMapper->SetInputData(squareOf(0, 0, 0, 80));
  vtkNew<vtkLimnProperty> plain;
  plain->SetColor(0, 0, 1);
  plain->LightingOff();
  vtkNew<vtkLimnActor> wall;
  wall->SetMapper(wallMapper);
  wall->SetProperty(plain);
  stage.Renderer->AddActor(wall);
  const vtkSmartPointer<vtkLight> light = lightAlong(1, 0, -1);
  stage.Renderer->AddLight(light);
  CHECK_EQUAL(stage.Coverage(), 0);
  stage.Property->ShadowLinesOn();
  checkIsNear(stage.Coverage(), 80, 2);
  const auto left = [&]
  {
    const Picture picture = render(stage.Window);
    int x = 0;
    while (x < picture.Width && picture.At(x, 35)[0] < 128)
    {
      ++x;
    }
    return x;
  };
  CHECK_EQUAL(left(), 39);
  stage.Renderer->GetActiveCamera()->SetPosition(50, 40, 120);
  CHECK_EQUAL(left(), 39);
  light->SetPosition(-0.5, 0, 1);
  CHECK_EQUAL(left(), 29);
  wall->SetPosition(0, 0, -10);
  CHECK_EQUAL(left(), 34);
  stage.Actor->SetPosition(5, 0, 0);
  CHECK_EQUAL(left(), 39);
  stage.Mapper->SetInputData(squareOf(21, 30, 20, 10));
  CHECK_EQUAL(left(), 40);
  wall->VisibilityOff();
  CHECK_EQUAL(stage.Coverage(), 0);
  wall->VisibilityOn();
  plain->ShadowLinesOn();
  plain->SetStrokeColor(0, 1, 0);
  checkIsNear(stage.Coverage(), 80, 2); // nothing is behind the wall
  stage.Property->ShadowLinesOff();
  CHECK_EQUAL(stage.Coverage(), 0);
}

// A ball of radius 30 cut by a wall 18 before its middle: a circle of radius 24.
void checkIntersections()
{
  LineStage stage;
  vtkNew<vtkSphereSource> ball;
  setBall(stage, ball);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  lookFromAfar(stage);
  vtkNew<vtkLimnPolyDataMapper> wallMapper;
  wallMapper->SetInputData(squareOf(0, 0, 18, 80));
  vtkNew<vtkLimnProperty> plain;
  plain->SetColor(0, 0, 1);
  plain->SetStrokeColor(1, 0, 0);
  plain->SetStrokeWidth(2);
  plain->LightingOff();
  vtkNew<vtkLimnActor> wall;
  wall->SetMapper(wallMapper);
  wall->SetProperty(plain);
  stage.Renderer->AddActor(wall);
  const double circle = 2 * 3.14159265 * 24 * 2;
  stage.Property->IntersectionLinesOn();
  checkIsNear(stage.Coverage(), circle, 0.02 * circle);
  plain->IntersectionLinesOn();
  checkIsNear(stage.Coverage(), circle, 0.02 * circle);
  stage.Property->IntersectionLinesOff();
  checkIsNear(stage.Coverage(), circle, 0.02 * circle);
  wall->SetPosition(0, 0, 20);
  CHECK_EQUAL(stage.Coverage(), 0);
}

void checkThresholds()
{
  LineStage stage;
  vtkNew<vtkSuperquadricSource> torus;
  torus->ToroidalOn();
  torus->SetSize(28);
  torus->SetAxisOfSymmetry(2);
  torus->SetThetaResolution(64);
  torus->SetPhiResolution(64);
  stage.Mapper->SetInputConnection(torus->GetOutputPort());
  vtkCamera* const camera = stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -100, 60);
  camera->SetClippingRange(10, 300);
  stage.Property->SuggestiveLinesOn();
  const double usual = stage.Coverage();
  stage.Property->SetSuggestiveThreshold(1000);
  CHECK_EQUAL(stage.Coverage(), 0);
  stage.Property->SetSuggestiveThreshold(0.01);
  CHECK_EQUAL(stage.Coverage(), usual);
  stage.Property->SuggestiveLinesOff();
  stage.Property->RidgeLinesOn();
  stage.Property->SetRidgeThreshold(0);
  const double all = stage.Coverage();
  stage.Property->SetRidgeThreshold(1000);
  CHECK_EQUAL(stage.Coverage(), 0);
  stage.Property->SetRidgeThreshold(0);
  CHECK_EQUAL(stage.Coverage(), all);
  CHECK(all > 0);
}

/// Strokes along the curvature: none in full light, made anew only when the mesh changes.
void checkHatching()
{
  LineStage stage;
  vtkNew<vtkSuperquadricSource> torus;
  torus->ToroidalOn();
  torus->SetSize(28);
  torus->SetAxisOfSymmetry(2);
  torus->SetThetaResolution(64);
  torus->SetPhiResolution(64);
  stage.Mapper->SetInputConnection(torus->GetOutputPort());
  hatchFromAbove(stage);
  const double lit = stage.Coverage();
  CHECK(lit > 30);
  stage.Property->SetHatchDarkest(0);
  CHECK_EQUAL(stage.Coverage(), 0);
  stage.Property->SetHatchDarkest(0.85);
  stage.Property->SetAmbient(1);
  stage.Renderer->SetAmbient(0.4, 0.4, 0.4);
  const double brighter = stage.Coverage();
  CHECK(brighter > 0 && brighter < lit);
  stage.Renderer->SetAmbient(1, 1, 1);
  CHECK_EQUAL(stage.Coverage(), 0);
}

/// Strokes of a cube are the same whether the data have its normals, split at its edges, or none;
/// and they are others if nothing is sharp.
void checkHatchedCube()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(30);
  cube->SetYLength(30);
  cube->SetZLength(30);
  cube->Update();
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(cube->GetOutput());
  bare->GetPointData()->SetNormals(nullptr);
  const auto coverage = [](vtkPolyData* data, double creaseAngle, double featureAngle)
  {
    LineStage stage;
    stage.Mapper->SetInputData(data);
    vtkCamera* const camera = stage.Renderer->GetActiveCamera();
    camera->SetFocalPoint(0, 0, 0);
    camera->SetPosition(40, 50, 90);
    camera->SetClippingRange(10, 300);
    stage.Property->HatchLinesOn();
    stage.Property->SetHatchSpacing(4);
    stage.Property->SetCreaseAngle(creaseAngle);
    stage.Property->SetFeatureAngle(featureAngle);
    return stage.Coverage();
  };
  const double flat = coverage(bare, 40, 180);
  CHECK(flat > 30);
  CHECK_EQUAL(coverage(cube->GetOutput(), 40, 180), flat);
  CHECK_EQUAL(coverage(bare, 120, 40), flat);
  CHECK(coverage(bare, 120, 180) != flat);
}

/// Strokes where the data's normals are nobody's: those of the surface itself.
void checkHatchingOfUnusableNormals()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(28);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();
  const auto coverage = [&sphere](vtkDataArray* normals)
  {
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(sphere->GetOutput());
    data->GetPointData()->SetNormals(normals);
    LineStage stage;
    stage.Mapper->SetInputData(data);
    hatchFromAbove(stage);
    return stage.Coverage();
  };
  const double own = coverage(nullptr);
  CHECK(own > 30);
  for (const double part : { 0.0, std::nan(""), 1e30 })
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(sphere->GetOutput()->GetNumberOfPoints());
    normals->Fill(part);
    CHECK_EQUAL(coverage(normals), own);
  }
}

/// Of point normals that change after a frame, or before the first.
void checkChangedNormals()
{
  enum class Change
  {
    Never,
    Before,
    After
  };
  const auto draw = [](Change change)
  {
    LineStage stage;
    vtkNew<vtkParametricTorus> shape;
    vtkNew<vtkParametricFunctionSource> torus;
    torus->SetParametricFunction(shape);
    torus->SetScalarModeToNone();
    torus->Update();
    vtkNew<vtkPolyData> data;
    data->DeepCopy(torus->GetOutput());
    stage.Mapper->SetInputData(data);
    stage.Renderer->GetActiveCamera()->SetPosition(0, -10, 6);
    stage.Renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
    stage.Renderer->ResetCamera();
    stage.Property->SuggestiveLinesOn();
    stage.Property->RidgeLinesOn();
    stage.Property->NormalLinesOn();
    if (change == Change::After)
    {
      stage.Window->Render();
    }
    vtkDataArray* const normals = data->GetPointData()->GetNormals();
    for (vtkIdType i = 0; change != Change::Never && i < normals->GetNumberOfTuples(); i += 2)
    {
      const double* const n = normals->GetTuple3(i);
      normals->SetTuple3(i, n[1], -n[0], n[2]);
    }
    normals->Modified();
    return render(stage.Window);
  };
  const Picture changed = draw(Change::Before);
  CHECK(draw(Change::After) == changed);
  CHECK(!(draw(Change::Never) == changed));
}

/// A dash without a gap is a line.
void checkDashAlone()
{
  LineStage stage;
  stage.Mapper->SetInputData(twoSquares());
  stage.Property->BorderLinesOn();
  const Picture line = render(stage.Window);
  stage.Property->SetStrokeDash(4);
  CHECK(render(stage.Window) == line);
  stage.Property->SetStrokeGap(4);
  CHECK(!(render(stage.Window) == line));
}

void checkUnusableValues()
{
  const struct
  {
    const char* Name;
    void (*Set)(vtkLimnProperty*);
  } cases[] = {
    { "StrokeWidth", [](vtkLimnProperty* p) { p->SetStrokeWidth(0); } },
    { "StrokeWidth",
      [](vtkLimnProperty* p) { p->SetStrokeWidth(std::numeric_limits<double>::quiet_NaN()); } },
    { "StrokeColor", [](vtkLimnProperty* p) { p->SetStrokeColor(0, -1, 0); } },
    { "StrokeTaper", [](vtkLimnProperty* p) { p->SetStrokeTaper(-1); } },
    { "StrokeGap",
      [](vtkLimnProperty* p)
      {
        p->SetStrokeDash(0.1);
        p->SetStrokeGap(0.1);
      } },
    { "FeatureAngle",
      [](vtkLimnProperty* p) { p->SetFeatureAngle(std::numeric_limits<double>::quiet_NaN()); } },
    { "CreaseAngle",
      [](vtkLimnProperty* p) { p->SetCreaseAngle(std::numeric_limits<double>::quiet_NaN()); } },
    { "StrokeDash", [](vtkLimnProperty* p) { p->SetStrokeDash(-3); } },
    { "RidgeThreshold", [](vtkLimnProperty* p) { p->SetRidgeThreshold(-1); } },
    { "SuggestiveThreshold", [](vtkLimnProperty* p)
      { p->SetSuggestiveThreshold(std::numeric_limits<double>::quiet_NaN()); } },
  };
  for (const auto& one : cases)
  {
    LineStage stage;
    stage.Mapper->SetInputData(twoSquares());
    stage.Property->BorderLinesOn();
    const Messages messages;
    one.Set(stage.Property);
    stage.Window->Render();
    CHECK_EQUAL(messages.Count("Not drawn"), 1);
    CHECK_EQUAL(messages.Count(one.Name), 1);
  }
}
}

namespace
{
/// Named as the property names it, and the surface is drawn.
void checkTooWide()
{
  LineStage stage;
  stage.Mapper->SetInputData(squareOf(20, 20, 0, 40));
  stage.Property->SetStrokeUnitToMillimeters();
  stage.Property->SetStrokeWidth(100);
  const Messages messages;
  for (const bool isBorder : { true, false })
  {
    stage.Property->SetBorderLines(isBorder);
    CHECK_EQUAL(render(stage.Window).At(40, 40)[2], 255);
    CHECK_EQUAL(messages.Count("StrokeWidth of its vtkLimnProperty is 283.465 pixels"), 1);
  }
}
}

int TestLimnLines(int, char*[])
{
  checkBorders();
  checkUnits();
  checkIds();
  checkIdsOfThePicture();
  checkCaching();
  checkContour();
  checkCurves();
  checkMovedPoints();
  checkTerminator();
  checkShadow();
  checkIntersections();
  checkThresholds();
  checkHatching();
  checkHatchedCube();
  checkHatchingOfUnusableNormals();
  checkChangedNormals();
  checkDashAlone();
  checkTooWide();
  checkUnusableValues();
  return result();
}
