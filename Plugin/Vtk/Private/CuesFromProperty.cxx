// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CuesFromProperty.h"

#include "vtkLimnProperty.h"

#include <sstream>

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

/// Leaves out one that is too wide.
Status haloOf(vtkLimnProperty* property, double pixelsPerInch, Halo& halo)
{
  const double width = haloPixels(property, pixelsPerInch);
  if (width > kMaxHaloWidth)
  {
    std::ostringstream text;
    text << "HaloWidth of its vtkLimnProperty is " << width << " pixels; it has to be from 0 to "
         << kMaxHaloWidth << ".";
    return { Error::kNotFinite, text.str() };
  }
  halo.width = static_cast<float>(width);
  halo.depth = static_cast<float>(property->GetHaloDepth());
  const double* const color = property->GetHaloColor();
  halo.color = vec3Cast<float>(Vec3d{ color[0], color[1], color[2] });
  return {};
}

} // namespace

Status cuesOf(vtkProperty* property, double pixelsPerInch, DepthCues& cues)
{
  cues = {};
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (!limn)
  {
    return {};
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
  return limn->GetHaloWidth() > 0 ? haloOf(limn, pixelsPerInch, cues.halo) : Status{};
}

} // namespace limn::bridge
