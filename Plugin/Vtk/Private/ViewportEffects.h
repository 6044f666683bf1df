// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ViewportEffects_h
#define ViewportEffects_h

#include "Rendering/FrameView.h"
#include "Rendering/Post/EffectPlanes.h"
#include "Rendering/PostEffects.h"

class vtkLimnRenderer;

namespace limn::bridge
{

/// The post effects of one renderer of Limn's own window, from frame to frame.
class ViewportEffects
{
public:
  /// After the viewport is cleared and before its surfaces are drawn.
  void begin(vtkLimnRenderer* renderer);
  /// Of the viewport, for FrameView; empty where no effect asks for it.
  const RadianceView& radiance() const { return radiance_; }
  /// After the surfaces are drawn.
  void apply(vtkLimnRenderer* renderer);

private:
  PostEffects effects_;
  EffectPlanes planes_;
  RadianceView radiance_;
};

} // namespace limn::bridge

#endif
