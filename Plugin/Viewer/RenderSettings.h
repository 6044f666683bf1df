// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_RenderSettings_h
#define limn_viewer_RenderSettings_h

#include <array>    // for Vector3
#include <optional> // for what the user need not name
#include <string>   // for file names
#include <vector>   // for several meshes and lights

/// What the user asked for, as plain data. The initial values are the defaults.
namespace limn::viewer
{

using Vector3 = std::array<double, 3>;
using Color = std::array<double, 3>; ///< linear factors, >= 0

enum class Shading
{
  Flat,
  Gouraud,
  Phong
};

enum class FlatPoint
{
  Centroid,
  FirstVertex
};

enum class Normals
{
  Data, ///< the mesh's, by area where it has none
  Uniform,
  Area,
  Angle
};

enum class Reflection
{
  None,
  Lambert,
  BlinnPhong,
  Phong,
  Irradiance,
  OrenNayar,
  Metallic
};

enum class Tone
{
  None,
  Gooch,
  GoochChapter,
  GoochRtr4,
  GoochOrangeBook,
  Metal,
  Toon,   ///< the reflection in steps
  Ramp,   ///< by MaterialSettings::toonRamp
  MatCap, ///< by MaterialSettings::matCap
  Hatching,
  Exaggerated,
};

enum class ToneLight
{
  Scene,
  UpperRight
};

enum class RampBy
{
  Depth,
  Silhouette,
  Highlight
};

enum class ToneOverData
{
  Classic,
  Undertone,
  LegendSafe
};

/// Of Tone::Exaggerated; what is not given is as the property has it.
struct ExaggerationSettings
{
  std::optional<double> contrast; ///< 0 to 1000
  std::optional<double> exponent; ///< -4 to 4
  std::optional<double> base;     ///< 0 to 1
  std::optional<int> levels;      ///< 1 to 8
  std::optional<double> scale;    ///< 0.0001 to 1
};

enum class HatchPlace
{
  Model,
  Texture
};

enum class Outline
{
  None,
  Normal,
  Hull,
  Image
};

enum class CreaseDetector
{
  Angle,
  Sobel,
  Laplacian
};

enum class Detector
{
  Plane,
  Sobel,
  Laplacian
};

enum class Window
{
  Cpu, ///< needs no display; no OpenGL library is loaded
  Gl
};

enum class AntiAliasing
{
  None, ///< but for the samples of each pixel
  Fxaa
};

enum class ToneMapping
{
  None,
  Reinhard,
  ReinhardExtended,
  Aces
};

enum class LightKind
{
  Headlight,
  Directional,
  Point,     ///< intensity I/r^2, or by attenuation
  Spot,      ///< intensity I/r^2 inside a cone
  Rectangle, ///< shines to the side of sides[0] x sides[1]
  Sphere
};

struct LightSettings
{
  LightKind kind = LightKind::Headlight;
  Vector3 position = { 0, 0, 0 };
  Vector3 direction = { 0, 0, -1 }; ///< the way the light travels
  double coneDegrees = 30;          ///< half angle, 0 < angle < 90
  double exponent = 1;
  Color color = { 1, 1, 1 };
  bool isPower = false;                  ///< color is power in all, not intensity
  Vector3 attenuation = { 0, 0, 1 };     ///< I / (a + b r + c r^2)
  double softDegrees = 0;                ///< width of a spot's soft edge, inside its cone
  std::array<Vector3, 2> sides = { {} }; ///< of a rectangle about its position
  double radius = 1;
  int samples = 16; ///< of a rectangle or sphere
};

struct CameraSettings
{
  std::optional<Vector3> position, focalPoint, viewUp; ///< fitted to the meshes if not given
  double viewAngleDegrees = 30;
  bool orthographic = false;
  std::optional<double> parallelScale; ///< half the height of the view in world units
  Vector3 up = { 0, 1, 0 };            ///< the meshes' own up: a unit axis
};

enum class TextureFilter
{
  Nearest,
  Bilinear,
  Trilinear ///< over a chain of mipmaps
};

enum class TextureWrap
{
  Repeat,
  Mirror,
  Clamp,
  Border ///< transparent black
};

enum class TextureRole
{
  Surface, ///< k_a and k_d, before light is computed
  Shaded   ///< the colour after light
};

enum class TextureMode
{
  Modulate,
  Replace,
  Decal,
  Add
};

enum class Procedural
{
  None,
  Checker,
  Wood,
  Marble
};

/// Images are files; empty: none.
struct TextureSettings
{
  std::string image, bump, normalMap, lightmap;
  std::optional<TextureFilter> filter; ///< trilinear if not given
  std::optional<TextureWrap> wrap;     ///< repeat if not given
  std::optional<TextureRole> role;     ///< surface if not given
  std::optional<TextureMode> mode;     ///< modulate if not given
  std::optional<int> anisotropy;       ///< 1 to 16; 1 if not given
  std::optional<double> bumpScale;     ///< 1 if not given
  Procedural procedural = Procedural::None;
  std::optional<double> proceduralScale; ///< 1 if not given

