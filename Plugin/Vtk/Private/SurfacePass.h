// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacePass_h
#define SurfacePass_h

#include "OpaqueOnly.h"
#include "SceneLines.h"
#include "Surface.h"
#include "ViewportEffects.h"

#include "vtkLimnCompositor.h"

#include "Rendering/Base/Array.h"
#include "Rendering/FrameView.h"
#include "Rendering/Renderer.h"

#include "vtkType.h"

#include <set>
#include <string>
#include <unordered_map>
#include <vector>

class vtkLimnRenderWindow;
class vtkObject;
class vtkMapper;
class vtkRenderer;

namespace limn::bridge
{

/// What a renderer has warned of, in words that name no actor: a hundred actors with one property
/// get one warning.
using Causes = std::set<std::string>;

/// The drawing of one renderer's surfaces, from frame to frame.
///
/// VTK lets one actor after the other render. The first one of ours to come draws them all; who
/// comes later in the same pass is crossed off. An actor that comes once more than it was drawn
/// starts another pass, and so does a changed camera or viewport (shadow maps, tiles, stereo).
///
/// Translucent surfaces are drawn together with the opaque ones, sample by sample, if no others can
/// come between. Else, and in windows of other backends, they wait for VTK's translucent pass,
/// where the first draws them all over the one colour and depth a pixel that is there by then.
class SurfacePass
{
public:
  explicit SurfacePass(vtkRenderer* renderer);

  void beginFrame();
  /// The surfaces that will come, if they are known before the first does.
  void expect(CollectedSurfaces surfaces);
  void draw(const Surface& surface);
  /// Of windows of other backends: what lines lay over samples that show no surface has to wait
  /// until all that is opaque is drawn, whoever draws it. Does nothing if nothing waits.
  void blendWaitingLines();
  /// For renderers of Limn's own window.
  ViewportEffects& effects() { return effects_; }

  /// The actor's surface if this pass has drawn it together with others, so that draw() would have
  /// nothing to do; else nullptr. Returns it once for each time that the actor was collected.
  const Surface* crossOff(vtkActor* actor, vtkMapper* mapper);

private:
  const Surface* crossOff(vtkActor* actor);
  bool isSameView();
  void startPass(bool isTranslucent);
  void drawAwaited();
  void drawDue(const std::vector<Surface>& surfaces);
  void drawTogether(const std::vector<Surface>& surfaces);
  Status renderInto(const Scene& scene, double prepareMilliseconds);
  Status renderInto(vtkLimnRenderWindow* window, const Scene& scene, double prepareMilliseconds);
  Status renderLayer(const Scene& scene, double prepareMilliseconds);
  Status renderTranslucentLayer(const Scene& scene, double prepareMilliseconds);
  Status renderInto(const FrameView& frame, const Scene& scene, double prepareMilliseconds,
    vtkLimnCompositor::Layer& layer);
  vtkLimnRenderWindow* window() const;
  void warnOfTruncation(std::size_t pixels);
  FrameView layer(int width, int height);
  void keepLines(const vtkLimnCompositor::Layer& layer);
  void blendWaitingLines(bool writesDepth);

  struct View
  {
    Camera camera;
    int place[4];
  };
  View currentView() const;

  vtkRenderer* renderer_;
  bool isExpecting_ = false;
  CollectedSurfaces expected_;
  bool isInPass_ = false;
  View view_ = {};
  vtkMTimeType timeOfView_ = 0;   ///< VTK's clock when the view was last seen to be the same
  std::vector<Surface> surfaces_; ///< of the pass
  std::vector<Surface> awaited_;  ///< likewise, the translucent ones if they have to wait
  bool isAwaiting_ = false;
  /// By actors drawn already: their surfaces, and how often they are still to come.
  struct Due
  {
    const Surface* surface;
    int times;
  };
  std::unordered_map<vtkActor*, Due> due_;

  SceneLines sceneLines_;
  ViewportEffects effects_;
  bool hasWarnedOfTruncation_ = false;
  OpaqueOnly opaqueOnly_;
  Causes said_; ///< of what was left out

  /// The layer for windows of other backends.
  Array<Rgba8> layerColor_;
  Array<float> layerDepth_;
  Array<std::uint8_t> layerCoverage_;
  std::vector<LinePixel> linePixels_;
  /// Lines of layers of one size and number of samples.
  struct WaitingLines
  {
    int width, height, samples;
    std::vector<vtkLimnCompositor::LinePixel> pixels;
  };
  WaitingLines waitingLines_ = {};
};

/// The pass of a renderer; it goes with the renderer.
SurfacePass& passOf(vtkRenderer* renderer);
/// Likewise, or nullptr if the renderer has none.
SurfacePass* findPassOf(vtkRenderer* renderer);

} // namespace limn::bridge

#endif
