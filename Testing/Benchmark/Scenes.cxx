// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include <vtkContourFilter.h>
#include <vtkImplicitFunction.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkSampleFunction.h>
#include <vtkSphereSource.h>
#include <vtkTexturedSphereSource.h>
#include <vtkTriangleFilter.h>

#include <cmath>

namespace
{
/// sin x cos y + sin y cos z + sin z cos x
class Gyroid : public vtkImplicitFunction
{
public:
  static Gyroid* New();
  vtkTypeMacro(Gyroid, vtkImplicitFunction);

  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override
  {
    return std::sin(x[0]) * std::cos(x[1]) + std::sin(x[1]) * std::cos(x[2]) +
           std::sin(x[2]) * std::cos(x[0]);
  }
  void EvaluateGradient(double x[3], double g[3]) override
  {
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      g[i] = std::cos(x[i]) * std::cos(x[j]) - std::sin(x[k]) * std::sin(x[i]);
    }
  }
};
vtkStandardNewMacro(Gyroid);

enum class Coordinates
{
  kNone,
  kTexture
};

vtkSmartPointer<vtkPolyData> MakeTorus(int side, Coordinates coordinates)
{
  vtkNew<vtkParametricTorus> torus;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(torus);
  source->SetUResolution(side);
  source->SetVResolution(side);
  source->SetScalarModeToNone();
  source->SetGenerateTextureCoordinates(coordinates == Coordinates::kTexture);
  source->Update();
  return source->GetOutput();
}

/// Two triangles for each of side x side squares, in the plane z = 0.
vtkSmartPointer<vtkPolyData> MakeSheet(int side)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(side, side);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeSphere(int around, int along)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(around);
  sphere->SetPhiResolution(along);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeTexturedSphere(int around, int along)
{
  vtkNew<vtkTexturedSphereSource> sphere;
  sphere->SetThetaResolution(around);
  sphere->SetPhiResolution(along);
  sphere->Update();
  return sphere->GetOutput();
}

/// Squares within squares, fine ones too: something for each level of a mip chain.
vtkSmartPointer<vtkImageData> MakePattern()
{
  constexpr int kSide = 1024;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(kSide, kSide, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < kSide; ++y)
  {
    for (int x = 0; x < kSide; ++x)
    {
      *texel++ = static_cast<unsigned char>((x ^ y) & 255);
      *texel++ = static_cast<unsigned char>((x / 4 ^ y / 4) & 255);
      *texel++ = static_cast<unsigned char>(255 - ((x / 2 + y / 2) & 127));
    }
  }
  return image;
}

/// Marching cubes of a gyroid in a cube of samples^3.
vtkSmartPointer<vtkPolyData> MakeGyroid(int samples)
{
  vtkNew<Gyroid> gyroid;
  vtkNew<vtkSampleFunction> sample;
  sample->SetImplicitFunction(gyroid);
  sample->SetModelBounds(-12, 12, -12, 12, -12, 12);
  sample->SetSampleDimensions(samples, samples, samples);
  sample->ComputeNormalsOff();
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(sample->GetOutputPort());
  contour->SetValue(0, 0);
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// Sheets behind each other that fill a 4K picture.
Scene Sheets(int layers)
{
  Scene scene;
  const vtkSmartPointer<vtkPolyData> sheet = MakeSheet(4);
  for (int i = 0; i < layers; ++i)
  {
    // The farthest first, as it hurts most.
    scene.Parts.push_back({ sheet, { 0, 0, 0.01 * i } });
  }
  scene.Width = 3840;
  scene.Height = 2160;
  scene.Elevation = 0;
  scene.Zoom = 3;
  return scene;
}

Scene Translucent(Scene scene)
{
  scene.Opacity = 0.4;
  return scene;
}

Scene Textured(Scene scene)
{
  scene.Texture = MakePattern();
  return scene;
}

Scene Illustrated(Scene scene)
{
  scene.Illustrated = true;
  return scene;
}

Scene Torus(int side, int samples, Coordinates coordinates)
{
  Scene scene;
  scene.Parts = { { MakeTorus(side, coordinates), { 0, 0, 0 } } };
  scene.Samples = samples;
  return scene;
}

Scene Filling(vtkSmartPointer<vtkPolyData> data, int width, int height)
{
  Scene scene;
  scene.Parts = { { data, { 0, 0, 0 } } };
  scene.Width = width;
  scene.Height = height;
  scene.Elevation = 0;
  scene.Zoom = 2.4;
  return scene;
}

}

Scene TorusScene(int side, int samples)
{
  return Torus(side, samples, Coordinates::kNone);
}

Scene SphereScene(int width, int height)
{
  return Filling(MakeSphere(200, 200), width, height);
}

Scene ActorsScene(int count)
{
  int side = 1;
  while (side * side * side < count)
  {
    ++side;
  }
  Scene scene;
  for (int i = 0; i < count; ++i)
  {
    scene.Parts.push_back({ MakeSphere(32, 17),
      { 1.2 * (i % side), 1.2 * (i / side % side), 1.2 * (i / side / side) } });
  }
  scene.Elevation = 20;
  return scene;
}

long long Scene::CountTriangles() const
{
  long long count = 0;
  for (const Part& part : this->Parts)
  {
    count += part.Data->GetNumberOfPolys();
  }
  return count;
}

const std::vector<SceneMaker>& SceneMakers()
{
  const auto named = [](const char* name, auto make)
  {
    return SceneMaker{ name, [name, make]
      {
        Scene scene = make();
        scene.Name = name;
        return scene;
      } };
  };
  static const std::vector<SceneMaker> makers = {
    named("torus 0.2M", [] { return TorusScene(316, 0); }),
    named("torus 2M", [] { return TorusScene(1000, 0); }),
    named("torus 18M", [] { return TorusScene(3000, 0); }),
    named("torus 50M", [] { return TorusScene(5000, 0); }),
    named("torus 2M, 4 samples", [] { return TorusScene(1000, 4); }),
    named("gyroid 3.5M", [] { return Filling(MakeGyroid(300), 1280, 720); }),
    named("1000 actors", [] { return ActorsScene(1000); }),
    named("sphere 1080p", [] { return SphereScene(1920, 1080); }),
    named("sphere 4K", [] { return SphereScene(3840, 2160); }),
    named("1 sheet 4K", [] { return Sheets(1); }),
    named("4 sheets 4K", [] { return Sheets(4); }),
    named("16 sheets 4K", [] { return Sheets(16); }),
    named("torus 0.2M, translucent", [] { return Translucent(TorusScene(316, 0)); }),
    named(
      "gyroid 3.5M, translucent", [] { return Translucent(Filling(MakeGyroid(300), 1280, 720)); }),
    named("4 sheets 4K, translucent", [] { return Translucent(Sheets(4)); }),
    named("torus 2M, textured", [] { return Textured(Torus(1000, 0, Coordinates::kTexture)); }),
    named("sphere 4K, textured",
      [] { return Textured(Filling(MakeTexturedSphere(200, 200), 3840, 2160)); }),
    named("torus 0.2M, all lines", [] { return Illustrated(TorusScene(316, 0)); }),
    named("torus 0.2M, all lines, 4 samples", [] { return Illustrated(TorusScene(316, 4)); }),
    named("torus 2M, all lines", [] { return Illustrated(TorusScene(1000, 0)); }),
  };
  return makers;
}
