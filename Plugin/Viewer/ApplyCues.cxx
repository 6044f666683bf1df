// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ApplyCues.h"

#include "vtkLimnProperty.h"

namespace limn::viewer
{

void applyCues(const CueSettings& cues, const Color& background, vtkLimnProperty& property)
{
  if (cues.eyeDome)
  {
    property.SetEyeDomeLighting(*cues.eyeDome > 0);
    property.SetEyeDomeStrength(*cues.eyeDome);
    property.SetEyeDomeRadius(cues.eyeDomeRadius.value_or(property.GetEyeDomeRadius()));
  }
  if (cues.unsharp)
  {
    const bool isBoth = cues.unsharpMode == UnsharpMode::Both;
    property.SetDepthUnsharp(*cues.unsharp == 0 ? vtkLimnProperty::DEPTH_UNSHARP_OFF
                             : isBoth           ? vtkLimnProperty::DEPTH_UNSHARP_BOTH
                                                : vtkLimnProperty::DEPTH_UNSHARP_DARKEN);
    property.SetDepthUnsharpStrength(*cues.unsharp);
    property.SetDepthUnsharpRadius(cues.unsharpRadius.value_or(property.GetDepthUnsharpRadius()));
  }
  if (cues.halo)
  {
    property.SetHaloWidth(cues.halo->value);
    property.SetHaloUnit(cues.halo->unit);
    property.SetHaloDepth(cues.haloDepth.value_or(property.GetHaloDepth()));
    property.SetHaloColor(cues.haloColor.value_or(background).data());
  }
}

} // namespace limn::viewer
