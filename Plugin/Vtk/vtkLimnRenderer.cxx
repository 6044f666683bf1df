// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnRenderer.h"

#include "Private/ClearViewport.h"
#include "Private/DrawSurfaces.h"

#include "vtkLimnActor.h"
#include "vtkLimnCamera.h"
#include "vtkLimnPostEffects.h"
#include "vtkLimnRenderWindow.h"

#include "vtkCommand.h"
#include "vtkFXAAOptions.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderPass.h"

#include <algorithm>

namespace
{
struct Kind
{
  const char* Class;
  const char* Name;
};

// Base classes; what derives from them is of the same kind.
const Kind KindsNotDrawn[] = {
  { "vtkActor2D", "2D props" },
  { "vtkContextActor", "charts" },
  { "vtkImageSlice", "images" },
  { "vtkImageStack", "images" },
  { "vtkTextActor3D", "text in space" },
  { "vtkBillboardTextActor3D", "text in space" },
  { "vtkSkybox", "skyboxes" },
  { "vtkVolume", "volumes" },
  { "vtkLegendScaleActor", "2D props" },
  { "vtkAffineRepresentation2D", "2D widgets" },
  { "vtkAngleRepresentation2D", "2D widgets" },
  { "vtkBalloonRepresentation", "2D widgets" },
  { "vtkBiDimensionalRepresentation2D", "2D widgets" },
  { "vtkBorderRepresentation", "2D widgets" },
  { "vtkCenteredSliderRepresentation", "2D widgets" },
  { "vtkCompassRepresentation", "2D widgets" },
  { "vtkDistanceRepresentation2D", "2D widgets" },
  { "vtkMagnifierRepresentation", "2D widgets" },
  { "vtkPointHandleRepresentation2D", "2D widgets" },
  { "vtkRectilinearWipeRepresentation", "2D widgets" },
  { "vtkSliderRepresentation2D", "2D widgets" },
  { "vtkTexturedButtonRepresentation2D", "2D widgets" },
};

const Kind* FindKindNotDrawn(vtkProp* prop)
{
  const auto found = std::find_if(std::begin(KindsNotDrawn), std::end(KindsNotDrawn),
    [prop](const Kind& kind) { return prop->IsA(kind.Class); });
  return found == std::end(KindsNotDrawn) ? nullptr : found;
}

// Its calls would go to OpenGL, and there is none here.
bool BelongsToOpenGL(vtkProp* prop)
{
  return std::string(prop->GetClassName()).rfind("vtkOpenGL", 0) == 0;
}
}

vtkStandardNewMacro(vtkLimnRenderer);

//------------------------------------------------------------------------------
vtkLimnRenderer::vtkLimnRenderer() = default;

//------------------------------------------------------------------------------
vtkLimnRenderer::~vtkLimnRenderer() = default;

