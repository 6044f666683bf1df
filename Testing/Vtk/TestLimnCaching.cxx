// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is prepared anew when something changes, and what is not.
#include "Check.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnEngine.h"
#include "vtkLimnProperty.h"

#include "vtkCallbackCommand.h"
#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"

namespace
{
/// As a mapper draws it that has never seen the data.
Picture pictureOfACopy(Stage& stage, vtkPolyData* data)
{
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(data);
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputData(copy);
  mapper->SetScalarVisibility(stage.Mapper->GetScalarVisibility());
  stage.Actor->SetMapper(mapper);
  const Picture picture = render(stage.Window);
  stage.Actor->SetMapper(stage.Mapper);
  return picture;
}

vtkSmartPointer<vtkPolyData> makeSquare(double left, double side)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(flatPoints(
    { { left, 10 }, { left + side, 10 }, { left + side, 10 + side }, { left, 10 + side } }));
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  return data;
}

void setRight(vtkPolyData* square, double right)
{
  square->GetPoints()->SetPoint(1, right, 10, 0);
  square->GetPoints()->SetPoint(2, right, 30, 0);
}

// Input that was set as data is not asked for again as long as nothing was modified.
void checkModifiedData()
{
  Stage stage;
  stage.LookFlat();
  const vtkSmartPointer<vtkPolyData> data = makeSquare(10, 20);
  stage.Mapper->SetInputData(data);
  const auto drawnPixels = [&]() { return render(stage.Window).CountOtherThan({ 0, 0, 0 }); };
  const auto rightBound = [&]() { return stage.Actor->GetBounds()[1]; };
  CHECK_EQUAL(drawnPixels(), 20 * 20);
  CHECK_EQUAL(drawnPixels(), 20 * 20);
  CHECK_EQUAL(rightBound(), 30);

  setRight(data, 40);
  data->GetPoints()->Modified();
  CHECK_EQUAL(rightBound(), 40);
  CHECK_EQUAL(drawnPixels(), 30 * 20);
  setRight(data, 50);
  data->GetPoints()->GetData()->Modified();
  CHECK_EQUAL(drawnPixels(), 40 * 20);
  CHECK_EQUAL(rightBound(), 50);

  // Two of the four corners, twice each.
  data->GetPolys()->GetConnectivityArray()->SetComponent(2, 0, 1);
  data->GetPolys()->GetConnectivityArray()->SetComponent(3, 0, 0);
  data->GetPolys()->GetConnectivityArray()->Modified();
  CHECK_EQUAL(drawnPixels(), 0);
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  CHECK_EQUAL(drawnPixels(), 40 * 20);
  CHECK_EQUAL(stage.Actor->GetBounds()[3], 30);

  data->Initialize();
  CHECK_EQUAL(drawnPixels(), 0);
  data->ShallowCopy(makeSquare(10, 10));
  CHECK_EQUAL(drawnPixels(), 10 * 10);
  CHECK_EQUAL(rightBound(), 20);
}

void checkReplacedData()
{
  Stage stage;
  stage.LookFlat();
  const auto drawnPixels = [&]() { return render(stage.Window).CountOtherThan({ 0, 0, 0 }); };
  const vtkSmartPointer<vtkPolyData> small = makeSquare(10, 20);
  const vtkSmartPointer<vtkPolyData> large = makeSquare(10, 40);
  stage.Mapper->SetInputData(small);
  CHECK_EQUAL(drawnPixels(), 20 * 20);
  stage.Mapper->SetInputData(large);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 50);
  CHECK_EQUAL(drawnPixels(), 40 * 40);

  auto* const producer = vtkTrivialProducer::SafeDownCast(stage.Mapper->GetInputAlgorithm());
  producer->SetOutput(small);
  CHECK_EQUAL(stage.Actor->GetBounds()[1], 30);
  CHECK_EQUAL(drawnPixels(), 20 * 20);

  // One that is gone with its producer.
  stage.Mapper->SetInputData(makeSquare(20, 30));
  CHECK_EQUAL(drawnPixels(), 30 * 30);
  stage.Mapper->RemoveAllInputConnections(0);
  CHECK_EQUAL(drawnPixels(), 0);
  stage.Mapper->SetInputData(makeSquare(20, 25));
  CHECK_EQUAL(drawnPixels(), 25 * 25);
}

