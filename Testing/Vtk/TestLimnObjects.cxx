// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every class as a VTK object: made, printed, copied.
#include "Check.h"
#include "Stage.h"

#include "vtkLimnCamera.h"
#include "vtkLimnCompositor.h"
#include "vtkLimnEngine.h"
#include "vtkLimnHardwareSelector.h"
#include "vtkLimnPostEffects.h"
#include "vtkLimnLight.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindowInteractor.h"
#include "vtkLimnShaderProperty.h"
#include "vtkLimnUniforms.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkTexture.h"

#include <array>
#include <sstream>
#include <string>

namespace
{
template <class Object>
void checkPrint(const char* name)
{
  vtkNew<Object> object;
  std::ostringstream text;
  object->Print(text);
  CHECK(text.str().find(name) == 0);
  CHECK(text.str().find("Reference Count: 1") != std::string::npos);
  vtkSmartPointer<Object> other = vtkSmartPointer<Object>::Take(object->NewInstance());
  CHECK_EQUAL(std::string(other->GetClassName()), name);
}

void checkActorCopy()
{
  Stage stage;
  stage.Actor->SetPosition(1, 2, 3);
  vtkNew<vtkLimnActor> copy;
  copy->ShallowCopy(stage.Actor);
  CHECK(copy->GetMapper() == stage.Mapper);
  CHECK_EQUAL(copy->GetPosition()[2], 3.0);
  CHECK(copy->GetShaderProperty() == stage.Actor->GetShaderProperty());
  CHECK(vtkLimnProperty::SafeDownCast(copy->GetProperty()) != nullptr);
}

std::string printed(vtkLight* light)
{
  std::ostringstream text;
  light->PrintSelf(text, vtkIndent());
  const std::string all = text.str();
  return all.substr(all.find("AmbientColor"));
}

void checkLightCopy()
{
  vtkNew<vtkLimnLight> light;
  CHECK(!light->GetPositional());
  light->SetShapeToRectangle();
  CHECK(light->GetPositional());
  light->SetWidth(3);
  light->SetHeight(4);
  light->SetViewUp(0, 0, 1);
  light->SetRadius(5);
  light->SetSamples(6);
  light->SetSoftEdgeAngle(7);
  light->SetUnitToPower();
  light->SetIntensity(0.5);
  vtkNew<vtkLimnLight> copy;
  copy->DeepCopy(light);
  CHECK_EQUAL(printed(copy), printed(light));
  CHECK_EQUAL(std::string(copy->GetShapeAsString()), "Rectangle");
  CHECK_EQUAL(std::string(copy->GetUnitAsString()), "Power");
  vtkSmartPointer<vtkLight> clone;
  clone.TakeReference(light->ShallowClone());
  CHECK(vtkLimnLight::SafeDownCast(clone) != nullptr);
  CHECK_EQUAL(printed(clone), printed(light));
  vtkNew<vtkLight> plain;
  copy->DeepCopy(plain);
  CHECK_EQUAL(copy->GetIntensity(), 1.0);
  light->SetSamples(0);
  CHECK_EQUAL(light->GetSamples(), 1);
  light->SetShape(99);
  CHECK_EQUAL(std::string(light->GetShapeAsString()), "Sphere");
  const vtkMTimeType time = light->GetMTime();
  light->SetShapeToSphere();
  CHECK_EQUAL(light->GetMTime(), time);
}

void checkPropertyCopy()
{
  vtkNew<vtkLimnProperty> property;
  property->SetShadingFrequencyToGouraud();
  property->SetFlatPointToFirstVertex();
  property->SetVertexNormalsToByAngle();
  property->SetFeatureAngle(35);
  property->SetReflectionModelToPhong();
  property->FresnelOn();
  property->SetRefractiveIndex(1.1, 1.2, 1.3);
  property->SetRimColor(0.3, 0.2, 0.1);
  property->SetRimPower(4);
  property->FallOffOff();
  property->SetToneToGooch();
  property->SetCoolColor(0.1, 0.2, 0.3);
  property->SetWarmColor(0.4, 0.5, 0.6);
  property->SetCoolSurface(0.7);
  property->SetWarmSurface(0.8);
  property->SetToneOverDataToLegendSafe();
  property->SetUndertone(0.15);
  property->SetLegendSafeRange(9);
  property->SetOutlineToNormal();
  property->SetOutlineThreshold(0.9);
  property->SetOutlineWidth(2.5);
  property->SetOutlineDetectorToLaplacian();
  property->SetOutlineDepthTolerance(1.5);
  property->SetOutlineCreaseAngle(25);
  property->SetOutlineCreaseDetectorToSobel();
  property->OutlineIdsOn();
  property->SetOutlineColor(1, 0, 1);
  property->SetOutlineOpacity(0.6);
  property->SetToonBands(5);
  property->SetToneLightToUpperRight();
  property->SetToneHighlightToWhite();
  property->SetToonRampByToSilhouette();
  property->SetToonRampExponent(3);
  property->SetToonRampRange(1, 9);
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(1, 1, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  property->SetToonRampImage(picture);
  property->SetMatCapImage(picture);
  property->SetHatchDarkest(0.7);
  property->SetHatchSpacing(4.5);
  property->SetHatchUnitToMillimeters();
  property->SetHatchPaper(0.9, 0.8, 0.7);
  property->SetHatchInk(0.1, 0.2, 0.3);
  property->SetHatchPlaceToTexture();
  property->SetExaggerationContrast(6.5);
  property->SetExaggerationExponent(0.75);
  property->SetExaggerationBase(0.55);
  property->SetExaggerationLevels(7);
  property->SetExaggerationScale(0.045);
  property->CreaseLinesOn();
  property->BorderLinesOn();
  property->NonManifoldLinesOn();
  property->IdLinesOn();
  property->NormalLinesOn();
  property->ContourLinesOn();
  property->SilhouetteLinesOn();
  property->RidgeLinesOn();
  property->ValleyLinesOn();
  property->SuggestiveLinesOn();
  property->SetRidgeThreshold(0.2);
  property->SetSuggestiveThreshold(0.03);
  property->TerminatorLinesOn();
  property->ShadowLinesOn();
  property->IntersectionLinesOn();
  property->SetLineLightsToAll();
  property->HatchLinesOn();
  property->SetHatchWidth(0.45);
  property->SetIdArrayName("part");
  property->SetCreaseAngle(25);
  property->SetShortestCrease(6);
  property->SetStrokeWidth(0.35);
  property->SetStrokeUnitToMillimeters();
  property->SetOuterWidthFactor(2.5);
  property->SetStrokeColor(0.1, 0.3, 0.5);
  property->SetStrokeOpacity(0.65);
  property->SetStrokeTaper(11);
  property->SetStrokeDash(6);
  property->SetStrokeGap(3);
  property->SetHiddenLinesToDashed();
  property->EyeDomeLightingOn();
  property->SetEyeDomeStrength(2.25);
  property->SetEyeDomeRadius(0.0035);
  property->SetDepthUnsharpToBoth();
  property->SetDepthUnsharpStrength(0.85);
  property->SetDepthUnsharpRadius(0.045);
  property->SetHaloWidth(1.75);
  property->SetHaloUnitToPoints();
  property->SetHaloDepth(2.75);
  property->SetHaloColor(0.15, 0.35, 0.55);
  property->SetTextureRoleToSurface();
  property->SetTextureModeToDecal();
  property->SetProceduralTextureToMarble();
  property->SetProceduralSpaceToUv();
  property->SetProceduralColorA(0.3, 0.2, 0.1);
  property->SetProceduralColorB(0.6, 0.5, 0.4);
  property->SetProceduralScale(12);
  property->SetProceduralTurbulence(0.35);
  property->SetLightmapIntensity(0.45);
  property->SetLightmapTCoords("second");
  property->SetBumpScale(-0.15);
  property->SetAmbient(0.25);
  vtkNew<vtkLimnProperty> copy;
  copy->DeepCopy(property);
  std::ostringstream original;
  std::ostringstream copied;
  vtkIndent indent;
  property->PrintSelf(original, indent);
  copy->PrintSelf(copied, indent);
  const auto settings = [](const std::string& text) { return text.substr(text.find("Ambient")); };
  CHECK_EQUAL(settings(copied.str()), settings(original.str()));
  CHECK_EQUAL(std::string(copy->GetReflectionModelAsString()), "Phong");
  CHECK_EQUAL(copy->GetOutlineThreshold(), 0.9);
  CHECK_EQUAL(copy->GetMatCap(), property->GetMatCap());
  CHECK_EQUAL(copy->GetToonRamp()->GetInput(), picture.GetPointer());
  property->SetOutline(99);
  CHECK_EQUAL(std::string(property->GetOutlineAsString()), "Image");
  CHECK_EQUAL(copy->GetOutlineDetectorAsString(), std::string("Laplacian"));
  CHECK_EQUAL(copy->GetOutlineDepthTolerance(), 1.5);
  CHECK_EQUAL(copy->GetOutlineCreaseAngle(), 25.0);
  CHECK_EQUAL(copy->GetShortestCrease(), 6);
  CHECK_EQUAL(copy->GetOutlineCreaseDetectorAsString(), std::string("Sobel"));
  CHECK(copy->GetOutlineIds());

  property->SetShadingFrequency(99);
  CHECK_EQUAL(property->GetShadingFrequency(), int(vtkLimnProperty::FREQUENCY_PHONG));
  property->SetReflectionModel(99);
  CHECK_EQUAL(std::string(property->GetReflectionModelAsString()), "Local5");
  property->SetOutlineThreshold(-1);
  CHECK_EQUAL(property->GetOutlineThreshold(), 0.0);
  const vtkMTimeType time = property->GetMTime();
  property->SetToneToGooch();
  CHECK_EQUAL(property->GetMTime(), time);
  property->SetToneToNone();
  CHECK(property->GetMTime() > time);
}

void checkGoochConstants()
{
  const auto has =
    [](vtkLimnProperty* property, const char* highlight, std::array<double, 8> constants)
  {
    CHECK_EQUAL(std::string(property->GetToneAsString()), "Gooch");
    CHECK_EQUAL(std::string(property->GetToneHighlightAsString()), highlight);
    const double* const cool = property->GetCoolColor();
    const double* const warm = property->GetWarmColor();
    const std::array<double, 8> set = { cool[0], cool[1], cool[2], property->GetCoolSurface(),
      warm[0], warm[1], warm[2], property->GetWarmSurface() };
    CHECK(set == constants);
  };
  vtkNew<vtkLimnProperty> property;
  property->SetGoochToRTR4();
  has(property, "White", { 0, 0, 0.55, 0.25, 0.3, 0.3, 0, 0.25 });
  property->SetGoochToOrangeBook();
  has(property, "Reflected", { 0, 0, 0.6, 0.45, 0.6, 0.6, 0, 0.45 });
  CHECK_EQUAL(property->GetDiffuseColor()[1], 0.75);
  CHECK_EQUAL(property->GetSpecularPower(), 32.0);
  CHECK_EQUAL(property->GetSpecular(), 1.0);
  property->SetMetalToSteel();
  CHECK_EQUAL(std::string(property->GetToneAsString()), "Metal");
  CHECK_EQUAL(property->GetWarmColor()[0], 2.0);
  property->SetGoochTo1998();
  has(property, "Added", { 0, 0, 0.4, 0.2, 0.4, 0.4, 0, 0.6 });
}

void checkShaderProperty()
{
  vtkNew<vtkLimnShaderProperty> shaders;
  shaders->AddVertexShaderReplacement("a", true, "b", false);
  shaders->AddFragmentShaderReplacement("a", true, "c", false);
  shaders->AddFragmentShaderReplacement("a", true, "d", true);
  CHECK_EQUAL(shaders->GetNumberOfShaderReplacements(), 2);
  CHECK_EQUAL(shaders->GetNthShaderReplacementTypeAsString(1), "Fragment");
  std::string name;
  std::string value;
  bool first = false;
  bool all = false;
  shaders->GetNthShaderReplacement(1, name, first, value, all);
  CHECK_EQUAL(name + value, "ad");
  CHECK(first && all);
  shaders->ClearFragmentShaderReplacement("a", false);
  CHECK_EQUAL(shaders->GetNumberOfShaderReplacements(), 2);
  shaders->ClearAllFragmentShaderReplacements();
  CHECK_EQUAL(shaders->GetNumberOfShaderReplacements(), 1);
  shaders->ClearAllShaderReplacements();
  CHECK_EQUAL(shaders->GetNumberOfShaderReplacements(), 0);
}

void checkUniforms()
{
  vtkNew<vtkLimnUniforms> uniforms;
  uniforms->SetUniformi("count", 7);
  const float color[3] = { 0.1f, 0.2f, 0.3f };
  uniforms->SetUniform3f("color", color);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(1, 2, 5);
  uniforms->SetUniformMatrix("matrix", matrix);
  CHECK_EQUAL(uniforms->GetNumberOfUniforms(), 3);
  CHECK_EQUAL(std::string(uniforms->GetNthUniformName(0)), "color");
  int count = 0;
  CHECK(uniforms->GetUniformi("count", count));
  CHECK_EQUAL(count, 7);
  float back[3] = {};
  CHECK(uniforms->GetUniform3f("color", back));
  CHECK_EQUAL(back[1], 0.2f);
  CHECK(!uniforms->GetUniform3f("count", back));
  vtkNew<vtkMatrix4x4> read;
  CHECK(uniforms->GetUniformMatrix("matrix", read));
  CHECK_EQUAL(read->GetElement(1, 2), 5.0);
  CHECK_EQUAL(uniforms->GetUniformScalarType("count"), VTK_INT);
  CHECK_EQUAL(uniforms->GetUniformNumberOfComponents("matrix"), 16);
  CHECK_EQUAL(uniforms->GetUniformNumberOfTuples("matrix"), 1);
  const vtkMTimeType listTime = uniforms->GetUniformListMTime();
  uniforms->SetUniformi("count", 8);
  CHECK_EQUAL(uniforms->GetUniformListMTime(), listTime);
  uniforms->RemoveUniform("count");
  CHECK(uniforms->GetUniformListMTime() > listTime);
  CHECK(!uniforms->GetUniformi("count", count));
}

void checkEngine()
{
  CHECK_EQUAL(vtkLimnEngine::GetNumberOfThreads(), 0);
  vtkLimnEngine::SetNumberOfThreads(3);
  CHECK_EQUAL(vtkLimnEngine::GetNumberOfThreads(), 3);
  CHECK(vtkLimnEngine::GetNumberOfAvailableInstructionSets() > 0);
  const std::string best = vtkLimnEngine::GetAvailableInstructionSet(0);
  CHECK_EQUAL(vtkLimnEngine::GetInstructionSet(), best);
  CHECK(!vtkLimnEngine::SetInstructionSet("MMX"));
  CHECK(vtkLimnEngine::SetInstructionSet(best));
  CHECK_EQUAL(vtkLimnEngine::GetAvailableInstructionSet(99), "");
  CHECK(!vtkLimnEngine::GetUseReference());
}
}

int TestLimnObjects(int, char*[])
{
  checkPrint<vtkLimnActor>("vtkLimnActor");
  checkPrint<vtkLimnCamera>("vtkLimnCamera");
  checkPrint<vtkLimnEngine>("vtkLimnEngine");
  checkPrint<vtkLimnHardwareSelector>("vtkLimnHardwareSelector");
  checkPrint<vtkLimnPolyDataMapper>("vtkLimnPolyDataMapper");
  checkPrint<vtkLimnPostEffects>("vtkLimnPostEffects");
  checkPrint<vtkLimnProperty>("vtkLimnProperty");
  checkPrint<vtkLimnRenderWindow>("vtkLimnRenderWindow");
  checkPrint<vtkLimnRenderWindowInteractor>("vtkLimnRenderWindowInteractor");
  checkPrint<vtkLimnRenderer>("vtkLimnRenderer");
  checkPrint<vtkLimnShaderProperty>("vtkLimnShaderProperty");
  checkPrint<vtkLimnUniforms>("vtkLimnUniforms");
  checkActorCopy();
  checkPropertyCopy();
  checkGoochConstants();
  checkLightCopy();
  checkShaderProperty();
  checkUniforms();
  checkEngine();
  return result();
}
