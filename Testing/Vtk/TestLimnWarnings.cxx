// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What cannot be drawn is named, once, and the rest is drawn.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnLight.h"
#include "vtkLimnProperty.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <vector>

namespace
{
const Pixel Black = { 0, 0, 0 };

struct Case
{
  const char* Feature;
  bool IsDrawn;
  void (*Ask)(Stage&);
};

const Case Cases[] = {
  { "blending in the opaque pass", true,
    [](Stage& stage)
    {
      stage.Actor->ForceOpaqueOn();
      stage.Actor->GetProperty()->SetOpacity(0.5);
    } },
  { "wireframes", false,
    [](Stage& stage) { stage.Actor->GetProperty()->SetRepresentationToWireframe(); } },
  { "surfaces as points", false,
    [](Stage& stage) { stage.Actor->GetProperty()->SetRepresentationToPoints(); } },
  { "clipping planes", false,
    [](Stage& stage)
    {
      vtkNew<vtkPlane> plane;
      stage.Mapper->AddClippingPlane(plane);
    } },
  { "vertex cells", true,
    [](Stage& stage)
    {
      vtkNew<vtkCellArray> cells;
      addCell(cells, { 0 });
      stage.Mapper->GetInput()->SetVerts(cells);
    } },
  { "line cells", true,
    [](Stage& stage)
    {
      vtkNew<vtkCellArray> cells;
      addCell(cells, { 0, 1 });
      stage.Mapper->GetInput()->SetLines(cells);
    } },
  { "edges on surfaces", true,
    [](Stage& stage) { stage.Actor->GetProperty()->EdgeVisibilityOn(); } },
  { "back face properties", true,
    [](Stage& stage)
    {
      vtkNew<vtkProperty> property;
      stage.Actor->SetBackfaceProperty(property);
    } },
  { "coats and anisotropy of materials", true,
    [](Stage& stage)
    {
      stage.Actor->GetProperty()->SetInterpolationToPBR();
      stage.Actor->GetProperty()->SetCoatStrength(0.5);
    } },
};

void checkFeatures()
{
  for (const Case& one : Cases)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(twoSquares());
    one.Ask(stage);
    Messages messages;
    const int pixels = render(stage.Window).CountOtherThan(Black);
    CHECK_EQUAL(pixels, one.IsDrawn ? 800 : 0);
    CHECK_EQUAL(messages.Count(std::string("A vtkLimnActor asks for ") + one.Feature), 1);
    CHECK_EQUAL(messages.Count("WARN") + messages.Count("Warning"), 1);
    stage.Renderer->GetActiveCamera()->Modified();
    render(stage.Window);
    CHECK_EQUAL(messages.Count("asks for"), 1);
  }
}

void checkOtherProps()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkTextActor> text;
  text->SetInput("not drawn");
  stage.Renderer->AddViewProp(text);
  Messages messages;
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
  CHECK_EQUAL(messages.Count("A vtkTextActor is not drawn"), 1);
  CHECK_EQUAL(messages.Count("2D props"), 1);
}

void checkBrokenMeshes()
{
  Stage stage;
  stage.LookFlat();
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  data->GetPoints()->SetPoint(6, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  vtkNew<vtkCellArray> polys;
  polys->DeepCopy(data->GetPolys());
  addCell(polys, { 0, 1, 8 });
  addCell(polys, { 0, 1, -1 });
  addCell(polys, { 0, 1, 3000000000 });
  data->SetPolys(polys);
  stage.Mapper->SetInputData(data);
  Messages messages;
  // Point 6 is in both triangles of the second square.
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 400);
  CHECK_EQUAL(messages.Count("2 triangles use a point with a coordinate"), 1);
  CHECK_EQUAL(messages.Count("3 triangles name a point that does not exist"), 1);
  stage.Renderer->GetActiveCamera()->Zoom(0.9);
  render(stage.Window);
  CHECK_EQUAL(messages.Count("Not all of the input is drawn"), 1);
  data->GetPoints()->Modified();
  render(stage.Window);
  CHECK_EQUAL(messages.Count("Not all of the input is drawn"), 2);
}

