// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreScene.h"

#include "SceneFromRenderer.h"
#include "StyleFromProperty.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <stdexcept>

using namespace limn::bridge;

CoreScene::CoreScene(vtkRenderer* renderer, int samples) : Renderer(renderer), Samples(samples)
{
  constexpr int kAllThreads = 0;
  vtkActorCollection* const actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* const actor = actors->GetNextActor())
  {
    auto mesh = std::make_unique<SurfaceMesh>();
    const limn::Status status =
      mesh->update(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()), this->Unmoved,
        needsOf(actor->GetProperty()), kAllThreads);
    if (!status.ok())
    {
      throw std::runtime_error(status.message);
    }
    limn::Instance instance;
    actor->ComputeMatrix();
    instance.modelToWorld = toMat4(actor->GetMatrix());
    instance.material = materialOf(actor->GetProperty());
    instance.style = styleOf(actor->GetProperty(), *mesh);
    mesh->describe(instance);
    this->Instances.push_back(instance);
    this->Meshes.push_back(std::move(mesh));
  }
}

limn::Scene CoreScene::Look()
{
  this->Lights = lightsOf(this->Renderer);
  limn::Scene scene;
  scene.camera = cameraOf(this->Renderer);
  scene.lights = this->Lights;
  scene.instances = this->Instances;
  scene.samples = this->Samples;
  return scene;
}