//------------------------------------------------------------------------------
void vtkLimnRenderer::SetPostEffects(vtkLimnPostEffects* effects)
{
  if (this->PostEffects != effects)
  {
    this->PostEffects = effects;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLimnPostEffects* vtkLimnRenderer::GetPostEffects()
{
  return this->PostEffects;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLimnRenderer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->PostEffects)
  {
    time = std::max(time, this->PostEffects->GetMTime());
  }
  return this->FXAAOptions ? std::max(time, this->FXAAOptions->GetMTime()) : time;
}

//------------------------------------------------------------------------------
vtkCamera* vtkLimnRenderer::MakeCamera()
{
  vtkCamera* camera = vtkLimnCamera::New();
  this->InvokeEvent(vtkCommand::CreateCameraEvent, camera);
  return camera;
}

//------------------------------------------------------------------------------
vtkPropCollection* vtkLimnRenderer::GetPropsToPickFrom()
{
  return this->PickFromProps ? this->PickFromProps : this->Props;
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::DeviceRender()
{
  vtkLimnRenderWindow* window = vtkLimnRenderWindow::SafeDownCast(this->RenderWindow);
  if (!window)
  {
    this->WarnOnce(std::string("This renderer draws in a vtkLimnRenderWindow only, not in a ") +
                   this->RenderWindow->GetClassName() + ".");
    return;
  }
  if (window->GetFrame().IsEmpty())
  {
    return;
  }
  this->WarnOfUnusedSettings();
  this->UpdateCamera();
  if (window->GetErase() && this->Erase)
  {
    this->Clear();
  }
  this->UpdateLightGeometry();
  this->UpdateLights();
  this->UpdateGeometry();
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::Clear()
{
  if (vtkLimnRenderWindow* window = vtkLimnRenderWindow::SafeDownCast(this->RenderWindow))
  {
    limn::bridge::clearViewport(this, window->GetFrame());
  }
}

//------------------------------------------------------------------------------
int vtkLimnRenderer::UpdateCamera()
{
  vtkCamera* camera = this->GetActiveCameraAndResetIfCreated();
  // Cameras of other backends would call their graphics library.
  if (vtkLimnCamera::SafeDownCast(camera))
  {
    camera->Render(this);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkLimnRenderer::UpdateLights()
{
  int switchedOn = 0;
  vtkCollectionSimpleIterator iterator;
  this->Lights->InitTraversal(iterator);
  while (vtkLight* light = this->Lights->GetNextLight(iterator))
  {
    switchedOn += light->GetSwitch() ? 1 : 0;
  }
  if (switchedOn == 0 && this->AutomaticLightCreation)
  {
    this->CreateLight();
    switchedOn = 1;
  }
  return switchedOn;
}

//------------------------------------------------------------------------------
int vtkLimnRenderer::UpdateGeometry(vtkFrameBufferObjectBase*)
{
  this->NumberOfPropsRendered = 0;
  this->DropPropsThatAreNotDrawn();
  if (this->Selector)
  {
    this->NumberOfPropsRendered =
      this->Selector->Render(this, this->PropArray, this->PropArrayCount);
    return this->NumberOfPropsRendered;
  }
  limn::bridge::beginEffects(this);
  limn::bridge::collectSurfaces(this);
  this->UpdateOpaquePolygonalGeometry();
  this->UpdateTranslucentPolygonalGeometry();
  limn::bridge::applyEffects(this);
  this->RenderTime.Modified();
  return this->NumberOfPropsRendered;
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::DropPropsThatAreNotDrawn()
{
  vtkProp** const end = this->PropArray + this->PropArrayCount;
  vtkProp** const kept = std::stable_partition(this->PropArray, end,
    [this](vtkProp* prop)
    {
      // By far the most of what there is, and asking for each kind takes a microsecond.
      if (vtkLimnActor::SafeDownCast(prop))
      {
        return true;
      }
      const Kind* kind = FindKindNotDrawn(prop);
      if (kind)
      {
        this->WarnOnce(std::string("A ") + prop->GetClassName() +
                       " is not drawn: Limn's own window has no " + kind->Name +
                       " yet. Use an OpenGL window (LIMN_WINDOW=gl) for it.");
      }
      else if (BelongsToOpenGL(prop))
      {
        this->WarnOnce(std::string("A ") + prop->GetClassName() +
                       " is not drawn: it needs an OpenGL window. Use vtkLimnActor here; with "
                       "LIMN_WINDOW=cpu vtkActor::New() makes one.");
      }
      return !kind && !BelongsToOpenGL(prop);
    });
  this->PropArrayCount = static_cast<int>(kept - this->PropArray);
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::WarnOfUnusedSettings()
{
  if (this->Pass)
  {
    this->WarnOnce(std::string("The render pass ") + this->Pass->GetClassName() +
                   " is not used: Limn's own window has no render passes yet.");
  }
  if (this->TexturedBackground)
  {
    this->WarnOnce("The background is drawn without its texture: Limn's own window has no textures "
                   "yet.");
  }
  if (this->UseShadows || this->UseSSAO)
  {
    this->WarnOnce("Shadows and SSAO are not drawn: Limn's own window has none yet.");
  }
  if (this->UseImageBasedLighting)
  {
    this->WarnOnce("Image based lighting is not used: Limn's own window has none yet.");
  }
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::WarnOnce(const std::string& what)
{
  if (this->Warnings.insert(what).second)
  {
    vtkWarningMacro(<< what);
  }
}

//------------------------------------------------------------------------------
void vtkLimnRenderer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Warnings: " << this->Warnings.size() << "\n";
  os << indent << "PostEffects: " << this->PostEffects.Get() << "\n";
}
