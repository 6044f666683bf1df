// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where actors are, whether they are seen, and what holds them.
#include "Check.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnEngine.h"

#include "vtkAssembly.h"
#include "vtkConeSource.h"
#include "vtkFollower.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropAssembly.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

namespace
{
const Pixel Black = { 0, 0, 0 };

struct ConeStage : Stage
{
  vtkNew<vtkConeSource> Cone;

  ConeStage()
  {
    this->Cone->SetResolution(12);
    this->Mapper->SetInputConnection(this->Cone->GetOutputPort());
    this->Renderer->GetActiveCamera()->SetPosition(0, 0, 6);
    this->Renderer->GetActiveCamera()->SetClippingRange(1, 20);
  }
};

vtkSmartPointer<vtkTransform> turn()
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(0.5, 0.25, 0);
  transform->RotateZ(40);
  transform->Scale(1, 1.5, 0.5);
  return transform;
}

Picture drawWithUserMatrix()
{
  ConeStage stage;
  stage.Actor->SetUserMatrix(turn()->GetMatrix());
  return render(stage.Window);
}

void checkTransforms()
{
  const Picture byMatrix = drawWithUserMatrix();
  CHECK(byMatrix.CountOtherThan(Black) > 300);

  ConeStage plain;
  CHECK(!(render(plain.Window) == byMatrix));

  ConeStage byActor;
  byActor.Actor->SetPosition(0.5, 0.25, 0);
  byActor.Actor->RotateZ(40);
  byActor.Actor->SetScale(1, 1.5, 0.5);
  CHECK_EQUAL(render(byActor.Window).CountDifferent(byMatrix, 1), 0);

  ConeStage byFilter;
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(turn());
  filter->SetInputConnection(byFilter.Cone->GetOutputPort());
  byFilter.Mapper->SetInputConnection(filter->GetOutputPort());
  // Its points are rounded to floats before they are drawn.
  CHECK(render(byFilter.Window).CountDifferent(byMatrix, 2) < 20);
}

template <class Assembly>
void checkAssembly()
{
  const Picture expected = drawWithUserMatrix();
  ConeStage stage;
  stage.Renderer->RemoveAllViewProps();
  vtkNew<Assembly> assembly;
  assembly->AddPart(stage.Actor);
  stage.Actor->SetUserMatrix(turn()->GetMatrix());
  stage.Renderer->AddViewProp(assembly);
  CHECK(render(stage.Window) == expected);
  CHECK(render(stage.Window) == expected);
  assembly->VisibilityOff();
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
}

// Twice the same part, placed by the assemblies that hold it.
void checkNestedAssemblies()
{
  ConeStage flat;
  flat.Actor->SetUserMatrix(turn()->GetMatrix());
  vtkNew<vtkLimnActor> second;
  second->SetMapper(flat.Mapper);
  second->SetPosition(0, 1.25, 0);
  flat.Renderer->AddActor(second);
  const Picture expected = render(flat.Window);
  // Twice a cone of twelve sides with a base of twelve corners.
  CHECK_EQUAL(vtkLimnEngine::GetTriangles(), 2 * (12 + 10));

  ConeStage stage;
  stage.Renderer->RemoveAllViewProps();
  vtkNew<vtkAssembly> turned;
  turned->AddPart(stage.Actor);
  turned->SetUserMatrix(turn()->GetMatrix());
  vtkNew<vtkAssembly> moved;
  moved->AddPart(stage.Actor);
  moved->SetPosition(0, 1.25, 0);
  vtkNew<vtkAssembly> both;
  both->AddPart(turned);
  both->AddPart(moved);
  stage.Renderer->AddViewProp(both);
  CHECK(render(stage.Window) == expected);
  CHECK_EQUAL(vtkLimnEngine::GetTriangles(), 2 * (12 + 10));
}

