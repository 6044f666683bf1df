// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent actors in a window without OpenGL: what makes an actor translucent, and what it is
// drawn over.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkAppendPolyData.h"
#include "vtkAssembly.h"
#include "vtkCellData.h"
#include "vtkFollower.h"
#include "vtkImageData.h"
#include "vtkFieldData.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <vector>

namespace
{
/// A quad over the whole stage at a height; -1 is far, 1 near.
vtkSmartPointer<vtkPolyData> makePane(double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-5, -5, z);
  plane->SetPoint1(105, -5, z);
  plane->SetPoint2(-5, 85, z);
  plane->Update();
  return plane->GetOutput();
}

template <class Actor = vtkLimnActor>
vtkSmartPointer<Actor> makeActor(double z, double red, double green, double opacity)
{
  vtkNew<vtkLimnPolyDataMapper> mapper;
  mapper->SetInputData(makePane(z));
  auto actor = vtkSmartPointer<Actor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(red, green, 0);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

/// A flat look at a black background.
struct Panes : Stage
{
  Panes()
  {
    this->LookFlat();
    this->Renderer->RemoveActor(this->Actor);
  }
  void Add(vtkProp* prop) { this->Renderer->AddViewProp(prop); }
  Pixel Center() { return render(this->Window).At(50, 40); }
};

#define CHECK_COLOR(actual, red, green)                                                            \
  do                                                                                               \
  {                                                                                                \
    const Pixel shown = actual;                                                                    \
    if (std::abs(shown[0] - (red)) > 0.51 || std::abs(shown[1] - (green)) > 0.51)                  \
    {                                                                                              \
      CHECK_EQUAL(shown, (Pixel{ int(red), int(green), 0 }));                                      \
    }                                                                                              \
  } while (false)

// Half of the green one in front, then a quarter of the red one, then the wall.
void checkSorting()
{
  for (const int samples : { 0, 4, 16 })
  {
    for (const int order : { 0, 1 })
    {
      Panes panes;
      panes.Window->SetMultiSamples(samples);
      const auto red = makeActor(0, 1, 0, 0.25);
      const auto green = makeActor(0.5, 0, 1, 0.5);
      panes.Add(order == 0 ? red : green);
      panes.Add(makeActor(-0.5, 0.4, 0.4, 1));
      panes.Add(makeActor(-0.7, 1, 1, 0.9));
      panes.Add(order == 0 ? green : red);
      CHECK_COLOR(panes.Center(), 0.5 * (0.25 * 255 + 0.75 * 102), 0.5 * 255 + 0.5 * 0.75 * 102);
      CHECK_COLOR(panes.Center(), 0.5 * (0.25 * 255 + 0.75 * 102), 0.5 * 255 + 0.5 * 0.75 * 102);
    }
  }
}

void checkWithoutOpaqueActors()
{
  Panes panes;
  panes.Add(makeActor(0, 1, 0, 0.25));
  CHECK_COLOR(panes.Center(), 0.25 * 255, 0);
  panes.Add(makeActor(0, 0, 1, 0));
  CHECK_COLOR(panes.Center(), 0.25 * 255, 0);
}

// Depth and position are those of what lies behind, as in VTK.
void checkDepth()
{
  Panes panes;
  panes.Add(makeActor(0, 1, 0, 0.25));
  render(panes.Window);
  CHECK_EQUAL(panes.Window->GetZbufferDataAtPoint(50, 40), 1.0f);
  panes.Add(makeActor(-0.5, 0.4, 0.4, 1));
  render(panes.Window);
  CHECK(std::abs(panes.Window->GetZbufferDataAtPoint(50, 40) - 0.75f) < 1e-5f);
}

// As vtkActor::HasTranslucentPolygonalGeometry() sees them.
void checkScalars()
{
  Panes panes;
  const auto actor = makeActor(0, 0, 0, 1);
  panes.Add(actor);
  vtkPolyData* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  colors->InsertNextTuple4(255, 0, 0, 51);
  data->GetCellData()->SetScalars(colors);
  CHECK_COLOR(panes.Center(), 51, 0);
  actor->GetProperty()->SetOpacity(0.5);
  CHECK_COLOR(panes.Center(), 25.5, 0);
  actor->GetProperty()->SetOpacity(1);

  // Alpha of points runs evenly.
  data->GetCellData()->SetScalars(nullptr);
  colors->Reset();
  for (const int alpha : { 0, 255, 0, 255 })
  {
    colors->InsertNextTuple4(255, 0, 0, alpha);
  }
  data->GetPointData()->SetScalars(colors);
  CHECK_COLOR(panes.Center(), 255 * 55.5 / 110, 0);

  // By a table.
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 0, 1, 0, 0.4);
  table->SetTableValue(1, 0, 1, 0, 0.4);
  vtkNew<vtkUnsignedCharArray> values;
  values->InsertNextValue(0);
  data->GetPointData()->SetScalars(nullptr);
  data->GetCellData()->SetScalars(values);
  actor->GetMapper()->SetColorModeToMapScalars();
  actor->GetMapper()->SetLookupTable(table);
  CHECK_COLOR(panes.Center(), 0, 102);

  // One tuple of field data for all.
  data->GetCellData()->SetScalars(nullptr);
  colors->Reset();
  colors->InsertNextTuple4(255, 255, 255, 255);
  colors->InsertNextTuple4(255, 0, 0, 51);
  colors->SetName("paint");
  data->GetFieldData()->AddArray(colors);
  actor->GetMapper()->SetColorModeToDirectScalars();
  actor->GetMapper()->SetScalarModeToUseFieldData();
  actor->GetMapper()->SelectColorArray("paint");
  actor->GetMapper()->SetFieldDataTupleId(1);
  CHECK_COLOR(panes.Center(), 51, 0);
}

