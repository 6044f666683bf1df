// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoreScene_h
#define CoreScene_h

#include "Rendering/Scene.h"
#include "SurfaceMesh.h"

#include <memory>
#include <vector>

class vtkRenderer;

/// What a renderer shows as the core takes it, made by the code of the plugin.
class CoreScene
{
public:
  /// Builds clusters of all actors' meshes.
  CoreScene(vtkRenderer* renderer, int samples);

  /// As the camera sees it now; valid until the next call.
  limn::Scene Look();

private:
  vtkRenderer* Renderer;
  int Samples;
  limn::bridge::MovedPoints Unmoved;
  std::vector<std::unique_ptr<limn::bridge::SurfaceMesh>> Meshes;
  std::vector<limn::Instance> Instances;
  std::vector<limn::Light> Lights;
};

#endif
