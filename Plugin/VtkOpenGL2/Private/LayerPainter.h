// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LayerPainter_h
#define LayerPainter_h

#include "vtkLimnCompositor.h"

#include "vtkNew.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkTextureObject.h"

#include <memory>

class vtkOpenGLRenderWindow;

/// Draws layers into one window: its textures and shaders live in that window's context.
class LayerPainter
{
public:
  explicit LayerPainter(vtkOpenGLRenderWindow* window);

  /// Draws into the current viewport, only where `layer` is touched. Requires: the window's context
  /// is current, the layer is valid and as large as the viewport. False if a texture is refused.
  bool Paint(const vtkLimnCompositor::Layer& layer);

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

  bool Reserve(const vtkLimnCompositor::Layer& layer);
  void Upload(const vtkLimnCompositor::Layer& layer);
  vtkOpenGLQuadHelper& ReadyQuad(bool masked);
  void Draw(const vtkLimnCompositor::Layer& layer);

  vtkOpenGLRenderWindow* Window;
  Plane Color;
  Plane Depth;
  Plane Coverage;
  std::unique_ptr<vtkOpenGLQuadHelper> MaskedQuad;
  std::unique_ptr<vtkOpenGLQuadHelper> BlendedQuad;
};

#endif
