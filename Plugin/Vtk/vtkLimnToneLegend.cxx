// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnToneLegend.h"

#include "Private/ToneLegendPicture.h"
#include "Private/UnusableValues.h"

#include "vtkLimnProperty.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using limn::Rgba8;

Rgba8 ColorOf(vtkScalarsToColors* table, int number, int count)
{
  vtkLookupTable* const entries = vtkLookupTable::SafeDownCast(table);
  const unsigned char* color = nullptr;
  if (entries && entries->GetNumberOfTableValues() > 0)
  {
    const vtkIdType last = entries->GetNumberOfTableValues() - 1;
    color = entries->GetPointer(count > 1 ? (number * last + (count - 1) / 2) / (count - 1) : 0);
  }
  else
  {
    const double* const range = table->GetRange();
    const double share = count > 1 ? static_cast<double>(number) / (count - 1) : 0.0;
    color = table->MapValue(range[0] + share * (range[1] - range[0]));
  }
  return { color[0], color[1], color[2], 255 };
}

std::vector<Rgba8> ColorsOf(vtkScalarsToColors* table, int count)
{
  table->Build();
  std::vector<Rgba8> colors;
  for (int i = 0; i < count; ++i)
  {
    colors.push_back(ColorOf(table, i, count));
  }
  return colors;
}

using Lab = std::array<double, 3>;

Lab LabOf(Rgba8 color)
{
  const double rgb[3] = { color.r / 255.0, color.g / 255.0, color.b / 255.0 };
  Lab lab;
  vtkMath::RGBToLab(rgb, lab.data());
  return lab;
}

/// Of the nearest, from 0 to 1.
double ReadValue(const std::vector<Lab>& legend, const Lab& color)
{
  std::size_t nearest = 0;
  double least = VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < legend.size(); ++i)
  {
    const double distance = vtkMath::Distance2BetweenPoints(legend[i].data(), color.data());
    if (distance < least)
    {
      least = distance;
      nearest = i;
    }
  }
  return static_cast<double>(nearest) / static_cast<double>(legend.size() - 1);
}

constexpr int LegendColors = 128;

/// Negative, with the reason, if the surface cannot be drawn.
double ReadBackErrorOf(vtkScalarsToColors* table, vtkProperty* property, std::string& reason)
{
  constexpr int Tones = 64;
  const std::vector<Rgba8> colors = ColorsOf(table, LegendColors);
  std::vector<Lab> legend;
  for (const Rgba8& color : colors)
  {
    legend.push_back(LabOf(color));
  }
  std::vector<Rgba8> pixels;
  const limn::Status status = limn::bridge::drawToneLegend({ colors, Tones, property }, pixels);
  if (!status.ok())
  {
    reason = status.message;
    return -1;
  }
  // Of a sphere that is lit from the eye, l.n of 0 ... c fills a share of c^2 of the picture.
  double sum = 0;
  double weights = 0;
  for (int row = Tones / 2; row < Tones; ++row)
  {
    const double cosine = (2.0 * row + 1) / Tones - 1;
    for (int column = 0; column < LegendColors; ++column)
    {
      const Rgba8& drawn = pixels[static_cast<std::size_t>(row) * LegendColors + column];
      const double value = static_cast<double>(column) / (LegendColors - 1);
      sum += cosine * std::fabs(ReadValue(legend, LabOf(drawn)) - value);
      weights += cosine;
    }
  }
  return sum / weights;
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
  const std::vector<Rgba8> colors = ColorsOf(this->LookupTable, this->NumberOfValues);
  std::vector<Rgba8> pixels;
  const limn::Status status =
    limn::bridge::drawToneLegend({ colors, this->NumberOfTones, this->SurfaceProperty }, pixels);
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
  std::string reason;
  const double error = ReadBackErrorOf(this->LookupTable, this->SurfaceProperty, reason);
  if (error < 0)
  {
    vtkErrorMacro("No error of reading back: " << reason);
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
  for (int i = 1; table && i <= Steps; ++i)
  {
    property->SetLegendSafeRange(Step * i);
    std::string reason;
    const double found = ReadBackErrorOf(table, property, reason);
    if (found < 0 || found > error)
    {
      return Step * (i - 1);
    }
  }
  return table ? Step * Steps : 0;
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
