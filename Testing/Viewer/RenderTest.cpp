// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>

namespace limn::testing
{
namespace
{

using Words = std::vector<std::string>;

/// Draws a mesh of Data/Meshes, small, and returns the bytes of the picture.
class Render : public ::testing::Test
{
protected:
  std::string draw(
    const std::string& mesh, const Words& options = {}, const Environment& environment = {})
  {
    Words arguments = { "render", meshFile(mesh), "--resolution=200,120", "--output=" + output_ };
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runLimn(arguments, environment);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    out_ = outcome.out;
    return bytesOf(output_);
  }

  Folder folder_;
  std::string output_ = folder_.file("out.png");
  std::string out_;
};

TEST_F(Render, WritesAPngOfTheResolutionAndNothingElse)
{
  draw("teapot.obj");
  const PngHeader header = pngHeader(output_);
  EXPECT_EQ(header.width, 200);
  EXPECT_EQ(header.height, 120);
  EXPECT_EQ(header.channels, 3);
  EXPECT_EQ(folder_.names(), Words{ "out.png" });
  EXPECT_EQ(out_, "");
}

TEST_F(Render, WritesMapsOfNormalsDepthAndIds)
{
  const std::string normals = folder_.file("n.png"), depth = folder_.file("d.png"),
                    ids = folder_.file("i.png");
  const std::string plain = draw("teapot.obj");
  EXPECT_EQ(draw("teapot.obj",
              { "--output-normals=" + normals, "--output-depth=" + depth, "--output-ids=" + ids }),
    plain)
    << "the picture is the same";
  EXPECT_EQ(folder_.names(), (Words{ "d.png", "i.png", "n.png", "out.png" }));
  EXPECT_EQ(pngHeader(normals).channels, 3);
  EXPECT_EQ(pngHeader(normals).width, 200);
  // Sixteen bits, of one and of three channels.
  EXPECT_EQ(bytesOf(depth).substr(24, 2), (std::string{ 16, 0 }));
  EXPECT_EQ(bytesOf(ids).substr(24, 2), (std::string{ 16, 2 }));
}

TEST_F(Render, WithoutBackgroundThePictureHasAlpha)
{
  draw("teapot.obj", { "--no-background" });
  EXPECT_EQ(pngHeader(output_).channels, 4);
}

TEST_F(Render, TheToneLegendIsAPictureOfItsOwn)
{
  const Words options = { "--coloring-array=height", "--tone=gooch",
    "--tone-over-data=legend-safe" };
  const std::string alone = draw("waves.vtp", options);
  Words both = options;
  both.push_back("--tone-legend=" + folder_.file("legend.png"));
  EXPECT_EQ(draw("waves.vtp", both), alone);
  const PngHeader header = pngHeader(folder_.file("legend.png"));
  EXPECT_EQ(header.width, 256);
  EXPECT_EQ(header.height, 64);
  EXPECT_EQ(folder_.names(), (Words{ "legend.png", "out.png" }));
  const std::string viridis = bytesOf(folder_.file("legend.png"));
  both.push_back("--colormap=cool-warm");
  draw("waves.vtp", both);
  EXPECT_NE(bytesOf(folder_.file("legend.png")), viridis);
}

TEST_F(Render, MapsNeedNoPicture)
{
  const std::string map = "--output-ids=" + folder_.file("ids.png");
  draw("teapot.obj", { map });
  const std::string beside = bytesOf(folder_.file("ids.png"));
  const Folder other;
  const Outcome outcome = runLimn({ "render", meshFile("teapot.obj"), "--resolution=200,120",
    "--output-ids=" + other.file("ids.png") });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(other.names(), Words{ "ids.png" });
  EXPECT_EQ(bytesOf(other.file("ids.png")), beside);
}

// What a style takes it shows; it refuses the rest.
TEST_F(Render, AStyleShowsWhatItDoesNotRefuse)
{
  const Words options = { "--color=0.9,0.2,0.1", "--diffuse=0.3,0.3,0.3", "--procedural=checker",
    "--coloring-array=region", "--specular=1,1,1", "--specular-power=90", "--shading=flat",
    "--normals=uniform", "--feature-angle=1", "--light=directional:1,-1,0.5:1,1,1",
    "--ambient=0.5,0.1,0.1", "--ambient-light=0.5,0.5,0.5", "--hatch-spacing=9", "--hatch-width=2",
    "--hatch-darkest=0.2" };
  int refused = 0;
  for (const std::string style : { "plain", "technical", "gooch", "toon", "blueprint", "pencil",
         "ink", "anatomy", "metal", "xray", "print" })
  {
    std::map<std::string, std::string> bare;
    for (const std::string mesh : { "globe.obj", "waves.vtp" })
    {
      bare[mesh] = draw(mesh, { "--style=" + style });
    }
    for (const std::string& option : options)
    {
      const std::string mesh = option.rfind("--coloring", 0) == 0 ? "waves.vtp" : "globe.obj";
      // A refused picture leaves the file as it is.
      std::ofstream(output_, std::ios::binary) << bare[mesh];
      const Outcome outcome = runLimn({ "render", meshFile(mesh), "--resolution=200,120",
        "--output=" + output_, "--style=" + style, option });
      refused += outcome.status == 2 ? 1 : 0;
      EXPECT_EQ(outcome.status == 2, bytesOf(output_) == bare[mesh]) << style << ' ' << option;
    }
  }
  EXPECT_GT(refused, 50);
}

TEST_F(Render, WhatIsNamedBesideAStyleHolds)
{
  const std::string xray = draw("teapot.obj", { "--style=xray" });
  EXPECT_NE(draw("teapot.obj", { "--style=xray", "--opacity=0.9" }), xray);
  const std::string ink = draw("teapot.obj", { "--style=ink" });
  for (const std::string option : { "--crease-angle=3", "--stroke-width=4", "--outer-width=1",
         "--stroke-color=1,0,0", "--stroke-opacity=0.4", "--stroke-taper=60", "--stroke-dash=6,4",
         "--hidden-lines=thin", "--background-color=0.5,0.5,0.5" })
  {
    EXPECT_NE(draw("teapot.obj", { "--style=ink", option }), ink) << option;
  }
}

// At 144 dpi a point is two pixels, and an inch 144.
TEST_F(Render, LengthsAreThoseOfThePicture)
{
  const struct
  {
    std::string pixels, points, millimeters;
  } lengths[] = {
    { "--outline-width=4", "--outline-width=2pt", "--outline-width=0.7055555555555556mm" },
    { "--stroke-taper=36px", "--stroke-taper=18pt", "--stroke-taper=6.35mm" },
    { "--stroke-dash=6,4", "--stroke-dash=3pt,4px", "--stroke-dash=1.0583333333333333mm,2pt" },
  };
  for (const auto& length : lengths)
  {
    const bool isOutline = length.pixels.find("outline") != std::string::npos;
    const std::string kind = isOutline ? "--outline=hull" : "--lines=border,contour";
    const std::string pixels = draw("teapot.obj", { kind, length.pixels });
    EXPECT_EQ(draw("teapot.obj", { kind, length.points, "--dpi=144" }), pixels) << length.points;
    EXPECT_EQ(draw("teapot.obj", { kind, length.millimeters, "--dpi=144" }), pixels)
      << length.millimeters;
    EXPECT_NE(draw("teapot.obj", { kind, length.points }), pixels) << length.points;
  }
}

// A mesh without normals is sharp at its creases, and has creases where it is sharp.
TEST_F(Render, AStylesCreasesAreAtTheFeatureAngle)
{
  for (const std::string style : { "ink", "pencil", "blueprint" })
  {
    const std::string bare = draw("gear.stl", { "--style=" + style });
    const std::string sharper = draw("gear.stl", { "--style=" + style, "--feature-angle=5" });
    EXPECT_NE(sharper, bare) << style;
    EXPECT_EQ(draw("gear.stl", { "--style=" + style, "--crease-angle=5" }), sharper) << style;
  }
}

// A scan bends sharply here and there; a gear has edges.
TEST_F(Render, StylesLeaveOutShortCreases)
{
  const auto drawn = [this](const std::string& mesh, const std::string& edges) {
    return draw(mesh, { "--style=print", "--shortest-crease=" + edges });
  };
  const std::string rock = draw("rock.ply", { "--style=print" });
  EXPECT_NE(drawn("rock.ply", "1"), rock);
  EXPECT_EQ(drawn("rock.ply", "8"), rock);
  EXPECT_EQ(drawn("rock.ply", "1000000"), rock);
  EXPECT_EQ(drawn("gear.stl", "1"), draw("gear.stl", { "--style=print" }));
}

TEST_F(Render, TheBytesDependOnTheSceneOnly)
{
  const Words options = { "--tone=gooch", "--light=directional:-1,-1,-1:1,1,1" };
  const std::string first = draw("teapot.obj", options);
  ASSERT_GT(first.size(), 1000u);
  EXPECT_EQ(draw("teapot.obj", options), first);
  for (const std::string threads : { "1", "2", "3", "8" })
  {
    Words threaded = options;
    threaded.push_back("--threads=" + threads);
    EXPECT_EQ(draw("teapot.obj", threaded), first) << threads << " threads";
  }
}

TEST_F(Render, EveryInstructionSetDrawsTheSameBytes)
{
  const std::string best = draw("teapot.obj", { "--stats" });
  const std::string bestTarget = nlohmann::json::parse(out_)["target"];
  std::size_t tried = 0;
  for (const std::string target : { "AVX3", "AVX2", "SSE4", "SSSE3", "NEON" })
  {
    const Words arguments = { "render", meshFile("teapot.obj"), "--resolution=200,120", "--stats",
      "--output=" + output_ };
    const Outcome outcome = runLimn(arguments, { { "LIMN_INSTRUCTION_SET", target } });
    if (outcome.status != 0)
      continue;
    if (nlohmann::json::parse(outcome.out)["target"] != target)
      continue;
    EXPECT_EQ(bytesOf(output_), best) << target << " and " << bestTarget;
    ++tried;
  }
  EXPECT_GE(tried, 1u) << "not even " << bestTarget << " can be chosen";
}

TEST_F(Render, EveryLookIsAPictureOfItsOwn)
{
  const std::vector<Words> looks = {
    {},
    { "--shading=flat" },
    { "--shading=gouraud" },
    { "--reflection=none" },
    { "--reflection=lambert" },
    { "--reflection=phong" },
    { "--tone=gooch" },
    { "--tone=gooch-chapter" },
    { "--tone=gooch", "--cool=0,0.5,0" },
    { "--tone=gooch", "--warm=0.9,0,0" },
    { "--tone=gooch", "--tone-light=upper-right" },
    { "--tone=gooch", "--toon-steps=4" },
    { "--tone=gooch-rtr4" },
    { "--tone=gooch-orange-book" },
    { "--tone=metal" },
    { "--tone=toon" },
    { "--tone=toon", "--toon-steps=5" },
    { "--toon-ramp=" + meshFile("../Textures/toon_ramp.png") },
    { "--toon-ramp=" + meshFile("../Textures/toon_ramp.png"), "--toon-ramp-by=silhouette" },
    { "--toon-ramp=" + meshFile("../Textures/toon_ramp.png"), "--toon-ramp-by=highlight" },
    { "--matcap=" + meshFile("../Textures/lit_sphere.png") },
    { "--tone=hatching" },
    { "--tone=hatching", "--hatch-spacing=9" },
    { "--tone=hatching", "--hatch-darkest=0.5" },
    { "--tone=hatching", "--hatch-ink=1,0,0" },
    { "--tone=hatching", "--hatch-paper=1,1,0.7" },
    { "--tone=exaggerated" },
    { "--tone=exaggerated", "--exaggeration-contrast=2" },
    { "--tone=exaggerated", "--exaggeration-exponent=1" },
    { "--tone=exaggerated", "--exaggeration-base=0.8" },
    { "--tone=exaggerated", "--exaggeration-levels=2" },
    { "--tone=exaggerated", "--exaggeration-scale=0.1" },
    { "--tone=exaggerated", "--tone-light=upper-right" },
    { "--tone=exaggerated", "--toon-steps=4" },
    { "--lines=hatch" },
    { "--lines=hatch", "--hatch-width=2" },
    { "--lines=hatch", "--hatch-spacing=12" },
    { "--lines=hatch", "--hatch-darkest=0.3" },
    { "--outline=normal" },
    { "--outline=normal", "--outline-width=2" },
    { "--outline=normal", "--outline-opacity=0.5" },
    { "--outline=hull" },
    { "--outline=hull", "--outline-width=4" },
    { "--outline=hull", "--outline-opacity=0.5" },
    { "--outline=normal", "--outline-color=1,0,0" },
    { "--outline=image" },
    { "--outline=image", "--outline-color=1,0,0" },
    { "--outline=image", "--outline-width=4" },
    { "--outline=image", "--outline-opacity=0.5" },
    { "--outline=image", "--outline-detector=sobel" },
    { "--outline=image", "--outline-detector=laplacian" },
    { "--outline=image", "--outline-tolerance=50" },
    { "--outline=image", "--outline-crease-angle=5" },
    { "--color=1,0.2,0.1" },
    { "--diffuse=0.2,0.9,0.1" },
    { "--specular=0,0,1" },
    { "--specular-power=4" },
    { "--ambient-light=0.3,0.3,0.3" },
    { "--ambient-light=0.3,0.3,0.3", "--ambient=1,0,0" },
    { "--light=directional:-1,-1,-1:1,1,1" },
    { "--light=directional:1,-1,-1:1,1,1" },
    { "--light=directional:-1,-1,-1:1,1,1", "--light=headlight" },
    { "--light=point:4,4,4:40,40,40" },
    { "--light=spot:0,4,8:0,-0.4,-0.8:8:1:80,80,80" },
    { "--samples=1" },
    { "--samples=2" },
    { "--samples=8" },
    { "--background-color=0,0,0" },
    { "--camera-position=8,3,1" },
    { "--camera-focal-point=0,0,0.5" },
    { "--camera-view-up=1,1,0" },
    { "--camera-view-angle=60", "--camera-position=8,3,1" },
    { "--camera-orthographic" },
    { "--camera-orthographic", "--camera-parallel-scale=5" },
    { "--up=+Z" },
  };
  std::map<std::string, std::string> lookOfPicture;
  for (const Words& look : looks)
  {
    std::string name;
    for (const std::string& option : look)
      name += option + " ";
    const auto [other, isNew] = lookOfPicture.emplace(draw("teapot.obj", look), name);
    EXPECT_TRUE(isNew) << name << "looks like " << other->second;
  }
}

/// A floor that fills the picture, seen and lit from straight above: n.l = n.v = n.h = 1, so that
/// every pixel shows one value of the equation in question.
class RenderFloor : public Render
{
protected:
  /// How the picture of the floor differs from one that is wholly `color`.
  std::string differenceFrom(const std::string& color, const Words& options)
  {
    const std::string floor =
      folder_.write("floor.obj", "v -9 0 -9\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nf 1 2 3 4\n");
    drawFloor(floor, "floor.png", "0,2,0", options);
    drawFloor(floor, "color.png", "0,-2,0",
      { "--camera-focal-point=0,-4,0", "--background-color=" + color });
    return runLimn({ "compare", folder_.file("floor.png"), folder_.file("color.png") }).out;
  }

private:
  void drawFloor(const std::string& floor, const std::string& picture, const std::string& eye,
    const Words& options)
  {
    Words arguments = { "render", floor, "--resolution=20,10", "--camera-orthographic" };
    const Words place = { "--camera-parallel-scale=1", "--camera-position=" + eye,
      "--output=" + folder_.file(picture) };
    arguments.insert(arguments.end(), place.begin(), place.end());
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runLimn(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
};

const char* const kSame = "0 of 200 pixels differ; largest difference 0, mean 0\n";

TEST_F(RenderFloor, OptionsAreTheTermsOfTheChaptersEquations)
{
  const auto differenceOfDull = [this](const std::string& color, Words options)
  {
    options.push_back("--specular=0,0,0");
    return differenceFrom(color, options);
  };
  const std::string color = "--color=0.2,0.4,0";
  EXPECT_EQ(differenceOfDull("0.2,0.4,0", { color }), kSame);
  EXPECT_EQ(differenceOfDull("0.2,0.4,0", { color, "--light=headlight" }), kSame);
  EXPECT_EQ(differenceOfDull("0.2,0.4,0", { "--diffuse=0.2,0.4,0" }), kSame);
  EXPECT_EQ(differenceOfDull("0.4,0.8,0", { color, "--light=directional:0,-1,0:2,2,2" }), kSame);
  EXPECT_EQ(differenceOfDull("0,0,0", { color, "--light=directional:0,1,0:2,2,2" }), kSame);
  EXPECT_EQ(differenceOfDull("0.2,0.4,0", { color, "--reflection=none" }), kSame);
  EXPECT_EQ(differenceOfDull("0.4,0.6,0", { color, "--ambient-light=1,0.5,1" }), kSame);
  EXPECT_EQ(
    differenceOfDull("0.2,0.4,0.2", { color, "--ambient-light=0.5,0.5,1", "--ambient=0,0,0.2" }),
    kSame);
}

TEST_F(RenderFloor, HighlightsAreAddedUnlessTheReflectionIsLambert)
{
  const Words shiny = { "--color=0.2,0.4,0", "--specular=0.2,0,1" };
  EXPECT_EQ(differenceFrom("0.4,0.4,1", shiny), kSame);
  EXPECT_EQ(differenceFrom("0.4,0.4,1", { shiny[0], shiny[1], "--reflection=phong" }), kSame);
  EXPECT_EQ(differenceFrom("0.2,0.4,0", { shiny[0], shiny[1], "--reflection=lambert" }), kSame);
}

TEST_F(RenderFloor, LocalModelsAddOneTermAtATime)
{
  // Luminance: 0.3286 of the colour, 0.11472 of the highlight.
  const auto differenceOfModel = [this](int model, const std::string& color, Words options)
  {
    options.insert(options.end(),
      { "--color=0.2,0.4,0", "--specular=0.2,0,1", "--model=" + std::to_string(model) });
    return differenceFrom(color, options);
  };
  const std::string ambient = "--ambient-light=0.5,0.5,0.5",
                    farAway = "--light=point:0,100,0:1,1,1";
  EXPECT_EQ(differenceOfModel(1, "0.1643,0.1643,0.1643", { ambient }), kSame);
  EXPECT_EQ(differenceOfModel(2, "0.4929,0.4929,0.4929", { ambient }), kSame);
  EXPECT_EQ(differenceOfModel(2, "0.3286,0.3286,0.3286", { farAway }), kSame);
  EXPECT_EQ(differenceOfModel(3, "0,0,0", { farAway }), kSame);
  EXPECT_EQ(differenceOfModel(3, "0.3286,0.3286,0.3286", {}), kSame);
  EXPECT_EQ(differenceOfModel(4, "0.44332,0.44332,0.44332", {}), kSame);
  EXPECT_EQ(differenceOfModel(5, "0.31472,0.51472,0.11472", {}), kSame);
}

TEST_F(RenderFloor, WarmAndCoolAreTheEndsOfTheTonesThemselves)
{
  const std::string warm = "--warm=0.8,0.4,0.2";
  const std::string cool = "--cool=0,0.2,0.6";
  const std::string dull = "--specular=0,0,0";
  EXPECT_EQ(differenceFrom("0.8,0.4,0.2", { warm, cool, dull, "--tone=gooch" }), kSame);
  EXPECT_EQ(differenceFrom("0,0.2,0.6", { warm, cool, dull, "--tone=gooch-chapter" }), kSame);
  EXPECT_EQ(differenceFrom("1,0.4,0.6", { "--color=1,0,1", dull, "--tone=gooch" }), kSame);
}

TEST_F(RenderFloor, TheBooksConstantsAreTheEndsOfTheirTones)
{
  // Warm, as the floor faces the light: 0.3 + 0.25 k_d, and where r.v = 1 white.
  EXPECT_EQ(differenceFrom("1,1,1", { "--tone=gooch-rtr4" }), kSame);
  // 0.6 + 0.45 x 0.75 and the highlight: above 1.
  EXPECT_EQ(differenceFrom("1,1,1", { "--tone=gooch-orange-book" }), kSame);
}

TEST_F(Render, BackFacesOfAnOpenSheetCanBeLeftOut)
{
  const Words behind = { "--camera-position=0,-8,-8", "--camera-view-up=0,1,0" };
  Words culled = behind;
  culled.push_back("--backface-culling");
  const Words inFront = { "--camera-position=0,8,8", "--camera-view-up=0,1,0" };
  Words inFrontCulled = inFront;
  inFrontCulled.push_back("--backface-culling");
  const bool changesBehind = draw("sheet.off", behind) != draw("sheet.off", culled);
  const bool changesInFront = draw("sheet.off", inFront) != draw("sheet.off", inFrontCulled);
  EXPECT_NE(changesBehind, changesInFront) << "one side of the sheet is its back";
}

TEST_F(Render, ArraysGiveColour)
{
  const std::string plain = draw("waves.vtp");
  const std::string viridis = draw("waves.vtp", { "--coloring-array=height" });
  EXPECT_NE(viridis, plain);
  EXPECT_EQ(draw("waves.vtp", { "--coloring-array=height", "--colormap=viridis" }), viridis);
  for (const std::string map : { "cool-warm", "rainbow", "grayscale", "black-body" })
  {
    EXPECT_NE(draw("waves.vtp", { "--coloring-array=height", "--colormap=" + map }), viridis)
      << map;
  }
  EXPECT_NE(draw("waves.vtp", { "--coloring-array=height", "--coloring-range=0,0.1" }), viridis);
}

TEST_F(Render, TheSameMeshInTwoFormatsIsOnePicture)
{
  EXPECT_EQ(draw("waves.vtp", { "--coloring-array=height" }),
    draw("waves.vtk", { "--coloring-array=height" }));
}

TEST_F(Render, EveryFormatIsDrawn)
{
  std::map<std::string, std::string> meshOfPicture;
  for (const std::string mesh : { "teapot.obj", "sphere.ply", "rock.ply", "torus.off", "gear.stl",
         "knot.obj", "sine.obj", "sheet.off", "waves.vtp" })
  {
    const auto [other, isNew] = meshOfPicture.emplace(draw(mesh), mesh);
    EXPECT_TRUE(isNew) << mesh << " looks like " << other->second;
  }
}

TEST_F(Render, ExtensionsMayBeInCapitals)
{
  const std::string capital = folder_.write("CUBE.OBJ", bytesOf(meshFile("cube.obj")));
  const std::string expected = draw("cube.obj");
  const Outcome outcome =
    runLimn({ "render", capital, "--resolution=200,120", "--output=" + output_ });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(bytesOf(output_), expected);
}

TEST_F(Render, ASecondMeshIsDrawnBesideTheFirst)
{
  const Words camera = { "--camera-position=0,0,12", "--camera-focal-point=0,0,0" };
  Words both = camera;
  both.insert(both.begin(), meshFile("torus.off"));
  EXPECT_NE(draw("cube.obj", both), draw("cube.obj", camera));
}

TEST_F(Render, StatsAreOneLineOfJson)
{
  draw("cube.obj", { "--stats", "--threads=3" });
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '\n'), 1);
  const nlohmann::json stats = nlohmann::json::parse(out_);
  EXPECT_EQ(stats["triangles"], 12);
  EXPECT_GE(stats["vertices"], 8);
  EXPECT_GE(stats["clusters"], 1);
  EXPECT_GT(stats["bytes"], 0);
  EXPECT_EQ(stats["threads"], 3);
  EXPECT_NE(stats["target"], "");
  for (const std::string stage : { "read", "prepare", "bin", "tiles", "render", "write" })
  {
    EXPECT_GE(stats["ms"][stage], 0.0) << stage;
  }
  EXPECT_LE(stats["ms"]["tiles"], stats["ms"]["render"]);
}

TEST_F(Render, ReplacesAnOlderPicture)
{
  folder_.write("out.png", "older");
  draw("cube.obj");
  EXPECT_EQ(pngHeader(output_).width, 200);
  EXPECT_EQ(folder_.names(), Words{ "out.png" });
}

TEST_F(Render, VersionAndHelpGoToStdout)
{
  const Outcome version = runLimn({ "--version" });
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.substr(0, 5), "limn ");
  const Outcome help = runLimn({ "help" });
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("limn render"), std::string::npos);
  EXPECT_EQ(help.err, "");
}

} // namespace
} // namespace limn::testing
