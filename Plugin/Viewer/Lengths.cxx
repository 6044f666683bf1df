// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lengths.h"

#include "RenderSettings.h"
#include "UserError.h"

#include <sstream>

namespace limn::viewer
{
namespace
{

double pixelsPerInchOf(const SceneSettings& scene)
{
  return scene.pixelsPerInch.value_or(72);
}

} // namespace

double pixelsOf(const Length& length, const SceneSettings& scene)
{
  if (length.unit == 0)
  {
    return length.value;
  }
  const double unitsPerInch[] = { 1, 72, 25.4 }; // in the order of StrokeUnits
  return length.value * pixelsPerInchOf(scene) / unitsPerInch[length.unit];
}

void requireAtMost(
  const std::string& option, const Length& length, double mostPixels, const SceneSettings& scene)
{
  const double pixels = pixelsOf(length, scene);
  if (pixels > mostPixels)
  {
    const char* const units[] = { "px", "pt", "mm" };
    std::ostringstream text;
    text << option << "=" << length.value << units[length.unit] << " is " << pixels << " pixels at "
         << pixelsPerInchOf(scene) << " dpi; at most " << mostPixels << " are possible";
    throw UserError(text.str());
  }
}

} // namespace limn::viewer
