// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RenderCommand.h"

#include "ApplyEffects.h"
#include "BuildScene.h"
#include "Colormap.h"
#include "LoadMesh.h"
#include "MapPictures.h"
#include "Messages.h"
#include "OpenWindow.h"
#include "Picture.h"

#include "vtkLimnEngine.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnToneLegend.h"

#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <thread>

namespace limn::viewer
{
namespace
{

/// Wall-clock milliseconds since it was made.
class Stopwatch
{
public:
  double milliseconds() const
  {
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - this->start_;
    return elapsed.count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

struct Times
{
  double read = 0, render = 0, write = 0;
};

struct DrawnPicture
{
  std::string file;
  vtkSmartPointer<vtkImageData> picture;
};

std::vector<DrawnPicture> drawMaps(const MapSettings& maps, vtkLimnRenderWindow& window)
{
  std::vector<DrawnPicture> drawn;
  if (!maps.normals.empty())
  {
    drawn.push_back({ maps.normals, pictureOfNormals(window) });
  }
  if (!maps.depth.empty())
  {
    drawn.push_back({ maps.depth, pictureOfDepth(window) });
  }
  if (!maps.ids.empty())
  {
    drawn.push_back({ maps.ids, pictureOfIds(window) });
  }
  return drawn;
}

/// What the window shows.
vtkSmartPointer<vtkImageData> pictureOf(vtkRenderWindow& window, bool hasAlpha)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(&window);
  grabber->ShouldRerenderOff();
  grabber->ReadFrontBufferOff();
  if (hasAlpha)
  {
    grabber->SetInputBufferTypeToRGBA();
  }
  grabber->Update();
  throwCollectedErrors();
  return grabber->GetOutput();
}

/// All that is to be written, but for the legend.
std::vector<DrawnPicture> drawPictures(
  const RenderSettings& settings, const std::vector<Mesh>& meshes)
{
  const OpenedWindow opened = openWindow(settings.window, settings.scene);
  opened.window->OffScreenRenderingOn();
  if (settings.transparentBackground)
  {
    opened.window->AlphaBitPlanesOn();
    opened.renderer->SetBackground(0, 0, 0);
    opened.renderer->SetBackgroundAlpha(0);
  }
  auto* const limnWindow = vtkLimnRenderWindow::SafeDownCast(opened.window);
  if (settings.maps.any())
  {
    limnWindow->MapsOn();
  }
  buildScene(settings.scene, meshes, *opened.renderer);
  applyEffects(settings.effects, *opened.renderer);
  opened.window->Render();
  throwCollectedErrors();

  std::vector<DrawnPicture> drawn;
  if (!settings.output.empty())
  {
    drawn.push_back({ settings.output, pictureOf(*opened.window, settings.transparentBackground) });
  }
  if (settings.maps.any())
  {
    for (DrawnPicture& map : drawMaps(settings.maps, *limnWindow))
    {
      drawn.push_back(std::move(map));
    }
  }
  return drawn;
}

/// Of colours by an array.
void writeToneLegend(const SceneSettings& scene, const Mesh& mesh, const std::string& file)
{
  const std::string colormap = scene.coloring.colormap.value_or(kDefaultColormap);
  vtkNew<vtkLimnProperty> property;
  applyLook(scene, mesh, {}, *property);
  vtkNew<vtkLimnToneLegend> legend;
  legend->SetLookupTable(makeColormap(colormap, { 0, 1 }));
  legend->SetSurfaceProperty(property);
  vtkImageData* const picture = legend->GetImage();
  throwCollectedErrors();
  writePicture(*picture, file);
}

int threadsInUse()
{
  const int threads = vtkLimnEngine::GetNumberOfThreads();
  return threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
}

void printStats(const Times& times)
{
  const nlohmann::ordered_json stats = {
    { "triangles", vtkLimnEngine::GetTriangles() },
    { "vertices", vtkLimnEngine::GetVertices() },
    { "clusters", vtkLimnEngine::GetClusters() },
    { "ms", { { "read", times.read }, { "prepare", vtkLimnEngine::GetPrepareMilliseconds() },
              { "bin", vtkLimnEngine::GetBinMilliseconds() },
              { "tiles", vtkLimnEngine::GetTileMilliseconds() }, { "render", times.render },
              { "write", times.write } } },
    { "bytes", vtkLimnEngine::GetBytes() },
    { "threads", threadsInUse() },
    { "target", vtkLimnEngine::GetInstructionSet() },
  };
  std::cout << stats.dump() << std::endl;
}

} // namespace

ExitStatus render(const RenderSettings& settings)
{
  preferWindow(settings.window);
  for (const std::string& file : { settings.output, settings.maps.normals, settings.maps.depth,
         settings.maps.ids, settings.toneLegend })
  {
    if (!file.empty())
    {
      checkWritable(file);
    }
  }

  Times times;
  const Stopwatch reading;
  const std::vector<Mesh> meshes = loadMeshes(settings.scene.meshes);
  times.read = reading.milliseconds();

  const Stopwatch rendering;
  const std::vector<DrawnPicture> pictures = drawPictures(settings, meshes);
  times.render = rendering.milliseconds();

  const Stopwatch writing;
  for (const DrawnPicture& drawn : pictures)
  {
    writePicture(*drawn.picture, drawn.file);
  }
  if (!settings.toneLegend.empty())
  {
    writeToneLegend(settings.scene, meshes[0], settings.toneLegend);
  }
  times.write = writing.milliseconds();
  if (settings.stats)
  {
    printStats(times);
  }
  return ExitSuccess;
}

} // namespace limn::viewer