// Passes that draw the props of a renderer more than once, as shadow maps do.
void checkDrawnAgain()
{
  ConeStage stage;
  vtkNew<vtkLimnActor> second;
  second->SetMapper(stage.Mapper);
  second->SetPosition(0, 1.25, 0);
  stage.Renderer->AddActor(second);
  const Picture expected = render(stage.Window);
  const vtkIdType triangles = vtkLimnEngine::GetTriangles();
  stage.Renderer->Clear();
  CHECK_EQUAL(read(stage.Window).CountOtherThan(Black), 0);
  CHECK_EQUAL(second->RenderOpaqueGeometry(stage.Renderer), 1);
  CHECK_EQUAL(stage.Actor->RenderOpaqueGeometry(stage.Renderer), 1);
  CHECK(read(stage.Window) == expected);
  CHECK_EQUAL(vtkLimnEngine::GetTriangles(), 2 * triangles);
}

class CameraTurner : public vtkProp
{
public:
  static CameraTurner* New();
  vtkTypeMacro(CameraTurner, vtkProp);

  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    static_cast<vtkRenderer*>(viewport)->GetActiveCamera()->Azimuth(30);
    return 1;
  }
};
vtkStandardNewMacro(CameraTurner);

// What is drawn together is drawn again for another view.
void checkCameraTurnedInBetween()
{
  ConeStage stage;
  vtkNew<CameraTurner> turner;
  stage.Renderer->AddViewProp(turner);
  vtkNew<vtkLimnActor> second;
  second->SetMapper(stage.Mapper);
  second->SetPosition(0, 1.25, 0);
  stage.Renderer->AddActor(second);
  vtkNew<vtkLimnActor> third;
  third->SetMapper(stage.Mapper);
  third->SetPosition(0, -1.25, 0);
  stage.Renderer->AddActor(third);
  turner->VisibilityOff();
  const Picture still = render(stage.Window);
  const vtkIdType triangles = vtkLimnEngine::GetTriangles();
  turner->VisibilityOn();
  CHECK(!(render(stage.Window) == still));
  CHECK_EQUAL(vtkLimnEngine::GetTriangles(), 2 * triangles);
}

void checkVisibility()
{
  ConeStage stage;
  const int both = render(stage.Window).CountOtherThan(Black);
  stage.Actor->VisibilityOff();
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
  stage.Actor->VisibilityOn();
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), both);
  stage.Renderer->RemoveActor(stage.Actor);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 0);
}

void checkOneMapperForTwoActors()
{
  ConeStage stage;
  const int one = render(stage.Window).CountOtherThan(Black);
  vtkNew<vtkLimnActor> second;
  second->SetMapper(stage.Mapper);
  second->SetPosition(0, 1.25, 0);
  stage.Renderer->AddActor(second);
  CHECK(render(stage.Window).CountOtherThan(Black) > one * 3 / 2);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);
}

// It hands its mapper to an actor of its own.
void checkFollower()
{
  ConeStage stage;
  const int cone = render(stage.Window).CountOtherThan(Black);
  stage.Renderer->RemoveAllViewProps();
  vtkNew<vtkFollower> follower;
  follower->SetMapper(stage.Mapper);
  follower->SetCamera(stage.Renderer->GetActiveCamera());
  stage.Renderer->AddActor(follower);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), cone);
}

void checkCulling()
{
  ConeStage stage;
  const Picture closed = render(stage.Window);
  stage.Actor->GetProperty()->BackfaceCullingOn();
  CHECK(render(stage.Window) == closed);
  stage.Actor->GetProperty()->BackfaceCullingOff();
  stage.Actor->GetProperty()->FrontfaceCullingOn();
  const Picture inside = render(stage.Window);
  CHECK(!(inside == closed));
  CHECK(inside.CountOtherThan(Black) > 300);
  // VTK: if both are on, the back faces are culled.
  stage.Actor->GetProperty()->BackfaceCullingOn();
  CHECK(render(stage.Window) == closed);
}
}

int TestLimnActors(int, char*[])
{
  checkTransforms();
  checkAssembly<vtkAssembly>();
  checkAssembly<vtkPropAssembly>();
  checkNestedAssemblies();
  checkDrawnAgain();
  checkCameraTurnedInBetween();
  checkVisibility();
  checkOneMapperForTwoActors();
  checkFollower();
  checkCulling();
  return result();
}
