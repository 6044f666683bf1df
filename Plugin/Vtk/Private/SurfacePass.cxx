// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePass.h"

#include "StyleFromProperty.h"

#include "BackendMapper.h"
#include "ClearViewport.h"
#include "Complaints.h"
#include "CuesFromProperty.h"
#include "EngineState.h"
#include "InteractiveSamples.h"
#include "SceneFromRenderer.h"

#include "vtkLimnProperty.h"
#include "vtkLimnCompositor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnRenderWindow.h"

#include "Rendering/Base/TranslucencyBound.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <utility>

namespace limn::bridge
{
namespace
{

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// All passes, by their renderers. Never deleted: renderers may outlive static objects.
class SurfacePasses
{
public:
  static SurfacePasses& instance()
  {
    static SurfacePasses* const passes = new SurfacePasses;
    return *passes;
  }

  SurfacePass& of(vtkRenderer* renderer)
  {
    std::unique_ptr<SurfacePass>& pass = passes_[renderer];
    if (!pass)
    {
      pass = std::make_unique<SurfacePass>(renderer);
      pass->beginFrame();
      renderer->AddObserver(vtkCommand::StartEvent, this, &SurfacePasses::begin);
      renderer->AddObserver(vtkCommand::EndEvent, this, &SurfacePasses::end);
      renderer->AddObserver(vtkCommand::DeleteEvent, this, &SurfacePasses::forget);
    }
    return *pass;
  }
  SurfacePass* find(vtkRenderer* renderer)
  {
    const auto found = passes_.find(renderer);
    return found == passes_.end() ? nullptr : found->second.get();
  }

private:
  // Actors of other classes than ours do not say when the opaque ones are drawn.
  void end(vtkObject* renderer, unsigned long, void*) { passes_.at(renderer)->blendWaitingLines(); }
  void begin(vtkObject* renderer, unsigned long, void*) { passes_.at(renderer)->beginFrame(); }
  void forget(vtkObject* renderer, unsigned long, void*) { passes_.erase(renderer); }

