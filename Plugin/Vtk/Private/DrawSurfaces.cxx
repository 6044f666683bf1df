// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawSurfaces.h"

#include "BackendMapper.h"
#include "MapperInternals.h"
#include "SurfacePass.h"
#include "WhatIsMissing.h"

#include "vtkLimnCompositor.h"
#include "vtkLimnHardwareSelector.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace limn::bridge
{
namespace
{

void updateInput(vtkLimnPolyDataMapper* mapper)
{
  mapper->InvokeEvent(vtkCommand::StartEvent);
  if (!mapper->GetStatic() && !mapper->GetInternals().Input.get(mapper))
  {
    mapper->GetInputAlgorithm()->Update();
  }
  mapper->InvokeEvent(vtkCommand::EndEvent);
}

/// Once for all actors of a renderer: the axes of one cube are a dozen.
void warnOfMissing(vtkRenderer* renderer, vtkActor* actor, const std::vector<Missing>& all)
{
  vtkLimnRenderer* const ours = vtkLimnRenderer::SafeDownCast(renderer);
  if (!ours)
  {
    return;
  }
  for (const Missing& missing : all)
  {
    ours->WarnOnce(std::string("A ") + actor->GetClassName() + " asks for " + missing.feature +
                   ", which Limn cannot draw yet. " +
                   (missing.surfaceIsDrawn ? "It is drawn without." : "It is not drawn.") +
                   " Use an OpenGL window (LIMN_WINDOW=gl) for it.");
  }
}

/// Passes work on the shaders of OpenGL's mapper, into targets of their own; light from images is
/// of these shaders.
bool needsShaders(vtkRenderer* renderer)
{
  return renderer->GetPass() || renderer->GetUseSSAO() || renderer->GetUseShadows() ||
         renderer->GetUseImageBasedLighting();
}

void drawInLimnWindow(vtkRenderer* renderer, const Surface& surface, vtkPolyData* input)
{
  const std::vector<Missing> missing = whatIsMissing(surface.actor, surface.mapper, input);
  const bool isDrawn = std::all_of(
    missing.begin(), missing.end(), [](const Missing& one) { return one.surfaceIsDrawn; });
  if (!renderer->GetSelector())
  {
    warnOfMissing(renderer, surface.actor, missing);
    if (isDrawn)
    {
      passOf(renderer).draw(surface);
    }
    return;
  }
  auto* const selector = vtkLimnHardwareSelector::SafeDownCast(renderer->GetSelector());
  if (selector && isDrawn)
  {
    selector->AddSurface(surface.actor, surface.mapper);
  }
}

} // namespace

void collectSurfaces(vtkRenderer* renderer)
{
  passOf(renderer).expect(surfacesOf(renderer, Assemblies::kTraverse));
}

bool isDrawnAlready(vtkRenderer* renderer, vtkActor* actor, vtkLimnPolyDataMapper* mapper)
{
  if (renderer->GetSelector())
  {
    return false;
  }
  const Surface* const surface = passOf(renderer).crossOff(actor, mapper);
  if (surface)
  {
    warnOfMissing(renderer, actor, surface->missing);
  }
  return surface != nullptr;
}

void drawSurface(vtkRenderer* renderer, vtkActor* actor, vtkLimnPolyDataMapper* mapper)
{
  updateInput(mapper);
  vtkPolyData* const input = inputOf(mapper);
  if (!input->GetPoints())
  {
    return;
  }
  const Surface surface = surfaceOf(actor, mapper, !actor->HasOpaqueGeometry());
  if (vtkLimnRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    drawInLimnWindow(renderer, surface, input);
  }
  else if (renderer->GetSelector() || needsShaders(renderer) ||
           !whatIsMissing(actor, mapper, input).empty())
  {
    if (compositor())
    {
      compositor()->RenderWithBackend(renderer, actor, mapper);
    }
  }
  else
  {
    passOf(renderer).draw(surface);
  }
}

void blendWaitingLines(vtkRenderer* renderer)
{
  if (SurfacePass* const pass = findPassOf(renderer))
  {
    pass->blendWaitingLines();
  }
}

void beginEffects(vtkLimnRenderer* renderer)
{
  passOf(renderer).effects().begin(renderer);
}

void applyEffects(vtkLimnRenderer* renderer)
{
  passOf(renderer).effects().apply(renderer);
}

} // namespace limn::bridge
