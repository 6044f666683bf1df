// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef EngineState_h
#define EngineState_h

#include "Rendering/Renderer.h"

#include "vtkWeakPointer.h"

#include <set>

class vtkRenderWindow;
class vtkRenderer;

namespace limn::bridge
{

/// Sums over the renderers of one window's frame.
struct FrameFigures
{
  RenderStats stats;
  double prepareMilliseconds = 0;
};

/// The program's settings, and what the last frame did.
class EngineState
{
public:
  /// Made, with the environment's values, at the first call.
  static EngineState& instance();

  /// To be called when a renderer starts; another window, or the second start of one renderer,
  /// begins a new frame.
  void beginRenderer(vtkRenderer* renderer);
  void add(const RenderStats& stats, double prepareMilliseconds);
  const FrameFigures& figures() const { return this->figures_; }

  RenderOptions options;

private:
  EngineState();

  FrameFigures figures_;
  vtkWeakPointer<vtkRenderWindow> window_;
  std::set<const vtkRenderer*> renderers_;
};

} // namespace limn::bridge

#endif