// Who observes the mapper may change its input at the last moment.
void checkDataModifiedByObserver()
{
  Stage stage;
  stage.LookFlat();
  const vtkSmartPointer<vtkPolyData> data = makeSquare(10, 20);
  stage.Mapper->SetInputData(data);
  vtkNew<vtkCallbackCommand> grow;
  grow->SetClientData(data);
  grow->SetCallback(
    [](vtkObject*, unsigned long, void* square, void*)
    {
      auto* const points = static_cast<vtkPolyData*>(square)->GetPoints();
      setRight(static_cast<vtkPolyData*>(square), points->GetPoint(1)[0] + 1);
      points->Modified();
    });
  const int before = render(stage.Window).CountOtherThan({ 0, 0, 0 });
  CHECK_EQUAL(before, 20 * 20);
  stage.Mapper->AddObserver(vtkCommand::StartEvent, grow);
  CHECK(render(stage.Window).CountOtherThan({ 0, 0, 0 }) > before);
}

void checkWhatIsPreparedAnew()
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(sphere->GetOutputPort());
  elevation->SetLowPoint(0, -0.5, 0);
  elevation->SetHighPoint(0, 0.5, 0);
  elevation->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(elevation->GetOutput());
  stage.Mapper->SetInputData(data);

  Picture before = render(stage.Window);
  const auto isChanged = [&]()
  {
    const Picture now = render(stage.Window);
    const bool differs = !(now == before);
    before = now;
    return differs;
  };
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);
  CHECK_EQUAL(vtkLimnEngine::GetTriangles(), data->GetNumberOfPolys());
  CHECK(!isChanged());

  stage.Renderer->GetActiveCamera()->Azimuth(25);
  CHECK(isChanged());
  stage.Actor->SetPosition(0.1, 0, 0);
  CHECK(isChanged());
  stage.Actor->GetProperty()->SetAmbient(0.3);
  CHECK(isChanged());
  vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty())->SetShadingFrequencyToFlat();
  CHECK(isChanged());
  vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty())->SetShadingFrequencyToGouraud();
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);

  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.1, 0.3);
  stage.Mapper->SetLookupTable(table);
  CHECK(isChanged());
  table->SetHueRange(0.5, 0.9);
  table->Build();
  CHECK(isChanged());
  vtkDataArray* scalars = data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, 1.0 - scalars->GetTuple1(i));
  }
  scalars->Modified();
  CHECK(isChanged());
  stage.Mapper->ScalarVisibilityOff();
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);

  // Points in place, by the array's modification or by the data set's: they are moved.
  data->GetPoints()->SetPoint(0, 0, 0, 0.9);
  data->GetPoints()->Modified();
  CHECK(isChanged());
  CHECK(before == pictureOfACopy(stage, data));
  static_cast<float*>(data->GetPoints()->GetVoidPointer(0))[2] = 1.2f;
  data->Modified();
  CHECK(isChanged());
  CHECK(before == pictureOfACopy(stage, data));
  // Other points over the same cells, in double.
  vtkNew<vtkPoints> far;
  far->SetDataTypeToDouble();
  far->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* const p = data->GetPoint(i);
    far->SetPoint(i, 0.3 + 1.1 * p[0], p[1], p[2] / 3);
  }
  data->SetPoints(far);
  CHECK(isChanged());
  CHECK(before == pictureOfACopy(stage, data));
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);
  // A point that is nowhere.
  far->SetPoint(3, vtkMath::Nan(), 0, 0);
  far->Modified();
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 2);
  far->SetPoint(3, 0.1, 0.2, 0.3);
  far->Modified();
  CHECK(isChanged());
  CHECK(before == pictureOfACopy(stage, data));
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 3);

  // Other cells.
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 2, 3, 4 });
  data->SetPolys(polys);
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 4);

  // Through the pipeline.
  stage.Mapper->SetInputConnection(elevation->GetOutputPort());
  CHECK(isChanged());
  sphere->SetThetaResolution(20);
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 6);
  CHECK(!isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 6);
  // A filter modifies its output, of which the points are as they were.
  stage.Mapper->ScalarVisibilityOn();
  CHECK(isChanged());
  const vtkIdType moves = stage.Mapper->GetNumberOfGeometryMoves();
  elevation->SetLowPoint(0, -0.8, 0);
  CHECK(isChanged());
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 6);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryMoves(), moves);
}