vtkSmartPointer<vtkFloatArray> upwards(vtkIdType count)
{
  vtkSmartPointer<vtkFloatArray> normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    normals->InsertNextTuple3(0, 0, 1);
  }
  return normals;
}

/// Each kind of what is no normal, of the flat squares' points or cells, is drawn as what it is in
/// place of.
void checkBrokenNormals()
{
  const double bad[][3] = { { std::numeric_limits<double>::quiet_NaN(), 0, 1 },
    { 0, -std::numeric_limits<double>::infinity(), 1 }, { 0, 0, 1e30 } };
  for (const bool isOfCells : { false, true })
  {
    for (const auto& broken : bad)
    {
      Stage stage;
      stage.LookFlat();
      stage.Actor->GetProperty()->LightingOn();
      stage.Actor->GetProperty()->SetInterpolation(isOfCells ? VTK_FLAT : VTK_GOURAUD);
      vtkSmartPointer<vtkPolyData> data = twoSquares();
      vtkSmartPointer<vtkFloatArray> normals =
        upwards(isOfCells ? data->GetNumberOfCells() : data->GetNumberOfPoints());
      data->GetPointData()->SetNormals(isOfCells ? nullptr : normals.Get());
      data->GetCellData()->SetNormals(isOfCells ? normals.Get() : nullptr);
      stage.Mapper->SetInputData(data);
      Messages messages;
      const Picture whole = render(stage.Window);
      CHECK_EQUAL(whole.CountOtherThan(Black), 800);
      CHECK_EQUAL(messages.GetText(), "");

      normals->SetTuple(1, broken);
      normals->Modified();
      CHECK(render(stage.Window) == whole);
      const char* const message = isOfCells ? "Not all cell normals of the input can be used"
                                            : "Not all point normals of the input can be used";
      CHECK_EQUAL(messages.Count(message), 1);
      CHECK_EQUAL(messages.Count("It is so with 1 of them."), 1);
      stage.Renderer->GetActiveCamera()->Modified();
      CHECK(render(stage.Window) == whole);
      CHECK_EQUAL(messages.Count("Not all"), 1);

      // Those of other points are used.
      normals->SetTuple3(0, 1, 0, 0);
      normals->Modified();
      CHECK(!(render(stage.Window) == whole));
      CHECK_EQUAL(messages.Count("Not all"), 2);

      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
      {
        normals->SetTuple(i, broken);
      }
      normals->Modified();
      CHECK(render(stage.Window) == whole);
      CHECK_EQUAL(messages.Count("Not all"), 3);

      normals->FillComponent(0, 0);
      normals->FillComponent(1, 0);
      normals->FillComponent(2, 1);
      normals->Modified();
      CHECK(render(stage.Window) == whole);
      CHECK_EQUAL(messages.Count("Not all"), 3);
    }
  }
}

/// The surface's own normals follow its points.
void checkBrokenNormalsOfChangedPoints()
{
  const auto draw = [](bool isBroken, bool isChanged)
  {
    Stage stage;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(25);
    sphere->SetCenter(30, 30, -40);
    sphere->SetThetaResolution(32);
    sphere->SetPhiResolution(32);
    sphere->Update();
    vtkSmartPointer<vtkPolyData> data = sphere->GetOutput();
    vtkDataArray* const normals = data->GetPointData()->GetNormals();
    stage.Mapper->SetInputData(data);
    const auto change = [&]
    {
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        const double* const p = data->GetPoint(i);
        const double changed[] = { p[0], 30 + (p[1] - 30) / 3, p[2] };
        data->GetPoints()->SetPoint(i, changed);
      }
      data->GetPoints()->Modified();
    };
    if (isBroken)
    {
      // All but one, which cannot be seen.
      const vtkIdType last = 1;
      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
      {
        normals->SetComponent(i, 0, i == last ? 0 : std::numeric_limits<double>::quiet_NaN());
      }
    }
    else
    {
      vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty())->SetVertexNormalsToByArea();
    }
    if (isChanged)
    {
      render(stage.Window);
    }
    change();
    return render(stage.Window);
  };
  for (const bool isChanged : { false, true })
  {
    const Picture expected = draw(false, isChanged);
    CHECK(expected.CountOtherThan(Black) > 400);
    CHECK(draw(true, isChanged) == expected);
  }
}

