// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuildScene.h"

#include "ApplyCues.h"
#include "ApplyTextures.h"
#include "ColorByArray.h"
#include "FitCamera.h"
#include "Lengths.h"
#include "Messages.h"
#include "UserError.h"

#include "vtkLimnActor.h"
#include "vtkLimnLight.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnStyle.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace limn::viewer
{
namespace
{

int shadingFrequencyOf(Shading shading)
{
  switch (shading)
  {
    case Shading::Flat:
      return vtkLimnProperty::FREQUENCY_FLAT;
    case Shading::Gouraud:
      return vtkLimnProperty::FREQUENCY_GOURAUD;
    case Shading::Phong:
      break;
  }
  return vtkLimnProperty::FREQUENCY_PHONG;
}

int normalsOf(Normals normals)
{
  switch (normals)
  {
    case Normals::Uniform:
      return vtkLimnProperty::NORMALS_UNIFORM;
    case Normals::Area:
      return vtkLimnProperty::NORMALS_BY_AREA;
    case Normals::Angle:
      return vtkLimnProperty::NORMALS_BY_ANGLE;
    case Normals::Data:
      break;
  }
  return vtkLimnProperty::NORMALS_FROM_DATA;
}

void setShading(const MaterialSettings& material, vtkLimnProperty& property)
{
  property.SetShadingFrequency(shadingFrequencyOf(material.shading));
  property.SetFlatPoint(material.flatPoint == FlatPoint::FirstVertex
                          ? vtkLimnProperty::FLAT_AT_FIRST_VERTEX
                          : vtkLimnProperty::FLAT_AT_CENTROID);
  property.SetVertexNormals(normalsOf(material.normals.value_or(Normals::Data)));
  constexpr double kNoFeatures = 180;
  property.SetFeatureAngle(material.featureAngleDegrees.value_or(kNoFeatures));
}

int reflectionModelOf(const MaterialSettings& material)
{
  if (material.localModel)
  {
    return vtkLimnProperty::REFLECTION_LOCAL_1 + *material.localModel - 1;
  }
  switch (material.reflection.value_or(kDefaultReflection))
  {
    case Reflection::None:
      return vtkLimnProperty::REFLECTION_NONE;
    case Reflection::Lambert:
      return vtkLimnProperty::REFLECTION_LAMBERT;
    case Reflection::Phong:
      return vtkLimnProperty::REFLECTION_PHONG;
    case Reflection::Irradiance:
      return vtkLimnProperty::REFLECTION_IRRADIANCE;
    case Reflection::OrenNayar:
      return vtkLimnProperty::REFLECTION_OREN_NAYAR;
    case Reflection::Metallic:
      return vtkLimnProperty::REFLECTION_METALLIC_ROUGHNESS;
    case Reflection::BlinnPhong:
      break;
  }
  return vtkLimnProperty::REFLECTION_BLINN_PHONG;
}

void setReflectance(const MaterialSettings& material, vtkLimnProperty& property)
{
  // Colours of a picture stay what they are.
  const bool isPainted = material.tone == Tone::Ramp || material.tone == Tone::MatCap ||
                         material.tone == Tone::Hatching || material.tone == Tone::Exaggerated;
  const Color none = isPainted ? Color{ 1, 1, 1 } : kDefaultColor;
  const Color diffuse = material.diffuse.value_or(material.color.value_or(none));
  const Color ambient = material.ambient.value_or(diffuse);
  // Without lights a surface shows k_a + k_d; a k_a that merely follows k_d would count twice.
  const bool hasAmbient = material.ambient || material.reflection != Reflection::None;
  property.SetDiffuseColor(diffuse.data());
  property.SetDiffuse(1);
  property.SetAmbientColor(ambient.data());
  property.SetAmbient(hasAmbient ? 1 : 0);
  property.SetSpecularColor(material.specular.data());
  property.SetSpecular(1);
  property.SetSpecularPower(material.specularPower);
  property.SetOpacity(material.opacity);
}

void setReflection(const MaterialSettings& material, vtkLimnProperty& property)
{
  const Color index = material.refractiveIndex.value_or(
    Color{ kDefaultRefractiveIndex, kDefaultRefractiveIndex, kDefaultRefractiveIndex });
  property.SetReflectionModel(reflectionModelOf(material));
  property.SetRoughness(material.roughness.value_or(kDefaultRoughness));
  property.SetMetallic(material.metallic.value_or(0));
  property.SetBaseIOR(index[0]);
  property.SetRefractiveIndex(index.data());
  property.SetFresnel(material.fresnel);
  property.SetRimColor(material.rim.value_or(Color{ 0, 0, 0 }).data());
  property.SetRimPower(material.rimPower.value_or(kDefaultRimPower));
}

int toneOf(Tone tone)
{
  switch (tone)
  {
    case Tone::Gooch:
      return vtkLimnProperty::TONE_GOOCH;
    case Tone::GoochChapter:
      return vtkLimnProperty::TONE_GOOCH_CHAPTER;
    case Tone::GoochRtr4:
    case Tone::GoochOrangeBook:
      return vtkLimnProperty::TONE_GOOCH;
    case Tone::Metal:
      return vtkLimnProperty::TONE_METAL;
    case Tone::Toon:
      return vtkLimnProperty::TONE_TOON;
    case Tone::Ramp:
      return vtkLimnProperty::TONE_RAMP;
    case Tone::MatCap:
      return vtkLimnProperty::TONE_MAT_CAP;
    case Tone::Hatching:
      return vtkLimnProperty::TONE_HATCHING;
    case Tone::Exaggerated:
      return vtkLimnProperty::TONE_EXAGGERATED;
    case Tone::None:
      break;
  }
  return vtkLimnProperty::TONE_NONE;
}

int toneOverDataOf(ToneOverData tone)
{
  switch (tone)
  {
    case ToneOverData::Undertone:
      return vtkLimnProperty::DATA_TONE_UNDERTONE;
    case ToneOverData::LegendSafe:
      return vtkLimnProperty::DATA_TONE_LEGEND_SAFE;
    case ToneOverData::Classic:
      break;
  }
  return vtkLimnProperty::DATA_TONE_CLASSIC;
}

void setToneOverData(const MaterialSettings& material, vtkLimnProperty& property)
{
  property.SetToneOverData(toneOverDataOf(material.toneOverData.value_or(ToneOverData::Classic)));
  property.SetUndertone(material.undertone.value_or(property.GetUndertone()));
  property.SetLegendSafeRange(material.legendSafeRange.value_or(property.GetLegendSafeRange()));
}

/// What of a tone the user need not name.
void setConstants(const MaterialSettings& material, vtkLimnProperty& property)
{
  const bool isOrangeBook = material.tone == Tone::GoochOrangeBook;
  if (isOrangeBook)
  {
    property.SetGoochToOrangeBook();
  }
  else if (material.tone == Tone::GoochRtr4)
  {
    property.SetGoochToRTR4();
  }
  else if (material.tone == Tone::Metal)
  {
    property.SetMetalToSteel();
  }
  else
  {
    property.SetGoochTo1998();
  }
  const std::optional<Color> diffuse = material.diffuse ? material.diffuse : material.color;
  if (isOrangeBook && diffuse)
  {
    property.SetDiffuseColor(diffuse->data());
  }
}

int rampDetailOf(RampBy by)
{
  switch (by)
  {
    case RampBy::Silhouette:
      return vtkLimnProperty::TOON_RAMP_BY_SILHOUETTE;
    case RampBy::Highlight:
      return vtkLimnProperty::TOON_RAMP_BY_HIGHLIGHT;
    case RampBy::Depth:
      break;
  }
  return vtkLimnProperty::TOON_RAMP_BY_DEPTH;
}

void setRamp(const MaterialSettings& material, vtkLimnProperty& property)
{
  property.SetToonRampBy(rampDetailOf(material.rampBy.value_or(RampBy::Depth)));
  property.SetToonRampExponent(material.rampExponent.value_or(1));
  property.SetToonRampRange(material.rampRange.value_or(std::array<double, 2>{ 0, 0 }).data());
}

void setHatching(const MaterialSettings& material, vtkLimnProperty& property)
{
  if (material.hatchSpacing)
  {
    property.SetHatchSpacing(material.hatchSpacing->value);
    property.SetHatchUnit(material.hatchSpacing->unit);
  }
  property.SetHatchDarkest(material.hatchDarkest.value_or(property.GetHatchDarkest()));
  property.SetHatchPaper(material.hatchPaper.value_or(Color{ 1, 1, 1 }).data());
  property.SetHatchInk(material.hatchInk.value_or(Color{ 0, 0, 0 }).data());
  property.SetHatchPlace(material.hatchPlace == HatchPlace::Texture
                           ? vtkLimnProperty::HATCH_ON_TEXTURE
                           : vtkLimnProperty::HATCH_ON_MODEL);
}

void setExaggeration(const ExaggerationSettings& settings, vtkLimnProperty& property)
{
  property.SetExaggerationContrast(settings.contrast.value_or(property.GetExaggerationContrast()));
  property.SetExaggerationExponent(settings.exponent.value_or(property.GetExaggerationExponent()));
  property.SetExaggerationBase(settings.base.value_or(property.GetExaggerationBase()));
  property.SetExaggerationLevels(settings.levels.value_or(property.GetExaggerationLevels()));
  property.SetExaggerationScale(settings.scale.value_or(property.GetExaggerationScale()));
}

int outlineOf(Outline outline)
{
  switch (outline)
  {
    case Outline::Normal:
      return vtkLimnProperty::OUTLINE_NORMAL;
    case Outline::Hull:
      return vtkLimnProperty::OUTLINE_HULL;
    case Outline::Image:
      return vtkLimnProperty::OUTLINE_IMAGE;
    case Outline::None:
      break;
  }
  return vtkLimnProperty::OUTLINE_NONE;
}

int outlineDetectorOf(Detector detector)
{
  switch (detector)
  {
    case Detector::Sobel:
      return vtkLimnProperty::OUTLINE_BY_SOBEL;
    case Detector::Laplacian:
      return vtkLimnProperty::OUTLINE_BY_LAPLACIAN;
    case Detector::Plane:
      break;
  }
  return vtkLimnProperty::OUTLINE_BY_PLANE;
}

int creaseDetectorOf(CreaseDetector detector)
{
  switch (detector)
  {
    case CreaseDetector::Sobel:
      return vtkLimnProperty::CREASES_BY_SOBEL;
    case CreaseDetector::Laplacian:
      return vtkLimnProperty::CREASES_BY_LAPLACIAN;
    case CreaseDetector::Angle:
      break;
  }
  return vtkLimnProperty::CREASES_BY_ANGLE;
}

void setOutline(const SceneSettings& settings, vtkLimnProperty& property)
{
  const MaterialSettings& material = settings.material;
  // 0: as wide as its kind usually is.
  const double width = material.outlineWidth ? pixelsOf(*material.outlineWidth, settings) : 0;
  const bool isVisible = width > 0 || !material.outlineWidth;
  property.SetOutline(outlineOf(isVisible ? material.outline : Outline::None));
  property.SetOutlineColor(material.outlineColor.value_or(Color{ 0, 0, 0 }).data());
  property.SetOutlineWidth(width);
  property.SetOutlineOpacity(material.outlineOpacity.value_or(1));
  property.SetOutlineDetector(
    outlineDetectorOf(material.outlineDetector.value_or(Detector::Plane)));
  if (material.outlineTolerance)
  {
    property.SetOutlineDepthTolerance(*material.outlineTolerance);
  }
  if (material.outlineCreaseDegrees)
  {
    property.SetOutlineCreaseAngle(*material.outlineCreaseDegrees);
  }
  property.SetOutlineCreaseDetector(
    creaseDetectorOf(material.outlineCreases.value_or(CreaseDetector::Angle)));
  property.SetOutlineIds(material.outlineIds);
}

void setIllustration(const SceneSettings& settings, vtkLimnProperty& property)
{
  const MaterialSettings& material = settings.material;
  setConstants(material, property);
  property.SetTone(toneOf(material.tone));
  setToneOverData(material, property);
  property.SetToonBands(material.toonSteps.value_or(0));
  property.SetToneLight(material.toneLight == ToneLight::UpperRight
                          ? vtkLimnProperty::TONE_LIGHT_UPPER_RIGHT
                          : vtkLimnProperty::TONE_LIGHT_SCENE);
  setRamp(material, property);
  setHatching(material, property);
  setExaggeration(material.exaggeration, property);
  if (material.cool)
  {
    property.SetCoolColor(material.cool->data());
    property.SetCoolSurface(0);
  }
  if (material.warm)
  {
    property.SetWarmColor(material.warm->data());
    property.SetWarmSurface(0);
  }
  setOutline(settings, property);
}

void setRectangle(const LightSettings& settings, vtkLimnLight& light)
{
  auto [a, b] = settings.sides;
  light.SetShapeToRectangle();
  light.SetWidth(vtkMath::Normalize(a.data()));
  light.SetHeight(vtkMath::Normalize(b.data()));
  light.SetViewUp(b.data());
  double ahead[3];
  vtkMath::Cross(a.data(), b.data(), ahead);
  const Vector3& from = settings.position;
  light.SetFocalPoint(from[0] + ahead[0], from[1] + ahead[1], from[2] + ahead[2]);
}

void setPosition(const LightSettings& settings, vtkLimnLight& light)
{
  const bool isSpot = settings.kind == LightKind::Spot;
  constexpr double kNoCone = 180;
  light.PositionalOn();
  light.SetUnit(settings.isPower ? vtkLimnLight::UNIT_POWER : vtkLimnLight::UNIT_INTENSITY);
  light.SetAttenuationValues(settings.attenuation.data());
  light.SetConeAngle(isSpot ? settings.coneDegrees : kNoCone);
  light.SetExponent(isSpot ? settings.exponent : 0);
  light.SetSoftEdgeAngle(settings.softDegrees);
  light.SetSamples(settings.samples);
  if (settings.kind == LightKind::Rectangle)
  {
    setRectangle(settings, light);
  }
  else if (settings.kind == LightKind::Sphere)
  {
    light.SetShapeToSphere();
    light.SetRadius(settings.radius);
  }
}

vtkSmartPointer<vtkLight> makeLight(const LightSettings& settings)
{
  auto light = vtkSmartPointer<vtkLimnLight>::New();
  light->SetColor(settings.color.data());
  if (settings.kind == LightKind::Headlight)
  {
    light->SetLightTypeToHeadlight();
    return light;
  }
  const Vector3& from = settings.position;
  const Vector3& along = settings.direction;
  light->SetLightTypeToSceneLight();
  light->SetPosition(from.data());
  light->SetFocalPoint(from[0] + along[0], from[1] + along[1], from[2] + along[2]);
  if (settings.kind != LightKind::Directional)
  {
    setPosition(settings, *light);
  }
  return light;
}

void addLights(const SceneSettings& settings, vtkRenderer& renderer)
{
  renderer.RemoveAllLights();
  renderer.AutomaticLightCreationOff();
  renderer.SetAmbient(settings.ambientLight.data());
  const std::vector<LightSettings> headlight(1);
  for (const LightSettings& light : settings.lights.empty() ? headlight : settings.lights)
  {
    renderer.AddLight(makeLight(light));
  }
}

void setLineKinds(const std::vector<LineKind>& kinds, vtkLimnProperty& property)
{
  const auto has = [&](LineKind kind)
  { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); };
  property.SetCreaseLines(has(LineKind::Crease));
  property.SetBorderLines(has(LineKind::Border));
  property.SetNonManifoldLines(has(LineKind::NonManifold));
  property.SetIdLines(has(LineKind::Ids));
  property.SetNormalLines(has(LineKind::Normals));
  property.SetContourLines(has(LineKind::Contour));
  property.SetSilhouetteLines(has(LineKind::Silhouette));
  property.SetRidgeLines(has(LineKind::Ridge));
  property.SetValleyLines(has(LineKind::Valley));
  property.SetSuggestiveLines(has(LineKind::Suggestive));
  property.SetTerminatorLines(has(LineKind::Terminator));
  property.SetShadowLines(has(LineKind::Shadow));
  property.SetIntersectionLines(has(LineKind::Intersections));
  property.SetHatchLines(has(LineKind::Hatch));
}

int hiddenLinesOf(HiddenLines hidden)
{
  switch (hidden)
  {
    case HiddenLines::Dashed:
      return vtkLimnProperty::HIDDEN_LINES_DASHED;
    case HiddenLines::Thin:
      return vtkLimnProperty::HIDDEN_LINES_THIN;
    case HiddenLines::Off:
      break;
  }
  return vtkLimnProperty::HIDDEN_LINES_OFF;
}

/// As far as they are given.
void applyDash(const SceneSettings& settings, vtkLimnProperty& property)
{
  const LineSettings& lines = settings.lines;
  if (lines.taper)
  {
    property.SetStrokeTaper(pixelsOf(*lines.taper, settings));
  }
  if (lines.dash)
  {
    property.SetStrokeDash(pixelsOf((*lines.dash)[0], settings));
    property.SetStrokeGap(pixelsOf((*lines.dash)[1], settings));
  }
}

void applyLines(const SceneSettings& settings, vtkLimnProperty& property)
{
  const LineSettings& lines = settings.lines;
  setLineKinds(lines.kinds, property);
  property.SetHiddenLines(hiddenLinesOf(lines.hidden.value_or(HiddenLines::Off)));
  property.SetIdArrayName(lines.idArray ? lines.idArray->c_str() : nullptr);
  if (lines.creaseAngleDegrees)
  {
    property.SetCreaseAngle(*lines.creaseAngleDegrees);
  }
  property.SetShortestCrease(lines.shortestCrease.value_or(1));
  property.SetRidgeThreshold(lines.ridgeThreshold.value_or(property.GetRidgeThreshold()));
  property.SetSuggestiveThreshold(
    lines.suggestiveThreshold.value_or(property.GetSuggestiveThreshold()));
  property.SetLineLights(lines.lights.value_or(LineLights::First) == LineLights::All
                           ? vtkLimnProperty::LINE_LIGHTS_ALL
                           : vtkLimnProperty::LINE_LIGHTS_FIRST);
  const Length width = lines.width.value_or(kUsualStroke);
  property.SetStrokeWidth(width.value);
  property.SetStrokeUnit(width.unit);
  property.SetOuterWidthFactor(lines.outerWidth.value_or(1));
  property.SetHatchWidth(lines.hatchWidth.value_or(property.GetHatchWidth()));
  property.SetStrokeColor(lines.color.value_or(Color{ 0, 0, 0 }).data());
  property.SetStrokeOpacity(lines.opacity.value_or(1));
  property.SetStrokeTaper(0);
  property.SetStrokeDash(0);
  property.SetStrokeGap(0);
  applyDash(settings, property);
}

void applyMaterial(const SceneSettings& settings, vtkLimnProperty& property)
{
  const MaterialSettings& material = settings.material;
  setReflectance(material, property);
  setIllustration(settings, property);
  setShading(material, property);
  setReflection(material, property);
  property.SetBackfaceCulling(material.backfaceCulling);
}

/// With what the user has named of its lines.
void applyStyle(const SceneSettings& settings, const Mesh& mesh, vtkLimnProperty& property)
{
  if (settings.style.empty())
  {
    return;
  }
  const LineSettings& lines = settings.lines;
  vtkLimnStyle::Apply(&property, settings.style.c_str());
  if (settings.material.opacity < 1)
  {
    property.SetOpacity(settings.material.opacity);
  }
  // Of VTK's shading, which knows no light that it would be a share of.
  property.SetAmbient(settings.material.ambient ? 1 : 0);
  // Creases are where the mesh is sharp, and without normals of its own it is sharp there.
  const std::optional<double> sharp = settings.material.featureAngleDegrees;
  property.SetCreaseAngle(
    lines.creaseAngleDegrees.value_or(sharp.value_or(property.GetCreaseAngle())));
  property.SetShortestCrease(lines.shortestCrease.value_or(property.GetShortestCrease()));
  if (!sharp && !mesh.surface->GetPointData()->GetNormals())
  {
    property.SetFeatureAngle(property.GetCreaseAngle());
  }
  if (lines.width)
  {
    property.SetStrokeWidth(lines.width->value);
    property.SetStrokeUnit(lines.width->unit);
  }
  const std::optional<Length>& spacing = settings.material.hatchSpacing;
  if (spacing)
  {
    property.SetHatchSpacing(spacing->value);
    property.SetHatchUnit(spacing->unit);
  }
  property.SetHatchDarkest(settings.material.hatchDarkest.value_or(property.GetHatchDarkest()));
  property.SetHatchWidth(lines.hatchWidth.value_or(property.GetHatchWidth()));
  property.SetOuterWidthFactor(lines.outerWidth.value_or(property.GetOuterWidthFactor()));
  property.SetStrokeOpacity(lines.opacity.value_or(property.GetStrokeOpacity()));
  applyDash(settings, property);
  if (lines.color)
  {
    property.SetStrokeColor(lines.color->data());
  }
  if (lines.hidden)
  {
    property.SetHiddenLines(hiddenLinesOf(*lines.hidden));
  }
}

Color backgroundOf(const SceneSettings& settings)
{
  Color paper = kDefaultBackground;
  vtkLimnStyle::GetBackground(settings.style.c_str(), paper.data());
  return settings.background.value_or(paper);
}

void addMeshes(
  const SceneSettings& settings, const std::vector<Mesh>& meshes, vtkRenderer& renderer)
{
  const Textures textures = loadTextures(settings.texture, meshes);
  const TonePictures pictures = loadTonePictures(settings.material);
  for (const Mesh& mesh : meshes)
  {
    vtkNew<vtkLimnPolyDataMapper> mapper;
    nameFileOf(*mapper, mesh.file);
    mapper->SetInputData(mesh.surface);
    vtkNew<vtkLimnProperty> property;
    applyLook(settings, mesh, pictures, *property);
    vtkNew<vtkLimnActor> actor;
    nameFileOf(*actor, mesh.file);
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    applyTextures(settings.texture, textures, *actor, *property);
    chooseColors(settings, meshes, mesh, *mapper);
    renderer.AddActor(actor);
  }
}

void requireFaces(const std::vector<Mesh>& meshes)
{
  for (const Mesh& mesh : meshes)
  {
    if (mesh.surface->GetNumberOfPolys() + mesh.surface->GetNumberOfStrips() == 0)
    {
      throw UserError(mesh.file + " has no faces; only surfaces are drawn");
    }
  }
}

/// Of cells, for lines between those that differ.
void requireIds(const SceneSettings& settings, const std::vector<Mesh>& meshes)
{
  const LineSettings& lines = settings.lines;
  const bool areLines =
    std::find(lines.kinds.begin(), lines.kinds.end(), LineKind::Ids) != lines.kinds.end();
  if (!areLines && !settings.material.outlineIds)
  {
    return;
  }
  const auto hasIds = [&lines](const Mesh& mesh)
  {
    vtkCellData* const data = mesh.surface->GetCellData();
    return (lines.idArray ? data->GetArray(lines.idArray->c_str()) : data->GetScalars()) != nullptr;
  };
  if (std::none_of(meshes.begin(), meshes.end(), hasIds))
  {
    throw UserError(lines.idArray
                      ? "--ids-array=" + *lines.idArray + ": no mesh has such cell data"
                      : std::string(areLines ? "--lines=ids" : "--outline-ids") +
                          ": no mesh has cell scalars; name cell data with --ids-array");
  }
}

Subject subjectOf(const std::vector<Mesh>& meshes)
{
  Subject subject;
  for (const Mesh& mesh : meshes)
  {
    double bounds[6];
    mesh.surface->GetCellsBounds(bounds);
    subject.box.AddBounds(bounds);
    subject.points.push_back(mesh.surface->GetPoints());
  }
  return subject;
}

} // namespace

