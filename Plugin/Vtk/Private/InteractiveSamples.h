// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef InteractiveSamples_h
#define InteractiveSamples_h

#include "Rendering/Scene.h"

class vtkRenderer;

namespace limn::bridge
{

/// How many samples per pixel to draw, of `wanted` at most: fewer while VTK's DesiredUpdateRate
/// asks for more than one frame a second, as it does while the user drags, and the frame would take
/// longer than the renderer's share of the time. The still frame after it has all of them. What a
/// frame takes is reckoned from its triangles, pixels and samples, not measured, so that
/// interactive frames too are the same on every machine.
int interactiveSamples(const Scene& scene, vtkRenderer* renderer, int wanted);

} // namespace limn::bridge

#endif