  std::unordered_map<vtkObject*, std::unique_ptr<SurfacePass>> passes_;
};

/// Those surfaces that have something to draw, and then the hulls, those last that others show
/// through.
struct Drawables
{
  std::vector<Instance> instances;
  std::vector<vtkActor*> actors; ///< of the instances
  FrameNormals normals;
  FrameTextures textures;
  FrameLines lines;
};

class Hulls
{
public:
  void add(const Instance& hull, vtkActor* actor)
  {
    (hull.isTranslucent() ? translucent_ : opaque_).push_back({ hull, actor });
  }
  void appendTo(Drawables& drawables) const
  {
    for (const std::vector<Hull>* hulls : { &opaque_, &translucent_ })
    {
      for (const Hull& hull : *hulls)
      {
        drawables.instances.push_back(hull.instance);
        drawables.actors.push_back(hull.actor);
      }
    }
  }

private:
  struct Hull
  {
    Instance instance;
    vtkActor* actor;
  };
  std::vector<Hull> opaque_;
  std::vector<Hull> translucent_;
};

/// Adds lines between surfaces, described already, to `drawables`.
void describeSceneLines(const std::vector<const Surface*>& described, const LineView& view,
  SceneLines& sceneLines, Drawables& drawables)
{
  const Status status = sceneLines.add(described, drawables.instances, view, drawables.lines);
  if (!status.ok())
  {
    vtkErrorWithObjectMacro(
      described[0]->actor, "Shadows and intersections have no lines: " << status.message);
  }
}

/// Points and millimetres become pixels of the window.
void setHatchSpacing(const Surface& surface, const LineView& view, Instance& instance)
{
  if (vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(surface.actor->GetProperty()))
  {
    instance.style.hatching.spacing = static_cast<float>(hatchSpacingOf(limn, view.pixelsPerInch));
  }
}

void describeCues(const Surface& surface, const LineView& view, Instance& instance)
{
  const Status status =
    cuesOf(surface.actor->GetProperty(), view.pixelsPerInch, instance.style.cues);
  if (!status.ok())
  {
    vtkErrorWithObjectMacro(surface.actor, "Drawn without a halo: " << status.message);
  }
}

/// Says of outlines that are left out why they are, once for all actors with one cause.
void complainOfOutline(const Surface& surface, Causes& said)
{
  const Status status = checkOutlineWidth(surface.actor->GetProperty());
  if (!status.ok() && said.insert(status.message).second)
  {
    vtkWarningWithObjectMacro(surface.actor, "Drawn without an outline: " << status.message);
  }
}

Drawables describeAll(const std::vector<Surface>& surfaces, const LineView& view,
  SceneLines& sceneLines, Causes& said, Complaints& complaints)
{
  Drawables drawables;
  Hulls hulls;
  std::vector<const Surface*> described;
  const bool hasSceneLines = std::any_of(surfaces.begin(), surfaces.end(),
    [](const Surface& surface) { return wantsSceneLines(surface.actor->GetProperty()); });
  drawables.instances.reserve(surfaces.size());
  drawables.actors.reserve(surfaces.size());
  for (const Surface& surface : surfaces)
  {
    // In place: half a kilobyte each.
    if (describe(surface, drawables.instances.emplace_back(), drawables.normals,
          &drawables.textures, complaints, hasSceneLines))
    {
      described.push_back(&surface);
      setHatchSpacing(surface, view, drawables.instances.back());
      describeLines(surface, view, drawables.instances.back(), drawables.lines);
      describeCues(surface, view, drawables.instances.back());
      complainOfOutline(surface, said);
      drawables.actors.push_back(surface.actor);
      if (Instance hull; describeHull(surface, hull))
      {
        hulls.add(hull, surface.actor);
      }
    }
    else
    {
      drawables.instances.pop_back();
    }
  }
  if (hasSceneLines && !described.empty())
  {
    describeSceneLines(described, view, sceneLines, drawables);
  }
  for (std::size_t i = 0; i < described.size(); ++i)
  {
    complainOfFlatness(*described[i], drawables.instances[i].lines, complaints);
  }
  hulls.appendTo(drawables);
  return drawables;
}

std::vector<LightRays> raysOf(const std::vector<Light>& lights, const Camera& camera)
{
  std::vector<LightRays> rays;
  for (const bool isHeadlight : { false, true })
  {
    for (const Light& light : lights)
    {
      if ((light.kind == LightKind::kHeadlight) == isHeadlight)
      {
        rays.push_back(lightRays(light, camera));
      }
    }
  }
  return rays;
}

/// As VTK's shaders without a light. The chapter's models keep to their equations.
void drawUnlit(std::vector<Instance>& instances)
{
  for (Instance& instance : instances)
  {
    if (instance.style.reflection == Reflection::kAsVtk)
    {
      instance.style.reflection = Reflection::kNone;
    }
  }
}

} // namespace

SurfacePass& passOf(vtkRenderer* renderer)
{
  return SurfacePasses::instance().of(renderer);
}

SurfacePass* findPassOf(vtkRenderer* renderer)
{
  return SurfacePasses::instance().find(renderer);
}

SurfacePass::SurfacePass(vtkRenderer* renderer) : renderer_(renderer) {}

void SurfacePass::beginFrame()
{
  EngineState::instance().beginRenderer(renderer_);
  isInPass_ = false;
  isExpecting_ = false;
  expected_ = {};
  due_.clear();
  waitingLines_.pixels.clear();
}

void SurfacePass::expect(CollectedSurfaces surfaces)
{
  expected_ = std::move(surfaces);
  isExpecting_ = true;
}

SurfacePass::View SurfacePass::currentView() const
{
  View view{};
  view.camera = cameraOf(renderer_);
  renderer_->GetTiledSizeAndOrigin(&view.place[0], &view.place[1], &view.place[2], &view.place[3]);
  return view;
}

bool SurfacePass::isSameView()
{
  // The clock runs when any object is modified; between most actors nothing is.
  vtkTimeStamp clock;
  clock.Modified();
  const vtkMTimeType before = std::exchange(timeOfView_, clock.GetMTime());
  if (before + 1 == timeOfView_)
  {
    return true;
  }
  const View now = this->currentView();
  const bool isSame =
    std::memcmp(&now.camera.worldToView, &view_.camera.worldToView, sizeof(Mat4d)) == 0 &&
    std::memcmp(&now.camera.viewToClip, &view_.camera.viewToClip, sizeof(Mat4d)) == 0 &&
    std::equal(std::begin(now.place), std::end(now.place), std::begin(view_.place));
  // Composing the camera's matrices has set the clock going.
  clock.Modified();
  timeOfView_ = isSame ? clock.GetMTime() : 0;
  return isSame;
}

const Surface* SurfacePass::crossOff(vtkActor* actor)
{
  const auto entry = due_.find(actor);
  if (entry == due_.end() || entry->second.times == 0)
  {
    return nullptr;
  }
  --entry->second.times;
  return entry->second.surface;
}

void SurfacePass::startPass(bool isTranslucent)
{
  CollectedSurfaces collected =
    isExpecting_ ? expected_ : surfacesOf(renderer_, Assemblies::kLeaveOut);
  surfaces_ = std::move(collected.surfaces);
  awaited_.clear();
  isAwaiting_ = !(isExpecting_ && collected.areAll);
  if (isAwaiting_)
  {
    const auto first = std::stable_partition(surfaces_.begin(), surfaces_.end(),
      [](const Surface& surface) { return !surface.isTranslucent; });
    awaited_.assign(std::make_move_iterator(first), std::make_move_iterator(surfaces_.end()));
    surfaces_.erase(first, surfaces_.end());
  }
  due_.clear();
  view_ = this->currentView();
  timeOfView_ = 0;
  isInPass_ = true;
  // Where the translucent pass comes first there is nothing for the opaque one.
  if (!isAwaiting_ || !isTranslucent)
  {
    this->drawDue(surfaces_);
  }
  if (isTranslucent)
  {
    this->drawAwaited();
  }
}

void SurfacePass::drawAwaited()
{
  if (isAwaiting_)
  {
    isAwaiting_ = false;
    this->drawDue(awaited_);
  }
}

void SurfacePass::drawDue(const std::vector<Surface>& surfaces)
{
  for (const Surface& surface : surfaces)
  {
    Due& due = due_[surface.actor];
    due.surface = &surface;
    ++due.times;
  }
  this->drawTogether(surfaces);
}

const Surface* SurfacePass::crossOff(vtkActor* actor, vtkMapper* mapper)
{
  const bool isContinued = actor->GetMapper() == mapper && isInPass_ && this->isSameView();
  return isContinued ? this->crossOff(actor) : nullptr;
}

void SurfacePass::draw(const Surface& surface)
{
  const bool isOfActor = surface.actor->GetMapper() == surface.mapper;
  const bool isContinued = isInPass_ && this->isSameView();
  if (isOfActor && isContinued && surface.isTranslucent)
  {
    this->drawAwaited();
    // OpenGL's renderers peel layer after layer off, and let all of them come each time.
    if (!window() && due_.count(surface.actor) > 0)
    {
      this->crossOff(surface.actor);
      return;
    }
  }
  if (isOfActor && (!isContinued || due_.count(surface.actor) > 0))
  {
    if (isContinued && this->crossOff(surface.actor))
    {
      return;
    }
    this->startPass(surface.isTranslucent);
    if (this->crossOff(surface.actor))
    {
      return;
    }
  }
  this->drawTogether({ surface });
}

void SurfacePass::drawTogether(const std::vector<Surface>& surfaces)
{
  const Clock::time_point start = Clock::now();
  LineView view;
  view.camera = cameraOf(renderer_);
  const std::vector<Light> lights = lightsOf(renderer_);
  view.lights = lights;
  view.ambientLight = ambientLightOf(renderer_);
  int place[4];
  renderer_->GetTiledSizeAndOrigin(&place[0], &place[1], &place[2], &place[3]);
  view.width = std::max(place[0], 1);
  view.height = std::max(place[1], 1);
  view.pixelsPerInch = renderer_->GetRenderWindow()->GetDPI();
  view.threads = EngineState::instance().options.threads;
  view.rays = raysOf(lights, view.camera);
  Complaints complaints;
  Drawables drawables = describeAll(surfaces, view, sceneLines_, said_, complaints);
  if (drawables.instances.empty())
  {
    return;
  }
  if (isUnlit(renderer_))
  {
    drawUnlit(drawables.instances);
  }
  for (std::size_t i = 0; i < drawables.actors.size(); ++i)
  {
    if (!drawables.instances[i].hull)
    {
      opaqueOnly_.look(drawables.actors[i], drawables.instances[i], complaints);
    }
  }
  if (vtkLimnRenderWindow* const target = this->window(); target && target->GetMaps())
  {
    for (std::size_t i = 0; i < drawables.actors.size(); ++i)
    {
      drawables.instances[i].id = target->GetFrame().NumberOf(drawables.actors[i]);
    }
  }
  Scene scene;
  scene.camera = view.camera;
  scene.ambientLight = view.ambientLight;
  scene.lights = lights;
  scene.instances = drawables.instances;
  const double milliseconds = millisecondsSince(start);

  if (this->renderInto(scene, milliseconds).ok())
  {
    return;
  }
  // One of them is at fault; the others should be seen.
  for (std::size_t i = 0; i < drawables.actors.size(); ++i)
  {
    scene.instances = { &drawables.instances[i], 1 };
    if (const Status status = this->renderInto(scene, 0); !status.ok())
    {
      vtkErrorWithObjectMacro(drawables.actors[i], "Not drawn: " << status.message);
    }
  }
}

Status SurfacePass::renderInto(const Scene& scene, double prepareMilliseconds)
{
  if (vtkLimnRenderWindow* const window = this->window())
  {
    return this->renderInto(window, scene, prepareMilliseconds);
  }
  // Of one kind, as translucent surfaces wait for their pass; but hulls of opaque ones may be
  // translucent, and are the last then.
  const Instance* const end = scene.instances.end();
  const Instance* const split =
    scene.instances[0].isTranslucent()
      ? scene.instances.begin()
      : std::find_if(scene.instances.begin(), end,
          [](const Instance& instance) { return instance.isTranslucent(); });
  Scene part = scene;
  if (split != scene.instances.begin())
  {
    part.instances = { scene.instances.data(),
      static_cast<std::size_t>(split - scene.instances.begin()) };
    if (Status status = this->renderLayer(part, prepareMilliseconds); !status.ok() || split == end)
    {
      return status;
    }
  }
  part.instances = { split, static_cast<std::size_t>(end - split) };
  return this->renderTranslucentLayer(part, prepareMilliseconds);
}

vtkLimnRenderWindow* SurfacePass::window() const
{
  return vtkLimnRenderWindow::SafeDownCast(renderer_->GetRenderWindow());
}

Status SurfacePass::renderInto(
  vtkLimnRenderWindow* window, const Scene& scene, double prepareMilliseconds)
{
  const auto viewport = viewportOf(renderer_, window->GetFrame());
  if (viewport.IsEmpty())
  {
    return {};
  }
  Scene sampled = scene;
  sampled.samples = interactiveSamples(scene, renderer_, window->GetSamplesPerPixel());
  EngineState& engine = EngineState::instance();
  RenderStats stats;
  FrameView view = window->GetFrame().View(viewport);
  view.radiance = effects_.radiance();
  Status status = render(sampled, view, engine.options, &stats);
  if (!status.ok() && view.clear.extent != FrameClear::Extent::kNothing)
  {
    window->GetFrame().ClearLater(viewport, view.clear.color);
  }
  engine.add(stats, prepareMilliseconds);
  this->warnOfTruncation(stats.truncatedPixels);
  return status;
}

void SurfacePass::warnOfTruncation(std::size_t pixels)
{
  if (pixels == 0 || hasWarnedOfTruncation_)
  {
    return;
  }
  hasWarnedOfTruncation_ = true;
  vtkWarningWithObjectMacro(renderer_,
    "In " << pixels << " pixels too many translucent surfaces lie over each other: a row of "
          << kTranslucentRowPixels << " pixels keeps " << kMaxTranslucentSamples
          << " samples of them. The farthest are left out. Draw with fewer samples per pixel, or "
             "fewer surfaces.");
}

FrameView SurfacePass::layer(int width, int height)
{
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  layerColor_.resize(pixels);
  layerDepth_.resize(pixels);
  layerCoverage_.resize(pixels);
  FrameView frame;
  frame.width = width;
  frame.height = height;
  frame.rowStride = width;
  frame.color = layerColor_.data();
  frame.depth = layerDepth_.data();
  frame.coverage = layerCoverage_.data();
  frame.background = Background::kKeepApart;
  frame.linePixels = &linePixels_;
  frame.clear.extent = FrameClear::Extent::kTouched;
  return frame;
}

Status SurfacePass::renderLayer(const Scene& scene, double prepareMilliseconds)
{
  int size[2];
  renderer_->GetTiledSize(&size[0], &size[1]);
  if (!compositor() || size[0] <= 0 || size[1] <= 0)
  {
    return {};
  }
  Scene sampled = scene;
  sampled.samples = interactiveSamples(scene, renderer_, compositor()->GetSamples(renderer_));
  vtkLimnCompositor::Layer layer;
  const Status status =
    this->renderInto(this->layer(size[0], size[1]), sampled, prepareMilliseconds, layer);
  if (status.ok() && layer.Touched[0] < layer.Touched[2] && layer.Touched[1] < layer.Touched[3])
  {
    if (compositor()->Composite(renderer_, layer))
      this->keepLines(layer);
  }
  return status;
}

void SurfacePass::keepLines(const vtkLimnCompositor::Layer& layer)
{
  WaitingLines& waiting = waitingLines_;
  if (waiting.width != layer.Width || waiting.height != layer.Height ||
      waiting.samples != layer.Samples)
  {
    this->blendWaitingLines();
    waiting.width = layer.Width;
    waiting.height = layer.Height;
    waiting.samples = layer.Samples;
  }
  for (const LinePixel& one : linePixels_)
  {
    waiting.pixels.push_back({ one.x, one.y, { one.color.r, one.color.g, one.color.b, one.color.a },
      one.depth, one.samples });
  }
}

void SurfacePass::blendWaitingLines()
{
  this->blendWaitingLines(true);
}

void SurfacePass::blendWaitingLines(bool writesDepth)
{
  WaitingLines& waiting = waitingLines_;
  if (!waiting.pixels.empty())
  {
    compositor()->BlendLines(
      renderer_, { waiting.width, waiting.height, waiting.samples, waiting.pixels.data(),
                   waiting.pixels.size(), writesDepth });
    waiting.pixels.clear();
  }
}

Status SurfacePass::renderTranslucentLayer(const Scene& scene, double prepareMilliseconds)
{
  int size[2];
  renderer_->GetTiledSize(&size[0], &size[1]);
  if (!compositor() || size[0] <= 0 || size[1] <= 0)
  {
    return {};
  }
  this->blendWaitingLines();
  FrameView frame = this->layer(size[0], size[1]);
  if (!compositor()->ReadDepth(renderer_, size[0], size[1], frame.depth))
  {
    return {};
  }
  // The depths have to stay, so the others are cleared here.
  frame.clear = {};
  std::fill(layerColor_.begin(), layerColor_.end(), Rgba8{ 0, 0, 0, 0 });
  std::fill(layerCoverage_.begin(), layerCoverage_.end(), std::uint8_t{ 0 });
  Scene sampled = scene;
  sampled.samples =
    interactiveSamples(scene, renderer_, compositor()->GetSamplesForBlend(renderer_));
  vtkLimnCompositor::Layer layer;
  const Status status = this->renderInto(frame, sampled, prepareMilliseconds, layer);
  if (status.ok() && layer.Touched[0] < layer.Touched[2] && layer.Touched[1] < layer.Touched[3])
  {
    if (compositor()->Blend(renderer_, layer))
      this->keepLines(layer);
    // Translucent surfaces write no depth, and their lines do not either.
    this->blendWaitingLines(false);
  }
  return status;
}

Status SurfacePass::renderInto(const FrameView& frame, const Scene& scene,
  double prepareMilliseconds, vtkLimnCompositor::Layer& layer)
{
  EngineState& engine = EngineState::instance();
  RenderStats stats;
  Status status = render(scene, frame, engine.options, &stats);
  engine.add(stats, prepareMilliseconds);
  this->warnOfTruncation(stats.truncatedPixels);
  const PixelRectangle& touched = stats.touched;
  layer = { frame.width, frame.height, { touched.x0, touched.y0, touched.x1, touched.y1 },
    scene.samples, &frame.color->r, frame.depth, frame.coverage };
  return status;
}

} // namespace limn::bridge
