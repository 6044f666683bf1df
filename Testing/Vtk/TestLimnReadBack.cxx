// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reading and writing the window's pixels and depths.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <memory>

namespace
{
// A tilted plane under perspective: the depth at a pixel follows from where its ray meets the
// plane.
void checkDepth()
{
  Stage stage;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(-9, -9, -4);
  points->InsertNextPoint(9, -9, 4);
  points->InsertNextPoint(9, 9, 4);
  points->InsertNextPoint(-9, 9, -4);
  data->SetPoints(points);
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  stage.Mapper->SetInputData(data);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const double eye = 12;
  const double nearPlane = 2;
  const double farPlane = 30;
  camera->SetPosition(0, 0, eye);
  camera->SetClippingRange(nearPlane, farPlane);
  stage.Window->SetMultiSamples(0);
  stage.Window->Render();

  const double tangent = std::tan(camera->GetViewAngle() * std::acos(-1.0) / 360);
  double worst = 0;
  for (int y = 0; y < 80; y += 7)
  {
    for (int x = 0; x < 100; x += 7)
    {
      const double u = ((x + 0.5) / 50 - 1) * tangent * 100 / 80;
      // The plane is z = 4/9 x; a point of the ray is (u t, ., eye - t).
      const double t = eye / (1 + u * 4 / 9);
      const double ndc =
        (farPlane + nearPlane - 2 * farPlane * nearPlane / t) / (farPlane - nearPlane);
      float depth = 0;
      stage.Window->GetZbufferData(x, y, x, y, &depth);
      worst = std::max(worst, std::abs(depth - (0.5 * ndc + 0.5)));
    }
  }
  // Corners snap to 1/256 pixel.
  CHECK(worst < 2e-5);
  CHECK_EQUAL(stage.Renderer->GetZ(50, 40) < 1.0, true);
}

void checkRegions()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Window->Render();
  using Bytes = std::unique_ptr<unsigned char[]>;
  const Bytes whole(stage.Window->GetPixelData(0, 0, 99, 79, 0));
  const Bytes turned(stage.Window->GetPixelData(99, 79, 0, 0, 1));
  CHECK(std::equal(whole.get(), whole.get() + 3 * 100 * 80, turned.get()));

  // Two columns on each side are outside.
  const Bytes beyond(stage.Window->GetPixelData(-2, 20, 101, 20, 0));
  for (int x = -2; x < 102; ++x)
  {
    const bool isInside = x >= 0 && x < 100;
    const int expected = isInside ? whole[3 * (20 * 100 + x)] : 0;
    CHECK_EQUAL(int(beyond[3 * (x + 2)]), expected);
  }
  const Bytes faraway(stage.Window->GetRGBACharPixelData(5000, 5000, 5003, 5003, 0));
  CHECK_EQUAL(int(faraway[0]), 0);
  const std::unique_ptr<float[]> depths(stage.Window->GetZbufferData(-3, -3, -1, -1));
  CHECK_EQUAL(depths[8], 1.0f);
  vtkNew<vtkUnsignedCharArray> array;
  CHECK_EQUAL(stage.Window->GetPixelData(-2147483647, 0, 2147483647, 0, 0, array), VTK_ERROR);
  delete[] stage.Window->GetPixelData(-2147483647, 0, 2147483647, 0, 0);

  vtkNew<vtkLimnRenderWindow> never;
  const Bytes nothing(never->GetPixelData(0, 0, 9, 9, 0));
  CHECK_EQUAL(int(nothing[0]), 0);
}

void checkArrays()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Window->Render();
  vtkNew<vtkUnsignedCharArray> rgb;
  CHECK_EQUAL(stage.Window->GetPixelData(9, 20, 10, 20, 0, rgb), VTK_OK);
  CHECK_EQUAL(rgb->GetNumberOfTuples(), 2);
  CHECK_EQUAL(int(rgb->GetValue(0)), 0);
  CHECK_EQUAL(int(rgb->GetValue(3)), 255);
  vtkNew<vtkUnsignedCharArray> rgba;
  CHECK_EQUAL(stage.Window->GetRGBACharPixelData(9, 20, 10, 20, 0, rgba), VTK_OK);
  CHECK_EQUAL(rgba->GetNumberOfComponents(), 4);
  CHECK_EQUAL(int(rgba->GetValue(3)), 0);
  CHECK_EQUAL(int(rgba->GetValue(7)), 255);
  vtkNew<vtkFloatArray> floats;
  CHECK_EQUAL(stage.Window->GetRGBAPixelData(10, 20, 10, 20, 0, floats), VTK_OK);
  CHECK_EQUAL(floats->GetValue(2), 1.0f);
  vtkNew<vtkFloatArray> depth;
  CHECK_EQUAL(stage.Window->GetZbufferData(9, 20, 10, 20, depth), VTK_OK);
  CHECK_EQUAL(depth->GetValue(0), 1.0f);
  CHECK_EQUAL(depth->GetValue(1), 0.5f);
  CHECK_EQUAL(stage.Window->GetZbufferData(0, 0, 1, 1, static_cast<float*>(nullptr)), VTK_ERROR);
}

