// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageCanvasSource2D.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <ostream>

/// A way to draw an actor that Limn leaves to the window's own backend, or that tests what is
/// handed over to it.
struct Look
{
  const char* Name;
  void (*Apply)(vtkActor*);
};

inline std::ostream& operator<<(std::ostream& os, const Look& look)
{
  return os << look.Name;
}

/// A quadrilateral mesh, folded so that some of it shows its back, with texture coordinates, point
/// scalars "height" and cell scalars "cell".
inline vtkSmartPointer<vtkPolyData> MakeQuads()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.8, -0.6, -0.3);
  plane->SetPoint1(0.7, -0.5, 0.4);
  plane->SetPoint2(-0.7, 0.7, 0.1);
  plane->SetResolution(5, 4);
  plane->Update();
  vtkSmartPointer<vtkPolyData> data = plane->GetOutput();
  vtkPoints* points = data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double* x = points->GetPoint(i);
    if (x[0] > 0.2)
    {
      points->SetPoint(i, 0.4 - x[0], x[1] - 0.1, x[2] - 0.5);
    }
  }
  vtkNew<vtkFloatArray> height;
  height->SetName("height");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(static_cast<float>(data->GetPoint(i)[2]));
  }
  data->GetPointData()->SetScalars(height);
  vtkNew<vtkFloatArray> cell;
  cell->SetName("cell");
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    cell->InsertNextValue(static_cast<float>((7 * i) % 20));
  }
  data->GetCellData()->AddArray(cell);
  return data;
}

inline vtkSmartPointer<vtkTexture> MakeTexture()
{
  vtkNew<vtkImageCanvasSource2D> canvas;
  canvas->SetScalarTypeToUnsignedChar();
  canvas->SetNumberOfScalarComponents(3);
  canvas->SetExtent(0, 15, 0, 15, 0, 0);
  canvas->SetDrawColor(250, 200, 40);
  canvas->FillBox(0, 15, 0, 15);
  canvas->SetDrawColor(20, 60, 200);
  canvas->FillBox(0, 7, 0, 7);
  canvas->FillBox(8, 15, 8, 15);
  vtkSmartPointer<vtkTexture> texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputConnection(canvas->GetOutputPort());
  texture->InterpolateOn();
  return texture;
}

inline const Look Looks[] = {
  { "Surface", [](vtkActor*) {} },
  { "Translucent",
    [](vtkActor* actor)
    {
      actor->GetProperty()->SetOpacity(0.4);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "Wireframe", [](vtkActor* actor) { actor->GetProperty()->SetRepresentationToWireframe(); } },
  { "Points",
    [](vtkActor* actor)
    {
      actor->GetProperty()->SetRepresentationToPoints();
      actor->GetProperty()->SetPointSize(5);
    } },
  { "Edges",
    [](vtkActor* actor)
    {
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->SetEdgeColor(1.0, 0.2, 0.2);
    } },
  { "Textured",
    [](vtkActor* actor)
    {
      actor->SetTexture(MakeTexture());
      actor->GetMapper()->ScalarVisibilityOff();
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "TextureTransformed",
    [](vtkActor* actor)
    {
      vtkNew<vtkTransform> transform;
      transform->Scale(2.0, 3.0, 1.0);
      transform->RotateZ(20.0);
      vtkSmartPointer<vtkTexture> texture = MakeTexture();
      texture->SetTransform(transform);
      actor->SetTexture(texture);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "PropertyTexture",
    [](vtkActor* actor)
    {
      actor->GetProperty()->SetTexture("paint", MakeTexture());
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "CulledBack",
    [](vtkActor* actor)
    {
      actor->GetProperty()->SetOpacity(0.7);
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->BackfaceCullingOn();
    } },
  { "CulledFront",
    [](vtkActor* actor)
    {
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->FrontfaceCullingOn();
      actor->RotateY(180.0);
    } },
  { "BackfaceProperty",
    [](vtkActor* actor)
    {
      vtkNew<vtkProperty> back;
      back->SetColor(0.9, 0.1, 0.6);
      actor->SetBackfaceProperty(back);
      actor->GetMapper()->ScalarVisibilityOff();
      actor->GetProperty()->EdgeVisibilityOn();
      actor->RotateY(180.0);
    } },
  { "CellScalars",
    [](vtkActor* actor)
    {
      vtkNew<vtkLookupTable> table;
      table->SetHueRange(0.6, 0.1);
      table->SetNumberOfTableValues(11);
      table->Build();
      vtkMapper* mapper = actor->GetMapper();
      mapper->SetLookupTable(table);
      mapper->SetScalarModeToUseCellFieldData();
      mapper->SelectColorArray("cell");
      mapper->SetScalarRange(3.0, 17.0);
      actor->GetProperty()->SetOpacity(0.8);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "InterpolatedScalars",
    [](vtkActor* actor)
    {
      actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
      actor->GetMapper()->SetScalarRange(-0.4, 0.5);
      actor->GetProperty()->SetOpacity(0.9);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "Moved",
    [](vtkActor* actor)
    {
      vtkNew<vtkTransform> user;
      user->RotateX(25.0);
      actor->SetUserTransform(user);
      actor->SetPosition(0.1, -0.2, 0.3);
      actor->SetScale(1.1, 0.7, 1.3);
      actor->RotateZ(33.0);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "Clipped",
    [](vtkActor* actor)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.3, 1.0, 0.1);
      actor->GetMapper()->AddClippingPlane(plane);
      actor->GetProperty()->EdgeVisibilityOn();
    } },
  { "ForcedOpaque",
    [](vtkActor* actor)
    {
      actor->ForceOpaqueOn();
      actor->GetProperty()->SetOpacity(0.3);
    } },
  { "ForcedTranslucent",
    [](vtkActor* actor)
    {
      actor->ForceTranslucentOn();
      actor->GetProperty()->EdgeVisibilityOn();
    } },
};
