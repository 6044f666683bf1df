// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What programmable stages cost beside the built-in model: Lambert's law over a sphere of
// 1920 x 1080 pixels, and a million vertices.
// Usage: limn_shader_cost [FRAMES [built-in | shader | call | vertices]]
// Prints the median milliseconds of a frame for each, or for the one named; one at a time, and
// twice with different FRAMES, is what callgrind wants. Fails where the shaders' pictures are not
// the built-in model's.
#include "Stopwatch.h"

#include "Data/Generator/GeneratedMeshes.h"
#include "Rendering/Mesh/BuildClusters.h"
#include "Rendering/Mesh/MoveVertices.h"
#include "Rendering/Renderer.h"
#include "Rendering/SurfaceShader.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace limn;

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;

class Lambert final : public SurfaceShader
{
public:
  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
    FragmentVectors& colors) const override
  {
    FragmentVectors towards;
    float falls[FragmentVectors::kCapacity];
    for (int i = 0; i < fragments.count; ++i)
    {
      colors.set(i, fragments.ambient[i] * lighting.scene.ambientLight);
    }
    for (std::size_t l = 0; l < lighting.lights.size(); ++l)
    {
      lighting.arrive(l, fragments, towards, falls);
      for (int i = 0; i < fragments.count; ++i)
      {
        const float nl = dot(fragments.normal[i], towards[i]);
        const Vec3f arriving = lighting.lights[l].color * (falls[i] * (nl > 0 ? nl : 0));
        colors.set(i, colors[i] + arriving * fragments.diffuse[i]);
      }
    }
  }
};

class BuiltIn final : public SurfaceShader
{
public:
  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
    FragmentVectors& colors) const override
  {
    lighting.light(fragments, colors);
  }
};

/// Ripples along x, by a parabola's pieces.
class Ripple final : public VertexShader
{
public:
  void move(VertexBatch& vertices) const override
  {
    for (int i = 0; i < vertices.count; ++i)
    {
      const double phase = vertices.x[i] * 8 - static_cast<int>(vertices.x[i] * 8);
      vertices.y[i] += 0.2 * phase * (1 - phase * phase);
    }
  }
};

struct SphereScene
{
  GeneratedMesh Mesh = sphere(720, 360, 1);
  std::vector<Triangle> Triangles = Mesh.triangles();
  ClusteredMesh Clusters;
  Light Lamp;
  Instance Sphere;
  std::vector<Rgba8> Color = std::vector<Rgba8>(kWidth * kHeight);
  std::vector<float> Depth = std::vector<float>(kWidth * kHeight);

  SphereScene()
  {
    const MeshView mesh = { this->Mesh.positions, {}, this->Triangles };
    if (!buildClusters(mesh, 0, this->Clusters).ok())
    {
      std::exit(EXIT_FAILURE);
    }
    this->Lamp.kind = LightKind::kDirectional;
    this->Lamp.direction = { -1, -1, -2 };
    this->Sphere.clusters = &this->Clusters;
    this->Sphere.mesh = mesh;
    this->Sphere.attributes.vertexNormals = this->Mesh.normals;
    this->Sphere.style.reflection = Reflection::kLambert;
  }

  void Draw(const SurfaceShader* shader)
  {
    this->Sphere.style.surfaceShader = shader;
    Scene scene;
    scene.camera = { { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, -3 }, { 0, 0, 0, 1 } } },
      { { { 1.5, 0, 0, 0 }, { 0, 2.667, 0, 0 }, { 0, 0, -1.5, -2.5 }, { 0, 0, -1, 0 } } }, false };
    scene.lights = { &this->Lamp, 1 };
    scene.instances = { &this->Sphere, 1 };
    FrameView frame;
    frame.width = frame.rowStride = kWidth;
    frame.height = kHeight;
    frame.color = this->Color.data();
    frame.depth = this->Depth.data();
    frame.clear.extent = FrameClear::Extent::kAll;
    const Status status = render(scene, frame);
    if (!status.ok())
    {
      std::cerr << status.message << "\n";
      std::exit(EXIT_FAILURE);
    }
  }

  std::size_t Pixels() const
  {
    return static_cast<std::size_t>(
      std::count_if(this->Depth.begin(), this->Depth.end(), [](float depth) { return depth < 1; }));
  }
};

template <class Frame>
double medianOf(int frames, Frame frame)
{
  std::vector<double> times;
  for (int i = 0; i < frames; ++i)
  {
    const Stopwatch watch;
    frame();
    times.push_back(watch.Milliseconds());
  }
  std::sort(times.begin(), times.end());
  return times.empty() ? 0 : times[times.size() / 2];
}

void moveMillion(int frames)
{
  const GeneratedMesh mesh = sphere(1000, 1000, 1);
  const MeshView view = { mesh.positions, {}, {} };
  MovedVertices moved;
  const double time = medianOf(frames, [&] { moveVertices(Ripple(), view, {}, 0, moved); });
  std::cout << "vertices: " << time << " ms, " << view.vertexCount() << " vertices\n";
}
}

int main(int argc, char* argv[])
{
  const int frames = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 21;
  const std::string only = argc > 2 ? argv[2] : "";
  const Lambert lambert;
  const BuiltIn builtIn;
  const struct
  {
    const char* name;
    const SurfaceShader* shader;
  } all[] = { { "built-in", nullptr }, { "shader", &lambert }, { "call", &builtIn } };
  if (only == "vertices")
  {
    moveMillion(frames);
    return EXIT_SUCCESS;
  }

  SphereScene scene;
  scene.Draw(nullptr);
  const std::vector<Rgba8> expected = scene.Color;
  for (const auto& one : all)
  {
    if (!only.empty() && only != one.name)
    {
      continue;
    }
    const double time = medianOf(frames, [&] { scene.Draw(one.shader); });
    std::cout << one.name << ": " << time << " ms, " << scene.Pixels() << " pixels\n";
    if (std::memcmp(scene.Color.data(), expected.data(), expected.size() * sizeof(Rgba8)) != 0)
    {
      std::cerr << one.name << " draws another picture than the built-in model\n";
      return EXIT_FAILURE;
    }
  }
  if (only.empty())
  {
    moveMillion(frames);
  }
  return EXIT_SUCCESS;
}
