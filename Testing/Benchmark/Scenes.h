// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scenes_h
#define Scenes_h

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

/// What is timed. Each scene is bound by one thing: triangles, pixels, actors or samples.
struct Part
{
  vtkSmartPointer<vtkPolyData> Data;
  std::array<double, 3> Position;
};

struct Scene
{
  std::string Name;
  std::vector<Part> Parts;
  int Width = 1280;
  int Height = 720;
  int Samples = 0; ///< as vtkRenderWindow::SetMultiSamples() takes them
  double Elevation = -50;
  double Zoom = 1;
  double Opacity = 1;                    ///< below 1 VTK peels depths, as exact as it can
  vtkSmartPointer<vtkImageData> Texture; ///< if any, put over all parts with mipmaps
  bool Illustrated = false;              ///< by Limn with a tone, an outline and lines of all kinds

  long long CountTriangles() const;
  bool IsTranslucent() const { return this->Opacity < 1; }
  /// Whether the limit's kernels draw it: they know no textures, translucent surfaces and lines.
  bool HasLimit() const { return !this->IsTranslucent() && !this->Texture && !this->Illustrated; }
};

struct SceneMaker
{
  std::string Name;
  std::function<Scene()> Make;
};

/// A torus of 2 side^2 triangles that just fits the picture.
Scene TorusScene(int side, int samples);
/// A sphere of 80 000 triangles that fills the picture.
Scene SphereScene(int width, int height);
/// Spheres of 960 triangles each in rows, layers and slices.
Scene ActorsScene(int count);

/// In the order of the table.
const std::vector<SceneMaker>& SceneMakers();

#endif