  bool hasImage() const
  {
    return !image.empty() || !bump.empty() || !normalMap.empty() || !lightmap.empty();
  }
};

/// Of lines, in pixels.
inline constexpr double kMaxStrokePixels = 256;
inline constexpr double kMaxHaloPixels = 64;
inline constexpr double kMinOutlinePixels = 0.01; ///< but for 0, the usual one
inline constexpr double kMaxOutlinePixels = 64;
inline constexpr double kMaxTaperPixels = 16384; ///< as many as a picture is wide at most

/// In the picture.
struct Length
{
  double value;
  int unit; ///< of vtkLimnProperty::StrokeUnits
};
inline constexpr Length kUsualStroke = { 1.5, 0 };

struct MaterialSettings
{
  std::optional<Color> color;            ///< the meshes' own colours, else kDefaultColor
  std::optional<Color> ambient, diffuse; ///< k_a: k_d if not given; k_d: color if not given
  Color specular = { 0.2, 0.2, 0.2 };    ///< k_s
  double specularPower = 32;             ///< 0 to 128
  double opacity = 1;                    ///< 0 to 1
  std::optional<double> roughness;       ///< 0 to 1; kDefaultRoughness if not given
  std::optional<double> metallic;        ///< 0 to 1; 0 if not given
  std::optional<Color> refractiveIndex;  ///< by channel; kDefaultRefractiveIndex if not given
  bool fresnel = false;
  std::optional<Color> rim;        ///< none if not given
  std::optional<double> rimPower;  ///< kDefaultRimPower if not given
  std::optional<int> localModel;   ///< 1 to 5, in place of a reflection
  std::optional<Color> cool, warm; ///< k_cool and k_warm themselves
  Shading shading = Shading::Phong;
  std::optional<FlatPoint> flatPoint;        ///< centroid if not given
  std::optional<Normals> normals;            ///< data if not given
  std::optional<double> featureAngleDegrees; ///< 0 to 180; no sharp edges if not given
  std::optional<Reflection> reflection;      ///< kDefaultReflection if not given
  Tone tone = Tone::None;
  std::optional<ToneOverData> toneOverData;       ///< classic if not given
  std::optional<double> undertone;                ///< 0 to 1; the property's default if not given
  std::optional<double> legendSafeRange;          ///< 0 to 100; the property's default if not given
  std::optional<int> toonSteps;                   ///< 2 to 64; 3 for Toon, else none, if not given
  std::optional<ToneLight> toneLight;             ///< of the scene if not given
  std::string toonRamp, matCap;                   ///< files; empty: none
  std::optional<RampBy> rampBy;                   ///< depth if not given
  std::optional<double> rampExponent;             ///< >= 0; 1 if not given
  std::optional<std::array<double, 2>> rampRange; ///< of the clipping planes if not given
  std::optional<Length> hatchSpacing;             ///< the property's if not given
  std::optional<double> hatchDarkest;             ///< 0 to 1; likewise
  std::optional<Color> hatchPaper, hatchInk;      ///< white, black if not given
  std::optional<HatchPlace> hatchPlace;           ///< model if not given
  ExaggerationSettings exaggeration;
  Outline outline = Outline::None;
  std::optional<Color> outlineColor;       ///< black if not given
  std::optional<Length> outlineWidth;      ///< 0: no outline
  std::optional<double> outlineOpacity;    ///< 0 to 1; 1 if not given
  std::optional<Detector> outlineDetector; ///< of Outline::Image; plane if not given
  std::optional<double> outlineTolerance, outlineCreaseDegrees; ///< likewise; the property's
  std::optional<CreaseDetector> outlineCreases;                 ///< likewise; by angle
  bool outlineIds = false;                                      ///< of Outline::Image
  bool backfaceCulling = false;
};

enum class HiddenLines
{
  Off,
  Dashed,
  Thin
};

enum class LineKind
{
  Crease,
  Border,
  NonManifold,
  Ids,
  Normals,
  Contour,
  Silhouette,
  Ridge,
  Valley,
  Suggestive,
  Hatch,
  Terminator,
  Shadow,
  Intersections
};

/// Of terminators and shadows.
enum class LineLights
{
  First,
  All
};

enum class UnsharpMode
{
  Darken,
  Both
};

/// Lines along the mesh, drawn as strokes.
struct LineSettings
{
  std::vector<LineKind> kinds; ///< none: no lines
  std::optional<double> creaseAngleDegrees;
  std::optional<int> shortestCrease;  ///< edges; 1, or a style's
  std::optional<std::string> idArray; ///< cell data; the cell scalars if not given
  std::optional<Length> width;
  std::optional<double> outerWidth; ///< times the width
  std::optional<double> hatchWidth; ///< likewise; the property's if not given
  std::optional<Color> color;
  std::optional<double> opacity;
  std::optional<Length> taper;
  std::optional<std::array<Length, 2>> dash; ///< dash and gap
  std::optional<HiddenLines> hidden;
  std::optional<double> ridgeThreshold, suggestiveThreshold; ///< the property's
  std::optional<LineLights> lights;                          ///< first if not given
};

/// Nothing of what is not given; the style's, if there is one.
struct CueSettings
{
  std::optional<double> eyeDome;       ///< strength, 0 to 100
  std::optional<double> eyeDomeRadius; ///< share of the picture's diagonal
  std::optional<double> unsharp;       ///< strength, 0 to 1
  std::optional<double> unsharpRadius; ///< share of the picture's diagonal
  std::optional<UnsharpMode> unsharpMode;
  std::optional<Length> halo;      ///< width, at most 64 pixels
  std::optional<double> haloDepth; ///< in widths
  std::optional<Color> haloColor;  ///< the background's if not given
};

struct ColoringSettings
{
  std::string array;                   ///< empty: not coloured by an array
  std::optional<std::string> colormap; ///< a name of makeColormap(); kDefaultColormap if not given
  std::optional<std::array<double, 2>> range; ///< of the array over all meshes if not given
};

struct SceneSettings
{
  std::vector<std::string> meshes;
  std::array<int, 2> resolution = { 1000, 600 }; ///< pixels
  CameraSettings camera;
  MaterialSettings material;
  TextureSettings texture;
  LineSettings lines;
  CueSettings cues;
  ColoringSettings coloring;
  std::optional<double> pixelsPerInch; ///< of the picture, for points and millimetres
  std::vector<LightSettings> lights;   ///< none: a headlight
  Color ambientLight = { 0, 0, 0 };    ///< I_a
  std::optional<Color> background;     ///< the style's, else kDefaultBackground, if not given
  std::string style;                   ///< a name of vtkLimnStyle; empty: none
  int samples = 4;
  int threads = 0; ///< 0: not given, one for each core unless LIMN_THREADS says otherwise
};

struct BloomSettings
{
  double strength = 0; ///< 0: none
  double threshold = 1;
};

struct DepthOfFieldSettings
{
  double distance; ///< in focus, from the eye, in world units; 0: the focal point's
  double aperture; ///< diameter of the lens; > 0, in world units
};

struct EffectSettings
{
  double exposure = 1;
  std::optional<DepthOfFieldSettings> depthOfField;
  BloomSettings bloom;
  ToneMapping toneMapping = ToneMapping::None;
  std::optional<double> whitePoint; ///< of ReinhardExtended
  AntiAliasing antiAliasing = AntiAliasing::None;
};

/// Files of what a picture has besides colours; empty: not written.
struct MapSettings
{
  std::string normals, depth, ids;

  bool any() const { return !normals.empty() || !depth.empty() || !ids.empty(); }
};

struct RenderSettings
{
  SceneSettings scene;
  EffectSettings effects;
  std::string output;
  std::string toneLegend; ///< a file; empty: none
  MapSettings maps;
  bool transparentBackground = false;
  Window window = Window::Cpu;
  bool stats = false;
};

struct CompareSettings
{
  std::array<std::string, 2> pictures;
  int tolerance = 0; ///< largest difference of a channel, 0 to 255, that still counts as equal
};

inline constexpr const char* kDefaultColormap = "viridis";
inline constexpr Reflection kDefaultReflection = Reflection::BlinnPhong;
inline constexpr double kDefaultRoughness = 0.5;
inline constexpr double kDefaultRefractiveIndex = 1.5;
inline constexpr double kDefaultRimPower = 3;
inline constexpr Color kDefaultBackground = { 0.94, 0.95, 0.97 };
inline constexpr Color kDefaultColor = { 0.66, 0.73, 0.82 };

} // namespace limn::viewer

#endif
