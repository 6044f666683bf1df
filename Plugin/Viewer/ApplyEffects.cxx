// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ApplyEffects.h"

#include "vtkLimnPostEffects.h"
#include "vtkLimnRenderer.h"

#include <vtkCamera.h>
#include <vtkNew.h>

namespace limn::viewer
{
namespace
{

int toneMappingOf(ToneMapping toneMapping)
{
  switch (toneMapping)
  {
    case ToneMapping::Reinhard:
      return vtkLimnPostEffects::TONE_MAPPING_REINHARD;
    case ToneMapping::ReinhardExtended:
      return vtkLimnPostEffects::TONE_MAPPING_REINHARD_EXTENDED;
    case ToneMapping::Aces:
      return vtkLimnPostEffects::TONE_MAPPING_ACES;
    case ToneMapping::None:
      break;
  }
  return vtkLimnPostEffects::TONE_MAPPING_NONE;
}

} // namespace

void applyEffects(const EffectSettings& settings, vtkRenderer& renderer)
{
  renderer.SetUseFXAA(settings.antiAliasing == AntiAliasing::Fxaa);
  vtkLimnRenderer* const ours = vtkLimnRenderer::SafeDownCast(&renderer);
  if (!ours)
  {
    return;
  }
  vtkNew<vtkLimnPostEffects> effects;
  effects->SetExposure(settings.exposure);
  effects->SetBloomStrength(settings.bloom.strength);
  effects->SetBloomThreshold(settings.bloom.threshold);
  effects->SetToneMapping(toneMappingOf(settings.toneMapping));
  effects->SetWhitePoint(settings.whitePoint.value_or(effects->GetWhitePoint()));
  if (settings.depthOfField)
  {
    effects->DepthOfFieldOn();
    renderer.GetActiveCamera()->SetFocalDistance(settings.depthOfField->distance);
    renderer.GetActiveCamera()->SetFocalDisk(settings.depthOfField->aperture);
  }
  ours->SetPostEffects(effects);
}

} // namespace limn::viewer
