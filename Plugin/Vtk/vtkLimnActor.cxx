// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnActor.h"

#include "Private/BackendMapper.h"
#include "Private/DrawSurfaces.h"
#include "Private/ShaderProperty.h"

#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"

#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <cmath>

namespace
{
bool HasDecal(vtkActor* actor)
{
  vtkLimnProperty* property = vtkLimnProperty::SafeDownCast(actor->GetProperty());
  return property && property->GetTextureMode() == vtkLimnProperty::TEXTURE_DECAL;
}

// No vtkCamera comes nearer to what it looks at.
constexpr double SmallestSize = 1e-20;
// Squares of distances are floats, with room for how far away a camera is.
constexpr double LargestSize = 1e18;

// The diagonal; 0 if there is no box.
double SizeOf(const double* bounds)
{
  const double sides[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  return sides[0] < 0 ? 0 : std::hypot(sides[0], sides[1], sides[2]);
}

bool IsInLimnWindow(vtkViewport* viewport)
{
  return vtkLimnRenderWindow::SafeDownCast(viewport->GetVTKWindow()) != nullptr;
}
}

vtkStandardNewMacro(vtkLimnActor);

//------------------------------------------------------------------------------
int vtkLimnActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  if (!IsInLimnWindow(viewport))
  {
    return this->Superclass::RenderOpaqueGeometry(viewport);
  }
  vtkRenderer* renderer = static_cast<vtkRenderer*>(viewport);
  // As VTK's: selections see translucent actors, too, but for those that nobody sees.
  const bool isSelected = renderer->GetSelector() && this->GetProperty()->GetOpacity() > 0;
  if (!this->Mapper || (!isSelected && !this->HasOpaqueGeometry()))
  {
    return 0;
  }
  this->Render(renderer, this->Mapper);
  return 1;
}

//------------------------------------------------------------------------------
int vtkLimnActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  if (!IsInLimnWindow(viewport))
  {
    limn::bridge::blendWaitingLines(static_cast<vtkRenderer*>(viewport));
    return this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
  }
  vtkRenderer* renderer = static_cast<vtkRenderer*>(viewport);
  if (!this->Mapper || renderer->GetSelector() || !this->HasTranslucentPolygonalGeometry())
  {
    return 0;
  }
  this->InTranslucentPass = true;
  this->Render(renderer, this->Mapper);
  this->InTranslucentPass = false;
  return 1;
}

//------------------------------------------------------------------------------
int vtkLimnActor::RenderVolumetricGeometry(vtkViewport* viewport)
{
  // The first that renderers without anything translucent ask for after the opaque actors.
  limn::bridge::blendWaitingLines(static_cast<vtkRenderer*>(viewport));
  return this->Superclass::RenderVolumetricGeometry(viewport);
}

//------------------------------------------------------------------------------
void vtkLimnActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  limn::bridge::renderMapper(renderer, this, mapper);
  this->EstimatedRenderTime += mapper->GetTimeToDraw();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkLimnActor::HasOpaqueGeometry()
{
  vtkTexture* texture = this->Texture;
  this->Texture = HasDecal(this) ? nullptr : texture;
  const vtkTypeBool isOpaque = this->Superclass::HasOpaqueGeometry();
  this->Texture = texture;
  return isOpaque;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkLimnActor::HasTranslucentPolygonalGeometry()
{
  vtkTexture* texture = this->Texture;
  this->Texture = HasDecal(this) ? nullptr : texture;
  const vtkTypeBool isTranslucent = this->Superclass::HasTranslucentPolygonalGeometry();
  this->Texture = texture;
  // VTK would render that in no pass, and nobody would hear of it.
  return isTranslucent || std::isnan(this->GetProperty()->GetOpacity());
}

//------------------------------------------------------------------------------
double* vtkLimnActor::GetBounds()
{
  double* bounds = this->Superclass::GetBounds();
  const double size = bounds ? SizeOf(bounds) : 0;
  const bool isSmall = size > 0 && size < SmallestSize;
  const bool isLarge = size > LargestSize;
  const int fault = isSmall ? TOO_SMALL : (isLarge ? TOO_LARGE : NO_FAULT);
  if (fault != NO_FAULT && fault != this->SizeFault)
  {
    vtkWarningMacro(
      "Its size in the world is "
      << size
      << (isSmall
             ? "; nearer than 1e-20 no vtkCamera comes, and there may be nothing to see: scale "
               "it up."
             : "; above 1e+18 it is not lit as it should be: scale it down."));
  }
  this->SizeFault = fault;
  return bounds;
}

//------------------------------------------------------------------------------
vtkProperty* vtkLimnActor::MakeProperty()
{
  return vtkLimnProperty::New();
}

//------------------------------------------------------------------------------
vtkShaderProperty* vtkLimnActor::GetShaderProperty()
{
  if (!this->ShaderProperty)
  {
    this->SetShaderProperty(limn::bridge::makeShaderProperty());
  }
  return this->ShaderProperty;
}

//------------------------------------------------------------------------------
void vtkLimnActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
