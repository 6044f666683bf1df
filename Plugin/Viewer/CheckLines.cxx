// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckLines.h"

#include "Lengths.h"
#include "RenderSettings.h"
#include "UserError.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace limn::viewer
{
namespace
{

/// A headlight's terminator is the contour, and its shadows lie behind what casts them.
bool hasPlacedLight(const SceneSettings& scene)
{
  return std::any_of(scene.lights.begin(), scene.lights.end(),
    [](const LightSettings& light) { return light.kind != LightKind::Headlight; });
}

void checkHatchWidth(const SceneSettings& scene)
{
  const LineSettings& lines = scene.lines;
  if (!lines.hatchWidth)
  {
    return;
  }
  if (!hasHatchLines(scene))
  {
    throw UserError("--hatch-width needs --lines=hatch, --style=ink or --style=pencil");
  }
  const double stroke = pixelsOf(lines.width.value_or(kUsualStroke), scene);
  if (stroke * *lines.hatchWidth > kMaxStrokePixels)
  {
    std::ostringstream text;
    text << "--hatch-width=" << *lines.hatchWidth << " of strokes " << stroke
         << " pixels wide is more than " << kMaxStrokePixels << " pixels";
    throw UserError(text.str());
  }
}

void checkDash(const std::array<Length, 2>& dash, const SceneSettings& scene)
{
  const double pixels = pixelsOf(dash[0], scene) + pixelsOf(dash[1], scene);
  if (pixels < 0.5)
  {
    std::ostringstream text;
    text << "--stroke-dash=" << textOf(dash[0]) << "," << textOf(dash[1]) << " is " << pixels
         << " pixels; dash and gap have to be half a pixel together";
    throw UserError(text.str());
  }
}

/// Whether a length depends on the pixels an inch.
bool hasUnits(const SceneSettings& scene)
{
  const LineSettings& lines = scene.lines;
  const std::optional<Length> lengths[] = { lines.width, lines.taper, scene.material.hatchSpacing,
    scene.material.outlineWidth, scene.cues.halo };
  const auto hasUnit = [](const std::optional<Length>& length)
  { return length && length->unit != 0; };
  return std::any_of(std::begin(lengths), std::end(lengths), hasUnit) ||
         (lines.dash && std::any_of(lines.dash->begin(), lines.dash->end(), hasUnit));
}

} // namespace

bool hasHatchLines(const SceneSettings& scene)
{
  const std::vector<LineKind>& kinds = scene.lines.kinds;
  return std::find(kinds.begin(), kinds.end(), LineKind::Hatch) != kinds.end() ||
         scene.style == "ink" || scene.style == "pencil";
}

void checkLines(const SceneSettings& scene)
{
  const LineSettings& lines = scene.lines;
  const auto has = [&](LineKind kind)
  { return std::find(lines.kinds.begin(), lines.kinds.end(), kind) != lines.kinds.end(); };
  const std::pair<const char*, bool> options[] = { { "--stroke-width", lines.width.has_value() },
    { "--outer-width", lines.outerWidth.has_value() },
    { "--stroke-color", lines.color.has_value() },
    { "--stroke-opacity", lines.opacity.has_value() },
    { "--stroke-taper", lines.taper.has_value() }, { "--stroke-dash", lines.dash.has_value() },
    { "--hidden-lines", lines.hidden.has_value() } };
  for (const auto& [name, isGiven] : options)
  {
    if (isGiven && lines.kinds.empty() && scene.style.empty())
    {
      throw UserError(std::string(name) + " needs lines; add --lines=crease or another kind");
    }
  }
  const bool isOfLight = has(LineKind::Terminator) || has(LineKind::Shadow);
  if (lines.creaseAngleDegrees && !has(LineKind::Crease) && !has(LineKind::Contour) &&
      !has(LineKind::Hatch) && !isOfLight && scene.style.empty())
  {
    throw UserError("--crease-angle needs --lines=crease, contour, hatch, terminator or shadow");
  }
  if (lines.shortestCrease && !has(LineKind::Crease) && scene.style.empty())
  {
    throw UserError("--shortest-crease needs --lines=crease");
  }
  if (lines.ridgeThreshold && !has(LineKind::Ridge) && !has(LineKind::Valley))
  {
    throw UserError("--ridge-threshold needs --lines=ridge or --lines=valley");
  }
  if (lines.suggestiveThreshold && !has(LineKind::Suggestive))
  {
    throw UserError("--suggestive-threshold needs --lines=suggestive");
  }
  if (lines.lights && !isOfLight)
  {
    throw UserError("--line-lights needs --lines=terminator or --lines=shadow");
  }
  if (isOfLight && !hasPlacedLight(scene))
  {
    throw UserError(std::string("--lines=") + (has(LineKind::Shadow) ? "shadow" : "terminator") +
                    " needs a light beside the camera; add --light=directional:1,-1,-1:1,1,1");
  }
  if (lines.idArray && !has(LineKind::Ids) && !scene.material.outlineIds)
  {
    throw UserError("--ids-array needs --lines=ids or --outline-ids");
  }
  if (lines.width)
  {
    requireAtMost("--stroke-width", *lines.width, kMaxStrokePixels, scene);
  }
  if (lines.taper)
  {
    requireAtMost("--stroke-taper", *lines.taper, kMaxTaperPixels, scene);
  }
  checkHatchWidth(scene);
  if (lines.dash)
  {
    checkDash(*lines.dash, scene);
  }
  if (scene.pixelsPerInch && !hasUnits(scene) && scene.style != "print")
  {
    throw UserError("--dpi needs a length in pt or mm, as in --stroke-width=1pt, or --style=print");
  }
}

} // namespace limn::viewer
