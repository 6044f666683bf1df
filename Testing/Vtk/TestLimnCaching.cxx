// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is prepared anew when something changes, and what is not.
#include "Check.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnEngine.h"
#include "vtkLimnProperty.h"

#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

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
}

int TestLimnCaching(int, char*[])
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
  return result();
}
