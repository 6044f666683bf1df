// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CuesFromProperty.h"

#include "vtkLimnProperty.h"

#include <algorithm>

namespace limn::bridge
{
namespace
{

double haloPixels(vtkLimnProperty* property, double pixelsPerInch)
{
  switch (property->GetHaloUnit())
  {
    case vtkLimnProperty::STROKE_POINTS:
      return property->GetHaloWidth() * pixelsPerInch / 72;
    case vtkLimnProperty::STROKE_MILLIMETERS:
      return property->GetHaloWidth() * pixelsPerInch / 25.4;
    default:
      return property->GetHaloWidth();
  }
}

} // namespace

DepthCues cuesOf(vtkProperty* property, double pixelsPerInch)
{
  DepthCues cues;
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (!limn)
  {
    return cues;
  }
  if (limn->GetEyeDomeLighting())
  {
    cues.eyeDome.strength = static_cast<float>(limn->GetEyeDomeStrength());
    cues.eyeDome.radius = static_cast<float>(limn->GetEyeDomeRadius());
  }
  if (limn->GetDepthUnsharp() != vtkLimnProperty::DEPTH_UNSHARP_OFF)
  {
    cues.unsharp.strength = static_cast<float>(limn->GetDepthUnsharpStrength());
    cues.unsharp.radius = static_cast<float>(limn->GetDepthUnsharpRadius());
    cues.unsharp.lightens = limn->GetDepthUnsharp() == vtkLimnProperty::DEPTH_UNSHARP_BOTH;
  }
  if (limn->GetHaloWidth() > 0)
  {
    const double width = haloPixels(limn, pixelsPerInch);
    cues.halo.width = static_cast<float>(std::min(width, double{ kMaxHaloWidth }));
    cues.halo.depth = static_cast<float>(limn->GetHaloDepth());
    const double* const color = limn->GetHaloColor();
    cues.halo.color = vec3Cast<float>(Vec3d{ color[0], color[1], color[2] });
  }
  return cues;
}

} // namespace limn::bridge
