// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorByArray.h"

#include "Colormap.h"
#include "ParseValue.h"
#include "UserError.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkPointData.h>

#include <algorithm>
#include <limits>

namespace limn::viewer
{
namespace
{

constexpr int kLength = -1; ///< of a vector, to vtkDataArray::GetFiniteRange

struct FoundArray
{
  vtkDataArray* array = nullptr;
  bool perPoint = true;
};

FoundArray findArray(vtkPolyData& surface, const std::string& name)
{
  if (vtkDataArray* const array = surface.GetPointData()->GetArray(name.c_str()))
  {
    return { array, true };
  }
  return { surface.GetCellData()->GetArray(name.c_str()), false };
}

std::vector<std::string> arrayNames(vtkPolyData& surface)
{
  std::vector<std::string> names;
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(surface.GetPointData()),
         static_cast<vtkFieldData*>(surface.GetCellData()) })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = arrays->GetArray(i);
      if (array && array->GetName())
      {
        names.emplace_back(array->GetName());
      }
    }
  }
  return names;
}

FoundArray requireArray(const Mesh& mesh, const std::string& name)
{
  const FoundArray found = findArray(*mesh.surface, name);
  if (!found.array)
  {
    const std::vector<std::string> names = arrayNames(*mesh.surface);
    throw UserError("--coloring-array=" + name + ": " + mesh.file + " has no such array; " +
                    (names.empty() ? "it has none" : "it has: " + joinWords(names)));
  }
  return found;
}

bool isScalar(vtkDataArray& array)
{
  return array.GetNumberOfComponents() == 1;
}

std::array<double, 2> rangeOver(const std::vector<Mesh>& meshes, const std::string& name)
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> range = { kInfinity, -kInfinity };
  for (const Mesh& mesh : meshes)
  {
    vtkDataArray& array = *requireArray(mesh, name).array;
    double own[2];
    array.GetFiniteRange(own, isScalar(array) ? 0 : kLength);
    range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
  }
  if (range[0] > range[1])
  {
    throw UserError("--coloring-array=" + name + " has no finite value");
  }
  return range;
}

void colorByArray(const ColoringSettings& coloring, const std::vector<Mesh>& meshes,
  const Mesh& mesh, vtkMapper& mapper)
{
  const FoundArray found = requireArray(mesh, coloring.array);
  const auto range = coloring.range ? *coloring.range : rangeOver(meshes, coloring.array);
  const auto table = makeColormap(coloring.colormap.value_or(kDefaultColormap), range);
  if (!isScalar(*found.array))
  {
    table->SetVectorModeToMagnitude();
  }
  mapper.SetLookupTable(table);
  mapper.UseLookupTableScalarRangeOn();
  // Bytes would else be taken for colours.
  mapper.SetColorModeToMapScalars();
  if (found.perPoint)
  {
    mapper.SetScalarModeToUsePointFieldData();
  }
  else
  {
    mapper.SetScalarModeToUseCellFieldData();
  }
  mapper.SelectColorArray(coloring.array.c_str());
  mapper.ScalarVisibilityOn();
}

bool hasOwnColors(vtkPolyData& surface)
{
  vtkDataArray* const perPoint = surface.GetPointData()->GetScalars();
  // The mapper looks at cells only where points have no scalars at all.
  return perPoint ? areColors(perPoint) : areColors(surface.GetCellData()->GetScalars());
}

} // namespace

bool areColors(vtkDataArray* scalars)
{
  return scalars && scalars->GetDataType() == VTK_UNSIGNED_CHAR &&
         scalars->GetNumberOfComponents() >= 3;
}

void chooseColors(const SceneSettings& settings, const std::vector<Mesh>& meshes, const Mesh& mesh,
  vtkMapper& mapper)
{
  if (!settings.coloring.array.empty())
  {
    colorByArray(settings.coloring, meshes, mesh, mapper);
    return;
  }
  const bool isColorNamed = settings.material.color || settings.material.diffuse;
  mapper.SetScalarVisibility(!isColorNamed && hasOwnColors(*mesh.surface));
}

} // namespace limn::viewer
