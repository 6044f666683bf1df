// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws one triangle with the installed core: exit status 0 if the middle pixel shows it.
#include <Rendering/Mesh/BuildClusters.h>
#include <Rendering/Renderer.h>

#include <vector>

int main()
{
  const std::vector<limn::Vec3f> corners = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const std::vector<limn::Triangle> triangles = {{{0, 1, 2}}};
  limn::ClusteredMesh clusters;
  if (!limn::buildClusters({corners, {}, triangles}, 0, clusters).ok()) return 1;

  limn::Instance instance;
  instance.clusters = &clusters;
  instance.style.normals = limn::NormalSource::kTriangle;
  instance.style.reflection = limn::Reflection::kNone;
  instance.material.diffuseColor = {1, 0, 0};
  instance.material.ambientColor = {0, 0, 0};
  limn::Scene scene;
  scene.camera = {limn::Mat4d::identity(), limn::Mat4d::identity(), true};
  scene.instances = {&instance, 1};

  std::vector<limn::Rgba8> color(64 * 64, limn::Rgba8{0, 0, 0, 0});
  std::vector<float> depth(64 * 64, 1.0f);
  if (!limn::render(scene, {64, 64, 64, color.data(), depth.data()}).ok()) return 2;
  const limn::Rgba8 middle = color[32 * 64 + 32], edge = color[63 * 64];
  return middle.r == 255 && middle.g == 0 && edge.a == 0 ? 0 : 3;
}