void checkTexture()
{
  Panes panes;
  const auto actor = makeActor(0, 1, 1, 1);
  panes.Add(makeActor(-0.5, 0.4, 0.4, 1));
  panes.Add(actor);
  vtkNew<vtkImageData> image;
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const double texel[4] = { 255, 0, 0, 51 };
  for (int i = 0; i < 4; ++i)
  {
    image->SetScalarComponentFromDouble(0, 0, 0, i, texel[i]);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
  CHECK_COLOR(panes.Center(), 0.2 * 255 + 0.8 * 102, 0.8 * 102);
  actor->GetProperty()->SetOpacity(0.5);
  CHECK_COLOR(panes.Center(), 0.1 * 255 + 0.9 * 102, 0.9 * 102);
}

void checkForced()
{
  Panes panes;
  const auto forced = makeActor(0.5, 1, 0, 1);
  forced->ForceTranslucentOn();
  panes.Add(forced);
  panes.Add(makeActor(-0.5, 0.4, 0.4, 1));
  CHECK_COLOR(panes.Center(), 255, 0);
  // It writes no depth.
  CHECK(std::abs(panes.Window->GetZbufferDataAtPoint(50, 40) - 0.75f) < 1e-5f);
}

// A follower draws as another actor than it is, so that it comes by itself: before the panes if it
// is opaque.
void checkFollower()
{
  Panes panes;
  // With this one begins what is drawn.
  panes.Add(makeActor(-0.9, 1, 1, 1));
  panes.Add(makeActor(0, 1, 0, 0.25));
  const auto follower = makeActor<vtkFollower>(-0.5, 0.4, 0.4, 1);
  follower->SetCamera(panes.Renderer->GetActiveCamera());
  panes.Add(follower);
  CHECK_COLOR(panes.Center(), 0.25 * 255 + 0.75 * 102, 0.75 * 102);
  follower->GetProperty()->SetOpacity(0.5);
  const double red = 0.25 * 255 + 0.75 * 255;
  const double green = 0.75 * 255;
  CHECK_COLOR(panes.Center(), 0.5 * 102 + 0.5 * red, 0.5 * 102 + 0.5 * green);
}

void checkAssembly()
{
  Panes panes;
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(makeActor(0, 1, 0, 0.25));
  assembly->AddPart(makeActor(-0.5, 0.4, 0.4, 1));
  assembly->SetPosition(0, 0, 0.25);
  panes.Add(makeActor(0.6, 0, 1, 0.5));
  panes.Add(assembly);
  CHECK_COLOR(panes.Center(), 0.5 * (0.25 * 255 + 0.75 * 102), 0.5 * 255 + 0.5 * 0.75 * 102);
}

void checkTruncation()
{
  Panes panes;
  vtkNew<vtkAppendPolyData> stack;
  for (int i = 0; i < 260; ++i)
  {
    stack->AddInputData(makePane(-0.9 + 0.005 * i));
  }
  const auto actor = makeActor(0, 1, 0, 0.004);
  actor->GetMapper()->SetInputConnection(0, stack->GetOutputPort());
  panes.Add(actor);
  panes.Window->SetSize(64, 1);
  panes.Renderer->GetActiveCamera()->SetParallelScale(0.5);
  panes.Window->SetMultiSamples(16);
  Messages messages;
  panes.Window->Render();
  CHECK_EQUAL(messages.Count("In 64 pixels too many translucent surfaces"), 1);
  panes.Window->Render();
  CHECK_EQUAL(messages.Count("too many translucent surfaces"), 1);
  const double nearest = 255 * (1 - std::pow(1 - 0.004, 256));
  CHECK_COLOR(read(panes.Window).At(30, 0), nearest, 0);
}

void checkUnusableOpacity()
{
  Panes panes;
  const auto actor = makeActor(0, 1, 0, std::nan(""));
  panes.Add(actor);
  Messages messages;
  CHECK_COLOR(panes.Center(), 0, 0);
  CHECK_EQUAL(messages.Count("Opacity of its vtkLimnProperty has the value nan"), 1);
}
} // namespace

int TestLimnTranslucency(int, char*[])
{
  checkSorting();
  checkWithoutOpaqueActors();
  checkDepth();
  checkScalars();
  checkTexture();
  checkForced();
  checkFollower();
  checkAssembly();
  checkTruncation();
  checkUnusableOpacity();
  return result();
}
