// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Post effects of a viewport of Limn's own window.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnPostEffects.h"

#include "vtkFXAAOptions.h"
#include "vtkLight.h"

#include <limits>

namespace
{
/// The two squares in grey 0.4 on 0.2.
struct GreyStage : public Stage
{
  vtkNew<vtkLimnPostEffects> Effects;

  GreyStage()
  {
    this->LookFlat();
    this->Mapper->SetInputData(twoSquares());
    this->Actor->GetProperty()->SetColor(0.4, 0.4, 0.4);
    this->Renderer->SetBackground(0.2, 0.2, 0.2);
  }
  Pixel Square() { return render(this->Window).At(20, 20); }
  Pixel Background() { return read(this->Window).At(5, 70); }
};

Pixel grey(int value)
{
  return { value, value, value };
}

void checkThatNothingIsDoneUnasked()
{
  GreyStage stage;
  const Picture plain = render(stage.Window);
  stage.Renderer->SetPostEffects(stage.Effects);
  CHECK(render(stage.Window) == plain);
  stage.Effects->SetExposure(2);
  CHECK(!(render(stage.Window) == plain));
  stage.Renderer->SetPostEffects(nullptr);
  CHECK(render(stage.Window) == plain);
}

void checkExposureAndToneMapping()
{
  GreyStage stage;
  stage.Renderer->SetPostEffects(stage.Effects);
  stage.Effects->SetExposure(0.5);
  CHECK_EQUAL(stage.Square(), grey(51));
  CHECK_EQUAL(stage.Background(), grey(26)); // 25.5, to even
  stage.Effects->SetExposure(5);
  CHECK_EQUAL(stage.Square(), grey(255));
  // 2 / (1 + 2) and 1 / (1 + 1).
  stage.Effects->SetToneMappingToReinhard();
  CHECK_EQUAL(stage.Square(), grey(170));
  CHECK_EQUAL(stage.Background(), grey(128));
  stage.Effects->SetToneMappingToReinhardExtended();
  stage.Effects->SetWhitePoint(2);
  CHECK_EQUAL(stage.Square(), grey(255));
  CHECK_EQUAL(stage.Background(), grey(159)); // (1 + 1/4) / 2
  stage.Effects->SetToneMappingToAces();
  CHECK_EQUAL(stage.Background(), grey(159));
  CHECK_EQUAL(stage.Square(), grey(233)); // 2 (5.02 + 0.03) / (2 (4.86 + 0.59) + 0.14)
  CHECK_EQUAL(std::string(stage.Effects->GetToneMappingAsString()), std::string("Aces"));
}

void checkLightAboveOne()
{
  GreyStage stage;
  stage.Actor->GetProperty()->LightingOn();
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(5);
  stage.Renderer->AddLight(light);
  CHECK_EQUAL(stage.Square(), grey(255));
  stage.Renderer->SetPostEffects(stage.Effects);
  stage.Effects->SetToneMappingToReinhard();
  CHECK_EQUAL(stage.Square(), grey(170));
  stage.Effects->SetToneMappingToNone();
  CHECK_EQUAL(render(stage.Window).At(35, 20), grey(51));
  stage.Effects->SetBloomStrength(1);
  stage.Effects->SetBloomLevels(3);
  const Picture bloomed = render(stage.Window);
  CHECK(bloomed.At(35, 20)[0] > 80);
  CHECK(bloomed.At(35, 20)[0] > bloomed.At(35, 33)[0]);
  CHECK_EQUAL(bloomed.At(95, 75), grey(51));
  stage.Effects->SetBloomThreshold(3);
  CHECK_EQUAL(render(stage.Window).At(35, 20), grey(51));
}

// A gradient background and a surface in one frame, and a frame without any surface.
void checkBackgrounds()
{
  GreyStage stage;
  stage.Renderer->SetPostEffects(stage.Effects);
  stage.Effects->SetExposure(0.5);
  stage.Renderer->GradientBackgroundOn();
  stage.Renderer->SetBackground2(1, 1, 1);
  const Picture dark = render(stage.Window);
  stage.Renderer->SetPostEffects(nullptr);
  const Picture plain = render(stage.Window);
  for (int y = 0; y < 80; y += 7)
  {
    CHECK(std::abs(2 * dark.At(90, y)[0] - plain.At(90, y)[0]) <= 1);
  }
  stage.Renderer->GradientBackgroundOff();
  stage.Renderer->SetPostEffects(stage.Effects);
  stage.Actor->VisibilityOff();
  CHECK_EQUAL(stage.Square(), grey(26));
  stage.Effects->SetExposure(1);
  stage.Renderer->UseFXAAOn();
  CHECK_EQUAL(stage.Square(), grey(51));
}

void checkViewportsApart()
{
  GreyStage stage;
  vtkNew<vtkLimnRenderer> beside;
  stage.Renderer->SetViewport(0, 0, 0.7, 1);
  beside->SetViewport(0.7, 0, 1, 1);
  beside->SetBackground(0.2, 0.2, 0.2);
  stage.Window->AddRenderer(beside);
  stage.Effects->SetExposure(0.5);
  stage.Effects->SetBloomStrength(0.5);
  beside->SetPostEffects(stage.Effects);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(69, 70), grey(51));
  CHECK_EQUAL(picture.At(70, 70), grey(26));
  stage.Window->SetSize(60, 40);
  CHECK_EQUAL(render(stage.Window).At(50, 20), grey(26));
  stage.Window->SetSize(200, 160);
  CHECK_EQUAL(render(stage.Window).At(150, 20), grey(26));
}