/// Nobody is told of normals that are not drawn.
void checkUnseenBrokenNormals()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Stage stage;
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  data->GetPoints()->InsertNextPoint(0, 0, 0);
  data->GetPointData()->SetNormals(upwards(data->GetNumberOfPoints()));
  data->GetCellData()->SetNormals(upwards(data->GetNumberOfCells()));
  // A point of no triangle.
  data->GetPointData()->GetNormals()->SetComponent(data->GetNumberOfPoints() - 1, 0, nan);
  data->GetCellData()->GetNormals()->SetComponent(0, 0, nan);
  stage.Mapper->SetInputData(data);
  Messages messages;
  render(stage.Window);
  CHECK_EQUAL(messages.GetText(), "");
  stage.Actor->GetProperty()->SetInterpolationToFlat();
  render(stage.Window);
  CHECK_EQUAL(messages.Count("Not all cell normals"), 1);
}

void checkManyBrokenMeshes()
{
  Stage stage;
  stage.LookFlat();
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 100; ++i)
  {
    vtkSmartPointer<vtkPolyData> data = twoSquares();
    if (i >= 3)
    {
      // The first in two triangles, the others in one.
      data->GetPoints()->SetPoint(i == 3 ? 6 : 7, 0, std::numeric_limits<double>::infinity(), 0);
    }
    vtkNew<vtkLimnPolyDataMapper> mapper;
    mapper->SetInputData(data);
    actors.push_back(vtkSmartPointer<vtkLimnActor>::New());
    actors.back()->SetMapper(mapper);
    actors.back()->GetProperty()->SetOpacity(i < 3 ? 0.5 : 1);
    vtkLimnProperty::SafeDownCast(actors.back()->GetProperty())->SetOutlineToImage();
    stage.Renderer->AddActor(actors.back());
  }
  Messages messages;
  render(stage.Window);
  CHECK_EQUAL(messages.Count("Not all of the input is drawn"), 1);
  CHECK_EQUAL(messages.Count("2 triangles use a point with a coordinate"), 1);
  CHECK_EQUAL(messages.Count("So it is with 96 more in this scene."), 1);
  CHECK_EQUAL(messages.Count("Its outline by image is not drawn"), 1);
  CHECK_EQUAL(messages.Count("So it is with 2 more in this scene."), 1);
  stage.Renderer->GetActiveCamera()->Zoom(0.9);
  render(stage.Window);
  CHECK_EQUAL(messages.Count("in this scene"), 2);
}

// Single faces without an area are common and not worth a word; nothing but such faces is.
void checkFlattenedMeshes()
{
  using Corners = std::initializer_list<std::array<double, 2>>;
  for (const Corners& corners : { Corners{ { 10, 10 }, { 30, 10 }, { 50, 10 } },
         Corners{ { 10, 10 }, { 30, 10 }, { 30, 10 } } })
  {
    Stage stage;
    stage.LookFlat();
    vtkNew<vtkPolyData> data;
    data->SetPoints(flatPoints(corners));
    vtkNew<vtkCellArray> polys;
    addCell(polys, { 0, 1, 2 });
    data->SetPolys(polys);
    stage.Mapper->SetInputData(data);
    Messages messages;
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
    stage.Renderer->GetActiveCamera()->Zoom(0.9);
    render(stage.Window);
    CHECK_EQUAL(messages.Count("None of its faces has an area"), 1);

    messages.Forget();
    data->GetPoints()->InsertNextPoint(30, 30, 0);
    addCell(polys, { 0, 1, 3 });
    data->GetPoints()->Modified();
    polys->Modified();
    CHECK(render(stage.Window).CountOtherThan(Black) > 0);
    CHECK_EQUAL(messages.GetText(), "");
  }
}

