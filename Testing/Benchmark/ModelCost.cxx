// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What each model of light and texture costs: a sphere of 814 000 pixels in a frame of 1920 x 1080,
// one light. Frames of all models take turns, so that a machine that slows down does so for all.
// Usage: limn_model_cost [ROUNDS [MODEL]]
// Prints a table in Markdown: the median milliseconds of a frame, and how often Lambert's frame
// goes into it. With a MODEL's name draws that one alone; twice with different ROUNDS is what
// callgrind wants. Fails where the surface shaders' pictures are not the built-in model's.
#include "Stopwatch.h"

#include "Data/Generator/GeneratedMeshes.h"
#include "Data/Generator/GeneratedTextures.h"
#include "Rendering/Mesh/BuildClusters.h"
#include "Rendering/Mesh/FaceGeometry.h"
#include "Rendering/Mesh/MoveVertices.h"
#include "Rendering/Renderer.h"
#include "Rendering/SurfaceShader.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace limn;

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;

[[noreturn]] void fail(const std::string& message)
{
  std::cerr << "limn_model_cost: " << message << '\n';
  std::exit(EXIT_FAILURE);
}

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

/// What a model may change.
struct Look
{
  Instance Sphere;
  std::vector<Light> Lights;
  std::vector<TextureLayer> Layers;
  int Samples = 1;
};

class SphereScene
{
public:
  SphereScene()
  {
    const MeshView mesh = { this->Mesh.positions, {}, this->Triangles };
    if (!buildClusters(mesh, 0, this->Clusters).ok())
    {
      fail("no clusters");
    }
    this->Faces = faceGeometry(mesh, {}, this->Triangles.size());
    for (const Vec2f& uv : this->Mesh.texCoords)
    {
      this->Uv.push_back(uv * 3.0f);
    }
  }

  /// Lambert's.
  Look Plain() const
  {
    Look look;
    look.Lights.resize(1);
    look.Lights[0].kind = LightKind::kDirectional;
    look.Lights[0].direction = { -1, -1, -2 };
    look.Sphere.clusters = &this->Clusters;
    look.Sphere.mesh = { this->Mesh.positions, {}, this->Triangles };
    look.Sphere.attributes.vertexNormals = this->Mesh.normals;
    look.Sphere.attributes.uv = this->Uv;
    look.Sphere.attributes.facePoints = this->Faces.centroid;
    look.Sphere.attributes.faceNormals = this->Faces.normal;
    look.Sphere.style.reflection = Reflection::kLambert;
    look.Sphere.material.specular = 0.3f;
    look.Sphere.material.specularPower = 32;
    return look;
  }

  void Draw(const Look& look)
  {
    Instance sphere = look.Sphere;
    sphere.layers = look.Layers;
    Scene scene;
    scene.camera = { { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, -3 }, { 0, 0, 0, 1 } } },
      { { { 1.5, 0, 0, 0 }, { 0, 2.667, 0, 0 }, { 0, 0, -1.5, -2.5 }, { 0, 0, -1, 0 } } }, false };
    scene.lights = look.Lights;
    scene.instances = { &sphere, 1 };
    scene.samples = look.Samples;
    FrameView frame;
    frame.width = frame.rowStride = kWidth;
    frame.height = kHeight;
    frame.color = this->Color.data();
    frame.depth = this->Depth.data();
    frame.clear.extent = FrameClear::Extent::kAll;
    const Status status = render(scene, frame);
    if (!status.ok())
    {
      fail(status.message);
    }
  }

  std::vector<Rgba8> Color = std::vector<Rgba8>(kWidth * kHeight);

private:
  GeneratedMesh Mesh = globe(128, 64);
  std::vector<Triangle> Triangles = Mesh.triangles();
  ClusteredMesh Clusters;
  FaceGeometry Faces;
  std::vector<Vec2f> Uv;
  std::vector<float> Depth = std::vector<float>(kWidth * kHeight);
};

struct Model
{
  std::string Name;
  Look Of;
  std::vector<double> Milliseconds = {};
};

TextureImage imageOf(const GeneratedTexture& texture)
{
  TextureImage image;
  const Status status = image.build(texture.view(), MipChain::kFull);
  if (!status.ok())
  {
    fail(status.message);
  }
  return image;
}

