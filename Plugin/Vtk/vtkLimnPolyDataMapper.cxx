// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnPolyDataMapper.h"

#include "Private/BackendMapper.h"
#include "Private/DrawSurfaces.h"
#include "Private/MapperInternals.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace
{
// vtkLODActor and its kin choose what they draw by the time it took: a measured time would make the
// picture depend on the machine's mood.
constexpr double NominalTimeToDraw = 1e-4;
}

vtkStandardNewMacro(vtkLimnPolyDataMapper);

//------------------------------------------------------------------------------
vtkLimnPolyDataMapper::vtkLimnPolyDataMapper() : Internals(new vtkInternals) {}

//------------------------------------------------------------------------------
vtkLimnPolyDataMapper::~vtkLimnPolyDataMapper() = default;

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  const bool isDrawn = !renderer->GetRenderWindow()->CheckAbortStatus() &&
                       limn::bridge::isDrawnAlready(renderer, actor, this);
  if (!isDrawn)
  {
    this->Superclass::Render(renderer, actor);
    return;
  }
  this->TimeToDraw = NominalTimeToDraw;
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetRenderWindow()->CheckAbortStatus())
  {
    return;
  }
  if (!limn::bridge::inputOf(this))
  {
    vtkErrorMacro("No input: connect a source or a filter, or call SetInputData().");
    return;
  }
  this->TimeToDraw = NominalTimeToDraw;
  limn::bridge::drawSurface(renderer, actor, this);
  this->UpdateProgress(1.0);
}

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  limn::bridge::releaseBackend(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkIdType vtkLimnPolyDataMapper::GetNumberOfGeometryBuilds()
{
  return this->Internals->Mesh.geometryBuilds();
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkLimnPolyDataMapper::MapScalarsToColors(int& cellFlag)
{
  // The setter would mark this mapper as modified, and with it everything drawn from it.
  const vtkTypeBool interpolate = this->InterpolateScalarsBeforeMapping;
  this->InterpolateScalarsBeforeMapping = 0;
  vtkUnsignedCharArray* colors = this->MapScalars(1.0, cellFlag);
  this->InterpolateScalarsBeforeMapping = interpolate;
  return colors;
}

//------------------------------------------------------------------------------
bool vtkLimnPolyDataMapper::HasTranslucentPolygonalGeometry()
{
  // VTK looks for the scalars first.
  return this->ScalarVisibility && this->Superclass::HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
double* vtkLimnPolyDataMapper::GetBounds()
{
  if (this->NumberOfSubPieces != 1 || !this->Internals->Input.get(this))
  {
    return this->Superclass::GetBounds();
  }
  this->ComputeBounds();
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::ComputeBounds()
{
  limn::bridge::InputBounds& bounds = this->Internals->InputBounds;
  vtkPolyData* const data = limn::bridge::inputOf(this);
  if (!bounds.update(data))
  {
    // Without an input VTK has reset them.
    std::copy(bounds.values().begin(), bounds.values().end(), this->Bounds);
    return;
  }
  if (bounds.areSafe())
  {
    this->Superclass::ComputeBounds();
    bounds.remember(this->Bounds);
    return;
  }
  std::copy(bounds.values().begin(), bounds.values().end(), this->Bounds);
}

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfGeometryBuilds: " << this->GetNumberOfGeometryBuilds() << "\n";
}