// Of faces along a line there are borders to draw, of faces in two points there are none.
void checkLinesOfFlattenedMeshes()
{
  for (const double last : { 50, 30 })
  {
    Stage stage;
    stage.LookFlat();
    vtkNew<vtkPolyData> data;
    data->SetPoints(flatPoints({ { 10, 10 }, { 30, 10 }, { last, 10 } }));
    vtkNew<vtkCellArray> polys;
    addCell(polys, { 0, 1, 2 });
    data->SetPolys(polys);
    stage.Mapper->SetInputData(data);
    vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    property->BorderLinesOn();
    property->SetStrokeColor(1, 1, 1);
    Messages messages;
    const bool isDrawn = render(stage.Window).CountOtherThan(Black) > 0;
    CHECK_EQUAL(isDrawn, last == 50);
    stage.Renderer->GetActiveCamera()->Zoom(0.9);
    render(stage.Window);
    CHECK_EQUAL(messages.Count("Only lines of the input are drawn."), isDrawn ? 1 : 0);
    CHECK_EQUAL(messages.Count("Nothing of the input is drawn."), isDrawn ? 0 : 1);
    CHECK_EQUAL(messages.Count("None of its faces has an area"), 1);

    messages.Forget();
    property->BorderLinesOff();
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
    CHECK_EQUAL(messages.Count("Nothing of the input is drawn."), isDrawn ? 1 : 0);
  }
}

// Outlines by image and depth cues are of opaque surfaces.
void checkTranslucentIllustration()
{
  const struct
  {
    const char* message;
    void (*ask)(vtkLimnProperty*);
  } cases[] = {
    { "Its outline by image is not drawn: only opaque surfaces have one, and this actor is "
      "translucent. Use SetOutlineToHull() or ContourLinesOn(), or make the actor opaque.",
      [](vtkLimnProperty* property) { property->SetOutlineToImage(); } },
    { "Its eye-dome lighting is not drawn",
      [](vtkLimnProperty* property) { property->EyeDomeLightingOn(); } },
    { "Its depth unsharp mask is not drawn",
      [](vtkLimnProperty* property) { property->SetDepthUnsharpToBoth(); } },
    { "Its halo is not drawn", [](vtkLimnProperty* property) { property->SetHaloWidth(3); } },
  };
  for (const auto& one : cases)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(twoSquares());
    vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    one.ask(property);
    Messages messages;
    render(stage.Window);
    CHECK_EQUAL(messages.GetText(), "");
    property->SetOpacity(0.5);
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
    stage.Renderer->GetActiveCamera()->Modified();
    render(stage.Window);
    CHECK_EQUAL(messages.Count(one.message), 1);
    CHECK_EQUAL(messages.Count("WARN") + messages.Count("Warning"), 1);

    // Whoever asks again, or is another actor, hears of it again.
    property->SetOpacity(1);
    render(stage.Window);
    property->SetOpacity(0.5);
    render(stage.Window);
    CHECK_EQUAL(messages.Count(one.message), 2);
    vtkNew<vtkLimnActor> other;
    other->SetMapper(stage.Mapper);
    other->SetProperty(property);
    stage.Renderer->AddActor(other);
    render(stage.Window);
    CHECK_EQUAL(messages.Count(one.message), 3);
  }
}

