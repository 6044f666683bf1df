// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectOptions.h"

#include "ParseValue.h"
#include "UserError.h"

#include <algorithm>

namespace limn::viewer
{
namespace
{

using Text = const std::string&;

const Choices<AntiAliasing> kAntiAliasings = { { "none", AntiAliasing::None },
  { "fxaa", AntiAliasing::Fxaa } };
const Choices<ToneMapping> kToneMappings = { { "none", ToneMapping::None },
  { "reinhard", ToneMapping::Reinhard }, { "reinhard-extended", ToneMapping::ReinhardExtended },
  { "aces", ToneMapping::Aces } };

/// As the renderer bounds its colours: the largest half float.
constexpr double kBrightest = 65504;

[[noreturn]] void refuse(Text option, Text text, const std::string& what)
{
  throw UserError(option + "=" + text + what);
}

bool isFrom(double smallest, double number)
{
  return number >= smallest && number <= kBrightest;
}

double parseExposure(Text option, Text text)
{
  const std::string range = "from 0 to 65504";
  const double number = parseNumberOfAnySize(option, text, range);
  if (!isFrom(0, number))
  {
    refuse(option, text, " is not " + range);
  }
  return number;
}

double parseWhitePoint(Text option, Text text)
{
  const std::string range = "from 0.001 to 65504";
  const double number = parseNumberOfAnySize(option, text, range);
  if (!isFrom(0.001, number))
  {
    refuse(option, text, " is not " + range);
  }
  return number;
}

BloomSettings parseBloom(Text option, Text text)
{
  const std::vector<double> numbers = parseNumbers(option, text, 1, 2);
  BloomSettings bloom;
  bloom.strength = numbers.front();
  bloom.threshold = numbers.size() > 1 ? numbers[1] : bloom.threshold;
  if (!isFrom(0, bloom.strength) || !isFrom(0, bloom.threshold))
  {
    refuse(option, text, " has a value that is not from 0 to 65504");
  }
  return bloom;
}

DepthOfFieldSettings parseDepthOfField(Text option, Text text)
{
  const std::vector<double> numbers = parseNumbers(option, text, 2, 2);
  const DepthOfFieldSettings lens = { numbers[0], numbers[1] };
  if (lens.distance < 0 || lens.aperture <= 0)
  {
    refuse(option, text,
      " has a negative distance in focus or a lens whose diameter is not greater than 0");
  }
  return lens;
}

/// The first option given that OpenGL's windows do not serve, or "".
std::string optionOfLimnsWindow(const EffectSettings& effects)
{
  const std::pair<bool, const char*> options[] = {
    { effects.exposure != 1, "--exposure" },
    { effects.depthOfField.has_value(), "--depth-of-field" },
    { effects.bloom.strength > 0, "--bloom" },
    { effects.toneMapping != ToneMapping::None, "--tone-mapping" },
  };
  const auto* const found = std::find_if(
    std::begin(options), std::end(options), [](const auto& option) { return option.first; });
  return found == std::end(options) ? "" : found->second;
}

} // namespace

void addEffectOptions(OptionList& options, EffectSettings& effects)
{
  options.startGroup("Effects on the finished picture, in this order");
  options.add("--exposure", "e", "factor of all colours, before they are clamped (1)",
    [&](Text option, Text text) { effects.exposure = parseExposure(option, text); });
  options.add("--depth-of-field", "distance,diameter",
    "in focus (0: the focal point's), and of the lens, in\nworld units (no lens)",
    [&](Text option, Text text) { effects.depthOfField = parseDepthOfField(option, text); });
  options.add("--bloom", "strength[,threshold]",
    "so much of the light above the threshold spills\nover (0,1)",
    [&](Text option, Text text) { effects.bloom = parseBloom(option, text); });
  options.add("--tone-mapping", "name", "none, reinhard, reinhard-extended, aces (none)",
    [&](Text option, Text text)
    { effects.toneMapping = parseChoice(option, text, kToneMappings); });
  options.add("--white-point", "w", "what reinhard-extended makes white (4)",
    [&](Text option, Text text) { effects.whitePoint = parseWhitePoint(option, text); });
  options.add("--anti-aliasing", "name", "none, fxaa; --samples is another way (none)",
    [&](Text option, Text text)
    { effects.antiAliasing = parseChoice(option, text, kAntiAliasings); });
}

void checkEffects(const RenderSettings& settings)
{
  const EffectSettings& effects = settings.effects;
  if (effects.whitePoint && effects.toneMapping != ToneMapping::ReinhardExtended)
  {
    throw UserError("--white-point needs --tone-mapping=reinhard-extended");
  }
  if (effects.depthOfField && settings.scene.camera.orthographic)
  {
    throw UserError("--depth-of-field and --camera-orthographic exclude each other: parallel "
                    "projection has no lens; give one");
  }
  const std::string option = optionOfLimnsWindow(effects);
  if (settings.window == Window::Gl && !option.empty())
  {
    throw UserError(option + " needs --window=cpu");
  }
}

} // namespace limn::viewer
