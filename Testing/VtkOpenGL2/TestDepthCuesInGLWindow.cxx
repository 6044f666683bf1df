// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth cues change the surfaces that ask for them: no text, no scalar bar, no background, nothing
// that OpenGL has drawn.
#include "GLScene.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"

#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace
{
vtkSmartPointer<vtkActor> MakeLimnActor(vtkAlgorithmOutput* source, vtkLimnProperty* property)
{
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkLimnActor>::New();
  actor->SetMapper(mapper);
  actor->SetProperty(property);
  return actor;
}

void SetCues(vtkLimnProperty* property, bool areOn)
{
  property->SetEyeDomeLighting(areOn);
  property->SetEyeDomeStrength(3);
  property->SetEyeDomeRadius(0.01);
  property->SetDepthUnsharp(
    areOn ? vtkLimnProperty::DEPTH_UNSHARP_BOTH : vtkLimnProperty::DEPTH_UNSHARP_OFF);
  property->SetHaloWidth(areOn ? 4 : 0);
}

/// A sphere before a wall of Limn's, a smaller one of OpenGL's, a text and a scalar bar, both
/// partly before the wall and partly before the background.
class DepthCuesTest : public ::testing::TestWithParam<int>
{
protected:
  GLScene Scene{ GetParam(), 320, 240 };
  vtkNew<vtkLimnProperty> Near, Far;
  vtkSmartPointer<vtkActor> Plain;

  void SetUp() override
  {
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-0.8, -0.8, -1);
    wall->SetPoint1(0.8, -0.8, -1);
    wall->SetPoint2(-0.8, 0.8, -1);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.4);
    sphere->SetThetaResolution(60);
    sphere->SetPhiResolution(60);
    vtkNew<vtkSphereSource> small;
    small->SetRadius(0.15);
    small->SetCenter(0.2, 0.3, 0.6);
    this->Scene.Renderer->AddActor(MakeLimnActor(wall->GetOutputPort(), this->Far));
    this->Scene.Renderer->AddActor(MakeLimnActor(sphere->GetOutputPort(), this->Near));
    this->Plain = MakeGLActor(small->GetOutputPort());
    this->Plain->GetProperty()->SetColor(1, 0, 1);
    this->Plain->GetProperty()->LightingOff();
    this->Scene.Renderer->AddActor(this->Plain);
  }

  void AddAnnotations(bool areOpaque)
  {
    vtkNew<vtkTextActor> text;
    text->SetInput("Pressure 12.5 kPa");
    text->SetDisplayPosition(8, 112);
    text->GetTextProperty()->SetFontSize(22);
    text->GetTextProperty()->SetColor(1, 1, 0);
    if (areOpaque)
    {
      text->GetTextProperty()->SetBackgroundColor(0.2, 0.1, 0.1);
      text->GetTextProperty()->SetBackgroundOpacity(1);
    }
    this->Scene.Renderer->AddViewProp(text);
    vtkNew<vtkLookupTable> table;
    table->SetTableRange(0, 1);
    table->Build();
    vtkNew<vtkScalarBarActor> bar;
    bar->SetLookupTable(table);
    bar->SetTitle("p");
    bar->SetPosition(0.72, 0.1);
    bar->SetWidth(0.2);
    bar->SetHeight(0.8);
    this->Scene.Renderer->AddViewProp(bar);
  }
  Picture Drawn(bool areOn)
  {
    SetCues(this->Near, areOn);
    SetCues(this->Far, areOn);
    return this->Scene.Render();
  }
};

using Color = std::array<int, 3>;

Color ColorAt(const Picture& picture, int x, int y)
{
  const unsigned char* const rgba = picture.At(x, y);
  return { rgba[0], rgba[1], rgba[2] };
}

