// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "CheckIllustration.h"
#include "CheckLines.h"
#include "CueOptions.h"
#include "EffectOptions.h"
#include "OptionList.h"
#include "ParseValue.h"
#include "SceneOptions.h"
#include "UserError.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <utility>

namespace limn::viewer
{
namespace
{

const char* const kOverview =
  R"(limn draws triangle meshes on the CPU, with technical-illustration shading.

Usage:
  limn render MESH... --output=FILE.png [OPTIONS]   draw a picture
  limn view MESH... [OPTIONS]                       look at it in a window
  limn info MESH...                                 what is in the files
  limn compare A.png B.png [--tolerance=N]          how far two pictures differ
  limn help [VERB]                                  this text, or a verb's options
  limn --version

Meshes: .obj .off .ply .stl .om .vtp .vtk .vtu
Exit status: 0; 2 for an error that you can mend; 3 where compared pictures differ.

Try:  limn render teapot.obj --tone=gooch --output=teapot.png
)";

const Choices<Window> kWindows = { { "cpu", Window::Cpu }, { "gl", Window::Gl } };

void requireMeshes(const std::vector<std::string>& meshes, const std::string& verb)
{
  if (meshes.empty())
  {
    throw UserError("no mesh is named; give one, as in: limn " + verb + " teapot.obj" +
                    (verb == "render" ? " --output=teapot.png" : ""));
  }
}

void requireColoringArray(const ColoringSettings& coloring)
{
  if (!coloring.array.empty())
  {
    return;
  }
  if (coloring.colormap)
  {
    throw UserError("--colormap needs --coloring-array=NAME; \"limn info MESH\" lists the arrays");
  }
  if (coloring.range)
  {
    throw UserError(
      "--coloring-range needs --coloring-array=NAME; \"limn info MESH\" lists the arrays");
  }
}

/// For a picture alone: in a window keys choose the shading.
void checkShading(const MaterialSettings& material)
{
  const bool isFlat = material.shading == Shading::Flat;
  if (material.flatPoint && !isFlat)
  {
    throw UserError("--flat-point needs --shading=flat");
  }
  if (isFlat && (material.normals || material.featureAngleDegrees))
  {
    throw UserError(std::string(material.normals ? "--normals" : "--feature-angle") +
                    " and --shading=flat exclude each other; give one");
  }
}

bool isGrey(const Color& color)
{
  return color[0] == color[1] && color[1] == color[2];
}

[[noreturn]] void refuseWithout(const std::string& option, const std::string& needed)
{
  throw UserError(option + " needs " + needed);
}

[[noreturn]] void refuseBoth(const std::string& one, const std::string& other)
{
  throw UserError(one + " and " + other + " exclude each other; give one");
}

/// A tone and the local models take the place of a reflection and of all that goes with it.
void checkAlternatives(const MaterialSettings& material)
{
  // Toon steps what they send back.
  const bool hasTone = material.tone != Tone::None && material.tone != Tone::Toon;
  if (material.localModel && material.reflection)
  {
    refuseBoth("--model", "--reflection");
  }
  if (material.localModel && hasTone)
  {
    refuseBoth("--model", "--tone");
  }
  const std::pair<const char*, bool> options[] = {
    { "--roughness", material.roughness.has_value() },
    { "--metallic", material.metallic.has_value() },
    { "--fresnel", material.fresnel },
    { "--refractive-index", material.refractiveIndex.has_value() },
    { "--rim", material.rim.has_value() },
    { "--rim-power", material.rimPower.has_value() },
  };
  for (const auto& [name, isGiven] : options)
  {
    if (isGiven && (hasTone || material.localModel))
    {
      refuseBoth(name, hasTone ? "--tone" : "--model");
    }
  }
}

/// What a picture would not show.
void checkReflection(const MaterialSettings& material)
{
  checkAlternatives(material);
  const Reflection reflection = material.reflection.value_or(kDefaultReflection);
  const bool isMetallic = reflection == Reflection::Metallic;
  const bool isGlossy = reflection == Reflection::BlinnPhong || reflection == Reflection::Phong ||
                        reflection == Reflection::Irradiance;
  if (material.roughness && !isMetallic && reflection != Reflection::OrenNayar)
  {
    refuseWithout("--roughness", "--reflection=oren-nayar or --reflection=metallic");
  }
  if (material.metallic && !isMetallic)
  {
    refuseWithout("--metallic", "--reflection=metallic");
  }
  if (material.fresnel && !isGlossy)
  {
    refuseWithout("--fresnel", "--reflection=blinn-phong, phong or irradiance");
  }
  if (material.refractiveIndex && !isMetallic && !material.fresnel)
  {
    refuseWithout("--refractive-index", "--fresnel or --reflection=metallic");
  }
  if (isMetallic && material.refractiveIndex && !isGrey(*material.refractiveIndex))
  {
    throw UserError(
      "--refractive-index of --reflection=metallic is one number; a metal's colour is "
      "its --color");
  }
  if (material.rim && (isMetallic || reflection == Reflection::None))
  {
    refuseWithout("--rim", "another --reflection than none or metallic");
  }
  if (material.rimPower && !material.rim)
  {
    refuseWithout("--rim-power", "--rim=r,g,b");
  }
}

/// What a picture would not show.
void checkTextures(const TextureSettings& texture)
{
  const bool hasColor = !texture.image.empty() || texture.procedural != Procedural::None;
  if ((texture.mode || texture.role) && !hasColor)
  {
    refuseWithout(
      texture.mode ? "--texture-mode" : "--texture-role", "--texture=FILE or --procedural=NAME");
  }
  if ((texture.filter || texture.wrap || texture.anisotropy) && !texture.hasImage())
  {
    refuseWithout(texture.filter ? "--texture-filter"
                  : texture.wrap ? "--texture-wrap"
                                 : "--anisotropy",
      "an image; add --texture=FILE");
  }
  if (texture.anisotropy &&
      texture.filter.value_or(TextureFilter::Trilinear) != TextureFilter::Trilinear)
  {
    refuseWithout("--anisotropy", "--texture-filter=trilinear");
  }
  if (texture.bumpScale && texture.bump.empty())
  {
    refuseWithout("--bump-scale", "--bump=FILE");
  }
  if (texture.proceduralScale && texture.procedural == Procedural::None)
  {
    refuseWithout("--procedural-scale", "--procedural=NAME");
  }
}

void checkCamera(const CameraSettings& camera)
{
  if (camera.parallelScale && !camera.orthographic)
  {
    throw UserError("--camera-parallel-scale needs --camera-orthographic");
  }
  if (camera.position && camera.position == camera.focalPoint)
  {
    throw UserError("--camera-position and --camera-focal-point are the same point; move one");
  }
}

void checkScene(const SceneSettings& scene, const std::string& verb)
{
  requireMeshes(scene.meshes, verb);
  requireColoringArray(scene.coloring);
  checkCamera(scene.camera);
}

void requirePng(const std::string& option, const std::string& file)
{
  std::filesystem::path path = file;
  if (!path.has_filename())
  {
    throw UserError(
      option + "=" + file + " names a folder; add a file's name, as in " + file + "picture.png");
  }
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (extension != ".png")
  {
    throw UserError(option + "=" + file + " is not a PNG file; name it " +
                    path.replace_extension(".png").string());
  }
}

/// All files that are written.
void checkOutputs(const RenderSettings& settings)
{
  if (settings.output.empty() && !settings.maps.any() && settings.toneLegend.empty())
  {
    throw UserError("no output is named; add --output=FILE.png");
  }
  if (!settings.toneLegend.empty() &&
      ((settings.scene.material.tone == Tone::None && settings.scene.style.empty()) ||
        settings.scene.coloring.array.empty()))
  {
    refuseWithout("--tone-legend", "a tone and --coloring-array=NAME");
  }
  if (settings.maps.any() && settings.window == Window::Gl)
  {
    throw UserError("an OpenGL window keeps no normals, depth and ids to write; leave out "
                    "--window=gl");
  }
  const std::pair<const char*, const std::string&> files[] = { { "--output", settings.output },
    { "--output-normals", settings.maps.normals }, { "--output-depth", settings.maps.depth },
    { "--output-ids", settings.maps.ids }, { "--tone-legend", settings.toneLegend } };
  std::map<std::string, std::string> optionOf;
  for (const auto& [option, file] : files)
  {
    if (file.empty())
    {
      continue;
    }
    requirePng(option, file);
    const auto [other, isNew] = optionOf.emplace(file, option);
    if (!isNew)
    {
      throw UserError(
        other->second + " and " + option + " name the same file " + file + "; choose two");
    }
  }
}

void addMaps(OptionList& options, MapSettings& maps)
{
  const auto file = [](std::string& name)
  { return [&name](const std::string&, const std::string& text) { name = text; }; };
  options.add("--output-normals", "FILE.png",
    "normals in view space: 255 (n + 1) / 2 (right, up,\ntowards the eye), grey where no mesh is",
    file(maps.normals));
  options.add("--output-depth", "FILE.png",
    "16 bits of grey: window depth, white is farthest; of\nopaque meshes, as all maps",
    file(maps.depth));
  options.add("--output-ids", "FILE.png",
    "3 x 16 bits: red the number of the mesh, from 1 on,\n65536 green + blue its cell; black "
    "where none is",
    file(maps.ids));
}

using Arguments = std::vector<std::string>;

Request parseRender(const Arguments& arguments)
{
  RenderSettings settings;
  SceneSettings& scene = settings.scene;
  OptionList options("render", "Draws meshes into a PNG file.");
  options.addFiles("MESH", "files to draw, one scene", scene.meshes);
  options.add("--output", "FILE.png", "written whole or not at all",
    [&](const std::string&, const std::string& text) { settings.output = text; });
  addMaps(options, settings.maps);
  addSceneOptions(options, scene);
  options.add("--tone-legend", "FILE.png",
    "the colours of --coloring-array as drawn: values from\nleft to right, from averted to facing "
    "upwards",
    [&](const std::string&, const std::string& text) { settings.toneLegend = text; });
  options.add("--background-color", "r,g,b", "(0.94,0.95,0.97, or the style's)",
    [&](const std::string& option, const std::string& text)
    { scene.background = parseColor(option, text); });
  options.addSwitch(
    "--no-background", "transparent where no mesh is", settings.transparentBackground);
  options.add("--window", "name", "cpu (needs no display), gl (an OpenGL window) (cpu)",
    [&](const std::string& option, const std::string& text)
    { settings.window = parseChoice(option, text, kWindows); });
  options.addSwitch(
    "--stats", "print one JSON line: counts, times, bytes, threads", settings.stats);
  addEffectOptions(options, settings.effects);
  if (!options.read(arguments))
  {
    return HelpRequest{ options.help() };
  }
  takePictures(scene.material);
  checkStyle(scene);
  checkShownByStyle(scene);
  checkScene(scene, "render");
  checkShading(scene.material);
  checkIllustration(scene);
  checkLines(scene);
  checkCues(scene);
  checkEffects(settings);
  checkReflection(scene.material);
  checkTextures(scene.texture);
  checkOutputs(settings);
  if (scene.background && settings.transparentBackground)
  {
    throw UserError("--background-color and --no-background exclude each other; give one");
  }
  return RenderRequest{ settings };
}

Request parseView(const Arguments& arguments)
{
  SceneSettings scene;
  OptionList options("view", "Shows meshes in a window; press h in it for the keys.");
  options.addFiles("MESH", "files to show, one scene", scene.meshes);
  addSceneOptions(options, scene);
  options.add("--background-color", "r,g,b", "(0.94,0.95,0.97, or the style's)",
    [&](const std::string& option, const std::string& text)
    { scene.background = parseColor(option, text); });
  if (!options.read(arguments))
  {
    return HelpRequest{ options.help() };
  }
  takePictures(scene.material);
  checkStyle(scene);
  checkScene(scene, "view");
  return ViewRequest{ scene };
}

Request parseInfo(const Arguments& arguments)
{
  InfoRequest request;
  OptionList options("info", "Prints what is in mesh files.");
  options.addFiles("MESH", "files to read", request.meshes);
  if (!options.read(arguments))
  {
    return HelpRequest{ options.help() };
  }
  requireMeshes(request.meshes, "info");
  return request;
}

Request parseCompare(const Arguments& arguments)
{
  CompareSettings settings;
  std::vector<std::string> pictures;
  OptionList options(
    "compare", "Says how far two pictures differ. Exit status 0: the same, 3: they differ.");
  options.addFiles("PNG", "two pictures", pictures);
  options.add("--tolerance", "n", "a channel may differ by n, 0 to 255 (0)",
    [&](const std::string& option, const std::string& text)
    { settings.tolerance = parseInteger(option, text, 0, 255); });
  if (!options.read(arguments))
  {
    return HelpRequest{ options.help() };
  }
  if (pictures.size() != 2)
  {
    throw UserError("compare takes two pictures, got " + std::to_string(pictures.size()) +
                    "; as in: limn compare A.png B.png");
  }
  settings.pictures = { pictures[0], pictures[1] };
  return CompareRequest{ settings };
}

Request parseVerb(const std::string& verb, const Arguments& arguments);

Request parseHelp(const Arguments& arguments)
{
  if (arguments.empty())
  {
    return HelpRequest{ kOverview };
  }
  if (arguments.size() > 1)
  {
    throw UserError("help takes one verb; as in: limn help render");
  }
  return arguments[0] == "help" ? HelpRequest{ kOverview } : parseVerb(arguments[0], { "--help" });
}

Request parseVerb(const std::string& verb, const Arguments& arguments)
{
  using Parser = Request (*)(const Arguments&);
  const std::vector<std::pair<std::string, Parser>> verbs = { { "render", parseRender },
    { "view", parseView }, { "info", parseInfo }, { "compare", parseCompare } };
  for (const auto& [name, parse] : verbs)
  {
    if (name == verb)
    {
      return parse(arguments);
    }
  }
  const std::string small = inSmallLetters(verb);
  for (const char* const known :
    { "render", "view", "info", "compare", "help", "--help", "--version" })
  {
    if (small == known)
    {
      throw UserError("unknown verb " + verb + "; write it in small letters: " + small);
    }
  }
  throw UserError("unknown verb " + verb + "; choose one of: render, view, info, compare, help");
}

} // namespace

Request parseArguments(const std::vector<std::string>& arguments)
{
  if (arguments.empty())
  {
    throw UserError("no verb is named; see \"limn help\"");
  }
  const std::string& verb = arguments[0];
  const Arguments rest(arguments.begin() + 1, arguments.end());
  if (verb == "--version")
  {
    return VersionRequest{};
  }
  if (verb == "--help")
  {
    return HelpRequest{ kOverview };
  }
  return verb == "help" ? parseHelp(rest) : parseVerb(verb, rest);
}

} // namespace limn::viewer
