// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whatever value a property is given, its actor is drawn, or a message names the value as the
// property does. None of the core's, which knows instances by numbers, comes through.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"

#include "vtkImageData.h"

#include <cmath>
#include <limits>

namespace
{
const Pixel Black = { 0, 0, 0 };
const Pixel Green = { 0, 51, 0 };

struct Member
{
  const char* Name;
  void (*Set)(vtkLimnProperty*, double);
};

#define LIMN_SCALAR(name)                                                                          \
  {                                                                                                \
#name, [](vtkLimnProperty * property, double value) { property->Set##name(value); }            \
  }
#define LIMN_COLOR(name)                                                                           \
  {                                                                                                \
#name, [](vtkLimnProperty * property, double value) { property->Set##name(1, value, 1); }      \
  }

const Member Members[] = { LIMN_COLOR(AmbientColor), LIMN_COLOR(DiffuseColor),
  LIMN_COLOR(SpecularColor), LIMN_COLOR(EdgeTint), LIMN_SCALAR(Ambient), LIMN_SCALAR(Diffuse),
  LIMN_SCALAR(Specular), LIMN_SCALAR(SpecularPower), LIMN_SCALAR(Opacity), LIMN_SCALAR(Roughness),
  LIMN_SCALAR(Metallic), LIMN_SCALAR(BaseIOR), LIMN_SCALAR(NormalScale),
  LIMN_COLOR(RefractiveIndex), LIMN_COLOR(RimColor), LIMN_SCALAR(RimPower),
  LIMN_SCALAR(FeatureAngle), LIMN_COLOR(CoolColor), LIMN_COLOR(WarmColor), LIMN_SCALAR(CoolSurface),
  LIMN_SCALAR(WarmSurface), LIMN_SCALAR(Undertone), LIMN_SCALAR(LegendSafeRange),
  LIMN_SCALAR(HatchSpacing), LIMN_SCALAR(HatchDarkest), LIMN_SCALAR(HatchWidth),
  LIMN_COLOR(HatchPaper), LIMN_COLOR(HatchInk), LIMN_SCALAR(ExaggerationContrast),
  LIMN_SCALAR(ExaggerationExponent), LIMN_SCALAR(ExaggerationBase), LIMN_SCALAR(ExaggerationScale),
  LIMN_COLOR(OutlineColor), LIMN_SCALAR(OutlineWidth), LIMN_SCALAR(OutlineOpacity),
  LIMN_SCALAR(OutlineThreshold), LIMN_SCALAR(OutlineCreaseAngle),
  LIMN_SCALAR(OutlineDepthTolerance), LIMN_SCALAR(CreaseAngle), LIMN_SCALAR(RidgeThreshold),
  LIMN_SCALAR(SuggestiveThreshold), LIMN_COLOR(StrokeColor), LIMN_SCALAR(StrokeOpacity),
  LIMN_SCALAR(StrokeWidth), LIMN_SCALAR(OuterWidthFactor), LIMN_SCALAR(StrokeTaper),
  LIMN_SCALAR(StrokeDash), LIMN_SCALAR(StrokeGap), LIMN_SCALAR(EyeDomeStrength),
  LIMN_SCALAR(EyeDomeRadius), LIMN_SCALAR(DepthUnsharpStrength), LIMN_SCALAR(DepthUnsharpRadius),
  LIMN_SCALAR(HaloWidth), LIMN_SCALAR(HaloDepth), LIMN_COLOR(HaloColor), LIMN_SCALAR(BumpScale),
  LIMN_SCALAR(LightmapIntensity), LIMN_COLOR(ProceduralColorA), LIMN_COLOR(ProceduralColorB),
  LIMN_SCALAR(ProceduralScale), LIMN_SCALAR(ProceduralTurbulence), LIMN_SCALAR(ToonRampExponent),
  { "ToonRampRange",
    [](vtkLimnProperty* property, double value) { property->SetToonRampRange(1, value); } },
  { "ToonRampRange",
    [](vtkLimnProperty* property, double value) { property->SetToonRampRange(value, 2); } } };

/// Settings with which all members are used, in ways that exclude each other.
void useOutlinesAndLines(vtkLimnProperty* property)
{
  property->SetOutlineToImage();
  property->CreaseLinesOn();
  property->HatchLinesOn();
  property->SetStrokeDash(4);
  property->SetStrokeGap(4);
  property->EyeDomeLightingOn();
  property->SetDepthUnsharpToBoth();
  property->SetHaloWidth(2);
  property->SetProceduralTextureToMarble();
  property->SetToneToHatching();
}
void useHulls(vtkLimnProperty* property)
{
  property->SetOutlineToHull();
  property->SetToneToGooch();
  property->SetReflectionModelToMetallicRoughness();
}
void useRamps(vtkLimnProperty* property)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 12; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = 200;
  }
  property->SetOutlineToNormal();
  property->SetToneToRamp();
  property->SetToonRampImage(image);
  property->SetReflectionModelToPhong();
  property->FresnelOn();
}
void useExaggeration(vtkLimnProperty* property)
{
  property->SetToneToExaggerated();
  property->SetShadingFrequencyToPhong();
}