/// Where two pictures differ.
std::vector<bool> Difference(const Picture& a, const Picture& b)
{
  std::vector<bool> differs(a.Bytes.size() / 4);
  for (std::size_t i = 0; i < a.Bytes.size(); ++i)
  {
    if (a.Bytes[i] != b.Bytes[i])
    {
      differs[i / 4] = true;
    }
  }
  return differs;
}

TEST_P(DepthCuesTest, LeaveTextAndScalarBarsAlone)
{
  const Picture off = this->Drawn(false);
  const Picture on = this->Drawn(true);
  this->AddAnnotations(true);
  const Picture annotatedOn = this->Drawn(true);
  const Picture annotatedOff = this->Drawn(false);
  const std::vector<bool> isAnnotation = Difference(annotatedOff, off);
  const std::vector<bool> isCue = Difference(on, off);
  const std::vector<bool> changes = Difference(annotatedOn, annotatedOff);
  int annotated = 0;
  int overCues = 0;
  int changed = 0;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    annotated += isAnnotation[i];
    overCues += isAnnotation[i] && isCue[i];
    changed += changes[i];
    // Smooth edges of glyphs without a box mix with what is below them.
    if (isAnnotation[i] && !isCue[i])
    {
      ASSERT_FALSE(changes[i]) << i % 320 << ", " << i / 320;
    }
  }
  EXPECT_GT(annotated, 3000);
  EXPECT_GT(overCues, 300) << "some has to lie over what the cues change";
  EXPECT_GT(changed, 3000);
  // The box of the text, which lies over wall, sphere and background, and the colours of the bar.
  for (int y = 114; y < 130; ++y)
  {
    for (int x = 12; x < 150; ++x)
    {
      ASSERT_EQ(ColorAt(annotatedOn, x, y), ColorAt(annotatedOff, x, y)) << x << ", " << y;
    }
  }
  for (int y = 30; y < 190; ++y)
  {
    for (int x = 236; x < 250; ++x)
    {
      ASSERT_EQ(ColorAt(annotatedOn, x, y), ColorAt(annotatedOff, x, y)) << x << ", " << y;
    }
  }
}

TEST_P(DepthCuesTest, LeaveOpenGLsActorsAndTheBackgroundAlone)
{
  const Picture off = this->Drawn(false);
  const Picture on = this->Drawn(true);
  int plain = 0;
  for (int y = 0; y < off.Height; ++y)
  {
    for (int x = 0; x < off.Width; ++x)
    {
      const bool isPlain = ColorAt(off, x, y) == Color{ 255, 0, 255 };
      plain += isPlain;
      if (isPlain || x < 60 || x > 260)
      {
        ASSERT_EQ(ColorAt(on, x, y), ColorAt(off, x, y)) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(plain, 500);
  // Beside the sphere: its halo, then what is darker.
  EXPECT_EQ(ColorAt(on, 160 + 48 + 2, 120), (Color{ 255, 255, 255 }));
  EXPECT_LT(on.At(160 + 48 + 7, 120)[0], off.At(160 + 48 + 7, 120)[0]);
}

TEST_P(DepthCuesTest, AreThoseOfOneActor)
{
  const Picture off = this->Drawn(false);
  SetCues(this->Near, true);
  this->Near->SetHaloWidth(0);
  const Picture on = this->Scene.Render();
  const std::vector<bool> changes = Difference(on, off);
  int changed = 0;
  for (int y = 0; y < off.Height; ++y)
  {
    for (int x = 0; x < off.Width; ++x)
    {
      const int dx = 2 * x + 1 - 320;
      const int dy = 2 * y + 1 - 240;
      const bool isOut = dx * dx + dy * dy > 4 * 50 * 50;
      changed += changes[static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x)];
      if (isOut)
      {
        ASSERT_EQ(ColorAt(on, x, y), ColorAt(off, x, y)) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(changed, 1000);
}

INSTANTIATE_TEST_SUITE_P(MultiSamples, DepthCuesTest, ::testing::Values(0, 8));
}
