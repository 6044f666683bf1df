// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth cues, as a vtkLimnProperty asks for them.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"
#include "vtkLimnToneLegend.h"

#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace
{
/// Blue, before a white wall, on black: 40 x 40 pixels, 50 from the wall.
struct CueStage : Stage
{
  vtkNew<vtkLimnProperty> Property;
  vtkNew<vtkLimnProperty> Wall;

  CueStage()
  {
    this->Actor->SetProperty(this->Property);
    this->LookFlat();
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(50, 40, 150);
    camera->SetClippingRange(1, 300);
    this->Property->SetColor(0, 0, 1);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(30, 20, 50);
    plane->SetPoint1(70, 20, 50);
    plane->SetPoint2(30, 60, 50);
    this->Mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkPlaneSource> behind;
    behind->SetOrigin(10, 10, 0);
    behind->SetPoint1(90, 10, 0);
    behind->SetPoint2(10, 70, 0);
    vtkNew<vtkLimnPolyDataMapper> mapper;
    mapper->SetInputConnection(behind->GetOutputPort());
    vtkNew<vtkLimnActor> actor;
    actor->SetMapper(mapper);
    actor->SetProperty(this->Wall);
    this->Wall->LightingOff();
    this->Wall->SetColor(1, 1, 1);
    this->Renderer->AddActor(actor);
  }
};

void checkEyeDomeLighting()
{
  CueStage stage;
  const Picture plain = render(stage.Window);
  stage.Property->EyeDomeLightingOn();
  CHECK(render(stage.Window) == plain); // nothing lies before it
  stage.Wall->EyeDomeLightingOn();
  const Picture picture = render(stage.Window);
  // Beside the square three of eight neighbours on the fine ring lie before it, by the most.
  CHECK(picture.At(70, 40)[0] < 110);
  CHECK(picture.At(70, 40)[0] > 20);
  CHECK_EQUAL(picture.At(85, 40)[0], 255);
  CHECK_EQUAL(picture.At(50, 40), plain.At(50, 40));
  CHECK_EQUAL(picture.At(5, 40), plain.At(5, 40));
  stage.Wall->SetEyeDomeStrength(3);
  CHECK(render(stage.Window).At(70, 40)[0] < picture.At(70, 40)[0]);
  stage.Wall->SetEyeDomeStrength(1);
  stage.Wall->SetEyeDomeRadius(0.02);
  CHECK(render(stage.Window).At(76, 40)[0] < 250);
  stage.Wall->EyeDomeLightingOff();
  CHECK(render(stage.Window) == plain);
}

void checkDepthUnsharp()
{
  CueStage stage;
  stage.Property->SetColor(0, 0, 0.5);
  const Picture plain = render(stage.Window);
  stage.Wall->SetDepthUnsharpToDarken();
  stage.Property->SetDepthUnsharpToDarken();
  const Picture dark = render(stage.Window);
  CHECK(dark.At(70, 40)[0] < 200);
  CHECK_EQUAL(dark.At(69, 40), plain.At(69, 40));
  stage.Property->SetDepthUnsharpToBoth();
  const Picture both = render(stage.Window);
  CHECK_EQUAL(both.At(70, 40), dark.At(70, 40));
  CHECK(both.At(69, 40)[2] > plain.At(69, 40)[2] + 20);
  stage.Wall->SetDepthUnsharpRadius(0.08);
  CHECK(render(stage.Window).At(78, 40)[0] < dark.At(78, 40)[0]);
  stage.Wall->SetDepthUnsharpStrength(0);
  stage.Property->SetDepthUnsharpToOff();
  CHECK(render(stage.Window) == plain);
}

int redPixels(const Picture& picture)
{
  int count = 0;
  for (int x = 70; x < picture.Width; ++x)
  {
    count += picture.At(x, 40) == Pixel{ 255, 0, 0 };
  }
  return count;
}

void checkHalo()
{
  CueStage stage;
  const Picture plain = render(stage.Window);
  stage.Property->SetHaloColor(1, 0, 0);
  stage.Property->SetHaloWidth(3);
  CHECK_EQUAL(redPixels(render(stage.Window)), 3);
  CHECK_EQUAL(render(stage.Window).At(69, 40), plain.At(69, 40));
  stage.Property->SetHaloDepth(100.0 / 3); // half as far: 1.5 pixels
  CHECK_EQUAL(redPixels(render(stage.Window)), 1);
  stage.Property->SetHaloDepth(4);
  stage.Window->SetDPI(144);
  stage.Property->SetHaloUnitToPoints();
  CHECK_EQUAL(redPixels(render(stage.Window)), 6);
  stage.Property->SetHaloUnitToMillimeters();
  stage.Property->SetHaloWidth(4 * 25.4 / 144);
  CHECK_EQUAL(redPixels(render(stage.Window)), 4);
  stage.Property->SetHaloWidth(0);
  CHECK(render(stage.Window) == plain);
}

// The legend is what this window has of annotations.
void checkLegend()
{
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  const auto bytesOf = [&property]
  {
    vtkNew<vtkLimnToneLegend> legend;
    legend->SetSurfaceProperty(property);
    vtkNew<vtkLookupTable> table;
    table->Build();
    legend->SetLookupTable(table);
    vtkImageData* const image = legend->GetImage();
    CHECK(image != nullptr);
    if (!image)
    {
      return std::vector<unsigned char>();
    }
    const auto* const first = static_cast<const unsigned char*>(image->GetScalarPointer());
    return std::vector<unsigned char>(
      first, first + image->GetNumberOfScalarComponents() * image->GetNumberOfPoints());
  };
  const auto plain = bytesOf();
  property->EyeDomeLightingOn();
  property->SetDepthUnsharpToBoth();
  property->SetHaloWidth(5);
  CHECK(bytesOf() == plain);
}

void checkUnusableValues()
{
  constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    const char* Name;
    std::function<void(vtkLimnProperty*)> Set;
  } cases[] = {
    { "EyeDomeStrength", [](vtkLimnProperty* p) { p->SetEyeDomeStrength(-1); } },
    { "EyeDomeStrength", [](vtkLimnProperty* p) { p->SetEyeDomeStrength(NaN); } },
    { "EyeDomeStrength", [](vtkLimnProperty* p) { p->SetEyeDomeStrength(101); } },
    { "EyeDomeRadius", [](vtkLimnProperty* p) { p->SetEyeDomeRadius(0); } },
    { "EyeDomeRadius", [](vtkLimnProperty* p) { p->SetEyeDomeRadius(0.5); } },
    { "DepthUnsharpStrength", [](vtkLimnProperty* p) { p->SetDepthUnsharpStrength(1.5); } },
    { "DepthUnsharpRadius", [](vtkLimnProperty* p) { p->SetDepthUnsharpRadius(NaN); } },
    { "HaloWidth", [](vtkLimnProperty* p) { p->SetHaloWidth(-2); } },
    { "HaloWidth", [](vtkLimnProperty* p) { p->SetHaloWidth(NaN); } },
    { "HaloDepth", [](vtkLimnProperty* p) { p->SetHaloDepth(0); } },
    { "HaloColor", [](vtkLimnProperty* p) { p->SetHaloColor(0, NaN, 0); } },
  };
  for (const auto& one : cases)
  {
    CueStage stage;
    stage.Property->EyeDomeLightingOn();
    stage.Property->SetDepthUnsharpToDarken();
    stage.Property->SetHaloWidth(2);
    const Messages messages;
    one.Set(stage.Property);
    stage.Window->Render();
    CHECK_EQUAL(messages.Count("Not drawn"), 1);
    CHECK_EQUAL(messages.Count(one.Name), 1);
  }
  // What is not asked for is not looked at.
  CueStage stage;
  stage.Property->SetEyeDomeRadius(NaN);
  stage.Property->SetDepthUnsharpRadius(NaN);
  stage.Property->SetHaloDepth(NaN);
  const Messages messages;
  stage.Window->Render();
  CHECK_EQUAL(messages.GetText(), std::string());
}
}

int TestLimnDepthCues(int, char*[])
{
  checkEyeDomeLighting();
  checkDepthUnsharp();
  checkHalo();
  checkLegend();
  checkUnusableValues();
  return result();
}
