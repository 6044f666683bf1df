// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ApplyEffects_h
#define limn_viewer_ApplyEffects_h

#include "RenderSettings.h" // for EffectSettings

class vtkRenderer;

namespace limn::viewer
{

/// Asks the renderer, which has its camera, for the effects.
void applyEffects(const EffectSettings& settings, vtkRenderer& renderer);

} // namespace limn::viewer

#endif
