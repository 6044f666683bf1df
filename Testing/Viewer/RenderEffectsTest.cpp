// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The effects of `limn render`, each in a picture.
#include "Program.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace limn::testing
{
namespace
{

using Words = std::vector<std::string>;

class RenderEffects : public ::testing::Test
{
protected:
  std::string draw(const std::string& mesh, const Words& options, const Environment& environment)
  {
    Words arguments = { "render", mesh, "--resolution=200,120", "--output=" + output_ };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runLimn(arguments, environment);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return bytesOf(output_);
  }
  std::string drawTeapot(const Words& options, const Environment& environment = {})
  {
    return draw(meshFile("teapot.obj"), options, environment);
  }

  /// How a picture full of one surface of k_d 0.5 under a light of 4 differs from one of a colour.
  std::string differenceFrom(const std::string& color, const std::string& effect)
  {
    const std::string wall =
      folder_.write("wall.obj", "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n");
    const Words place = { wall, "--resolution=20,10", "--camera-orthographic",
      "--camera-parallel-scale=1", "--reflection=lambert", "--specular=0,0,0" };
    drawWall(place, "wall.png",
      { "--color=0.5,0.5,0.5", "--light=directional:0,0,-1:4,4,4", "--camera-position=0,0,3",
        effect });
    drawWall(place, "color.png",
      { "--background-color=" + color, "--camera-position=0,0,-3", "--camera-focal-point=0,0,-9" });
    return runLimn({ "compare", folder_.file("wall.png"), folder_.file("color.png") }).out;
  }

  Folder folder_;
  std::string output_ = folder_.file("out.png");

private:
  void drawWall(const Words& place, const std::string& picture, const Words& options)
  {
    Words arguments = { "render", "--output=" + folder_.file(picture) };
    arguments.insert(arguments.end(), place.begin(), place.end());
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runLimn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
};

const char* const kSame = "0 of 200 pixels differ; largest difference 0, mean 0\n";

TEST_F(RenderEffects, AreTheirFormulas)
{
  // 0.5 times 4 is 2.
  EXPECT_EQ(differenceFrom("1,1,1", "--tone-mapping=none"), kSame);
  EXPECT_EQ(differenceFrom("0.5,0.5,0.5", "--exposure=0.25"), kSame);
  EXPECT_EQ(differenceFrom("0.6666667,0.6666667,0.6666667", "--tone-mapping=reinhard"), kSame);
  EXPECT_EQ(differenceFrom("0.75,0.75,0.75", "--tone-mapping=reinhard-extended"), kSame);
  EXPECT_EQ(differenceFrom("0.9148551,0.9148551,0.9148551", "--tone-mapping=aces"), kSame);
}

TEST_F(RenderEffects, EachIsAPictureOfItsOwn)
{
  const std::string lit = "--light=directional:1,-1,-1:4,4,4";
  const std::vector<Words> looks = {
    {},
    { "--exposure=0.5" },
    { "--bloom=0.5" },
    { "--bloom=0.9" },
    { "--bloom=0.5,2" },
    { "--tone-mapping=reinhard" },
    { "--tone-mapping=reinhard-extended" },
    { "--tone-mapping=reinhard-extended", "--white-point=2" },
    { "--tone-mapping=aces" },
    { "--depth-of-field=0,1" },
    { "--depth-of-field=0,2" },
    { "--depth-of-field=20,2" },
    { "--anti-aliasing=fxaa" },
  };
  std::map<std::string, std::string> lookOfPicture;
  for (const Words& look : looks)
  {
    Words options = look;
    options.push_back(lit);
    std::string name;
    for (const std::string& option : look)
      name += option + " ";
    const std::string picture = drawTeapot(options);
    const auto [other, isNew] = lookOfPicture.emplace(picture, name);
    EXPECT_TRUE(isNew) << name << "looks like " << other->second;
    EXPECT_EQ(drawTeapot(options, { { "LIMN_RENDERER", "reference" } }), picture) << name;
  }
}

TEST_F(RenderEffects, TheBytesDependOnTheSceneOnly)
{
  const Words options = { "--light=directional:1,-1,-1:4,4,4", "--exposure=1.5", "--bloom=0.5",
    "--tone-mapping=aces", "--depth-of-field=0,1", "--anti-aliasing=fxaa" };
  const std::string first = drawTeapot(options);
  for (const std::string threads : { "1", "2", "3", "8" })
  {
    Words threaded = options;
    threaded.push_back("--threads=" + threads);
    EXPECT_EQ(drawTeapot(threaded), first) << threads << " threads";
  }
  for (const std::string target : { "AVX2", "SSE4", "SSSE3" })
  {
    Words arguments = { "render", meshFile("teapot.obj"), "--resolution=200,120",
      "--output=" + output_ };
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (runLimn(arguments, { { "LIMN_INSTRUCTION_SET", target } }).status == 0)
    {
      EXPECT_EQ(bytesOf(output_), first) << target;
    }
  }
}

TEST_F(RenderEffects, DepthOfFieldBlursTheAlphaOfAPictureWithoutBackground)
{
  const std::string sharp = drawTeapot({ "--no-background" });
  EXPECT_EQ(pngHeader(output_).channels, 4);
  EXPECT_NE(drawTeapot({ "--no-background", "--depth-of-field=100,3" }), sharp);
}

TEST_F(RenderEffects, ALensTooLargeIsAnError)
{
  const Outcome outcome = runLimn(
    { "render", meshFile("teapot.obj"), "--output=" + output_, "--depth-of-field=1e-20,1e30" });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("aperture"), std::string::npos) << outcome.err;
  EXPECT_EQ(bytesOf(output_), "");
}

} // namespace
} // namespace limn::testing