/// What the models borrow.
struct Resources
{
  TextureImage Grid = imageOf(uvGrid()), Window = imageOf(leadedWindow());
  TextureImage Heights = imageOf(brickHeights()), Normals = imageOf(brickNormals());
  ProceduralTexture Procedural[3];
  Lambert ByHand;
  BuiltIn Calling;

  Resources()
  {
    const ProceduralKind kinds[] = { ProceduralKind::kChecker, ProceduralKind::kWood,
      ProceduralKind::kMarble };
    for (int i = 0; i < 3; ++i)
    {
      this->Procedural[i].kind = kinds[i];
      this->Procedural[i].scale = 5;
      this->Procedural[i].turbulence = i == 0 ? 0.0f : 0.5f;
    }
  }
};

class Models
{
public:
  Models(const SphereScene& scene, const Resources& resources) : Plain(scene.Plain())
  {
    this->AddReflections();
    this->AddLights();
    this->AddTextures(resources);
    this->Add("opacity 0.5", [](Look& look) { look.Sphere.material.opacity = 0.5f; });
    this->Add("opacity 0.5, 4 samples",
      [](Look& look)
      {
        look.Sphere.material.opacity = 0.5f;
        look.Samples = 4;
      });
    for (const int samples : { 4, 8, 16 })
    {
      this->Add(
        std::to_string(samples) + " samples", [samples](Look& look) { look.Samples = samples; });
    }
    this->Add(
      "shader by hand", [&](Look& look) { look.Sphere.style.surfaceShader = &resources.ByHand; });
    this->Add("shader that calls",
      [&](Look& look) { look.Sphere.style.surfaceShader = &resources.Calling; });
  }

  std::vector<Model> All;

private:
  void Add(const std::string& name, const std::function<void(Look&)>& change)
  {
    this->All.push_back({ name, this->Plain });
    change(this->All.back().Of);
  }

  void AddReflection(const std::string& name, Reflection reflection)
  {
    this->Add(name, [reflection](Look& look) { look.Sphere.style.reflection = reflection; });
  }

  void AddReflections()
  {
    this->AddReflection("Lambert", Reflection::kLambert);
    this->AddReflection("unlit", Reflection::kNone);
    this->AddReflection("as VTK", Reflection::kAsVtk);
    this->AddReflection("Blinn-Phong", Reflection::kBlinnPhong);
    this->Add("Blinn-Phong, power 17.5",
      [](Look& look)
      {
        look.Sphere.style.reflection = Reflection::kBlinnPhong;
        look.Sphere.material.specularPower = 17.5f;
      });
    this->AddReflection("Phong", Reflection::kPhong);
    this->AddReflection("irradiance", Reflection::kIrradiance);
    this->Add("Blinn-Phong, Fresnel",
      [](Look& look)
      {
        look.Sphere.style.reflection = Reflection::kBlinnPhong;
        look.Sphere.style.fresnel = true;
      });
    this->AddReflection("Oren-Nayar", Reflection::kOrenNayar);
    this->AddReflection("metallic-roughness", Reflection::kMetallicRoughness);
    this->Add("velvet", [](Look& look) { look.Sphere.material.rim = { 0.3f, 0.3f, 0.4f }; });
    this->Add("flat", [](Look& look) { look.Sphere.style.frequency = ShadingFrequency::kFlat; });
    this->Add(
      "Gouraud", [](Look& look) { look.Sphere.style.frequency = ShadingFrequency::kGouraud; });
    this->Add("Gooch", [](Look& look) { look.Sphere.style.tone = Tone::kGooch; });
    this->Add("outline", [](Look& look) { look.Sphere.style.outlineThreshold = 0.3f; });
  }

  void AddLights()
  {
    this->Add("headlight", [](Look& look) { look.Lights[0].kind = LightKind::kHeadlight; });
    this->Add("point light",
      [](Look& look)
      {
        look.Lights[0].kind = LightKind::kPoint;
        look.Lights[0].position = { 2, 2, 4 };
      });
    this->Add("soft spot",
      [](Look& look)
      {
        look.Lights[0].kind = LightKind::kSpot;
        look.Lights[0].position = { 2, 2, 4 };
        look.Lights[0].softDegrees = 10;
      });
    this->Add("sphere of 16 lights",
      [](Look& look)
      {
        look.Lights[0].kind = LightKind::kSphere;
        look.Lights[0].position = { 2, 2, 4 };
      });
    this->Add("rectangle of 16 lights",
      [](Look& look)
      {
        look.Lights[0].kind = LightKind::kRectangle;
        look.Lights[0].position = { 2, 2, 4 };
      });
  }

