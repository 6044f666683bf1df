// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which actors and cells are seen, through VTK's own pickers and selectors.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnHardwareSelector.h"
#include "vtkLimnProperty.h"

#include "vtkAssemblyPath.h"
#include "vtkCellPicker.h"
#include "vtkCubeSource.h"
#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPropCollection.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <cmath>
#include <map>
#include <set>

namespace
{
using Selected = std::map<vtkObjectBase*, std::set<vtkIdType>>;

Selected select(Stage& stage, unsigned int x1, unsigned int y1, unsigned int x2, unsigned int y2)
{
  vtkNew<vtkLimnHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(x1, y1, x2, y2);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Selected selected;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType j = 0; j < ids->GetNumberOfTuples(); ++j)
    {
      selected[node->GetProperties()->Get(vtkSelectionNode::PROP())].insert(ids->GetValue(j));
    }
  }
  return selected;
}

/// Of 60 x 60 pixels, around the middle of the picture.
vtkSmartPointer<vtkPolyData> bigSquare()
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(flatPoints({ { 20, 10 }, { 80, 10 }, { 80, 70 }, { 20, 70 } }));
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  return data;
}

/// Where a ray through the middle of the picture meets what can be picked.
double pickedHeight(vtkRenderer* renderer)
{
  vtkNew<vtkPropPicker> picker;
  CHECK(picker->PickProp(50, 40, renderer) != 0);
  return picker->GetPickPosition()[2];
}

// The window's depth is that of the nearest actor.
void checkPickPosition(int samples)
{
  Stage stage;
  stage.LookFlat();
  stage.Window->SetMultiSamples(samples);
  stage.Mapper->SetInputData(bigSquare());
  stage.Actor->SetPosition(0, 0, 0.5);
  vtkNew<vtkLimnActor> behind;
  behind->SetMapper(stage.Mapper);
  behind->SetPosition(0, 0, -0.5);
  stage.Renderer->AddActor(behind);
  const Picture before = render(stage.Window);
  const double tolerance = 1e-6;
  CHECK(std::abs(pickedHeight(stage.Renderer) - 0.5) < tolerance);
  stage.Actor->PickableOff();
  CHECK(std::abs(pickedHeight(stage.Renderer) + 0.5) < tolerance);
  vtkNew<vtkPropCollection> all;
  all->AddItem(behind);
  stage.Actor->PickableOn();
  vtkNew<vtkPropPicker> picker;
  CHECK(picker->PickProp(50, 40, stage.Renderer, all) != 0);
  CHECK(std::abs(picker->GetPickPosition()[2] + 0.5) < tolerance);
  CHECK(read(stage.Window) == before);
  CHECK(render(stage.Window) == before);
  CHECK(std::abs(stage.Renderer->GetZ(50, 40) - 0.25) < tolerance);
}

// Of the renderer's viewport all pixels are left, of others none.
void checkDepthAfterSelections()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(bigSquare());
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkLimnRenderer> right;
  right->SetViewport(0.5, 0, 1, 1);
  right->SetActiveCamera(stage.Renderer->GetActiveCamera());
  right->AddActor(stage.Actor);
  stage.Window->AddRenderer(right);
  stage.Window->Render();
  const double depth = right->GetZ(75, 40);
  CHECK_EQUAL(stage.Renderer->GetZ(25, 40), depth);
  vtkNew<vtkLimnHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto depthAfterSelection = [&]
  {
    vtkSmartPointer<vtkSelection>::Take(selector->Select());
    return stage.Renderer->GetZ(25, 40);
  };
  CHECK_EQUAL(depthAfterSelection(), depth);
  stage.Actor->PickableOff();
  CHECK_EQUAL(depthAfterSelection(), 1.0);
  CHECK_EQUAL(right->GetZ(75, 40), depth);
}