// vtkCamera keeps a distance, and floats overflow, where nothing else is at fault.
void checkSizes()
{
  const struct
  {
    double size;
    const char* message;
  } cases[] = { { 1e-25, "there may be nothing to see: scale it up" }, { 1e-15, nullptr },
    { 1e15, nullptr }, { 1e25, "it is not lit as it should be: scale it down" } };
  for (const auto& one : cases)
  {
    Stage stage;
    stage.Actor->GetProperty()->LightingOff();
    vtkSmartPointer<vtkPolyData> data = twoSquares();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const double* const p = data->GetPoint(i);
      points->InsertNextPoint(p[0] * one.size, p[1] * one.size, p[2] * one.size);
    }
    data->SetPoints(points);
    stage.Mapper->SetInputData(data);
    Messages messages;
    stage.Renderer->ResetCamera();
    const int pixels = render(stage.Window).CountOtherThan(Black);
    CHECK(pixels > 0 || one.message);
    CHECK_EQUAL(messages.Count("Its size in the world is"), one.message ? 1 : 0);
    CHECK_EQUAL(messages.Count(one.message ? one.message : "scale it"), one.message ? 1 : 0);
    stage.Renderer->GetActiveCamera()->Zoom(0.9);
    render(stage.Window);
    CHECK_EQUAL(messages.Count("Its size in the world is"), one.message ? 1 : 0);

    // An actor's own scale mends it.
    stage.Actor->SetScale(1 / one.size);
    messages.Forget();
    stage.Renderer->GetActiveCamera()->SetPosition(0, 0, 1);
    stage.Renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
    stage.Renderer->ResetCamera();
    CHECK(render(stage.Window).CountOtherThan(Black) > 0);
    CHECK_EQUAL(messages.GetText(), "");
  }
}

// One actor's fault does not take the others from the picture.
void checkBrokenActor()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, std::numeric_limits<double>::infinity());
  vtkNew<vtkLimnActor> broken;
  broken->SetMapper(stage.Mapper);
  broken->SetUserMatrix(matrix);
  stage.Renderer->AddActor(broken);
  Messages messages;
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
  CHECK_EQUAL(messages.Count("its matrix has a value that is not a finite number"), 1);
  CHECK_EQUAL(messages.Count("vtkLimnActor"), 1);
}

void checkBrokenProperty()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkLimnActor> broken;
  broken->SetMapper(stage.Mapper);
  stage.Renderer->AddActor(broken);
  for (double value : { -0.5, std::numeric_limits<double>::quiet_NaN() })
  {
    broken->GetProperty()->SetSpecularColor(1, value, 1);
    Messages messages;
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
    CHECK_EQUAL(messages.Count("vtkLimnActor"), 1);
    CHECK_EQUAL(messages.Count("SpecularColor of its vtkLimnProperty has the value"), 1);
    CHECK_EQUAL(messages.Count("Instance"), 0);
  }
}

