// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnOpenGLCompositor.h"

#include "vtkLimnOpenGLActor.h"

#include "Private/BackendActor.h"
#include "Private/LayerPainter.h"
#include "Private/SampleMatch.h"
#include "Private/SelectionIds.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"
#include "vtk_glew.h"

#include <map>
#include <utility>

namespace
{
/// Removes an observer when it goes, unless the observed object went first.
class Observation
{
public:
  Observation() = default;
  Observation(vtkObject* object, unsigned long tag) : Object(object), Tag(tag) {}
  Observation(const Observation&) = delete;
  Observation& operator=(Observation&& other) noexcept
  {
    std::swap(this->Object, other.Object);
    std::swap(this->Tag, other.Tag);
    return *this;
  }
  bool IsActive() const { return this->Object != nullptr; }
  ~Observation()
  {
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Tag);
    }
  }

private:
  vtkWeakPointer<vtkObject> Object;
  unsigned long Tag = 0;
};

/// The next smaller of 8, 4, 2 and 1.
int SupportedSamples(int samples)
{
  int supported = 1;
  while (supported < 8 && 2 * supported <= samples)
  {
    supported *= 2;
  }
  return supported;
}

struct WindowState
{
  explicit WindowState(vtkOpenGLRenderWindow* window) : Painter(window) {}
  LayerPainter Painter;
  std::map<vtkObject*, std::map<vtkObject*, BackendActor>> Twins; ///< by actor, then by mapper
  Observation OfWindow;
};
}

class vtkLimnOpenGLCompositor::vtkInternals
{
public:
  WindowState& StateOf(vtkOpenGLRenderWindow* window, vtkLimnOpenGLCompositor* owner)
  {
    const auto found = this->Windows.try_emplace(window, window);
    WindowState& state = found.first->second;
    if (found.second)
    {
      state.OfWindow = Observation(window, window->AddObserver(vtkCommand::DeleteEvent, owner,
                                             &vtkLimnOpenGLCompositor::ForgetWindow));
    }
    return state;
  }

  BackendActor& TwinOf(vtkOpenGLRenderWindow* window, vtkActor* actor, vtkMapper* mapper,
    vtkLimnOpenGLCompositor* owner)
  {
    this->Observe(actor, owner, &vtkLimnOpenGLCompositor::ForgetActor);
    this->Observe(mapper, owner, &vtkLimnOpenGLCompositor::ForgetMapper);
    return this->StateOf(window, owner).Twins[actor][mapper];
  }

  std::map<vtkObject*, WindowState> Windows;
  /// Of actors and mappers that have twins: one each, as every event of an object asks all its
  /// observers, and a mapper may have thousands of actors.
  std::map<vtkObject*, Observation> Observations;
  SelectionIds Selection;
  Observation OfSelectingRenderer;

private:
  using Forget = void (vtkLimnOpenGLCompositor::*)(vtkObject*, unsigned long, void*);
  void Observe(vtkObject* object, vtkLimnOpenGLCompositor* owner, Forget forget)
  {
    Observation& observation = this->Observations[object];
    if (!observation.IsActive())
    {
      observation =
        Observation(object, object->AddObserver(vtkCommand::DeleteEvent, owner, forget));
    }
  }
};

vtkStandardNewMacro(vtkLimnOpenGLCompositor);

vtkLimnOpenGLCompositor::vtkLimnOpenGLCompositor() : Internals(new vtkInternals) {}

vtkLimnOpenGLCompositor::~vtkLimnOpenGLCompositor() = default;

void vtkLimnOpenGLCompositor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Windows: " << this->Internals->Windows.size() << "\n";
}

int vtkLimnOpenGLCompositor::GetSamples(vtkRenderer* renderer)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  if (!window)
  {
    return 1;
  }
  window->MakeCurrent();
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return SupportedSamples(samples);
}

int vtkLimnOpenGLCompositor::GetSamplesForBlend(vtkRenderer* renderer)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  return window ? SupportedSamples(window->GetRenderFramebuffer()->GetMultiSamples()) : 1;
}

bool vtkLimnOpenGLCompositor::Composite(vtkRenderer* renderer, const Layer& layer)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  if (!window)
  {
    return false;
  }
  if (!this->IsValid(layer))
  {
    return false;
  }
  GLint viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (layer.Width != viewport[2] || layer.Height != viewport[3])
  {
    vtkErrorMacro("The layer is " << layer.Width << " x " << layer.Height
                                  << " pixels, but the viewport " << viewport[2] << " x "
                                  << viewport[3] << ".");
    return false;
  }
  return this->IsAccepted(layer, this->Internals->StateOf(window, this).Painter.Paint(layer));
}

bool vtkLimnOpenGLCompositor::IsValid(const Layer& layer)
{
  if (!layer.Color || !layer.Depth || !layer.Coverage)
  {
    vtkErrorMacro("A layer needs colour, depth and coverage; one of them is missing.");
    return false;
  }
  return this->IsSampled(layer.Samples);
}

bool vtkLimnOpenGLCompositor::IsSampled(int samples)
{
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8)
  {
    vtkErrorMacro("A layer has 1, 2, 4 or 8 samples per pixel, not " << samples << ".");
    return false;
  }
  return true;
}