// The ink of an outline is nobody's: what it covers is found, as without it.
void checkOutline()
{
  Stage stage;
  stage.LookFlat();
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(20);
  cube->SetYLength(20);
  cube->SetZLength(0.5);
  cube->SetCenter(50, 40, 0);
  stage.Mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkLimnActor> behind;
  vtkNew<vtkLimnPolyDataMapper> wall;
  wall->SetInputData(bigSquare());
  behind->SetMapper(wall);
  behind->SetPosition(0, 0, -0.5);
  stage.Renderer->AddActor(behind);
  const Picture without = render(stage.Window);
  const Selected onBorder = select(stage, 56, 40, 64, 40);
  const Selected besides = select(stage, 61, 40, 63, 40);
  auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->SetOutlineToHull();
  property->SetOutlineWidth(5);
  CHECK(!(render(stage.Window) == without));
  CHECK(select(stage, 56, 40, 64, 40) == onBorder);
  CHECK(select(stage, 61, 40, 63, 40) == besides);
  CHECK_EQUAL(besides.count(stage.Actor.Get()), 0u);
  CHECK_EQUAL(onBorder.size(), 2u);
}
}

int TestLimnSelector(int, char*[])
{
  checkOutline();
  Stage stage;
  stage.LookFlat();
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  vtkNew<vtkCellArray> lines;
  addCell(lines, { 0, 1 });
  data->SetLines(lines);
  stage.Mapper->SetInputData(data);
  vtkNew<vtkLimnActor> behind;
  behind->SetMapper(stage.Mapper);
  behind->SetPosition(0, 30, -0.5);
  stage.Renderer->AddActor(behind);
  const Picture before = render(stage.Window);

  // Cell 0 is the line; the squares are 1 and 2.
  const Selected all = select(stage, 0, 0, 99, 79);
  CHECK(all == (Selected{ { stage.Actor, { 1, 2 } }, { behind, { 1, 2 } } }));
  CHECK(select(stage, 15, 15, 20, 20) == (Selected{ { stage.Actor, { 1 } } }));
  CHECK(
    select(stage, 25, 25, 45, 45) == (Selected{ { stage.Actor, { 1, 2 } }, { behind, { 1, 2 } } }));
  CHECK(select(stage, 0, 0, 5, 5).empty());
  behind->PickableOff();
  CHECK(select(stage, 0, 0, 99, 79) == (Selected{ { stage.Actor, { 1, 2 } } }));
  CHECK(read(stage.Window) == before);

  vtkNew<vtkPropPicker> propPicker;
  CHECK(propPicker->PickProp(20, 20, stage.Renderer) != 0);
  CHECK(propPicker->GetViewProp() == stage.Actor);
  CHECK_EQUAL(propPicker->PickProp(2, 2, stage.Renderer), 0);
  vtkNew<vtkCellPicker> cellPicker;
  CHECK(cellPicker->Pick(50, 20, 0, stage.Renderer) != 0);
  CHECK_EQUAL(cellPicker->GetCellId(), 2);

  // What shows something can be selected, and what the window does not draw is not there.
  vtkProperty* look = stage.Actor->GetProperty();
  look->SetOpacity(0.5);
  CHECK(select(stage, 0, 0, 99, 79) == (Selected{ { stage.Actor, { 1, 2 } } }));
  look->SetOpacity(0);
  CHECK(select(stage, 0, 0, 99, 79).empty());
  look->SetOpacity(1);
  look->SetRepresentationToWireframe();
  CHECK(select(stage, 0, 0, 99, 79).empty());
  CHECK_EQUAL(propPicker->PickProp(20, 20, stage.Renderer), 0);
  look->SetRepresentationToSurface();
  look->EdgeVisibilityOn();
  CHECK(select(stage, 0, 0, 99, 79) == (Selected{ { stage.Actor, { 1, 2 } } }));

  checkPickPosition(0);
  checkPickPosition(4);
  checkDepthAfterSelections();

  Messages messages;
  vtkNew<vtkLimnHardwareSelector> points;
  points->SetRenderer(stage.Renderer);
  points->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  CHECK(points->Select() == nullptr);
  CHECK_EQUAL(messages.Count("Points cannot be selected"), 1);
  return result();
}
