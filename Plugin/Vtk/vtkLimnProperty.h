// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnProperty
 * @brief   a vtkProperty with the shading models of technical illustration
 *
 * An ordinary vtkProperty until one of its own settings is changed: with all of them at their
 * defaults a surface looks as VTK's OpenGL shaders draw it. ShadingFrequency and ReflectionModel
 * choose when and how light is computed, Tone replaces the diffuse shades by a colour scale,
 * Outline darkens the surface where it turns away from the viewer or draws a line around it, and
 * textures can do more than vtkTexture's own way of multiplying the lit colour.
 *
 * Only Limn's mapper reads these settings. n is the surface normal, l points towards the light, v
 * towards the eye, h halfway between them, r along the reflected ray; all are unit vectors.
 *
 * Choices and whole numbers, and most angles, shares and factors, are clamped: what is outside of
 * their range becomes the nearest end of it, as VTK's own properties have it (vtkSetClampMacro).
 * Other values are kept as they are given; what cannot be drawn with one of them is not drawn, and
 * an error names the value and its range.
 *
 * @sa
 * vtkLimnActor vtkLimnPolyDataMapper vtkLimnSurfaceShader
 */

#ifndef vtkLimnProperty_h
#define vtkLimnProperty_h

#include "vtkLimnModule.h" // for export macro
#include "vtkProperty.h"

class vtkImageData;
class vtkTexture;
class vtkLimnSurfaceShader;

