// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LayerPainter_h
#define LayerPainter_h

#include "LinePainter.h"
#include "SampleMatch.h"

#include "vtkLimnCompositor.h"

#include "vtkNew.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkTextureObject.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;

/// Draws layers into one window: its textures and shaders live in that window's context.
class LayerPainter
{
public:
  explicit LayerPainter(vtkOpenGLRenderWindow* window);
  ~LayerPainter();

  /// Draws into the current viewport, only where `layer` is touched. Requires: the window's context
  /// is current, the layer is valid and as large as the viewport. False if a texture is refused.
  bool Paint(const vtkLimnCompositor::Layer& layer);
  /// Likewise over what is there, as vtkLimnCompositor::Blend().
  bool Blend(const vtkLimnCompositor::Layer& layer);
  /// Likewise, as vtkLimnCompositor::BlendLines().
  void BlendLines(const vtkLimnCompositor::LineLayer& lines);

private:
  /// One plane of a layer, in a texture that only grows.
  class Plane
  {
  public:
    Plane(vtkOpenGLRenderWindow* window, int components, int vtkType);
    bool IsAllocated() { return this->Texture->GetHandle() != 0; }
    bool Reserve(int width, int height);
    void Upload(const vtkLimnCompositor::Layer& layer, const void* pixels);

    vtkNew<vtkTextureObject> Texture;

  private:
    int Components;
    int VtkType;
  };

  /// How the layer's samples become those of the framebuffer.
  enum class Mix
  {
    None,  ///< one to one
    Masks, ///< by coverage, for each sample
    Share, ///< by coverage, blended
  };

  enum class Way
  {
    TestDepth, ///< opaque
    Blend      ///< multiplied by alpha, whatever the depth
  };

  bool Paint(const vtkLimnCompositor::Layer& layer, Way way);
  void ForgetLostContext();
  bool Reserve(const vtkLimnCompositor::Layer& layer);
  void Upload(const vtkLimnCompositor::Layer& layer, Mix mix);
  vtkOpenGLQuadHelper& ReadyQuad(Mix mix, Way way);
  void SetState(Mix mix, Way way);
  void Draw(const vtkLimnCompositor::Layer& layer, Mix mix, Way way,
    const std::vector<SamplePoint>& framebuffer);

  vtkOpenGLRenderWindow* Window;
  Plane Color;
  Plane Depth;
  Plane Coverage;
  std::map<std::pair<Mix, Way>, std::unique_ptr<vtkOpenGLQuadHelper>> Quads;
  LinePainter Lines;
};

#endif