bool vtkLimnOpenGLCompositor::IsAccepted(const Layer& layer, bool isPainted)
{
  if (!isPainted)
  {
    vtkErrorMacro("OpenGL refuses a texture of " << layer.Width << " x " << layer.Height
                                                 << " pixels; make the window smaller.");
  }
  return isPainted;
}

bool vtkLimnOpenGLCompositor::ReadDepth(vtkRenderer* renderer, int width, int height, float* depth)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  if (!window)
  {
    return false;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (size[0] != width || size[1] != height)
  {
    vtkErrorMacro("Depths of " << width << " x " << height
                               << " pixels are asked for, but the viewport is " << size[0] << " x "
                               << size[1] << ".");
    return false;
  }
  return window->GetZbufferData(
           origin[0], origin[1], origin[0] + width - 1, origin[1] + height - 1, depth) == VTK_OK;
}

template <class Paint>
bool vtkLimnOpenGLCompositor::PaintInOwnFramebuffer(
  vtkRenderer* renderer, int width, int height, const Paint& paint)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  if (!window)
  {
    return false;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (width != size[0] || height != size[1])
  {
    vtkErrorMacro("The layer is " << width << " x " << height << " pixels, but the viewport "
                                  << size[0] << " x " << size[1] << ".");
    return false;
  }
  // VTK's translucent passes have framebuffers of their own, which they lay over this one.
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  state->PushFramebufferBindings();
  window->GetRenderFramebuffer()->Bind();
  state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
  const bool isPainted = paint(this->Internals->StateOf(window, this).Painter);
  state->PopFramebufferBindings();
  return isPainted;
}

bool vtkLimnOpenGLCompositor::Blend(vtkRenderer* renderer, const Layer& layer)
{
  return this->IsValid(layer) &&
         this->PaintInOwnFramebuffer(renderer, layer.Width, layer.Height,
           [&](LayerPainter& painter) { return this->IsAccepted(layer, painter.Blend(layer)); });
}

bool vtkLimnOpenGLCompositor::BlendLines(vtkRenderer* renderer, const LineLayer& lines)
{
  return this->IsSampled(lines.Samples) &&
         this->PaintInOwnFramebuffer(renderer, lines.Width, lines.Height,
           [&](LayerPainter& painter)
           {
             painter.BlendLines(lines);
             return true;
           });
}

void vtkLimnOpenGLCompositor::RenderWithBackend(
  vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper)
{
  vtkOpenGLRenderWindow* window = this->GetWindow(renderer);
  if (!window)
  {
    return;
  }
  BackendActor& twin = this->Internals->TwinOf(window, actor, mapper, this);
  twin.Render(renderer, actor, mapper);
  if (renderer->GetSelector())
  {
    this->NoteSelection(renderer, actor, twin.GetMapper());
  }
}

void vtkLimnOpenGLCompositor::RenderMapperWithBackend(
  vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  if (vtkOpenGLRenderWindow* window = this->GetWindow(renderer))
  {
    this->Internals->TwinOf(window, actor, mapper, this)
      .RenderOpenGLMapper(renderer, actor, mapper);
  }
}

vtkActor* vtkLimnOpenGLCompositor::NewActor()
{
  vtkLimnOpenGLActor* actor = vtkLimnOpenGLActor::New();
  actor->SetCompositor(this);
  return actor;
}

void vtkLimnOpenGLCompositor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Windows.erase(window);
}

vtkOpenGLRenderWindow* vtkLimnOpenGLCompositor::GetWindow(vtkRenderer* renderer)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The renderer is in no OpenGL window.");
  }
  return window;
}

void vtkLimnOpenGLCompositor::NoteSelection(
  vtkRenderer* renderer, vtkActor* actor, vtkOpenGLPolyDataMapper* twin)
{
  SelectionIds& selection = this->Internals->Selection;
  if (selection.IsEmpty())
  {
    this->Internals->OfSelectingRenderer =
      Observation(renderer, renderer->AddObserver(vtkCommand::EndEvent, this,
                              &vtkLimnOpenGLCompositor::TranslateSelection));
  }
  selection.Note(renderer->GetSelector(), actor, twin);
}

void vtkLimnOpenGLCompositor::TranslateSelection(vtkObject* caller, unsigned long, void*)
{
  vtkHardwareSelector* selector = static_cast<vtkRenderer*>(caller)->GetSelector();
  if (selector)
  {
    this->Internals->Selection.Translate(selector);
  }
}

void vtkLimnOpenGLCompositor::ForgetWindow(vtkObject* caller, unsigned long, void*)
{
  this->Internals->Windows.erase(caller);
}

void vtkLimnOpenGLCompositor::ForgetActor(vtkObject* caller, unsigned long, void*)
{
  for (auto& window : this->Internals->Windows)
  {
    window.second.Twins.erase(caller);
  }
  this->Internals->Observations.erase(caller);
}

void vtkLimnOpenGLCompositor::ForgetMapper(vtkObject* caller, unsigned long, void*)
{
  for (auto& window : this->Internals->Windows)
  {
    for (auto& twinsOfActor : window.second.Twins)
    {
      twinsOfActor.second.erase(caller);
    }
  }
  this->Internals->Observations.erase(caller);
}
