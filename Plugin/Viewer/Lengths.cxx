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

[[noreturn]] void refuse(const std::string& option, const Length& length,
  const SceneSettings& scene, const std::string& need)
{
  std::ostringstream text;
  text << option << "=" << textOf(length) << " is " << pixelsOf(length, scene) << " pixels at "
       << pixelsPerInchOf(scene) << " dpi; " << need;
  throw UserError(text.str());
}

} // namespace

std::string textOf(const Length& length)
{
  const char* const units[] = { "px", "pt", "mm" };
  std::ostringstream text;
  text << length.value << units[length.unit];
  return text.str();
}

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
  if (pixelsOf(length, scene) > mostPixels)
  {
    std::ostringstream need;
    need << "at most " << mostPixels << " are possible";
    refuse(option, length, scene, need.str());
  }
}

void requireAtLeast(
  const std::string& option, const Length& length, double leastPixels, const SceneSettings& scene)
{
  if (length.value != 0 && pixelsOf(length, scene) < leastPixels)
  {
    std::ostringstream need;
    need << "at least " << leastPixels << " are needed, or 0";
    refuse(option, length, scene, need.str());
  }
}

} // namespace limn::viewer
