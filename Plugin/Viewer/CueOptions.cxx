// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CueOptions.h"

#include "Lengths.h"
#include "ParseValue.h"
#include "UserError.h"

#include <sstream>
#include <string>
#include <utility>

namespace limn::viewer
{
namespace
{

using Text = const std::string&;

const Choices<UnsharpMode> kUnsharpModes = { { "darken", UnsharpMode::Darken },
  { "both", UnsharpMode::Both } };

/// A number from 0 to `most`, without 0 or with it.
template <typename Target>
OptionList::Reader upTo(Target& target, double most, const char* words, bool isZeroAllowed)
{
  return [&target, most, words, isZeroAllowed](Text option, Text text)
  {
    const double number = parseNumberOfAnySize(option, text, words);
    if (number < 0 || number > most || (number == 0 && !isZeroAllowed))
    {
      throw UserError(option + "=" + text + " is not " + words);
    }
    if (!isZeroAllowed)
    {
      refuseTiny(option, text, number);
    }
    target = number;
  };
}

} // namespace

void addCueOptions(OptionList& options, CueSettings& cues)
{
  options.startGroup("Depth cues, of surfaces and of no line");
  options.add("--edl", "strength",
    "eye-dome lighting: darker where something near in\nthe picture lies before it, 0 to 100 (0)",
    upTo(cues.eyeDome, 100, "from 0 to 100", true));
  options.add("--edl-radius", "share", "of the picture's diagonal, up to 0.02 (0.001)",
    upTo(cues.eyeDomeRadius, 0.02, "above 0, at most 0.02", false));
  options.add("--depth-unsharp", "strength",
    "darker where it lies behind the mean of what is\naround, 0 to 1 (0)",
    upTo(cues.unsharp, 1, "from 0 to 1", true));
  options.add("--depth-unsharp-mode", "name",
    "darken, both (lighter, too, where it lies before\nthat) (darken)",
    [&cues](Text option, Text text)
    { cues.unsharpMode = parseChoice(option, text, kUnsharpModes); });
  options.add("--depth-unsharp-radius", "share",
    "of the picture's diagonal, up to 0.1: the standard\ndeviation of the mean (0.02)",
    upTo(cues.unsharpRadius, 0.1, "above 0, at most 0.1", false));
  options.add("--halo", "width",
    "a gap in what lies behind a border: as 3, 3px, 2pt or\n0.7mm; up to 64 pixels (none)",
    [&cues](Text option, Text text) { cues.halo = parseWidth(option, text, kMaxHaloPixels); });
  options.add("--halo-depth", "widths",
    "how far behind is the gap as wide as that; narrower\nwhere it is less (4)",
    [&cues](Text option, Text text) { cues.haloDepth = parsePositive(option, text); });
  options.add("--halo-color", "r,g,b", "(the background's)",
    [&cues](Text option, Text text) { cues.haloColor = parseColor(option, text); });
}

void checkCues(const SceneSettings& scene)
{
  const CueSettings& cues = scene.cues;
  const struct
  {
    const char *option, *needed;
    bool isGiven, isThere;
  } needs[] = {
    { "--edl-radius", "--edl", cues.eyeDomeRadius.has_value(), cues.eyeDome.has_value() },
    { "--depth-unsharp-mode", "--depth-unsharp", cues.unsharpMode.has_value(),
      cues.unsharp.has_value() },
    { "--depth-unsharp-radius", "--depth-unsharp", cues.unsharpRadius.has_value(),
      cues.unsharp.has_value() },
    { "--halo-depth", "--halo", cues.haloDepth.has_value(), cues.halo.has_value() },
    { "--halo-color", "--halo", cues.haloColor.has_value(), cues.halo.has_value() },
  };
  for (const auto& one : needs)
  {
    if (one.isGiven && !one.isThere)
    {
      throw UserError(std::string(one.option) + " needs " + one.needed);
    }
  }
  if (scene.material.opacity < 1)
  {
    const std::pair<const char*, bool> given[] = { { "--edl", cues.eyeDome.has_value() },
      { "--depth-unsharp", cues.unsharp.has_value() }, { "--halo", cues.halo.has_value() } };
    for (const auto& [option, isGiven] : given)
    {
      if (isGiven)
      {
        throw UserError(std::string(option) + " needs an opaque surface; leave out --opacity");
      }
    }
  }
  if (cues.halo)
  {
    requireAtMost("--halo", *cues.halo, kMaxHaloPixels, scene);
  }
}

} // namespace limn::viewer
