// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckIllustration.h"

#include "CheckLines.h"
#include "Lengths.h"
#include "RenderSettings.h"
#include "UserError.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

namespace limn::viewer
{
namespace
{

/// Of cool and warm.
bool isScale(Tone tone)
{
  return tone != Tone::None && tone != Tone::Toon && tone != Tone::Ramp && tone != Tone::MatCap &&
         tone != Tone::Hatching && tone != Tone::Exaggerated;
}

void checkRamp(const MaterialSettings& material)
{
  const bool isByDepth = material.rampBy.value_or(RampBy::Depth) == RampBy::Depth;
  if (material.rampExponent && isByDepth)
  {
    throw UserError("--toon-ramp-exponent needs --toon-ramp-by=silhouette or highlight");
  }
  if (material.rampRange && !isByDepth)
  {
    throw UserError("--toon-ramp-range needs --toon-ramp-by=depth");
  }
}

void checkToneOverData(const MaterialSettings& material)
{
  const auto over = material.toneOverData.value_or(ToneOverData::Classic);
  if (material.toneOverData && !isScale(material.tone) && material.tone != Tone::Exaggerated)
  {
    throw UserError("--tone-over-data needs --tone=metal, exaggerated or one of gooch");
  }
  if (material.undertone && over != ToneOverData::Undertone)
  {
    throw UserError("--undertone needs --tone-over-data=undertone");
  }
  if (material.legendSafeRange && over != ToneOverData::LegendSafe)
  {
    throw UserError("--legend-safe-range needs --tone-over-data=legend-safe");
  }
}

/// Throws for the first option that is given.
void refuseGiven(
  std::initializer_list<std::pair<const char*, bool>> options, const std::string& needs)
{
  for (const auto& [option, isGiven] : options)
  {
    if (isGiven)
    {
      throw UserError(option + (" needs " + needs));
    }
  }
}

void checkHatching(const MaterialSettings& material, bool hasLines)
{
  if (material.tone == Tone::Hatching)
  {
    return;
  }
  refuseGiven({ { "--hatch-ink", material.hatchInk.has_value() },
                { "--hatch-paper", material.hatchPaper.has_value() },
                { "--hatch-on", material.hatchPlace.has_value() } },
    "--tone=hatching");
  if (!hasLines)
  {
    refuseGiven({ { "--hatch-spacing", material.hatchSpacing.has_value() },
                  { "--hatch-darkest", material.hatchDarkest.has_value() } },
      "--tone=hatching, --lines=hatch, --style=ink or --style=pencil");
  }
}

void checkExaggeration(const MaterialSettings& material)
{
  if (material.tone == Tone::Exaggerated)
  {
    return;
  }
  const ExaggerationSettings& settings = material.exaggeration;
  refuseGiven({ { "--exaggeration-contrast", settings.contrast.has_value() },
                { "--exaggeration-exponent", settings.exponent.has_value() },
                { "--exaggeration-base", settings.base.has_value() },
                { "--exaggeration-levels", settings.levels.has_value() },
                { "--exaggeration-scale", settings.scale.has_value() } },
    "--tone=exaggerated");
}

void checkOutline(const SceneSettings& scene)
{
  const MaterialSettings& material = scene.material;
  if (material.outline == Outline::None)
  {
    refuseGiven({ { "--outline-color", material.outlineColor.has_value() },
                  { "--outline-width", material.outlineWidth.has_value() },
                  { "--outline-opacity", material.outlineOpacity.has_value() } },
      "--outline=normal, hull or image");
  }
  if (material.outlineWidth)
  {
    requireAtLeast("--outline-width", *material.outlineWidth, kMinOutlinePixels, scene);
    requireAtMost("--outline-width", *material.outlineWidth, kMaxOutlinePixels, scene);
  }
  if (material.outline == Outline::Image && material.opacity < 1)
  {
    throw UserError("--outline=image needs an opaque surface; leave out --opacity, or take "
                    "--outline=hull or --lines=contour");
  }
  if (material.outline != Outline::Image)
  {
    refuseGiven({ { "--outline-detector", material.outlineDetector.has_value() },
                  { "--outline-tolerance", material.outlineTolerance.has_value() },
                  { "--outline-crease-angle", material.outlineCreaseDegrees.has_value() },
                  { "--outline-crease-detector", material.outlineCreases.has_value() },
                  { "--outline-ids", material.outlineIds } },
      "--outline=image");
  }
}

} // namespace

void takePictures(MaterialSettings& material)
{
  const bool isRamp = !material.toonRamp.empty();
  const bool isMatCap = !material.matCap.empty();
  if ((isRamp || isMatCap) && material.tone != Tone::None)
  {
    throw UserError(std::string(isRamp ? "--toon-ramp" : "--matcap") +
                    " and --tone exclude each other; give one");
  }
  if (isRamp && isMatCap)
  {
    throw UserError("--toon-ramp and --matcap exclude each other; give one");
  }
  if (!isRamp && (material.rampBy || material.rampExponent || material.rampRange))
  {
    throw UserError(std::string(material.rampBy         ? "--toon-ramp-by"
                                : material.rampExponent ? "--toon-ramp-exponent"
                                                        : "--toon-ramp-range") +
                    " needs --toon-ramp=FILE");
  }
  material.tone = isRamp ? Tone::Ramp : isMatCap ? Tone::MatCap : material.tone;
}

void checkStyle(const SceneSettings& scene)
{
  const MaterialSettings& material = scene.material;
  const std::pair<const char*, bool> options[] = {
    { "--tone", material.tone != Tone::None },
    { "--outline", material.outline != Outline::None },
    { "--lines", !scene.lines.kinds.empty() },
    { "--reflection", material.reflection.has_value() },
    { "--model", material.localModel.has_value() },
    { "--cool", material.cool.has_value() },
    { "--warm", material.warm.has_value() },
    { "--toon-steps", material.toonSteps.has_value() },
    { "--tone-light", material.toneLight.has_value() },
    { "--tone-over-data", material.toneOverData.has_value() },
    { "--outline-color", material.outlineColor.has_value() },
    { "--outline-width", material.outlineWidth.has_value() },
    { "--outline-opacity", material.outlineOpacity.has_value() },
    { "--fresnel", material.fresnel },
    { "--rim", material.rim.has_value() },
  };
  for (const auto& [option, isGiven] : options)
  {
    if (isGiven && !scene.style.empty())
    {
      throw UserError(std::string("--style and ") + option + " exclude each other; give one");
    }
  }
}

void checkShownByStyle(const SceneSettings& scene)
{
  if (scene.style.empty())
  {
    return;
  }
  const auto isOneOf = [&scene](std::initializer_list<const char*> names)
  { return std::find(names.begin(), names.end(), scene.style) != names.end(); };
  const MaterialSettings& material = scene.material;
  const MaterialSettings usual;
  const bool hasLight = isOneOf({ "plain" });
  const bool hasHighlight = isOneOf({ "plain", "technical", "gooch" });
  const bool hasColor = !isOneOf({ "blueprint", "pencil", "ink", "metal", "print" });
  const bool hasShades = !isOneOf({ "blueprint", "ink" });
  const struct
  {
    const char* option;
    bool isGiven, isShown;
  } options[] = {
    { "--color", material.color.has_value(), hasColor },
    { "--diffuse", material.diffuse.has_value(), hasColor },
    { "--procedural", scene.texture.procedural != Procedural::None, hasColor },
    { "--coloring-array", !scene.coloring.array.empty(), hasColor },
    { "--specular", material.specular != usual.specular, hasHighlight },
    { "--specular-power", material.specularPower != usual.specularPower, hasHighlight },
    { "--shading", material.shading != usual.shading, hasShades },
    { "--normals", material.normals.has_value(), hasShades || isOneOf({ "ink" }) },
    { "--light", !scene.lights.empty(), hasLight },
    { "--ambient", material.ambient.has_value(), hasLight },
    { "--shortest-crease", scene.lines.shortestCrease.has_value(),
      !isOneOf({ "plain", "gooch", "anatomy", "xray" }) },
    { "--ambient-light", scene.ambientLight != Color{ 0, 0, 0 }, false },
  };
  for (const auto& [option, isGiven, isShown] : options)
  {
    if (isGiven && !isShown)
    {
      throw UserError("--style=" + scene.style + " does not show " + option + "; leave it out");
    }
  }
}

void checkIllustration(const SceneSettings& scene)
{
  const MaterialSettings& material = scene.material;
  checkRamp(material);
  checkToneOverData(material);
  const bool hasHatch = hasHatchLines(scene);
  checkHatching(material, hasHatch);
  checkExaggeration(material);
  if (!isScale(material.tone) && (material.cool || material.warm))
  {
    throw UserError(std::string(material.cool ? "--cool" : "--warm") +
                    " needs a tone; add --tone=gooch or --tone=gooch-chapter");
  }
  const bool isExaggerated = material.tone == Tone::Exaggerated;
  if (material.toonSteps && !isScale(material.tone) && material.tone != Tone::Toon &&
      !isExaggerated)
  {
    throw UserError("--toon-steps needs --tone=toon, metal, exaggerated or one of gooch");
  }
  const bool hatches = material.tone == Tone::Hatching || hasHatch;
  if (material.toneLight && !isScale(material.tone) && material.tone != Tone::Ramp && !hatches &&
      !isExaggerated)
  {
    throw UserError("--tone-light needs --tone=gooch, hatching or exaggerated, --toon-ramp=FILE or "
                    "--lines=hatch");
  }
  checkOutline(scene);
}

} // namespace limn::viewer