class VTKLIMN_EXPORT vtkLimnProperty : public vtkProperty
{
public:
  static vtkLimnProperty* New();
  vtkTypeMacro(vtkLimnProperty, vtkProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShadingFrequencies
  {
    FREQUENCY_AS_VTK = 0,
    FREQUENCY_FLAT,
    FREQUENCY_GOURAUD,
    FREQUENCY_PHONG
  };

  ///@{
  /**
   * How often light is computed: once per face at its FlatPoint (Flat), once per vertex with
   * colours interpolated (Gouraud), once per pixel with normals interpolated (Phong). As VTK, the
   * default, follows Interpolation as VTK's shaders do: per pixel, with face normals if it is
   * VTK_FLAT.
   */
  vtkSetClampMacro(ShadingFrequency, int, FREQUENCY_AS_VTK, FREQUENCY_PHONG);
  vtkGetMacro(ShadingFrequency, int);
  void SetShadingFrequencyToAsVTK() { this->SetShadingFrequency(FREQUENCY_AS_VTK); }
  void SetShadingFrequencyToFlat() { this->SetShadingFrequency(FREQUENCY_FLAT); }
  void SetShadingFrequencyToGouraud() { this->SetShadingFrequency(FREQUENCY_GOURAUD); }
  void SetShadingFrequencyToPhong() { this->SetShadingFrequency(FREQUENCY_PHONG); }
  const char* GetShadingFrequencyAsString();
  ///@}

  enum FlatPoints
  {
    FLAT_AT_CENTROID = 0,
    FLAT_AT_FIRST_VERTEX
  };

  ///@{
  /**
   * Where the frequency Flat lights a face. FirstVertex is the first point of its cell, as
   * fixed-function hardware did it. Default: Centroid.
   */
  vtkSetClampMacro(FlatPoint, int, FLAT_AT_CENTROID, FLAT_AT_FIRST_VERTEX);
  vtkGetMacro(FlatPoint, int);
  void SetFlatPointToCentroid() { this->SetFlatPoint(FLAT_AT_CENTROID); }
  void SetFlatPointToFirstVertex() { this->SetFlatPoint(FLAT_AT_FIRST_VERTEX); }
  const char* GetFlatPointAsString();
  ///@}

  enum VertexNormalSources
  {
    NORMALS_FROM_DATA = 0,
    NORMALS_UNIFORM,
    NORMALS_BY_AREA,
    NORMALS_BY_ANGLE
  };

  ///@{
  /**
   * Where the normals of points come from. FromData, the default: the point data's, or ByArea if
   * there are none and the frequency needs some. All others are computed, whatever the data has, as
   * sums over the triangles around a point, each with the same weight, by its area, or by its angle
   * there. Computing them takes one pass over the mesh when it changes. Frequency Flat and, as VTK
   * does it, VTK_FLAT need none.
   */
  vtkSetClampMacro(VertexNormals, int, NORMALS_FROM_DATA, NORMALS_BY_ANGLE);
  vtkGetMacro(VertexNormals, int);
  void SetVertexNormalsToFromData() { this->SetVertexNormals(NORMALS_FROM_DATA); }
  void SetVertexNormalsToUniform() { this->SetVertexNormals(NORMALS_UNIFORM); }
  void SetVertexNormalsToByArea() { this->SetVertexNormals(NORMALS_BY_AREA); }
  void SetVertexNormalsToByAngle() { this->SetVertexNormals(NORMALS_BY_ANGLE); }
  const char* GetVertexNormalsAsString();
  ///@}

  ///@{
  /**
   * Edges whose two faces' normals are more than this many degrees apart are sharp: points on them
   * have normals of their own on each side. Below 180 normals are computed, whatever the data has,
   * and take 12 bytes more for each triangle. From 0 to 180; default: 180, no sharp edges.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  enum ReflectionModels
  {
    REFLECTION_AS_VTK = 0,
    REFLECTION_NONE,
    REFLECTION_LAMBERT,
    REFLECTION_BLINN_PHONG,
    REFLECTION_PHONG,
    REFLECTION_IRRADIANCE,
    REFLECTION_OREN_NAYAR,
    REFLECTION_METALLIC_ROUGHNESS,
    REFLECTION_LOCAL_1,
    REFLECTION_LOCAL_2,
    REFLECTION_LOCAL_3,
    REFLECTION_LOCAL_4,
    REFLECTION_LOCAL_5
  };

  ///@{
  /**
   * What a surface does with light. None: ambient plus diffuse colour, unlit. Lambert:
   * k_a I_a + k_d I max(0, n.l). Blinn-Phong adds k_s I max(0, n.h)^p, Phong k_s I max(0, r.v)^p.
   * Irradiance: (k_d / pi + k_s max(0, n.h)^p) E, E = I max(0, n.l). Oren-Nayar: Lambert's for
   * rough surfaces, by Roughness. Metallic-roughness: facets after Trowbridge and Reitz (GGX), by
   * Roughness, Metallic, BaseIOR and EdgeTint. Local1 to Local5 are models of which each adds to
   * the one before: 1 ambient light alone, 2 Lambert's reflection without the lights' fall-off, 3
   * with it, 4 highlights as Phong's, 5 ambient and diffuse colour, which 1 to 4 take as greys of
   * the same luminance; that of highlights is a grey in all. They have neither Fresnel's term nor
   * a rim, and colours of scalars stay. I_a is vtkRenderer's Ambient. The default, as VTK, is what
   * VTK's shaders compute, with the interpolation VTK_PBR too.
   */
  vtkSetClampMacro(ReflectionModel, int, REFLECTION_AS_VTK, REFLECTION_LOCAL_5);
  vtkGetMacro(ReflectionModel, int);
  void SetReflectionModelToAsVTK() { this->SetReflectionModel(REFLECTION_AS_VTK); }
  void SetReflectionModelToNone() { this->SetReflectionModel(REFLECTION_NONE); }
  void SetReflectionModelToLambert() { this->SetReflectionModel(REFLECTION_LAMBERT); }
  void SetReflectionModelToBlinnPhong() { this->SetReflectionModel(REFLECTION_BLINN_PHONG); }
  void SetReflectionModelToPhong() { this->SetReflectionModel(REFLECTION_PHONG); }
  void SetReflectionModelToIrradiance() { this->SetReflectionModel(REFLECTION_IRRADIANCE); }
  void SetReflectionModelToOrenNayar() { this->SetReflectionModel(REFLECTION_OREN_NAYAR); }
  void SetReflectionModelToMetallicRoughness()
  {
    this->SetReflectionModel(REFLECTION_METALLIC_ROUGHNESS);
  }
  void SetReflectionModelToLocal1() { this->SetReflectionModel(REFLECTION_LOCAL_1); }
  void SetReflectionModelToLocal2() { this->SetReflectionModel(REFLECTION_LOCAL_2); }
  void SetReflectionModelToLocal3() { this->SetReflectionModel(REFLECTION_LOCAL_3); }
  void SetReflectionModelToLocal4() { this->SetReflectionModel(REFLECTION_LOCAL_4); }
  void SetReflectionModelToLocal5() { this->SetReflectionModel(REFLECTION_LOCAL_5); }
  const char* GetReflectionModelAsString();
  ///@}

  ///@{
  /**
   * Multiply k_s by Fresnel's term in Schlick's form, F_0 + (1 - F_0) (1 - h.l)^5 with
   * F_0 = ((mu - 1) / (mu + 1))^2, for Blinn-Phong, Phong and irradiance. mu is RefractiveIndex, by
   * channel, at least 1. Defaults: off and (1.5, 1.5, 1.5).
   */
  vtkSetMacro(Fresnel, bool);
  vtkGetMacro(Fresnel, bool);
  vtkBooleanMacro(Fresnel, bool);
  vtkSetVector3Macro(RefractiveIndex, double);
  vtkGetVector3Macro(RefractiveIndex, double);
  ///@}

  ///@{
  /**
   * Velvet: k_a and k_d grow by RimColor (1 - max(0, n.v))^RimPower, for Lambert, Blinn-Phong,
   * Phong, irradiance and Oren-Nayar. Defaults: black, which is no rim, and 3.
   */
  vtkSetVector3Macro(RimColor, double);
  vtkGetVector3Macro(RimColor, double);
  vtkSetMacro(RimPower, double);
  vtkGetMacro(RimPower, double);
  ///@}

  ///@{
  /**
   * Whether lights reach this surface weaker from afar, by their attenuation. Default: on.
   */
  vtkSetMacro(FallOff, bool);
  vtkGetMacro(FallOff, bool);
  vtkBooleanMacro(FallOff, bool);
  ///@}

  enum Tones
  {
    TONE_NONE = 0,
    TONE_GOOCH,
    TONE_GOOCH_CHAPTER,
    TONE_TOON,
    TONE_METAL,
    TONE_RAMP,
    TONE_MAT_CAP,
    TONE_HATCHING,
    TONE_EXAGGERATED
  };

  ///@{
  /**
   * A colour scale in place of the diffuse term, for the light that ToneLight names. Gooch: warm
   * where the surface faces it, cool where it turns away. GoochChapter: the same scale the other
   * way round. Metal: Gooch's scale times the stripes of a milled surface. Ramp: k_d times
   * ToonRamp's colour. MatCap: k_d times the colour that the MatCap's sphere has for the same
   * normal. Hatching: strokes of HatchInk on HatchPaper, the denser the less light all the lights
   * send. Exaggerated: k_d times a grey that shows detail of all sizes, lit or not; see
   * ExaggerationContrast.
   *
   * Toon is no scale, but ReflectionModel in ToonBands steps. Default: None.
   */
  vtkSetClampMacro(Tone, int, TONE_NONE, TONE_EXAGGERATED);
  vtkGetMacro(Tone, int);
  void SetToneToNone() { this->SetTone(TONE_NONE); }
  void SetToneToGooch() { this->SetTone(TONE_GOOCH); }
  void SetToneToGoochChapter() { this->SetTone(TONE_GOOCH_CHAPTER); }
  void SetToneToToon() { this->SetTone(TONE_TOON); }
  void SetToneToMetal() { this->SetTone(TONE_METAL); }
  void SetToneToRamp() { this->SetTone(TONE_RAMP); }
  void SetToneToMatCap() { this->SetTone(TONE_MAT_CAP); }
  void SetToneToHatching() { this->SetTone(TONE_HATCHING); }
  void SetToneToExaggerated() { this->SetTone(TONE_EXAGGERATED); }
  const char* GetToneAsString();
  ///@}

  ///@{
  /**
   * Into how many even steps light is divided, after that of all lights is summed, for the tones
   * Toon, Gooch, GoochChapter, Metal and Exaggerated: 2 to 64. Highlights become all or nothing.
   * Their edges are antialiased with the frequency Phong; Flat gives each face one step, and
   * Gouraud blends steps over the triangles that they meet in. Default: 0, which is 3 for Toon and
   * smooth for all else.
   */
  vtkSetClampMacro(ToonBands, int, 0, 64);
  vtkGetMacro(ToonBands, int);
  ///@}

  enum ToneLights
  {
    TONE_LIGHT_SCENE = 0,
    TONE_LIGHT_UPPER_RIGHT
  };

  ///@{
  /**
   * The light of all tones but Toon and MatCap, and of HatchLines. Scene, the default: the
   * renderer's first, of hatching all. UpperRight: one from above and the right that moves with the
   * camera, perpendicular to the gaze, so that the whole scale is seen.
   */
  vtkSetClampMacro(ToneLight, int, TONE_LIGHT_SCENE, TONE_LIGHT_UPPER_RIGHT);
  vtkGetMacro(ToneLight, int);
  void SetToneLightToScene() { this->SetToneLight(TONE_LIGHT_SCENE); }
  void SetToneLightToUpperRight() { this->SetToneLight(TONE_LIGHT_UPPER_RIGHT); }
  const char* GetToneLightAsString();
  ///@}

  enum ToneHighlights
  {
    TONE_HIGHLIGHT_ADDED = 0,
    TONE_HIGHLIGHT_REFLECTED,
    TONE_HIGHLIGHT_WHITE,
    TONE_HIGHLIGHT_NONE
  };

  ///@{
  /**
   * The highlight of Gooch, GoochChapter and Metal. Added, the default: k_s max(0, n.h)^p, without
   * the light's colour. Reflected: k_s max(0, r.v)^p. White: a share clamp(100 r.v - 97) of white.
   */
  vtkSetClampMacro(ToneHighlight, int, TONE_HIGHLIGHT_ADDED, TONE_HIGHLIGHT_NONE);
  vtkGetMacro(ToneHighlight, int);
  void SetToneHighlightToAdded() { this->SetToneHighlight(TONE_HIGHLIGHT_ADDED); }
  void SetToneHighlightToReflected() { this->SetToneHighlight(TONE_HIGHLIGHT_REFLECTED); }
  void SetToneHighlightToWhite() { this->SetToneHighlight(TONE_HIGHLIGHT_WHITE); }
  void SetToneHighlightToNone() { this->SetToneHighlight(TONE_HIGHLIGHT_NONE); }
  const char* GetToneHighlightAsString();
  ///@}

  ///@{
  /**
   * The tone Gooch with the constants of a publication: CoolColor, WarmColor, CoolSurface,
   * WarmSurface and ToneHighlight. 1998: the figures of Gooch, Gooch, Shirley and Cohen, all the
   * defaults. RTR4: Real-Time Rendering, 4th edition, 5.1. OrangeBook: Rost, OpenGL Shading
   * Language, which has a surface of 0.75 and a white highlight of power 32; these are set too, as
   * diffuse and specular color.
   */
  void SetGoochTo1998();
  void SetGoochToRTR4();
  void SetGoochToOrangeBook();
  ///@}

  /**
   * The tone Metal with a CoolColor of (1, 1.15, 1.4) and a WarmColor of (2, 1.95, 1.8), whatever
   * the surface's own color, and no highlight. All stripes but one are dark: with Gooch's own
   * constants they make cast iron.
   */
  void SetMetalToSteel();

  ///@{
  /**
   * The picture of the tone Ramp: to the right max(0, n.l), upwards a detail (X-Toon: Barla,
   * Thollot and Markosian 2006). ToonRampBy says which: Depth, the default, from 0 at the farther
   * end of ToonRampRange to 1 at the nearer one, by the logarithm of the distance along the gaze;
   * Silhouette |n.v|^ToonRampExponent; Highlight max(0, r.v)^ToonRampExponent. A range of (0, 0),
   * the default, is that of the camera's clipping planes. The exponent's default is 1.
   */
  virtual void SetToonRamp(vtkTexture* texture);
  void SetToonRampImage(vtkImageData* image);
  vtkGetObjectMacro(ToonRamp, vtkTexture);
  enum ToonRampDetails
  {
    TOON_RAMP_BY_DEPTH = 0,
    TOON_RAMP_BY_SILHOUETTE,
    TOON_RAMP_BY_HIGHLIGHT
  };
  vtkSetClampMacro(ToonRampBy, int, TOON_RAMP_BY_DEPTH, TOON_RAMP_BY_HIGHLIGHT);
  vtkGetMacro(ToonRampBy, int);
  void SetToonRampByToDepth() { this->SetToonRampBy(TOON_RAMP_BY_DEPTH); }
  void SetToonRampByToSilhouette() { this->SetToonRampBy(TOON_RAMP_BY_SILHOUETTE); }
  void SetToonRampByToHighlight() { this->SetToonRampBy(TOON_RAMP_BY_HIGHLIGHT); }
  const char* GetToonRampByAsString();
  vtkSetMacro(ToonRampExponent, double);
  vtkGetMacro(ToonRampExponent, double);
  vtkSetVector2Macro(ToonRampRange, double);
  vtkGetVector2Macro(ToonRampRange, double);
  ///@}

  ///@{
  /**
   * The picture of the tone MatCap: a sphere that fills it, as it looks from the eye (Sloan et al.
   * 2001).
   */
  virtual void SetMatCap(vtkTexture* texture);
  void SetMatCapImage(vtkImageData* image);
  vtkGetObjectMacro(MatCap, vtkTexture);
  ///@}

  enum StrokeUnits
  {
    STROKE_PIXELS = 0,
    STROKE_POINTS,
    STROKE_MILLIMETERS
  };

  enum HatchPlaces
  {
    HATCH_ON_MODEL = 0,
    HATCH_ON_TEXTURE
  };

  ///@{
  /**
   * The strokes of the tone Hatching, whose share of the surface is HatchDarkest times 1 - t, where
   * t is the light that all lights send back by a matt white surface, with k_a times the ambient
   * light, 0 to 1, or with the ToneLight UpperRight (1 + n.l) / 2. HatchSpacing is the distance
   * from stroke to stroke where a quarter of the surface is ink, in HatchUnit (as StrokeUnit),
   * bounded to 1 to 256 pixels, at any distance and tilt. The colour of the paper is that of the
   * surface times HatchPaper. Strokes lie where planes through the model cut it, or, with
   * HatchPlace Texture, along the texture coordinates. Defaults: 0.85, 6 pixels, white, black,
   * Model.
   */
  vtkSetClampMacro(HatchDarkest, double, 0.0, 1.0);
  vtkGetMacro(HatchDarkest, double);
  vtkSetMacro(HatchSpacing, double);
  vtkGetMacro(HatchSpacing, double);
  vtkSetClampMacro(HatchUnit, int, STROKE_PIXELS, STROKE_MILLIMETERS);
  vtkGetMacro(HatchUnit, int);
  void SetHatchUnitToPixels() { this->SetHatchUnit(STROKE_PIXELS); }
  void SetHatchUnitToPoints() { this->SetHatchUnit(STROKE_POINTS); }
  void SetHatchUnitToMillimeters() { this->SetHatchUnit(STROKE_MILLIMETERS); }
  const char* GetHatchUnitAsString();
  vtkSetVector3Macro(HatchPaper, double);
  vtkGetVector3Macro(HatchPaper, double);
  vtkSetVector3Macro(HatchInk, double);
  vtkGetVector3Macro(HatchInk, double);
  vtkSetClampMacro(HatchPlace, int, HATCH_ON_MODEL, HATCH_ON_TEXTURE);
  vtkGetMacro(HatchPlace, int);
  void SetHatchPlaceToModel() { this->SetHatchPlace(HATCH_ON_MODEL); }
  void SetHatchPlaceToTexture() { this->SetHatchPlace(HATCH_ON_TEXTURE); }
  const char* GetHatchPlaceAsString();
  ///@}

  ///@{
  /**
   * The tone Exaggerated (Rusinkiewicz, Burns and DeCarlo 2006): the surface's normals are smoothed
   * over ExaggerationLevels scales, from the mean distance of neighbouring points to
   * ExaggerationScale times the root of the surface's area (at most 32 of these distances), and
   * each scale is lit by light that grazes the surface as the next coarser one has it. Its cosine
   * is magnified by ExaggerationContrast and clamped; scales are weighed by their size to the power
   * of ExaggerationExponent, so that above 0 large shapes count more and below fine detail; and
   * ExaggerationBase is the share of the plain light of the coarsest normal. Normals are apart on
   * the two sides of edges sharper than FeatureAngle or, where that is 180, CreaseAngle, but for
   * those that the data's normals say to be smooth; so flat faces have no detail. The normals are
   * computed when the mesh changes, and take 4 bytes a point and level, and where there are sharp
   * edges 24 for each triangle. The light is best perpendicular to the gaze, as ToneLight
   * UpperRight is. Defaults: 10, 0, 0.4, 5, 0.06.
   */
  vtkSetClampMacro(ExaggerationContrast, double, 0.0, 1000.0);
  vtkGetMacro(ExaggerationContrast, double);
  vtkSetClampMacro(ExaggerationExponent, double, -4.0, 4.0);
  vtkGetMacro(ExaggerationExponent, double);
  vtkSetClampMacro(ExaggerationBase, double, 0.0, 1.0);
  vtkGetMacro(ExaggerationBase, double);
  vtkSetClampMacro(ExaggerationLevels, int, 1, 8);
  vtkGetMacro(ExaggerationLevels, int);
  vtkSetClampMacro(ExaggerationScale, double, 0.0001, 1.0);
  vtkGetMacro(ExaggerationScale, double);
  ///@}

  ///@{
  /**
   * The ends of the scale: k_cool = CoolColor + CoolSurface k_d and k_warm = WarmColor +
   * WarmSurface k_d. Defaults: (0, 0, 0.4) and 0.2, (0.4, 0.4, 0) and 0.6.
   */
  vtkSetVector3Macro(CoolColor, double);
  vtkGetVector3Macro(CoolColor, double);
  vtkSetVector3Macro(WarmColor, double);
  vtkGetVector3Macro(WarmColor, double);
  vtkSetMacro(CoolSurface, double);
  vtkGetMacro(CoolSurface, double);
  vtkSetMacro(WarmSurface, double);
  vtkGetMacro(WarmSurface, double);
  ///@}

  enum TonesOverData
  {
    DATA_TONE_CLASSIC = 0,
    DATA_TONE_UNDERTONE,
    DATA_TONE_LEGEND_SAFE
  };

  ///@{
  /**
   * What a Tone does with colours that the mapper makes of scalars. Classic, the default: what it
   * does with any other k_d, so that the legend no longer shows them. Undertone mixes the tone of a
   * grey surface into them, by the share Undertone (0 to 1; default: 0.25). LegendSafe moves their
   * lightness alone, L* of CIELAB, from -LegendSafeRange where the surface turns away from the
   * light to +LegendSafeRange where it faces it (0 to 100; default: 12); where the screen has no
   * such colour, by less, and not at all for pure red, green or blue. It is less, too, with a table
   * whose values lie in their lightness alone, as a grey scale's: as much as adds 3.8 % of the
   * table's range to the mean error of values read off the picture. Neither adds a highlight.
   * Colours are taken to be sRGB.
   *
   * @sa
   * vtkLimnToneLegend, which shows the colours that are drawn, and finds how far they can be read
   */
  vtkSetClampMacro(ToneOverData, int, DATA_TONE_CLASSIC, DATA_TONE_LEGEND_SAFE);
  vtkGetMacro(ToneOverData, int);
  void SetToneOverDataToClassic() { this->SetToneOverData(DATA_TONE_CLASSIC); }
  void SetToneOverDataToUndertone() { this->SetToneOverData(DATA_TONE_UNDERTONE); }
  void SetToneOverDataToLegendSafe() { this->SetToneOverData(DATA_TONE_LEGEND_SAFE); }
  const char* GetToneOverDataAsString();
  vtkSetClampMacro(Undertone, double, 0.0, 1.0);
  vtkGetMacro(Undertone, double);
  vtkSetClampMacro(LegendSafeRange, double, 0.0, 100.0);
  vtkGetMacro(LegendSafeRange, double);
  ///@}

  enum Outlines
  {
    OUTLINE_NONE = 0,
    OUTLINE_NORMAL,
    OUTLINE_HULL,
    OUTLINE_IMAGE
  };

  ///@{
  /**
   * Normal: pixels where |n.v| is below OutlineThreshold get OutlineColor, a line that is the wider
   * the flatter the surface turns away; with an OutlineWidth a line of that width inside the
   * surface's border. Hull: a line outside of the surface, OutlineWidth pixels wide at any
   * distance, tilt and shape of window, around it and along the contours before other parts of it,
   * mitred at corners: the faces that look away are drawn once more, their outer corners moved out
   * on the screen, and so is what lies beyond borders. Points in the same place count as one, and
   * neighbours as wound alike. Picking takes what the line covers. Image: a line inside of the
   * surface's borders and steps, and along its creases, found in the finished picture by
   * OutlineDetector. Default: None.
   */
  vtkSetClampMacro(Outline, int, OUTLINE_NONE, OUTLINE_IMAGE);
  vtkGetMacro(Outline, int);
  void SetOutlineToNone() { this->SetOutline(OUTLINE_NONE); }
  void SetOutlineToNormal() { this->SetOutline(OUTLINE_NORMAL); }
  void SetOutlineToHull() { this->SetOutline(OUTLINE_HULL); }
  void SetOutlineToImage() { this->SetOutline(OUTLINE_IMAGE); }
  const char* GetOutlineAsString();
  ///@}

  ///@{
  /**
   * From 0 (no outline) to 1 (all of the surface). Default: 0.2.
   */
  vtkSetClampMacro(OutlineThreshold, double, 0.0, 1.0);
  vtkGetMacro(OutlineThreshold, double);
  ///@}

  ///@{
  /**
   * In pixels, at least 0; for Image at most 64: a wider one is not drawn, with a warning. Default:
   * 0, which means a line by OutlineThreshold for Normal, 1.5 pixels for Hull and 2 for Image.
   */
  vtkSetMacro(OutlineWidth, double);
  vtkGetMacro(OutlineWidth, double);
  ///@}

  ///@{
  /**
   * Default: black.
   */
  vtkSetVector3Macro(OutlineColor, double);
  vtkGetVector3Macro(OutlineColor, double);
  ///@}

  ///@{
  /**
   * How much of the line is seen, 0 to 1; the rest is the surface's colour. Default: 1.
   */
  vtkSetClampMacro(OutlineOpacity, double, 0.0, 1.0);
  vtkGetMacro(OutlineOpacity, double);
  ///@}

  enum OutlineDetectors
  {
    OUTLINE_BY_PLANE = 0,
    OUTLINE_BY_SOBEL,
    OUTLINE_BY_LAPLACIAN
  };

  ///@{
  /**
   * How Image finds steps in the depth of one actor; borders to others are always found. Plane:
   * what two pixels show are planes that predict each other, so that tilted surfaces have no false
   * lines. Sobel and Laplacian are the classical convolutions, for comparison: Sobel blackens
   * surfaces that are tilted by more than OutlineDepthTolerance. Default: Plane.
   */
  vtkSetClampMacro(OutlineDetector, int, OUTLINE_BY_PLANE, OUTLINE_BY_LAPLACIAN);
  vtkGetMacro(OutlineDetector, int);
  void SetOutlineDetectorToPlane() { this->SetOutlineDetector(OUTLINE_BY_PLANE); }
  void SetOutlineDetectorToSobel() { this->SetOutlineDetector(OUTLINE_BY_SOBEL); }
  void SetOutlineDetectorToLaplacian() { this->SetOutlineDetector(OUTLINE_BY_LAPLACIAN); }
  const char* GetOutlineDetectorAsString();
  ///@}

  ///@{
  /**
   * How deep a step has to be for Image, in pixels' widths where it is, at least 0. Default: 3.
   */
  vtkSetMacro(OutlineDepthTolerance, double);
  vtkGetMacro(OutlineDepthTolerance, double);
  ///@}

  ///@{
  /**
   * Degrees between normals of pixels next to each other above which Image draws a crease, 0 to
   * 180; with 180 none. Default: 40.
   */
  vtkSetClampMacro(OutlineCreaseAngle, double, 0.0, 180.0);
  vtkGetMacro(OutlineCreaseAngle, double);
  ///@}

  enum OutlineCreaseDetectors
  {
    CREASES_BY_ANGLE = 0,
    CREASES_BY_SOBEL,
    CREASES_BY_LAPLACIAN
  };

  ///@{
  /**
   * How Image finds creases in the normals of the picture. Angle: between two pixels next to each
   * other. Sobel: by the gradient of the normals over three rows and columns, so that bevels no
   * wider than two pixels count as well. Laplacian: where that of the normals turns over. Default:
   * Angle.
   */
  vtkSetClampMacro(OutlineCreaseDetector, int, CREASES_BY_ANGLE, CREASES_BY_LAPLACIAN);
  vtkGetMacro(OutlineCreaseDetector, int);
  void SetOutlineCreaseDetectorToAngle() { this->SetOutlineCreaseDetector(CREASES_BY_ANGLE); }
  void SetOutlineCreaseDetectorToSobel() { this->SetOutlineCreaseDetector(CREASES_BY_SOBEL); }
  void SetOutlineCreaseDetectorToLaplacian()
  {
    this->SetOutlineCreaseDetector(CREASES_BY_LAPLACIAN);
  }
  const char* GetOutlineCreaseDetectorAsString();
  ///@}

  ///@{
  /**
   * Whether Image draws lines, in the middle as those of creases, between parts of one actor, too:
   * where the cell array named by SetIdArrayName() changes, or the cell scalars if that is not set.
   * Default: off.
   */
  vtkSetMacro(OutlineIds, bool);
  vtkGetMacro(OutlineIds, bool);
  vtkBooleanMacro(OutlineIds, bool);
  ///@}

  ///@{
  /**
   * Lines along edges of the mesh, drawn as strokes: creases, whose faces' normals are more than
   * CreaseAngle apart; borders, of one face; non-manifold edges, of three faces or more; edges
   * whose faces differ in the cell array named by SetIdArrayName(), or the cell scalars if that is
   * not set; edges at which point normals are split. Points in one place are one point. Default:
   * off.
   */
  vtkSetMacro(CreaseLines, bool);
  vtkGetMacro(CreaseLines, bool);
  vtkBooleanMacro(CreaseLines, bool);
  vtkSetMacro(BorderLines, bool);
  vtkGetMacro(BorderLines, bool);
  vtkBooleanMacro(BorderLines, bool);
  vtkSetMacro(NonManifoldLines, bool);
  vtkGetMacro(NonManifoldLines, bool);
  vtkBooleanMacro(NonManifoldLines, bool);
  vtkSetMacro(IdLines, bool);
  vtkGetMacro(IdLines, bool);
  vtkBooleanMacro(IdLines, bool);
  vtkSetMacro(NormalLines, bool);
  vtkGetMacro(NormalLines, bool);
  vtkBooleanMacro(NormalLines, bool);
  vtkSetStringMacro(IdArrayName);
  vtkGetStringMacro(IdArrayName);
  ///@}

  ///@{
  /**
   * The line where the surface turns away from the viewer. Between creases the surface is taken to
   * be smooth, and the line follows that and not the edges of the mesh; it is found anew for each
   * step of the camera. On coarse meshes it lies beside the facets that are seen; silhouettes, the
   * edges between a face seen from its front and one seen from its back, lie on them. Default: off.
   */
  vtkSetMacro(ContourLines, bool);
  vtkGetMacro(ContourLines, bool);
  vtkBooleanMacro(ContourLines, bool);
  vtkSetMacro(SilhouetteLines, bool);
  vtkGetMacro(SilhouetteLines, bool);
  vtkBooleanMacro(SilhouetteLines, bool);
  ///@}

  ///@{
  /**
   * Lines inside of smooth surfaces, found from curvature, which is computed when the mesh changes:
   * ridges and valleys, where the surface bends most sharply outwards or inwards, and suggestive
   * contours, which would be contours from a view nearby; convex bodies have none. Noisy meshes
   * have many. Default: off.
   */
  vtkSetMacro(RidgeLines, bool);
  vtkGetMacro(RidgeLines, bool);
  vtkBooleanMacro(RidgeLines, bool);
  vtkSetMacro(ValleyLines, bool);
  vtkGetMacro(ValleyLines, bool);
  vtkBooleanMacro(ValleyLines, bool);
  vtkSetMacro(SuggestiveLines, bool);
  vtkGetMacro(SuggestiveLines, bool);
  vtkBooleanMacro(SuggestiveLines, bool);
  ///@}

  ///@{
  /**
   * How much a surface bends where it has a ridge or valley: more than RidgeThreshold over s, a
   * fortieth of the diagonal of the mesh's box. And where it has a suggestive contour: its radial
   * curvature grows towards the viewer by more than SuggestiveThreshold over s squared. At least 0;
   * 0 gives all lines. Default: 0.1 and 0.01.
   */
  vtkSetMacro(RidgeThreshold, double);
  vtkGetMacro(RidgeThreshold, double);
  vtkSetMacro(SuggestiveThreshold, double);
  vtkGetMacro(SuggestiveThreshold, double);
  ///@}

  ///@{
  /**
   * Strokes along the greater principal curvature and, where it is darker than half, across it
   * (Hertzmann and Zorin 2000), straight ones on flat faces; not over edges above FeatureAngle or,
   * where that is 180, CreaseAngle (60 degrees at least if the data's normals are smooth): the
   * denser the less light the lights send, as the tone Hatching has it, by HatchDarkest and
   * HatchSpacing, which is the distance of strokes along the curvature where half of the light
   * arrives, in steps of two between which strokes swell. No closer than 1/200 of the diagonal of
   * the mesh's box. They are found when the mesh changes, so that they stay where they are when the
   * camera moves, and drawn below all other lines, HatchWidth times as wide and on flat faces up to
   * 1.3 times that, their ends tapered over HatchSpacing at least. Defaults: off,
   * 0.6.
   */
  vtkSetMacro(HatchLines, bool);
  vtkGetMacro(HatchLines, bool);
  vtkBooleanMacro(HatchLines, bool);
  vtkSetClampMacro(HatchWidth, double, 0.01, 256.0);
  vtkGetMacro(HatchWidth, double);
  ///@}

  ///@{
  /**
   * Lines of light. The terminator is where a surface turns away from a light, n.l = 0; along edges
   * sharper than CreaseAngle it follows edges that are lit on one side. Shadow lines are the
   * borders of the shadows that this actor casts, on itself and on all others of Limn's in the
   * renderer, whether these have lines or not, and all of them keep light from each other. Surfaces
   * are not darkened. Both are of LineLights; those are found anew when a light or a surface moves,
   * not for the camera. Default: off.
   */
  vtkSetMacro(TerminatorLines, bool);
  vtkGetMacro(TerminatorLines, bool);
  vtkBooleanMacro(TerminatorLines, bool);
  vtkSetMacro(ShadowLines, bool);
  vtkGetMacro(ShadowLines, bool);
  vtkBooleanMacro(ShadowLines, bool);
  ///@}

  enum LineLightChoices
  {
    LINE_LIGHTS_FIRST = 0,
    LINE_LIGHTS_ALL
  };
  ///@{
  /**
   * Which lights have terminators and shadows: the renderer's first that is on and no headlight, or
   * the headlight if there is no other; or all that are on.
   * Rectangles and spheres count as points in their middle. Default: First.
   */
  vtkSetClampMacro(LineLights, int, LINE_LIGHTS_FIRST, LINE_LIGHTS_ALL);
  vtkGetMacro(LineLights, int);
  void SetLineLightsToFirst() { this->SetLineLights(LINE_LIGHTS_FIRST); }
  void SetLineLightsToAll() { this->SetLineLights(LINE_LIGHTS_ALL); }
  const char* GetLineLightsAsString();
  ///@}

  ///@{
  /**
   * The lines where this actor's surface cuts itself or others of Limn's in the renderer. Where two
   * actors that both have them meet, the line is the first one's. Default: off.
   */
  vtkSetMacro(IntersectionLines, bool);
  vtkGetMacro(IntersectionLines, bool);
  vtkBooleanMacro(IntersectionLines, bool);
  ///@}

  ///@{
  /**
   * In degrees, 0 to 180, for CreaseLines, ContourLines, TerminatorLines and ShadowLines, which no
   * smooth surface has right where it turns away from the light, for HatchLines and for the tone
   * Exaggerated. Default: 40.
   */
  vtkSetClampMacro(CreaseAngle, double, 0.0, 180.0);
  vtkGetMacro(CreaseAngle, double);
  ///@}

  ///@{
  /**
   * The fewest edges of a crease among CreaseLines: of fewer edges that hang together, with those
   * of the other lines along edges, none is drawn, unless one is sharper than 60 degrees or of
   * another kind, too. Rough surfaces, as scans have them, bend by more than any CreaseAngle here
   * and there. Default: 1, which draws all.
   */
  vtkSetClampMacro(ShortestCrease, int, 1, VTK_INT_MAX);
  vtkGetMacro(ShortestCrease, int);
  ///@}

  ///@{
  /**
   * How wide lines are on the screen, whatever the distance and the tilt, in StrokeUnit: pixels, or
   * points (1/72 inch) or millimetres by the window's DPI. At most 256 pixels. Default: 1.5 pixels.
   */
  vtkSetMacro(StrokeWidth, double);
  vtkGetMacro(StrokeWidth, double);
  vtkSetClampMacro(StrokeUnit, int, STROKE_PIXELS, STROKE_MILLIMETERS);
  vtkGetMacro(StrokeUnit, int);
  void SetStrokeUnitToPixels() { this->SetStrokeUnit(STROKE_PIXELS); }
  void SetStrokeUnitToPoints() { this->SetStrokeUnit(STROKE_POINTS); }
  void SetStrokeUnitToMillimeters() { this->SetStrokeUnit(STROKE_MILLIMETERS); }
  const char* GetStrokeUnitAsString();
  ///@}

  ///@{
  /**
   * How many times as wide lines are that have something else behind them: contours, borders and
   * creases of which one face is turned away. Default: 1.
   */
  vtkSetClampMacro(OuterWidthFactor, double, 0.0, 256.0);
  vtkGetMacro(OuterWidthFactor, double);
  ///@}

  ///@{
  /**
   * Colour and opacity of lines. Where lines of one actor cross they are no darker. Default: opaque
   * black.
   */
  vtkSetVector3Macro(StrokeColor, double);
  vtkGetVector3Macro(StrokeColor, double);
  vtkSetClampMacro(StrokeOpacity, double, 0.0, 1.0);
  vtkGetMacro(StrokeOpacity, double);
  ///@}

  ///@{
  /**
   * In pixels: over StrokeTaper the ends of lines grow from nothing to their full width; StrokeDash
   * and StrokeGap make lines dashed, where both are above 0. Default: 0.
   */
  vtkSetMacro(StrokeTaper, double);
  vtkGetMacro(StrokeTaper, double);
  vtkSetMacro(StrokeDash, double);
  vtkGetMacro(StrokeDash, double);
  vtkSetMacro(StrokeGap, double);
  vtkGetMacro(StrokeGap, double);
  ///@}

  enum HiddenLineStyles
  {
    HIDDEN_LINES_OFF = 0,
    HIDDEN_LINES_DASHED,
    HIDDEN_LINES_THIN
  };

  ///@{
  /**
   * What is drawn of lines where surfaces hide them: nothing, dashes, or the line; the latter two
   * half as wide. Default: Off.
   */
  vtkSetClampMacro(HiddenLines, int, HIDDEN_LINES_OFF, HIDDEN_LINES_THIN);
  vtkGetMacro(HiddenLines, int);
  void SetHiddenLinesToOff() { this->SetHiddenLines(HIDDEN_LINES_OFF); }
  void SetHiddenLinesToDashed() { this->SetHiddenLines(HIDDEN_LINES_DASHED); }
  void SetHiddenLinesToThin() { this->SetHiddenLines(HIDDEN_LINES_THIN); }
  const char* GetHiddenLinesAsString();
  ///@}

  ///@{
  /**
   * Eye-dome lighting: a point is the darker, the more of what is around it in the picture lies
   * before it, by EyeDomeStrength, 0 to 100. The same in perspective and in parallel projection,
   * and for every size of the picture: EyeDomeRadius, above 0 to 0.02, is a share of its diagonal.
   * Depth cues change surfaces and no line, text or scalar bar. Of opaque actors. Defaults: off, 1
   * and 0.001.
   */
  vtkSetMacro(EyeDomeLighting, bool);
  vtkGetMacro(EyeDomeLighting, bool);
  vtkBooleanMacro(EyeDomeLighting, bool);
  vtkSetMacro(EyeDomeStrength, double);
  vtkGetMacro(EyeDomeStrength, double);
  vtkSetMacro(EyeDomeRadius, double);
  vtkGetMacro(EyeDomeRadius, double);
  ///@}

  enum DepthUnsharpModes
  {
    DEPTH_UNSHARP_OFF = 0,
    DEPTH_UNSHARP_DARKEN,
    DEPTH_UNSHARP_BOTH
  };

  ///@{
  /**
   * Unsharp masking of the depth (Luft, Colditz and Deussen 2006): what lies behind the mean of its
   * surroundings gets darker, and with Both what lies before it lighter, by DepthUnsharpStrength, 0
   * to 1. DepthUnsharpRadius, above 0 to 0.1 of the picture's diagonal, is the standard deviation
   * of these surroundings. Of opaque actors. Defaults: Off, 0.5 and 0.02.
   */
  vtkSetClampMacro(DepthUnsharp, int, DEPTH_UNSHARP_OFF, DEPTH_UNSHARP_BOTH);
  vtkGetMacro(DepthUnsharp, int);
  void SetDepthUnsharpToOff() { this->SetDepthUnsharp(DEPTH_UNSHARP_OFF); }
  void SetDepthUnsharpToDarken() { this->SetDepthUnsharp(DEPTH_UNSHARP_DARKEN); }
  void SetDepthUnsharpToBoth() { this->SetDepthUnsharp(DEPTH_UNSHARP_BOTH); }
  const char* GetDepthUnsharpAsString();
  vtkSetMacro(DepthUnsharpStrength, double);
  vtkGetMacro(DepthUnsharpStrength, double);
  vtkSetMacro(DepthUnsharpRadius, double);
  vtkGetMacro(DepthUnsharpRadius, double);
  ///@}

  ///@{
  /**
   * A gap of HaloColor that the actor cuts into what of Limn's surfaces lies behind its borders,
   * parts of itself too, HaloWidth wide in HaloUnit (one of StrokeUnits), at most 64 pixels; 0, the
   * default, for none. It has its full width where these lie HaloDepth widths behind, and is the
   * narrower the less that is. Lines there are cut, too; those of the actor itself only where
   * they lie so far behind. Translucent actors behind it have the gap's colour at their own
   * opacity, but not in OpenGL windows. Defaults: pixels, 4 and white.
   */
  vtkSetMacro(HaloWidth, double);
  vtkGetMacro(HaloWidth, double);
  vtkSetClampMacro(HaloUnit, int, STROKE_PIXELS, STROKE_MILLIMETERS);
  vtkGetMacro(HaloUnit, int);
  void SetHaloUnitToPixels() { this->SetHaloUnit(STROKE_PIXELS); }
  void SetHaloUnitToPoints() { this->SetHaloUnit(STROKE_POINTS); }
  void SetHaloUnitToMillimeters() { this->SetHaloUnit(STROKE_MILLIMETERS); }
  const char* GetHaloUnitAsString();
  vtkSetMacro(HaloDepth, double);
  vtkGetMacro(HaloDepth, double);
  vtkSetVector3Macro(HaloColor, double);
  vtkGetVector3Macro(HaloColor, double);
  ///@}

  enum TextureRoles
  {
    TEXTURE_SHADED = 0,
    TEXTURE_SURFACE
  };

  ///@{
  /**
   * What the actor's texture, this property's textures by names of the user's choice and the
   * procedural texture change. Shaded, the default, as VTK: the colour after light, highlights
   * too. Surface: ambient and diffuse colour, k_a and k_d, before light is computed; with the
   * frequency Gouraud, which lights corners, as Shaded.
   */
  vtkSetClampMacro(TextureRole, int, TEXTURE_SHADED, TEXTURE_SURFACE);
  vtkGetMacro(TextureRole, int);
  void SetTextureRoleToShaded() { this->SetTextureRole(TEXTURE_SHADED); }
  void SetTextureRoleToSurface() { this->SetTextureRole(TEXTURE_SURFACE); }
  const char* GetTextureRoleAsString();
  ///@}

  enum TextureModes
  {
    TEXTURE_MODULATE = 0,
    TEXTURE_REPLACE,
    TEXTURE_DECAL,
    TEXTURE_ADD
  };

  ///@{
  /**
   * How these textures are put over a colour c, with t the texture's colour and a its alpha.
   * Modulate, the default, as VTK: c t. Replace: t. Decal: c + (t - c) a. Add: c + t. For the role
   * Surface t is weighted by Ambient or Diffuse where it is not a factor.
   */
  vtkSetClampMacro(TextureMode, int, TEXTURE_MODULATE, TEXTURE_ADD);
  vtkGetMacro(TextureMode, int);
  void SetTextureModeToModulate() { this->SetTextureMode(TEXTURE_MODULATE); }
  void SetTextureModeToReplace() { this->SetTextureMode(TEXTURE_REPLACE); }
  void SetTextureModeToDecal() { this->SetTextureMode(TEXTURE_DECAL); }
  void SetTextureModeToAdd() { this->SetTextureMode(TEXTURE_ADD); }
  const char* GetTextureModeAsString();
  ///@}

  enum ProceduralTextures
  {
    PROCEDURAL_NONE = 0,
    PROCEDURAL_CHECKER,
    PROCEDURAL_WOOD,
    PROCEDURAL_MARBLE
  };

  ///@{
  /**
   * A texture that is computed: cubes of two colours, rings about the z axis, veins along x. It is
   * put over the surface after all others. Default: None.
   */
  vtkSetClampMacro(ProceduralTexture, int, PROCEDURAL_NONE, PROCEDURAL_MARBLE);
  vtkGetMacro(ProceduralTexture, int);
  void SetProceduralTextureToNone() { this->SetProceduralTexture(PROCEDURAL_NONE); }
  void SetProceduralTextureToChecker() { this->SetProceduralTexture(PROCEDURAL_CHECKER); }
  void SetProceduralTextureToWood() { this->SetProceduralTexture(PROCEDURAL_WOOD); }
  void SetProceduralTextureToMarble() { this->SetProceduralTexture(PROCEDURAL_MARBLE); }
  const char* GetProceduralTextureAsString();
  ///@}

  enum ProceduralSpaces
  {
    PROCEDURAL_OBJECT = 0,
    PROCEDURAL_UV
  };

  ///@{
  /**
   * Whether the procedural texture reads positions, in the mesh's own coordinates, or texture
   * coordinates. Default: Object.
   */
  vtkSetClampMacro(ProceduralSpace, int, PROCEDURAL_OBJECT, PROCEDURAL_UV);
  vtkGetMacro(ProceduralSpace, int);
  void SetProceduralSpaceToObject() { this->SetProceduralSpace(PROCEDURAL_OBJECT); }
  void SetProceduralSpaceToUv() { this->SetProceduralSpace(PROCEDURAL_UV); }
  const char* GetProceduralSpaceAsString();
  ///@}

  ///@{
  /**
   * The procedural texture's two colours, its cells, rings or veins per unit, and how far noise
   * moves rings and veins, in their own width. Defaults: white, black, 1 and 0.
   */
  vtkSetVector3Macro(ProceduralColorA, double);
  vtkGetVector3Macro(ProceduralColorA, double);
  vtkSetVector3Macro(ProceduralColorB, double);
  vtkGetVector3Macro(ProceduralColorB, double);
  vtkSetMacro(ProceduralScale, double);
  vtkGetMacro(ProceduralScale, double);
  vtkSetMacro(ProceduralTurbulence, double);
  vtkGetMacro(ProceduralTurbulence, double);
  ///@}

  ///@{
  /**
   * Light that was computed before: k_d times its colour times LightmapIntensity is added to what
   * the lights give. It is read by the point array LightmapTCoords of two components, or by the
   * active texture coordinates if that is nullptr or empty. Defaults: none, 1 and nullptr.
   */
  virtual void SetLightmapTexture(vtkTexture* texture);
  vtkGetObjectMacro(LightmapTexture, vtkTexture);
  vtkSetMacro(LightmapIntensity, double);
  vtkGetMacro(LightmapIntensity, double);
  vtkSetStringMacro(LightmapTCoords);
  vtkGetStringMacro(LightmapTCoords);
  ///@}

  ///@{
  /**
   * Heights above the surface, from the image's first component (8 and 16 bits mean 0 to 1) times
   * BumpScale, in units of texture coordinates. Their gradient bends the normals of surfaces that
   * are lit per pixel. Defaults: none and 1.
   *
   * Normal maps are vtkProperty's NormalTexture and NormalScale. They need the point array of
   * tangents only where ShadingFrequency is as VTK.
   */
  virtual void SetBumpTexture(vtkTexture* texture);
  vtkGetObjectMacro(BumpTexture, vtkTexture);
  vtkSetMacro(BumpScale, double);
  vtkGetMacro(BumpScale, double);
  ///@}

  ///@{
  /**
   * A program that gives each pixel its colour in place of ReflectionModel and Tone, which it may
   * call; none by default.
   */
  virtual void SetSurfaceShader(vtkLimnSurfaceShader*);
  vtkGetObjectMacro(SurfaceShader, vtkLimnSurfaceShader);
  ///@}

  /**
   * With the surface shader's.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Copies all settings, those of a vtkLimnProperty too if `property` is one; the surface shader is
   * shared.
   */
  void DeepCopy(vtkProperty* property);

protected:
  vtkLimnProperty() = default;
  ~vtkLimnProperty() override;

  int ShadingFrequency = FREQUENCY_AS_VTK;
  int FlatPoint = FLAT_AT_CENTROID;
  int VertexNormals = NORMALS_FROM_DATA;
  double FeatureAngle = 180.0;
  int ReflectionModel = REFLECTION_AS_VTK;
  bool Fresnel = false;
  double RefractiveIndex[3] = { 1.5, 1.5, 1.5 };
  double RimColor[3] = { 0.0, 0.0, 0.0 };
  double RimPower = 3.0;
  bool FallOff = true;
  int Tone = TONE_NONE;
  double CoolColor[3] = { 0.0, 0.0, 0.4 };
  double WarmColor[3] = { 0.4, 0.4, 0.0 };
  double CoolSurface = 0.2;
  int ToneOverData = DATA_TONE_CLASSIC;
  double Undertone = 0.25;
  double LegendSafeRange = 12;
  double WarmSurface = 0.6;
  int ToonBands = 0;
  int ToneLight = TONE_LIGHT_SCENE;
  int ToneHighlight = TONE_HIGHLIGHT_ADDED;
  vtkTexture* ToonRamp = nullptr;
  int ToonRampBy = TOON_RAMP_BY_DEPTH;
  double ToonRampExponent = 1.0;
  double ToonRampRange[2] = { 0.0, 0.0 };
  vtkTexture* MatCap = nullptr;
  double HatchDarkest = 0.85;
  double HatchSpacing = 6.0;
  int HatchUnit = STROKE_PIXELS;
  double HatchPaper[3] = { 1.0, 1.0, 1.0 };
  double HatchInk[3] = { 0.0, 0.0, 0.0 };
  int HatchPlace = HATCH_ON_MODEL;
  double ExaggerationContrast = 10.0;
  double ExaggerationExponent = 0.0;
  double ExaggerationBase = 0.4;
  int ExaggerationLevels = 5;
  double ExaggerationScale = 0.06;
  int Outline = OUTLINE_NONE;
  double OutlineThreshold = 0.2;
  double OutlineWidth = 0.0;
  double OutlineColor[3] = { 0.0, 0.0, 0.0 };
  double OutlineOpacity = 1.0;
  int OutlineDetector = OUTLINE_BY_PLANE;
  double OutlineDepthTolerance = 3.0;
  double OutlineCreaseAngle = 40.0;
  int OutlineCreaseDetector = CREASES_BY_ANGLE;
  bool OutlineIds = false;
  bool CreaseLines = false;
  bool BorderLines = false;
  bool NonManifoldLines = false;
  bool IdLines = false;
  bool NormalLines = false;
  bool ContourLines = false;
  bool SilhouetteLines = false;
  bool RidgeLines = false;
  bool ValleyLines = false;
  bool SuggestiveLines = false;
  double RidgeThreshold = 0.1;
  double SuggestiveThreshold = 0.01;
  bool TerminatorLines = false;
  bool ShadowLines = false;
  bool IntersectionLines = false;
  int LineLights = LINE_LIGHTS_FIRST;
  bool HatchLines = false;
  double HatchWidth = 0.6;
  char* IdArrayName = nullptr;
  double CreaseAngle = 40.0;
  int ShortestCrease = 1;
  double StrokeWidth = 1.5;
  int StrokeUnit = STROKE_PIXELS;
  double OuterWidthFactor = 1.0;
  double StrokeColor[3] = { 0.0, 0.0, 0.0 };
  double StrokeOpacity = 1.0;
  double StrokeTaper = 0.0;
  double StrokeDash = 0.0;
  double StrokeGap = 0.0;
  int HiddenLines = HIDDEN_LINES_OFF;
  bool EyeDomeLighting = false;
  double EyeDomeStrength = 1.0;
  double EyeDomeRadius = 0.001;
  int DepthUnsharp = DEPTH_UNSHARP_OFF;
  double DepthUnsharpStrength = 0.5;
  double DepthUnsharpRadius = 0.02;
  double HaloWidth = 0.0;
  int HaloUnit = STROKE_PIXELS;
  double HaloDepth = 4.0;
  double HaloColor[3] = { 1.0, 1.0, 1.0 };
  int TextureRole = TEXTURE_SHADED;
  int TextureMode = TEXTURE_MODULATE;
  int ProceduralTexture = PROCEDURAL_NONE;
  int ProceduralSpace = PROCEDURAL_OBJECT;
  double ProceduralColorA[3] = { 1.0, 1.0, 1.0 };
  double ProceduralColorB[3] = { 0.0, 0.0, 0.0 };
  double ProceduralScale = 1.0;
  double ProceduralTurbulence = 0.0;
  vtkTexture* LightmapTexture = nullptr;
  double LightmapIntensity = 1.0;
  char* LightmapTCoords = nullptr;
  vtkTexture* BumpTexture = nullptr;
  double BumpScale = 1.0;
  vtkLimnSurfaceShader* SurfaceShader = nullptr;

private:
  void CopyWithTextures(vtkProperty* property);
  void CopyTone(vtkLimnProperty* other);
  void PrintTone(ostream& os, vtkIndent indent);
  void CopyCues(vtkLimnProperty* other);
  void PrintCues(ostream& os, vtkIndent indent);

  vtkLimnProperty(const vtkLimnProperty&) = delete;
  void operator=(const vtkLimnProperty&) = delete;
};

#endif
