// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnHardwareSelector.h"

#include "Private/Complaints.h"
#include "Private/EngineState.h"
#include "Private/SceneFromRenderer.h"
#include "Private/Surface.h"
#include "Private/WindowFrame.h"

#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderer.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"

#include <algorithm>

namespace
{
// 0 in a pixel buffer means nothing is there, so numbers of props are stored plus one.
constexpr int PropOffset = 1;
constexpr int BytesPerPass = 3;

struct SelectedSurface
{
  limn::bridge::Surface Surface;
  int PropID;
};

struct SelectionPlanes
{
  int Width = 0;
  int Height = 0;
  std::vector<std::uint32_t> Instance;
  std::vector<std::uint32_t> Cell;
  std::vector<float> Depth;
};
}

class vtkLimnHardwareSelector::vtkInternals
{
public:
  std::vector<SelectedSurface> Surfaces;
  SelectionPlanes Planes;
  int Origin[2] = { 0, 0 };
  std::vector<int> PropOfInstance;
};

vtkStandardNewMacro(vtkLimnHardwareSelector);

//------------------------------------------------------------------------------
vtkLimnHardwareSelector::vtkLimnHardwareSelector() : Internals(new vtkInternals) {}

//------------------------------------------------------------------------------
vtkLimnHardwareSelector::~vtkLimnHardwareSelector() = default;

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::AddSurface(vtkActor* actor, vtkLimnPolyDataMapper* mapper)
{
  this->Internals->Surfaces.push_back(
    { limn::bridge::surfaceOf(actor, mapper, false), this->PropID });
}

//------------------------------------------------------------------------------
bool vtkLimnHardwareSelector::CaptureBuffers()
{
  if (!this->Renderer || !vtkLimnRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow()))
  {
    vtkErrorMacro("Call SetRenderer() with a renderer of a vtkLimnRenderWindow first.");
    return false;
  }
  if (this->FieldAssociation != vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    vtkErrorMacro("Points cannot be selected in a vtkLimnRenderWindow yet; select cells, or use an "
                  "OpenGL window (LIMN_WINDOW=gl).");
    return false;
  }
  this->InvokeEvent(vtkCommand::StartEvent);
  this->BeginSelection();
  this->Iteration = 0;
  this->CurrentPass = ACTOR_PASS;
  this->Internals->Surfaces.clear();
  this->RenderPickableProps();
  this->EndSelection();
  this->InvokeEvent(vtkCommand::EndEvent);
  return true;
}