/// As checkBrokenProperty, for what only vtkLimnProperty has.
void checkBrokenReflection()
{
  const struct
  {
    const char* message;
    void (*spoil)(vtkLimnProperty*);
  } cases[] = {
    { "RimColor of its vtkLimnProperty has the value -1; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetRimColor(0, -1, 0); } },
    { "RimPower of its vtkLimnProperty has the value -2; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetRimPower(-2); } },
    { "OutlineWidth of its vtkLimnProperty has the value -1; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetOutlineWidth(-1); } },
    { "OutlineColor of its vtkLimnProperty has the value -3; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetOutlineColor(0, 0, -3); } },
    { "RefractiveIndex of its vtkLimnProperty has the value 0.9; it has to be a finite number, at "
      "least 1.",
      [](vtkLimnProperty* property) { property->SetRefractiveIndex(1.5, 0.9, 1.5); } },
    { "OutlineWidth of its vtkLimnProperty has the value -3; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetOutlineWidth(-3); } },
    { "ToonRamp of its vtkLimnProperty is not set, and the tone Ramp needs it.",
      [](vtkLimnProperty* property) { property->SetToneToRamp(); } },
    { "MatCap of its vtkLimnProperty is not set, and the tone MatCap needs it.",
      [](vtkLimnProperty* property) { property->SetToneToMatCap(); } },
    { "HatchSpacing of its vtkLimnProperty has the value 0; it has to be a finite number above 0.",
      [](vtkLimnProperty* property) { property->SetHatchSpacing(0); } },
    { "HatchInk of its vtkLimnProperty has the value -1; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property) { property->SetHatchInk(0, -1, 0); } },
    { "ExaggerationExponent of its vtkLimnProperty has the value nan; it has to be from -4 to 4.",
      [](vtkLimnProperty* property)
      { property->SetExaggerationExponent(std::numeric_limits<double>::quiet_NaN()); } },
    { "ToonRampRange of its vtkLimnProperty has the value 5; it has to be above 0 and below the "
      "range's other end.",
      [](vtkLimnProperty* property)
      {
        vtkNew<vtkTexture> texture;
        property->SetToneToRamp();
        property->SetToonRamp(texture);
        property->SetToonRampRange(5, 2);
      } },
    { "ToonRampExponent of its vtkLimnProperty has the value -1; it has to be a finite number, not "
      "negative.",
      [](vtkLimnProperty* property)
      {
        vtkNew<vtkTexture> texture;
        property->SetToneToRamp();
        property->SetToonRamp(texture);
        property->SetToonRampExponent(-1);
      } },
  };
  for (const auto& one : cases)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(twoSquares());
    one.spoil(vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty()));
    Messages messages;
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
    CHECK_EQUAL(messages.Count(one.message), 1);
    CHECK_EQUAL(messages.Count("Instance"), 0);
  }
}

void checkMissingInput()
{
  Stage stage;
  Messages messages;
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
  vtkNew<vtkPolyData> empty;
  stage.Mapper->SetInputData(empty);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
  CHECK_EQUAL(messages.GetText(), "");
}

void checkBrokenLight()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkLight> light;
  light->SetIntensity(std::numeric_limits<double>::quiet_NaN());
  stage.Renderer->AddLight(light);
  Messages messages;
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
  CHECK_EQUAL(messages.Count("Light 0 has a value that is not a finite number"), 1);
}

void checkImpossibleLights()
{
  const struct
  {
    const char* message;
    void (*spoil)(vtkLimnLight*);
  } cases[] = {
    { "Light 0 is a rectangle without an area",
      [](vtkLimnLight* light)
      {
        light->SetShapeToRectangle();
        light->SetWidth(0);
      } },
    { "Light 0 is a sphere whose radius is not above 0",
      [](vtkLimnLight* light)
      {
        light->SetShapeToSphere();
        light->SetRadius(-1);
      } },
    { "70000 lights, each sample of an area light counted, are more than 65536",
      [](vtkLimnLight* light)
      {
        light->SetShapeToSphere();
        light->SetSamples(70000);
      } },
    { "Light 0 is directional and has no power",
      [](vtkLimnLight* light) { light->SetUnitToPower(); } },
    { "Light 0 has a soft edge that is not 0 to its cone angle wide",
      [](vtkLimnLight* light)
      {
        light->PositionalOn();
        light->SetSoftEdgeAngle(31);
      } },
  };
  for (const auto& one : cases)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(twoSquares());
    vtkNew<vtkLimnLight> light;
    one.spoil(light);
    stage.Renderer->AddLight(light);
    Messages messages;
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
    CHECK_EQUAL(messages.Count(one.message), 1);
  }
}
}

int TestLimnWarnings(int, char*[])
{
  checkFeatures();
  checkOtherProps();
  checkBrokenMeshes();
  checkBrokenNormals();
  checkBrokenNormalsOfChangedPoints();
  checkUnseenBrokenNormals();
  checkManyBrokenMeshes();
  checkFlattenedMeshes();
  checkLinesOfFlattenedMeshes();
  checkTranslucentIllustration();
  checkSizes();
  checkBrokenActor();
  checkBrokenProperty();
  checkBrokenReflection();
  checkMissingInput();
  checkBrokenLight();
  checkImpossibleLights();
  return result();
}
