// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkLimnCompositor.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

#include <functional>
#include <vector>

/// A layer that owns its planes.
struct OwnedLayer
{
  OwnedLayer(int width, int height, int samples)
    : Color(4 * size_t(width) * height), Depth(size_t(width) * height, 1.0f),
      Coverage(size_t(width) * height)
  {
    this->View.Width = width;
    this->View.Height = height;
    this->View.Samples = samples;
    this->Touch(0, 0, width, height);
  }

  void Touch(int x0, int y0, int x1, int y1)
  {
    const int touched[4] = { x0, y0, x1, y1 };
    std::copy(touched, touched + 4, this->View.Touched);
  }

  void Set(int x, int y, const unsigned char rgb[3], float depth, unsigned char coverage)
  {
    const size_t pixel = size_t(y) * this->View.Width + x;
    std::copy(rgb, rgb + 3, &this->Color[4 * pixel]);
    this->Color[4 * pixel + 3] = coverage == 0 ? 0 : 255;
    this->Depth[pixel] = depth;
    this->Coverage[pixel] = coverage;
  }

  const vtkLimnCompositor::Layer& Get()
  {
    this->View.Color = this->Color.data();
    this->View.Depth = this->Depth.data();
    this->View.Coverage = this->Coverage.data();
    return this->View;
  }

  std::vector<unsigned char> Color;
  std::vector<float> Depth;
  std::vector<unsigned char> Coverage;
  vtkLimnCompositor::Layer View = {};
};

/// Composites a layer when its renderer draws opaque props, or blends it.
class LayerProp : public vtkProp
{
public:
  static LayerProp* New();
  vtkTypeMacro(LayerProp, vtkProp);

  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    vtkRenderer* renderer = static_cast<vtkRenderer*>(viewport);
    if (this->IsBlended)
    {
      this->Samples = this->Compositor->GetSamplesForBlend(renderer);
      this->Drawn = this->Layer && this->Compositor->Blend(renderer, this->Layer->Get());
      return 1;
    }
    this->Samples = this->Compositor->GetSamples(renderer);
    this->Drawn = this->Layer && this->Compositor->Composite(renderer, this->Layer->Get());
    if (this->Drawn && !this->Lines.empty())
    {
      const vtkLimnCompositor::Layer& layer = this->Layer->Get();
      this->Drawn = this->Compositor->BlendLines(
        renderer, { layer.Width, layer.Height, layer.Samples, this->Lines.data(),
                    this->Lines.size(), this->WritesDepth });
    }
    return 1;
  }

  OwnedLayer* Layer = nullptr;
  bool IsBlended = false;
  std::vector<vtkLimnCompositor::LinePixel> Lines; ///< blended after Composite
  bool WritesDepth = true;
  vtkSmartPointer<vtkLimnCompositor> Compositor;
  int Samples = 0;    ///< what GetSamples said in the last frame
  bool Drawn = false; ///< what Composite said in the last frame

protected:
  LayerProp() : Compositor(vtkSmartPointer<vtkLimnCompositor>::Take(vtkLimnCompositor::New())) {}
};
vtkStandardNewMacro(LayerProp);