void checkWriting()
{
  Stage stage;
  stage.Window->Render();
  unsigned char rgb[6] = { 1, 2, 3, 4, 5, 6 };
  CHECK_EQUAL(stage.Window->SetPixelData(99, 79, 100, 79, rgb, 0), VTK_OK);
  CHECK_EQUAL(read(stage.Window).At(99, 79), (Pixel{ 1, 2, 3 }));
  unsigned char rgba[4] = { 200, 100, 50, 51 };
  CHECK_EQUAL(stage.Window->SetRGBACharPixelData(0, 0, 0, 0, rgba, 0, 1), VTK_OK);
  CHECK_EQUAL(read(stage.Window).At(0, 0), (Pixel{ 40, 20, 10 }));
  CHECK_EQUAL(stage.Window->SetRGBACharPixelData(0, 0, 0, 0, rgba, 0), VTK_OK);
  CHECK_EQUAL(read(stage.Window).At(0, 0), (Pixel{ 200, 100, 50 }));
  float floats[4] = { 0.5f, 2.0f, -1.0f, 1.0f };
  CHECK_EQUAL(stage.Window->SetRGBAPixelData(1, 0, 1, 0, floats, 0), VTK_OK);
  CHECK_EQUAL(read(stage.Window).At(1, 0), (Pixel{ 128, 255, 0 }));
  float depth = 0.25f;
  CHECK_EQUAL(stage.Window->SetZbufferData(3, 3, 3, 3, &depth), VTK_OK);
  float back = 0;
  stage.Window->GetZbufferData(3, 3, 3, 3, &back);
  CHECK_EQUAL(back, 0.25f);
}

void checkMaps()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Window->MapsOn();
  CHECK(stage.Window->GetMaps());
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputData(twoSquares());
  vtkNew<vtkLimnActor> other;
  other->SetMapper(mapper);
  other->SetPosition(20, 30, 0.5);
  stage.Renderer->AddActor(other);
  stage.Window->Render();

  vtkNew<vtkIdTypeArray> ids;
  CHECK_EQUAL(stage.Window->GetIdData(-1, 0, 99, 79, ids), VTK_OK);
  const auto idAt = [&](int x, int y, int component)
  { return ids->GetTypedComponent(y * 101 + x + 1, component); };
  CHECK_EQUAL(idAt(-1, 0, 0), -1);
  CHECK_EQUAL(idAt(5, 5, 0), -1);
  CHECK_EQUAL(idAt(5, 5, 1), -1);
  CHECK_EQUAL(idAt(20, 20, 0), 0);
  CHECK_EQUAL(idAt(20, 20, 1), 0);
  CHECK_EQUAL(idAt(50, 20, 1), 1);
  CHECK_EQUAL(idAt(40, 50, 0), 1);
  CHECK_EQUAL(idAt(70, 50, 1), 1);
  CHECK(stage.Window->GetMappedActor(0) == stage.Actor);
  CHECK(stage.Window->GetMappedActor(1) == other);
  CHECK(stage.Window->GetMappedActor(2) == nullptr);
  CHECK(stage.Window->GetMappedActor(-1) == nullptr);

  vtkNew<vtkFloatArray> normals;
  CHECK_EQUAL(stage.Window->GetNormalData(20, 20, 20, 20, normals), VTK_OK);
  CHECK_EQUAL(normals->GetNumberOfComponents(), 3);
  CHECK_EQUAL(normals->GetValue(2), 1.0f);
  CHECK_EQUAL(stage.Window->GetNormalData(5, 5, 5, 5, normals), VTK_OK);
  CHECK_EQUAL(normals->GetValue(2), 0.0f);

  // What was there is cleared with the picture.
  stage.Renderer->RemoveActor(other);
  stage.Window->Render();
  stage.Window->GetIdData(40, 50, 40, 50, ids);
  CHECK_EQUAL(ids->GetValue(0), -1);
  CHECK(stage.Window->GetMappedActor(1) == nullptr);
}

void checkNoMaps()
{
  Stage stage;
  stage.Mapper->SetInputData(twoSquares());
  stage.Window->Render();
  const Messages messages;
  vtkNew<vtkIdTypeArray> ids;
  CHECK_EQUAL(stage.Window->GetIdData(0, 0, 9, 9, ids), VTK_ERROR);
  vtkNew<vtkFloatArray> normals;
  CHECK_EQUAL(stage.Window->GetNormalData(0, 0, 9, 9, normals), VTK_ERROR);
  CHECK_EQUAL(messages.Count("without MapsOn()"), 2);
}
}

int TestLimnReadBack(int, char*[])
{
  checkDepth();
  checkRegions();
  checkArrays();
  checkWriting();
  checkMaps();
  checkNoMaps();
  return result();
}
