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

RenderSettings parseRender(const Words& options)
{
  Words arguments = { "render", "a.obj", "--output=a.png" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return std::get<RenderRequest>(parseArguments(arguments)).settings;
}

/// The message of the error, or "" if there is none.
std::string errorOf(const Words& arguments)
{
  try
  {
    parseArguments(arguments);
  }
  catch (const UserError& error)
  {
    return error.what();
  }
  return "";
}

std::string renderErrorOf(const Words& options)
{
  Words arguments = { "render", "a.obj", "--output=a.png" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return errorOf(arguments);
}

TEST(Arguments, DefaultsAreThoseOfTheHelp)
{
  const RenderSettings settings = parseRender({});
  EXPECT_EQ(settings.output, "a.png");
  EXPECT_EQ(settings.scene.meshes, Words{ "a.obj" });
  EXPECT_EQ(settings.window, Window::Cpu);
  EXPECT_EQ(settings.scene.samples, 4);
  EXPECT_EQ(settings.scene.threads, 0);
  EXPECT_EQ(settings.scene.resolution, (std::array<int, 2>{ 1000, 600 }));
  EXPECT_EQ(settings.scene.material.shading, Shading::Phong);
  EXPECT_EQ(settings.scene.material.reflection, std::nullopt);
  EXPECT_EQ(settings.scene.material.tone, Tone::None);
  EXPECT_EQ(settings.scene.material.outline, Outline::None);
  EXPECT_TRUE(settings.scene.lights.empty());
  EXPECT_FALSE(settings.stats);
  EXPECT_FALSE(settings.transparentBackground);
}

TEST(Arguments, SeveralMeshesMayStandBetweenTheOptions)
{
  const auto request =
    parseArguments({ "render", "a.obj", "--output", "x.png", "b.ply", "--samples=8", "c.stl" });
  const RenderSettings& settings = std::get<RenderRequest>(request).settings;
  EXPECT_EQ(settings.scene.meshes, (Words{ "a.obj", "b.ply", "c.stl" }));
  EXPECT_EQ(settings.output, "x.png");
  EXPECT_EQ(settings.scene.samples, 8);
}

TEST(Arguments, CameraIsReadIncludingNegativeNumbers)
{
  const CameraSettings camera = parseRender(
    { "--camera-position=-1,2.5,-3e2", "--camera-focal-point", "-1,0,0", "--camera-view-up=0,0,1",
      "--camera-view-angle=45", "--camera-orthographic", "--camera-parallel-scale=2", "--up=-z" })
                                  .scene.camera;
  EXPECT_EQ(camera.position, (Vector3{ -1, 2.5, -300 }));
  EXPECT_EQ(camera.focalPoint, (Vector3{ -1, 0, 0 }));
  EXPECT_EQ(camera.viewUp, (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(camera.viewAngleDegrees, 45);
  EXPECT_TRUE(camera.orthographic);
  EXPECT_EQ(camera.parallelScale, 2);
  EXPECT_EQ(camera.up, (Vector3{ 0, 0, -1 }));
}

TEST(Arguments, MaterialIsRead)
{
  const MaterialSettings material =
    parseRender({ "--color=0.1,0.2,0.3", "--shading=gouraud", "--reflection=lambert",
                  "--tone=gooch-chapter", "--cool=0,0,1", "--warm=1,0.5,0", "--ambient=0.1,0.1,0",
                  "--diffuse=0,1,0", "--specular=1,1,1", "--specular-power=50", "--outline=normal",
                  "--outline-color=1,0,0", "--backface-culling", "--opacity=0.3" })
      .scene.material;
  EXPECT_EQ(material.color, (Color{ 0.1, 0.2, 0.3 }));
  EXPECT_EQ(material.shading, Shading::Gouraud);
  EXPECT_EQ(material.reflection, Reflection::Lambert);
  EXPECT_EQ(material.tone, Tone::GoochChapter);
  EXPECT_EQ(material.cool, (Color{ 0, 0, 1 }));
  EXPECT_EQ(material.warm, (Color{ 1, 0.5, 0 }));
  EXPECT_EQ(material.ambient, (Color{ 0.1, 0.1, 0 }));
  EXPECT_EQ(material.diffuse, (Color{ 0, 1, 0 }));
  EXPECT_EQ(material.specular, (Color{ 1, 1, 1 }));
  EXPECT_EQ(material.specularPower, 50);
  EXPECT_EQ(material.opacity, 0.3);
  EXPECT_EQ(material.outline, Outline::Normal);
  EXPECT_EQ(material.outlineColor, (Color{ 1, 0, 0 }));
  EXPECT_TRUE(material.backfaceCulling);
}

TEST(Arguments, ReflectionIsRead)
{
  const MaterialSettings metal = parseRender(
    { "--reflection=metallic", "--roughness=0.25", "--metallic=1", "--refractive-index=2.4" })
                                   .scene.material;
  EXPECT_EQ(metal.reflection, Reflection::Metallic);
  EXPECT_EQ(metal.roughness, 0.25);
  EXPECT_EQ(metal.metallic, 1);
  EXPECT_EQ(metal.refractiveIndex, (Color{ 2.4, 2.4, 2.4 }));
  const MaterialSettings velvet =
    parseRender({ "--reflection=irradiance", "--fresnel", "--refractive-index=1.5,1.6,1.7",
                  "--rim=0.5,0,0", "--rim-power=2" })
      .scene.material;
  EXPECT_TRUE(velvet.fresnel);
  EXPECT_EQ(velvet.refractiveIndex, (Color{ 1.5, 1.6, 1.7 }));
  EXPECT_EQ(velvet.rim, (Color{ 0.5, 0, 0 }));
  EXPECT_EQ(velvet.rimPower, 2);
  EXPECT_EQ(parseRender({ "--model=4" }).scene.material.localModel, 4);
}

TEST(Arguments, LinesAreKindsAndAStyle)
{
  const SceneSettings scene =
    parseRender({ "--lines=crease,contour,suggestive", "--crease-angle=25", "--shortest-crease=4",
                  "--stroke-width=0.35mm", "--dpi=300", "--outer-width=2",
                  "--stroke-color=0.1,0.2,0.3", "--stroke-opacity=0.5", "--stroke-taper=20pt",
                  "--stroke-dash=6,3mm", "--hidden-lines=dashed" })
      .scene;
  const LineSettings& lines = scene.lines;
  EXPECT_EQ(lines.kinds,
    (std::vector<LineKind>{ LineKind::Crease, LineKind::Contour, LineKind::Suggestive }));
  EXPECT_EQ(lines.creaseAngleDegrees, 25);
  EXPECT_EQ(lines.shortestCrease, 4);
  EXPECT_EQ(lines.width->value, 0.35);
  EXPECT_EQ(lines.width->unit, 2);
  EXPECT_EQ(scene.pixelsPerInch, 300);
  EXPECT_EQ(lines.outerWidth, 2);
  EXPECT_EQ(lines.color, (Color{ 0.1, 0.2, 0.3 }));
  EXPECT_EQ(lines.opacity, 0.5);
  EXPECT_EQ(lines.taper->value, 20);
  EXPECT_EQ(lines.taper->unit, 1);
  EXPECT_EQ((*lines.dash)[0].value, 6);
  EXPECT_EQ((*lines.dash)[0].unit, 0);
  EXPECT_EQ((*lines.dash)[1].value, 3);
  EXPECT_EQ((*lines.dash)[1].unit, 2);
  EXPECT_EQ(lines.hidden, HiddenLines::Dashed);
  const auto widthOf = [](const char* option) {
    return *parseRender({ "--lines=border", option }).scene.lines.width;
  };
  EXPECT_EQ(widthOf("--stroke-width=2").unit, 0);
  EXPECT_EQ(widthOf("--stroke-width=2px").unit, 0);
  EXPECT_EQ(widthOf("--stroke-width=0.75pt").unit, 1);
}

TEST(Arguments, LinesOfLightAndOfCurvatureHaveSettings)
{
  const LineSettings lines =
    parseRender({ "--lines=terminator,shadow,intersections,ridge,suggestive",
                  "--light=directional:1,-1,-1:1,1,1", "--line-lights=all", "--ridge-threshold=0.3",
                  "--suggestive-threshold=0" })
      .scene.lines;
  EXPECT_EQ(lines.kinds, (std::vector<LineKind>{ LineKind::Terminator, LineKind::Shadow,
                           LineKind::Intersections, LineKind::Ridge, LineKind::Suggestive }));
  EXPECT_EQ(lines.lights, LineLights::All);
  EXPECT_EQ(lines.ridgeThreshold, 0.3);
  EXPECT_EQ(lines.suggestiveThreshold, 0);
  EXPECT_EQ(
    renderErrorOf({ "--lines=shadow", "--light=point:1,1,1:1,1,1", "--crease-angle=20" }), "");
}

TEST(Arguments, AStyleTakesThePlaceOfWhatItDecidesOn)
{
  const RenderSettings settings =
    parseRender({ "--style=technical", "--stroke-width=2pt", "--crease-angle=20" });
  EXPECT_EQ(settings.scene.style, "technical");
  EXPECT_EQ(settings.scene.lines.width->value, 2);
  EXPECT_FALSE(settings.scene.background.has_value());
  EXPECT_TRUE(parseRender({}).scene.style.empty());
  for (const std::string option :
    { "--tone=gooch", "--outline=hull", "--lines=crease", "--reflection=phong", "--model=2",
      "--cool=0,0,1", "--toon-steps=3", "--tone-light=upper-right", "--outline-width=3" })
  {
    EXPECT_EQ(renderErrorOf({ "--style=ink", option }),
      "--style and " + option.substr(0, option.find('=')) + " exclude each other; give one");
  }
  EXPECT_EQ(renderErrorOf({ "--style=print", "--dpi=300" }), "");
  EXPECT_EQ(renderErrorOf({ "--style=baroque" }),
    "--style=baroque is unknown; choose one of: plain, technical, gooch, toon, blueprint, pencil, "
    "ink, anatomy, metal, xray, print");
  EXPECT_EQ(errorOf({ "view", "a.obj", "--style=ink", "--tone=gooch" }),
    "--style and --tone exclude each other; give one");
}

TEST(Arguments, WhatAStyleDoesNotShowIsRefused)
{
  const auto error = [](const std::string& style, const std::string& option) {
    return renderErrorOf({ "--style=" + style, option });
  };
  EXPECT_EQ(error("ink", "--color=1,0,0"), "--style=ink does not show --color; leave it out");
  EXPECT_EQ(error("ink", "--shading=flat"), "--style=ink does not show --shading; leave it out");
  EXPECT_EQ(error("ink", "--feature-angle=20"), "");
  EXPECT_EQ(error("toon", "--color=1,0,0"), "");
  EXPECT_EQ(
    error("metal", "--procedural=wood"), "--style=metal does not show --procedural; leave it out");
  EXPECT_EQ(error("technical", "--light=headlight"),
    "--style=technical does not show --light; leave it out");
  EXPECT_EQ(errorOf({ "view", "a.obj", "--style=ink", "--color=1,0,0" }), "")
    << "a key changes the style";
}

TEST(Arguments, LineOptionsThatWouldShowNothingAreRefused)
{
  const struct
  {
    std::vector<std::string> options;
    std::string error;
  } cases[] = {
    { { "--stroke-width=2" }, "--stroke-width needs lines; add --lines=crease or another kind" },
    { { "--hidden-lines=thin" }, "--hidden-lines needs lines; add --lines=crease or another kind" },
    { { "--lines=border", "--crease-angle=20" },
      "--crease-angle needs --lines=crease, contour, hatch, terminator or shadow" },
    { { "--lines=border", "--shortest-crease=3" }, "--shortest-crease needs --lines=crease" },
    { { "--lines=crease", "--shortest-crease=0" },
      "--shortest-crease=0 is not a whole number from 1 to 1000000" },
    { { "--style=gooch", "--shortest-crease=3" },
      "--style=gooch does not show --shortest-crease; leave it out" },
    { { "--lines=terminator" }, "--lines=terminator needs a light beside the camera; add "
                                "--light=directional:1,-1,-1:1,1,1" },
    { { "--lines=shadow", "--light=headlight" },
      "--lines=shadow needs a light beside the camera; add --light=directional:1,-1,-1:1,1,1" },
    { { "--lines=border", "--line-lights=all" },
      "--line-lights needs --lines=terminator or --lines=shadow" },
    { { "--lines=border", "--ridge-threshold=1" },
      "--ridge-threshold needs --lines=ridge or --lines=valley" },
    { { "--lines=ridge", "--suggestive-threshold=1" },
      "--suggestive-threshold needs --lines=suggestive" },
    { { "--lines=ridge", "--ridge-threshold=-1" }, "--ridge-threshold=-1 is negative" },
    { { "--lines=ridge", "--ridge-threshold=nan" },
      "--ridge-threshold=nan is not a finite number, as in --ridge-threshold=1.5" },
    { { "--lines=border", "--ids-array=part" }, "--ids-array needs --lines=ids or --outline-ids" },
    { { "--outline=hull", "--outline-ids" }, "--outline-ids needs --outline=image" },
    { { "--lines=border", "--dpi=300" },
      "--dpi needs a length in pt or mm, as in --stroke-width=1pt, or --style=print" },
    { { "--lines=crease,edges" },
      "--lines=edges is unknown; choose one of: crease, border, non-manifold, ids, normals, "
      "contour, silhouette, ridge, valley, suggestive, hatch, terminator, shadow, "
      "intersections" },
    { { "--lines=border", "--hatch-width=0.5" },
      "--hatch-width needs --lines=hatch, --style=ink or --style=pencil" },
    { { "--lines=hatch", "--hatch-width=200" },
      "--hatch-width=200 of strokes 1.5 pixels wide is more than 256 pixels" },
    { { "--lines=hatch", "--hatch-width=0" }, "--hatch-width=0 is not from 0.01 to 256" },
    { { "--lines=hatch", "--hatch-ink=1,0,0" }, "--hatch-ink needs --tone=hatching" },
    { { "--lines=crease,crease" }, "--lines=crease,crease names a kind twice; name it once" },
    { { "--lines=border", "--stroke-width=0" }, "--stroke-width=0 is not greater than 0" },
    { { "--lines=border", "--stroke-width=2in" },
      "--stroke-width=2in is not a length above 0 and up to 256 pixels, as in 2, 1.5px, 3pt or "
      "0.5mm; the units of lengths are px, pt and mm" },
    { { "--lines=border", "--stroke-width=3mmm" },
      "--stroke-width=3mmm is not a length above 0 and up to 256 pixels, as in 2, 1.5px, 3pt or "
      "0.5mm; the units of lengths are px, pt and mm" },
    { { "--lines=border", "--stroke-width=1e38mm" },
      "--stroke-width=1e38mm: 1e38mm is not from -1e30 to 1e30, as all numbers have to be" },
    { { "--lines=border", "--stroke-width=300px" },
      "--stroke-width=300px is greater than 256 pixels" },
    { { "--lines=border", "--stroke-width=257" }, "--stroke-width=257 is greater than 256 pixels" },
    { { "--lines=border", "--stroke-width=100mm" },
      "--stroke-width=100mm is 283.465 pixels at 72 dpi; at most 256 are possible" },
    { { "--lines=border", "--stroke-width=72pt", "--dpi=300" },
      "--stroke-width=72pt is 300 pixels at 300 dpi; at most 256 are possible" },
    { { "--lines=border", "--stroke-taper=-1" },
      "--stroke-taper=-1 is not from 0 to 16384 pixels" },
    { { "--lines=border", "--stroke-taper=1e9" },
      "--stroke-taper=1e9 is not from 0 to 16384 pixels" },
    { { "--lines=border", "--stroke-taper=16384" }, "" },
    { { "--lines=border", "--stroke-taper=1e6mm" },
      "--stroke-taper=1e+06mm is 2.83465e+06 pixels at 72 dpi; at most 16384 are possible" },
    { { "--lines=border", "--stroke-dash=3,0" },
      "--stroke-dash=3,0: dash and gap have to be above 0" },
    { { "--lines=border", "--stroke-dash=0.1mm,0.1pt", "--dpi=50" },
      "--stroke-dash=0.1mm,0.1pt is 0.266295 pixels; dash and gap have to be half a pixel "
      "together" },
    { { "--lines=border", "--stroke-dash=1e-9,1e-9" },
      "--stroke-dash=1e-9,1e-9: dash and gap have to be half a pixel together" },
    { { "--lines=border", "--stroke-dash=6,30deg" },
      "--stroke-dash=6,30deg is not two lengths with a comma between them, as in "
      "--stroke-dash=6,3 or --stroke-dash=2mm,1mm; the units of lengths are px, pt and mm" },
    { { "--lines=border", "--stroke-width=30deg" },
      "--stroke-width=30deg is not a length above 0 and up to 256 pixels, as in 2, 1.5px, 3pt or "
      "0.5mm; the units of lengths are px, pt and mm" },
    { { "--lines=crease," }, "--lines=crease, has a comma without a kind on both sides" },
    { { "--lines=,crease" }, "--lines=,crease has a comma without a kind on both sides" },
    { { "--lines=border", "--stroke-dash=3mm" },
      "--stroke-dash=3mm is not two lengths with a comma between them, as in --stroke-dash=6,3 or "
      "--stroke-dash=2mm,1mm" },
    { { "--lines=border", "--stroke-taper=2cm" },
      "--stroke-taper=2cm is not a length from 0 to 16384 pixels, as in 2, 1.5px, 3pt or 0.5mm; "
      "the units of lengths are px, pt and mm" },
    { { "--outline=hull", "--outline-width=30mm" },
      "--outline-width=30mm is 85.0394 pixels at 72 dpi; at most 64 are possible" },
    { { "--outline=hull", "--outline-width=1e-9" },
      "--outline-width=1e-9 is not from 0.01 to 64 pixels, or 0" },
    { { "--outline=hull", "--outline-width=1e-9mm" },
      "--outline-width=1e-09mm is 2.83465e-09 pixels at 72 dpi; at least 0.01 are needed, or 0" },
    { { "--outline=hull", "--outline-width=0.01" }, "" },
    { { "--outline=hull", "--outline-width=0" }, "" },
    { { "--outline=hull", "--outline-width=0mm", "--dpi=300" }, "" },
    { { "--outline=hull", "--outline-width=-1pt" },
      "--outline-width=-1pt is not from 0.01 to 64 pixels, or 0" },
    { { "--lines=border", "--outer-width=300" }, "--outer-width=300 is greater than 256" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf(one.options), one.error);
  }
}

TEST(Arguments, DepthCuesAreRead)
{
  const CueSettings cues =
    parseRender({ "--edl=1.5", "--edl-radius=0.002", "--depth-unsharp=0.4",
                  "--depth-unsharp-mode=both", "--depth-unsharp-radius=0.03", "--halo=0.7mm",
                  "--halo-depth=2", "--halo-color=1,0,0", "--dpi=300" })
      .scene.cues;
  EXPECT_EQ(cues.eyeDome, 1.5);
  EXPECT_EQ(cues.eyeDomeRadius, 0.002);
  EXPECT_EQ(cues.unsharp, 0.4);
  EXPECT_EQ(cues.unsharpMode, UnsharpMode::Both);
  EXPECT_EQ(cues.unsharpRadius, 0.03);
  EXPECT_EQ(cues.halo->value, 0.7);
  EXPECT_EQ(cues.halo->unit, 2);
  EXPECT_EQ(cues.haloDepth, 2);
  EXPECT_EQ(*cues.haloColor, (Color{ 1, 0, 0 }));
  EXPECT_FALSE(parseRender({}).scene.cues.eyeDome.has_value());
  EXPECT_EQ(renderErrorOf({ "--style=ink", "--edl=1" }), "");
  EXPECT_EQ(renderErrorOf({ "--halo=4", "--opacity=0.5" }),
    "--halo needs an opaque surface; leave out --opacity");
  const struct
  {
    const char* option;
    std::string error;
  } cases[] = {
    { "--edl=-1", "--edl=-1 is not from 0 to 100" },
    { "--edl=nan", "--edl=nan is not a number from 0 to 100" },
    { "--edl-radius=0.002", "--edl-radius needs --edl" },
    { "--depth-unsharp=1.1", "--depth-unsharp=1.1 is not from 0 to 1" },
    { "--depth-unsharp-mode=both", "--depth-unsharp-mode needs --depth-unsharp" },
    { "--depth-unsharp-radius=0", "--depth-unsharp-radius=0 is not above 0, at most 0.1" },
    { "--depth-unsharp-radius=0.05", "--depth-unsharp-radius needs --depth-unsharp" },
    { "--halo=0", "--halo=0 is not greater than 0" },
    { "--halo=65", "--halo=65 is greater than 64 pixels" },
    { "--halo-depth=2", "--halo-depth needs --halo" },
    { "--halo-depth=0", "--halo-depth=0 is not greater than 0" },
    { "--halo-color=1,1,1", "--halo-color needs --halo" },
    { "--halo=1e300", "--halo=1e300 is greater than 64 pixels" },
    { "--halo=1e400px", "--halo=1e400px is greater than 64 pixels" },
    { "--halo=65pt", "--halo=65pt is 65 pixels at 72 dpi; at most 64 are possible" },
    { "--edl=1e300", "--edl=1e300 is not from 0 to 100" },
    { "--edl-radius=1e-46",
      "--edl-radius=1e-46 is nearer to 0 than 1e-30, the smallest number here" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf({ one.option }), one.error);
  }
}

TEST(Arguments, ReflectionOptionsThatWouldShowNothingAreRefused)
{
  const struct
  {
    std::vector<std::string> options;
    std::string error;
  } cases[] = {
    { { "--roughness=0.5" }, "--roughness needs --reflection=oren-nayar or --reflection=metallic" },
    { { "--metallic=1", "--reflection=oren-nayar" }, "--metallic needs --reflection=metallic" },
    { { "--fresnel", "--reflection=lambert" },
      "--fresnel needs --reflection=blinn-phong, phong or irradiance" },
    { { "--refractive-index=1.3" }, "--refractive-index needs --fresnel or --reflection=metallic" },
    { { "--refractive-index=1,2,3", "--reflection=metallic" },
      "--refractive-index of --reflection=metallic is one number; a metal's colour is its "
      "--color" },
    { { "--rim=1,1,1", "--reflection=none" },
      "--rim needs another --reflection than none or metallic" },
    { { "--rim-power=2" }, "--rim-power needs --rim=r,g,b" },
    { { "--model=2", "--reflection=blinn-phong" },
      "--model and --reflection exclude each other; give one" },
    { { "--model=4", "--fresnel" }, "--fresnel and --model exclude each other; give one" },
    { { "--model=1", "--rim=1,1,1" }, "--rim and --model exclude each other; give one" },
    { { "--model=1", "--tone=gooch" }, "--model and --tone exclude each other; give one" },
    { { "--rim=1,1,1", "--tone=gooch" }, "--rim and --tone exclude each other; give one" },
    { { "--fresnel", "--tone=gooch-chapter" },
      "--fresnel and --tone exclude each other; give one" },
    { { "--opacity=-0.1" }, "--opacity=-0.1 is not from 0 to 1" },
    { { "--opacity=nan" }, "--opacity=nan is not a number from 0 to 1" },
    { { "--roughness=1.5", "--reflection=oren-nayar" }, "--roughness=1.5 is not from 0 to 1" },
    { { "--refractive-index=0.9", "--fresnel" },
      "--refractive-index=0.9 is not at least 1, the index of air" },
    { { "--rim=-1,0,0" },
      "--rim=-1,0,0 is not a colour of three numbers of at least 0, as in --rim=1,0.5,0" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf(one.options), one.error);
  }
  EXPECT_NE(renderErrorOf({ "--model=6" }), "");
}

TEST(Arguments, TexturesAreRead)
{
  const TextureSettings texture =
    parseRender({ "--texture=a.png", "--texture-role=shaded", "--texture-mode=decal",
                  "--texture-filter=trilinear", "--texture-wrap=mirror", "--anisotropy=8",
                  "--bump=b.png", "--bump-scale=-0.5", "--normal-map=c.png", "--lightmap=d.png",
                  "--procedural=wood", "--procedural-scale=4" })
      .scene.texture;
  EXPECT_EQ(texture.image, "a.png");
  EXPECT_EQ(texture.role, TextureRole::Shaded);
  EXPECT_EQ(texture.mode, TextureMode::Decal);
  EXPECT_EQ(texture.filter, TextureFilter::Trilinear);
  EXPECT_EQ(texture.wrap, TextureWrap::Mirror);
  EXPECT_EQ(texture.anisotropy, 8);
  EXPECT_EQ(texture.bump, "b.png");
  EXPECT_EQ(texture.bumpScale, -0.5);
  EXPECT_EQ(texture.normalMap, "c.png");
  EXPECT_EQ(texture.lightmap, "d.png");
  EXPECT_EQ(texture.procedural, Procedural::Wood);
  EXPECT_EQ(texture.proceduralScale, 4);
}

TEST(Arguments, TextureOptionsThatWouldShowNothingAreRefused)
{
  const struct
  {
    std::vector<std::string> options;
    std::string error;
  } cases[] = {
    { { "--texture-mode=add" }, "--texture-mode needs --texture=FILE or --procedural=NAME" },
    { { "--texture-role=shaded", "--bump=a.png" },
      "--texture-role needs --texture=FILE or --procedural=NAME" },
    { { "--texture-filter=nearest" }, "--texture-filter needs an image; add --texture=FILE" },
    { { "--anisotropy=4", "--texture=a.png", "--texture-filter=bilinear" },
      "--anisotropy needs --texture-filter=trilinear" },
    { { "--bump-scale=2" }, "--bump-scale needs --bump=FILE" },
    { { "--procedural-scale=2" }, "--procedural-scale needs --procedural=NAME" },
    { { "--procedural=granite" },
      "--procedural=granite is unknown; choose one of: none, checker, wood, marble" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf(one.options), one.error);
  }
  EXPECT_NE(renderErrorOf({ "--texture=a.png", "--anisotropy=17" }), "");
  EXPECT_NE(renderErrorOf({ "--procedural=wood", "--procedural-scale=0" }), "");
}

TEST(Arguments, LightsKeepTheirOrder)
{
  const auto lights = parseRender(
    { "--light=directional:0,-1,0:2,2,2", "--light=point:1,2,3:9,8,7",
      "--light=spot:0,0,5:0,0,-1:20:4:1,1,0", "--light=headlight", "--ambient-light=0.2,0.3,0.4" })
                        .scene.lights;
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].kind, LightKind::Directional);
  EXPECT_EQ(lights[0].direction, (Vector3{ 0, -1, 0 }));
  EXPECT_EQ(lights[0].color, (Color{ 2, 2, 2 }));
  EXPECT_EQ(lights[1].kind, LightKind::Point);
  EXPECT_EQ(lights[1].position, (Vector3{ 1, 2, 3 }));
  EXPECT_EQ(lights[1].color, (Color{ 9, 8, 7 }));
  EXPECT_EQ(lights[2].kind, LightKind::Spot);
  EXPECT_EQ(lights[2].position, (Vector3{ 0, 0, 5 }));
  EXPECT_EQ(lights[2].direction, (Vector3{ 0, 0, -1 }));
  EXPECT_EQ(lights[2].coneDegrees, 20);
  EXPECT_EQ(lights[2].exponent, 4);
  EXPECT_EQ(lights[2].color, (Color{ 1, 1, 0 }));
  EXPECT_EQ(lights[3].kind, LightKind::Headlight);
}

TEST(Arguments, LightsWithAShapePowerOrSoftEdgeAreRead)
{
  const auto lights = parseRender(
    { "--light=point:1,2,3:9,8,7:0.5,0,2", "--light=point:1,2,3:power=9,8,7",
      "--light=spot:0,0,5:0,0,-1:20:4:1,1,0:7.5", "--light=rectangle:1,2,3:2,0,0:0,0,4:1,2,3",
      "--light=sphere:1,2,3:0.5:power=4,5,6:99",
      "--light=rectangle:1,2,3:2,0,0:0,0,4:power=1,2,3:1" })
                        .scene.lights;
  ASSERT_EQ(lights.size(), 6u);
  EXPECT_EQ(lights[0].attenuation, (Vector3{ 0.5, 0, 2 }));
  EXPECT_FALSE(lights[0].isPower);
  EXPECT_TRUE(lights[1].isPower);
  EXPECT_EQ(lights[1].color, (Color{ 9, 8, 7 }));
  EXPECT_EQ(lights[1].attenuation, (Vector3{ 0, 0, 1 }));
  EXPECT_EQ(lights[2].softDegrees, 7.5);
  EXPECT_EQ(lights[3].kind, LightKind::Rectangle);
  EXPECT_EQ(lights[3].sides[0], (Vector3{ 2, 0, 0 }));
  EXPECT_EQ(lights[3].sides[1], (Vector3{ 0, 0, 4 }));
  EXPECT_EQ(lights[3].samples, 16);
  EXPECT_EQ(lights[4].kind, LightKind::Sphere);
  EXPECT_EQ(lights[4].radius, 0.5);
  EXPECT_TRUE(lights[4].isPower);
  EXPECT_EQ(lights[4].samples, 99);
  EXPECT_EQ(lights[5].samples, 1);
}

TEST(Arguments, LightsThatCannotBeAreRefused)
{
  for (const std::string light : { "point:1,2,3:1,1,1:0,0,0", "point:1,2,3:1,1,1:-1,0,1",
         "point:1,2,3:power=1,1,1:1,0,0", "point:1,2,3:power=1,1", "directional:0,0,1:power=1,1,1",
         "spot:0,0,5:0,0,-1:20:4:1,1,0:21", "spot:0,0,5:0,0,-1:20:4:1,1,0:-1",
         "rectangle:1,2,3:2,0,0:1,0,4:1,2,3", "rectangle:1,2,3:2,0,0:0,0,0:1,2,3",
         "rectangle:1,2,3:2,0,0:0,0,4:1,2,3:0", "sphere:1,2,3:0:1,1,1",
         "sphere:1,2,3:1:1,1,1:70000", "sphere:1,2,3:1:1,1,1:1.5", "headlight:1,1,1" })
  {
    EXPECT_EQ(renderErrorOf({ "--light=" + light }).rfind("--light=" + light + " is not ", 0), 0u)
      << renderErrorOf({ "--light=" + light });
  }
}

TEST(Arguments, NormalsAndFlatPointAreRead)
{
  const MaterialSettings smooth =
    parseRender({ "--normals=angle", "--feature-angle=30" }).scene.material;
  EXPECT_EQ(smooth.normals, Normals::Angle);
  EXPECT_EQ(smooth.featureAngleDegrees, 30);
  const MaterialSettings flat =
    parseRender({ "--shading=flat", "--flat-point=first-vertex" }).scene.material;
  EXPECT_EQ(flat.flatPoint, FlatPoint::FirstVertex);
  EXPECT_EQ(renderErrorOf({ "--flat-point=centroid" }), "--flat-point needs --shading=flat");
  EXPECT_EQ(renderErrorOf({ "--shading=flat", "--normals=area" }),
    "--normals and --shading=flat exclude each other; give one");
  EXPECT_EQ(renderErrorOf({ "--shading=flat", "--feature-angle=3" }),
    "--feature-angle and --shading=flat exclude each other; give one");
  EXPECT_EQ(
    renderErrorOf({ "--feature-angle=181" }), "--feature-angle=181 is not from 0 to 180 degrees");
}

TEST(Arguments, PictureAndColoringAreRead)
{
  const RenderSettings settings = parseRender({ "--resolution=64,48", "--samples=2", "--threads=3",
    "--window=gl", "--stats", "--no-background", "--coloring-array=height", "--colormap=cool-warm",
    "--coloring-range=-1,2" });
  EXPECT_EQ(settings.scene.resolution, (std::array<int, 2>{ 64, 48 }));
  EXPECT_EQ(settings.scene.samples, 2);
  EXPECT_EQ(settings.scene.threads, 3);
  EXPECT_EQ(settings.window, Window::Gl);
  EXPECT_TRUE(settings.stats);
  EXPECT_TRUE(settings.transparentBackground);
  EXPECT_EQ(settings.scene.coloring.array, "height");
  EXPECT_EQ(settings.scene.coloring.colormap, "cool-warm");
  EXPECT_EQ(settings.scene.coloring.range, (std::array<double, 2>{ -1, 2 }));
  EXPECT_EQ(parseRender({ "--background-color=1,0,0.5" }).scene.background, (Color{ 1, 0, 0.5 }));
}

TEST(Arguments, TonesOverDataAndTheirNumbers)
{
  const MaterialSettings none = parseRender({ "--tone=gooch" }).scene.material;
  EXPECT_FALSE(none.toneOverData || none.undertone || none.legendSafeRange);
  const MaterialSettings undertone =
    parseRender({ "--tone=gooch", "--tone-over-data=undertone", "--undertone=0.12" })
      .scene.material;
  EXPECT_EQ(undertone.toneOverData, ToneOverData::Undertone);
  EXPECT_EQ(undertone.undertone, 0.12);
  const RenderSettings safe = parseRender({ "--tone=gooch-chapter", "--tone-over-data=legend-safe",
    "--legend-safe-range=6", "--coloring-array=height", "--tone-legend=legend.png" });
  EXPECT_EQ(safe.scene.material.toneOverData, ToneOverData::LegendSafe);
  EXPECT_EQ(safe.scene.material.legendSafeRange, 6);
  EXPECT_EQ(safe.toneLegend, "legend.png");
  EXPECT_EQ(parseRender({ "--tone=gooch", "--tone-over-data=classic" }).scene.material.toneOverData,
    ToneOverData::Classic);
}

TEST(Arguments, TonesOverDataThatWouldNotShowAreErrors)
{
  const std::pair<std::vector<std::string>, std::string> cases[] = {
    { { "--tone-over-data=undertone" },
      "--tone-over-data needs --tone=metal, exaggerated or one of gooch" },
    { { "--tone=toon", "--tone-over-data=legend-safe" },
      "--tone-over-data needs --tone=metal, exaggerated or one of gooch" },
    { { "--tone=gooch", "--undertone=0.2" }, "--undertone needs --tone-over-data=undertone" },
    { { "--tone=gooch", "--tone-over-data=undertone", "--legend-safe-range=3" },
      "--legend-safe-range needs --tone-over-data=legend-safe" },
    { { "--tone=gooch", "--tone-over-data=safe" },
      "--tone-over-data=safe is unknown; choose one of: classic, undertone, legend-safe" },
    { { "--undertone=1.5" }, "--undertone=1.5 is not from 0 to 1" },
    { { "--legend-safe-range=-1" }, "--legend-safe-range=-1 is not from 0 to 100" },
    { { "--legend-safe-range=nan" }, "--legend-safe-range=nan is not a number from 0 to 100" },
    { { "--tone=gooch", "--tone-legend=a.png" },
      "--tone-legend needs a tone and --coloring-array=NAME" },
    { { "--coloring-array=a", "--tone-legend=a.png" },
      "--tone-legend needs a tone and --coloring-array=NAME" },
    { { "--tone=gooch", "--coloring-array=a", "--tone-legend=a.jpg" },
      "--tone-legend=a.jpg is not a PNG file; name it a.png" },
  };
  for (const auto& [arguments, message] : cases)
  {
    EXPECT_EQ(renderErrorOf(arguments), message);
  }
}

TEST(Arguments, UnknownOptionsAreNamedWithTheHelpToRead)
{
  EXPECT_EQ(renderErrorOf({ "--foo" }), "unknown option --foo; see \"limn help render\"");
  EXPECT_EQ(renderErrorOf({ "--foo=3" }), "unknown option --foo; see \"limn help render\"");
  EXPECT_EQ(renderErrorOf({ "-x" }), "unknown option -x; see \"limn help render\"");
  EXPECT_EQ(errorOf({ "info", "a.obj", "--output=x.png" }),
    "unknown option --output; see \"limn help info\"");
  EXPECT_EQ(
    errorOf({ "draw" }), "unknown verb draw; choose one of: render, view, info, compare, help");
}

TEST(Arguments, OptionsOfLaterVersionsAreNamedAsSuch)
{
  for (const std::string option : { "--edges", "--line-width", "--point-size" })
  {
    const std::string expected = option + " is not served by this version; ";
    EXPECT_EQ(renderErrorOf({ option + "=1" }).substr(0, expected.size()), expected);
    EXPECT_EQ(renderErrorOf({ option }).substr(0, expected.size()), expected);
  }
}

TEST(Arguments, ValuesOfLaterVersionsAreNamedAsSuch)
{
  EXPECT_EQ(renderErrorOf({ "--reflection=mirror" }),
    "--reflection=mirror is unknown; choose one of: none, lambert, "
    "phong, blinn-phong, irradiance, oren-nayar, metallic");
  EXPECT_EQ(renderErrorOf({ "--tone=sepia" }),
    "--tone=sepia is unknown; choose one of: none, gooch, gooch-chapter, gooch-rtr4, "
    "gooch-orange-book, metal, toon, hatching, exaggerated");
  EXPECT_EQ(renderErrorOf({ "--outline=fuzzy" }),
    "--outline=fuzzy is unknown; choose one of: none, normal, hull, image");
}

TEST(Arguments, MisspelledValuesNameTheAllowedOnes)
{
  EXPECT_EQ(renderErrorOf({ "--shading=fong" }),
    "--shading=fong is unknown; choose one of: flat, gouraud, phong");
  EXPECT_EQ(renderErrorOf({ "--colormap=jet", "--coloring-array=a" }),
    "--colormap=jet is unknown; choose one of: viridis, cool-warm, rainbow, grayscale, "
    "black-body");
  EXPECT_EQ(renderErrorOf({ "--window=x11" }), "--window=x11 is unknown; choose one of: cpu, gl");
  EXPECT_EQ(
    renderErrorOf({ "--samples=3" }), "--samples=3 is unknown; choose one of: 1, 2, 4, 8, 16");
  EXPECT_EQ(
    renderErrorOf({ "--up=Y" }), "--up=Y is not an axis; choose one of: +X, -X, +Y, -Y, +Z, -Z");
}

class BadValue : public ::testing::TestWithParam<const char*>
{
};

TEST_P(BadValue, IsRefusedAndQuoted)
{
  const std::string option = GetParam();
  EXPECT_NE(renderErrorOf({ option }).find(option), std::string::npos) << renderErrorOf({ option });
}

INSTANTIATE_TEST_SUITE_P(Arguments, BadValue,
  ::testing::Values("--camera-position=nan,0,0", "--camera-position=1e31,0,0",
    "--camera-position=0,inf,0", "--camera-position=1,2", "--camera-position=1,2,3,4",
    "--camera-position=1,,3", "--camera-position=a,b,c", "--camera-position=1,2,3x",
    "--camera-view-up=0,0,0", "--camera-view-angle=0", "--camera-view-angle=180",
    "--camera-view-angle=nan", "--camera-parallel-scale=0", "--camera-parallel-scale=-1",
    "--color=-0.1,0,0", "--color=nan,0,0", "--color=1e300,0,0", "--color=red",
    "--background-color=0,0,1.5", "--specular-power=129", "--specular-power=-1",
    "--specular-power=inf", "--light=sun", "--light=headlight:1,1,1",
    "--light=directional:0,0,0:1,1,1", "--light=directional:0,0,1",
    "--light=directional:0,0,1:-1,0,0", "--light=point:0,0,nan:1,1,1",
    "--light=spot:0,0,0:0,0,1:0:1:1,1,1", "--light=spot:0,0,0:0,0,1:90:1:1,1,1",
    "--light=spot:0,0,0:0,0,1:30:-1:1,1,1", "--light=spot:0,0,0:0,0,1:30:1", "--ambient-light=1,2",
    "--coloring-range=1,1", "--coloring-range=2,1", "--coloring-range=0,nan", "--threads=0",
    "--threads=-2", "--threads=two", "--threads=1.5", "--opacity=x", "--output=", "--color="));

TEST(Arguments, NumbersOutOfRangeAreToldFromWhatIsNone)
{
  const std::string range = " is not from -1e30 to 1e30, as all numbers have to be";
  const std::string tiny = " is nearer to 0 than 1e-30, the smallest number here";
  const struct
  {
    std::string option;
    std::string error;
  } cases[] = {
    { "--camera-position=1,1e300,1", ": 1e300" + range },
    { "--camera-position=1,-1e400,1", ": -1e400" + range },
    { "--camera-position=1,1e-400,x", " is not three finite numbers, as in "
                                      "--camera-position=1,0,-2.5" },
    { "--color=1e31,0,0", ": 1e31" + range },
    { "--bump-scale=1e300", ": 1e300" + range },
    { "--light=point:0,0,0:power=1e300,1,1", ": 1e300" + range },
    { "--coloring-range=0,1e300", ": 1e300" + range },
    { "--stroke-dash=1e300,1", ": 1e300" + range },
    { "--bump-scale=inf", " is not a finite number, as in --bump-scale=1.5" },
    { "--bump-scale=1e300x", " is not a finite number, as in --bump-scale=1.5" },
    { "--stroke-width=1e300", " is greater than 256 pixels" },
    { "--stroke-width=1" + std::string(400, '0'), " is greater than 256 pixels" },
    { "--stroke-width=0." + std::string(400, '0') + "1", tiny },
    { "--stroke-width=1e-40", tiny },
    { "--stroke-width=1e-400mm", tiny },
    { "--stroke-width=1" + std::string(400, '0') + "e-50", " is greater than 256 pixels" },
    { "--stroke-width=0." + std::string(400, '0') + "1e20", tiny },
    { "--stroke-width=-1e-400", " is not greater than 0" },
    { "--stroke-dash=1e-40,1", tiny },
    { "--camera-parallel-scale=1e-320", tiny },
    { "--camera-view-angle=1e-46", tiny },
    { "--camera-view-angle=1e300", " is not between 0 and 180 degrees" },
    { "--opacity=1e300", " is not from 0 to 1" },
    { "--exposure=1e300", " is not from 0 to 65504" },
    { "--procedural-scale=1e300", " is greater than 1e6" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf({ one.option }), one.option + one.error);
  }
}

TEST(Arguments, FactorsOfLightMayExceed1AndColorsOfThePictureMayNot)
{
  for (const std::string option :
    { "--color", "--ambient", "--diffuse", "--specular", "--cool", "--warm", "--ambient-light" })
  {
    EXPECT_EQ(renderErrorOf({ option + "=300,0,0", "--tone=gooch" }), "") << option;
  }
  for (const std::string option : { "--background-color", "--outline-color" })
  {
    EXPECT_NE(renderErrorOf({ option + "=300,0,0" }).find("from 0 to 1"), std::string::npos)
      << option;
  }
}

TEST(Arguments, ValuesOfImageLinesHaveTheirRanges)
{
  const std::string image = "--outline=image";
  EXPECT_EQ(renderErrorOf({ image, "--opacity=0.5" }),
    "--outline=image needs an opaque surface; leave out --opacity, or take --outline=hull or "
    "--lines=contour");
  EXPECT_EQ(renderErrorOf({ image, "--outline-width=65" }),
    "--outline-width=65 is not from 0.01 to 64 pixels, or 0");
  EXPECT_EQ(
    renderErrorOf({ image, "--outline-opacity=1.5" }), "--outline-opacity=1.5 is not from 0 to 1");
  EXPECT_EQ(
    renderErrorOf({ image, "--outline-tolerance=-1" }), "--outline-tolerance=-1 is negative");
  EXPECT_EQ(renderErrorOf({ image, "--outline-crease-angle=181" }),
    "--outline-crease-angle=181 is not from 0 to 180 degrees");
  EXPECT_EQ(renderErrorOf({ image, "--outline-detector=canny" }),
    "--outline-detector=canny is unknown; choose one of: plane, sobel, laplacian");
  EXPECT_EQ(renderErrorOf({ image, "--outline-crease-detector=plane" }),
    "--outline-crease-detector=plane is unknown; choose one of: angle, sobel, laplacian");
}

TEST(Arguments, ErrorsSayWhatIsAccepted)
{
  const struct
  {
    std::string option;
    std::string error;
  } cases[] = {
    { "--crease-angle=30deg", " is not a number from 0 to 180 degrees; write 30, without a unit" },
    { "--crease-angle=30\xC2\xB0",
      " is not a number from 0 to 180 degrees; write 30, without a unit" },
    { "--crease-angle=sharp", " is not a number from 0 to 180 degrees" },
    { "--crease-angle=inf", " is not a number from 0 to 180 degrees" },
    { "--camera-view-angle=45deg",
      " is not a number between 0 and 180 degrees; write 45, without a unit" },
    { "--opacity=50%", " is not a number from 0 to 1" },
    { "--edl-radius=nan", " is not a number above 0, at most 0.02" },
    { "--exposure=bright", " is not a number from 0 to 65504" },
    { "--procedural-scale=inf", " is not a number above 0, at most 1e6" },
    { "--dpi=1e9", " is not a whole number from 1 to 100000" },
    { "--dpi=300dpi", " is not a whole number from 1 to 100000; write 300, without a unit" },
    { "--dpi=72.5", " is not a whole number from 1 to 100000" },
    { "--halo=inf", " is not a length above 0 and up to 64 pixels, as in 2, 1.5px, 3pt or 0.5mm" },
    { "--halo=4PX",
      " is not a length above 0 and up to 64 pixels, as in 2, 1.5px, 3pt or 0.5mm; write 4px" },
    { "--outline-width=wide",
      " is not a length from 0.01 to 64 pixels, or 0, as in 2, 1.5px, 3pt or 0.5mm" },
    { "--tone=GOOCH", " is unknown; write it in small letters: --tone=gooch" },
    { "--light=Point:0,0,0:1,1,1", " is not a light; write its kind in small letters: point" },
    { "--light=HEADLIGHT", " is not a light; write it in small letters: headlight" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf({ one.option }), one.option + one.error);
  }
  EXPECT_EQ(renderErrorOf({ "--lines=border,Crease" }),
    "--lines=Crease is unknown; write it in small letters: --lines=crease");
  const std::string cone = renderErrorOf({ "--light=spot:0,0,9:0,0,-1:30deg:1:1,1,1" });
  EXPECT_NE(cone.find("; write 30, without a unit"), std::string::npos) << cone;
  EXPECT_EQ(
    renderErrorOf({ "--Tone=gooch" }), "unknown option --Tone; write it in small letters: --tone");
  EXPECT_EQ(
    errorOf({ "Render", "a.obj" }), "unknown verb Render; write it in small letters: render");
}

TEST(Arguments, WholeNumbersMayBeWrittenAsOthers)
{
  const SceneSettings scene =
    parseRender({ "--resolution=1e3,600.0", "--lines=border", "--stroke-width=1pt", "--dpi=3e2" })
      .scene;
  EXPECT_EQ(scene.resolution, (std::array<int, 2>{ 1000, 600 }));
  EXPECT_EQ(scene.pixelsPerInch, 300);
}

TEST(Arguments, ResolutionMustBePositiveAndBounded)
{
  for (const std::string text : { "0,10", "10,-1", "10", "10,20,30", "16385,10", "1e5,10", "x,y" })
  {
    EXPECT_NE(renderErrorOf({ "--resolution=" + text }), "") << text;
  }
}

TEST(Arguments, AnOptionIsGivenOnce)
{
  EXPECT_EQ(
    renderErrorOf({ "--samples=2", "--samples=4" }), "--samples is given twice; give it once");
}

TEST(Arguments, SwitchesTakeNoValue)
{
  EXPECT_EQ(renderErrorOf({ "--stats=yes" }), "--stats=yes: --stats takes no value");
}

TEST(Arguments, FilesAfterTheMarkMayLookLikeOptions)
{
  const auto request = parseArguments({ "info", "--", "-a.obj" });
  EXPECT_EQ(std::get<InfoRequest>(request).meshes, Words{ "-a.obj" });
}

TEST(Arguments, WhatIsMissingIsNamed)
{
  EXPECT_EQ(errorOf({}), "no verb is named; see \"limn help\"");
  EXPECT_EQ(errorOf({ "render", "--output=x.png" }),
    "no mesh is named; give one, as in: limn render teapot.obj --output=teapot.png");
  EXPECT_EQ(errorOf({ "view" }), "no mesh is named; give one, as in: limn view teapot.obj");
  EXPECT_EQ(errorOf({ "info" }), "no mesh is named; give one, as in: limn info teapot.obj");
  EXPECT_EQ(errorOf({ "render", "a.obj" }), "no output is named; add --output=FILE.png");
  for (const std::string map :
    { "--output-ids=x.png", "--output-depth=x.png", "--output-normals=x.png" })
  {
    EXPECT_EQ(errorOf({ "render", "a.obj", map }), "");
  }
  EXPECT_NE(errorOf({ "render", "a.obj", "--output" }).find("--output"), std::string::npos);
  EXPECT_EQ(errorOf({ "compare", "a.png" }),
    "compare takes two pictures, got 1; as in: limn compare A.png B.png");
}

TEST(Arguments, OutputMustBePng)
{
  EXPECT_EQ(errorOf({ "render", "a.obj", "--output=out/x.jpg" }),
    "--output=out/x.jpg is not a PNG file; name it out/x.png");
  EXPECT_EQ(
    errorOf({ "render", "a.obj", "--output=x" }), "--output=x is not a PNG file; name it x.png");
  EXPECT_EQ(errorOf({ "render", "a.obj", "--output=x.PNG" }), "");
  EXPECT_EQ(errorOf({ "render", "a.obj", "--output=out/" }),
    "--output=out/ names a folder; add a file's name, as in out/picture.png");
}

TEST(Arguments, OptionsThatNeedOrExcludeEachOther)
{
  EXPECT_NE(renderErrorOf({ "--colormap=viridis" }).find("--coloring-array"), std::string::npos);
  EXPECT_NE(renderErrorOf({ "--cool=0,0,1" }).find("--cool needs a tone"), std::string::npos);
  EXPECT_NE(renderErrorOf({ "--warm=1,1,0", "--tone=none" }).find("--warm needs a tone"),
    std::string::npos);
  for (const std::string option :
    { "--outline-color=1,0,0", "--outline-width=3", "--outline-opacity=0.5" })
  {
    EXPECT_EQ(renderErrorOf({ option }),
      option.substr(0, option.find('=')) + " needs --outline=normal, hull or image");
  }
  for (const std::string option : { "--outline-detector=sobel", "--outline-tolerance=2",
         "--outline-crease-angle=30", "--outline-crease-detector=sobel" })
  {
    EXPECT_EQ(renderErrorOf({ option, "--outline=normal" }),
      option.substr(0, option.find('=')) + " needs --outline=image");
    EXPECT_EQ(renderErrorOf({ option, "--outline=image" }), "");
  }
  EXPECT_EQ(renderErrorOf({ "--output-depth=a.png", "--window=gl" }),
    "an OpenGL window keeps no normals, depth and ids to write; leave out --window=gl");
  EXPECT_EQ(renderErrorOf({ "--output-ids=x.png", "--output-normals=x.png" }),
    "--output-normals and --output-ids name the same file x.png; choose two");
  EXPECT_EQ(
    renderErrorOf({ "--output-ids=a.jpg" }), "--output-ids=a.jpg is not a PNG file; name it a.png");
  EXPECT_EQ(errorOf({ "view", "a.obj", "--cool=0,0,1", "--outline-color=1,0,0" }), "");
  EXPECT_NE(renderErrorOf({ "--coloring-range=0,1" }).find("--coloring-array"), std::string::npos);
  EXPECT_NE(renderErrorOf({ "--camera-parallel-scale=1" }).find("--camera-orthographic"),
    std::string::npos);
  EXPECT_NE(renderErrorOf({ "--no-background", "--background-color=0,0,0" }), "");
  EXPECT_NE(renderErrorOf({ "--camera-position=1,1,1", "--camera-focal-point=1,1,1" }), "");
}

TEST(Arguments, TonesAndOutlinesHaveTheirNumbers)
{
  const MaterialSettings toon =
    parseRender({ "--tone=toon", "--toon-steps=5", "--reflection=oren-nayar", "--roughness=0.7",
                  "--outline=normal", "--outline-width=2.5", "--outline-opacity=0.4" })
      .scene.material;
  EXPECT_EQ(toon.tone, Tone::Toon);
  EXPECT_EQ(toon.toonSteps, 5);
  EXPECT_EQ(toon.outlineWidth->value, 2.5);
  EXPECT_EQ(toon.outlineWidth->unit, 0);
  EXPECT_EQ(toon.outlineOpacity, 0.4);
  EXPECT_EQ(parseRender({ "--tone=gooch", "--tone-light=upper-right" }).scene.material.toneLight,
    ToneLight::UpperRight);
  const MaterialSettings ramp =
    parseRender({ "--toon-ramp=a.png", "--toon-ramp-by=highlight", "--toon-ramp-exponent=4" })
      .scene.material;
  EXPECT_EQ(ramp.tone, Tone::Ramp);
  EXPECT_EQ(ramp.toonRamp, "a.png");
  EXPECT_EQ(ramp.rampBy, RampBy::Highlight);
  EXPECT_EQ(ramp.rampExponent, 4.0);
  EXPECT_EQ(parseRender({ "--toon-ramp=a.png", "--toon-ramp-range=1,4" }).scene.material.rampRange,
    (std::array<double, 2>{ 1, 4 }));
  EXPECT_EQ(parseRender({ "--matcap=a.png" }).scene.material.tone, Tone::MatCap);
}

TEST(Arguments, HatchLinesHaveTheirWidthAndDensity)
{
  const SceneSettings scene =
    parseRender({ "--lines=hatch,contour", "--hatch-width=0.4", "--hatch-spacing=4pt",
                  "--hatch-darkest=0.9", "--dpi=300" })
      .scene;
  EXPECT_EQ(scene.lines.kinds, (std::vector<LineKind>{ LineKind::Hatch, LineKind::Contour }));
  EXPECT_EQ(scene.lines.hatchWidth, 0.4);
  EXPECT_EQ(scene.material.hatchSpacing->unit, 1);
}

TEST(Arguments, HatchingHasItsStrokesAndColours)
{
  const MaterialSettings material =
    parseRender({ "--tone=hatching", "--hatch-spacing=1.5mm", "--hatch-darkest=0.5",
                  "--hatch-ink=1,0,0", "--hatch-paper=0,1,0", "--hatch-on=texture" })
      .scene.material;
  EXPECT_EQ(material.tone, Tone::Hatching);
  EXPECT_EQ(material.hatchSpacing->value, 1.5);
  EXPECT_EQ(material.hatchSpacing->unit, 2);
  EXPECT_EQ(material.hatchDarkest, 0.5);
  EXPECT_EQ(material.hatchInk, (Color{ 1, 0, 0 }));
  EXPECT_EQ(material.hatchPaper, (Color{ 0, 1, 0 }));
  EXPECT_EQ(material.hatchPlace, HatchPlace::Texture);
}

TEST(Arguments, ExaggerationHasItsScales)
{
  const MaterialSettings material =
    parseRender({ "--tone=exaggerated", "--exaggeration-contrast=8", "--exaggeration-exponent=-2",
                  "--exaggeration-base=0.1", "--exaggeration-levels=7", "--exaggeration-scale=0.05",
                  "--toon-steps=4", "--tone-light=upper-right", "--tone-over-data=legend-safe" })
      .scene.material;
  EXPECT_EQ(material.tone, Tone::Exaggerated);
  EXPECT_EQ(material.exaggeration.contrast, 8.0);
  EXPECT_EQ(material.exaggeration.exponent, -2.0);
  EXPECT_EQ(material.exaggeration.base, 0.1);
  EXPECT_EQ(material.exaggeration.levels, 7);
  EXPECT_EQ(material.exaggeration.scale, 0.05);
}

TEST(Arguments, TonesAndOutlinesThatWouldNotShowAreRefused)
{
  const struct
  {
    std::vector<std::string> options;
    const char* error;
  } cases[] = {
    { { "--hatch-spacing=4" },
      "--hatch-spacing needs --tone=hatching, --lines=hatch, --style=ink or --style=pencil" },
    { { "--tone=gooch", "--hatch-ink=1,0,0" }, "--hatch-ink needs --tone=hatching" },
    { { "--tone=hatching", "--hatch-darkest=1.5" }, "--hatch-darkest=1.5 is not from 0 to 1" },
    { { "--exaggeration-contrast=4" }, "--exaggeration-contrast needs --tone=exaggerated" },
    { { "--tone=gooch", "--exaggeration-scale=0.1" },
      "--exaggeration-scale needs --tone=exaggerated" },
    { { "--tone=exaggerated", "--exaggeration-contrast=-1" },
      "--exaggeration-contrast=-1 is not from 0 to 1000" },
    { { "--tone=exaggerated", "--exaggeration-exponent=5" },
      "--exaggeration-exponent=5 is not from -4 to 4" },
    { { "--tone=exaggerated", "--exaggeration-base=2" },
      "--exaggeration-base=2 is not from 0 to 1" },
    { { "--tone=exaggerated", "--exaggeration-levels=9" },
      "--exaggeration-levels=9 is not a whole number from 1 to 8" },
    { { "--tone=exaggerated", "--exaggeration-scale=0" },
      "--exaggeration-scale=0 is not from 0.0001 to 1" },
    { { "--tone=exaggerated", "--exaggeration-contrast=nan" },
      "--exaggeration-contrast=nan is not a number from 0 to 1000" },
    { { "--cool=0,0,1", "--tone=exaggerated" },
      "--cool needs a tone; add --tone=gooch or --tone=gooch-chapter" },
    { { "--cool=0,0,1", "--tone=hatching" },
      "--cool needs a tone; add --tone=gooch or --tone=gooch-chapter" },
    { { "--toon-steps=3" }, "--toon-steps needs --tone=toon, metal, exaggerated or one of gooch" },
    { { "--toon-steps=1", "--tone=toon" }, "--toon-steps=1 is not a whole number from 2 to 64" },
    { { "--toon-steps=65", "--tone=toon" }, "--toon-steps=65 is not a whole number from 2 to 64" },
    { { "--cool=0,0,1", "--tone=toon" },
      "--cool needs a tone; add --tone=gooch or --tone=gooch-chapter" },
    { { "--tone-light=scene", "--tone=toon" },
      "--tone-light needs --tone=gooch, hatching or exaggerated, --toon-ramp=FILE or "
      "--lines=hatch" },
    { { "--tone=gooch", "--matcap=a.png" }, "--matcap and --tone exclude each other; give one" },
    { { "--toon-ramp=b.png", "--matcap=a.png" },
      "--toon-ramp and --matcap exclude each other; give one" },
    { { "--toon-ramp-by=depth" }, "--toon-ramp-by needs --toon-ramp=FILE" },
    { { "--toon-ramp=a.png", "--toon-ramp-exponent=2" },
      "--toon-ramp-exponent needs --toon-ramp-by=silhouette or highlight" },
    { { "--toon-ramp=a.png", "--toon-ramp-by=highlight", "--toon-ramp-range=1,2" },
      "--toon-ramp-range needs --toon-ramp-by=depth" },
    { { "--toon-ramp=a.png", "--toon-ramp-range=0,2" },
      "--toon-ramp-range=0,2 is not a range above 0" },
    { { "--outline-width=2" }, "--outline-width needs --outline=normal, hull or image" },
    { { "--outline-opacity=0.5" }, "--outline-opacity needs --outline=normal, hull or image" },
    { { "--outline=normal", "--outline-width=-1" },
      "--outline-width=-1 is not from 0.01 to 64 pixels, or 0" },
    { { "--outline=normal", "--outline-opacity=2" }, "--outline-opacity=2 is not from 0 to 1" },
  };
  for (const auto& one : cases)
  {
    EXPECT_EQ(renderErrorOf(one.options), one.error);
  }
}

TEST(Arguments, ViewSharesTheSceneButHasNoOutput)
{
  const auto request = parseArguments({ "view", "a.obj", "--tone=gooch" });
  EXPECT_EQ(std::get<ViewRequest>(request).scene.material.tone, Tone::Gooch);
  EXPECT_EQ(errorOf({ "view", "a.obj", "--output=x.png" }),
    "unknown option --output; see \"limn help view\"");
}

TEST(Arguments, CompareTakesATolerance)
{
  const auto request = parseArguments({ "compare", "a.png", "b.png", "--tolerance=3" });
  const CompareSettings& settings = std::get<CompareRequest>(request).settings;
  EXPECT_EQ(settings.pictures, (std::array<std::string, 2>{ "a.png", "b.png" }));
  EXPECT_EQ(settings.tolerance, 3);
  EXPECT_NE(errorOf({ "compare", "a.png", "b.png", "--tolerance=-1" }), "");
  EXPECT_NE(errorOf({ "compare", "a.png", "b.png", "--tolerance=256" }), "");
}

TEST(Arguments, HelpListsEveryServedOption)
{
  const auto request = parseArguments({ "help", "render" });
  const std::string& text = std::get<HelpRequest>(request).text;
  for (const std::string option :
    { "--output", "--resolution", "--camera-position", "--camera-focal-point", "--camera-view-up",
      "--camera-view-angle", "--camera-orthographic", "--camera-parallel-scale", "--up", "--color",
      "--background-color", "--no-background", "--opacity", "--shading", "--flat-point",
      "--normals", "--feature-angle", "--reflection", "--tone", "--roughness", "--metallic",
      "--fresnel", "--refractive-index", "--rim", "--rim-power", "--model", "--texture",
      "--texture-role", "--texture-mode", "--texture-filter", "--texture-wrap", "--anisotropy",
      "--bump", "--bump-scale", "--normal-map", "--lightmap", "--procedural", "--procedural-scale",
      "--cool", "--warm", "--ambient", "--diffuse", "--specular", "--specular-power", "--light",
      "--ambient-light", "--outline", "--outline-color", "--outline-width", "--outline-opacity",
      "--toon-steps", "--tone-light", "--toon-ramp", "--toon-ramp-by", "--toon-ramp-exponent",
      "--toon-ramp-range", "--matcap", "--hatch-spacing", "--hatch-darkest", "--hatch-ink",
      "--hatch-paper", "--hatch-on", "--exaggeration-contrast", "--exaggeration-exponent",
      "--exaggeration-base", "--exaggeration-levels", "--exaggeration-scale", "--hatch-width",
      "--outline-detector", "--outline-tolerance", "--outline-crease-angle",
      "--outline-crease-detector", "--outline-ids", "--output-normals", "--output-depth",
      "--output-ids", "--coloring-array", "--colormap", "--coloring-range", "--samples",
      "--backface-culling", "--threads", "--window", "--stats" })
  {
    EXPECT_NE(text.find("  " + option + " "), std::string::npos) << option;
  }
  EXPECT_EQ(text.find("--edges"), std::string::npos);
  EXPECT_EQ(std::get<HelpRequest>(parseArguments({ "render", "--help" })).text, text);
}

TEST(Arguments, HelpAndVersionNeedNoVerb)
{
  EXPECT_TRUE(std::holds_alternative<VersionRequest>(parseArguments({ "--version" })));
  EXPECT_TRUE(std::holds_alternative<HelpRequest>(parseArguments({ "help" })));
  EXPECT_TRUE(std::holds_alternative<HelpRequest>(parseArguments({ "--help" })));
  EXPECT_TRUE(std::holds_alternative<HelpRequest>(parseArguments({ "help", "help" })));
  EXPECT_NE(errorOf({ "help", "draw" }), "");
}

} // namespace
} // namespace limn::viewer
