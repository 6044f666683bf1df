// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnPolyDataMapper.h"

#include "Private/BackendMapper.h"
#include "Private/DrawSurfaces.h"
#include "Private/EngineState.h"
#include "Private/MapperInternals.h"

#include "vtkLimnVertexShader.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
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
vtkCxxSetObjectMacro(vtkLimnPolyDataMapper, VertexShader, vtkLimnVertexShader);

//------------------------------------------------------------------------------
vtkLimnPolyDataMapper::vtkLimnPolyDataMapper() : Internals(new vtkInternals) {}

//------------------------------------------------------------------------------
vtkLimnPolyDataMapper::~vtkLimnPolyDataMapper()
{
  this->SetVertexShader(nullptr);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLimnPolyDataMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->VertexShader ? std::max(time, this->VertexShader->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkLimnPolyDataMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  this->Superclass::ShallowCopy(mapper);
  if (vtkLimnPolyDataMapper* const other = vtkLimnPolyDataMapper::SafeDownCast(mapper))
  {
    this->SetVertexShader(other->VertexShader);
  }
}

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
vtkIdType vtkLimnPolyDataMapper::GetNumberOfGeometryMoves()
{
  return this->Internals->Mesh.geometryMoves();
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
  limn::bridge::MovedPoints& moved = this->Internals->Moved;
  vtkPolyData* const data = limn::bridge::inputOf(this);
  if (data && data->GetPoints())
  {
    moved.update(this->VertexShader, data, limn::bridge::EngineState::instance().options.threads);
  }
  if (!bounds.update(data, moved))
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
  os << indent << "VertexShader: ";
  if (this->VertexShader)
  {
    os << "\n";
    this->VertexShader->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "NumberOfGeometryBuilds: " << this->GetNumberOfGeometryBuilds() << "\n";
}
