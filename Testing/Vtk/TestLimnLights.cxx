// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's lights on a square that faces the eye, n = (0, 0, 1), at z = 0.
#include "Check.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnLight.h"
#include "vtkLimnProperty.h"

#include "vtkLight.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace
{
/// The grey of pixel (x, y) of a white square over the whole window, lit by one light.
template <class AnyLight>
int greyAt(int x, int y, void (*arrange)(AnyLight*, Stage&))
{
  Stage stage;
  stage.LookFlat();
  stage.Actor->GetProperty()->LightingOn();
  vtkNew<vtkPolyData> data;
  data->SetPoints(flatPoints({ { 0, 0 }, { 100, 0 }, { 100, 80 }, { 0, 80 } }));
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  stage.Mapper->SetInputData(data);
  vtkNew<AnyLight> light;
  arrange(light, stage);
  stage.Renderer->AddLight(light);
  return render(stage.Window).At(x, y)[0];
}

int greyAt(int x, int y, void (*arrange)(vtkLight*, Stage&))
{
  return greyAt<vtkLight>(x, y, arrange);
}

bool isNear(int value, double expected)
{
  return std::abs(value - expected) <= 1;
}

void hang(vtkLimnLight* light, double height)
{
  light->SetConeAngle(180);
  light->SetPosition(50.5, 40.5, height);
  light->SetFocalPoint(50.5, 40.5, 0);
}

void checkShapes()
{
  // One sample: at the middle. At distance 40 beside it cos = 0.6, twice for a rectangle.
  const auto panel = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    light->SetSamples(1);
    hang(light, 30);
  };
  CHECK_EQUAL(greyAt<vtkLimnLight>(50, 40, panel), 255);
  CHECK(isNear(greyAt<vtkLimnLight>(90, 40, panel), 255 * 0.36));
  const auto away = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    hang(light, 30);
    light->SetFocalPoint(50.5, 40.5, 60);
  };
  CHECK_EQUAL(greyAt<vtkLimnLight>(50, 40, away), 0);
  const auto globe = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToSphere();
    light->SetSamples(1);
    hang(light, 30);
  };
  CHECK(isNear(greyAt<vtkLimnLight>(90, 40, globe), 255 * 0.6));

  // A rod along x, 30 above: beside it the light of its length, across it of a point.
  const auto rodAlongX = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    light->SetWidth(60);
    light->SetHeight(1e-3);
    light->SetSamples(64);
    hang(light, 30);
  };
  const auto rodAlongY = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    light->SetWidth(60);
    light->SetHeight(1e-3);
    light->SetViewUp(1, 0, 0);
    light->SetSamples(64);
    hang(light, 30);
  };
  const int beside = greyAt<vtkLimnLight>(80, 40, rodAlongX);
  const int across = greyAt<vtkLimnLight>(80, 40, rodAlongY);
  CHECK(beside > across + 15);
  CHECK(isNear(greyAt<vtkLimnLight>(50, 70, rodAlongX), across));
}

void checkPower()
{
  // P / (4 pi r^2) at r = 0.5, whatever the attenuation.
  const auto bulb = [](vtkLimnLight* light, Stage&)
  {
    light->PositionalOn();
    light->SetUnitToPower();
    light->SetIntensity(2);
    hang(light, 0.5);
  };
  CHECK(isNear(greyAt<vtkLimnLight>(50, 40, bulb), 255 * 2 / (4 * 3.14159265358979 * 0.25)));
}

void checkSoftEdge()
{
  const auto spot = [](vtkLimnLight* light, Stage&)
  {
    light->PositionalOn();
    hang(light, 30);
    light->SetConeAngle(60);
    light->SetExponent(0);
    light->SetSoftEdgeAngle(30);
  };
  // At 45 degrees: t between the cosines of 60 and 30.
  const double t = (std::sqrt(0.5) - 0.5) / (std::sqrt(0.75) - 0.5);
  CHECK(isNear(greyAt<vtkLimnLight>(80, 40, spot), 255 * std::sqrt(0.5) * t * t * (3 - 2 * t)));
  CHECK_EQUAL(greyAt<vtkLimnLight>(50, 40, spot), 255);
}

// Of a light that moves with the camera, whose matrix has a scale.
void checkTransform()
{
  const auto scaled = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    light->SetWidth(6);
    light->SetHeight(1e-4);
    light->SetSamples(64);
    light->SetConeAngle(180);
    light->SetPosition(5.05, 4.05, 3);
    light->SetFocalPoint(5.05, 4.05, 0);
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, i, 10);
    }
    light->SetTransformMatrix(matrix);
  };
  const auto same = [](vtkLimnLight* light, Stage&)
  {
    light->SetShapeToRectangle();
    light->SetWidth(60);
    light->SetHeight(1e-3);
    light->SetSamples(64);
    hang(light, 30);
  };
  CHECK_EQUAL(greyAt<vtkLimnLight>(80, 40, scaled), greyAt<vtkLimnLight>(80, 40, same));
}
}

