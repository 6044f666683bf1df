// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewportEffects.h"

#include "ClearViewport.h"
#include "EngineState.h"
#include "SceneFromRenderer.h"

#include "vtkLimnPostEffects.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkCamera.h"
#include "vtkFXAAOptions.h"

namespace limn::bridge
{
namespace
{

Fxaa fxaaOf(vtkLimnRenderer* renderer)
{
  Fxaa fxaa;
  fxaa.enabled = renderer->GetUseFXAA();
  if (vtkFXAAOptions* const options = renderer->GetFXAAOptions())
  {
    fxaa.relativeContrastThreshold = options->GetRelativeContrastThreshold();
    fxaa.hardContrastThreshold = options->GetHardContrastThreshold();
    fxaa.subpixelBlendLimit = options->GetSubpixelBlendLimit();
    fxaa.subpixelContrastThreshold = options->GetSubpixelContrastThreshold();
    fxaa.highQualityEndpoints = options->GetUseHighQualityEndpoints();
    // An edge is no longer than the picture.
    fxaa.endpointSearchIterations = std::min(options->GetEndpointSearchIterations(), kMaxImageSide);
    if (fxaa.enabled && options->GetDebugOptionValue() != vtkFXAAOptions::FXAA_NO_DEBUG)
    {
      renderer->WarnOnce("The DebugOptionValue of vtkFXAAOptions is not used: Limn's own window "
                         "has no such pictures.");
    }
  }
  return fxaa;
}

DepthOfField lensOf(vtkLimnRenderer* renderer, vtkLimnPostEffects* settings)
{
  DepthOfField lens;
  if (!settings->GetDepthOfField())
  {
    return lens;
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    renderer->WarnOnce("The picture is drawn without depth of field: parallel projection has no "
                       "lens. Call ParallelProjectionOff() on the camera for it.");
    return lens;
  }
  const double distance = camera->GetFocalDistance();
  lens.aperture = static_cast<float>(camera->GetFocalDisk());
  lens.focusDistance = static_cast<float>(distance > 0 ? distance : camera->GetDistance());
  lens.maxRadius = settings->GetMaximumBlurRadius();
  return lens;
}

PostEffects effectsOf(vtkLimnRenderer* renderer)
{
  PostEffects effects;
  effects.fxaa = fxaaOf(renderer);
  vtkLimnPostEffects* const settings = renderer->GetPostEffects();
  if (!settings)
  {
    return effects;
  }
  effects.exposure = static_cast<float>(settings->GetExposure());
  effects.depthOfField = lensOf(renderer, settings);
  effects.bloom = { static_cast<float>(settings->GetBloomStrength()),
    static_cast<float>(settings->GetBloomThreshold()), settings->GetBloomLevels() };
  effects.toneMapping = static_cast<ToneMapping>(settings->GetToneMapping());
  effects.whitePoint = static_cast<float>(settings->GetWhitePoint());
  return effects;
}

/// The viewport's pixels, cleared already.
FrameView viewOf(vtkLimnRenderer* renderer)
{
  auto& frame = vtkLimnRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetFrame();
  const auto viewport = viewportOf(renderer, frame);
  if (viewport.IsEmpty())
  {
    return {};
  }
  frame.GetColor();
  return frame.View(viewport);
}

} // namespace

void ViewportEffects::begin(vtkLimnRenderer* renderer)
{
  effects_ = effectsOf(renderer);
  radiance_ = {};
  if (!effects_.needRadiance())
  {
    return;
  }
  const FrameView view = viewOf(renderer);
  if (view.color)
  {
    radiance_ = planes_.radianceOf(view, EngineState::instance().options.threads);
  }
}

void ViewportEffects::apply(vtkLimnRenderer* renderer)
{
  if (!effects_.areOn())
  {
    return;
  }
  FrameView view = viewOf(renderer);
  if (!view.color)
  {
    return;
  }
  view.radiance = radiance_;
  const Status status =
    applyEffects(effects_, cameraOf(renderer), view, planes_, EngineState::instance().options);
  if (!status.ok())
  {
    vtkErrorWithObjectMacro(renderer, "Drawn without post effects: " << status.message);
  }
}

} // namespace limn::bridge