  void AddImage(const std::string& name, const TextureImage& image, TextureRole role,
    TextureFilter filter, int anisotropy = 1)
  {
    this->Add(name,
      [&](Look& look)
      {
        TextureLayer layer;
        layer.image = &image;
        layer.role = role;
        layer.sampler.filter = filter;
        layer.sampler.maxAnisotropy = anisotropy;
        look.Layers = { layer };
      });
  }

  void AddTextures(const Resources& of)
  {
    const TextureRole surface = TextureRole::kSurface;
    this->AddImage("texture, nearest", of.Grid, surface, TextureFilter::kNearest);
    this->AddImage("texture, bilinear", of.Grid, surface, TextureFilter::kBilinear);
    this->AddImage("texture, trilinear", of.Grid, surface, TextureFilter::kTrilinear);
    this->AddImage("texture, 16 probes", of.Grid, surface, TextureFilter::kTrilinear, 16);
    this->AddImage("bump map", of.Heights, TextureRole::kBump, TextureFilter::kBilinear);
    this->AddImage("normal map", of.Normals, TextureRole::kNormal, TextureFilter::kBilinear);
    this->AddImage("lightmap", of.Grid, TextureRole::kLight, TextureFilter::kBilinear);
    this->AddImage("texture with alpha", of.Window, surface, TextureFilter::kBilinear);
    this->All.back().Of.Sphere.style.readsAlpha = true;
    const char* const names[] = { "checker", "wood", "marble" };
    for (int i = 0; i < 3; ++i)
    {
      this->Add(names[i],
        [&](Look& look)
        {
          TextureLayer layer;
          layer.procedural = &of.Procedural[i];
          layer.role = TextureRole::kSurface;
          look.Layers = { layer };
        });
    }
  }

  Look Plain;
};

template <class Task>
double millisecondsOf(Task task)
{
  const Stopwatch watch;
  task();
  return watch.Milliseconds();
}

double medianOf(std::vector<double> times)
{
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void moveMillion(int rounds)
{
  const GeneratedMesh mesh = sphere(1000, 1000, 1);
  const MeshView view = { mesh.positions, {}, {} };
  MovedVertices moved;
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i)
  {
    times.push_back(millisecondsOf([&] { moveVertices(Ripple(), view, {}, 0, moved); }));
  }
  std::printf(
    "A vertex shader moves %zu vertices in %.1f ms.\n", view.vertexCount(), medianOf(times));
}

void expectSame(SphereScene& scene, const std::vector<Model>& models, const std::string& name,
  const std::string& other)
{
  const auto pictureOf = [&](const std::string& of)
  {
    const auto model =
      std::find_if(models.begin(), models.end(), [&](const Model& one) { return one.Name == of; });
    scene.Draw(model->Of);
    return scene.Color;
  };
  const std::vector<Rgba8> expected = pictureOf(name), actual = pictureOf(other);
  if (std::memcmp(actual.data(), expected.data(), expected.size() * sizeof(Rgba8)) != 0)
  {
    fail(other + " draws another picture than " + name);
  }
}
}

int main(int argc, char* argv[])
{
  const int rounds = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 21;
  const std::string only = argc > 2 ? argv[2] : "";
  SphereScene scene;
  const Resources resources;
  std::vector<Model> models = Models(scene, resources).All;
  if (only.empty())
  {
    expectSame(scene, models, "Lambert", "shader by hand");
    expectSame(scene, models, "Lambert", "shader that calls");
  }
  else
  {
    const auto others = std::remove_if(
      models.begin(), models.end(), [&](const Model& model) { return model.Name != only; });
    models.erase(others, models.end());
    if (models.empty())
    {
      fail("no model is called " + only);
    }
  }

  for (int round = 0; round < rounds; ++round)
  {
    for (Model& model : models)
    {
      model.Milliseconds.push_back(millisecondsOf([&] { scene.Draw(model.Of); }));
    }
  }
  std::printf("| model | ms | by Lambert |\n| --- | --- | --- |\n");
  for (const Model& model : models)
  {
    const double time = medianOf(model.Milliseconds);
    std::printf("| %s | %.1f | %.2f |\n", model.Name.c_str(), time,
      time / medianOf(models.front().Milliseconds));
  }
  if (only.empty())
  {
    moveMillion(rounds);
  }
  return EXIT_SUCCESS;
}