int TestLimnLights(int, char*[])
{
  checkShapes();
  checkPower();
  checkSoftEdge();
  checkTransform();
  const auto slanted = [](vtkLight* light, Stage&)
  {
    light->SetPosition(0, 60, 80);
    light->SetFocalPoint(0, 0, 0);
  };
  CHECK(isNear(greyAt(50, 40, slanted), 255 * 0.8));

  const auto dimmed = [](vtkLight* light, Stage&)
  {
    light->SetPosition(0, 0, 1);
    light->SetIntensity(0.5);
    light->SetDiffuseColor(0.5, 0.5, 0.5);
  };
  CHECK(isNear(greyAt(50, 40, dimmed), 255 * 0.25));

  // Switched off, so that the renderer makes a headlight of its own.
  const auto off = [](vtkLight* light, Stage&) { light->SwitchOff(); };
  CHECK_EQUAL(greyAt(50, 40, off), 255);
  const auto dark = [](vtkLight* light, Stage& stage)
  {
    light->SwitchOff();
    stage.Renderer->AutomaticLightCreationOff();
    stage.Actor->GetProperty()->SetAmbient(0.2);
    stage.Actor->GetProperty()->SetDiffuse(0.4);
  };
  // As VTK: unlit.
  CHECK_EQUAL(greyAt(50, 40, dark), 51 + 102);

  // 30 above (50.5, 40.5): at distance 40 beside it cos = 0.6.
  const auto lamp = [](vtkLight* light, Stage&)
  {
    light->PositionalOn();
    light->SetConeAngle(180);
    light->SetPosition(50.5, 40.5, 30);
    light->SetFocalPoint(50.5, 40.5, 0);
  };
  CHECK_EQUAL(greyAt(50, 40, lamp), 255);
  CHECK(isNear(greyAt(90, 40, lamp), 255 * 0.6));
  const auto fading = [](vtkLight* light, Stage&)
  {
    light->PositionalOn();
    light->SetConeAngle(180);
    light->SetAttenuationValues(0, 0, 1.0 / 1600);
    light->SetPosition(50.5, 40.5, 40);
    light->SetFocalPoint(50.5, 40.5, 0);
  };
  CHECK_EQUAL(greyAt(50, 40, fading), 255);
  // At distance 50, cos = 0.8.
  CHECK(isNear(greyAt(80, 40, fading), 255 * 0.8 * 1600 / 2500));
  const auto spot = [](vtkLight* light, Stage&)
  {
    light->PositionalOn();
    light->SetConeAngle(45);
    light->SetExponent(2);
    light->SetPosition(50.5, 40.5, 30);
    light->SetFocalPoint(50.5, 40.5, 0);
  };
  // cos^2 of the cone times cos of the surface; outside of the cone nothing.
  const double cosine = 30 / std::sqrt(30 * 30 + 20 * 20);
  CHECK(isNear(greyAt(70, 40, spot), 255 * cosine * cosine * cosine));
  CHECK_EQUAL(greyAt(90, 40, spot), 0);

  const auto camera = [](vtkLight* light, Stage&)
  {
    light->SetLightTypeToCameraLight();
    light->SetPosition(0, 0.6, 0.8);
    light->SetFocalPoint(0, 0, 0);
  };
  CHECK(isNear(greyAt(50, 40, camera), 255 * 0.8));
  const auto nowhere = [](vtkLight* light, Stage& stage)
  {
    light->SetPosition(1, 1, 1);
    light->SetFocalPoint(1, 1, 1);
    stage.Actor->GetProperty()->SetAmbient(0.2);
  };
  CHECK_EQUAL(greyAt(50, 40, nowhere), 51);

  // I_a is the chapter's, and VTK's own shading does not have it.
  const auto ambient = [](vtkLight* light, Stage& stage)
  {
    light->SwitchOff();
    stage.Renderer->AutomaticLightCreationOff();
    stage.Renderer->SetAmbient(0.5, 0.5, 0.5);
    stage.Actor->GetProperty()->SetAmbient(0.4);
    vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty())->SetReflectionModelToLambert();
  };
  CHECK_EQUAL(greyAt(50, 40, ambient), 51);
  return result();
}
