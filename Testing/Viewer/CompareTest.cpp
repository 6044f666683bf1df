// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <gtest/gtest.h>

namespace limn::testing
{
namespace
{

using Words = std::vector<std::string>;

class Compare : public ::testing::Test
{
protected:
  std::string draw(
    const std::string& name, const Words& options, const std::string& resolution = "40,30")
  {
    Words arguments = { "render", meshFile("cube.obj"), "--resolution=" + resolution,
      "--output=" + folder_.file(name) };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runLimn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return folder_.file(name);
  }

  /// Wholly one grey: the cube is behind the eye.
  std::string drawGrey(const std::string& name, const std::string& level)
  {
    return draw(name, { "--background-color=" + level + "," + level + "," + level,
                        "--camera-position=0,0,50", "--camera-focal-point=0,0,100" });
  }

  Folder folder_;
};

TEST_F(Compare, EqualPicturesAreSuccess)
{
  const std::string a = draw("a.png", {});
  const std::string b = draw("b.png", {});
  const Outcome outcome = runLimn({ "compare", a, b });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "0 of 1200 pixels differ; largest difference 0, mean 0\n");
}

TEST_F(Compare, CountsLargestAndMeanAreThoseOfTheBytes)
{
  const std::string black = drawGrey("black.png", "0");
  const std::string grey = drawGrey("grey.png", "0.2");
  const Outcome outcome = runLimn({ "compare", black, grey });
  EXPECT_EQ(outcome.status, 3);
  // Three of four channels differ by 51 = 0.2 * 255; alpha does not.
  EXPECT_EQ(outcome.out, "1200 of 1200 pixels differ; largest difference 51, mean 38.25\n");
}

TEST_F(Compare, ToleranceIsTheLargestDifferenceThatPasses)
{
  const std::string black = drawGrey("black.png", "0");
  const std::string grey = drawGrey("grey.png", "0.2");
  EXPECT_EQ(runLimn({ "compare", black, grey, "--tolerance=50" }).status, 3);
  const Outcome passed = runLimn({ "compare", black, grey, "--tolerance=51" });
  EXPECT_EQ(passed.status, 0);
  EXPECT_EQ(
    passed.out, "0 of 1200 pixels differ by more than 51; largest difference 51, mean 38.25\n");
}

TEST_F(Compare, OpaqueAndTransparentPicturesDiffer)
{
  const std::string opaque = draw("a.png", { "--background-color=0,0,0" });
  const std::string transparent = draw("b.png", { "--no-background" });
  EXPECT_EQ(runLimn({ "compare", opaque, transparent }).status, 3);
}

TEST_F(Compare, WhatCannotBeComparedIsAnError)
{
  const std::string a = draw("a.png", {});
  const std::string larger = draw("larger.png", {}, "41,30");
  const std::string noise = folder_.write("noise.png", "this is not a picture");
  const std::string bytes = bytesOf(a);
  const std::string cut = folder_.write("cut.png", bytes.substr(0, bytes.size() / 2));
  for (const std::string& other :
    { folder_.file("none.png"), larger, noise, cut, folder_.file("") })
  {
    const Outcome outcome = runLimn({ "compare", a, other });
    EXPECT_EQ(outcome.status, 2) << other << ": " << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("limn: error: "), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

} // namespace
} // namespace limn::testing
