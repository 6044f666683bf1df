// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stage_h
#define Stage_h

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <initializer_list>

/// A window of Limn's with one renderer and one actor, 100 x 80 pixels on black.
struct Stage
{
  vtkNew<vtkLimnRenderWindow> Window;
  vtkNew<vtkLimnRenderer> Renderer;
  vtkNew<vtkLimnActor> Actor;
  vtkNew<vtkLimnPolyDataMapper> Mapper;

  Stage()
  {
    this->Window->SetSize(100, 80);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
  }

  /// World coordinates x and y are then pixels, and z from -1 (far) to 1 (near) is visible.
  void LookFlat()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(40);
    camera->SetPosition(50, 40, 2);
    camera->SetFocalPoint(50, 40, 0);
    camera->SetClippingRange(1, 3);
    this->Actor->GetProperty()->LightingOff();
    this->Window->SetMultiSamples(0);
  }
};

inline void addCell(vtkCellArray* cells, std::initializer_list<vtkIdType> ids)
{
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.begin());
}

/// Points of a plane x, y with height z = 0.
inline vtkSmartPointer<vtkPoints> flatPoints(std::initializer_list<std::array<double, 2>> positions)
{
  vtkNew<vtkPoints> points;
  for (const auto& position : positions)
  {
    points->InsertNextPoint(position[0], position[1], 0);
  }
  return points;
}

/// Two squares of 20 x 20 pixels, cells 0 and 1, with corners at (10, 10) and (40, 10).
inline vtkSmartPointer<vtkPolyData> twoSquares()
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(flatPoints({ { 10, 10 }, { 30, 10 }, { 30, 30 }, { 10, 30 }, { 40, 10 },
    { 60, 10 }, { 60, 30 }, { 40, 30 } }));
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  addCell(polys, { 4, 5, 6, 7 });
  data->SetPolys(polys);
  return data;
}

#endif
