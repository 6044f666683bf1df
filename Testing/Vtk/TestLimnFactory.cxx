// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Run with LIMN_WINDOW=cpu: a program that only knows VTK's names gets Limn's classes and the same
// picture as one that names them.
#include "Check.h"
#include "Picture.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkHardwareSelector.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkUniforms.h"

#include <string>

namespace
{
template <class Window, class Renderer, class Actor, class Mapper, class Property>
Picture draw()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetPhiResolution(24);
  sphere->SetThetaResolution(24);
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(1.5);
  vtkNew<Renderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.4);
  for (vtkAlgorithm* source :
    { static_cast<vtkAlgorithm*>(sphere), static_cast<vtkAlgorithm*>(cone) })
  {
    vtkNew<Mapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<Property> property;
    property->SetColor(0.9, 0.6, 0.3);
    property->SetSpecular(0.5);
    property->SetSpecularPower(20);
    vtkNew<Actor> actor;
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    renderer->AddActor(actor);
  }
  vtkNew<Window> window;
  window->SetSize(160, 120);
  window->AddRenderer(renderer);
  return render(window);
}

template <class Base>
std::string made()
{
  vtkNew<Base> object;
  return object ? object->GetClassName() : "nothing";
}
}

int TestLimnFactory(int, char*[])
{
  CHECK_EQUAL(made<vtkActor>(), "vtkLimnActor");
  CHECK_EQUAL(made<vtkCamera>(), "vtkLimnCamera");
  CHECK_EQUAL(made<vtkHardwareSelector>(), "vtkLimnHardwareSelector");
  CHECK_EQUAL(made<vtkPolyDataMapper>(), "vtkLimnPolyDataMapper");
  CHECK_EQUAL(made<vtkProperty>(), "vtkLimnProperty");
  CHECK_EQUAL(made<vtkRenderWindow>(), "vtkLimnRenderWindow");
  CHECK_EQUAL(made<vtkRenderWindowInteractor>(), "vtkLimnRenderWindowInteractor");
  CHECK_EQUAL(made<vtkRenderer>(), "vtkLimnRenderer");
  CHECK_EQUAL(made<vtkShaderProperty>(), "vtkLimnShaderProperty");
  CHECK_EQUAL(made<vtkUniforms>(), "vtkLimnUniforms");

  const Picture plain =
    draw<vtkRenderWindow, vtkRenderer, vtkActor, vtkPolyDataMapper, vtkProperty>();
  const Picture named = draw<vtkLimnRenderWindow, vtkLimnRenderer, vtkLimnActor,
    vtkLimnPolyDataMapper, vtkLimnProperty>();
  CHECK(plain == named);
  CHECK(plain.CountOtherThan({ 26, 51, 102 }) > 3000);
  return result();
}
