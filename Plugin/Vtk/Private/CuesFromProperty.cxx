// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CuesFromProperty.h"

#include "vtkLimnProperty.h"

#include <algorithm>
#include <cmath>
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

struct Bounded
{
  const char* name;
  double value;
  bool isRight;
  const char* range;
};

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

std::string unusableCueOf(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  if (!limn)
  {
    return {};
  }
  const bool isDome = limn->GetEyeDomeLighting();
  const bool isUnsharp = limn->GetDepthUnsharp() != vtkLimnProperty::DEPTH_UNSHARP_OFF;
  const auto isFrom = [](double value, double least, double most)
  { return value >= least && value <= most; };
  const auto isRadius = [](double value, double most) {
    return static_cast<float>(value) > 0 && static_cast<float>(value) <= static_cast<float>(most);
  };
  const double width = limn->GetHaloWidth();
  const double depth = limn->GetHaloDepth();
  const double* const color = limn->GetHaloColor();
  const bool isHalo = width > 0;
  const auto isColor = [&](int i) { return !isHalo || (std::isfinite(color[i]) && color[i] >= 0); };
  constexpr const char* kNotNegative = "a finite number, not negative";
  const Bounded all[] = {
    { "EyeDomeStrength", limn->GetEyeDomeStrength(),
      !isDome || isFrom(limn->GetEyeDomeStrength(), 0, kMaxCueStrength), "from 0 to 100" },
    { "EyeDomeRadius", limn->GetEyeDomeRadius(),
      !isDome || isRadius(limn->GetEyeDomeRadius(), kMaxEyeDomeRadius), "above 0, at most 0.02" },
    { "DepthUnsharpStrength", limn->GetDepthUnsharpStrength(),
      !isUnsharp || isFrom(limn->GetDepthUnsharpStrength(), 0, 1), "from 0 to 1" },
    { "DepthUnsharpRadius", limn->GetDepthUnsharpRadius(),
      !isUnsharp || isRadius(limn->GetDepthUnsharpRadius(), kMaxUnsharpRadius),
      "above 0, at most 0.1" },
    { "HaloWidth", width, std::isfinite(width) && width >= 0, kNotNegative },
    { "HaloDepth", depth, !isHalo || (std::isfinite(depth) && static_cast<float>(depth) > 0),
      "a finite number above 0" },
    { "HaloColor", color[0], isColor(0), kNotNegative },
    { "HaloColor", color[1], isColor(1), kNotNegative },
    { "HaloColor", color[2], isColor(2), kNotNegative },
  };
  for (const Bounded& one : all)
  {
    if (!one.isRight)
    {
      std::ostringstream text;
      text << one.name << " of its " << property->GetClassName() << " has the value " << one.value
           << "; it has to be " << one.range << ".";
      return text.str();
    }
  }
  return {};
}

} // namespace limn::bridge
