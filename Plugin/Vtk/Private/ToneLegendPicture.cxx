// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ToneLegendPicture.h"

#include "EngineState.h"
#include "StyleFromProperty.h"

#include "Rendering/Mesh/BuildClusters.h"
#include "Rendering/Renderer.h"

#include "vtkLimnProperty.h"

#include "vtkNew.h"

#include <cmath>

namespace limn::bridge
{
namespace
{

/// A square of one pixel for each entry of the legend, with its colour and its normal.
struct SquareSheet
{
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> cells;
  std::vector<Rgba8> colors;
  std::vector<Vec3f> normals;
  std::vector<std::uint32_t> packedNormals; ///< by corner
  std::vector<Vec3d> places;
  ClusteredMesh clusters;

  MeshView view() const { return { positions, {}, triangles }; }
};

Vec3f normalOfRow(int row, int rows)
{
  const double cosine = (2.0 * row + 1) / rows - 1;
  return vec3Cast<float>(Vec3d{ std::sqrt(1 - cosine * cosine), 0, cosine });
}

void addSquare(SquareSheet& sheet, std::uint32_t column, std::uint32_t row)
{
  const auto first = static_cast<std::uint32_t>(sheet.positions.size());
  const auto cell = static_cast<std::uint32_t>(sheet.normals.size());
  const auto x = static_cast<float>(column);
  const auto y = static_cast<float>(row);
  for (const Vec3f corner :
    { Vec3f{ x, y, 0 }, Vec3f{ x + 1, y, 0 }, Vec3f{ x + 1, y + 1, 0 }, Vec3f{ x, y + 1, 0 } })
  {
    sheet.positions.push_back(corner);
  }
  sheet.triangles.push_back({ { first, first + 1, first + 2 } });
  sheet.triangles.push_back({ { first, first + 2, first + 3 } });
  sheet.cells.insert(sheet.cells.end(), { cell, cell });
}

SquareSheet makeSheet(const ToneLegendRequest& request)
{
  SquareSheet sheet;
  for (int row = 0; row < request.rows; ++row)
  {
    for (std::size_t column = 0; column < request.colors.size(); ++column)
    {
      addSquare(sheet, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
      sheet.colors.push_back(request.colors[column]);
      const Vec3f normal = normalOfRow(row, request.rows);
      sheet.normals.push_back(normal);
      sheet.packedNormals.insert(
        sheet.packedNormals.end(), 4, packedNormal(vec3Cast<double>(normal)));
    }
  }
  sheet.places.resize(sheet.normals.size());
  return sheet;
}

/// Without what a legend cannot show: it is looked at head-on and has no other side.
void setLook(const ToneLegendRequest& request, Instance& instance)
{
  vtkNew<vtkLimnProperty> look;
  look->DeepCopy(request.property);
  look->SetShadingFrequencyToFlat();
  look->SetOutlineToNone();
  look->SetSurfaceShader(nullptr);
  look->SetSpecular(0);
  look->SetOpacity(1);
  instance.material = materialOf(look);
  instance.style = styleOf(look, SurfaceMesh());
  instance.style.legendSafeRange = static_cast<float>(request.legendSafeRange);
  instance.style.toneLight = ToneLight::kFirst;
  instance.style.toneHighlight = ToneHighlight::kNone;
  instance.style.hatching.place = HatchPlace::kModel;
  instance.style.exaggeration.base = 1;
}

} // namespace

Status drawToneLegend(const ToneLegendRequest& request, std::vector<Rgba8>& pixels)
{
  const auto columns = static_cast<int>(request.colors.size());
  SquareSheet sheet = makeSheet(request);
  if (Status status = buildClusters(sheet.view(), 0, sheet.clusters); !status.ok())
  {
    return status;
  }
  Instance instance;
  instance.clusters = &sheet.clusters;
  instance.mesh = sheet.view();
  setLook(request, instance);
  instance.attributes.cellColors = sheet.colors;
  instance.attributes.cells = sheet.cells;
  instance.attributes.cellCount = sheet.normals.size();
  instance.attributes.facePoints = sheet.places;
  instance.attributes.faceNormals = sheet.normals;
  instance.attributes.smoothNormals = sheet.packedNormals;
  instance.attributes.smoothLevels = 1;

  const Light headlight;
  Scene scene;
  scene.camera = { Mat4d::identity(),
    { { { 2.0 / columns, 0, 0, -1 }, { 0, 2.0 / request.rows, 0, -1 }, { 0, 0, -1, 0 },
      { 0, 0, 0, 1 } } },
    true };
  scene.lights = { &headlight, 1 };
  scene.instances = { &instance, 1 };

  const std::size_t count = sheet.normals.size();
  pixels.assign(count, Rgba8{ 0, 0, 0, 0 });
  std::vector<float> depth(count, 1.0f);
  FrameView frame;
  frame.width = columns;
  frame.height = request.rows;
  frame.rowStride = columns;
  frame.color = pixels.data();
  frame.depth = depth.data();
  return render(scene, frame, EngineState::instance().options);
}

} // namespace limn::bridge