/// Whether it is refused.
bool checkValue(const Member& member, double value, void (*use)(vtkLimnProperty*))
{
  Stage stage;
  stage.LookFlat();
  stage.Renderer->SetBackground(0, 0.2, 0);
  stage.Mapper->SetInputData(twoSquares());
  vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->LightingOn();
  use(property);
  member.Set(property, value);
  Messages messages;
  const int pixels = render(stage.Window).CountOtherThan(Green);
  const bool isOpacity = std::string(member.Name) == "Opacity";
  // With less than 1 not all that these ask for is there.
  const bool isTranslucent = isOpacity && messages.Count("this actor is translucent") > 0;
  if (messages.GetText().empty() || isTranslucent)
  {
    const bool isInvisible = isOpacity && property->GetOpacity() < 1e-3;
    if (pixels == 0 && !isInvisible)
    {
      std::cerr << member.Name << " = " << value << " draws nothing without a word." << std::endl;
      ++failures();
    }
    return false;
  }
  const std::string name = member.Name;
  const int named = messages.Count(name + " of its vtkLimnProperty ") +
                    messages.Count(name + " times StrokeWidth of its vtkLimnProperty ");
  if (named != 1 || messages.Count("it has to be ") != 1 || messages.Count("Instance") != 0)
  {
    std::cerr << name << " = " << value << ": " << messages.GetText() << std::endl;
    ++failures();
  }
  return true;
}

void checkAll()
{
  const double values[] = { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL, 1e300,
    -1e300, 1e30, 1e-300, -1, 0 };
  for (const Member& member : Members)
  {
    for (const double value : values)
    {
      int refusals = 0;
      for (void (*use)(vtkLimnProperty*) :
        { useOutlinesAndLines, useHulls, useRamps, useExaggeration })
      {
        refusals += checkValue(member, value, use) ? 1 : 0;
      }
      // Setters that clamp let this pass.
      CHECK(refusals > 0 || !std::isnan(value));
    }
  }
}

void checkOne(const char* message, void (*spoil)(vtkLimnProperty*), int expectedPixels)
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  spoil(vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty()));
  Messages messages;
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), expectedPixels);
  CHECK_EQUAL(messages.Count(message), 1);
  CHECK_EQUAL(messages.Count("Instance"), 0);
  if (messages.Count(message) != 1)
  {
    std::cerr << messages.GetText() << std::endl;
  }
}

void checkWords()
{
  checkOne(
    "Drawn without an outline: OutlineWidth of its vtkLimnProperty is 1e+30 pixels; it has to be "
    "from 0 to 64.",
    [](vtkLimnProperty* property)
    {
      property->SetOutlineToImage();
      property->SetOutlineWidth(1e30);
    },
    800);
  checkOne(
    "OutlineCreaseAngle of its vtkLimnProperty has the value nan; it has to be from 0 to 180.",
    [](vtkLimnProperty* property)
    { property->SetOutlineCreaseAngle(std::numeric_limits<double>::quiet_NaN()); },
    0);
  checkOne(
    "DiffuseColor of its vtkLimnProperty has the value 1e+300; it has to be a finite number, "
    "not negative, and no more than 3.40282e+38 in size.",
    [](vtkLimnProperty* property) { property->SetDiffuseColor(1e300, 1, 1); }, 0);
  checkOne(
    "HatchWidth times StrokeWidth of its vtkLimnProperty is 384 pixels; it has to be above 0, "
    "at most 256.",
    [](vtkLimnProperty* property)
    {
      property->HatchLinesOn();
      property->SetHatchWidth(1e30);
    },
    800);
  checkOne(
    "StrokeWidth of its vtkLimnProperty is 1e+30 pixels; it has to be above 0, at most 256.",
    [](vtkLimnProperty* property)
    {
      property->CreaseLinesOn();
      property->SetStrokeWidth(1e30);
    },
    800);
  checkOne(
    "HaloWidth of its vtkLimnProperty is 1e+38 pixels; it has to be from 0 to 64.",
    [](vtkLimnProperty* property) { property->SetHaloWidth(1e38); }, 800);
  checkOne(
    "HaloWidth of its vtkLimnProperty is 72 pixels; it has to be from 0 to 64.",
    [](vtkLimnProperty* property)
    {
      property->SetHaloUnitToPoints();
      property->SetHaloWidth(72);
    },
    800);
  checkOne(
    "HaloDepth of its vtkLimnProperty has the value 1e-46; it has to be a finite number above 0, "
    "and no less than 1.4013e-45.",
    [](vtkLimnProperty* property)
    {
      property->SetHaloWidth(2);
      property->SetHaloDepth(1e-46);
    },
    0);
  checkOne(
    "EyeDomeRadius of its vtkLimnProperty has the value 1e-60; it has to be above 0, at most 0.02, "
    "and no less than 1.4013e-45.",
    [](vtkLimnProperty* property)
    {
      property->EyeDomeLightingOn();
      property->SetEyeDomeRadius(1e-60);
    },
    0);
  checkOne(
    "ProceduralScale of its vtkLimnProperty has the value 0; it has to be above 0, at most "
    "1e+06.",
    [](vtkLimnProperty* property)
    {
      property->SetProceduralTextureToWood();
      property->SetProceduralScale(0);
    },
    0);
}

// Frame after frame; and of an outline that is 64 pixels wide nothing.
void checkWideOutlines()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->SetOutlineToImage();
  property->SetOutlineWidth(64);
  Messages messages;
  render(stage.Window);
  CHECK_EQUAL(messages.GetText(), "");
  property->SetOutlineWidth(1e9);
  for (int frame = 0; frame < 3; ++frame)
  {
    CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 800);
    stage.Renderer->GetActiveCamera()->Modified();
  }
  CHECK_EQUAL(messages.Count("OutlineWidth of its vtkLimnProperty is 1e+09 pixels"), 1);
  CHECK_EQUAL(messages.Count("Drawn without an outline"), 1);
}
}

int TestLimnUnusableValues(int, char*[])
{
  checkAll();
  checkWords();
  checkWideOutlines();
  return result();
}
