// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BackendMapper_h
#define BackendMapper_h

class vtkActor;
class vtkLimnCompositor;
class vtkMapper;
class vtkRenderer;
class vtkWindow;

namespace limn::bridge
{

/// What carries our pictures into windows of other backends; nullptr if it cannot be had (said
/// once).
vtkLimnCompositor* compositor();

/// Frees what the compositor keeps for `window`, if there is one.
void releaseBackend(vtkWindow* window);

/// Renders an actor's mapper, ours or another, in ours or another window.
void renderMapper(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

} // namespace limn::bridge

#endif
