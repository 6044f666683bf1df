// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "UserError.h"

#include <gtest/gtest.h>

namespace limn::viewer
{
namespace
{

using Words = std::vector<std::string>;

EffectSettings effectsOf(const Words& options)
{
  Words arguments = { "render", "a.obj", "--output=a.png" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return std::get<RenderRequest>(parseArguments(arguments)).settings.effects;
}

/// The message of the error, or "" if there is none.
std::string errorOf(const Words& options)
{
  try
  {
    effectsOf(options);
  }
  catch (const UserError& error)
  {
    return error.what();
  }
  return "";
}

TEST(EffectOptions, DefaultsChangeNothing)
{
  const EffectSettings effects = effectsOf({});
  EXPECT_EQ(effects.exposure, 1);
  EXPECT_FALSE(effects.depthOfField);
  EXPECT_EQ(effects.bloom.strength, 0);
  EXPECT_EQ(effects.toneMapping, ToneMapping::None);
  EXPECT_EQ(effects.antiAliasing, AntiAliasing::None);
}

TEST(EffectOptions, AreRead)
{
  const EffectSettings effects =
    effectsOf({ "--exposure=0.5", "--depth-of-field=3.5,0.25", "--bloom=0.75,2",
      "--tone-mapping=reinhard-extended", "--white-point=6", "--anti-aliasing=fxaa" });
  EXPECT_EQ(effects.exposure, 0.5);
  ASSERT_TRUE(effects.depthOfField);
  EXPECT_EQ(effects.depthOfField->distance, 3.5);
  EXPECT_EQ(effects.depthOfField->aperture, 0.25);
  EXPECT_EQ(effects.bloom.strength, 0.75);
  EXPECT_EQ(effects.bloom.threshold, 2);
  EXPECT_EQ(effects.toneMapping, ToneMapping::ReinhardExtended);
  EXPECT_EQ(effects.whitePoint, 6);
  EXPECT_EQ(effects.antiAliasing, AntiAliasing::Fxaa);
  EXPECT_EQ(effectsOf({ "--bloom=0.5" }).bloom.threshold, 1);
  EXPECT_EQ(effectsOf({ "--depth-of-field=0,1" }).depthOfField->distance, 0);
  EXPECT_EQ(effectsOf({ "--tone-mapping=reinhard" }).toneMapping, ToneMapping::Reinhard);
  EXPECT_EQ(effectsOf({ "--tone-mapping=aces" }).toneMapping, ToneMapping::Aces);
}

class BadEffect : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BadEffect, IsRefusedAndQuoted)
{
  const std::string option = GetParam();
  EXPECT_NE(errorOf({ option }).find(option), std::string::npos) << errorOf({ option });
}

INSTANTIATE_TEST_SUITE_P(EffectOptions, BadEffect,
  ::testing::Values("--exposure=-1", "--exposure=nan", "--exposure=70000", "--exposure=bright",
    "--bloom=-0.5", "--bloom=nan", "--bloom=1,-1", "--bloom=1,nan", "--bloom=1,2,3", "--bloom=1,",
    "--depth-of-field=5", "--depth-of-field=-1,1", "--depth-of-field=5,0",
    "--depth-of-field=5,-0.1", "--depth-of-field=nan,1", "--depth-of-field=5,inf",
    "--depth-of-field=1,2,3", "--tone-mapping=filmic", "--white-point=0", "--white-point=nan",
    "--anti-aliasing=ssaa"));

TEST(EffectOptions, NeedOrExcludeEachOther)
{
  EXPECT_EQ(errorOf({ "--white-point=2" }), "--white-point needs --tone-mapping=reinhard-extended");
  EXPECT_NE(errorOf({ "--depth-of-field=1,1", "--camera-orthographic" }).find("no lens"),
    std::string::npos);
  for (const std::string option :
    { "--exposure=2", "--bloom=1", "--tone-mapping=aces", "--depth-of-field=1,1" })
  {
    EXPECT_NE(errorOf({ option, "--window=gl" }).find("needs --window=cpu"), std::string::npos)
      << option;
  }
  EXPECT_EQ(errorOf({ "--anti-aliasing=fxaa", "--window=gl" }), "");
}

TEST(EffectOptions, StandInTheHelp)
{
  const auto request = parseArguments({ "help", "render" });
  const std::string& text = std::get<HelpRequest>(request).text;
  for (const std::string option : { "--exposure", "--depth-of-field", "--bloom", "--tone-mapping",
         "--white-point", "--anti-aliasing" })
  {
    EXPECT_NE(text.find("  " + option + " "), std::string::npos) << option;
  }
}

} // namespace
} // namespace limn::viewer
