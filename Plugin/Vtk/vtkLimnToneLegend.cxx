// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnToneLegend.h"

#include "Private/ReadBack.h"
#include "Private/ToneLegendPicture.h"
#include "Private/UnusableValues.h"

#include "vtkLimnProperty.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using limn::Rgba8;

namespace
{
/// As surfaces with the table's colours have it.
double LegendSafeRangeOf(vtkProperty* property, vtkScalarsToColors* table)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  const bool isSafe = limn && limn->GetToneOverData() == vtkLimnProperty::DATA_TONE_LEGEND_SAFE;
  return isSafe
           ? limn::bridge::legendSafeBound(table, static_cast<float>(limn->GetLegendSafeRange()))
           : 0;
}
}

vtkStandardNewMacro(vtkLimnToneLegend);
vtkCxxSetObjectMacro(vtkLimnToneLegend, LookupTable, vtkScalarsToColors);
vtkCxxSetObjectMacro(vtkLimnToneLegend, SurfaceProperty, vtkProperty);

//------------------------------------------------------------------------------
vtkLimnToneLegend::vtkLimnToneLegend()
{
  this->PositionCoordinate->SetCoordinateSystemToNormalizedViewport();
  this->PositionCoordinate->SetValue(0.02, 0.02);
  this->Position2Coordinate->SetCoordinateSystemToNormalizedViewport();
  this->Position2Coordinate->SetValue(0.2, 1.0 / 12);
  this->Position2Coordinate->SetReferenceCoordinate(this->PositionCoordinate);
}

//------------------------------------------------------------------------------
vtkLimnToneLegend::~vtkLimnToneLegend()
{
  this->SetLookupTable(nullptr);
  this->SetSurfaceProperty(nullptr);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLimnToneLegend::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->LookupTable)
  {
    time = std::max(time, this->LookupTable->GetMTime());
  }
  return this->SurfaceProperty ? std::max(time, this->SurfaceProperty->GetMTime()) : time;
}