/// A square turned by some degrees, unlit.
void showTurnedSquare(Stage& stage)
{
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Actor->RotateZ(8);
}

void checkFxaa()
{
  Stage stage;
  showTurnedSquare(stage);
  const Picture jagged = render(stage.Window);
  stage.Renderer->UseFXAAOn();
  const Picture smooth = render(stage.Window);
  const int changed = smooth.CountDifferent(jagged, 0);
  CHECK(changed > 50 && changed < 1000);
  stage.Renderer->GetFXAAOptions()->SetSubpixelBlendLimit(0);
  stage.Renderer->GetFXAAOptions()->SetEndpointSearchIterations(0);
  CHECK(render(stage.Window) == jagged);
  stage.Renderer->GetFXAAOptions()->SetEndpointSearchIterations(VTK_INT_MAX);
  const Picture edges = render(stage.Window);
  CHECK(!(edges == jagged) && !(edges == smooth));
  stage.Renderer->GetFXAAOptions()->UseHighQualityEndpointsOff();
  CHECK(!(render(stage.Window) == jagged));
  stage.Renderer->GetFXAAOptions()->SetHardContrastThreshold(1);
  CHECK(render(stage.Window).CountDifferent(jagged, 0) < changed);
  Messages messages;
  stage.Renderer->GetFXAAOptions()->SetDebugOptionValue(vtkFXAAOptions::FXAA_DEBUG_EDGE_DIRECTION);
  render(stage.Window);
  render(stage.Window);
  CHECK_EQUAL(messages.Count("DebugOptionValue"), 1);
}

void checkDepthOfField()
{
  Stage stage;
  stage.Mapper->SetInputData(twoSquares());
  stage.Actor->GetProperty()->LightingOff();
  stage.Window->SetMultiSamples(0);
  vtkCamera* const camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(35, 20, 100);
  camera->SetFocalPoint(35, 20, 0);
  camera->SetViewAngle(40);
  camera->SetClippingRange(10, 200);
  const Picture sharp = render(stage.Window);
  vtkNew<vtkLimnPostEffects> effects;
  stage.Renderer->SetPostEffects(effects);
  effects->DepthOfFieldOn();
  camera->SetFocalDisk(10);
  // The background lies at the far plane; the squares are in focus and white on black.
  CHECK(render(stage.Window) == sharp);
  camera->SetFocalDistance(50);
  const Picture blurred = render(stage.Window);
  const int reach = blurred.CountDifferent(sharp, 2);
  CHECK(reach > 100);
  effects->SetMaximumBlurRadius(2);
  const int bounded = render(stage.Window).CountDifferent(sharp, 2);
  CHECK(bounded > 0 && bounded < reach);
  Messages messages;
  camera->ParallelProjectionOn();
  render(stage.Window);
  render(stage.Window);
  CHECK_EQUAL(messages.Count("without depth of field"), 1);
}

void checkErrors()
{
  GreyStage stage;
  const Picture plain = render(stage.Window);
  stage.Renderer->SetPostEffects(stage.Effects);
  const struct
  {
    void (*Spoil)(vtkLimnPostEffects*);
    const char* Word;
  } cases[] = {
    { [](vtkLimnPostEffects* effects) { effects->SetExposure(-1); }, "exposure" },
    { [](vtkLimnPostEffects* effects)
      { effects->SetExposure(std::numeric_limits<double>::quiet_NaN()); },
      "exposure" },
    { [](vtkLimnPostEffects* effects) { effects->SetBloomStrength(-2); }, "bloom" },
    { [](vtkLimnPostEffects* effects)
      {
        effects->SetBloomLevels(20);
        effects->SetToneMappingToAces();
      },
      "levels" },
    { [](vtkLimnPostEffects* effects) { effects->SetWhitePoint(0); }, "white point" },
  };
  for (const auto& one : cases)
  {
    vtkNew<vtkLimnPostEffects> effects;
    effects->SetToneMappingToReinhard();
    one.Spoil(effects);
    stage.Renderer->SetPostEffects(effects);
    Messages messages;
    CHECK(render(stage.Window) == plain);
    CHECK_EQUAL(messages.Count("Drawn without post effects"), 1);
    CHECK_EQUAL(messages.Count(one.Word), 1);
  }
}

void checkTimes()
{
  GreyStage stage;
  stage.Renderer->SetPostEffects(stage.Effects);
  const vtkMTimeType before = stage.Renderer->GetMTime();
  stage.Effects->SetExposure(3);
  CHECK(stage.Renderer->GetMTime() > before);
  const vtkMTimeType later = stage.Renderer->GetMTime();
  stage.Renderer->GetFXAAOptions()->SetHardContrastThreshold(0.25f);
  CHECK(stage.Renderer->GetMTime() > later);
}
}

int TestLimnPostEffects(int, char*[])
{
  checkThatNothingIsDoneUnasked();
  checkExposureAndToneMapping();
  checkLightAboveOne();
  checkBackgrounds();
  checkViewportsApart();
  checkFxaa();
  checkDepthOfField();
  checkErrors();
  checkTimes();
  return result();
}