/// Clusters of random points would stay bad when the points become a surface.
void checkDisorderPasses()
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(120);
  sphere->SetPhiResolution(120);
  sphere->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(sphere->GetOutput());
  const vtkSmartPointer<vtkPoints> order = data->GetPoints();
  vtkNew<vtkPoints> points;
  points->DeepCopy(order);
  data->SetPoints(points);
  stage.Mapper->SetInputData(data);
  const vtkIdType count = points->GetNumberOfPoints();
  const auto shuffle = [&](vtkIdType step)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->SetPoint(i, order->GetPoint(i * step % count));
    }
    points->Modified();
    return render(stage.Window);
  };
  shuffle(2741);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);
  // Built once more; then seldom, as it has not helped.
  for (const vtkIdType step : { 3, 7, 11, 13, 17, 19, 23 })
  {
    shuffle(step * 331);
  }
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 4);
  for (int i = 0; i < 8; ++i)
  {
    shuffle(1);
  }
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 5);
  CHECK(shuffle(1) == pictureOfACopy(stage, data));
  shuffle(2741);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 6);
}

void checkExaggerationFollowsItsMesh()
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(sphere->GetOutput());
  stage.Mapper->SetInputData(data);
  auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->SetToneToExaggerated();
  property->SetToneLightToUpperRight();
  const Picture smooth = render(stage.Window);
  CHECK(smooth == render(stage.Window));
  // A dent, with normals that stay, then normals that change.
  for (vtkIdType i = 100; i < 160; i += 3)
  {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, 0.9 * p[0], 0.9 * p[1], 0.9 * p[2]);
  }
  data->GetPoints()->Modified();
  const Picture dented = render(stage.Window);
  CHECK(!(dented == smooth));
  CHECK(dented == pictureOfACopy(stage, data));
  vtkDataArray* const normals = data->GetPointData()->GetNormals();
  for (vtkIdType i = 100; i < 160; i += 3)
  {
    normals->SetTuple3(i, 0, 0, 1);
  }
  normals->Modified();
  const Picture turned = render(stage.Window);
  CHECK(!(turned == dented));
  CHECK(turned == pictureOfACopy(stage, data));
  // Each scale and number of levels has normals of its own.
  property->SetExaggerationScale(0.2);
  const Picture coarse = render(stage.Window);
  CHECK(!(coarse == turned));
  property->SetExaggerationScale(0.06);
  CHECK(turned == render(stage.Window));
  property->SetExaggerationLevels(2);
  CHECK(!(turned == render(stage.Window)));
  data->GetPointData()->SetNormals(nullptr);
  CHECK(render(stage.Window) == pictureOfACopy(stage, data));
}

// VTK resets a mapper's bounds while there is no input.
void checkInputTakenAwayAndGivenBack()
{
  Stage stage;
  stage.LookFlat();
  const vtkSmartPointer<vtkPolyData> data = makeSquare(10, 20);
  stage.Mapper->SetInputData(data);
  const Picture before = render(stage.Window);
  const double right = stage.Mapper->GetBounds()[1];
  stage.Mapper->SetInputData(nullptr);
  CHECK(stage.Mapper->GetBounds()[1] < stage.Mapper->GetBounds()[0]);
  stage.Mapper->SetInputData(data);
  CHECK_EQUAL(stage.Mapper->GetBounds()[1], right);
  CHECK(before == render(stage.Window));
}
}

int TestLimnCaching(int, char*[])
{
  checkModifiedData();
  checkReplacedData();
  checkDataModifiedByObserver();
  checkWhatIsPreparedAnew();
  checkDisorderPasses();
  checkExaggerationFollowsItsMesh();
  checkInputTakenAwayAndGivenBack();
  return result();
}
