// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawSurfaces_h
#define DrawSurfaces_h

class vtkActor;
class vtkLimnRenderer;
class vtkLimnPolyDataMapper;
class vtkRenderer;

namespace limn::bridge
{

/// For renderers of ours, before their props render: notes all surfaces that will come, those
/// inside of assemblies too, so that the first drawSurface() draws them together.
void collectSurfaces(vtkRenderer* renderer);

/// Draws what `mapper` shows of its input as `actor`. The first call of a pass draws the surfaces
/// of all actors of the renderer that can be drawn, at once; later calls for these return at once.
/// What Limn cannot draw goes to the window's own backend, or is named in a warning if there is
/// none.
/// Whether nothing is left to do for the actor: its surface has been drawn together with others.
/// Says so once for each time that it was collected.
bool isDrawnAlready(vtkRenderer* renderer, vtkActor* actor, vtkLimnPolyDataMapper* mapper);

void drawSurface(vtkRenderer* renderer, vtkActor* actor, vtkLimnPolyDataMapper* mapper);

/// In windows of other backends: blends what lines lay over pixels that show no surface of ours, as
/// soon as all is drawn that may lie behind them.
void blendWaitingLines(vtkRenderer* renderer);

/// For renderers of ours: what their post effects need before their surfaces are drawn, and the
/// effects after that.
void beginEffects(vtkLimnRenderer* renderer);
void applyEffects(vtkLimnRenderer* renderer);

} // namespace limn::bridge

#endif