//------------------------------------------------------------------------------
int vtkLimnHardwareSelector::RenderPickableProps()
{
  vtkPropCollection* candidates =
    static_cast<vtkLimnRenderer*>(this->Renderer)->GetPropsToPickFrom();
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator iterator;
  candidates->InitTraversal(iterator);
  while (vtkProp* prop = candidates->GetNextProp(iterator))
  {
    // Only 3D props show surfaces; others might need a graphics library to render.
    if (prop->GetVisibility() && prop->IsA("vtkProp3D") && !prop->IsA("vtkVolume") &&
        !prop->IsA("vtkImageSlice"))
    {
      props.push_back(prop);
    }
  }
  return this->Render(this->Renderer, props.data(), static_cast<int>(props.size()));
}

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::DrawIds()
{
  vtkInternals& selected = *this->Internals;
  selected.PropOfInstance.clear();
  std::vector<limn::Instance> instances;
  limn::bridge::FrameNormals normals;
  limn::bridge::Complaints complaints;
  for (const SelectedSurface& surface : selected.Surfaces)
  {
    // Outlines are left out: what is under the ink is what is picked.
    limn::Instance instance;
    if (limn::bridge::describe(surface.Surface, instance, normals, nullptr, complaints))
    {
      instance.id = static_cast<std::uint32_t>(instances.size());
      instances.push_back(instance);
      selected.PropOfInstance.push_back(surface.PropID);
    }
  }
  SelectionPlanes& planes = selected.Planes;
  this->Renderer->GetTiledSizeAndOrigin(
    &planes.Width, &planes.Height, &selected.Origin[0], &selected.Origin[1]);
  const size_t pixels = static_cast<size_t>(std::max(planes.Width, 0)) * std::max(planes.Height, 0);
  planes.Instance.assign(pixels, limn::kNobody);
  planes.Cell.assign(pixels, limn::kNobody);
  planes.Depth.assign(pixels, 1.0f);
  if (instances.empty() || pixels == 0)
  {
    return;
  }
  std::vector<limn::Rgba8> color(pixels);
  limn::FrameView frame;
  frame.width = planes.Width;
  frame.height = planes.Height;
  frame.rowStride = planes.Width;
  frame.color = color.data();
  frame.depth = planes.Depth.data();
  frame.instance = planes.Instance.data();
  frame.cell = planes.Cell.data();
  const std::vector<limn::Light> lights = limn::bridge::lightsOf(this->Renderer);
  limn::Scene scene;
  scene.camera = limn::bridge::cameraOf(this->Renderer);
  scene.lights = lights;
  scene.instances = instances;
  const limn::Status status =
    limn::render(scene, frame, limn::bridge::EngineState::instance().options);
  if (!status.ok())
  {
    vtkErrorMacro(<< status.message);
  }
}

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::LeaveDepth()
{
  auto& frame = vtkLimnRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow())->GetFrame();
  const vtkInternals& selected = *this->Internals;
  const float* const depth = selected.Planes.Depth.data();
  frame.ForEachRow(frame.GetDepth(),
    { selected.Origin[0], selected.Origin[1], selected.Planes.Width, selected.Planes.Height },
    [depth](float* row, size_t count, size_t index) { std::copy_n(depth + index, count, row); });
}

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::SavePixelBuffer(int vtkNotUsed(pass))
{
  this->DrawIds();
  this->LeaveDepth();
  const vtkInternals& selected = *this->Internals;
  const int width = static_cast<int>(this->Area[2] - this->Area[0]) + 1;
  const int height = static_cast<int>(this->Area[3] - this->Area[1]) + 1;
  const size_t pixels = static_cast<size_t>(width) * height;
  std::vector<vtkIdType> props(pixels, 0);
  std::vector<vtkIdType> cells(pixels, 0);
  for (size_t i = 0; i < pixels; ++i)
  {
    const int x = static_cast<int>(this->Area[0] + i % width) - selected.Origin[0];
    const int y = static_cast<int>(this->Area[1] + i / width) - selected.Origin[1];
    if (x < 0 || y < 0 || x >= selected.Planes.Width || y >= selected.Planes.Height)
    {
      continue;
    }
    const size_t pixel = static_cast<size_t>(y) * selected.Planes.Width + x;
    const std::uint32_t instance = selected.Planes.Instance[pixel];
    if (instance != limn::kNobody)
    {
      props[i] = selected.PropOfInstance[instance] + PropOffset;
      cells[i] = selected.Planes.Cell[pixel];
    }
  }
  this->SaveIds(ACTOR_PASS, props);
  this->SaveIds(COMPOSITE_INDEX_PASS, std::vector<vtkIdType>(pixels, 0));
  this->SaveIds(CELL_ID_LOW24, cells);
  std::for_each(cells.begin(), cells.end(), [](vtkIdType& cell) { cell >>= 24; });
  this->SaveIds(CELL_ID_HIGH24, cells);
}

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::SaveIds(int pass, const std::vector<vtkIdType>& ids)
{
  for (unsigned char** buffer : { &this->PixBuffer[pass], &this->RawPixBuffer[pass] })
  {
    delete[] * buffer;
    *buffer = new unsigned char[BytesPerPass * ids.size()];
    for (size_t i = 0; i < ids.size(); ++i)
    {
      for (int byte = 0; byte < BytesPerPass; ++byte)
      {
        (*buffer)[BytesPerPass * i + byte] =
          static_cast<unsigned char>(ids[i] >> (8 * byte) & 0xff);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkLimnHardwareSelector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surfaces: " << this->Internals->Surfaces.size() << "\n";
}
