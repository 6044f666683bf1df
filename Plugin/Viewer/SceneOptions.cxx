// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneOptions.h"

#include "Choices.h"
#include "CueOptions.h"
#include "ParseValue.h"
#include "UserError.h"

#include <algorithm>
#include <sstream>

namespace limn::viewer
{
namespace
{

using Text = const std::string&;

const Choices<std::string> kColormaps = { { "viridis", "viridis" }, { "cool-warm", "cool-warm" },
  { "rainbow", "rainbow" }, { "grayscale", "grayscale" }, { "black-body", "black-body" } };

/// Sets `target` with one of the functions of ParseValue.h.
template <typename Target, typename Parse>
OptionList::Reader into(Target& target, Parse parse)
{
  return [&target, parse](Text option, Text text) { target = parse(option, text); };
}

template <typename Target, typename Value>
OptionList::Reader choose(
  Target& target, const Choices<Value>& choices, const std::vector<std::string>& later = {})
{
  return [&target, &choices, later](Text option, Text text)
  { target = parseChoice(option, text, choices, later); };
}

double parseNotNegative(Text option, Text text)
{
  const double number = parseNumber(option, text);
  if (number < 0)
  {
    throw UserError(option + "=" + text + " is negative");
  }
  return number;
}

double parseWithin(Text option, Text text, double low, double high, const char* unit = "")
{
  std::ostringstream range;
  range << "from " << low << " to " << high << unit;
  const double number = parseNumberOfAnySize(option, text, range.str());
  if (number < low || number > high)
  {
    throw UserError(option + "=" + text + " is not " + range.str());
  }
  return number;
}

Length parseOutlineWidth(Text option, Text text)
{
  const std::string range = "from 0.01 to 64 pixels, or 0";
  const Length width = parseLength(option, text, range);
  const bool isInPixels = width.unit == 0 && width.value != 0;
  if (width.value < 0 ||
      (isInPixels && (width.value < kMinOutlinePixels || width.value > kMaxOutlinePixels)))
  {
    throw UserError(option + "=" + text + " is not " + range);
  }
  refuseTiny(option, text, width.value);
  return width;
}

double parseViewAngle(Text option, Text text)
{
  const std::string range = "between 0 and 180 degrees";
  const double degrees = parseNumberOfAnySize(option, text, range);
  if (degrees <= 0 || degrees >= 180)
  {
    throw UserError(option + "=" + text + " is not " + range);
  }
  refuseTiny(option, text, degrees);
  return degrees;
}

double parseSpecularPower(Text option, Text text)
{
  return parseWithin(option, text, 0, 128);
}

double parseShare(Text option, Text text)
{
  return parseWithin(option, text, 0, 1);
}

double parseLightness(Text option, Text text)
{
  return parseWithin(option, text, 0, 100);
}

Color parseRefractiveIndex(Text option, Text text)
{
  const bool isOne = text.find(',') == std::string::npos;
  const double one = isOne ? parseNumber(option, text) : 1;
  const Color index = isOne ? Color{ one, one, one } : parseIntensity(option, text);
  if (*std::min_element(index.begin(), index.end()) < 1)
  {
    throw UserError(option + "=" + text + " is not at least 1, the index of air");
  }
  return index;
}

void addCamera(OptionList& options, CameraSettings& camera)
{
  options.startGroup("Camera (fitted to the meshes where not given)");
  options.add("--camera-position", "x,y,z", "where the eye is", into(camera.position, parseVector));
  options.add(
    "--camera-focal-point", "x,y,z", "what it looks at", into(camera.focalPoint, parseVector));
  options.add(
    "--camera-view-up", "x,y,z", "what is up in the picture", into(camera.viewUp, parseDirection));
  options.add("--camera-view-angle", "degrees", "height of the view (30)",
    into(camera.viewAngleDegrees, parseViewAngle));
  options.addSwitch("--camera-orthographic", "parallel projection", camera.orthographic);
  options.add("--camera-parallel-scale", "size", "half the height of an orthographic view",
    into(camera.parallelScale, parsePositive));
  options.add(
    "--up", "axis", "the meshes' own up: +X -X +Y -Y +Z -Z (+Y)", into(camera.up, parseAxis));
}

double parseFeatureAngle(Text option, Text text)
{
  return parseWithin(option, text, 0, 180, " degrees");
}

void addMaterial(OptionList& options, MaterialSettings& material)
{
  options.startGroup("Surface");
  options.add("--color", "r,g,b", "the colour (the meshes' own, else a grey blue)",
    into(material.color, parseIntensity));
  options.add("--opacity", "a", "how much of it is seen, 0 to 1; the rest is what lies\nbehind (1)",
    into(material.opacity, parseShare));
  options.add("--shading", "name", "where light is evaluated: flat, gouraud, phong (phong)",
    choose(material.shading, shadings()));
  options.add("--flat-point", "name", "of a face lit flat: centroid, first-vertex (centroid)",
    choose(material.flatPoint, flatPoints()));
  options.add("--normals", "name",
    "of vertices: data (the mesh's, else by area), or\ncomputed: uniform, area, angle (data)",
    choose(material.normals, normalSources()));
  options.add("--feature-angle", "degrees",
    "0 to 180; edges above it are sharp, and of a style\ncreases (none)",
    into(material.featureAngleDegrees, parseFeatureAngle));
  options.add("--reflection", "name",
    "none, lambert, phong, blinn-phong, irradiance (the\n"
    "highlight has the cosine too, k_d is over pi),\n"
    "oren-nayar (rough and matt), metallic (facets)\n(blinn-phong)",
    into(material.reflection,
      [](Text option, Text text) { return parseChoice(option, text, reflections()); }));
  options.add("--ambient", "r,g,b", "k_a (k_d)", into(material.ambient, parseIntensity));
  options.add("--diffuse", "r,g,b", "k_d (the colour)", into(material.diffuse, parseIntensity));
  options.add("--specular", "r,g,b", "k_s (0.2,0.2,0.2)", into(material.specular, parseIntensity));
  options.add("--specular-power", "p", "the exponent of the highlight, 0 to 128 (32)",
    into(material.specularPower, parseSpecularPower));
  options.add("--roughness", "r", "of oren-nayar and metallic, 0 to 1 (0.5)",
    into(material.roughness, parseShare));
  options.add("--metallic", "m", "of metallic: 0 plastic to 1 metal (0)",
    into(material.metallic, parseShare));
  options.addSwitch("--fresnel", "highlights grow towards grazing angles", material.fresnel);
  options.add("--refractive-index", "mu", "one, or r,g,b, for fresnel and metallic (1.5)",
    into(material.refractiveIndex, parseRefractiveIndex));
  options.add(
    "--rim", "r,g,b", "velvet: a shine towards the outline", into(material.rim, parseIntensity));
  options.add("--rim-power", "q", "how narrow it is, 0 to 128 (3)",
    into(material.rimPower, parseSpecularPower));
  options.add("--model", "n",
    "in place of --reflection one of five that build on\n"
    "each other: 1 ambient light, 2 matt reflection,\n"
    "3 fall-off, 4 highlights by the reflected ray,\n"
    "5 in colour",
    [&material](Text option, Text text)
    { material.localModel = parseInteger(option, text, 1, 5); });
  options.addSwitch(
    "--backface-culling", "leave out faces seen from behind", material.backfaceCulling);
}

double parseExponent(Text option, Text text)
{
  return parseWithin(option, text, 0, 1000);
}

std::array<double, 2> parseDistances(Text option, Text text)
{
  const std::array<double, 2> range = parseRange(option, text);
  if (!(range[0] > 0 && range[1] > range[0]))
  {
    throw UserError(option + "=" + text + " is not a range above 0");
  }
  return range;
}

Length parseWidthOfLines(Text option, Text text)
{
  return parseWidth(option, text, kMaxStrokePixels);
}

void addHatching(OptionList& options, MaterialSettings& material)
{
  options.add("--hatch-spacing", "s",
    "of strokes where a quarter is ink (of --lines=hatch,\nhalf of the light arrives), as 6, 4pt "
    "or 1.5mm (6)",
    into(material.hatchSpacing, parseWidthOfLines));
  options.add("--hatch-darkest", "a", "share of ink where no light arrives, 0 to 1 (0.85)",
    into(material.hatchDarkest, parseShare));
  options.add("--hatch-ink", "r,g,b", "(0,0,0)", into(material.hatchInk, parseColor));
  options.add(
    "--hatch-paper", "r,g,b", "times the colour (1,1,1)", into(material.hatchPaper, parseColor));
  options.add("--hatch-on", "name",
    "planes through the model, or the texture's\ncoordinates: model, texture (model)",
    choose(material.hatchPlace, hatchPlaces()));
}

template <int kLow, int kHigh>
double parseBetween(Text option, Text text)
{
  return parseWithin(option, text, kLow, kHigh);
}

double parseScale(Text option, Text text)
{
  return parseWithin(option, text, 0.0001, 1);
}

void addExaggeration(OptionList& options, ExaggerationSettings& settings)
{
  options.add("--exaggeration-contrast", "a", "of each scale's detail, 0 to 1000 (10)",
    into(settings.contrast, parseBetween<0, 1000>));
  options.add("--exaggeration-exponent", "p",
    "weight of scales by their size: above 0 large shapes,\nbelow fine detail, -4 to 4 (0)",
    into(settings.exponent, parseBetween<-4, 4>));
  options.add("--exaggeration-base", "share", "of plain light on the coarsest scale, 0 to 1 (0.4)",
    into(settings.base, parseShare));
  options.add("--exaggeration-levels", "n", "scales, 1 to 8 (5)",
    [&settings](Text option, Text text) { settings.levels = parseInteger(option, text, 1, 8); });
  options.add("--exaggeration-scale", "s",
    "of the coarsest, in roots of the surface's area,\n0.0001 to 1 (0.06)",
    into(settings.scale, parseScale));
}

void addTone(OptionList& options, MaterialSettings& material)
{
  options.add("--tone", "name",
    "none, gooch (warm faces the light), gooch-chapter\n(cool faces the light), gooch-rtr4, "
    "gooch-orange-book\n(as these books have it), metal (milled), toon (the\nreflection in steps), "
    "hatching "
    "(strokes, as dense as it\nis dark), exaggerated (detail of all sizes) (none)",
    choose(material.tone, tones()));
  options.add("--toon-steps", "n", "of light, 2 to 64 (3 with toon, else smooth)",
    [&material](Text option, Text text)
    { material.toonSteps = parseInteger(option, text, 2, 64); });
  options.add("--tone-light", "name",
    "of tones but toon: scene (the first, of hatching all),\nupper-right (fixed to the camera) "
    "(scene)",
    choose(material.toneLight, toneLights()));
  options.add("--cool", "r,g,b", "k_cool (0,0,0.4 + 0.2 k_d, or as the tone has it)",
    into(material.cool, parseIntensity));
  options.add("--warm", "r,g,b", "k_warm (0.4,0.4,0 + 0.6 k_d, or as the tone has it)",
    into(material.warm, parseIntensity));
  options.add("--tone-over-data", "name",
    "with colours of an array or of the mesh: classic (as\n"
    "k_d), undertone (the tone mixed in), legend-safe\n(lightness alone moves) (classic)",
    choose(material.toneOverData, tonesOverData()));
  options.add("--undertone", "share", "of the tone in undertone, 0 to 1 (0.25)",
    into(material.undertone, parseShare));
  options.add("--legend-safe-range", "w", "of legend-safe: L* moves by w l.n, 0 to 100 (12)",
    into(material.legendSafeRange, parseLightness));
  options.add("--toon-ramp", "file",
    "in place of --tone: a picture with the tone max(0, n.l)\nto the right, a detail upwards",
    [&material](Text, Text text) { material.toonRamp = text; });
  options.add("--toon-ramp-by", "name", "its detail: depth, silhouette, highlight (depth)",
    choose(material.rampBy, rampDetails()));
  options.add("--toon-ramp-exponent", "r", "of silhouette and highlight, 0 to 1000 (1)",
    into(material.rampExponent, parseExponent));
  options.add("--toon-ramp-range", "a,b", "of depth, distances from the eye (of what is seen)",
    into(material.rampRange, parseDistances));
  options.add("--matcap", "file", "in place of --tone: a picture of a lit sphere",
    [&material](Text, Text text) { material.matCap = text; });
}

void addIllustration(OptionList& options, SceneSettings& scene)
{
  MaterialSettings& material = scene.material;
  options.startGroup("Illustration");
  options.add("--style", "name",
    "tone, outline, lines and reflection by one word:\n"
    "plain, technical, gooch, toon, blueprint, pencil,\n"
    "ink, anatomy, metal, xray, print; width, colour and\n"
    "the like of strokes may be named besides (none)",
    choose(scene.style, styles()));
  addTone(options, material);
  addHatching(options, material);
  addExaggeration(options, material.exaggeration);
  options.add("--outline", "name",
    "none, normal (where the surface turns away), hull (a\nline around it), image (borders, steps "
    "and creases\nof the picture) (none)",
    choose(material.outline, outlines()));
  options.add("--outline-width", "width",
    "as 3, 3px, 2pt or 0.7mm; 0.01 to 64 pixels (hull 1.5,\nimage 2, normal wider where the "
    "surface is flatter)",
    into(material.outlineWidth, parseOutlineWidth));
  options.add("--outline-color", "r,g,b", "(0,0,0)", into(material.outlineColor, parseColor));
  options.add("--outline-opacity", "a", "0 to 1 (1)", into(material.outlineOpacity, parseShare));
  options.add("--outline-detector", "name",
    "of image: plane, or the convolutions sobel, laplacian\n(plane)",
    choose(material.outlineDetector, detectors()));
  options.add("--outline-tolerance", "px", "of image: how deep a step is at least (3)",
    into(material.outlineTolerance, parseNotNegative));
  options.add("--outline-crease-angle", "degrees",
    "of image, between normals as they are drawn: hard edges\nof meshes without normals need "
    "--feature-angle; 180: none (40)",
    into(material.outlineCreaseDegrees, parseFeatureAngle));
  options.add("--outline-crease-detector", "name",
    "of image: angle, or over three pixels sobel, laplacian\n(angle)",
    choose(material.outlineCreases, creaseDetectors()));
  options.addSwitch("--outline-ids",
    "of image: lines between parts of a mesh, too, by the\ncell data that --ids-array names",
    material.outlineIds);
}

Length parseTaper(Text option, Text text)
{
  const std::string range = "from 0 to 16384 pixels";
  const Length taper = parseLength(option, text, range);
  if (taper.value < 0 || (taper.unit == 0 && taper.value > kMaxTaperPixels))
  {
    throw UserError(option + "=" + text + " is not " + range);
  }
  return taper;
}

std::vector<LineKind> parseLineKinds(Text option, Text text)
{
  std::vector<LineKind> kinds;
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (begin == end && !text.empty())
    {
      throw UserError(option + "=" + text + " has a comma without a kind on both sides");
    }
    const LineKind kind = parseChoice(option, text.substr(begin, end - begin), lineKinds());
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
    {
      std::ostringstream message;
      message << option << "=" << text << " names a kind twice; name it once";
      throw UserError(message.str());
    }
    kinds.push_back(kind);
    begin = end + 1;
  }
  return kinds;
}

double parseOuterWidth(Text option, Text text)
{
  const double factor = parseNotNegative(option, text);
  if (factor > 256)
  {
    throw UserError(option + "=" + text + " is greater than 256");
  }
  return factor;
}

double parsePixelsPerInch(Text option, Text text)
{
  return parseInteger(option, text, 1, 100000);
}

double parseHatchWidth(Text option, Text text)
{
  return parseWithin(option, text, 0.01, 256);
}

void addLines(OptionList& options, SceneSettings& scene)
{
  LineSettings& lines = scene.lines;
  options.startGroup("Lines of the mesh, drawn as strokes of an exact width");
  options.add("--lines", "kinds",
    "one or more, with commas between them: crease,\n"
    "border, non-manifold, ids (cells whose array\n"
    "differs), normals (where they are split), contour\n"
    "(where the surface turns away), silhouette (the\n"
    "same along edges of the mesh), intersections (where\n"
    "surfaces cut each other), terminator (where they turn\n"
    "away from the light), shadow (the border of what they\n"
    "cast), and of smooth surfaces ridge, valley,\n"
    "suggestive, hatch (strokes along the curvature, as\n"
    "dense as it is dark) (none)",
    into(lines.kinds, parseLineKinds));
  options.add("--crease-angle", "degrees",
    "0 to 180, between faces' normals, of creases (40; of\na style the feature angle if given)",
    into(lines.creaseAngleDegrees, parseFeatureAngle));
  options.add("--shortest-crease", "edges",
    "creases of fewer edges that hang together are left\n"
    "out if none is sharper than 60 degrees (1; of a style\n8)",
    [&lines](const std::string& option, const std::string& text)
    { lines.shortestCrease = parseInteger(option, text, 1, 1000000); });
  options.add("--ridge-threshold", "k",
    "how much a fortieth of the model bends at ridges and\nvalleys, 0 gives all (0.1)",
    into(lines.ridgeThreshold, parseNotNegative));
  options.add("--suggestive-threshold", "k",
    "how much the bend along the view grows at suggestive\nlines, likewise (0.01)",
    into(lines.suggestiveThreshold, parseNotNegative));
  options.add("--line-lights", "name",
    "lights that have terminators and shadows: first (that\nis no headlight), all (first)",
    choose(lines.lights, lineLights()));
  options.add("--ids-array", "name", "cell data for ids (the cell scalars)",
    [&lines](Text, Text text) { lines.idArray = text; });
  options.add("--stroke-width", "width",
    "as 1.5, 1.5px, 0.75pt or 0.35mm; up to 256 pixels\n(1.5px)",
    into(lines.width, parseWidthOfLines));
  options.add("--dpi", "n", "pixels an inch of the picture, for pt and mm (72)",
    into(scene.pixelsPerInch, parsePixelsPerInch));
  options.add("--outer-width", "factor",
    "of lines with something else behind them, times the\nwidth (1)",
    into(lines.outerWidth, parseOuterWidth));
  options.add("--hatch-width", "factor", "of hatch, times the width (0.6)",
    into(lines.hatchWidth, parseHatchWidth));
  options.add("--stroke-color", "r,g,b", "(0,0,0)", into(lines.color, parseColor));
  options.add("--stroke-opacity", "a", "0 to 1 (1)", into(lines.opacity, parseShare));
  options.add("--stroke-taper", "length",
    "over which ends of lines grow to their width, as 9,\n9px, 6pt or 2mm (0)",
    into(lines.taper, parseTaper));
  options.add(
    "--stroke-dash", "dash,gap", "lengths, as 6,3 or 2mm,1mm (none)", into(lines.dash, parseDash));
  options.add(
    "--hidden-lines", "name", "off, dashed, thin (off)", choose(lines.hidden, hiddenLines()));
}

double parseProceduralScale(Text option, Text text)
{
  const double scale =
    requirePositive(option, text, parseNumberOfAnySize(option, text, "above 0, at most 1e6"));
  if (scale > 1e6)
  {
    throw UserError(option + "=" + text + " is greater than 1e6");
  }
  return scale;
}

void addTextures(OptionList& options, TextureSettings& texture)
{
  const auto file = [](std::string& name) { return [&name](Text, Text text) { name = text; }; };
  options.startGroup("Textures (images need texture coordinates, procedural ones do not)");
  options.add(
    "--texture", "file", ".png .jpg .tif .bmp .pnm .hdr, over the colour", file(texture.image));
  options.add("--texture-role", "name",
    "what it changes: surface (the colour that is lit),\nshaded (the colour after light) (surface)",
    choose(texture.role, textureRoles()));
  options.add("--texture-mode", "name", "modulate, replace, decal, add (modulate)",
    choose(texture.mode, textureModes()));
  options.add("--texture-filter", "name", "nearest, bilinear, trilinear (trilinear)",
    choose(texture.filter, textureFilters()));
  options.add("--texture-wrap", "name", "repeat, mirror, clamp, border (repeat)",
    choose(texture.wrap, textureWraps()));
  options.add("--anisotropy", "n", "most probes of trilinear, 1 to 16 (1)",
    [&texture](Text option, Text text) { texture.anisotropy = parseInteger(option, text, 1, 16); });
  options.add("--bump", "file", "heights that bend the normals", file(texture.bump));
  options.add("--bump-scale", "s", "of the heights, in widths of the image (1)",
    into(texture.bumpScale, parseNumber));
  options.add("--normal-map", "file", "normals in tangent space", file(texture.normalMap));
  options.add("--lightmap", "file", "light that was computed before", file(texture.lightmap));
  options.add("--procedural", "name", "none, checker, wood, marble (none)",
    choose(texture.procedural, procedurals()));
  options.add("--procedural-scale", "s", "its periods per unit of the mesh (1)",
    into(texture.proceduralScale, parseProceduralScale));
}

void addLights(OptionList& options, SceneSettings& scene)
{
  options.startGroup("Light (a headlight where not given)");
  options.addRepeatable("--light", "light",
    "one of\n"
    "  headlight\n"
    "  directional:dx,dy,dz:r,g,b\n"
    "  point:x,y,z:r,g,b[:a,b,c]\n"
    "  spot:x,y,z:dx,dy,dz:cone:exponent:r,g,b[:soft]\n"
    "  rectangle:x,y,z:ax,ay,az:bx,by,bz:r,g,b[:samples]\n"
    "  sphere:x,y,z:radius:r,g,b[:samples]\n"
    "and may be repeated. Directions are the way the light\n"
    "travels; colours may exceed 1, and are the power of a\n"
    "light where power=r,g,b stands for r,g,b; lights with\n"
    "a place fall off with the square of the distance d, or\n"
    "by 1/(a + b d + c d^2); the cone is its half angle in\n"
    "degrees, soft those of its edge; a rectangle has its\n"
    "middle and its sides a and b, and shines to the side\n"
    "of a x b; samples (16) are its point lights",
    [&scene](Text option, Text text) { scene.lights.push_back(parseLight(option, text)); });
  options.add("--ambient-light", "r,g,b", "I_a (0,0,0)", into(scene.ambientLight, parseIntensity));
}

void addColoring(OptionList& options, ColoringSettings& coloring)
{
  options.startGroup("Colour by an array of the mesh");
  options.add("--coloring-array", "name", "point or cell data; of a vector its length",
    [&coloring](Text, Text text) { coloring.array = text; });
  options.add("--colormap", "name", "viridis, cool-warm, rainbow, grayscale, black-body (viridis)",
    [&coloring](Text option, Text text)
    { coloring.colormap = parseChoice(option, text, kColormaps); });
  options.add("--coloring-range", "a,b", "values of the ends of the map (of the array)",
    into(coloring.range, parseRange));
}

} // namespace

void addSceneOptions(OptionList& options, SceneSettings& scene)
{
  addCamera(options, scene.camera);
  addMaterial(options, scene.material);
  addIllustration(options, scene);
  addLines(options, scene);
  addCueOptions(options, scene.cues);
  addTextures(options, scene.texture);
  addLights(options, scene);
  addColoring(options, scene.coloring);
  options.startGroup("Picture");
  options.add("--resolution", "width,height", "in pixels (1000,600)",
    into(scene.resolution, parseResolution));
  options.add(
    "--samples", "n", "per pixel: 1, 2, 4, 8, 16 (4)", choose(scene.samples, sampleCounts()));
  options.add("--threads", "n", "how many cores to use (all)",
    [&scene](Text option, Text text) { scene.threads = parseInteger(option, text, 1, 1024); });
}

} // namespace limn::viewer
