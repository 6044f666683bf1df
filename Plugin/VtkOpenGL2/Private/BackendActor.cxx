// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BackendActor.h"

#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtk_glew.h"

#include <algorithm>

namespace
{
/// What vtkOpenGLProperty::Render and PostRender do, for a property of any class.
class AppliedProperty
{
public:
  AppliedProperty(vtkProperty* property, vtkRenderer* renderer)
    : Property(property), Renderer(renderer),
      State(static_cast<vtkOpenGLRenderer*>(renderer)->GetState())
  {
    this->State->vtkglCullFace(property->GetBackfaceCulling() ? GL_BACK : GL_FRONT);
    this->State->SetEnumState(GL_CULL_FACE, this->Culls());
    for (const auto& texture : property->GetAllTextures())
    {
      texture.second->Render(renderer);
    }
  }

  ~AppliedProperty()
  {
    if (this->Culls())
    {
      this->State->vtkglDisable(GL_CULL_FACE);
    }
    for (const auto& texture : this->Property->GetAllTextures())
    {
      texture.second->PostRender(this->Renderer);
    }
  }

private:
  bool Culls() const
  {
    return this->Property->GetBackfaceCulling() || this->Property->GetFrontfaceCulling();
  }

  vtkProperty* Property;
  vtkRenderer* Renderer;
  vtkOpenGLState* State;
};

bool Equal(vtkMatrix4x4* a, vtkMatrix4x4* b)
{
  return std::equal(a->GetData(), a->GetData() + 16, b->GetData());
}
}

BackendActor::BackendActor()
{
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetPropertyKeys(this->Keys);
  this->Actor->SetUserMatrix(this->Matrix);
}

BackendActor::~BackendActor() = default;

void BackendActor::Render(vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper)
{
  this->Follow(mapper);
  this->Draw(renderer, actor, this->Mapper);
}

void BackendActor::RenderOpenGLMapper(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  // Only while it draws: the twin must not keep the mapper alive.
  this->Actor->SetMapper(mapper);
  this->Draw(renderer, actor, mapper);
  this->Actor->SetMapper(this->Mapper);
}

void BackendActor::Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  this->Follow(actor);
  AppliedProperty applied(actor->GetProperty(), renderer);
  this->Actor->Render(renderer, mapper);
}

void BackendActor::Follow(vtkPolyDataMapper* mapper)
{
  this->Mapper->ShallowCopy(mapper);
  this->Mapper->SetPiece(mapper->GetPiece());
  this->Mapper->SetStatic(mapper->GetStatic());
  this->Mapper->SetSelection(mapper->GetSelection());
}

void BackendActor::Follow(vtkActor* actor)
{
  this->Actor->SetProperty(actor->GetProperty());
  this->Actor->SetBackfaceProperty(actor->GetBackfaceProperty());
  this->Actor->SetTexture(actor->GetTexture());
  this->Actor->SetShaderProperty(actor->GetShaderProperty());
  this->Actor->SetForceOpaque(actor->GetForceOpaque());
  this->Actor->SetForceTranslucent(actor->GetForceTranslucent());
  this->Actor->SetIsRenderingTranslucentPolygonalGeometry(
    actor->IsRenderingTranslucentPolygonalGeometry());
  this->Keys->Copy(actor->GetPropertyKeys());

  vtkMatrix4x4* matrix = actor->GetMatrix();
  if (!Equal(this->Matrix, matrix))
  {
    this->Matrix->DeepCopy(matrix);
    this->Actor->Modified();
  }
}