void applyLook(const SceneSettings& settings, const Mesh& mesh, const TonePictures& pictures,
  vtkLimnProperty& property)
{
  applyMaterial(settings, property);
  property.SetToonRamp(pictures.ramp.Get());
  property.SetMatCap(pictures.matCap.Get());
  applyLines(settings, property);
  applyStyle(settings, mesh, property);
  applyCues(settings.cues, backgroundOf(settings), property);
}

void setBackground(const SceneSettings& settings, vtkRenderer& renderer)
{
  renderer.SetBackground(backgroundOf(settings).data());
}

void pointCamera(
  const SceneSettings& settings, const std::vector<Mesh>& meshes, vtkRenderer& renderer)
{
  const double aspect = static_cast<double>(settings.resolution[0]) / settings.resolution[1];
  fitCamera(settings.camera, subjectOf(meshes), aspect, *renderer.GetActiveCamera());
  renderer.ResetCameraClippingRange();
}

void buildScene(
  const SceneSettings& settings, const std::vector<Mesh>& meshes, vtkRenderer& renderer)
{
  requireFaces(meshes);
  requireIds(settings, meshes);
  setBackground(settings, renderer);
  addLights(settings, renderer);
  addMeshes(settings, meshes, renderer);
  pointCamera(settings, meshes, renderer);
}

} // namespace limn::viewer
