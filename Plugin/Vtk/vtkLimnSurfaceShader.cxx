// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnSurfaceShader.h"

#include "Private/SurfaceShaderInternals.h"

#include <algorithm>
#include <type_traits>

namespace
{
using Fragments = vtkLimnSurfaceShader::Fragments;
using Vectors = vtkLimnSurfaceShader::Vectors;

static_assert(vtkLimnSurfaceShader::Capacity == limn::FragmentVectors::kCapacity,
  "what users declare holds what the renderer gives");
static_assert(
  std::is_same<int, std::int32_t>::value && std::is_same<unsigned, std::uint32_t>::value,
  "pixels and cells are handed over as they are");

Vectors toVtk(const limn::FragmentVectorsView& v)
{
  return { v.x, v.y, v.z };
}

limn::FragmentVectorsView fromVtk(const Vectors& v)
{
  return { v.X, v.Y, v.Z };
}

Fragments toVtk(const limn::SurfaceFragments& f)
{
  return { f.count, toVtk(f.position), toVtk(f.modelPosition), toVtk(f.normal), toVtk(f.ambient),
    toVtk(f.diffuse), toVtk(f.specular), f.u, f.v, f.pixelX, f.pixelY, f.cell };
}

limn::SurfaceFragments fromVtk(const Fragments& f)
{
  return { f.Count, fromVtk(f.Position), fromVtk(f.ModelPosition), fromVtk(f.Normal),
    fromVtk(f.Ambient), fromVtk(f.Diffuse), fromVtk(f.Specular), f.U, f.V, f.PixelX, f.PixelY,
    f.Cell };
}

void copy(limn::Vec3f from, float to[3])
{
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

void copy(const limn::FragmentVectors& from, int count, float* const to[3])
{
  std::copy_n(from.x, count, to[0]);
  std::copy_n(from.y, count, to[1]);
  std::copy_n(from.z, count, to[2]);
}

class LightingOfScene final : public vtkLimnSurfaceShader::Lighting
{
public:
  explicit LightingOfScene(const limn::SurfaceLighting& lighting) : lighting_(lighting) {}

  void Light(const Fragments& fragments, float* const color[3]) const override
  {
    limn::FragmentVectors colors;
    lighting_.light(fromVtk(fragments), colors);
    copy(colors, fragments.Count, color);
  }
  int GetNumberOfLights() const override { return static_cast<int>(lighting_.lights.size()); }
  void GetLightColor(int light, float color[3]) const override
  {
    copy(lighting_.lights[light].color, color);
  }
  void Arrive(
    int light, const Fragments& fragments, float* const toward[3], float* fall) const override
  {
    limn::FragmentVectors towards;
    lighting_.arrive(light, fromVtk(fragments), towards, fall);
    copy(towards, fragments.Count, toward);
  }
  void GetAmbientLight(float color[3]) const override { copy(lighting_.scene.ambientLight, color); }
  void GetModelToWorld(double matrix[16]) const override
  {
    std::copy_n(&lighting_.instance.modelToWorld.m[0][0], 16, matrix);
  }
  void GetWorldToView(double matrix[16]) const override
  {
    std::copy_n(&lighting_.scene.camera.worldToView.m[0][0], 16, matrix);
  }
  bool GetParallelProjection() const override { return lighting_.scene.camera.parallel; }

private:
  const limn::SurfaceLighting& lighting_;
};
}

//------------------------------------------------------------------------------
vtkLimnSurfaceShader::Lighting::~Lighting() = default;

//------------------------------------------------------------------------------
vtkLimnSurfaceShader::vtkLimnSurfaceShader() : Internals(new vtkInternals(this)) {}

//------------------------------------------------------------------------------
vtkLimnSurfaceShader::~vtkLimnSurfaceShader() = default;

//------------------------------------------------------------------------------
void vtkLimnSurfaceShader::vtkInternals::shade(const limn::SurfaceFragments& fragments,
  const limn::SurfaceLighting& lighting, limn::FragmentVectors& colors) const
{
  float* const color[3] = { colors.x, colors.y, colors.z };
  this->Self->Shade(toVtk(fragments), LightingOfScene(lighting), color);
}

//------------------------------------------------------------------------------
void vtkLimnSurfaceShader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