//------------------------------------------------------------------------------
bool vtkLimnToneLegend::UpdateImage()
{
  if (!this->LookupTable || !this->SurfaceProperty)
  {
    vtkErrorMacro("No legend without both a LookupTable and a SurfaceProperty; set them.");
    return false;
  }
  if (this->ImageTime > this->GetMTime())
  {
    return true;
  }
  const std::string fault = limn::bridge::unusableValueOf(this->SurfaceProperty);
  if (!fault.empty())
  {
    vtkErrorMacro("No legend: " << fault);
    return false;
  }
  const std::vector<Rgba8> colors = limn::bridge::colorsOf(this->LookupTable, this->NumberOfValues);
  std::vector<Rgba8> pixels;
  const limn::Status status =
    limn::bridge::drawToneLegend({ colors, this->NumberOfTones, this->SurfaceProperty,
                                   LegendSafeRangeOf(this->SurfaceProperty, this->LookupTable) },
      pixels);
  if (!status.ok())
  {
    vtkErrorMacro("No legend: " << status.message);
    return false;
  }
  this->Image->SetDimensions(this->NumberOfValues, this->NumberOfTones, 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(this->Image->GetScalarPointer());
  for (const Rgba8& pixel : pixels)
  {
    *bytes++ = pixel.r;
    *bytes++ = pixel.g;
    *bytes++ = pixel.b;
  }
  this->Image->Modified();
  this->ImageTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* vtkLimnToneLegend::GetImage()
{
  return this->UpdateImage() ? this->Image.Get() : nullptr;
}

//------------------------------------------------------------------------------
double vtkLimnToneLegend::GetReadBackError()
{
  // For what can be said against the two.
  if (!this->UpdateImage())
  {
    return -1;
  }
  const std::vector<Rgba8> legend =
    limn::bridge::colorsOf(this->LookupTable, limn::bridge::kLegendColors);
  double error = 0;
  const limn::Status status = limn::bridge::readBackError(legend, this->SurfaceProperty,
    LegendSafeRangeOf(this->SurfaceProperty, this->LookupTable), error);
  if (!status.ok())
  {
    vtkErrorMacro("No error of reading back: " << status.message);
    return -1;
  }
  return error;
}

//------------------------------------------------------------------------------
double vtkLimnToneLegend::FindLegendSafeRange(vtkScalarsToColors* table, double error)
{
  constexpr int Steps = 100;
  constexpr double Step = 0.5;
  if (!std::isfinite(error) || error < 0)
  {
    vtkGenericWarningMacro("No range of lightness keeps an error of "
                           << error << "; it has to be a finite number, not negative.");
    return 0;
  }
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  property->SetToneOverDataToLegendSafe();
  if (!table)
  {
    return 0;
  }
  const std::vector<Rgba8> legend = limn::bridge::colorsOf(table, limn::bridge::kLegendColors);
  for (int i = 1; i <= Steps; ++i)
  {
    double found = 0;
    if (!limn::bridge::readBackError(legend, property, Step * i, found).ok() || found > error)
    {
      return Step * (i - 1);
    }
  }
  return Step * Steps;
}

//------------------------------------------------------------------------------
bool vtkLimnToneLegend::UpdateRectangle(vtkViewport* viewport)
{
  if (!this->UpdateImage())
  {
    return false;
  }
  if (!this->Mapper)
  {
    // Not in the constructor: there is none where there is no OpenGL.
    vtkSmartPointer<vtkPolyDataMapper2D> mapper =
      vtkSmartPointer<vtkPolyDataMapper2D>::Take(vtkPolyDataMapper2D::New());
    mapper->SetInputData(this->Rectangle);
    mapper->SetScalarModeToUseCellData();
    this->SetMapper(mapper);
  }
  const int* const from = this->PositionCoordinate->GetComputedViewportValue(viewport);
  const int origin[2] = { from[0], from[1] };
  const int* const to = this->Position2Coordinate->GetComputedViewportValue(viewport);
  const int size[2] = { to[0] - origin[0], to[1] - origin[1] };
  if (this->RectangleTime > this->ImageTime && std::equal(size, size + 2, this->RectangleSize))
  {
    return true;
  }
  std::copy(size, size + 2, this->RectangleSize);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row <= this->NumberOfTones; ++row)
  {
    for (int column = 0; column <= this->NumberOfValues; ++column)
    {
      points->InsertNextPoint(static_cast<double>(size[0]) * column / this->NumberOfValues,
        static_cast<double>(size[1]) * row / this->NumberOfTones, 0);
    }
  }
  const vtkIdType stride = this->NumberOfValues + 1;
  for (vtkIdType row = 0; row < this->NumberOfTones; ++row)
  {
    for (vtkIdType column = 0; column < this->NumberOfValues; ++column)
    {
      const vtkIdType first = row * stride + column;
      const vtkIdType square[4] = { first, first + 1, first + stride + 1, first + stride };
      cells->InsertNextCell(4, square);
    }
  }
  this->Rectangle->Initialize();
  this->Rectangle->SetPoints(points);
  this->Rectangle->SetPolys(cells);
  this->Rectangle->GetCellData()->SetScalars(this->Image->GetPointData()->GetScalars());
  this->RectangleTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
int vtkLimnToneLegend::RenderOverlay(vtkViewport* viewport)
{
  return this->UpdateRectangle(viewport) ? this->Superclass::RenderOverlay(viewport) : 0;
}

//------------------------------------------------------------------------------
int vtkLimnToneLegend::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return this->UpdateRectangle(viewport) ? this->Superclass::RenderOpaqueGeometry(viewport) : 0;
}

//------------------------------------------------------------------------------
int vtkLimnToneLegend::RenderTranslucentPolygonalGeometry(vtkViewport*)
{
  return 0;
}

//------------------------------------------------------------------------------
void vtkLimnToneLegend::ShallowCopy(vtkProp* prop)
{
  // The mapper draws the other's rectangle.
  vtkSmartPointer<vtkMapper2D> own = this->Mapper;
  this->Superclass::ShallowCopy(prop);
  this->SetMapper(own);
  if (vtkLimnToneLegend* const other = vtkLimnToneLegend::SafeDownCast(prop))
  {
    this->SetLookupTable(other->LookupTable);
    this->SetSurfaceProperty(other->SurfaceProperty);
    this->SetNumberOfValues(other->NumberOfValues);
    this->SetNumberOfTones(other->NumberOfTones);
  }
}

//------------------------------------------------------------------------------
void vtkLimnToneLegend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LookupTable: " << this->LookupTable << "\n";
  os << indent << "SurfaceProperty: " << this->SurfaceProperty << "\n";
  os << indent << "NumberOfValues: " << this->NumberOfValues << "\n";
  os << indent << "NumberOfTones: " << this->NumberOfTones << "\n";
}
